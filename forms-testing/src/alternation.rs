//! Times of several functions in one run. The functions alternate, so that a disturbance of the
//! machine affects all of them.

use std::time::{Duration, Instant};

/// Number of rounds; the median is reported.
const ROUNDS: usize = 101;
/// Least duration of a round.
const ROUND: Duration = Duration::from_micros(100);

/// Returns the seconds per call of each function: the median over its rounds.
///
/// ```
/// let roots = [1.5_f64, 2.5].map(|x| move || { std::hint::black_box(x.sqrt()); });
/// let seconds = forms_testing::alternation::seconds_per_call(roots);
/// assert!(seconds.len() == 2 && seconds[0] > 0.0);
/// ```
pub fn seconds_per_call<F: FnMut()>(functions: impl IntoIterator<Item = F>) -> Vec<f64> {
    let mut functions: Vec<F> = functions.into_iter().collect();
    let calls: Vec<u32> = functions.iter_mut().map(calls_of_a_round).collect();
    let mut rounds = vec![Vec::with_capacity(ROUNDS); functions.len()];
    for _ in 0..ROUNDS {
        for ((function, &calls), rounds) in functions.iter_mut().zip(&calls).zip(&mut rounds) {
            rounds.push(time(function, calls).as_secs_f64() / f64::from(calls));
        }
    }
    let medians = rounds.into_iter().map(|mut rounds| {
        rounds.sort_by(f64::total_cmp);
        rounds[ROUNDS / 2]
    });
    medians.collect()
}

fn time(function: &mut impl FnMut(), calls: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..calls {
        function();
    }
    start.elapsed()
}

/// Returns the number of calls that fill a round.
fn calls_of_a_round(function: &mut impl FnMut()) -> u32 {
    let mut calls = 1;
    while time(function, calls) < ROUND && calls < 1 << 20 {
        calls *= 2;
    }
    calls
}
