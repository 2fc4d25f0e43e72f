//! Halving: pieces of an integral are halved until the bounds of their errors sum to the allowed
//! error.
//!
//! ```text
//! pieces ─▶ parts: values, bounds, rounding ─ halved if the bound exceeds a fair share ─▶ sums
//! ```
//! The allowed error is relative to the largest value of a band. While the value is not known, a
//! fraction of its error bound counts as part of it.

use super::{Reached, least};

/// Maximum number of pieces; if more would be needed, the bound is larger than the goal.
const MOST: usize = 1 << 14;
/// Fraction of the unknown remainder that counts as part of the result while pieces are halved.
const OPEN: f64 = 0.1;

/// A piece of the domain of integration.
pub(super) trait Piece: Sized {
    fn halves(&self) -> [Self; 2];
}

/// A piece with its results: values by measure and band, and by band their errors and rounding
/// errors.
pub(super) struct Part<P> {
    pub(super) piece: P,
    pub(super) values: Vec<f64>,
    pub(super) errors: Vec<f64>,
    pub(super) rounding: Vec<f64>,
}

/// Returns the integrals over all pieces by measure and band, for this number of measures in bands
/// of this extinction. Their errors are below the goal, a fraction of the largest value of the
/// band. `part` evaluates a piece.
pub(super) fn halved<P: Piece>(
    pieces: Vec<P>,
    (measures, extinction): (usize, &[f64]),
    goal: f64,
    part: impl Fn(P) -> Part<P>,
) -> Vec<Reached> {
    let mut parts: Vec<Part<P>> = pieces.into_iter().map(&part).collect();
    loop {
        let sums = sums(&parts, measures, extinction);
        let fair: Vec<f64> =
            goals(&sums, goal, extinction.len()).iter().map(|goal| goal / parts.len() as f64).collect();
        let is_open = |part: &Part<P>| part.errors.iter().zip(&fair).any(|(error, fair)| error > fair);
        if parts.len() >= MOST || !parts.iter().any(is_open) {
            return sums;
        }
        let halved = |own: Part<P>| {
            if is_open(&own) { own.piece.halves().map(&part).into() } else { vec![own] }
        };
        parts = parts.into_iter().flat_map(halved).collect();
    }
}

/// Returns for each band the allowed sum of the errors of all parts.
fn goals(sums: &[Reached], goal: f64, bands: usize) -> Vec<f64> {
    let of_band = |band: usize| {
        let known = |sum: &Reached| sum.value.abs().max(OPEN * sum.quadrature);
        let largest = sums.iter().skip(band).step_by(bands).map(known).fold(0.0, f64::max);
        (goal * largest).max(f64::MIN_POSITIVE)
    };
    (0..bands).map(of_band).collect()
}

fn sums<P>(parts: &[Part<P>], measures: usize, extinction: &[f64]) -> Vec<Reached> {
    let of_place = |place: usize| {
        let band = place % extinction.len();
        let sum = |of: fn(&Part<P>) -> &Vec<f64>, place: usize| {
            parts.iter().map(|part| of(part)[place]).sum::<f64>()
        };
        let terms = 1.0 + parts.len() as f64 / super::ROUNDING[0];
        let lost = if parts.is_empty() { 0.0 } else { least(extinction[band]) };
        Reached {
            // an empty sum is −0
            value: 0.0 + sum(|part| &part.values, place),
            quadrature: sum(|part| &part.errors, band),
            rounding: terms * sum(|part| &part.rounding, band) + lost,
        }
    };
    (0..measures * extinction.len()).map(of_place).collect()
}
