//! Laws of the metric operations on random metrics. Each has a wrong variant, which must be refuted
//! for some metric.

use super::random::{COORDINATES, Metric, blade, metrics, subsets};
use super::theory::{assert_proved, is_refuted};

/// Returns a random form of one degree: unknown functions times basis forms.
fn form(metric: &Metric, degree: usize) -> String {
    let functions = ["p", "q", "x", "(1 + y)"];
    let terms = subsets(metric.dimension(), degree).into_iter().enumerate();
    terms
        .map(|(k, places)| format!("{}*{}", functions[k % 4], blade(&places)))
        .collect::<Vec<_>>()
        .join(" + ")
}

fn field(metric: &Metric) -> String {
    let functions = ["p", "q", "x*y"];
    let terms = (0..metric.dimension()).map(|k| format!("{}*@{}", functions[k], COORDINATES[k]));
    terms.collect::<Vec<_>>().join(" + ")
}

/// Sign s = det g/|det g| in terms of the volume: ⋆vol = s.
const SIGN: &str = "hodge[g](volume[g])";

/// Law: both sides for a metric and a degree, and the right side of a wrong variant.
type Law = fn(&Metric, usize) -> Option<[String; 3]>;

fn two_stars(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let (n, w) = (metric.dimension(), form(metric, k));
    let sign = if (k * (n - k)).is_multiple_of(2) { "" } else { "-" };
    let right = format!("{sign}{SIGN}*({w})");
    Some([format!("hodge[g](hodge[g]({w}))"), right, format!("{sign}({w})")])
}

fn definition_of_the_star(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let (a, b) = (form(metric, k), format!("y*({})", blade(&subsets(metric.dimension(), k)[0])));
    let left = if k == 0 { format!("({a})*hodge[g]({b})") } else { format!("({a})^hodge[g]({b})") };
    let right = format!("inner[g]({a}, {b})*volume[g]");
    let slip = format!("inner[g]({a}, {b})*abs(volume[g][{}])**2*{}", top(metric), top(metric));
    Some([left, right, slip])
}

fn top(metric: &Metric) -> String {
    blade(&(0..metric.dimension()).collect::<Vec<_>>())
}

fn codifferential(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let (n, w) = (metric.dimension(), form(metric, k));
    let sign = if (n * (k + 1) + 1).is_multiple_of(2) { "" } else { "-" };
    let stars = format!("hodge[g](d(hodge[g]({w})))");
    (k > 0).then(|| [format!("codiff[g]({w})"), format!("{sign}{SIGN}*{stars}"), format!("{sign}{stars}")])
}

fn divergence(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let x = field(metric);
    let by_volume = format!("interior({x}, volume[g])");
    let right = format!("{SIGN}*hodge[g](d({by_volume}))");
    (k == 1).then(|| [format!("div[g]({x})"), right, format!("hodge[g](d({by_volume}))")])
}

fn star_of_one(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let slip = format!("abs({SIGN}*volume[g][{}])**2*{}", top(metric), top(metric));
    (k == 0).then(|| ["hodge[g](1)".into(), "volume[g]".into(), slip])
}

fn musical(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let x = field(metric);
    (k == 1).then(|| [format!("sharp[g](flat[g]({x}))"), x.clone(), format!("{SIGN}*({x})")])
}

fn gradients_have_no_curl(metric: &Metric, k: usize) -> Option<[String; 3]> {
    (k == 1 && metric.dimension() == 3)
        .then(|| ["curl[g](grad[g](p))".into(), "0*@x".into(), "grad[g](p)".into()])
}

fn curls_have_no_divergence(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let x = field(metric);
    (k == 1 && metric.dimension() == 3)
        .then(|| [format!("div[g](curl[g]({x}))"), "0".into(), format!("div[g]({x})")])
}

fn laplacian(metric: &Metric, k: usize) -> Option<[String; 3]> {
    let div_grad = "div[g](grad[g](p))";
    (k == 0 && metric.dimension() == 2)
        .then(|| ["laplace[g](p)".into(), format!("-{div_grad}"), div_grad.into()])
}

fn check(law: Law) {
    let mut seen = false;
    for metric in metrics(10) {
        for degree in 0..=metric.dimension() {
            let Some([left, right, slip]) = law(&metric, degree) else { continue };
            assert_proved(&metric.preamble(), &left, &right);
            seen = seen || is_refuted(&metric.preamble(), &left, &slip);
        }
    }
    assert!(seen, "no metric sees the slip");
}

#[test]
fn two_stars_are_one_up_to_sign() {
    check(two_stars);
}

#[test]
fn a_wedge_star_b_is_the_inner_product_times_the_volume() {
    check(definition_of_the_star);
}

#[test]
fn the_codifferential_is_star_d_star_with_the_sign_of_the_metric() {
    check(codifferential);
}

#[test]
fn the_divergence_is_that_of_the_volume() {
    check(divergence);
}

#[test]
fn the_star_of_one_is_the_volume() {
    check(star_of_one);
}

#[test]
fn sharp_undoes_flat() {
    check(musical);
}

#[test]
fn gradients_are_free_of_curl() {
    check(gradients_have_no_curl);
}

#[test]
fn curls_are_free_of_divergence() {
    check(curls_have_no_divergence);
}

#[test]
fn the_laplacian_of_a_function_is_minus_the_divergence_of_its_gradient() {
    check(laplacian);
}
