//! Simulation: a scene becomes a plan of the effects that it needs, and the plan becomes answers
//! with their errors.
//!
//! ```text
//! scene ─▶ plan (which effects, why, what dropping them can change)
//!       ─▶ answers and maps, refined until they are exact enough
//! ```
//! A watcher is notified of progress and can stop the computation; the results obtained by then are
//! returned.

mod arithmetic;
mod checkpoint_file;
mod job;
mod run;
mod state;
#[cfg(test)]
mod tests;

pub use crate::answer::{
    Accuracy, Answer, ErrorKind, ErrorParts, Exposure, Layout, Map, MissedCells, Moment, NoTime, Quantity,
    Rated, Simulation,
};
pub use crate::checkpoint::{Keeper, Misfit, Snapshot};
pub use crate::effects::PlannedEffect;
pub use crate::job::{Budget, NoBudget, NoShare, Share};
pub use crate::plan::Plan;
pub use crate::plan::decision::plan;
pub use crate::plan::method::{Method, ReceiverMethod};
pub use crate::used_kernel::UsedKernel;
pub use crate::watch::{Unwatched, Watch};
pub use arithmetic::Arithmetic;
pub use checkpoint_file::{Identity, NoState, StateFile};
pub use job::Job;
pub use run::{merge, simulate, simulate_job};
pub use state::State;
