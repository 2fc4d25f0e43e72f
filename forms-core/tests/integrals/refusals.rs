//! Integrals that do not converge, are not known to converge, or are outside the class: they are
//! refused with the reason.

use super::quadrature::{errors, theory_of};
use forms_core::check::{decide_all, read_theory};
use forms_core::decide::{UnknownReason, Verdict, decide};

fn reason(integral: &str) -> String {
    let functions =
        "fn f(x); fn g(x); fn half(x) where x > 0; fn holed(x) where x != 0; fn left(x) where x <= 0;";
    let text = format!("chart R1(x); param c; {functions} let it = integral({integral});");
    let found = errors(&text);
    assert_eq!(found.len(), 1, "{integral}: {found:?}");
    found[0].clone()
}

#[test]
fn singular_integrands_are_refused() {
    let table = [
        (
            "1/x, x = -1..1",
            "cannot integrate over `x`: it is not known that `x` is not zero on the whole range of `x`",
        ),
        (
            "1/x, x = 0..1",
            "cannot integrate over `x`: it is not known that `x` is positive on the whole range of `x`",
        ),
        (
            "1/x**2, x = -1..1",
            "cannot integrate over `x`: it is not known that `x` is not zero on the whole range of `x`",
        ),
        (
            "1/(x - c), x = 0..1",
            "cannot integrate over `x`: it is not known that `x - c` is not zero on the whole range of `x`",
        ),
        ("sqrt(x)**2, x = -1..1", "cannot integrate: it is not known that `x >= 0` holds on the whole range"),
        (
            "sqrt(1 - x**2), x = 0..2",
            "cannot integrate: it is not known that `1 - x**2 >= 0` holds on the whole range",
        ),
        ("log(x), x = -1..1", "cannot integrate: it is not known that `x > 0` holds on the whole range"),
        (
            "1/cos(x)**2, x = 0..pi",
            "cannot integrate over `x`: it is not known that `cos(1/2*x)` is not zero on the whole range of `x`",
        ),
    ];
    for (integral, message) in table {
        assert_eq!(reason(integral), message, "{integral}");
    }
}

#[test]
fn what_is_outside_the_class_is_refused() {
    let table = [
        (
            "exp(x**2), x = 0..1",
            "cannot integrate over `x`: no antiderivative of `exp(x**2)` with respect to `x` is known",
        ),
        ("if x > 0 { 1 } else { 0 }, x = 0..1", "cannot integrate over `x`: an expression with `if`"),
        (
            "1/(x**5 + x + 1), x = 0..1",
            "cannot integrate over `x`: a denominator of degree 5 that was not factored",
        ),
    ];
    for (integral, message) in table {
        assert_eq!(reason(integral), message, "{integral}");
    }
}

#[test]
fn a_statement_about_an_integral_that_was_not_found_is_undecided_and_the_others_are_decided() {
    let text =
        "chart R1(x); prove a: integral(exp(x**2), x = 0..1) == 1; prove b: integral(x, x = 0..1) == 1/2;";
    let (mut theory, found) = theory_of(text);
    assert_eq!(found, [""; 0]);
    let verdicts = decide_all(&mut theory);
    let reason = "cannot integrate over `x`: no antiderivative of `exp(x**2)` with respect to `x` is known";
    assert_eq!(verdicts[0], Verdict::Unknown { reason: UnknownReason::NoValue(reason.into()) });
    assert_eq!(verdicts[1].name(), "proved");
}

#[test]
fn a_statement_about_an_integral_that_may_not_exist_is_an_error() {
    for integrand in ["1/x", "log(x)/x**2", "exp(x)/(x - 1)"] {
        let text = format!("chart R1(x); prove a: integral({integrand}, x = 0..1) == 1;");
        assert_eq!(errors(&text).len(), 1, "{integrand}");
    }
}

