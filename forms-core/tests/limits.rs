//! Extremely large exponents still give an answer: a verdict if one monomial is enough, `unknown`
//! if the terms would not fit.

use forms_core::decide::{Verdict, decide};
use forms_core::normal::{Obstacle, SizeLimit, Tower, Trigonometry};
use forms_core::polynomial::Polynomial;
use forms_core::resolve::resolve;
use forms_core::syntax::read;

/// Returns the message of the only error of a text.
fn error(text: &str) -> String {
    let (file, errors) = read(text);
    assert!(errors.is_empty(), "{errors:?}");
    let (_, errors) = resolve(&file);
    assert_eq!(errors.len(), 1, "{errors:?}");
    errors[0].message.clone()
}

/// Returns the verdict on one statement about x, y, z, u and v.
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
    let power = vec!["x**1000000"; 30].join(" * ");
    let parts = ["x", "y", "z", "u", "v", "x*y", "x*z", "x*u", "x*v", "y*z", "y*u"];
    let backwards: Vec<&str> = parts.iter().rev().copied().collect();
    let factors = ["x", "y", "z", "u", "v", "(x + 1)", "(y + 1)", "(z + 1)", "(u + 1)"];
    let squares: Vec<String> = factors.iter().map(|factor| format!("{factor}**2")).collect();
    let roots: Vec<String> = squares.iter().map(|square| format!("sqrt({square})")).collect();
    let shifted =
        |shifts: std::ops::RangeInclusive<u32>| shifts.map(|i| format!("(x + {i})")).collect::<Vec<_>>();
    let roots_of_each: Vec<String> = shifted(1..=66).iter().map(|factor| format!("sqrt({factor})")).collect();
    let splits = format!("sqrt({})*({})", shifted(1..=66).join("*"), roots_of_each.join(" + "));
    let within: Vec<String> = ["x", "y", "z", "u", "v"].map(|name| format!("abs(abs({name}) - 1)")).to_vec();
    let outside: Vec<String> = within.iter().map(|part| format!("sqrt({part}**2)")).collect();
    for (statement, limit) in [
        (
            "exp(1/(x**2 + y*z + u + v + 1)**6)**2 == exp(2/(x**2 + y*z + u + v + 1)**6)".into(),
            "a denominator of exponents has more than 64 terms",
        ),
        ("sin(49*x)**2 == 1 - cos(49*x)**2".into(), "an angle or exponent with the coefficient 49"),
        ("exp(4097*x)*exp(y) == exp(4097*x + y)".into(), "an exponent with the coefficient 4097"),
        ("sin(17*atan(x))**2 == 1 - cos(17*atan(x))**2".into(), "17 times `atan`"),
        ("sin(atan(x)/32)**2 == 1 - cos(atan(x)/32)**2".into(), "1/32 times `atan`"),
        (
            "2**(1/97) + 3**(1/89) + 5**(1/83) == 5**(1/83) + 3**(1/89) + 2**(1/97)".into(),
            "a root of order 97",
        ),
        ("x*sin(pi/37)**2 == x - x*cos(pi/37)**2".into(), "an angle of 1/37 times pi"),
        ("x*sin(pi/128)**2 == x - x*cos(pi/128)**2".into(), "an angle of 1/128 times pi"),
        (
            format!("{splits} == {splits}*x/x where x > 0"),
            "its radicands and angles need more than 64 refinements",
        ),
        (
            format!("{} == {}", within.join(" + "), outside.join(" + ")),
            "too many factors of radicands have an open sign",
        ),
        ("x**(1/65) * x**(1/65) == x**(2/65) where x > 0".into(), "a root of order 65"),
        (
            format!("sin({})**2 == 1 - cos({})**2", parts.join(" + "), backwards.join(" + ")),
            "an angle of more than 10 parts",
        ),
        (
            format!("sqrt({}) == {}", squares.join(" * "), roots.join(" * ")),
            "too many factors of radicands have an open sign",
        ),
        (format!("{power} * (x + 1) == {power} * x + {power}"), "an exponent is beyond"),
        (
            format!("(y + 1) / ({power}) == y / ({power}) + 1 / ({power}) where x > 0"),
            "an exponent is beyond",
        ),
    ] {
        let shown: String = statement.chars().take(60).collect();
        match verdict(&statement) {
            Verdict::Unknown { reason } => assert!(reason.to_string().contains(limit), "{shown}: {reason}"),
            other => panic!("{shown}: {}", other.name()),
        }
    }
}

#[test]
fn a_power_of_more_terms_than_the_work_allows_is_refused_beforehand() {
    let sum = (0..5).fold(Polynomial::one(), |sum, index| sum.add(&Polynomial::variable(index)));
    let power = Tower::new(Trigonometry::Circle).integer_power(&sum.into(), 600);
    assert_eq!(power, Err(Obstacle::TooLarge(SizeLimit::Products(100_000_000))));
}

