//! Accuracy: the values a program computes, compared with the true values.
//!
//! ```text
//! kernel ─┬─ edges, regime ─▶ arguments, typical and hard ─┐
//!         ├─ truth ──▶ values, correctly rounded ──────────┴─ sample ─┐
//!         └─ programs ─▶ values in f32, f64, double-double ───────────┴─ score ─▶ bits and ulps lost
//! ```
//! True values are found by enclosures of rising precision: a true value is a number only where its
//! rounding is certain. Arguments are drawn from a fixed seed, so that equal kernels have equal
//! scores on every machine.

mod arguments;
mod edges;
mod format;
mod ordinal;
mod regime;
mod removable;
mod sample;
mod score;
mod sheet;
mod truth;

pub use edges::ranges;
pub use format::{Format, Rounded};
pub use ordinal::Width;
pub use regime::Regime;
pub use removable::removable_singularities;
pub(crate) use sample::sample_at;
pub use sample::{Sample, Samples, sample};
pub(crate) use score::bits_lost;
pub use score::{Score, Statistics};
pub use sheet::{Arithmetic, Line, Variant, sheet};
pub use truth::{Truth, Value};
