//! Metrics g = Σ gᵢⱼ dxⁱ dxʲ on a chart: the map that lowers indices, the determinant and the
//! inverse.
//!
//! The determinant of some rows and columns is a coefficient of the wedge product of these rows.
//! Minors are therefore computed by the wedge product, without division and each once. Coordinates
//! that the metric does not couple form blocks; the determinant is the product over the blocks.

use super::blade::{Blade, Coordinate};
use super::coefficient::{Coefficients, Quotients};
use super::form::Form;
use super::pullback::{Pullback, pullback};
use std::collections::BTreeMap;

/// A metric, possibly indefinite, with the quantities that its operations share.
#[derive(Clone, Debug)]
pub struct Metric<S> {
    coordinates: Vec<Coordinate>,
    /// 1 if the chart's order is an even permutation of the numerical order, else −1.
    orientation: i8,
    entries: BTreeMap<(Coordinate, Coordinate), S>,
    lowering: Pullback<S>,
    blocks: Vec<Block<S>>,
    determinant: S,
    density: S,
    sign: S,
}

/// Coordinates that the metric couples with each other and with no others.
#[derive(Clone, Debug)]
struct Block<S> {
    blade: Blade,
    determinant: S,
}

impl<S: Clone> Metric<S> {
    /// Creates the metric with these entries gᵢⱼ (i ≤ j; missing entries are zero), oriented by the
    /// order of the coordinates.
    pub fn new<R: Quotients<Scalar = S>>(
        ring: &mut R,
        order: &[Coordinate],
        upper: &BTreeMap<(Coordinate, Coordinate), S>,
    ) -> Self {
        let mut entries = BTreeMap::new();
        for (&(i, j), value) in upper {
            if !ring.is_zero(value) {
                entries.insert((i, j), value.clone());
                entries.insert((j, i), value.clone());
            }
        }
        let mut coordinates = order.to_vec();
        coordinates.sort_unstable();
        let lowering = Pullback::linear(coordinates.iter().map(|&i| (i, row(&entries, i))));
        let blocks: Vec<Block<S>> = coupled(&coordinates, &entries)
            .into_iter()
            .map(|blade| Block { blade, determinant: minor(ring, &lowering, blade, blade) })
            .collect();
        let mut determinant = ring.one();
        for block in &blocks {
            determinant = ring.multiply(&determinant, &block.determinant);
        }
        let (density, sign) = ring.magnitude(&determinant);
        Metric {
            orientation: parity(order),
            coordinates,
            entries,
            lowering,
            blocks,
            determinant,
            density,
            sign,
        }
    }

    /// Returns the size of the largest block of metrics with these entries.
    pub fn largest_block(order: &[Coordinate], upper: &BTreeMap<(Coordinate, Coordinate), S>) -> u32 {
        coupled(order, upper).into_iter().map(Blade::degree).max().unwrap_or(0)
    }

    /// Returns the coordinates of its chart, in numerical order.
    pub fn coordinates(&self) -> &[Coordinate] {
        &self.coordinates
    }

    /// Returns the entries gᵢⱼ that are not known to vanish.
    pub fn entries(&self) -> &BTreeMap<(Coordinate, Coordinate), S> {
        &self.entries
    }

    /// Returns the dimension n.
    pub fn dimension(&self) -> u32 {
        self.coordinates.len() as u32
    }

    /// det g
    pub fn determinant(&self) -> &S {
        &self.determinant
    }

    /// Returns the determinants of the blocks, whose product is det g.
    pub fn block_determinants(&self) -> impl Iterator<Item = &S> {
        self.blocks.iter().map(|block| &block.determinant)
    }

    /// √|det g|
    pub fn density(&self) -> &S {
        &self.density
    }

    /// s = det g/|det g|
    pub fn sign(&self) -> &S {
        &self.sign
    }

    /// Returns the chart's orientation: the sign of dx₁∧…∧dxₙ in numerical order.
    pub(super) fn orientation(&self) -> i8 {
        self.orientation
    }

