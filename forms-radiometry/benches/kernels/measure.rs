//! Times of the functions of a kernel in one run.

use crate::catalogue::{Author, Entry};
use crate::inputs;
use forms_testing::alternation::seconds_per_call;
use std::hint::black_box;

/// Number of values of a call.
pub(crate) const VALUES: usize = 1024;

/// Returns the seconds per value of each function.
pub(crate) fn seconds_per_value(entry: &Entry) -> Vec<(Author, f64)> {
    let columns = inputs::columns(entry.domain, VALUES);
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let calls = entry.functions.iter().map(|(_, function)| {
        let (columns, mut out) = (&columns, vec![0.0; VALUES]);
        move || function(black_box(columns), black_box(&mut out))
    });
    let seconds = seconds_per_call(calls);
    entry
        .functions
        .iter()
        .zip(seconds)
        .map(|((author, _), seconds)| (*author, seconds / VALUES as f64))
        .collect()
}
