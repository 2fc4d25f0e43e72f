//! Observers of a simulation.

/// Observer that receives the progress of the work, and decides whether it continues. Called from
/// several threads.
pub trait Watch: Sync {
    /// Receives the present stage, and the fraction of the whole work that is done, which is never
    /// less than before.
    fn progress(&self, stage: &str, fraction: f64);

    /// Receives the remaining seconds, where they can be predicted; called before each
    /// [`progress`](Watch::progress).
    fn time_left(&self, _seconds: Option<f64>) {}

    /// Whether to stop and return the results so far. Once it is true it stays true.
    fn is_stopped(&self) -> bool;
}

/// Observer that ignores progress and never stops the work.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _stage: &str, _fraction: f64) {}

    fn is_stopped(&self) -> bool {
        false
    }
}
