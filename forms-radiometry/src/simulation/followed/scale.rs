//! Scales: what the tolerance of cells and pixels is relative to, found in a pilot that every share of the work repeats.
//!
//! ```text
//! scale = max over cells of (value − 2σ)          settled when no value is above scale/0.9
//! ```
//! A pilot gives every cell its first samples, and more to those whose values are above what the scale allows: a few of the largest,
//! of which either the scale or the value gives way. A cell that had a lucky sample is not taken for the largest, because its error is as
//! large as its value; and as the scale is from below, errors within the tolerance of it are within that of the largest value.

use super::asked::Asked;
use rayon::prelude::*;

/// How many standard errors a scale is below a value.
const BELOW: f64 = 2.0;
/// The part of each value that a settled scale has.
const SETTLED: f64 = 0.9;
/// How many cells get more samples at a time, for each band.
const CANDIDATES: usize = 64;
/// The most samples of a replicate in a pilot.
const MOST: u32 = 1 << 10;

/// For each receiver the scale of its cells in each band; nothing for those without.
pub(super) type Scales = Vec<Vec<f64>>;

/// The scales, or the questions that more samples are to decide them.
pub(super) fn settled(asked: &[Asked], receivers: usize, bands: usize) -> Result<Scales, Vec<usize>> {
    let mut scales = vec![Vec::new(); receivers];
    let mut open = Vec::new();
    for of_receiver in asked.chunk_by(|a, b| a.receiver == b.receiver) {
        let receiver = of_receiver[0].receiver;
        let first = asked.iter().position(|asked| asked.receiver == receiver).unwrap_or(0);
        let is_cell = |place: &usize| asked[*place].cell.is_some();
        let cells: Vec<usize> = (first..first + of_receiver.len()).filter(is_cell).collect();
        if cells.is_empty() {
            continue;
        }
        for band in 0..bands {
            let (scale, candidates) = of_band(asked, &cells, band);
            scales[receiver].push(scale);
            open.extend(candidates);
        }
    }
    open.sort_unstable();
    open.dedup();
    if open.is_empty() { Ok(scales) } else { Err(open) }
}

/// The scale of cells in a band, and the cells that may change it.
fn of_band(asked: &[Asked], cells: &[usize], band: usize) -> (f64, Vec<usize>) {
    let found: Vec<[f64; 2]> = cells.par_iter().map(|&cell| asked[cell].found(band)).collect();
    let largest = found.iter().map(|[value, _]| *value).fold(0.0, f64::max);
    let scale = found.iter().map(|[value, error]| value - BELOW * error).fold(0.0, f64::max);
    let is_open = |&(place, [value, _]): &(usize, [f64; 2])| {
        let cell = &asked[cells[place]];
        SETTLED * value > scale && cell.computed.is_none() && cell.replicates.samples < MOST
    };
    let mut open: Vec<(usize, [f64; 2])> = found.iter().copied().enumerate().filter(is_open).collect();
    open.sort_by(|(_, [a, _]), (_, [b, _])| b.total_cmp(a));
    open.truncate(CANDIDATES);
    (if scale > 0.0 { scale } else { largest }, open.into_iter().map(|(place, _)| cells[place]).collect())
}
