//! Absurd exponents end in an answer: a verdict where one monomial does, `unknown` where terms would not fit.

use forms_core::decide::{Verdict, decide};
use forms_core::resolve::resolve;
use forms_core::syntax::read;

/// The verdict on one statement about x, y, z, u and v.
fn verdict(statement: &str) -> Verdict {
    let text = format!("chart R5(x, y, z, u, v); prove s: {statement};");
    let (file, errors) = read(&text);
    assert!(errors.is_empty(), "{errors:?}");
    let (mut theory, errors) = resolve(&file);
    assert!(errors.is_empty(), "{errors:?}");
    let statement = theory.statements[0].clone();
    decide(&mut theory, &statement)
}

#[test]
fn large_powers_of_a_variable_are_monomials() {
    for statement in [
        "x**999999 * x == x**1000000",
        "(1 + x**1000000) * (1 - x**3) == 1 + x**1000000 - x**3 - x**1000000 * x**3",
        "d(x**1000000) == 1000000 * x**999999 * d(x)",
        "x**1000000 / x**999999 == x where x > 0",
        "(x + y + z + u + v + 1)**1024 == (x + y + z + u + v + 1)**1023 * (x + y + z + u + v + 1)",
        "1 / x**1000000 - y == (1 - x**1000000 * y) / x**1000000 where x > 0",
    ] {
        assert_eq!(verdict(statement).name(), "proved", "{statement}");
    }
}

#[test]
fn what_would_not_fit_is_unknown() {
    let sum = "(x + y + z + u + v + 1)";
    let power = vec!["x**1000000"; 30].join(" * ");
    for (statement, limit) in [
        (format!("({sum}**600 + 1) * ({sum}**600 - 1) == {sum}**1200 - 1"), "products of terms"),
        (format!("{power} * (x + 1) == {power} * x + {power}"), "an exponent is beyond"),
        (
            format!("(y + 1) / ({power}) == y / ({power}) + 1 / ({power}) where x > 0"),
            "an exponent is beyond",
        ),
    ] {
        let shown: String = statement.chars().take(60).collect();
        match verdict(&statement) {
            Verdict::Unknown { reason } => assert!(reason.contains(limit), "{shown}: {reason}"),
            other => panic!("{shown}: {}", other.name()),
        }
    }
}

#[test]
fn a_false_power_beyond_every_limit_is_refuted_where_its_base_is_small() {
    for statement in ["(x + 1)**1000000 == 0", "x**1000000 == 0", "(x*y + z)**999999 == 7"] {
        assert_eq!(verdict(statement).name(), "refuted", "{statement}");
    }
}

#[test]
fn a_power_too_large_at_every_point_is_unknown() {
    assert_eq!(verdict("(x**2 + 3)**1000000 == 0").name(), "unknown");
}
