//! Integrals of absolute values and of symbolic powers against quadrature, and refutations of wrong
//! values.

use super::quadrature::{quadrature, scalar, theory_of};
use forms_core::decide::decide;
use forms_core::expression::Symbol;
use forms_core::kernel::evaluate_f64;
use forms_core::theory::Theory;

const DECLARATIONS: &str = "chart Plane(x, y); param n, a, b where n > 1, 0 < a < 1, b > 1;";

/// Values of n, a and b for the comparison.
const PARAMETERS: [(&str, f64); 3] = [("n", 2.5), ("a", 0.375), ("b", 1.75)];

fn with_values(theory: &Theory, x: Option<f64>, symbols: &[Symbol]) -> Vec<(Symbol, f64)> {
    let value = |name: &str| PARAMETERS.iter().find(|entry| entry.0 == name).map(|entry| entry.1);
    symbols
        .iter()
        .map(|&symbol| {
            (symbol, value(theory.pool.symbol_name(symbol)).or(x).expect("only x is integrated over"))
        })
        .collect()
}

/// Asserts that the exact integral of f(x) between numbers agrees with quadrature between
/// consecutive places.
fn assert_close(integrand: &str, (from, to): (&str, &str), places: &[f64]) {
    let text = format!("{DECLARATIONS} let f = {integrand}; let it = integral(f, x = {from}..{to});");
    let (theory, errors) = theory_of(&text);
    assert!(errors.is_empty(), "{integrand}: {errors:?}");
    let (written, exact) = (scalar(&theory, "f"), scalar(&theory, "it"));
    let parameters = theory.pool.symbols_in(&[exact]);
    let found = evaluate_f64(&theory.pool, &[exact], &with_values(&theory, None, &parameters)).unwrap()[0];
    let symbols = theory.pool.symbols_in(&[written]);
    let value =
        |x: f64| evaluate_f64(&theory.pool, &[written], &with_values(&theory, Some(x), &symbols)).unwrap()[0];
    let expected: f64 = places.windows(2).map(|ends| quadrature(value, ends[0], ends[1])).sum();
    let close = (found - expected).abs() <= 1e-5 * (1.0 + expected.abs());
    assert!(close, "{integrand} from {from} to {to}: {found} and {expected}");
}

#[test]
fn integrals_of_absolute_values_agree_with_quadrature() {
    use std::f64::consts::PI;
    let (root, golden) = (2f64.sqrt(), (1.0 + 5f64.sqrt()) / 2.0);
    assert_close("abs(x)", ("-1", "1"), &[-1.0, 0.0, 1.0]);
    assert_close("abs(x)", ("1", "-2"), &[1.0, 0.0, -2.0]);
    assert_close("abs(x - a)*x", ("0", "1"), &[0.0, 0.375, 1.0]);
    assert_close("abs(x - a)*abs(x - b)", ("0", "b + 1"), &[0.0, 0.375, 1.75, 2.75]);
    assert_close("abs(x**2 - 2)", ("-3", "2"), &[-3.0, -root, root, 2.0]);
    assert_close("abs(x**2 - x - 1)*x", ("0", "2"), &[0.0, golden, 2.0]);
    assert_close("abs(x**2 + x + 1)", ("-2", "2"), &[-2.0, 2.0]);
    assert_close("abs(x**3 - x**2)", ("-1", "2"), &[-1.0, 0.0, 1.0, 2.0]);
    assert_close("abs(cos(x))*sin(x)", ("0", "pi"), &[0.0, PI / 2.0, PI]);
    assert_close("abs(sin(2*x))", ("0", "2*pi"), &[0.0, PI / 2.0, PI, 1.5 * PI, 2.0 * PI]);
    assert_close("abs(cos(x) - 1/2)", ("0", "2*pi"), &[0.0, PI / 3.0, 5.0 * PI / 3.0, 2.0 * PI]);
    assert_close("abs(1 + 2*sin(x))", ("0", "2*pi"), &[0.0, 7.0 * PI / 6.0, 11.0 * PI / 6.0, 2.0 * PI]);
    assert_close("abs(sin(x)*cos(x))", ("-1", "1"), &[-1.0, 0.0, 1.0]);
    assert_close("abs(cos(x + pi/3))", ("0", "3"), &[0.0, PI / 6.0, 7.0 * PI / 6.0, 3.0]);
    assert_close("abs(abs(x) - 1)", ("-2", "2"), &[-2.0, -1.0, 0.0, 1.0, 2.0]);
    assert_close("sqrt((x - 1)**2)*exp(x)", ("0", "2"), &[0.0, 1.0, 2.0]);
    assert_close("abs(a - b)*x", ("0", "1"), &[0.0, 1.0]);
}

#[test]
fn integrals_of_symbolic_powers_agree_with_quadrature() {
    use std::f64::consts::PI;
    let half = PI / 2.0;
    assert_close("x**n", ("0", "1"), &[0.0, 1e-6, 1e-3, 1.0]);
    assert_close("x**(-a)", ("1", "b"), &[1.0, 1.75]);
    assert_close("x**2*(1 - x)**n", ("0", "1"), &[0.0, 0.9, 0.999, 1.0]);
    assert_close("x*(1 - x**2)**n", ("0", "1"), &[0.0, 0.9, 0.999, 1.0]);
    assert_close("(3*x + 2)**a*x", ("0", "1"), &[0.0, 1.0]);
    assert_close("(2 - x)**(n + a)", ("0", "1"), &[0.0, 1.0]);
    assert_close("cos(x)**(n + 1)*sin(x)", ("0", "pi/2"), &[0.0, 1.5, half]);
    assert_close("sin(x)**n*cos(x)", ("0", "pi/2"), &[0.0, 0.1, half]);
    assert_close("cos(x)**n*sin(x)", ("0", "a"), &[0.0, 0.375]);
}

#[test]
fn absolute_values_whose_changes_of_sign_are_not_known_are_left_undecided() {
    for integral in ["abs(x - y), x = 0..1", "abs(x**5 + x - 1), x = 0..1", "abs(exp(x) - 2), x = 0..1"] {
        let text = format!("{DECLARATIONS} let it = integral({integral});");
        assert_eq!(theory_of(&text).1.len(), 1, "{integral}");
    }
}

#[test]
fn symbolic_powers_that_may_not_converge_are_refused() {
    for integral in ["x**(-n), x = 0..1", "x**(a - b), x = 0..1", "cos(x)**(-n)*sin(x), x = 0..pi/2"] {
        let text = format!("{DECLARATIONS} let it = integral({integral});");
        assert_eq!(theory_of(&text).1.len(), 1, "{integral}");
    }
}

#[test]
fn mistaken_integrals_are_refuted() {
    let table = [
        "integral(abs(cos(x))*sin(x), x = 0..pi) == 0",
        "integral(abs(x - a), x = 0..1) == 1/2 - a",
        "integral(cos(x)**(n + 1)*sin(x), x = 0..pi/2) == 1/(n + 1)",
        "integral(x**n, x = 0..1) == 1/n",
        "integral(abs(x - y), x = 0..1, y = 0..1) == 0",
    ];
    for statement in table {
        let (mut theory, errors) = theory_of(&format!("{DECLARATIONS} prove it: {statement};"));
        assert!(errors.is_empty(), "{statement}: {errors:?}");
        let claim = theory.statements[0].clone();
        assert_eq!(decide(&mut theory, &claim).name(), "refuted", "{statement}");
    }
}
