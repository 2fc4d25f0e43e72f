//! Definite integrals: values against numerical quadrature, boundaries against the interior, and
//! integrals that must be refused.

mod boundary;
mod pieces;
mod quadrature;
mod refusals;
mod unknown;
