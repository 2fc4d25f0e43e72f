//! Derivations: the statements in their steps are themselves true, and a simple factor between
//! unequal sides is found.

use forms_core::check::{decide_all, read_theory};
use forms_core::decide::{Verdict, decide};
use forms_core::derivation::{Derivation, Line, derive};
use forms_core::syntax::Source;

const SPACE: &str = "chart R3(x, y, z) where x**2 + y**2 + z**2 > 0;
    chart Angles(theta, phi) where 0 < theta < pi;
    chart UV(u, v);
    param a, h where a > 0, h > 0;
    fn S1(u, v); fn S2(u, v); fn S3(u, v);
    let r = sqrt(x**2 + y**2 + z**2);
    form beta = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3;
    map sphere: Angles -> R3 = (a*sin(theta)*cos(phi), a*sin(theta)*sin(phi), a*cos(theta));
    map surface: UV -> R3 = (S1, S2, S3);
    map plane: UV -> R3 = (u, v, h);";

fn derivation(statement: &str) -> Derivation {
    let source = Source::new("test", format!("{SPACE} {statement};"));
    derive(&source, "s").unwrap_or_else(|| panic!("{statement}"))
}

/// Returns the formulas of a derivation that are equations of the language.
fn equations(derivation: &Derivation) -> Vec<String> {
    let told = ["Results of the exterior calculus", "Left minus right"];
    let steps = derivation.steps.iter().filter(|step| told.iter().any(|title| step.title.starts_with(title)));
    let formulas = steps.flat_map(|step| &step.lines).filter_map(|line| match line {
        Line::Formula(formula) => Some(formula.text.clone()),
        Line::Words(_) => None,
    });
    formulas.filter(|text| text.matches(" = ").count() == 1 && !text.contains("characters)")).collect()
}

const DERIVED: &[&str] = &[
    "prove s: d(beta) == 0",
    "prove s: d(d(x*y**2*dz + r*dx)) == 0",
    "prove s: pullback(sphere, beta) == sin(theta)*dtheta^dphi",
    "prove s: d(pullback(surface, x*dy)) == pullback(surface, d(x*dy))",
    "prove s: lie(x*@y, x*dy^dz) == x**2*dy^dz + 0*dx^dy where x > 0",
    "prove s: interior(x*@x + y*@y + z*@z, beta) == 0",
    "prove s: integral(pullback(sphere, beta), theta = 0..pi, phi = 0..2*pi) == 4*pi",
    "prove s: sqrt(x**2*y) == abs(x)*sqrt(y)",
    "prove s: sqrt((1 - cos(theta))/2) == sin(theta/2)",
    "prove s: cos(3*u + v) == (4*cos(u)**3 - 3*cos(u))*cos(v) - (3*sin(u) - 4*sin(u)**3)*sin(v)",
    "prove s: cosh(u)**2 - sinh(u)**2 == 1",
    "prove s: bracket(x*@y, y*@x) == x*@x - y*@y",
];

#[test]
fn every_equation_of_a_derivation_is_a_theorem() {
    let mut checked = 0;
    for statement in DERIVED {
        let derivation = derivation(statement);
        let place = statement.split_once(" where ").map_or(String::new(), |(_, c)| format!(", {c}"));
        for (number, equation) in equations(&derivation).iter().enumerate() {
            let claim =
                format!("prove line{number}: {} where a > 0{place};", equation.replace(" = ", " == "));
            let (mut theory, errors) = read_theory(&format!("{SPACE} {claim}"));
            assert!(errors.is_empty(), "{claim}: {errors:?}");
            let verdicts = decide_all(&mut theory);
            assert!(matches!(verdicts.as_slice(), [Verdict::Proved(_)]), "{claim}: {verdicts:?}");
            checked += 1;
        }
    }
    assert!(checked > 2 * DERIVED.len(), "{checked} equations");
}

