//! Definite integrals: values against numerical quadrature, boundaries against the inside, and integrals that have to be
//! refused.

mod boundary;
mod pieces;
mod quadrature;
mod refusals;
mod unknown;
