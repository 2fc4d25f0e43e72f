//! The pullback by a map: F*(w dx_I) = (w∘F) dF_i₁∧…∧dF_iₖ.

use super::blade::{Blade, Coordinate};
use super::coefficient::Coefficients;
use super::exterior::exterior_derivative;
use super::form::Form;
use super::wedge::wedge;
use std::collections::BTreeMap;

/// A map prepared for pullbacks: the differentials dFᵢ of its components along the source's
/// coordinates. Coordinates that do not belong to the target stay unchanged.
#[derive(Clone, Debug)]
pub struct Pullback<S> {
    differentials: BTreeMap<Coordinate, Form<S>>,
}

impl<S: Clone> Pullback<S> {
    /// Creates the pullback by the map that sends the source's coordinates to `components`, one for
    /// each target coordinate.
    pub fn new<R: Coefficients<Scalar = S>>(
        ring: &mut R,
        components: &[(Coordinate, S)],
        source: &[Coordinate],
    ) -> Self {
        let differentials = components
            .iter()
            .map(|(target, component)| {
                let scalar = Form::scalar(ring, component.clone());
                (*target, exterior_derivative(ring, &scalar, source))
            })
            .collect();
        Pullback { differentials }
    }

    /// Creates the map that sends each of these differentials to a 1-form, extended to products.
    pub(super) fn linear(images: impl IntoIterator<Item = (Coordinate, Form<S>)>) -> Self {
        Pullback { differentials: images.into_iter().collect() }
    }

    fn of_differential<R: Coefficients<Scalar = S>>(&self, ring: &mut R, coordinate: Coordinate) -> Form<S> {
        match self.differentials.get(&coordinate) {
            Some(image) => image.clone(),
            None => Form::differential(ring, coordinate),
        }
    }
}

/// F*w; `compose` returns the composition of a coefficient with the map.
pub fn pullback<R: Coefficients>(
    ring: &mut R,
    map: &Pullback<R::Scalar>,
    w: &Form<R::Scalar>,
    mut compose: impl FnMut(&mut R, &R::Scalar) -> R::Scalar,
) -> Form<R::Scalar> {
    let mut images: BTreeMap<Blade, Form<R::Scalar>> = BTreeMap::new();
    let mut sum = Form::zero(w.degree());
    for (blade, value) in w.terms() {
        let image = image_of_blade(ring, map, *blade, &mut images);
        let composed = compose(ring, value);
        let term = image.scale(ring, &composed);
        sum = sum.add(ring, &term);
    }
    sum
}

/// dF_i₁∧…∧dF_iₖ, where the image of each tail of a blade is computed once.
fn image_of_blade<R: Coefficients>(
    ring: &mut R,
    map: &Pullback<R::Scalar>,
    blade: Blade,
    images: &mut BTreeMap<Blade, Form<R::Scalar>>,
) -> Form<R::Scalar> {
    if let Some(known) = images.get(&blade) {
        return known.clone();
    }
    let image = match blade.coordinates().next() {
        None => {
            let one = ring.one();
            Form::scalar(ring, one)
        }
        Some(first) => {
            let (rest, _) = blade.without(first).expect("the first coordinate belongs to its blade");
            let head = map.of_differential(ring, first);
            let tail = image_of_blade(ring, map, rest, images);
            wedge(ring, &head, &tail)
        }
    };
    images.insert(blade, image.clone());
    image
}
