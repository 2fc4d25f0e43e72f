//! Answers: results with their errors, and what these promise.
//!
//! ```text
//! error budget ─▶ results ─┬─ accuracy: errors relative to scales, missed tolerances
//!                          ├─ units: from working units to the units of quantities
//!                          └─ exposure: power times the duration of an exposure
//! ```

mod accuracy;
mod error_budget;
mod error_kind;
mod exposure;
mod quantity;
mod results;
mod units;

pub use accuracy::{Accuracy, MissedCells, Rated};
pub(crate) use accuracy::{DARK, relative};
pub use error_budget::ErrorParts;
pub use error_kind::ErrorKind;
pub use exposure::{Exposure, NoTime};
pub use quantity::Quantity;
pub use results::{Answer, Map, Moment, Simulation};
