//! Arithmetic of generated kernels.
//!
//! ```text
//! Formula: one generic body ─┬─ f32, f64 ───────────▶ a value
//!                            ├─ DoubleDouble, Wide ─▶ a value of 31 digits, of hundreds
//!                            ├─ Guarded<T> ─────────▶ a value and a bound of its error
//!                            └─ Lane<FMA> ──────────▶ batches over slices, vectorised, chosen at run time
//! ```
//! A kernel is written once, as a function of any [`Real`]; a precision is a type. The crate needs
//! only the standard library, so that it can be pasted next to a kernel.
//!
//! # Without the standard library
//!
//! ```toml
//! forms-math = { version = "0.1", default-features = false, features = ["libm"] }
//! ```
//! Without its default feature `std` the crate needs `core`, an allocator, and for the elementary
//! functions of `f32` and `f64` the crate [`libm`](https://docs.rs/libm). All types and functions are
//! the same, except for those of the feature `rayon`, which includes `std`. The differences:
//!
//! * The functions of `libm` and of the standard library round differently in the last place. Error
//!   bounds and promises hold for both.
//! * [`Instructions`] are those for which the program is compiled, since nothing detects others:
//!   `-C target-feature=+avx2,+fma` on x86-64.
//! * [`escalate()`] compiles a formula for each precision up to 16 384 bits instead of recording its
//!   steps once: the program is larger.

#![no_std]

extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

#[cfg(not(any(feature = "std", feature = "libm")))]
compile_error!(
    "`forms-math` needs a library of elementary functions: enable its feature `std` (the default), or its \
     feature `libm` for programs without the standard library"
);

mod batch;
mod composed;
mod double_double;
mod elementary;
mod error_free;
mod escalate;
mod float;
mod formula;
mod guarded;
mod hardware;
mod instructions;
mod lane;
mod number;
#[cfg(not(feature = "std"))]
mod once_lock;
mod quadrature;
mod real;
mod scalar;
mod source;
mod special;
mod table;
mod wide;

pub use batch::{
    Column, LengthMismatch, batch, batch_by, batch_f32, batch_f32_by, batch_within, batch_within_by,
    batch_without_escalation, bounds_in_lanes, row_within,
};
#[cfg(feature = "rayon")]
pub use batch::{batch_f32_parallel, batch_parallel, batch_within_parallel};
pub use double_double::DoubleDouble;
pub use escalate::{
    NotWithin, Tier, escalate, escalate_checked, escalate_computation, escalate_double_double,
    escalate_double_double_computation, escalate_f32, escalate_with_tier, without_escalation,
};
pub use formula::{Computation, Formula};
pub use guarded::{Bound, Guardable, Guarded, Magnitude, Units};
pub use instructions::Instructions;
pub use lane::{Lane32, Lane64};
pub use number::Number;
pub use real::Real;
pub use scalar::Scalar;
pub use source::{crate_files, source};
pub use wide::Wide;
