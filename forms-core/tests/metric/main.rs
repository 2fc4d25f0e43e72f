//! The metric operations on random metrics: against a slow definition, by their laws, and on mutants of both; what is
//! said about mistakes.

mod adjoint;
mod laws;
mod mistakes;
mod random;
mod star;
mod theory;
