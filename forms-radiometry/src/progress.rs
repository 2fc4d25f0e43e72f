//! Progress: the stages of the work become the fraction of the whole that is done, which never
//! decreases, and the remaining time, where it can be predicted.
//!
//! ```text
//! a stage began after b seconds; its fraction f is done after t  ─▶ it ends after b + (t − b)/f
//! the whole ends after the later of that and the prediction      ─▶ times the stages that follow
//!                                                                ─▶ done: t/end, left: end − t
//! ```
//! So the fraction that is done is a fraction of the time, as far as the time is known: the time
//! that a tolerance takes shows only during the work. Where the end turns out to be later, the
//! fraction does not change for a while. The number of refinement rounds is known only at their
//! end, and until then no remaining time is reported. Otherwise it is reported where [`Forecast`]
//! trusts it.

mod forecast;
pub(crate) mod times;

use crate::answer::Moment;
use crate::watch::Watch;
use forecast::Forecast;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Instant;

/// End of the whole, relative to the end of its first stage, as long as nothing is known of the
/// other stages.
const UNKNOWN: f64 = 20.0;
/// End of the whole, relative to the end of the present round: each round takes about as long as
/// all rounds before it, and one more may follow.
const ONE_MORE: f64 = 2.0;
/// Power of time by which errors fall as long as fewer than two errors are known, and the smallest
/// and the largest power that is derived from two errors.
const USUAL_POWER: f64 = 1.0;
const POWERS: [f64; 2] = [0.25, 4.0];
/// Number of the last errors that determine that power.
const SEEN: usize = 3;

/// Reports to the caller how much of the whole is done.
pub(crate) struct Progress<'w> {
    watch: &'w dyn Watch,
    start: Instant,
    state: Mutex<State>,
}

/// Outlook on the work after the present stage.
#[derive(Clone, Copy)]
pub(crate) enum Outlook {
    /// Nothing is known.
    Unknown,
    /// Rounds like this one follow, until at least this many seconds of the work.
    Rounds { until: f64 },
    /// This many stages remain, including the present one, and they take about as long as it.
    Stages(usize),
    /// It is the last one, but may take longer than it seems.
    Doubtful,
}

struct State {
    /// Seconds that the work took before this run.
    before: f64,
    /// Fraction that was reported last.
    told: f64,
    begin: f64,
    outlook: Outlook,
    forecast: Forecast,
}

impl<'w> Progress<'w> {
    /// Returns the progress of work that begins now. It has a single stage until another one
    /// begins.
    pub(crate) fn new(watch: &'w dyn Watch) -> Self {
        let (outlook, forecast) = (Outlook::Stages(1), Forecast::default());
        let state = State { before: 0.0, told: 0.0, begin: 0.0, outlook, forecast };
        Self { watch, start: Instant::now(), state: Mutex::new(state) }
    }

    /// Adds the seconds that the work took before this run.
    pub(crate) fn resume(&self, before: f64) {
        self.state().before += before;
    }

    /// Begins a stage.
    pub(crate) fn begin(&self, outlook: Outlook) {
        let mut state = self.state();
        state.begin = self.seconds_with(state.before);
        state.outlook = outlook;
    }

    /// Updates the outlook on the work after the present stage.
    pub(crate) fn look(&self, outlook: Outlook) {
        self.state().outlook = outlook;
    }

    /// Returns the seconds of the work so far, including those before this run.
    pub(crate) fn seconds(&self) -> f64 {
        self.seconds_with(self.state().before)
    }

    fn seconds_with(&self, before: f64) -> f64 {
        before + self.start.elapsed().as_secs_f64()
    }

    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Watch for Progress<'_> {
    fn progress(&self, stage: &str, fraction: f64) {
        let mut state = self.state();
        let now = self.seconds_with(state.before);
        let (done, left) = state.note(now, fraction);
        // the lock is held, so that no other thread reports a larger fraction first
        self.watch.time_left(left);
        self.watch.progress(stage, done);
    }

    fn is_stopped(&self) -> bool {
        self.watch.is_stopped()
    }
}

