//! Jobs: the part of a simulation that is run, and the checkpoint from which it continues.

use super::state::State;
use crate::checkpoint::Keeper;
use crate::job::{Budget, Share};

/// Part of a simulation to run.
pub struct Job<'k> {
    /// Number of samples; as many as the tolerance requires if `None`. Scenes that are solved as a
    /// whole have no samples.
    pub budget: Option<Budget>,
    /// Shard that is run.
    pub share: Share,
    /// Checkpoint from which the work continues; it starts from the beginning if `None`.
    pub state: Option<State>,
    /// Keeper of the checkpoints.
    pub keeper: Option<&'k dyn Keeper>,
}

impl Default for Job<'_> {
    fn default() -> Self {
        Self { budget: None, share: Share::WHOLE, state: None, keeper: None }
    }
}
