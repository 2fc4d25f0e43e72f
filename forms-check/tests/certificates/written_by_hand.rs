//! Certificates as a dishonest prover could write them.

use crate::support::checked;
use forms_check::Outcome;
use forms_core::certificate::{HEADER, file_lines};

/// Returns the outcome of one entry about a source.
fn outcome(source: &str, entry: &str) -> Outcome {
    let lines = HEADER.to_string() + &file_lines("it.forms", source) + entry;
    let mut all = checked(&lines, source).expect("a certificate that can be read");
    all.remove(0).outcome
}

fn is_rejected(source: &str, entry: &str) -> bool {
    matches!(outcome(source, entry), Outcome::Rejected(_))
}

const SQUARE: &str = "chart L(x); prove s: sqrt(x**2) == x;";

#[test]
fn a_sign_needs_a_reason_that_shows_it() {
    for reason in ["x", "abs(x)", "x**2", "x*1", "-(-x)", "x**3/x**2", "x + 0*x"] {
        assert!(is_rejected(SQUARE, &format!("proved s\nbase x\npositive {reason}\nzero\n")), "{reason}");
    }
    assert!(is_rejected(SQUARE, "proved s\nbase x\nzero\n"));
    assert!(is_rejected(SQUARE, "proved s\nzero\n"));
    let positive = "chart L(x); prove s: sqrt(x**2) == x where x > 0;";
    assert_eq!(outcome(positive, "proved s\nbase x\npositive x\nzero\n"), Outcome::Accepted);
}

#[test]
fn no_case_may_be_left_out() {
    assert!(is_rejected(SQUARE, "proved s\nbase x\nsplit 1\ncase +\nbase x\npositive x\nzero\nend\n"));
    assert!(is_rejected(SQUARE, "proved s\nbase x\nsplit 1\nend\n"));
    let both = "proved s\nbase x\nsplit 1\ncase +\nbase x\npositive x\nzero\ncase -\nbase x\nnegative -x\nzero\nend\n";
    assert!(is_rejected(SQUARE, both));
    assert_eq!(outcome("chart L(x); prove s: sqrt(x**2) == abs(x);", both), Outcome::Accepted);
}

#[test]
fn what_divides_by_zero_proves_nothing() {
    assert!(is_rejected(SQUARE, "proved s\nbase x\nundefined\n"));
    assert!(is_rejected(SQUARE, "proved s\nbase 1/(x - x)\nzero\n"));
}

#[test]
fn a_point_has_to_meet_every_condition_and_both_sides_have_to_be_defined_there() {
    let source = "chart L(x) where x > 0; refute s: sqrt(x**2) == -x;";
    assert_eq!(outcome(source, "refuted s\nat x = 1\ncomponent\nleft 1\nright -1\n"), Outcome::Accepted);
    assert!(is_rejected(source, "refuted s\nat x = 0\ncomponent\nleft 0\nright 0\n"));
    assert!(is_rejected(source, "refuted s\nat x = -1\ncomponent\nleft 1\nright 2\n"));
    let undefined = "chart L(x); refute s: log(x)*0 == 1;";
    assert!(is_rejected(undefined, "refuted s\nat x = -1\ncomponent\nleft 0\nright 1\n"));
    assert_eq!(outcome(undefined, "refuted s\nat x = 2\ncomponent\nleft 0\nright 1\n"), Outcome::Accepted);
}

#[test]
fn an_unknown_function_has_one_value_at_one_place() {
    let source = "chart L(x); fn f(x); refute s: f(2*x) == f(x + x);";
    let entry = "refuted s\nat x = 1\nat f(2) = 1\nat f(2.0000000000001) = 2\ncomponent\nleft 1\nright 2\n";
    assert!(is_rejected(source, entry));
}

#[test]
fn functions_of_inverse_functions_and_powers_of_logarithms_are_algebraic() {
    let source = "chart L(x); prove s: cos(atan(x)) == 1/sqrt(1 + x**2);";
    let entry = "proved s\nbase 1 + x**2\nroot 2\npositive 1 + x**2\nzero\n";
    assert_eq!(outcome(source, entry), Outcome::Accepted);
    let source = "chart L(x) where x > 0; param q; prove s: exp(log(x)/2)**2 == x;";
    assert_eq!(outcome(source, "proved s\nbase x\nroot 2\npositive x\nzero\n"), Outcome::Accepted);
}

#[test]
fn sines_and_cosines_of_parts_of_a_half_turn_are_algebraic() {
    for (right, wrong) in [
        ("cos(pi/3) == 1/2", "cos(pi/3) == -1/2"),
        ("cos(2*pi/3) == -1/2", "cos(2*pi/3) == 1/2"),
        ("sin(7*pi/6) == -1/2", "sin(7*pi/6) == 1/2"),
        ("tan(pi/3) == sqrt(3)", "tan(pi/3) == -sqrt(3)"),
        ("sin(pi/4)**2 == 1/2", "sin(pi/4)**2 == 1/4"),
        ("cos(pi/5) == (1 + sqrt(5))/4", "cos(pi/5) == (1 - sqrt(5))/4"),
        ("cos(pi/8)**2 == (1 + cos(pi/4))/2", "cos(pi/8)**2 == (1 - cos(pi/4))/2"),
        ("cos(pi/12)**2 == (2 + sqrt(3))/4", "cos(pi/12)**2 == (2 - sqrt(3))/4"),
    ] {
        let source = |claim: &str| format!("chart L(x); prove s: {claim};");
        assert_eq!(outcome(&source(right), "proved s\nzero\n"), Outcome::Accepted, "{right}");
        assert!(is_rejected(&source(wrong), "proved s\nzero\n"), "{wrong}");
    }
}

#[test]
fn fifths_and_fifteenths_of_a_half_turn_need_three_roots() {
    let roots = "base 5\nroot 4\nbase 2\nroot 2\nbase sqrt(5) + 1\nroot 2\npositive sqrt(5) + 1\n";
    let entry = format!("proved s\n{roots}zero\n");
    for (right, wrong) in [
        ("cos(2*pi/5) == (sqrt(5) - 1)/4", "cos(2*pi/5) == (1 - sqrt(5))/4"),
        ("sin(pi/5)**2 == (5 - sqrt(5))/8", "sin(pi/5)**2 == (5 + sqrt(5))/8"),
        ("sin(pi/10) == (sqrt(5) - 1)/4", "sin(pi/10) == (1 - sqrt(5))/4"),
        ("sin(3*pi/5) == sin(2*pi/5)", "sin(3*pi/5) == -sin(2*pi/5)"),
        // the product of two cosines, by the sum and the difference of the angles
        ("4*cos(4*pi/15)*cos(pi/15) == 1 + 2*cos(pi/5)", "4*cos(4*pi/15)*cos(pi/15) == 1 - 2*cos(pi/5)"),
    ] {
        let source = |claim: &str| format!("chart L(x); prove s: {claim};");
        assert_eq!(outcome(&source(right), &entry), Outcome::Accepted, "{right}");
        assert!(is_rejected(&source(wrong), &entry), "{wrong}");
    }
}

#[test]
fn a_logarithm_of_a_magnitude_needs_no_sign() {
    let source = "chart L(x); prove s: log(abs(x)) == log(x**2)/2;";
    assert_eq!(outcome(source, "proved s\nbase x\nlogarithm\nzero\n"), Outcome::Accepted);
    assert!(is_rejected(
        "chart L(x); prove s: log(abs(x)) == log(x**2);",
        "proved s\nbase x\nlogarithm\nzero\n"
    ));
}
