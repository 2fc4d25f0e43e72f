//! Parts that the benches of scenes share: command lines, scripts of other programs, runs, and
//! cells of tables.

pub mod cells;
pub mod options;
pub mod scripts;
pub mod simulated;
