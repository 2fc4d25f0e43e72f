//! Coprime bases: pairwise coprime square-free polynomials over which all given polynomials factor.

use super::Polynomial;
use num_bigint::BigInt;

/// Returns pairwise coprime, square-free, primitive polynomials with positive leading coefficients
/// such that every input is a constant times a product of their powers. Zeros and constants
/// contribute nothing.
///
/// If an intermediate [`Polynomial::gcd`] is not the greatest common divisor, some of them may
/// share factors or contain squares; the inputs are still products of their powers.
pub fn coprime_basis(polynomials: &[Polynomial]) -> Vec<Polynomial> {
    let mut basis = Vec::new();
    for polynomial in polynomials {
        for (factor, _) in polynomial.square_free().1 {
            refine(&mut basis, factor);
        }
    }
    basis
}

/// Adds a square-free polynomial f: g = gcd(f, bᵢ) splits bᵢ into g and bᵢ/g, and f/g is refined
/// further.
fn refine(basis: &mut Vec<Polynomial>, polynomial: Polynomial) {
    let mut rest = polynomial;
    let mut index = 0;
    while index < basis.len() && !rest.is_constant() {
        let common = rest.gcd(&basis[index]);
        if !common.is_constant() {
            let cofactor = basis[index].divide_exact(&common).expect("a gcd divides");
            rest = rest.divide_exact(&common).expect("a gcd divides");
            basis[index] = common;
            if !cofactor.is_constant() {
                index += 1;
                basis.insert(index, cofactor);
            }
        }
        index += 1;
    }
    if !rest.is_constant() {
        basis.push(rest);
    }
}

impl Polynomial {
    /// Factors f = c ∏ bᵢ^eᵢ over a basis: returns the constant and the exponents if f has such a
    /// factorisation; 0 has none.
    pub fn factor_over(&self, basis: &[Polynomial]) -> Option<(BigInt, Vec<u32>)> {
        if self.is_zero() {
            return None;
        }
        let mut rest = self.clone();
        let mut exponents = Vec::with_capacity(basis.len());
        for factor in basis {
            let mut exponent = 0;
            while !factor.is_constant()
                && let Some(quotient) = rest.divide_exact(factor)
            {
                rest = quotient;
                exponent += 1;
            }
            exponents.push(exponent);
        }
        Some((rest.as_constant()?, exponents))
    }
}
