//! Kernels: their costs, and the agreement of all ways of computing them.

mod conformance;
mod counts;
mod device;
mod emitted;
mod formula;
mod names;
mod promises;
mod targets;
mod translation;
mod values;
