//! Integrals of unknown functions: linearity, Fubini's theorem, differentiation under the integral,
//! integration by parts, Gauss's theorem. Refutations name functions; statements that depend on the
//! sign of an integral remain undecided.

use super::quadrature::theory_of;
use forms_core::decide::{Verdict, decide};

const DECLARATIONS: &str = "chart Plane(x, y); chart Line(s); chart Space(u, v, w); chart Time(t);
    map still: Space -> Space = (u, v, w);
    param a, b, c; fn f(s); fn g(s); fn h(x, y); fn k(x, s); fn m(x, y, s); fn F(x); fn G(x);
    fn X(u, v, w); fn Y(u, v, w); fn Z(u, v, w); fn energy(u, v, w, t); fn q(s) where s > 0;";

fn verdict(statement: &str) -> Verdict {
    let (mut theory, errors) = theory_of(&format!("{DECLARATIONS} prove it: {statement};"));
    assert!(errors.is_empty(), "{statement}: {errors:?}");
    let statement = theory.statements[0].clone();
    decide(&mut theory, &statement)
}

fn all_are(name: &str, statements: &[&str]) {
    for statement in statements {
        let found = verdict(statement);
        assert_eq!(found.name(), name, "{statement}: {found:?}");
    }
}

#[test]
fn operators_given_by_integrals_are_linear() {
    all_are(
        "proved",
        &[
            "integral(k*(a*f + b*g), s = 0..1) == a*integral(k*f, s = 0..1) + b*integral(k*g, s = 0..1)",
            "integral(m*(a*h + b*F), x = 0..1, y = 0..c)
                == a*integral(m*h, x = 0..1, y = 0..c) + b*integral(m*F, x = 0..1, y = 0..c)",
            "integral((1 + s)*f, s = 0..1) - integral(s*f, s = 0..1) == integral(f, s = 0..1)",
            "integral(cos(2*s)*f, s = 0..b) == integral((1 - 2*sin(s)**2)*f, s = 0..b)",
            "integral(q/s, s = 1..2) + integral(q, s = 1..2) == integral(q*(1 + s)/s, s = 1..2)",
        ],
    );
    all_are(
        "refuted",
        &[
            "integral(k*(a*f + b*g), s = 0..1) == a*integral(k*f, s = 0..1) + integral(k*g, s = 0..1)",
            "integral(f*g, s = 0..1) == integral(f, s = 0..1)*integral(g, s = 0..1)",
            "integral(f**2, s = 0..1) == integral(f, s = 0..1)**2",
        ],
    );
}

#[test]
fn ranges_are_split_and_variables_renamed() {
    all_are(
        "proved",
        &[
            "integral(f, s = a..b) == integral(f, s = a..c) + integral(f, s = c..b)",
            "integral(f, s = a..b) == -integral(f, s = b..a)",
            "integral(f*sin(s), s = a..b) == integral(f(x)*sin(x), x = a..b)",
            "integral(f(s + 1), s = 0..1) == integral(f, s = 1..2)",
            "integral(f(a - s)*g, s = 0..a) == integral(f*g(a - s), s = 0..a)",
            "integral(f(s**2)*s, s = 0..2) == integral(f, s = 0..4)/2",
            "integral(f(sin(s))*cos(s), s = 0..pi/2) == integral(f, s = 0..1)",
        ],
    );
    all_are(
        "refuted",
        &[
            "integral(f, s = a..b) == integral(f, s = a..c) - integral(f, s = c..b)",
            "integral(f(2*s), s = 0..1) == integral(f, s = 0..2)",
            "integral(f(s + 1), s = 0..1) == integral(f, s = 0..1)",
            "integral(f, s = 0..1) == (f(0) + 4*f(1/2) + f(1))/6",
        ],
    );
}

