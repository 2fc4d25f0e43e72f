//! Sampling: keys become points of the unit square, and these directions about an axis.
//!
//! Warps themselves are kernels ([`kernels`](crate::kernels)); here is what they are given, and what turns their axis to where it is wanted.

mod choice;
mod draws;
mod frame;
mod sequence;
mod sobol;

pub(crate) use choice::chosen;
pub(crate) use draws::{Draws, SHARED};
pub(crate) use frame::Frame;
pub(crate) use sequence::{Net, Random, Samples, key};
