//! The Hodge star, the volume form, the codifferential and the Laplacian of forms.
//!
//! By Jacobi's identity for complementary minors, a ∧ ⋆b = ⟨a, b⟩ vol gives ⋆dx_I = (s/√|g|) ε(I,
//! Iᶜ) Σ_J det(gᵢⱼ; i ∈ Iᶜ, j ∈ J) dx_J: the complement of I with its indices lowered. This needs
//! no inverse, and no division except by √|g|.

use super::coefficient::{Coefficients, Quotients};
use super::exterior::exterior_derivative;
use super::form::Form;
use super::metric::Metric;
use super::wedge::wedge;

/// vol = √|g| dx₁∧…∧dxₙ in the order of the chart.
pub fn volume<R: Coefficients>(ring: &mut R, metric: &Metric<R::Scalar>) -> Form<R::Scalar> {
    let density = metric.density().clone();
    let signed = if metric.orientation() < 0 { ring.negate(&density) } else { density };
    Form::monomial(ring, metric.top(), signed)
}

/// ⋆w, a form of degree n − k.
pub fn hodge<R: Quotients>(ring: &mut R, metric: &Metric<R::Scalar>, w: &Form<R::Scalar>) -> Form<R::Scalar> {
    let star = bare_star(ring, metric, w);
    let factor = ring.divide(metric.sign(), metric.density());
    star.scale(ring, &factor)
}

/// √|g| s ⋆w, which is polynomial in the entries of g: ⋆w without its square root.
fn bare_star<R: Coefficients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    w: &Form<R::Scalar>,
) -> Form<R::Scalar> {
    let mut complements = Vec::with_capacity(w.terms().len());
    for (blade, value) in w.terms() {
        let complement = blade.complement_in(metric.top());
        let sign = blade.wedge(complement).map_or(1, |(_, sign)| sign) * metric.orientation();
        complements.push((complement, if sign < 0 { ring.negate(value) } else { value.clone() }));
    }
    let degree = metric.dimension().saturating_sub(w.degree());
    metric.lower(ring, &Form::from_terms(degree, complements))
}

/// δw = s (−1)^(n(k+1)+1) ⋆d⋆w of a form of degree k ≥ 1.
///
/// With ⋆ = (s/√|g|) L the roots and the sign s cancel: s ⋆d⋆w = (1/det g) L(dLw − d(det g)/(2 det
/// g) ∧ Lw).
pub fn codifferential<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    w: &Form<R::Scalar>,
) -> Form<R::Scalar> {
    if w.degree() == 0 || w.degree() > metric.dimension() {
        return Form::zero(w.degree().saturating_sub(1));
    }
    let along = metric.coordinates();
    let star = bare_star(ring, metric, w);
    let derivative = exterior_derivative(ring, &star, along);
    let logarithmic = half_logarithmic_derivative(ring, metric);
    let correction = wedge(ring, &logarithmic, &star).negate(ring);
    let inner = derivative.add(ring, &correction);
    let outer = bare_star(ring, metric, &inner);
    let one = ring.one();
    let factor = ring.divide(&one, metric.determinant());
    let scaled = outer.scale(ring, &factor);
    let exponent = metric.dimension() * (w.degree() + 1) + 1;
    if exponent % 2 == 1 { scaled.negate(ring) } else { scaled }
}

/// d log √|g| = Σ d(det)/(2 det) over the blocks.
pub(super) fn half_logarithmic_derivative<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
) -> Form<R::Scalar> {
    let mut sum = Form::zero(1);
    for determinant in metric.block_determinants() {
        let scalar = Form::scalar(ring, determinant.clone());
        let derivative = exterior_derivative(ring, &scalar, metric.coordinates());
        let twice = ring.add(determinant, determinant);
        let quotient = derivative.map(ring, |ring, value| ring.divide(value, &twice));
        sum = sum.add(ring, &quotient);
    }
    sum
}

/// Δw = dδw + δdw; for functions on Euclidean space, minus the sum of the second derivatives.
pub fn laplacian<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    w: &Form<R::Scalar>,
) -> Form<R::Scalar> {
    let along = metric.coordinates();
    let derivative = exterior_derivative(ring, w, along);
    let first = codifferential(ring, metric, &derivative);
    if w.degree() == 0 {
        return first;
    }
    let inner = codifferential(ring, metric, w);
    exterior_derivative(ring, &inner, along).add(ring, &first)
}
