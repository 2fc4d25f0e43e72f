//! Integrals by offered antiderivatives: valid proofs, and invalid ones.

use crate::support::{certificate, checked};
use forms_check::Outcome;
use forms_core::certificate::{HEADER, file_lines};

/// Returns the outcome for one claim `p` about an integral, with offers for its ranges in the order
/// of the source.
fn outcome(source: &str, offers: &[&str], proof: &str) -> Outcome {
    let places = source.match_indices("..").map(|(dots, _)| {
        let before = &source[..dots];
        let equals = before.rfind('=').unwrap_or(0);
        let name = before[..equals].trim_end();
        name.rfind(|c: char| !c.is_alphanumeric()).map_or(0, |at| at + 1)
    });
    let mut lines = HEADER.to_string() + &file_lines("it.forms", source);
    // the innermost range is written last and integrated first
    for (place, offer) in places.zip(offers) {
        lines += &format!("integral {place} {offer}\n");
    }
    lines += &format!("proved p\n{proof}");
    let all = checked(&lines, source).expect("a certificate that can be read");
    all.into_iter().find(|one| one.name == "p").expect("the claim").outcome
}

fn is_accepted(source: &str, offers: &[&str]) -> bool {
    outcome(source, offers, "zero\n") == Outcome::Accepted
}

const LINE: &str = "chart L(x, y); chart H(w) where w > 0; fn f(x, y); param a, b, k where a < b, k > 0;";

fn on_line(claim: &str, offers: &[&str]) -> bool {
    is_accepted(&format!("{LINE} prove p: {claim};"), offers)
}

#[test]
fn an_antiderivative_is_believed_once_its_derivative_is_the_integrand() {
    assert!(on_line("integral(x**2, x = 0..3) == 9", &["x**3/3\nzero"]));
    assert!(on_line("integral(x**2, x = 3..0) == -9", &["x**3/3 + 7\nzero"]));
    assert!(on_line("integral(cos(k*x), x = 0..y) == sin(k*y)/k", &["sin(k*x)/k\nzero"]));
    assert!(on_line("integral(diff(f, x), x = a..b) == f(b, y) - f(a, y)", &["f\nzero"]));
    assert!(on_line("integral(x*y, y = 0..1, x = 0..y) == 1/8", &["y**4/8\nzero", "x**2*y/2\nzero"]));
    assert!(on_line("integral(dx^dy, y = 0..1, x = 0..1) == -1", &["-y\nzero", "-x\nzero"]));
    for wrong in ["x**3/2\nzero", "x**3/3 + y*x\nzero", "x**2\nzero", "x**3/3", ""] {
        assert!(!on_line("integral(x**2, x = 0..3) == 9", &[wrong]), "{wrong}");
    }
    assert!(!on_line("integral(x**2, x = 0..3) == 8", &["x**3/3\nzero"]));
    assert!(!on_line("integral(dx^dy, y = 0..1, x = 0..1) == 1", &["-y\nzero", "-x\nzero"]));
}

#[test]
fn a_jump_between_the_bounds_is_seen() {
    assert!(on_line("integral(1/x**2, x = 1..2) == 1/2", &["-1/x\nzero"]));
    assert!(on_line("integral(1/x**2, x = -2..-1) == 1/2", &["-1/x\nzero"]));
    assert!(on_line(
        "integral(1/(1 + x**2)**2*x, x = -1..y) == 1/4 - 1/(2*(1 + y**2))",
        &["-1/(2*(1 + x**2))\nzero"]
    ));
    for (claim, offer) in [
        ("integral(1/x**2, x = -1..1) == -2", "-1/x\nzero"),
        ("integral(1/x**2, x = 0..1) == -1", "-1/x\nzero"),
        ("integral(1/x**2, x = a..b) == 1/a - 1/b", "-1/x\nzero"),
        ("integral(0*x, x = -1..1) == 2", "abs(x)/x\nbase x\nzero"),
        ("integral(1 + tan(x)**2, x = 0..pi) == 0", "tan(x)\nzero"),
        ("integral(1/(1 + x**2), x = -1..1) == -pi/2", "atan(-1/x)\nzero"),
        ("integral(1/(2*x - 1)**2, x = 0..1) == -1", "-1/(2*(2*x - 1))\nzero"),
        ("integral(1/(x**2 - k)**2*x, x = 0..k) == 1/(2*k) - 1/(2*k*(k - 1))", "-1/(2*(x**2 - k))\nzero"),
    ] {
        assert!(!on_line(claim, &[offer]), "{claim}");
    }
}