    /// Returns the product of all differentials.
    pub(super) fn top(&self) -> Blade {
        union(self.coordinates.iter().copied())
    }

    /// Lowers every index: the blade dx_I stands for ∂_I, which is mapped to ∧ Σⱼ gᵢⱼ dxʲ.
    pub(super) fn lower<R: Coefficients<Scalar = S>>(&self, ring: &mut R, v: &Form<S>) -> Form<S> {
        pullback(ring, &self.lowering, v, |_, value| value.clone())
    }

    /// Returns the row gⁱʲ of the inverse: cofactors divided by the determinant, both of the block
    /// of i.
    pub(super) fn inverse_row<R: Quotients<Scalar = S>>(
        &self,
        ring: &mut R,
        i: Coordinate,
    ) -> Vec<(Coordinate, S)> {
        let Some(block) = self.blocks.iter().find(|block| block.blade.contains(i)) else { return Vec::new() };
        let Some((without_i, sign_i)) = block.blade.without(i) else { return Vec::new() };
        let one = ring.one();
        let image = self.lower(ring, &Form::from_terms(without_i.degree(), [(without_i, one)]));
        let mut row = Vec::new();
        for j in block.blade.coordinates() {
            let Some((without_j, sign_j)) = block.blade.without(j) else { continue };
            let Some(cofactor) = image.coefficient(without_j) else { continue };
            let quotient = ring.divide(cofactor, &block.determinant);
            row.push((j, if sign_i == sign_j { quotient } else { ring.negate(&quotient) }));
        }
        row
    }
}

/// Σⱼ gᵢⱼ dxʲ
fn row<S: Clone>(entries: &BTreeMap<(Coordinate, Coordinate), S>, i: Coordinate) -> Form<S> {
    let terms = entries.iter().filter(|((row, _), _)| *row == i);
    Form::from_terms(1, terms.map(|((_, j), value)| (Blade::of(*j), value.clone())))
}

/// Returns the determinant of the submatrix with these rows and columns.
fn minor<R: Coefficients>(
    ring: &mut R,
    lowering: &Pullback<R::Scalar>,
    rows: Blade,
    columns: Blade,
) -> R::Scalar {
    let one = ring.one();
    let rows = Form::from_terms(rows.degree(), [(rows, one)]);
    let image = pullback(ring, lowering, &rows, |_, value| value.clone());
    image.coefficient(columns).cloned().unwrap_or_else(|| ring.zero())
}

/// Returns the connected components of the coordinates, where an entry joins two coordinates.
fn coupled<S>(coordinates: &[Coordinate], entries: &BTreeMap<(Coordinate, Coordinate), S>) -> Vec<Blade> {
    let mut blocks: Vec<Blade> = coordinates.iter().map(|&i| Blade::of(i)).collect();
    for &(i, j) in entries.keys() {
        let place = |c: Coordinate| blocks.iter().position(|block| block.contains(c));
        let (Some(a), Some(b)) = (place(i), place(j)) else { continue };
        if a != b {
            let joined = union(blocks[a].coordinates().chain(blocks[b].coordinates()));
            blocks[a.min(b)] = joined;
            blocks.remove(a.max(b));
        }
    }
    blocks
}

/// Returns the blade of a set of coordinates.
fn union(coordinates: impl IntoIterator<Item = Coordinate>) -> Blade {
    let differentials = coordinates.into_iter().map(Blade::of);
    differentials.fold(Blade::SCALAR, |all, next| all.wedge(next).map_or(all, |(blade, _)| blade))
}

/// Returns the sign of the permutation that puts the coordinates in numerical order.
fn parity(order: &[Coordinate]) -> i8 {
    let mut product = (Blade::SCALAR, 1);
    for &coordinate in order {
        if let Some((blade, sign)) = product.0.wedge(Blade::of(coordinate)) {
            product = (blade, product.1 * sign);
        }
    }
    product.1
}
