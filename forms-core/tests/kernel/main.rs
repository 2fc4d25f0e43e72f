//! Kernels: what they cost, and that every way of computing them gives the same value.

mod counts;
mod device;
mod emitted;
mod formula;
mod names;
mod promises;
mod targets;
mod translation;
mod values;
