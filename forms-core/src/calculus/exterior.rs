//! The exterior derivative: dw = Σᵢ ∂ᵢw_I dxᵢ∧dx_I.

use super::blade::{Blade, Coordinate};
use super::coefficient::Coefficients;
use super::form::Form;
use std::collections::BTreeMap;

/// One term ±∂w_I/∂xᵢ dx_J of an exterior derivative, with ±dx_J = dxᵢ∧dx_I.
#[derive(Clone, Copy, Debug)]
pub struct Contribution<'a, S> {
    /// I
    pub blade: Blade,
    /// w_I
    pub value: &'a S,
    /// i
    pub coordinate: Coordinate,
    /// J
    pub raised: Blade,
    /// ±1
    pub sign: i8,
}

/// Returns the terms of the exterior derivative along the given coordinates, whether or not they
/// vanish.
pub fn contributions<'a, S: Clone>(
    w: &'a Form<S>,
    along: &'a [Coordinate],
) -> impl Iterator<Item = Contribution<'a, S>> {
    w.terms().iter().flat_map(move |(blade, value)| {
        along.iter().filter_map(move |&coordinate| {
            let (raised, sign) = Blade::of(coordinate).wedge(*blade)?;
            Some(Contribution { blade: *blade, value, coordinate, raised, sign })
        })
    })
}

/// Signed coefficients with the coordinates by which they are differentiated, grouped by basis
/// form.
type Groups<'a, S> = BTreeMap<Blade, Vec<(i8, &'a S, Coordinate)>>;

/// Returns the exterior derivative along the given coordinates: all of them for d, one chart's for
/// `d[chart]`.
pub fn exterior_derivative<R: Coefficients>(
    ring: &mut R,
    w: &Form<R::Scalar>,
    along: &[Coordinate],
) -> Form<R::Scalar> {
    let mut groups: Groups<R::Scalar> = Groups::new();
    for Contribution { value, coordinate, raised, sign, .. } in contributions(w, along) {
        groups.entry(raised).or_default().push((sign, value, coordinate));
    }
    let mut terms = Vec::with_capacity(groups.len());
    for (blade, group) in groups {
        let value = ring.sum_of_derivatives(&group);
        if !ring.is_zero(&value) {
            terms.push((blade, value));
        }
    }
    Form::from_terms(w.degree() + 1, terms)
}
