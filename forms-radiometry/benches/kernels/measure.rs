//! Times of several functions in one run. The functions alternate, so that a disturbance of the
//! machine affects all of them.

use crate::catalogue::{Author, Entry};
use crate::inputs;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Number of values of a call.
pub(crate) const VALUES: usize = 1024;
/// Number of rounds; the median is reported.
const TURNS: usize = 101;
/// Least duration of a round.
const TURN: Duration = Duration::from_micros(100);

/// Returns the seconds per value of each function: the median over its rounds.
pub(crate) fn seconds_per_value(entry: &Entry) -> Vec<(Author, f64)> {
    let columns = inputs::columns(entry.domain, VALUES);
    let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
    let mut out = vec![0.0; VALUES];
    let mut call = |function: &crate::catalogue::Fill, calls: u32| {
        let start = Instant::now();
        for _ in 0..calls {
            function(black_box(&columns), black_box(&mut out));
        }
        start.elapsed()
    };
    let calls: Vec<u32> =
        entry.functions.iter().map(|(_, function)| enough(|calls| call(function, calls))).collect();
    let mut turns = vec![Vec::with_capacity(TURNS); entry.functions.len()];
    for _ in 0..TURNS {
        for (((_, function), &calls), turns) in entry.functions.iter().zip(&calls).zip(&mut turns) {
            turns.push(call(function, calls).as_secs_f64() / (f64::from(calls) * VALUES as f64));
        }
    }
    let medians = turns.into_iter().map(|mut turns| {
        turns.sort_by(f64::total_cmp);
        turns[TURNS / 2]
    });
    entry.functions.iter().map(|(author, _)| *author).zip(medians).collect()
}

/// Returns the number of calls that fill a round.
fn enough(mut time: impl FnMut(u32) -> Duration) -> u32 {
    let mut calls = 1;
    while time(calls) < TURN && calls < 1 << 20 {
        calls *= 2;
    }
    calls
}