#[test]
fn the_order_of_integration_does_not_matter() {
    all_are(
        "proved",
        &[
            "integral(h, x = 0..a, y = 0..b) == integral(h, y = 0..b, x = 0..a)",
            "integral(F*integral(k*f, s = 0..1), x = 0..1) == integral(f*integral(k*F, x = 0..1), s = 0..1)",
            "integral(F*sin(x)*integral(k*cos(s)*f, s = 0..1), x = 0..1)
                == integral(f*cos(s)*integral(k*sin(x)*F, x = 0..1), s = 0..1)",
            "integral(F(x)*G(y), x = 0..1, y = 0..1) == integral(F, x = 0..1)*integral(G, x = 0..1)",
        ],
    );
    all_are(
        "refuted",
        &[
            "integral(h(x, y), x = 0..1, y = 0..1) == 2*integral(h(x, y), x = 0..1, y = 0..x)",
            "integral(h, x = 0..1, y = 0..2) == integral(h, x = 0..2, y = 0..1)",
        ],
    );
}

#[test]
fn derivatives_are_taken_under_the_integral() {
    all_are(
        "proved",
        &[
            "diff(integral(k, s = 0..1), x) == integral(diff(k, x), s = 0..1)",
            "diff(integral(k*f, s = 0..x), x) == k(x, x)*f(x) + integral(diff(k, x)*f, s = 0..x)",
            "diff(integral(f, s = x..y), y, x) == 0",
            "diff(integral(energy, u = 0..1, v = 0..1, w = 0..1), t)
                == integral(diff(energy, t), u = 0..1, v = 0..1, w = 0..1)",
        ],
    );
    all_are(
        "refuted",
        &[
            "diff(integral(k*f, s = 0..x), x) == integral(diff(k, x)*f, s = 0..x)",
            "diff(integral(f, s = x..y), x) == f(x)",
        ],
    );
}

#[test]
fn partial_integration_carries_derivatives_over() {
    all_are(
        "proved",
        &[
            "integral(diff(F, x)*G, x = a..b) == F(b)*G(b) - F(a)*G(a) - integral(F*diff(G, x), x = a..b)",
            "integral(F*diff(G, x, x) - diff(F, x, x)*G, x = 0..1)
                == integral(diff(F*diff(G, x) - diff(F, x)*G, x), x = 0..1)",
            "integral(x*diff(F, x) + F, x = 0..a) == a*F(a)",
            "integral(diff(F, x)*G + F*diff(G, x) + F, x = 0..1)
                == F(1)*G(1) - F(0)*G(0) + integral(F, x = 0..1)",
        ],
    );
    all_are(
        "refuted",
        &["integral(diff(F, x)*G, x = 0..1) == F(1)*G(1) - F(0)*G(0) + integral(F*diff(G, x), x = 0..1)"],
    );
}

#[test]
fn flux_out_of_a_box_is_the_integral_of_the_divergence() {
    let flux = "boundary_integral(still, X*dv^dw + Y*dw^du + Z*du^dv, u = 0..a, v = 0..b, w = 0..c)";
    let divergence = "integral(diff(X, u) + diff(Y, v) + diff(Z, w), u = 0..a, v = 0..b, w = 0..c)";
    all_are("proved", &[&format!("{flux} == {divergence}"), &format!("-{flux} == -{divergence}")]);
    all_are("refuted", &[&format!("{flux} == -{divergence}")]);
}

/// ∫f² ≥ 0 and the Cauchy–Schwarz inequality constrain the values of integrals, so independently
/// chosen values are not a valid point.
#[test]
fn values_that_no_function_has_refute_nothing() {
    all_are(
        "unknown",
        &[
            "abs(integral(f**2, s = 0..1)) == integral(f**2, s = 0..1)",
            "abs(integral(f**2, s = 0..1)*integral(g**2, s = 0..1) - integral(f*g, s = 0..1)**2)
                == integral(f**2, s = 0..1)*integral(g**2, s = 0..1) - integral(f*g, s = 0..1)**2",
        ],
    );
}

#[test]
fn a_refutation_names_functions_that_have_the_integrals() {
    let Verdict::Refuted(witness) = verdict("integral(f*g, s = 0..1) == 0") else { panic!() };
    let names: Vec<&str> = witness.point.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["f", "g"]);
    assert!(witness.point.iter().all(|(_, value)| value.contains('s')), "{:?}", witness.point);
}
