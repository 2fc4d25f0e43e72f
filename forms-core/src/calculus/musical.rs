//! The musical isomorphisms ♭ and ♯, and the inner products of fields and of forms.

use super::blade::{Blade, Coordinate};
use super::coefficient::{Coefficients, Quotients};
use super::field::Field;
use super::form::Form;
use super::metric::Metric;
use super::pullback::{Pullback, pullback};
use std::collections::BTreeMap;

/// X♭ = Σ gᵢⱼ Xⁱ dxʲ
pub fn flat<R: Coefficients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    x: &Field<R::Scalar>,
) -> Form<R::Scalar> {
    let terms = x.components().map(|(i, value)| (Blade::of(i), value.clone()));
    metric.lower(ring, &Form::from_terms(1, terms))
}

/// w♯ = Σ gⁱʲ wᵢ ∂ⱼ of a 1-form
pub fn sharp<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    w: &Form<R::Scalar>,
) -> Field<R::Scalar> {
    let mut field = Field::zero();
    for (blade, value) in w.terms() {
        let Some(i) = blade.coordinates().next() else { continue };
        for (j, entry) in metric.inverse_row(ring, i) {
            let product = ring.multiply(value, &entry);
            let part = Field::along(ring, j, product);
            field = field.add(ring, &part);
        }
    }
    field
}

/// g(X, Y) = Σ gᵢⱼ Xⁱ Yʲ
pub fn inner_of_fields<R: Coefficients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    x: &Field<R::Scalar>,
    y: &Field<R::Scalar>,
) -> R::Scalar {
    let mut sum = ring.zero();
    for ((i, j), entry) in metric.entries() {
        let (Some(xi), Some(yj)) = (x.component(*i), y.component(*j)) else { continue };
        let product = ring.multiply(xi, yj);
        let term = ring.multiply(entry, &product);
        sum = ring.add(&sum, &term);
    }
    sum
}

/// ⟨a, b⟩ = Σ a_I det(gⁱʲ; i ∈ I, j ∈ J) b_J of two k-forms, so that ⟨dx∧dy, dx∧dy⟩ = 1 in
/// Euclidean space.
pub fn inner_of_forms<R: Quotients>(
    ring: &mut R,
    metric: &Metric<R::Scalar>,
    a: &Form<R::Scalar>,
    b: &Form<R::Scalar>,
) -> R::Scalar {
    let mut rows: BTreeMap<Coordinate, Vec<(Coordinate, R::Scalar)>> = BTreeMap::new();
    for coordinate in a.terms().iter().flat_map(|term| term.0.coordinates()) {
        rows.entry(coordinate).or_insert_with(|| metric.inverse_row(ring, coordinate));
    }
    let mut sum = ring.zero();
    let raised = raise(ring, &rows, a);
    for (blade, value) in raised.terms() {
        let Some(other) = b.coefficient(*blade) else { continue };
        let product = ring.multiply(value, other);
        sum = ring.add(&sum, &product);
    }
    sum
}

/// Raises every index of a form; the blade dx_I of the result stands for ∂_I.
fn raise<R: Coefficients>(
    ring: &mut R,
    rows: &BTreeMap<Coordinate, Vec<(Coordinate, R::Scalar)>>,
    a: &Form<R::Scalar>,
) -> Form<R::Scalar> {
    let images = rows.iter().map(|(i, row)| {
        (*i, Form::from_terms(1, row.iter().map(|(j, value)| (Blade::of(*j), value.clone()))))
    });
    let raising = Pullback::linear(images);
    pullback(ring, &raising, a, |_, value| value.clone())
}
