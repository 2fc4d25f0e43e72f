//! Polynomials with integer coefficients.
