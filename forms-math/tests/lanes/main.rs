//! Lanes: accuracy of their functions, special values, and batches of formulas.

mod formulas;
mod single;
