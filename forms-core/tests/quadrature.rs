//! Integrals that are computed numerically: the decisions about them, and their values.

use forms_core::accuracy::{Format, Rounded, Truth, Value};
use forms_core::check::{decide_all, read_theory};
use forms_core::compile::compile_kernel;
use forms_core::expression::{Rational, Symbol};
use forms_core::kernel::{Instruction, evaluate_f64};
use forms_core::theory::Theory;

fn theory(text: &str) -> Theory {
    let (theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{errors:?}");
    theory
}

/// Computes the last kernel of a source at these arguments.
fn values(text: &str, arguments: &[f64]) -> Vec<f64> {
    let mut theory = theory(text);
    let kernel = theory.kernels.last().cloned().expect("a kernel");
    let generated = compile_kernel(&mut theory.pool, &kernel).expect("a kernel");
    assert!(generated.translation.is_proved(), "{text}: {}", generated.translation);
    let point: Vec<_> = kernel.arguments.iter().copied().zip(arguments.iter().copied()).collect();
    let values = generated.optimised.interpret(arguments);
    let plain = evaluate_f64(&theory.pool, &kernel.outputs, &point).expect("values");
    for (value, plain) in values.iter().zip(plain) {
        assert!((value - plain).abs() <= 1e-14 * plain.abs().max(1.0), "{text}: {value} {plain}");
    }
    values
}

fn is_near(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-14 * expected.abs().max(1.0), "{found} {expected}");
    }
}

#[test]
fn what_a_quadrature_is_a_function_of_decides_statements() {
    let mut theory = theory(
        "chart T(t, x);
         prove end: diff(quadrature(exp(-x*t**2), t = 0..x), x)
            == exp(-x**3) - quadrature(t**2*exp(-x*t**2), t = 0..x);
         prove name: quadrature(exp(-x*t**2), t = 0..1) == quadrature(exp(-x*s**2), s = 0..1);
         prove empty: quadrature(sin(t**3), t = x..x) == 0;
         refute value: quadrature(exp(-t**2), t = 0..1) == 3/4;
         refute function: quadrature(exp(-x*t**2), t = 0..1) == exp(-x/3);",
    );
    for (verdict, statement) in decide_all(&mut theory).iter().zip(&theory.statements) {
        assert!(verdict.bears_out(statement.claim), "{}: {verdict:?}", statement.name);
    }
}

#[test]
fn kernels_compute_quadratures_and_integrals_without_a_closed_form() {
    is_near(&values("kernel k(x) = quadrature(cos(t**2), t = 0..x);", &[0.7]), &[0.683_378_790_502_197]);
    is_near(
        &values("chart Line(s); kernel k(x) = integral(exp(-s**4), s = 0..x);", &[0.7]),
        &[0.668_509_137_694_402_6],
    );
    is_near(
        &values("kernel k(x) = quadrature(quadrature(sin(s*t), t = 0..s), s = 0..x);", &[0.7]),
        &[0.029_713_846_808_293_84],
    );
    is_near(
        &values("kernel f(x) = quadrature(exp(-t**2), t = 0..x); kernel g = grad(f; x);", &[0.7]),
        &[(-0.49_f64).exp()],
    );
}

/// Returns the operations of the integrand in the last kernel of a source, after optimisation.
fn operations_of_the_integrand(text: &str) -> String {
    let mut theory = theory(text);
    let kernel = theory.kernels.last().cloned().expect("a kernel");
    let generated = compile_kernel(&mut theory.pool, &kernel).expect("a kernel");
    assert!(generated.translation.is_proved(), "{text}: {}", generated.translation);
    let integrand = generated.optimised.instructions().iter().find_map(|instruction| match instruction {
        Instruction::Quadrature { integrand, .. } => Some(integrand.operations().to_string()),
        _ => None,
    });
    integrand.expect("a quadrature")
}

#[test]
fn what_a_quadrature_integrates_is_optimised_like_a_kernel() {
    let cases = [
        ("t**2", "1 multiplication"),
        ("t**3 + 2*t**2 + x*t", "2 additions, 2 multiplications"),
        ("t**2*exp(-x*t**2)", "3 multiplications, 1 negation, 1 function call"),
        ("(x + t)**(3/2)", "1 addition, 1 multiplication, 1 square root"),
    ];
    for (integrand, expected) in cases {
        let text = format!("kernel k(x) = quadrature({integrand}, t = 0..1);");
        assert_eq!(operations_of_the_integrand(&text), expected, "{integrand}");
    }
}

#[test]
fn a_quadrature_is_refused_where_it_means_nothing() {
    for (text, message) in [
        ("chart X(x); prove s: quadrature(1/t, t = -1..1) == 0;", "it is not known that `t != 0` holds"),
        ("kernel k(x) = quadrature(x);", "`quadrature` takes an integrand and one range"),
        ("kernel k(x) = quadrature(t*y, t = 0..x);", "`y` is not declared"),
    ] {
        let found: String = read_theory(text).1.into_iter().map(|error| error.message + "\n").collect();
        assert!(found.contains(message), "{text}\n{found}");
    }
}

/// Computes the last kernel of a source at exact arguments, to fifty digits.
fn digits(text: &str, arguments: &[&str]) -> String {
    let theory = theory(text);
    let kernel = theory.kernels.last().expect("a kernel");
    let numbers = arguments.iter().map(|text| text.parse::<Rational>().expect("a fraction"));
    let point: Vec<(Symbol, Rational)> = kernel.arguments.iter().copied().zip(numbers).collect();
    let truth = Truth::new(&theory.pool, &kernel.outputs, &kernel.domain);
    match truth.at(&point, Format::Digits(50)).remove(0) {
        Value::Known(Rounded::Digits(digits)) => digits,
        other => format!("{other:?}"),
    }
}

#[test]
fn integrals_of_every_size_have_fifty_certain_digits() {
    // erf(1) √π/2, and the same value scaled
    let digits_of_erf = "7.4682413281242702539946743613185300535449968681261";
    assert_eq!(
        digits("kernel k(x) = quadrature(exp(-t**2), t = 0..x);", &["1"]),
        format!("{digits_of_erf}e-1")
    );
    assert_eq!(
        digits("kernel k(x, s) = quadrature(s*exp(-t**2), t = 0..x);", &["1", "1/100000000000000000000"]),
        format!("{digits_of_erf}e-21")
    );
}

#[test]
fn a_view_factor_without_a_closed_form_has_fifty_certain_digits() {
    // two unit spheres at distance 3, with the formula of `view_factor_spheres`
    let source = "kernel k(r, R, D) = 64*R**2/(pi*D)*quadrature(u**2*(1 - u**2)**2/((1 + u**2)**4*(D*(1 + u**2)
        + sqrt((D - r - R)*(D + r + R)*(1 + u**2)**2 + 16*r*R*u**2))), u = 0..1) where r > 0, R >= 0, D >= r + R;";
    assert_eq!(digits(source, &["1", "1", "3"]), "2.9590312250550431403804540422850051399434907326547e-2");
}
