//! Rules by which exponentials, logarithms, powers, radicals and absolute values are compared, each
//! with a wrong variant. Every instance of a rule is proved, and every instance of a wrong variant
//! is refuted unless both sides agree at every point tried.

use forms_core::decide::{Verdict, decide};
use forms_core::kernel::evaluate_f64;
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use forms_core::theory::Value;

const PREAMBLE: &str = "chart Plane(x, y); chart Quadrant(s, t) where s > 0, t > 0; param q, n;";

/// Expressions substituted for A and B, which are real, and for P and R, which are positive.
const REAL: &[&str] = &["x", "(x + y)", "(x*y)", "(x**2/3)", "(y/(1 + x**2))", "sqrt(1 + x**2)"];
const POSITIVE: &[&str] = &["s", "(s*t)", "(1 + x**2)", "exp(x)", "sqrt(t)", "(s/(s + t))", "(s + sqrt(t))"];

/// Left side, right side, and the right side of the wrong variant.
const RULES: &[(&str, [&str; 3])] = &[
    ("a sum of exponents is a product", ["exp(A + B)", "exp(A)*exp(B)", "exp(A) + exp(B)"]),
    (
        "exponents over one denominator",
        ["exp(A/P)*exp(B/R)", "exp((A*R + B*P)/(P*R))", "exp((A + B)/(P + R))"],
    ),
    ("parts of an exponent", ["exp(A/2)**2", "exp(A)", "exp(A/4)"]),
    ("the logarithm of a product", ["log(P*R)", "log(P) + log(R)", "log(P)*log(R)"]),
    ("the logarithm of a power", ["log(P**3/R)", "3*log(P) - log(R)", "log(P)**3 - log(R)"]),
    ("the logarithm of a square", ["log(A**2)/2", "log(abs(A))", "log(1 + abs(A))"]),
    ("the exponential of a logarithm", ["exp(log(P)/2 + A)", "sqrt(P)*exp(A)", "P*exp(A)/2"]),
    ("the magnitude in a logarithm", ["exp(log(A**2)/2)", "abs(A)", "A + 1"]),
    ("the logarithm of an exponential", ["log(P*exp(A))", "A + log(P)", "A*log(P)"]),
    ("symbolic exponents add", ["P**q*P**n", "P**(q + n)", "P**(q*n)"]),
    ("a symbolic power of a product", ["(P*R)**q", "P**q*R**q", "P**q + R**q"]),
    ("a power of a power", ["(P**q)**n", "P**(q*n)", "P**(q + n)"]),
    ("the derivative of a logarithm", ["diff(log(P), x)", "diff(P, x)/P", "diff(P, x)/P + 1/P"]),
    ("a nested square", ["sqrt(P + R + 2*sqrt(P*R))", "sqrt(P) + sqrt(R)", "sqrt(P + R) + 1"]),
    (
        "a nested square with its sign",
        ["sqrt(P + R - 2*sqrt(P*R))", "abs(sqrt(P) - sqrt(R))", "1 + sqrt(P) - sqrt(R)"],
    ),
    (
        "a product of conjugates",
        ["sqrt(sqrt(A**2 + P) + A)*sqrt(sqrt(A**2 + P) - A)", "sqrt(P)", "sqrt(A**2 + P) + 1"],
    ),
    (
        "the logarithm of conjugates",
        ["log(sqrt(A**2 + 1) + A)", "-log(sqrt(A**2 + 1) - A)", "log(sqrt(A**2 + 1) + 1)"],
    ),
    ("the magnitude of a product", ["abs(A*B)", "abs(A)*abs(B)", "abs(A) + abs(B) + 1"]),
    (
        "the sign of a root less its square's part",
        ["abs(sqrt(A**2 + P) - A)", "sqrt(A**2 + P) - A", "sqrt(A**2 + P) + P"],
    ),
    ("the sign of a monotone difference", ["abs(exp(A**2) - 1)", "exp(A**2) - 1", "exp(A**2) + 1"]),
];

fn instance(template: &str, number: usize) -> String {
    let of = |list: &[&str], place: usize| list[place % list.len()].to_string();
    template
        .replace('A', &of(REAL, number))
        .replace('B', &of(REAL, 2 * number + 1))
        .replace('P', &of(POSITIVE, number))
        .replace('R', &of(POSITIVE, 3 * number + 1))
}

/// Returns the verdict, and whether the sides agree in plain arithmetic at some points where both
/// have a value.
fn decided(left: &str, right: &str) -> (Verdict, bool) {
    let text = format!("{PREAMBLE} prove it: {left} == {right};");
    let (mut theory, errors) = resolve(&read(&text).0);
    assert_eq!(errors, [], "{text}");
    let statement = theory.statements[0].clone();
    let verdict = decide(&mut theory, &statement);
    let sides: Vec<_> = [&statement.left, &statement.right]
        .into_iter()
        .map(|side| match side {
            Value::Scalar(scalar) => *scalar,
            _ => theory.pool.integer(0),
        })
        .collect();
    let symbols = theory.pool.symbols_in(&sides);
    let agree = [[0.7, 1.3, 0.4, 2.2], [1.9, 0.6, 1.1, 0.3], [0.2, 2.7, 3.1, 1.4]].iter().all(|values| {
        let point: Vec<_> = symbols.iter().copied().zip(values.iter().copied().cycle()).collect();
        match evaluate_f64(&theory.pool, &sides, &point).as_deref() {
            Some([l, r]) if l.is_finite() && r.is_finite() => (l - r).abs() <= 1e-9 * (1.0 + l.abs()),
            _ => true,
        }
    });
    (verdict, agree)
}

#[test]
fn every_instance_of_a_rule_is_proved() {
    let mut open = Vec::new();
    for (name, [left, right, _]) in RULES {
        for number in 0..7 {
            let (left, right) = (instance(left, number), instance(right, number));
            let (verdict, agree) = decided(&left, &right);
            assert!(agree, "{name}: {left} == {right} fails in plain arithmetic");
            if !matches!(verdict, Verdict::Proved(_)) {
                open.push(format!("{name}: {left} == {right}: {verdict:?}"));
            }
        }
    }
    assert!(open.is_empty(), "{}", open.join("\n"));
}

#[test]
fn every_slip_of_a_rule_is_refuted() {
    for (name, [left, _, slip]) in RULES {
        for number in 0..7 {
            let (left, slip) = (instance(left, number), instance(slip, number));
            let (verdict, agree) = decided(&left, &slip);
            assert!(!agree, "{name}: the slip {left} == {slip} is none");
            assert!(matches!(verdict, Verdict::Refuted(_)), "{name}: {left} == {slip}: {verdict:?}");
        }
    }
}
