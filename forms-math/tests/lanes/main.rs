//! Lanes: accuracy of their functions, special values, and batches of formulas.

mod arguments;
mod double;
mod formulas;
mod single;