#[test]
fn bounds_in_either_order_bound_the_variable() {
    assert!(on_line("integral(1/(1 + w)**2, w = 0..k) == 1 - 1/(1 + k)", &["-1/(1 + w)\nzero"]));
    assert!(on_line("integral(1/(1 + w)**2, w = k..0) == 1/(1 + k) - 1", &["-1/(1 + w)\nzero"]));
    assert!(!on_line("integral(1/(1 + w)**2, w = 0..y) == 1 - 1/(1 + y)", &["-1/(1 + w)\nzero"]));
    assert!(!on_line("integral(1/(1 + w)**2, w = 0..-k) == 1 - 1/(1 - k)", &["-1/(1 + w)\nzero"]));
    // a divisor of degree 2, bounded by its values at the bounds and by its control point
    assert!(on_line("integral((1 - 2*x)/(1 + x - x**2)**2, x = 0..1) == 0", &["-1/(1 + x - x**2)\nzero"]));
    assert!(!on_line(
        "integral((1 - 2*x)/(1/5 - x + x**2)**2, x = 0..1) == 0",
        &["1/(1/5 - x + x**2)\nzero"]
    ));
}

#[test]
fn no_condition_speaks_of_a_variable_that_is_integrated_over() {
    // x and w are positive outside the integral, and take negative values inside
    let magnitude = "integral(sqrt(x**2), x = -1..1) == 0 where x > 0";
    assert!(!on_line(magnitude, &["x**2/2\nbase x\npositive x\nzero"]));
    let domain = "integral(sqrt(w**2), w = -1..1) == 0";
    assert!(!on_line(domain, &["w**2/2\nbase w\npositive w\nzero"]));
    let param = "integral(sqrt(k**2), k = -1..1) == 0";
    assert!(!on_line(param, &["k**2/2\nbase k\npositive k\nzero"]));
    // an inner integral within an outer one
    let nested = "integral(integral(sqrt(x**2)*y, y = 0..1), x = -1..1) == 0 where x > 0";
    let inner = "x*y**2/2\nbase x\npositive x\nzero";
    assert!(!on_line(nested, &[inner, "x**2/4\nzero"]));
    let named =
        format!("{LINE} let q = integral(sqrt(w**2)*y, y = 0..1); prove p: integral(q, w = -1..1) == 0;");
    assert!(!is_accepted(&named, &["w*y**2/2\nbase w\npositive w\nzero", "w**2/4\nzero"]));
    let kept =
        format!("{LINE} let q = integral(sqrt(w**2)*y, y = 0..1); prove p: integral(q, w = 1..2) == 3/4;");
    assert!(is_accepted(&kept, &["w*y**2/2\nbase w\npositive w\nzero", "w**2/4\nzero"]));
    // a condition on a point does not hold for its image
    let pulled = format!(
        "{LINE} map m: L -> L = (-x, y); prove p: pullback(m, integral(sqrt(x**2)*y, y = 0..1)) == -x/2 where x > 0;"
    );
    assert!(!is_accepted(&pulled, &[inner]));
}

