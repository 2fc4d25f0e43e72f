//! Lanes: accuracy of their functions, special values, and batches of formulas.

mod arguments;
mod batches;
mod double;
mod formulas;
mod single;
mod special_values;
mod within;
