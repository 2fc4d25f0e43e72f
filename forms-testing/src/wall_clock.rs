//! Wall-clock time of a run, with all threads that it starts.

use std::time::{Duration, Instant};

/// Number of rounds; the median is reported.
const TURNS: usize = 11;
/// Least duration of a round: far above the resolution of the clock.
const TURN: Duration = Duration::from_millis(5);

/// Returns the seconds of one run: the median over rounds.
pub fn seconds<T>(mut run: impl FnMut() -> T) -> f64 {
    let mut time = |runs: u32| {
        let start = Instant::now();
        (0..runs).for_each(|_| drop(std::hint::black_box(run())));
        start.elapsed()
    };
    let mut runs = 1;
    while time(runs) < TURN && runs < 1 << 20 {
        runs *= 2;
    }
    let mut turns: Vec<f64> = (0..TURNS).map(|_| time(runs).as_secs_f64() / f64::from(runs)).collect();
    turns.sort_by(f64::total_cmp);
    turns[TURNS / 2]
}
