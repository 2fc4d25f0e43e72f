//! Who watches a simulation.

/// Is told how far the work is, and says whether to go on. Called from several threads.
pub trait Watch: Sync {
    /// What is being done, and which fraction of the whole work is done, which is never less than before.
    fn progress(&self, stage: &str, fraction: f64);

    /// The seconds that are left, where that can be foreseen; called before each [`progress`](Watch::progress).
    fn time_left(&self, _seconds: Option<f64>) {}

    /// Whether to stop, with what there is by then. Once it says so it does not change its mind.
    fn is_stopped(&self) -> bool;
}

/// Nobody watches, and nothing is stopped.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _stage: &str, _fraction: f64) {}

    fn is_stopped(&self) -> bool {
        false
    }
}
