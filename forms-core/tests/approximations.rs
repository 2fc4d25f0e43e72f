//! `by F approx E`: forms that are proved to be close to their formula, and forms that are not.

use forms_core::check::read_theory;
use forms_core::compile::{Options, compile};
use forms_core::stability::{Budget, search};
use proptest::prelude::*;

/// Returns the message about a kernel, or `accepted`.
fn verdict(kernel: &str) -> String {
    let compiled = compile(kernel, &Options::default());
    compiled.diagnostics.first().map_or_else(|| "accepted".to_owned(), |found| found.message.clone())
}

/// The Taylor polynomial of (t − sin t)/t³ up to t⁸.
const SERIES: &str = "1/6 - t**2/120 + t**4/5040 - t**6/362880 + t**8/39916800";

#[test]
fn a_form_within_its_tolerance_is_accepted() {
    for (claim, kernel) in [
        (
            "a series near a removable singularity, the formula elsewhere",
            format!("k(t) = (t - sin(t))/t**3 by if abs(t) < 1/2 {{ {SERIES} }} else {{ (t - sin(t))/t**3 }} approx 1e-12"),
        ),
        (
            "the same on a domain that bounds the argument",
            format!("k(t) = (t - sin(t))/t**3 by {SERIES} approx 1e-12 where -1/2 <= t, t <= 1/2"),
        ),
        (
            "a function of a norm, by a polynomial of its square",
            "k(x, y) = sin(sqrt(x**2 + y**2))/sqrt(x**2 + y**2) by if x**2 + y**2 < 1/100 \
             { 1 - (x**2 + y**2)/6 + (x**2 + y**2)**2/120 } \
             else { sin(sqrt(x**2 + y**2))/sqrt(x**2 + y**2) } approx 1e-9"
                .into(),
        ),
        (
            "an approximated factor",
            "k(a, t) = a*(sin(t)/t) by a*(1 - t**2/6) approx 1e-5 where abs(t) < 1/10".into(),
        ),
        (
            "a quotient of approximations",
            "k(t) = sin(t)/cos(t) by (t - t**3/6)/(1 - t**2/2) approx 1e-5 where abs(t) < 1/10".into(),
        ),
        (
            "a polynomial with rounded coefficients",
            "k(t) = exp(t) by 0.99999999 + 1.0000001*t + 0.5*t**2 + 0.1667*t**3 approx 1e-4 where 0 <= t <= 1/10".into(),
        ),
        (
            "a zero of the formula, with its order",
            "k(t) = t - sin(t) by t**3*(1/6 - t**2/120) approx 1e-5 where abs(t) < 1/4".into(),
        ),
        (
            "a singularity away from 0",
            "k(t) = log(t)/(t - 1) by 1 - (t - 1)/2 + (t - 1)**2/3 approx 1e-5 where 99/100 <= t <= 101/100".into(),
        ),
        (
            "what is equal",
            "k(t) = (t**2 - 1)/(t - 1) by t + 1 approx 1e-17".into(),
        ),
    ] {
        assert_eq!(verdict(&format!("kernel {kernel};")), "accepted", "{claim}");
    }
}

#[test]
fn a_form_that_is_not_shown_to_be_close_is_an_error() {
    for (claim, kernel, message) in [
        (
            "a wrong coefficient",
            "k(t) = (t - sin(t))/t**3 by 1/6 - t**2/121 approx 1e-7 where abs(t) < 1/2",
            "the form of `k` is not within 1e-7 of its formula\nat t = -",
        ),
        (
            "too few terms",
            "k(t) = sin(t)/t by 1 - t**2/6 approx 1e-6 where abs(t) < 1/2",
            "the form of `k` is not within 1/1000000 of its formula\nat t = ",
        ),
        (
            "a range that no condition bounds",
            "k(t) = exp(t) by 1 + t approx 1e-2",
            "the form of `k` is not within 1/100 of its formula\nat t = ",
        ),
        (
            "a zero that the form does not have",
            "k(t) = sin(t) by t + 1e-9 approx 1e-3 where abs(t) < 1/100",
            "the form of `k` is not within 1/1000 of its formula\nat t = 0: the formula is 0",
        ),
        (
            "a form without a value where the formula has one",
            "k(t) = 1 + t by t**2/t**2 + t approx 1e-3 where abs(t) < 1/100",
            "cannot decide whether the form of `k` is within 1/1000 of its formula",
        ),
        (
            "a root that the formula does not take",
            "k(t) = 1 + t by 1 + sqrt(t)*sqrt(t) approx 1e-3 where abs(t) < 1/100",
            "cannot decide whether the form of `k` is within 1/1000 of its formula",
        ),
        (
            "a tolerance of more than one half",
            "k(t) = t by t approx 1",
            "expected a rational number above 0 and below 1/2",
        ),
    ] {
        let found = verdict(&format!("kernel {kernel};"));
        assert!(found.starts_with(message), "{claim}: {found}");
    }
}

/// The Taylor polynomial of (t − sin t)/t³ to 1e-17 for |t| < 1/2.
const TO_THE_LAST_DIGIT: &str = "if abs(t) < 1/2 { 1/6 - t**2/120 + t**4/5040 - t**6/362880 + t**8/39916800 \
                                 - t**10/6227020800 + t**12/1307674368000 } else { (1 - sin(t)/t)/t**2 } approx 1e-17";

