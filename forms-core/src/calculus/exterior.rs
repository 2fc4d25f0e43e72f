//! The exterior derivative: dw = Σᵢ ∂ᵢw_I dxᵢ∧dx_I.

use super::blade::{Blade, Coordinate};
use super::coefficient::Coefficients;
use super::form::Form;
use std::collections::BTreeMap;

/// Signed partial derivatives of coefficients, grouped by the basis form they belong to.
type Contributions<'a, S> = BTreeMap<Blade, Vec<(i8, &'a S, Coordinate)>>;

/// The exterior derivative along the given coordinates: all of them for d, one chart's for `d[chart]`.
pub fn exterior_derivative<R: Coefficients>(
    ring: &mut R,
    w: &Form<R::Scalar>,
    along: &[Coordinate],
) -> Form<R::Scalar> {
    let mut contributions: Contributions<R::Scalar> = Contributions::new();
    for (blade, value) in w.terms() {
        for &coordinate in along {
            if let Some((raised, sign)) = Blade::of(coordinate).wedge(*blade) {
                contributions.entry(raised).or_default().push((sign, value, coordinate));
            }
        }
    }
    let mut terms = Vec::with_capacity(contributions.len());
    for (blade, group) in contributions {
        let value = ring.sum_of_derivatives(&group);
        if !ring.is_zero(&value) {
            terms.push((blade, value));
        }
    }
    Form::from_terms(w.degree() + 1, terms)
}
