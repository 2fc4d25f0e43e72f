//! Batches on all processors: the rows are divided into shares of several blocks.

use alloc::vec::Vec;

use super::method::BLOCK;
use super::method::Element;
use rayon::prelude::*;

/// Number of rows of a share: large enough that the cost of distributing it is negligible.
const SHARE: usize = 16 * BLOCK;

/// Runs `batch` over shares of the rows.
pub(super) fn over_shares<E: Element, const A: usize, const O: usize>(
    columns: [&[E]; A],
    outputs: [&mut [E]; O],
    length: usize,
    batch: &(impl Fn([&[E]; A], [&mut [E]; O]) + Sync),
) {
    let mut rest = outputs;
    let shares: Vec<_> = (0..length)
        .step_by(SHARE)
        .map(|start| {
            let end = length.min(start + SHARE);
            let outputs =
                rest.each_mut().map(|output| output.split_off_mut(..end - start).unwrap_or_default());
            (columns.map(|column| &column[start..end]), outputs)
        })
        .collect();
    shares.into_par_iter().for_each(|(columns, outputs)| batch(columns, outputs));
}
