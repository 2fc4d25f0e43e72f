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
mod digits;
mod divided;
mod effects;
mod estimate;
mod file;
mod followed;
mod forecast;
mod goals;
mod images;
mod interpolation;
mod job;
mod left_out;
mod map;
mod maps;
mod method;
mod obstacles;
mod planning;
mod prepared;
mod progress;
mod readings;
mod sampled;
mod scales;
mod shapes;
mod solver;
mod state;
mod surroundings;
mod survey;
#[cfg(test)]
mod tests;
mod times;

pub use crate::answer::{
    Accuracy, Answer, ErrorKind, ErrorParts, Exposure, Map, MissedCells, Moment, NoTime, Quantity, Rated,
    Simulation,
};
pub use crate::plan::{Plan, PlannedEffect};
pub use crate::used_kernel::UsedKernel;
pub use crate::watch::{Unwatched, Watch};
pub use arithmetic::Arithmetic;
pub use divided::{is_by_paths, merge, simulate, simulate_job};
pub use file::{Identity, NoState, StateFile};
pub use job::{Budget, Job, Keeper, NoBudget, NoShare, Share};
pub use method::{Method, methods};
pub use planning::plan;
pub use state::{Misfit, Snapshot, State};
