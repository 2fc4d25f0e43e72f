//! Lower and upper bounds on the number of terms of a power, known before it is multiplied out.
//!
//! Let F have d + 1 terms whose exponents m₀, …, m_d are affinely independent. The monomials of
//! (c₀m₀ + … + c_d m_d)ⁿ are the sums Σ kᵢmᵢ with Σ kᵢ = n; they are all different, and there are
//! C(n + d, d) of them. They all occur in Fⁿ if F has no other terms, or if all coefficients of F
//! have one sign, so that nothing cancels.

use super::Polynomial;

impl Polynomial {
    /// Returns a lower bound on the number of terms of a·fⁿ; 1 if none is known.
    pub(crate) fn least_terms_with_power(&self, f: &Self, n: u64) -> u64 {
        let independent = f.independent_terms();
        let nothing_cancels = self.has_one_sign() && f.has_one_sign();
        let known = nothing_cancels || (self.term_count() == 1 && independent == f.term_count());
        if known { binomial(n, independent.saturating_sub(1) as u64) } else { 1 }
    }

    /// Returns an upper bound on the number of terms of a·fⁿ: the number of products of terms.
    pub(crate) fn most_terms_with_power(&self, f: &Self, n: u64) -> u64 {
        let power = (f.term_count() as u64).saturating_pow(u32::try_from(n).unwrap_or(u32::MAX));
        power.saturating_mul(self.term_count() as u64)
    }

    /// Whether all coefficients are positive or all are negative.
    fn has_one_sign(&self) -> bool {
        (1..self.term_count()).all(|term| self.coefficients.is_negative(term) == self.is_negative())
    }

    /// Returns the number of terms, starting from the least one, that contain a variable that no
    /// earlier term contains: the exponents of each such term are affinely independent of the
    /// earlier ones.
    fn independent_terms(&self) -> usize {
        let mut seen = vec![0; self.layout.fields()];
        let mut independent = 0;
        for term in (0..self.term_count()).rev() {
            let variables = self.layout.unpack(self.monomial(term));
            if independent == 0 || variables.iter().any(|&(variable, _)| seen[variable as usize] == 0) {
                independent += 1;
                variables.iter().for_each(|&(variable, _)| seen[variable as usize] = 1);
            }
        }
        independent
    }
}

/// Returns C(n + d, d), or `u64::MAX` if it is larger.
fn binomial(n: u64, d: u64) -> u64 {
    let mut value: u128 = 1;
    for k in 1..=u128::from(d) {
        // C(n + k, k) = C(n + k − 1, k − 1) (n + k)/k
        match value.checked_mul(u128::from(n) + k) {
            Some(product) => value = product / k,
            None => return u64::MAX,
        }
    }
    u64::try_from(value).unwrap_or(u64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn variable(index: u32) -> Polynomial {
        Polynomial::variable(index)
    }

    /// Returns the number of terms of a·fⁿ, multiplied out, and the bound.
    fn terms_and_bound(a: &Polynomial, f: &Polynomial, n: u32) -> (u64, u64) {
        (a.mul(&f.pow(n)).term_count() as u64, a.least_terms_with_power(f, n.into()))
    }

    #[test]
    fn a_power_of_a_simplex_has_the_terms_of_the_bound() {
        let simplex = (0..5).fold(Polynomial::integer(-1), |sum, index| sum.add(&variable(index)));
        for n in 0..7 {
            let (terms, bound) = terms_and_bound(&variable(7), &simplex, n);
            assert_eq!(terms, bound, "n = {n}");
        }
    }

    #[test]
    fn where_nothing_cancels_the_bound_holds() {
        let [x, y, z] = [0, 1, 2].map(variable);
        let square = x.add(&y).add(&Polynomial::one()).square();
        let wide = x.square().mul(&y).add(&y.mul(&z).mul(&x)).add(&z.pow(3)).add(&z);
        for f in [square, wide] {
            for n in 0..7 {
                let (terms, bound) = terms_and_bound(&x.add(&z), &f, n);
                assert!(bound <= terms && (bound > 1 || n == 0), "n = {n}: {terms} terms, bound {bound}");
                assert!(terms <= x.add(&z).most_terms_with_power(&f, n.into()), "n = {n}: {terms} terms");
            }
        }
    }

    #[test]
    fn where_terms_may_cancel_nothing_is_claimed() {
        let [x, y] = [0, 1].map(variable);
        let one = Polynomial::one();
        // (x − y)³(x + y)³ = (x² − y²)³
        assert_eq!(terms_and_bound(&x.sub(&y).pow(3), &x.add(&y), 3), (4, 1));
        // (x² + 2x − 2)² = x⁴ + 4x³ − 8x + 4
        let f = x.square().add(&x.scale_small(2)).sub(&one.scale_small(2));
        assert_eq!(terms_and_bound(&one, &f, 2), (4, 1));
    }

    #[test]
    fn a_bound_beyond_every_number_is_the_greatest() {
        let many = (0..40).fold(Polynomial::one(), |sum, index| sum.add(&variable(index)));
        assert_eq!(Polynomial::one().least_terms_with_power(&many, u64::MAX), u64::MAX);
    }
}
