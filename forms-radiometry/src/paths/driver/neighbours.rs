//! Neighbours: the first samples of the cells around a cell correct its estimated standard error.
//!
//! ```text
//! s² = mean of n σ² over the cells around
//! error after n samples = max(σ, min(σ s/(σ₁ √n₁), s/√n))
//! ```
//! σ is a cell's own standard error, and σ₁ the standard error after its first n₁ samples. A few
//! samples that have all missed a rare event agree with each other: the cell would be done too
//! early, be too dark, and report a small error. (If the number of samples depends on their values,
//! their mean is biased: Kirk and Arvo, Unbiased sampling techniques for image synthesis, 1991.)
//! The cells around it that see the same surface have met the event. Where the samples of a cell
//! agree better than theirs, its error is larger by that ratio, but no larger than theirs.

use super::request::Request;
use crate::scene::Scene;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// Reach of the neighbourhood of a cell, in columns and in rows.
const REACH: usize = 8;

/// Spread of one of a cell's values, as indicated by the cells around it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Spread {
    /// Their standard error with one sample of each replicate.
    of_all: f64,
    /// Standard error of the cell itself, as part of theirs, at most 1.
    own: f64,
}

/// Result of the first samples of a cell.
struct First<'a> {
    request: &'a Request,
    /// Variance of each value with one sample of each replicate.
    variances: Vec<f64>,
}

/// Cells of a map, or pixels of an image, that need samples.
struct Cells<'a> {
    size: [usize; 2],
    at: Vec<Option<First<'a>>>,
}

/// Returns the spreads of the cells of all receivers, question by question and value by value;
/// empty where no samples are needed, and for points and faces in no order.
pub(super) fn spreads(requests: &[Request], scene: &Scene) -> Vec<Vec<Spread>> {
    let mut all = Vec::with_capacity(requests.len());
    for of_receiver in requests.chunk_by(|a, b| a.receiver == b.receiver) {
        let size = scene.receivers[of_receiver[0].receiver].kind.raster();
        let cells = size.map(|size| Cells::of(of_receiver, size));
        let told = |request: &Request| match (&cells, request.cell) {
            (Some(cells), Some(cell)) => cells.tell(cell),
            _ => Vec::new(),
        };
        all.par_extend(of_receiver.par_iter().map(told));
    }
    all
}

impl<'a> Cells<'a> {
    fn of(requests: &'a [Request], size: [usize; 2]) -> Self {
        let mut at: Vec<Option<First>> = (0..size[0] * size[1]).map(|_| None).collect();
        for request in requests.iter().filter(|request| request.computed.is_none()) {
            if let Some(cell) = request.cell {
                at[cell] = Some(First::of(request));
            }
        }
        Self { size, at }
    }

    /// Returns the spreads of a cell that needs samples.
    fn tell(&self, cell: usize) -> Vec<Spread> {
        let Some(own) = &self.at[cell] else { return Vec::new() };
        let around = self.around(own, cell);
        let of_one = |(place, variance): (usize, &f64)| {
            let sum: f64 = around.iter().map(|first| first.variances[place]).sum();
            let of_all = (sum / around.len() as f64).sqrt();
            Spread { of_all, own: if of_all > 0.0 { (variance.sqrt() / of_all).min(1.0) } else { 1.0 } }
        };
        own.variances.iter().enumerate().map(of_one).collect()
    }

    /// Returns a cell together with the cells around it that see the same single surface.
    fn around(&self, own: &'a First<'a>, cell: usize) -> Vec<&First<'a>> {
        let [columns, rows] = self.size;
        let near = |place: usize, count: usize| place.saturating_sub(REACH)..(place + REACH + 1).min(count);
        let seen = own.request.seen;
        let is_like = |other: &&First| seen.surface.is_ok() && other.request.seen == seen;
        let all = near(cell / columns, rows)
            .flat_map(|row| near(cell % columns, columns).map(move |column| row * columns + column));
        let others = all.filter(|&other| other != cell).filter_map(|other| self.at[other].as_ref());
        std::iter::once(own).chain(others.filter(is_like)).collect()
    }
}

impl<'a> First<'a> {
    fn of(request: &'a Request) -> Self {
        let samples = f64::from(request.replicates.samples);
        let variance = |place| {
            let [_, error] = request.replicates.found(place);
            samples * error * error
        };
        Self { request, variances: (0..request.replicates.len()).map(variance).collect() }
    }
}

impl Spread {
    /// Returns the corrected standard error of a cell after this many samples.
    pub(super) fn error(self, own: f64, samples: u32) -> f64 {
        // the quotient means nothing for a cell that found nothing, or only one value
        own.max((own / self.own).min(self.of_all / f64::from(samples).sqrt()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cell_is_as_inexact_as_those_around_it_until_its_own_samples_tell_more() {
        let spread = Spread { of_all: 8.0, own: 0.25 };
        for (what, own, samples, expected) in [
            ("it fell as it should", 1.0, 4, 4.0),
            ("it fell faster, as on a net", 0.25, 4, 1.0),
            ("something rare was met", 3.0, 4, 4.0),
            ("it is larger than theirs", 5.0, 4, 5.0),
        ] {
            assert_eq!(spread.error(own, samples), expected, "{what}");
        }
        assert_eq!(Spread { of_all: 8.0, own: 0.0 }.error(0.0, 4), 4.0, "it found nothing");
    }
}
