//! Accuracy: what a program computes beside what it should.
//!
//! ```text
//! kernel ─┬─ domain ─ regime ─▶ points, of typical and of hard kinds ─┐
//!         ├─ truth ──▶ values, correctly rounded ─────────────────────┴─ score ─▶ bits and ulps lost
//!         └─ programs ─▶ values in f32, f64, double-double ───────────┘
//! ```
//! Truth is found by enclosures of rising precision: it is a number only where its rounding is certain. Points are
//! drawn from a fixed seed, so that equal kernels have equal scores on every machine.

mod format;
mod truth;

pub use format::{Format, Rounded};
pub use truth::{Truth, Value};
