//! Radiometry on proved kernels.

pub mod geometry;
pub mod kernels;
