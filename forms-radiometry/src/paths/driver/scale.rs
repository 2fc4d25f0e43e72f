//! Scales: the values that the tolerances of cells and pixels are relative to, found by a pilot
//! that every shard of the work repeats.
//!
//! ```text
//! scale = mean over cells of value − 2σ of the mean     settled when it is 0.9 of the mean or more
//! ```
//! The mean is taken over the cells in which no emitter is seen directly, or over all cells where
//! those are dark. A pilot gives every cell its first samples, and more to the cells whose errors
//! are above the average. The scale is a lower estimate. Errors within the tolerance of the scale
//! are therefore within the tolerance of the mean.

use super::request::Request;
use crate::radiosity::driver::scales::Mean;
use rayon::prelude::*;

/// Number of standard errors of the mean by which a scale is below the mean.
const BELOW: f64 = 2.0;
/// Part of the mean above which a scale is settled.
const SETTLED: f64 = 0.9;
/// Least scale, as part of the mean.
const LEAST: f64 = 0.5;
/// Largest number of samples of a replicate in a pilot.
const MOST: u32 = 1 << 10;

/// Scale of the cells of each receiver in each band; empty for receivers without cells.
pub(super) type Scales = Vec<Vec<f64>>;

/// Scale of the cells of a receiver in a band, from their samples so far.
struct Told {
    scale: f64,
    /// Cells that need more samples to settle it.
    open: Vec<usize>,
}

/// Returns the scales, or the questions that need more samples to settle them.
pub(super) fn settled(requests: &[Request], receivers: usize, bands: usize) -> Result<Scales, Vec<usize>> {
    let told = told(requests, receivers, bands);
    let mut open: Vec<usize> = told.iter().flatten().flat_map(|told| told.open.iter().copied()).collect();
    open.sort_unstable();
    open.dedup();
    if open.is_empty() { Ok(scales(told)) } else { Err(open) }
}

/// Returns the scales from the present samples of all cells.
pub(super) fn known(requests: &[Request], receivers: usize, bands: usize) -> Scales {
    scales(told(requests, receivers, bands))
}

/// Returns the scale of an estimand's tolerance in each band, given the scales of cells.
pub(super) fn of_request(request: &Request, scales: Option<&Scales>, bands: usize) -> Vec<f64> {
    match (scales, request.cell) {
        (Some(scales), Some(_)) => scales[request.receiver].clone(),
        _ => request.largest(bands),
    }
}

fn scales(told: Vec<Vec<Told>>) -> Scales {
    told.into_iter().map(|bands| bands.into_iter().map(|told| told.scale).collect()).collect()
}

/// Returns the scales of the cells of each receiver, band by band.
fn told(requests: &[Request], receivers: usize, bands: usize) -> Vec<Vec<Told>> {
    let mut told: Vec<Vec<Told>> = (0..receivers).map(|_| Vec::new()).collect();
    let mut first = 0;
    for of_receiver in requests.chunk_by(|a, b| a.receiver == b.receiver) {
        let is_cell = |place: &usize| requests[*place].cell.is_some() && requests[*place].is_answered();
        let cells: Vec<usize> = (first..first + of_receiver.len()).filter(is_cell).collect();
        first += of_receiver.len();
        if !cells.is_empty() {
            told[of_receiver[0].receiver] = (0..bands).map(|band| of_band(requests, &cells, band)).collect();
        }
    }
    told
}

/// Returns the scale of cells in a band, and the cells that may change it. Where no cell found any
/// light, the scale is the brightest light.
fn of_band(requests: &[Request], cells: &[usize], band: usize) -> Told {
    let found: Vec<[f64; 2]> = cells.par_iter().map(|&cell| requests[cell].found(band)).collect();
    let values = cells.iter().zip(&found).map(|(&cell, &[value, _])| (value, requests[cell].seen.is_emitter));
    let Mean { value: mean, is_of_all } = Mean::of(values);
    if mean == 0.0 {
        return Told { scale: requests[cells[0]].brightest(), open: Vec::new() };
    }
    let counted =
        || cells.iter().zip(&found).filter(|(cell, _)| is_of_all || !requests[**cell].seen.is_emitter);
    // for a cell without any light found, the amount that was missed is unknown
    let lit = counted().filter(|(_, [value, _])| *value != 0.0);
    let squares: Vec<(usize, f64)> = lit.map(|(&cell, [_, error])| (cell, error * error)).collect();
    let sum: f64 = squares.iter().map(|(_, square)| square).sum();
    let scale = mean - BELOW * sum.sqrt() / counted().count() as f64;
    let average = sum / squares.len() as f64;
    let may_change = |&(cell, square): &(usize, f64)| {
        let cell = &requests[cell];
        square >= average && cell.computed.is_none() && cell.replicates.samples < MOST
    };
    let open = squares.into_iter().filter(|_| scale < SETTLED * mean).filter(may_change);
    Told { scale: scale.max(LEAST * mean), open: open.map(|(cell, _)| cell).collect() }
}
