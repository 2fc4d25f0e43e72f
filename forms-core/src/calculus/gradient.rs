//! Gradient, curl and divergence: the exterior derivative in terms of fields.

use super::coefficient::Quotients;
use super::exterior::exterior_derivative;
use super::field::Field;
use super::form::Form;
use super::hodge::{half_logarithmic_derivative, hodge};
use super::interior::pairing;
use super::metric::Metric;
use super::musical::{flat, sharp};

/// grad f = (df)♯
pub fn gradient<R: Quotients>(ring: &mut R, metric: &Metric<R::Scalar>, f: &R::Scalar) -> Field<R::Scalar> {
    let scalar = Form::scalar(ring, f.clone());
    let derivative = exterior_derivative(ring, &scalar, metric.coordinates());
    sharp(ring, metric, &derivative)
}

/// curl X = (⋆dX♭)♯ in three dimensions
pub fn curl<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    x: &Field<R::Scalar>,
) -> Field<R::Scalar> {
    let lowered = flat(ring, metric, x);
    let derivative = exterior_derivative(ring, &lowered, metric.coordinates());
    let star = hodge(ring, metric, &derivative);
    sharp(ring, metric, &star)
}

/// div X with L_X vol = div X vol: Σ ∂ᵢXⁱ + X(log √|g|)
pub fn divergence<R: Quotients>(ring: &mut R, metric: &Metric<R::Scalar>, x: &Field<R::Scalar>) -> R::Scalar {
    let mut sum = ring.zero();
    for (coordinate, component) in x.components() {
        let partial = ring.derivative(component, coordinate);
        sum = ring.add(&sum, &partial);
    }
    let logarithmic = half_logarithmic_derivative(ring, metric);
    let along = pairing(ring, &logarithmic, &[x]);
    ring.add(&sum, &along)
}
