//! Counted instructions of a simulation, by effect and by kernel.

pub mod callgrind;
pub mod parts;
