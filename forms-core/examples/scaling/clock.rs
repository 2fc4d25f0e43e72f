//! How long something takes: the processor time of this thread where the system tells it, so that other programs on the
//! machine disturb little, and the time on the wall elsewhere.

use std::time::{Duration, Instant};

/// Batches of which the median is taken.
const BATCHES: usize = 5;
/// The least time of a batch: far above the resolution of the clock.
const BATCH: Duration = Duration::from_millis(20);

/// A clock, started.
enum Clock {
    Processor(Duration),
    Wall(Instant),
}

/// The time for which this thread has run. The system brings it up to date when the thread yields.
fn processor_time() -> Option<Duration> {
    std::thread::yield_now();
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(Duration::from_nanos(text.split(' ').next()?.parse().ok()?))
}

impl Clock {
    fn start() -> Self {
        processor_time().map_or_else(|| Clock::Wall(Instant::now()), Clock::Processor)
    }

    fn elapsed(&self) -> Duration {
        match self {
            Clock::Processor(start) => processor_time().unwrap_or(*start).saturating_sub(*start),
            Clock::Wall(start) => start.elapsed(),
        }
    }
}

/// The seconds of one run, the median over batches.
pub(crate) fn seconds(run: &mut dyn FnMut()) -> f64 {
    run();
    let runs = runs_in_a_batch(run);
    let mut batches: Vec<f64> = (0..BATCHES)
        .map(|_| {
            let clock = Clock::start();
            (0..runs).for_each(|_| run());
            clock.elapsed().as_secs_f64() / f64::from(runs)
        })
        .collect();
    batches.sort_by(f64::total_cmp);
    batches[BATCHES / 2]
}

fn runs_in_a_batch(run: &mut dyn FnMut()) -> u32 {
    let mut runs = 1;
    loop {
        let clock = Clock::start();
        (0..runs).for_each(|_| run());
        if clock.elapsed() >= BATCH || runs >= 1 << 20 {
            return runs;
        }
        runs *= 2;
    }
}
