//! Answers: results with their errors, and what these promise.
//!
//! ```text
//! error budget ─▶ results ─┬─ accuracy: errors relative to scales, missed tolerances
//!                          ├─ units: from working units to the units of quantities
//!                          ├─ net flux: power that faces absorb, less the power that they emit
//!                          └─ exposure: power times the duration of an exposure
//! ```

mod accuracy;
mod cells;
mod error_budget;
mod error_kind;
mod exposure;
mod net_flux;
mod quantity;
mod results;
mod units;

pub use accuracy::{Accuracy, MissedCells, Rated};
pub(crate) use accuracy::{DARK, relative};
pub(crate) use cells::mean_of_cells;
pub use error_budget::ErrorParts;
pub use error_kind::ErrorKind;
pub use exposure::{Exposure, NoTime};
pub(crate) use net_flux::NetFlux;
pub use quantity::Quantity;
pub use results::{Answer, Layout, Map, Moment, Simulation};