/// The conditions on a parameter allow a zero of the denominator in the range, or at its end. Each
/// integral would be accepted if a rule about signs over the range overestimated a bound, a power
/// or an end.
#[test]
fn integrands_that_a_parameter_may_make_singular_are_refused() {
    let table = [
        ("c < 10, c != 5", "exp(x)/(exp(x) + c - 3), x = 0..1", "exp(x) + (c - 3)", "is not zero"),
        ("c > -1", "1/(x + c), x = 1/2..1", "x + c", "is not zero"),
        ("c >= 0", "1/(x + c), x = 0..1", "x + c", "is positive"),
        ("c**2 >= 1", "1/(x + c**2 - 1), x = 0..1", "x + (c**2 - 1)", "is positive"),
        ("c >= a, a > 0, b >= 0", "1/(x + c + b - a), x = 0..1", "x + (c + b - a)", "is positive"),
        ("c > 0", "1/(1 - sqrt(x)), x = 0..1", "-(sqrt(x) - 1)", "is positive"),
        ("c > 0", "1/(x - 1/2)**2, x = 0..1", "2*x - 1", "is not zero"),
        ("c > 0", "1/(1 + 2*cos(x)), x = 0..pi", "2*tan(1/2*x) - sqrt(12)", "is not zero"),
    ];
    for (conditions, integral, part, claim) in table {
        let text = format!("chart R1(x); param a, b, c where {conditions}; let it = integral({integral});");
        let expected = format!(
            "cannot integrate over `x`: it is not known that `{part}` {claim} on the whole range of `x`"
        );
        assert_eq!(errors(&text), [expected], "{integral} where {conditions}");
    }
}

#[test]
fn the_narrower_of_two_bounds_of_a_parameter_counts() {
    let text =
        "chart R1(x); param c where 0 < c < 10, c < 3; let it = integral(exp(x)/(exp(x) + 4 - c), x = 0..1);";
    assert_eq!(errors(text), [""; 0]);
}

/// An unknown function can be singular at the boundary of its conditions, as log x is at 0 for x >
/// 0, and 1/x for x ≠ 0.
#[test]
fn unknown_functions_are_integrated_only_where_their_conditions_hold_up_to_the_ends() {
    let table = [
        (
            "diff(half, x), x = 0..1",
            "cannot integrate: it is not known that `x > 0` holds on the whole range",
        ),
        (
            "diff(holed, x), x = -1..1",
            "cannot integrate: it is not known that `x != 0` holds on the whole range",
        ),
        (
            "diff(left, x), x = -1..1",
            "cannot integrate: it is not known that `x <= 0` holds on the whole range",
        ),
        (
            "diff(holed, x), x = 0..1",
            "cannot integrate: it is not known that `x != 0` holds on the whole range",
        ),
        ("half*x, x = 0..1", "cannot integrate: it is not known that `x > 0` holds on the whole range"),
        ("holed**2, x = -1..1", "cannot integrate: it is not known that `x != 0` holds on the whole range"),
        ("f/x, x = 0..1", "cannot integrate: it is not known that `x != 0` holds on the whole range"),
        ("f*log(x), x = 0..1", "cannot integrate: it is not known that `x > 0` holds on the whole range"),
        ("f/g, x = 0..1", "cannot integrate: it is not known that `g != 0` holds on the whole range"),
        ("sqrt(f), x = 0..1", "cannot integrate: it is not known that `f >= 0` holds on the whole range"),
    ];
    for (integral, message) in table {
        assert_eq!(reason(integral), message, "{integral}");
    }
}

#[test]
fn what_a_statement_says_of_its_points_says_nothing_of_what_is_integrated_over() {
    for claim in [
        "integral(integral(sqrt(x**2)*y, y = 0..1), x = -1..1) == 0 where x > 0",
        "potential(integral(sqrt((x - 1)**2)*y, y = 0..1)*dx) == x**2/4 - x/2 where x > 1",
    ] {
        let (mut theory, errors) = read_theory(&format!("chart L(x, y); prove claim: {claim};"));
        if errors.is_empty() {
            let statement = theory.statements[0].clone();
            assert_ne!(decide(&mut theory, &statement).name(), "proved", "{claim}");
        }
    }
}