#[test]
fn a_promise_is_kept_by_the_approximation_where_a_bound_shows_it() {
    for (domain, is_computed) in [(" where abs(t) < 100", true), ("", false)] {
        let text = format!("kernel k(t) = (t - sin(t))/t**3 by {TO_THE_LAST_DIGIT}{domain} within 400;");
        let compiled = compile(&text, &Options::default());
        let generated = compiled.kernels[0].generated();
        assert_eq!(generated.bounded.is_some(), is_computed, "{}", generated.account());
        assert_eq!(generated.is_dropped, !is_computed, "{}", generated.account());
        assert_eq!(generated.within().is_some(), !is_computed, "{}", generated.account());
        for t in [1e-3_f64, 0.3, 0.5, 2.0, -7.0] {
            let value = compiled.kernels[0].values(&[t])[0];
            let exact = if t.abs() < 1.0 { series(t) } else { (1.0 - t.sin() / t) / (t * t) };
            assert!((value / exact - 1.0).abs() < 200.0 * f64::EPSILON, "{t}: {value} {exact}");
        }
    }
}

/// (t − sin t)/t³ as a sum of 12 terms.
fn series(t: f64) -> f64 {
    let term = |n: u32| {
        let factorial: f64 = (1..=2 * n + 3).map(f64::from).product();
        (-1.0_f64).powi(n as i32) * t.powi(2 * n as i32) / factorial
    };
    (0..12).rev().map(term).sum()
}

/// A formula with its value in `f64`, accurate for |t| ≤ 1 away from 0, and the beginning of its
/// Taylor series.
struct Known {
    formula: &'static str,
    value: fn(f64) -> f64,
    coefficients: [f64; 6],
}

const KNOWN: [Known; 4] = [
    Known {
        formula: "sin(t)/t",
        value: |t| t.sin() / t,
        coefficients: [1.0, 0.0, -1.0 / 6.0, 0.0, 1.0 / 120.0, 0.0],
    },
    Known {
        formula: "exp(t)",
        value: f64::exp,
        coefficients: [1.0, 1.0, 0.5, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0],
    },
    Known {
        formula: "log(1 + t)/t",
        value: |t| t.ln_1p() / t,
        coefficients: [1.0, -0.5, 1.0 / 3.0, -0.25, 0.2, -1.0 / 6.0],
    },
    Known { formula: "cos(t)", value: f64::cos, coefficients: [1.0, 0.0, -0.5, 0.0, 1.0 / 24.0, 0.0] },
];

impl Known {
    /// Returns the largest relative error of a polynomial at points of |t| ≤ r.
    fn error(&self, coefficients: &[f64], radius: f64) -> f64 {
        let points = (1..=400).flat_map(|n| [radius * f64::from(n) / 400.0, -radius * f64::from(n) / 400.0]);
        let error = |t: f64| {
            let polynomial = coefficients.iter().rev().fold(0.0, |sum, c| sum * t + c);
            (polynomial / (self.value)(t) - 1.0).abs()
        };
        points.map(error).fold(0.0, f64::max)
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    /// An accepted form is within the tolerance at every point, and a form clearly within it is accepted.
    #[test]
    fn a_form_is_accepted_if_and_only_if_it_is_close(
        which in 0..KNOWN.len(),
        count in 2_usize..=6,
        place in 0_usize..6,
        change in prop_oneof![Just(0.0), -1e-4..1e-4, -1e-6..1e-6],
        radius in prop_oneof![Just(0.5), Just(0.25), 0.01_f64..0.5],
        factor in prop_oneof![0.5..0.99, 1.3..3.0],
    ) {
        let known = &KNOWN[which];
        let mut coefficients = known.coefficients[..count].to_vec();
        coefficients[place % count] += change;
        let error = known.error(&coefficients, radius);
        let tolerance = factor * error;
        prop_assume!(tolerance > 1e-11 && tolerance < 0.4);
        let terms: Vec<String> = coefficients.iter().enumerate().map(|(k, c)| format!("({c})*t**{k}")).collect();
        let found = verdict(&format!(
            "kernel k(t) = {} by {} approx {tolerance:e} where abs(t) <= {radius};",
            known.formula,
            terms.join(" + ").replace("*t**0", "")
        ));
        prop_assert_eq!(found == "accepted", factor > 1.0, "{}: {}", error, found);
    }
}

/// Returns the chosen form of the only kernel of a text, with its loss in bits and its tolerance.
fn chosen(text: &str) -> (Vec<String>, f64, bool) {
    let (mut theory, errors) = read_theory(text);
    assert!(errors.is_empty(), "{errors:?}");
    let kernel = theory.kernels[0].clone();
    let found = search(&mut theory.pool, &kernel, Budget::default()).expect("samples");
    let form = found.chosen().0;
    (theory.pool.texts(&form.outputs), form.loss, form.approximation.is_some())
}

#[test]
fn the_search_computes_removable_singularities_by_series() {
    for formula in ["(t - sin(t))/t**3", "(2*t - 3*sin(t) + t*cos(t))/(2*t**5)"] {
        let (form, loss, is_close) = chosen(&format!("kernel k(t) = {formula};"));
        assert!(is_close && loss < 1.0, "{formula}: {form:?} {loss}");
    }
}