#[test]
fn zeros_of_parameters_are_left_out_of_open_conditions_only() {
    let source = |claim: &str, condition: &str| {
        format!("chart L(x, y); param c{condition}; map m: L -> L = (x, 0); prove p: {claim};")
    };
    let wave = "integral(cos(c*x), x = 0..1) == sin(c)/c";
    assert!(is_accepted(&source(wave, ""), &["sin(c*x)/c\nzero"]));
    assert!(is_accepted(&source(wave, " where c < 2"), &["sin(c*x)/c\nzero"]));
    // the conditions leave only the zero
    let nothing = "integral(cos(c*x), x = 0..1) == 5";
    for proof in ["undefined\n", "base c\nsplit 1\nend\n", "zero\n"] {
        let closed = source(nothing, " where c >= 0, c <= 0");
        assert_ne!(outcome(&closed, &["sin(c*x)/c\nzero"], proof), Outcome::Accepted, "{proof}");
        let pulled = source("pullback(m, integral(cos(y*x), x = 0..1)) == 5", "");
        assert_ne!(outcome(&pulled, &["sin(y*x)/y\nzero"], proof), Outcome::Accepted, "{proof}");
        let zero = source(nothing, "");
        for offer in [
            "sin(c*x)/(c - c)\nzero",
            "sin(c*x)/c*(c - c)/(c - c)\nzero",
            "5*x/(cos(c)**2 + sin(c)**2 - 1)\nzero",
        ] {
            assert_ne!(outcome(&zero, &[offer], proof), Outcome::Accepted, "{offer} {proof}");
        }
    }
}

#[test]
fn what_divides_by_zero_everywhere_shows_no_antiderivative() {
    let claim = "integral(0*x + 1, x = 0..1) == 17";
    assert!(!on_line(claim, &["abs(x - x) + 17*x\nundefined"]));
    assert!(!on_line(claim, &["17*x + 1/(x - x)\nundefined"]));
}

#[test]
fn a_value_may_be_differentiated_only_where_it_holds_all_around() {
    // the conditions leave one point, at which |x| can be replaced by −x
    let source = format!("{LINE} prove p: diff(integral(x, y = 0..1), x) == -1 where x >= 0, x <= 0;");
    let offer = "-abs(x)*y\nbase x\nnegative -x\nzero";
    assert_ne!(outcome(&source, &[offer], "base x\npositive x\nzero\n"), Outcome::Accepted);
}

#[test]
fn boundaries_are_oriented_outwards() {
    let source = |value: &str| {
        format!(
            "{LINE} chart UV(u, v); map s: UV -> L = (u, v); prove p: boundary_integral(s, x*dy, u = 0..2, v = 0..3) == {value};"
        )
    };
    // over u = 2 and u = 0 along v, over v = 3 and v = 0 along u
    let entry = |value: &str| {
        let source = source(value);
        let mut lines = certificate(&source);
        if !lines.contains("proved p") {
            let start = lines.find("refuted p").expect("an entry");
            lines.truncate(start);
            lines += "proved p\nzero\n";
        }
        checked(&lines, &source).expect("a certificate that can be read").remove(0).outcome
    };
    assert_eq!(entry("6"), Outcome::Accepted);
    assert_ne!(entry("-6"), Outcome::Accepted);
}

#[test]
fn no_number_of_an_antiderivative_can_be_changed() {
    let source = "chart S(t, p); param h where h > 0;\n\
        prove sphere: integral(sin(t)*dt^dp, t = 0..pi, p = 0..2*pi) == 4*pi;\n\
        prove wave: integral(t*cos(2*t), t = 0..pi/2) == -1/2;\n\
        prove decay: integral(exp(-h*t)*h, t = 0..3) == 1 - exp(-3*h);\n\
        prove lamp: integral(t/(t**2 + h**2)**2, t = 0..h) == 1/(4*h**2);\n";
    let lines = certificate(source);
    let accepted = |text: &str| {
        checked(text, source).is_ok_and(|all| all.iter().all(|one| one.outcome == Outcome::Accepted))
    };
    assert!(accepted(&lines), "{:?}\n{lines}", checked(&lines, source));
    let offers = lines.find("\nproved").expect("a proof");
    let start = lines.find("\nintegral").expect("an offer");
    for (place, byte) in lines[..offers].char_indices().skip(start) {
        let before = lines[..place].chars().next_back().is_some_and(|c| c.is_alphabetic());
        let others: &[&str] = match byte {
            '0'..='8' if !before => &["9"],
            '9' => &["1"],
            '+' => &["-"],
            '-' => &["+"],
            _ => &[],
        };
        for other in others {
            let changed = format!("{}{other}{}", &lines[..place], &lines[place + 1..]);
            assert!(!accepted(&changed), "{}", &changed[lines[..place].rfind('\n').unwrap_or(0)..offers]);
        }
    }
}
