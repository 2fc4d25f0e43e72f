//! Square-free factorisation: f = c ∏ fᵢ^mᵢ with the fᵢ square-free, primitive and pairwise
//! coprime.

use super::Polynomial;
use super::content::content_in;
use num_bigint::BigInt;
use num_traits::One;

impl Polynomial {
    /// Returns the content with the sign of the leading coefficient, and coprime square-free
    /// primitive factors with their multiplicities; a variable that divides the polynomial is a
    /// factor of its own. 0 has the content 0.
    ///
    /// If an intermediate [`Polynomial::gcd`] is not the greatest common divisor, a factor may
    /// contain a square; the product of all powers is still the polynomial.
    pub fn square_free(&self) -> (BigInt, Vec<(Polynomial, u32)>) {
        let mut content = self.content();
        if self.is_negative() {
            content = -content;
        }
        let mut factors = Vec::new();
        let monomial = self.monomial_content();
        let primitive = self.primitive_part();
        for &(variable, exponent) in &monomial {
            factors.push((Polynomial::variable(variable), exponent));
        }
        let rest = primitive.divide_by_monomial(&monomial).expect("its own content divides");
        split(rest, &mut factors);
        (content, factors)
    }
}

/// Splits off the content in one variable and continues with it. The part that is primitive in the
/// variable is factored by Yun's algorithm, whose result is verified since a gcd need not be the
/// greatest.
fn split(f: Polynomial, factors: &mut Vec<(Polynomial, u32)>) {
    let mut rest = f;
    while !rest.is_constant() {
        let variables = rest.variables();
        let degree = |&&variable: &&u32| rest.degree(variable);
        let main = *variables.iter().min_by_key(degree).expect("it is not constant");
        let content = content_in(&rest, main);
        let primitive = rest.divide_exact(&content).expect("its own content divides");
        let parts = yun(&primitive, main);
        if Polynomial::from_factors(&BigInt::one(), &parts) == primitive {
            factors.extend(parts);
        } else {
            factors.push((primitive, 1));
        }
        rest = content;
    }
}

/// Yun's algorithm: with f = ∏ aᵢ^i, g = gcd(f, f′), b = f/g, d = f′/g − b′, each aᵢ = gcd(b, d),
/// then b/aᵢ, d/aᵢ − b′.
fn yun(f: &Polynomial, main: u32) -> Vec<(Polynomial, u32)> {
    let mut factors = Vec::new();
    let derivative = f.derivative(main);
    let common = f.gcd(&derivative);
    let exact = |a: &Polynomial, b: &Polynomial| a.divide_exact(b).expect("a gcd divides");
    let mut b = exact(f, &common);
    let mut d = exact(&derivative, &common).sub(&b.derivative(main));
    let mut multiplicity = 1;
    while !b.is_constant() && multiplicity <= f.degree(main) {
        let factor = if d.is_zero() { b.clone() } else { b.gcd(&d) };
        if !factor.is_constant() {
            factors.push((factor.primitive_part(), multiplicity));
        }
        b = exact(&b, &factor);
        d = exact(&d, &factor).sub(&b.derivative(main));
        multiplicity += 1;
    }
    factors
}

impl Polynomial {
    /// c ∏ fᵢ^mᵢ
    pub fn from_factors(content: &BigInt, factors: &[(Polynomial, u32)]) -> Self {
        let mut product = Polynomial::constant(content.clone());
        for (factor, multiplicity) in factors {
            product = product.mul(&factor.pow(*multiplicity));
        }
        product
    }

    /// Whether no square of a polynomial divides the primitive part.
    pub fn is_square_free(&self) -> bool {
        self.square_free().1.iter().all(|(_, multiplicity)| multiplicity.is_one())
    }
}
