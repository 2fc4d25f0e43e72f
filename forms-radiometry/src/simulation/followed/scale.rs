//! Scales: what the tolerance of cells and pixels is relative to, found in a pilot that every share of the work repeats.
//!
//! ```text
//! scale = mean over cells of value − 2σ of the mean          settled when it is 0.9 of the mean or more
//! ```
//! The mean is over the cells in which no emitter is seen directly, or over all where these are dark. A pilot gives every cell its first samples,
//! and more to those whose errors are above the average. As the scale is from below, errors within the tolerance of it are within that of the mean.

use super::super::scales::Mean;
use super::asked::Asked;
use rayon::prelude::*;

/// How many standard errors of the mean a scale is below it.
const BELOW: f64 = 2.0;
/// The part of the mean that a settled scale has.
const SETTLED: f64 = 0.9;
/// The least part of it that any scale has.
const LEAST: f64 = 0.5;
/// The most samples of a replicate in a pilot.
const MOST: u32 = 1 << 10;

/// For each receiver the scale of its cells in each band; nothing for those without.
pub(super) type Scales = Vec<Vec<f64>>;

/// What the cells of a receiver tell of their scale in a band.
struct Told {
    scale: f64,
    /// The cells that more samples are to decide it by.
    open: Vec<usize>,
}

/// The scales, or the questions that more samples are to decide them.
pub(super) fn settled(asked: &[Asked], receivers: usize, bands: usize) -> Result<Scales, Vec<usize>> {
    let told = told(asked, receivers, bands);
    let mut open: Vec<usize> = told.iter().flatten().flat_map(|told| told.open.iter().copied()).collect();
    open.sort_unstable();
    open.dedup();
    if open.is_empty() { Ok(scales(told)) } else { Err(open) }
}

/// The scales by what is known of all cells.
pub(super) fn known(asked: &[Asked], receivers: usize, bands: usize) -> Scales {
    scales(told(asked, receivers, bands))
}

fn scales(told: Vec<Vec<Told>>) -> Scales {
    told.into_iter().map(|bands| bands.into_iter().map(|told| told.scale).collect()).collect()
}

/// What the cells of each receiver tell, band by band.
fn told(asked: &[Asked], receivers: usize, bands: usize) -> Vec<Vec<Told>> {
    let mut told: Vec<Vec<Told>> = (0..receivers).map(|_| Vec::new()).collect();
    let mut first = 0;
    for of_receiver in asked.chunk_by(|a, b| a.receiver == b.receiver) {
        let is_cell = |place: &usize| asked[*place].cell.is_some() && asked[*place].is_answered();
        let cells: Vec<usize> = (first..first + of_receiver.len()).filter(is_cell).collect();
        first += of_receiver.len();
        if !cells.is_empty() {
            told[of_receiver[0].receiver] = (0..bands).map(|band| of_band(asked, &cells, band)).collect();
        }
    }
    told
}

/// The scale of cells in a band, and the cells that may change it. Where nothing is found in any, it is the brightest light.
fn of_band(asked: &[Asked], cells: &[usize], band: usize) -> Told {
    let found: Vec<[f64; 2]> = cells.par_iter().map(|&cell| asked[cell].found(band)).collect();
    let values = cells.iter().zip(&found).map(|(&cell, &[value, _])| (value, asked[cell].seen.is_emitter));
    let Mean { value: mean, is_of_all } = Mean::of(values);
    if mean == 0.0 {
        return Told { scale: asked[cells[0]].brightest(), open: Vec::new() };
    }
    let counted = || cells.iter().zip(&found).filter(|(cell, _)| is_of_all || !asked[**cell].seen.is_emitter);
    // of a cell in which nothing was found it is not known how much more there may be
    let lit = counted().filter(|(_, [value, _])| *value != 0.0);
    let squares: Vec<(usize, f64)> = lit.map(|(&cell, [_, error])| (cell, error * error)).collect();
    let sum: f64 = squares.iter().map(|(_, square)| square).sum();
    let scale = mean - BELOW * sum.sqrt() / counted().count() as f64;
    let average = sum / squares.len() as f64;
    let may_change = |&(cell, square): &(usize, f64)| {
        let cell = &asked[cell];
        square >= average && cell.computed.is_none() && cell.replicates.samples < MOST
    };
    let open = squares.into_iter().filter(|_| scale < SETTLED * mean).filter(may_change);
    Told { scale: scale.max(LEAST * mean), open: open.map(|(cell, _)| cell).collect() }
}