impl State {
    /// Returns the fraction of the whole that is done at a time at which this fraction of the stage
    /// is done, and the remaining seconds, if they are known.
    fn note(&mut self, now: f64, fraction: f64) -> (f64, Option<f64>) {
        let of_stage = self.begin + (now - self.begin) / fraction.clamp(0.0, 1.0);
        let end = match self.outlook {
            Outlook::Unknown => UNKNOWN * of_stage,
            Outlook::Rounds { until } => ONE_MORE * of_stage.max(until),
            Outlook::Stages(count) => self.begin + count as f64 * (of_stage - self.begin),
            Outlook::Doubtful => of_stage,
        };
        let done = now / end;
        if done.is_finite() {
            self.told = self.told.max(done.clamp(0.0, 1.0));
        }
        let left = match self.outlook {
            Outlook::Stages(1) if end.is_finite() => self.forecast.note(now, end),
            _ => {
                self.forecast = Forecast::default();
                None
            }
        };
        (self.told, left)
    }
}

/// Predicts when errors will have fallen to a tolerance, from the history since `begin`: they fall
/// as a power of time. `None` as long as no error is known.
pub(crate) fn foreseen(history: &[Moment], begin: f64, tolerance: f64) -> Option<f64> {
    let known: Vec<&Moment> = history.iter().filter(|moment| moment.error.is_finite()).collect();
    let last = known.last()?;
    let first = known[known.len().saturating_sub(SEEN)];
    let slower = ((last.seconds - begin) / (first.seconds - begin)).ln();
    let power = (first.error / last.error).ln() / slower;
    let power = if slower > 0.0 { power.clamp(POWERS[0], POWERS[1]) } else { USUAL_POWER };
    let left = (last.error / tolerance).max(1.0);
    Some(begin + (last.seconds - begin) * left.powf(1.0 / power))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(outlook: Outlook) -> State {
        State { before: 0.0, told: 0.0, begin: 0.0, outlook, forecast: Forecast::default() }
    }

    #[test]
    fn what_is_done_is_a_part_of_the_time_and_never_less_than_before() {
        let mut state = state(Outlook::Unknown);
        assert_eq!(state.note(1.0, 0.5).0, 1.0 / 40.0);
        state.outlook = Outlook::Rounds { until: 10.0 };
        assert_eq!(state.note(2.0, 0.5).0, 2.0 / 20.0);
        // the round takes longer than predicted
        assert_eq!(state.note(4.0, 0.1).0, 2.0 / 20.0);
        (state.begin, state.outlook) = (10.0, Outlook::Stages(2));
        assert_eq!(state.note(12.0, 0.5).0, 12.0 / 18.0);
        for nothing in [0.0, -1.0, f64::NAN] {
            assert_eq!(state.note(13.0, nothing).0, 12.0 / 18.0, "{nothing}");
        }
        (state.begin, state.outlook) = (14.0, Outlook::Stages(1));
        assert_eq!(state.note(16.0, 1.0), (1.0, Some(0.0)));
        assert_eq!(state.note(17.0, 0.2).0, 1.0);
    }

    #[test]
    fn no_time_is_told_of_rounds_whose_number_is_not_known() {
        let mut state = state(Outlook::Rounds { until: 0.0 });
        let steady =
            |state: &mut State| (1..100).map(|i| state.note(f64::from(i), f64::from(i) / 200.0).1).last();
        assert_eq!(steady(&mut state), Some(None));
        state.outlook = Outlook::Doubtful;
        assert_eq!(steady(&mut state), Some(None));
        state.outlook = Outlook::Stages(1);
        assert_eq!(steady(&mut state), Some(Some(101.0)));
    }

    #[test]
    fn errors_that_fall_by_a_power_of_time_reach_the_tolerance_when_it_says() {
        let moment = |seconds: f64| Moment { seconds: seconds + 1.0, error: seconds.powi(-2) };
        let first = Moment { seconds: 1.1, error: f64::INFINITY };
        let history = [first, moment(1.0), moment(2.0), moment(4.0)];
        let end = foreseen(&history, 1.0, 1e-2).expect("errors are known");
        assert!((end - 11.0).abs() < 1e-9, "{end}");
        assert_eq!(foreseen(&history[..1], 1.0, 1e-2), None);
        // with a single error, the error is taken to fall as the inverse of time
        assert_eq!(foreseen(&history[..2], 1.0, 0.1), Some(11.0));
        // the tolerance is met
        assert_eq!(foreseen(&history, 1.0, 0.1), Some(5.0));
    }
}
