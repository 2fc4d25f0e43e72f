//! Neighbours: what the first samples of the cells around a cell tell of how many it needs.
//!
//! ```text
//! s² = mean of n σ² over the cells around          a cell is done at n = s²/ε² samples, or at an error of ε min(1, σ₁ √n₁/s), and at ε
//! ```
//! σ is a standard error, n₁ the number of the first samples and σ₁ their error, ε the error that is tolerated. A few samples that have all missed
//! what is rare agree with each other: the cell would be done too early, and be too dark. (A number of samples that depends on what they
//! found makes their mean wrong: Kirk and Arvo, Unbiased sampling techniques for image synthesis, 1991.) All the cells around that see the same
//! surface have met it. Where a cell agrees with itself better than they do, its tolerance is the smaller by that.

use super::asked::{Asked, MOST};
use crate::scene::{ReceiverKind, Scene};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

/// How far around a cell others are asked, in columns and in rows.
const REACH: usize = 8;

/// What the cells around a cell tell of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Neighbours {
    /// So many samples of each replicate are enough by the errors of all of them.
    enough: u32,
    /// The cell's own error as part of theirs, at most 1.
    part: f64,
}

/// What the first samples of a cell have found.
struct First<'a> {
    asked: &'a Asked,
    /// Each value, and its variance by one sample of each replicate.
    values: Vec<[f64; 2]>,
}

/// The cells of a map, or the pixels of an image, that samples are to answer.
struct Cells<'a> {
    size: [usize; 2],
    at: Vec<Option<First<'a>>>,
}

/// What the cells of all receivers tell of each other, question by question. `scales` has what the tolerance of each receiver's cells is
/// relative to in each band.
pub(super) fn neighbours(asked: &[Asked], scene: &Scene, scales: &[Vec<f64>]) -> Vec<Neighbours> {
    let mut all = Vec::with_capacity(asked.len());
    for of_receiver in asked.chunk_by(|a, b| a.receiver == b.receiver) {
        let receiver = of_receiver[0].receiver;
        let size = match &scene.receivers[receiver].kind {
            ReceiverKind::Surface { grid: Some(size), .. } => *size,
            ReceiverKind::Camera(camera) => camera.resolution,
            _ => [0, 0],
        };
        let cells = Cells::of(of_receiver, size);
        let told = |asked: &Asked| {
            let told = asked.cell.and_then(|cell| cells.tell(cell, &scales[receiver], scene.solve.tolerance));
            told.unwrap_or(Neighbours::NONE)
        };
        all.par_extend(of_receiver.par_iter().map(told));
    }
    all
}

impl<'a> Cells<'a> {
    fn of(asked: &'a [Asked], size: [usize; 2]) -> Self {
        let mut at: Vec<Option<First>> = (0..size[0] * size[1]).map(|_| None).collect();
        for asked in asked.iter().filter(|asked| asked.computed.is_none()) {
            if let Some(cell) = asked.cell {
                at[cell] = Some(First::of(asked));
            }
        }
        Self { size, at }
    }

    /// What is known of a cell that needs samples, with these scales of bands.
    fn tell(&self, cell: usize, scales: &[f64], tolerance: f64) -> Option<Neighbours> {
        let own = self.at[cell].as_ref()?;
        let around = self.around(own, cell);
        let count = around.len() as f64;
        let mean = |place: usize, part: usize| {
            around.iter().map(|first| first.values[place][part]).sum::<f64>() / count
        };
        let mut told = Neighbours::NONE;
        for (place, [_, own_variance]) in own.values.iter().enumerate() {
            let variance = mean(place, 1);
            if variance > 0.0 {
                let scale = scales[own.asked.replicates.band(place)].max(mean(place, 0).abs());
                let enough = variance / (tolerance * scale).powi(2);
                told.enough = told.enough.max(enough.min(f64::from(MOST)).ceil() as u32);
                told.part = told.part.min((own_variance / variance).sqrt());
            }
        }
        Some(told)
    }

    /// A cell with those around it that see the one surface that it sees.
    fn around(&self, own: &'a First<'a>, cell: usize) -> Vec<&First<'a>> {
        let [columns, rows] = self.size;
        let near = |place: usize, count: usize| place.saturating_sub(REACH)..(place + REACH + 1).min(count);
        let seen = own.asked.seen;
        let is_like = |other: &&First| seen.surface.is_ok() && other.asked.seen == seen;
        let all = near(cell / columns, rows)
            .flat_map(|row| near(cell % columns, columns).map(move |column| row * columns + column));
        let others = all.filter(|&other| other != cell).filter_map(|other| self.at[other].as_ref());
        std::iter::once(own).chain(others.filter(is_like)).collect()
    }
}

impl<'a> First<'a> {
    fn of(asked: &'a Asked) -> Self {
        let samples = f64::from(asked.replicates.samples);
        let value = |place| {
            let [value, error] = asked.replicates.found(place);
            [value, samples * error * error]
        };
        Self { asked, values: (0..asked.replicates.len()).map(value).collect() }
    }
}

impl Neighbours {
    /// What is known without any.
    pub(super) const NONE: Self = Self { enough: 0, part: 1.0 };

    /// The tolerance of a cell's own error after so many samples.
    pub(super) fn tolerance(self, samples: u32, tolerance: f64) -> f64 {
        if samples < self.enough { self.part * tolerance } else { tolerance }
    }

    /// The samples after which the cell is done, if its error, which is this now, falls like the root of their number, which is doubled
    /// until then.
    pub(super) fn foreseen(self, samples: u32, error: f64, tolerance: f64) -> f64 {
        let after = |tolerance: f64| {
            let doublings = (2.0 * (error / tolerance).log2()).ceil().max(0.0);
            f64::from(samples) * doublings.exp2()
        };
        after(tolerance).max(after(self.part * tolerance).min(f64::from(self.enough)))
    }
}
