//! Simulation: a scene becomes a plan of the effects that it needs, and the plan becomes answers
//! with their errors.
//!
//! ```text
//! scene ─▶ plan (which effects, why, what dropping them can change)
//!       ─▶ answers and maps, refined until they are exact enough
//! ```
//! A watcher is notified of progress and can stop the computation; the results obtained by then are
//! returned.

mod accuracy;
mod answer;
mod arithmetic;
mod digits;
mod divided;
mod effects;
mod estimate;
mod exposure;
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
mod parts;
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
mod units;

pub use crate::radiosity::UsedKernel;
pub use crate::watch::{Unwatched, Watch};
pub use accuracy::{Accuracy, MissedCells, Rated};
pub use answer::{Answer, ErrorKind, Map, Moment, Plan, PlannedEffect, Quantity, Simulation};
pub use arithmetic::Arithmetic;
pub use divided::{is_by_paths, merge, simulate, simulate_job};
pub use exposure::{Exposure, NoTime};
pub use file::{Identity, NoState, StateFile};
pub use job::{Budget, Job, Keeper, NoBudget, NoShare, Share};
pub use method::{Method, methods};
pub use parts::ErrorParts;
pub use planning::plan;
pub use state::{Misfit, Snapshot, State};
