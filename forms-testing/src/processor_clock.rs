//! Time measurement: the processor time of this thread if the system reports it, so that other
//! programs on the machine have little effect, and otherwise the wall-clock time.

use std::time::{Duration, Instant};

/// Number of batches, of which the median is taken.
const BATCHES: usize = 5;
/// Minimum duration of a batch, far above the resolution of the clock.
const BATCH: Duration = Duration::from_millis(20);

/// Running clock.
enum Clock {
    Processor(Duration),
    Wall(Instant),
}

/// Returns the run time of this thread. The system updates it when the thread yields.
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

/// Returns the seconds of one run, as the median over batches.
pub fn seconds(run: &mut dyn FnMut()) -> f64 {
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
