//! The order of the tactics: each statement is proved by one of them, after all others before it
//! gave up.

use forms_core::check::read_theory;
use forms_core::decide::{Attempt, UnknownReason, attempts};

fn tried(statement: &str) -> Vec<Attempt> {
    let (mut theory, errors) = read_theory(&format!("chart R2(x, y); prove it: {statement};"));
    assert_eq!(errors, [], "{statement}");
    let statement = theory.statements[0].clone();
    attempts(&mut theory, &statement)
}

#[test]
fn each_tactic_proves_what_the_tactics_before_it_do_not() {
    let order = [
        ("normal form", "(x + y)**2 == x**2 + 2*x*y + y**2"),
        ("trigonometric signs", "abs(sin(x) - cos(x)) == cos(x) - sin(x) where 0 < x < pi/4"),
        ("angles", "atan(x) + atan(1/x) == pi/2 where x > 0"),
        ("principal branches", "4*cos(acos(x)/3)**3 - 3*cos(acos(x)/3) == x"),
        ("numbers", "sqrt(28**(1/3) - 3) == (98**(1/3) - 28**(1/3) - 1)/3"),
        ("equations", "x*y == 0 where x**2 <= 0"),
    ];
    for (place, (tactic, statement)) in order.into_iter().enumerate() {
        let tried = tried(statement);
        let last = tried.last().expect("an attempt");
        assert_eq!((last.tactic, &last.gives_up), (tactic, &None), "{statement}: {tried:?}");
        let names: Vec<&str> = tried.iter().map(|attempt| attempt.tactic).collect();
        assert_eq!(names, order.map(|row| row.0)[..=place], "{statement}");
    }
}

#[test]
fn a_tactic_that_gives_up_says_why() {
    let reasons: Vec<_> = tried("x == y").into_iter().map(|attempt| attempt.gives_up).collect();
    let expected = [
        UnknownReason::DifferentNormalForms,
        UnknownReason::NoTrigonometricSigns,
        UnknownReason::NoAngles,
        UnknownReason::NoPrincipalBranches,
        UnknownReason::NoNumbers,
        UnknownReason::NoEquations,
    ];
    assert_eq!(reasons, expected.map(Some));
}
