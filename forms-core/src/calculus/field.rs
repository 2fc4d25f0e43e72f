//! Vector fields X = Σ Xⁱ ∂ᵢ, their action on functions and their bracket.

use super::blade::Coordinate;
use super::coefficient::Coefficients;
use std::collections::BTreeMap;

/// A vector field by its components; components known to vanish are omitted.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Field<S> {
    components: BTreeMap<Coordinate, S>,
}

impl<S: Clone> Field<S> {
    /// The zero field.
    pub fn zero() -> Self {
        Field { components: BTreeMap::new() }
    }

    /// f ∂/∂x
    pub fn along(ring: &impl Coefficients<Scalar = S>, coordinate: Coordinate, value: S) -> Self {
        let mut field = Self::zero();
        if !ring.is_zero(&value) {
            field.components.insert(coordinate, value);
        }
        field
    }

    /// Returns the components that are not known to vanish.
    pub fn components(&self) -> impl Iterator<Item = (Coordinate, &S)> {
        self.components.iter().map(|(coordinate, value)| (*coordinate, value))
    }

    /// Xⁱ, if it is not known to vanish.
    pub fn component(&self, coordinate: Coordinate) -> Option<&S> {
        self.components.get(&coordinate)
    }

    /// X + Y
    pub fn add(&self, ring: &mut impl Coefficients<Scalar = S>, other: &Field<S>) -> Field<S> {
        let mut sum = self.clone();
        for (coordinate, value) in other.components() {
            let total = match sum.components.get(&coordinate) {
                Some(present) => ring.add(present, value),
                None => value.clone(),
            };
            if ring.is_zero(&total) {
                sum.components.remove(&coordinate);
            } else {
                sum.components.insert(coordinate, total);
            }
        }
        sum
    }

    /// Returns the field with every component replaced; components that vanish are dropped.
    pub fn map<T: Clone, R: Coefficients<Scalar = T>>(
        &self,
        ring: &mut R,
        mut change: impl FnMut(&mut R, &S) -> T,
    ) -> Field<T> {
        let mut changed = Field::zero();
        for (coordinate, value) in self.components() {
            let value = change(ring, value);
            if !ring.is_zero(&value) {
                changed.components.insert(coordinate, value);
            }
        }
        changed
    }

    /// −X
    pub fn negate(&self, ring: &mut impl Coefficients<Scalar = S>) -> Field<S> {
        self.map(ring, |ring, value| ring.negate(value))
    }

    /// f X
    pub fn scale(&self, ring: &mut impl Coefficients<Scalar = S>, factor: &S) -> Field<S> {
        self.map(ring, |ring, value| ring.multiply(factor, value))
    }
}

/// X(f) = Σ Xⁱ ∂ᵢf
pub fn derivative_along<R: Coefficients>(ring: &mut R, x: &Field<R::Scalar>, f: &R::Scalar) -> R::Scalar {
    let mut sum = ring.zero();
    for (coordinate, component) in x.components() {
        let partial = ring.derivative(f, coordinate);
        let term = ring.multiply(component, &partial);
        sum = ring.add(&sum, &term);
    }
    sum
}

/// [X, Y]ⁱ = X(Yⁱ) − Y(Xⁱ)
pub fn bracket<R: Coefficients>(
    ring: &mut R,
    x: &Field<R::Scalar>,
    y: &Field<R::Scalar>,
) -> Field<R::Scalar> {
    let forward = y.map(ring, |ring, component| derivative_along(ring, x, component));
    let backward = x.map(ring, |ring, component| derivative_along(ring, y, component));
    let backward = backward.negate(ring);
    forward.add(ring, &backward)
}
