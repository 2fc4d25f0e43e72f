//! The metric operations on random metrics: against a slow definition, by their laws, and on mutants of both; what is
//! said about mistakes; integrals and potentials that have to be refused.

mod adjoint;
mod laws;
mod mistakes;
mod random;
mod refusals;
mod star;
mod theory;
