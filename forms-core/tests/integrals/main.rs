//! Definite integrals: values against numerical quadrature, and integrals that have to be refused.

mod quadrature;
mod refusals;
mod unknown;
