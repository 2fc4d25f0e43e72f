//! Notation: simplified values as text and as LaTeX.

use forms_core::notation::{latex, simplify, text};
use forms_core::resolve::resolve;
use forms_core::syntax::read;
use forms_core::theory::{Named, Theory, Value};

const DECLARATIONS: &str = "
    chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
    chart UV(u, v);
    chart Angles(theta, phi);
    param sigma_a where sigma_a > 0;
    fn f(x, y);
    form solid_angle: 2 on R3 = (x*dy^dz + y*dz^dx + z*dx^dy)/sqrt(x**2 + y**2 + z**2)**3;
    let q = u**2 + v**2 + 1;
    map inverse_stereographic: UV -> R3 = (2*v/q, 2*u/q, (u**2 + v**2 - 1)/q);
";

/// Returns the value of an expression of the language, with its theory.
fn value(expression: &str) -> (Theory, Value) {
    let (file, errors) = read(&format!("{DECLARATIONS} let value = {expression};"));
    assert!(errors.is_empty(), "{errors:?}");
    let (theory, errors) = resolve(&file);
    assert!(errors.is_empty(), "{errors:?}");
    let Some(Named::Object(number)) = theory.named("value") else { panic!("`value` is declared") };
    let value = theory.objects[*number].value.clone();
    (theory, value)
}

#[test]
fn values_are_simplified_and_written_in_the_language() {
    let cases = [
        ("pullback(inverse_stereographic, solid_angle)", "4/(u**2 + v**2 + 1)**2*du^dv"),
        ("(x**2 - y**2)/(x - y)", "x + y"),
        ("cos(x)**2 + sin(x)**2", "1"),
        ("d(x*y)", "y*dx + x*dy"),
        ("(x + y)*dx - dy", "(x + y)*dx - dy"),
        ("x*dx - x*dx", "0"),
        ("-2*dx - x*dy", "-2*dx - x*dy"),
        ("x*@y - @x", "-@x + x*@y"),
        ("diff(f, x)*dx^dy", "diff(f, x)*dx^dy"),
        ("abs(x)", "abs(x)"),
        ("asin(x) - asin(x)", "0"),
    ];
    for (expression, expected) in cases {
        let (mut theory, value) = value(expression);
        let simplified = simplify(&mut theory, &[], &value);
        assert_eq!(text(&theory, &simplified), expected, "{expression}");
    }
}

#[test]
fn values_are_typeset() {
    let cases = [
        ("theta/2", r"\frac{\theta}{2}"),
        ("sigma_a*x", r"\sigma_{a}\,x"),
        ("2*3**(1/2)*x", r"2\,\sqrt{3}\,x"),
        ("(x + y)**2*z", r"\left(x + y\right)^{2}\,z"),
        ("min(x, y + 1) - max(0, z)", r"\min\left(x, y + 1\right) - \max\left(0, z\right)"),
        ("hypot(x, y)*cbrt(z)", r"\operatorname{hypot}\left(x, y\right)\,\operatorname{cbrt}\left(z\right)"),
        ("x**(1/3) + x**(3/2)", r"\sqrt[3]{x} + x^{3/2}"),
        ("x*(-y)", r"-x\,y"),
        ("x - (y + z)", r"x - \left(y + z\right)"),
        ("x/(1/2 + y)", r"\frac{x}{\frac{1}{2} + y}"),
        ("(x/y)**2", r"\left(\frac{x}{y}\right)^{2}"),
        ("sin(theta)**2", r"\sin^{2}\left(\theta\right)"),
        ("exp(-x)**2", r"\left(e^{-x}\right)^{2}"),
        ("abs(x)", r"\left|x\right|"),
        ("diff(f, x, x, y)", r"\frac{\partial^{3} f}{\partial x^{2}\,\partial y}"),
        ("f(y, 2)", r"f\left(y, 2\right)"),
        ("pi*dx^dy", r"\pi\,\mathrm{d}x\wedge \mathrm{d}y"),
        ("@theta - 2*@phi", r"\partial_{\theta} - 2\,\partial_{\phi}"),
    ];
    for (expression, expected) in cases {
        let (theory, value) = value(expression);
        assert_eq!(latex(&theory, &value), expected, "{expression}");
    }
}

#[test]
fn what_is_too_long_to_read_is_told_by_its_size() {
    let doubled: String = (1..40).map(|i| format!("let a{i} = a{}*a{} + {i};", i - 1, i - 1)).collect();
    let (file, _) = read(&format!("chart L(x); let a0 = sin(x); {doubled}"));
    let (theory, errors) = resolve(&file);
    assert!(errors.is_empty());
    let last = &theory.objects.last().expect("forty of them").value;
    assert!(text(&theory, last).contains("terms and operators"));
    assert!(latex(&theory, last).len() < 400_000);
}
