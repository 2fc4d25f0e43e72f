//! Products: Σ sₖ aₖ bₖ into one accumulator.

use super::Polynomial;
use super::coefficient::{Coefficient, Norms, Rung, on_rung};
use super::monomial::Layout;

impl Polynomial {
    /// f·g
    ///
    /// # Panics
    /// If an exponent of the product is beyond 2³¹ − 1.
    pub fn mul(&self, other: &Self) -> Self {
        Self::sum_of_products(&[(1, self, other)])
    }

    /// f²
    ///
    /// # Panics
    /// If an exponent of the square is beyond 2³¹ − 1.
    pub fn square(&self) -> Self {
        self.mul(self)
    }

    /// fⁿ by repeated squaring, with f⁰ = 1.
    ///
    /// # Panics
    /// If an exponent of the power is beyond 2³¹ − 1.
    pub fn pow(&self, n: u32) -> Self {
        if n == 0 {
            return Self::one();
        }
        let mut result = self.clone();
        for bit in (0..n.ilog2()).rev() {
            result = result.square();
            if n >> bit & 1 == 1 {
                result = result.mul(self);
            }
        }
        result
    }

    /// A bound of the number of terms of f·g: the lesser of the number of pairs of terms and the size of the
    /// box of exponents ∏ (1 + degᵢ f + degᵢ g).
    pub fn product_size_bound(&self, other: &Self) -> usize {
        let pairs = self.term_count().saturating_mul(other.term_count());
        let (left, right) = (self.degrees(), other.degrees());
        let mut size = 1usize;
        for variable in 0..self.layout.fields().max(other.layout.fields()) {
            let degree = |degrees: &[u32]| degrees.get(variable).map_or(0, |&degree| degree as usize);
            size = size.saturating_mul(1 + degree(&left) + degree(&right));
        }
        pairs.min(size)
    }

    /// Σ sₖ aₖ bₖ, collected in one accumulator.
    ///
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub fn sum_of_products(terms: &[(i64, &Polynomial, &Polynomial)]) -> Self {
        let layout = product_layout(terms);
        on_rung!(product_rung(terms), C => accumulate::<C>(layout, terms))
    }

    /// Whether Σ sₖ aₖ bₖ = 0.
    ///
    /// # Panics
    /// If an exponent of a product is beyond 2³¹ − 1.
    pub fn sum_of_products_is_zero(terms: &[(i64, &Polynomial, &Polynomial)]) -> bool {
        Self::sum_of_products(terms).is_zero()
    }
}

/// The narrowest layout on which no product of the sum carries from one field into the next.
fn product_layout(terms: &[(i64, &Polynomial, &Polynomial)]) -> Layout {
    let mut layout = Layout::CONSTANT;
    for (_, a, b) in terms {
        let (left, right) = (a.degrees(), b.degrees());
        for (variable, degree) in left.iter().enumerate() {
            let total = u64::from(*degree) + right.get(variable).map_or(0, |&degree| u64::from(degree));
            layout = layout.join(Layout::fitting(0, total));
        }
        layout = layout.join(a.layout).join(b.layout);
    }
    layout
}

/// The lowest rung that holds every coefficient of the sum: Σ |sₖ| min(max|aₖ|·‖bₖ‖₁, max|bₖ|·‖aₖ‖₁).
fn product_rung(terms: &[(i64, &Polynomial, &Polynomial)]) -> Rung {
    let mut bound = Some(0u128);
    for (factor, a, b) in terms {
        let product = Norms::of_product(a.coefficients.norms(), b.coefficients.norms());
        let scaled = product.and_then(|product| product.checked_mul(u128::from(factor.unsigned_abs())));
        bound = bound.zip(scaled).and_then(|(bound, scaled)| bound.checked_add(scaled));
    }
    Rung::for_bound(bound)
}

fn accumulate<C: Coefficient>(layout: Layout, terms: &[(i64, &Polynomial, &Polynomial)]) -> Polynomial {
    let words = layout.words;
    let mut monomials = Vec::new();
    let mut coefficients = Vec::new();
    for (factor, a, b) in terms {
        let (left, right) = (a.monomials_on(layout), b.monomials_on(layout));
        let (a, b) = (C::view(&a.coefficients), C::view(&b.coefficients));
        let factor = C::from(*factor);
        for i in 0..a.len() {
            let scaled = a[i].times(&factor);
            for j in 0..b.len() {
                for word in 0..words {
                    monomials.push(left[i * words + word] + right[j * words + word]);
                }
                coefficients.push(scaled.times(&b[j]));
            }
        }
    }
    Polynomial::from_unsorted(layout, &monomials, &coefficients)
}