#[test]
fn the_solid_angle_form_is_closed_term_by_term() {
    let expected = "\
s

1. Claimed to hold
      d(beta) = 0

2. Definitions
      r = sqrt(x**2 + y**2 + z**2)
      beta = (x*dy^dz + y*dz^dx + z*dx^dy)/r**3

3. Results of the exterior calculus
      diff(z/(x**2 + y**2 + z**2)**(3/2), z)*dz^dx^dy = (x**2 + y**2 - 2*z**2)/(x**2 + y**2 + z**2)**(5/2)*dx^dy^dz
      diff(-y/(x**2 + y**2 + z**2)**(3/2), y)*dy^dx^dz = (x**2 + z**2 - 2*y**2)/(x**2 + y**2 + z**2)**(5/2)*dx^dy^dz
      diff(x/(x**2 + y**2 + z**2)**(3/2), x)*dx^dy^dz = -(2*x**2 - y**2 - z**2)/(x**2 + y**2 + z**2)**(5/2)*dx^dy^dz
      d(beta) = 0

4. Left minus right
   The computation uses polynomials in the variables and these generators:
      (sqrt(x**2 + y**2 + z**2))**2 = x**2 + y**2 + z**2
   The coefficient of dx^dy^dz:
      ((x**2 + y**2 - 2*z**2) + (x**2 + z**2 - 2*y**2) + (-(2*x**2 - y**2 - z**2)))/((x**2 + y**2 + z**2)**(5/2)) = 0

5. Proved
   The two sides are equal at every point that meets
      x**2 + y**2 + z**2 > 0
";
    assert_eq!(derivation("prove s: d(beta) == 0").text(), expected);
}

#[test]
fn a_refutation_shows_the_point_and_both_values() {
    let text = derivation("refute s: pullback(plane, beta) == h*du^dv/(u**2 + v**2 + h**2)").text();
    for part in
        ["At the point", "the coefficients of du^dv are", "left = ", "right = ", "left/right = 1/sqrt("]
    {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn the_latex_of_a_derivation_is_a_document_of_balanced_groups() {
    for statement in DERIVED {
        let latex = derivation(statement).latex();
        assert!(latex.starts_with("\\documentclass") && latex.ends_with("\\end{document}\n"), "{statement}");
        let count = |c: char| latex.matches(c).count() - latex.matches(&format!("\\{c}")).count();
        assert_eq!(count('{'), count('}'), "{statement}: {latex}");
        assert_eq!(latex.matches("\\left").count(), latex.matches("\\right").count(), "{statement}: {latex}");
        assert_eq!(latex.matches("\\[").count(), latex.matches("\\]").count(), "{statement}");
    }
}

/// Returns the reported quotient of the sides.
fn ratio(equation: &str) -> Option<String> {
    let (mut theory, errors) = read_theory(&format!("{SPACE} refute s: {equation};"));
    assert!(errors.is_empty(), "{equation}: {errors:?}");
    let statement = theory.statements[0].clone();
    match decide(&mut theory, &statement) {
        Verdict::Refuted(witness) => witness.ratio.map(|ratio| match ratio.jacobian_of {
            Some(map) => format!("{} of {map}", ratio.factor),
            None => ratio.factor,
        }),
        other => panic!("{equation}: {other:?}"),
    }
}

#[test]
fn a_simple_factor_between_the_sides_is_named() {
    let cases = [
        ("dx^dy == dy^dx", "-1"),
        ("d(x**2) == x*dx", "2"),
        ("integral(sin(theta), theta = 0..pi, phi = 0..2*pi) == 4", "pi"),
        ("pullback(sphere, beta) == dtheta^dphi", "sin(theta)"),
        ("pullback(sphere, z*dx^dy) == a**3*cos(theta)**2*dtheta^dphi", "sin(theta)"),
        ("pullback(plane, beta) == h/(u**2 + v**2 + h**2)*du^dv", "1/sqrt(h**2 + u**2 + v**2)"),
        ("pullback(sphere, a**2*beta) == dtheta^dphi", "a**2*sin(theta) of sphere"),
        ("cos(theta)*sin(theta)/r**2 == sin(theta)", "cos(theta)/(x**2 + y**2 + z**2)"),
    ];
    for (equation, factor) in cases {
        assert_eq!(ratio(equation).as_deref(), Some(factor), "{equation}");
    }
}

#[test]
fn sides_that_differ_otherwise_have_no_factor() {
    for equation in [
        "d(beta) == dx^dy^dz",
        "x*dy + y*dx == x*dy + 2*y*dx",
        "x**2 + y == x + y**2",
        "S1 == S2",
        "x + 1 == x",
        "abs(x)*asin(sin(u)) == x*u",
    ] {
        assert_eq!(ratio(equation), None, "{equation}");
    }
}
