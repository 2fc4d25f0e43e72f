//! Metric operations on random metrics: against a slow definition, by their laws, and on mutants of
//! both; messages about errors.

mod adjoint;
mod laws;
mod mistakes;
mod random;
mod star;
mod theory;
