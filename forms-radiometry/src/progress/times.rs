//! Times: the time of the work is attributed to receivers; the remainder is the time of the
//! solution that all of them share.
//!
//! ```text
//! time of a receiver += its time in a loop × time of the loop / Σ of all times in it
//! shared              = time of the work − Σ times of receivers
//! ```
//! Threads that process receivers at the same time divide the elapsed time, including the time that
//! they wait for each other. All times therefore add up to the time of the work.

use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// Seconds that each receiver took so far.
pub(crate) struct Times(Mutex<Vec<f64>>);

impl Times {
    pub(crate) fn new(receivers: usize) -> Self {
        Self(Mutex::new(vec![0.0; receivers]))
    }

    /// Returns the seconds of a receiver.
    pub(crate) fn of(&self, receiver: usize) -> f64 {
        self.lock()[receiver]
    }

    /// Returns the seconds of each receiver.
    pub(crate) fn all(&self) -> Vec<f64> {
        self.lock().clone()
    }

    /// Adds a loop that began at this time and has just ended: its receivers, each with its
    /// seconds.
    pub(crate) fn add(&self, begin: Instant, parts: impl Iterator<Item = (usize, f64)> + Clone) {
        let scale = scale(begin, parts.clone().map(|(_, seconds)| seconds).sum());
        let mut times = self.lock();
        parts.for_each(|(receiver, seconds)| times[receiver] += scale * seconds);
    }

    /// Adds the time that a receiver alone took since this time.
    pub(crate) fn add_since(&self, begin: Instant, receiver: usize) {
        self.add(begin, std::iter::once((receiver, begin.elapsed().as_secs_f64())));
    }

    /// Joins two tasks that began at this time, when receivers had the times `before`, and have
    /// just ended, each after its `seconds`. If they ran at the same time, the times that they
    /// added to receivers are scaled to the elapsed time.
    pub(crate) fn rejoin(&self, begin: Instant, before: &[f64], seconds: [f64; 2]) {
        let scale = scale(begin, seconds.iter().sum());
        self.lock()
            .iter_mut()
            .zip(before)
            .for_each(|(time, before)| *time = before + scale * (*time - before));
    }

    fn lock(&self) -> MutexGuard<'_, Vec<f64>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Returns the factor that scales parts of a work to parts of the elapsed time. The work began at
/// this time, and all its parts took this many seconds.
pub(crate) fn scale(begin: Instant, seconds: f64) -> f64 {
    let passed = begin.elapsed().as_secs_f64();
    if seconds > 0.0 { passed / seconds } else { 0.0 }
}

/// Returns the result of some work, and its seconds.
pub(crate) fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let begin = Instant::now();
    let found = work();
    (found, begin.elapsed().as_secs_f64())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::Duration;

    #[test]
    fn receivers_at_the_same_time_divide_it() {
        let times = Times::new(3);
        let begin = Instant::now().checked_sub(Duration::from_secs(4)).expect("a time");
        // alone, on a thread that was waited for
        times.add(begin, [(0, 1.0)].into_iter());
        assert!((times.of(0) - 4.0).abs() < 0.1, "{}", times.of(0));
        // two threads, all the time
        times.add(begin, [(1, 2.0), (2, 4.0), (1, 2.0)].into_iter());
        let [_, one, two] = times.all()[..] else { panic!("three receivers") };
        assert!((one - two).abs() < 1e-9 && (one + two - 4.0).abs() < 0.1, "{one} {two}");
        // a solution of 4 s next to a map of 4 s, in 4 s
        let before = times.all();
        times.add(begin, [(0, 4.0)].into_iter());
        times.rejoin(begin, &before, [4.0, 4.0]);
        assert!((times.of(0) - before[0] - 2.0).abs() < 0.1, "{}", times.of(0));
        assert_eq!(times.of(1), before[1]);
    }
}