#[test]
fn a_power_of_a_sum_has_a_limit_of_its_own() {
    let sum = Polynomial::variable(0).add(&Polynomial::one());
    let power = Tower::new(Trigonometry::Circle).integer_power(&sum.into(), 16_385);
    assert_eq!(power, Err(Obstacle::TooLarge(SizeLimit::PowerOfSum(16384))));
}

#[test]
fn a_file_beyond_a_limit_is_told_which() {
    let coordinates = |count: usize| (0..count).map(|i| format!("x{i}")).collect::<Vec<_>>();
    let chart = |count: usize| format!("chart C({});", coordinates(count).join(", "));
    assert_eq!(error(&chart(129)), "a file can declare at most 128 coordinates");
    let differentials: Vec<String> = coordinates(9).iter().map(|name| format!("d{name}")).collect();
    let squares: Vec<String> = differentials.iter().map(|dx| format!("{dx}**2")).collect();
    let metric = format!("metric g on C = ({})**2 + {};", differentials.join(" + "), squares.join(" + "));
    let expected = "the metric couples more than 8 coordinates with each other";
    assert_eq!(error(&format!("{}{metric}", chart(9))), expected);
    let beyond = "chart R(x); prove s: x**1000001 == 0;";
    assert_eq!(error(beyond), "the exponent is beyond the limit of 1000000");
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

/// Returns the wedge product of (Σ x₀ᵏ dx₀ + … ) for k = 0, 1, ….
fn wedge_of_sums(coordinates: usize, factors: u32) -> String {
    let names: Vec<String> = (0..coordinates).map(|i| format!("x{i}")).collect();
    let sum = |k| names.iter().map(|x| format!("{x}**{k}*d{x}")).collect::<Vec<_>>().join(" + ");
    let sums: Vec<String> = (0..factors).map(sum).collect();
    format!("chart R({}); let w = (({}));", names.join(", "), sums.join(")^("))
}

#[test]
fn the_parts_of_the_expressions_of_a_file_are_counted() {
    let expected = "the expressions of this file have more than 1000000 distinct subexpressions";
    assert_eq!(error(&wedge_of_sums(30, 5)), expected);
}

#[test]
fn the_products_of_a_wedge_are_counted_beforehand() {
    let text = wedge_of_sums(48, 2).replace("));", ")); let square = w^w;");
    assert_eq!(error(&text), "the wedge product takes more than 1000000 products of terms");
}

#[test]
fn derivatives_of_unknown_functions_in_an_integrand_are_limited() {
    let text = |count: u32| {
        let functions: String = (0..count).map(|i| format!("fn f{i}(x);")).collect();
        let sum: Vec<String> = (0..count).map(|i| format!("diff(f{i}, x)")).collect();
        format!("chart R(x); {functions} let it = integral({}, x = 0..1);", sum.join(" + "))
    };
    let (file, _) = read(&text(63));
    assert_eq!(resolve(&file).1, []);
    let expected =
        "cannot integrate over `x`: the integrand has more than 64 derivatives of unknown functions";
    assert_eq!(error(&text(65)), expected);
}

/// Returns definitions f0, f1, … of which each calls the one before it by `call`.
fn tower(levels: usize, call: &str) -> String {
    let level = |n: usize| format!("let f{}(t) = {};\n", n + 1, call.replace("f", &format!("f{n}")));
    "let f0(t) = t + 1;\n".to_owned() + &(0..levels).map(level).collect::<String>()
}

#[test]
fn definitions_that_call_each_other_are_limited() {
    let of = |levels: usize, call: &str| format!("{}kernel k(x) = f{levels}(x);", tower(levels, call));
    assert_eq!(resolve(&read(&of(10, "f(t) + f(2*t)")).0).1, []);
    assert_eq!(
        error(&of(30, "f(t) + f(2*t)")),
        "this item has more than 10000 calls of definitions and terms of sums"
    );
    assert!(
        error(&of(100, "f(t)"))
            .ends_with("nested more than 64 levels deep, with the definitions that it calls")
    );
}

#[test]
fn sums_are_limited() {
    assert_eq!(
        error("kernel k(x) = sum(x, j = 1..1001);"),
        "`sum` has 1001 terms, more than the limit of 1000"
    );
    assert_eq!(
        error("kernel k(x) = sum(sum(x, j = 1..1000), j = 1..1000);"),
        "this item has more than 10000 calls of definitions and terms of sums"
    );
    assert_eq!(
        error("kernel k(x) = sum(x, j = 0..10**30);"),
        "`sum` has 1000000000000000000000000000001 terms, more than the limit of 1000"
    );
}
