//! Sampling: hash keys become points of the unit square, and these become directions about an axis.
//!
//! The warps themselves are kernels of [`forms_kernels`]; this module provides their inputs, and the
//! frames that rotate their axis to the required direction.

mod choice;
mod draws;
mod frame;
mod sequence;
mod sobol;

pub(crate) use choice::{chosen, shares};
pub(crate) use draws::{Draws, SHARED};
pub(crate) use frame::Frame;
pub(crate) use sequence::{Net, Random, Samples, key};
