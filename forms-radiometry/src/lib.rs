//! Radiometry on proved kernels.
