//! Kernels: their costs, and the agreement of all ways of computing them.

mod arrays;
mod conformance;
mod counts;
mod device;
mod emitted;
mod extrema;
mod formula;
mod names;
mod promises;
mod shader;
mod shader_functions;
mod target_forms;
mod targets;
mod translation;
mod values;
