//! Nested radicals: factors A + Bρ that contain roots themselves, with ρ² = f.
//!
//! The norm n = A² − B² f relates such a factor to its conjugate A − Bρ and, if n is a square, to
//! simpler factors (denesting):
//! ```text
//! A + Bρ = n / (A − Bρ)                          where the conjugate is a factor already
//! A + Bρ = (A + m + Bρ)² / (2 (A + m))           where n = m²: √(3 + 2√2) = (4 + 2√2)/√8 = 1 + √2
//! A + Bρ = s² / g                                where its product with a known factor g is a square s²
//! A + Bρ = h³                                    where numbers A and B make it a cube
//! ```
//! Each is an identity of the field, so it serves both roots and logarithms. Its divisor must have
//! a non-zero norm, down to an element without roots, which shows that the divisor is not a hidden
//! zero. Where the norm vanishes the identity makes no statement, which the tower records
//! (`normal/strata.rs`). A factor without an applicable identity joins the basis.

use super::cube::cube_root;
use super::factored::Factored;
use super::fraction::Fraction;
use super::generator::Generator;
use super::norm::{DEEPEST_ROOT, MOST_TERMS, Split};
use super::obstacle::Obstacle;
use super::tower::Tower;
use crate::polynomial::Polynomial;
use num_rational::Ratio;

/// Largest number of nested radicals that are denested in one element.
const MOST_DENESTED: u32 = 24;

/// Largest number of nested factors whose products are tried as squares.
const MOST_PRODUCTS: usize = 8;

impl Tower {
    /// Multiplies by a power of a primitive factor that contains bound generators.
    pub(super) fn raise_nested(
        &mut self,
        part: &Polynomial,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        let roots = self.roots_in(part);
        if part.term_count() > MOST_TERMS || roots.is_empty() {
            return self.raise_part(part, exponent, factored);
        }
        let coefficients = part.split_by(&roots);
        let common = coefficients.iter().fold(Polynomial::zero(), |common, (_, c)| common.gcd(c));
        if common.as_constant().is_none()
            && let Some(rest) = part.divide_exact(&common)
        {
            self.factor_polynomial_into(&common, exponent, factored)?;
            return self.factor_polynomial_into(&rest, exponent, factored);
        }
        let (_, powers) = part.square_free();
        if powers.iter().any(|(_, multiplicity)| *multiplicity > 1) {
            for (factor, multiplicity) in powers {
                let power = exponent * Ratio::from_integer(i64::from(multiplicity));
                self.factor_polynomial_into(&factor, power, factored)?;
            }
            return Ok(());
        }
        for &variable in &roots {
            if let Some(rest) = self.divide_by_generator(part, variable) {
                self.factor_polynomial_into(&Polynomial::variable(variable), exponent, factored)?;
                return self.factor_polynomial_into(&rest, exponent, factored);
            }
        }
        if factored.denested < MOST_DENESTED {
            for &variable in roots.iter().rev() {
                let Some(split) = self.split_at(part, variable) else { continue };
                factored.denested += 1;
                if self.by_conjugate(&split, exponent, factored)?
                    || self.denest(&split, exponent, factored)?
                    || self.by_cube(&split, exponent, factored)?
                {
                    return Ok(());
                }
                factored.denested -= 1;
            }
            if self.by_square_product(part, exponent, factored)? {
                return Ok(());
            }
        }
        self.raise_part(part, exponent, factored)
    }

    /// (A + Bρ)ᵉ = nᵉ (A − Bρ)⁻ᵉ
    fn by_conjugate(
        &mut self,
        split: &Split,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<bool, Obstacle> {
        let conjugate = split.conjugate();
        let primitive = conjugate.primitive_part();
        let primitive = if primitive.is_negative() { primitive.neg() } else { primitive };
        if !self.is_active_base(&primitive) {
            return Ok(false);
        }
        let norm = self.norm(split)?;
        let Some(below) = self.full_norm(&conjugate)?.filter(|_| !norm.is_zero()) else { return Ok(false) };
        self.exclude_zeros(below);
        self.factor_polynomial_into(&norm, exponent, factored)?;
        self.factor_polynomial_into(&conjugate, -exponent, factored)?;
        Ok(true)
    }

    /// (A + Bρ)ᵉ = (A + m + Bρ)²ᵉ (2 (A + m))⁻ᵉ if m² = A² − B² f
    fn denest(
        &mut self,
        split: &Split,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<bool, Obstacle> {
        let norm = self.norm(split)?;
        let available = self.roots_in(&split.rational.add(&split.irrational()));
        let Some(m) = self.square_root(&norm, &available, DEEPEST_ROOT)? else { return Ok(false) };
        let Some((sum, below)) = self.sum_to_divide_by(split, &m)? else { return Ok(false) };
        let whole = self.add(&sum, &split.irrational().into())?;
        if whole.is_zero() || !self.exclude_zeros_below(&sum)? {
            return Ok(false);
        }
        self.exclude_zeros(below);
        let two = Ratio::from_integer(2);
        self.raise_fraction(&whole, exponent * two, factored)?;
        self.raise_fraction(&sum, -exponent, factored)?;
        self.multiply_constant(factored, &2.into(), -exponent);
        Ok(true)
    }

    /// Returns A + m or A − m with its norm; the one whose norm is a number is preferred.
    fn sum_to_divide_by(
        &mut self,
        split: &Split,
        m: &Fraction,
    ) -> Result<Option<(Fraction, Polynomial)>, Obstacle> {
        let mut found = None;
        for m in [m.clone(), self.negate(m)] {
            let sum = self.add(&split.rational.clone().into(), &m)?;
            if sum.is_zero() {
                continue;
            }
            let Some(norm) = self.full_norm(&sum.numerator)? else { continue };
            if norm.as_constant().is_some() {
                return Ok(Some((sum, norm)));
            }
            found = found.or(Some((sum, norm)));
        }
        Ok(found)
    }

    /// (A + Bρ)ᵉ = h³ᵉ for numbers A and B
    fn by_cube(
        &mut self,
        split: &Split,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<bool, Obstacle> {
        let norm = self.norm(split)?;
        let (Some(a), Some(norm)) = (split.rational.as_constant(), norm.as_constant()) else {
            return Ok(false);
        };
        let is_number = split.slope.as_constant().is_some();
        let Some((shift, below)) = cube_root(&a, &norm).filter(|_| is_number) else { return Ok(false) };
        let above = split.rational.add(&split.irrational()).add(&Polynomial::constant(shift));
        let three = Ratio::from_integer(3);
        self.factor_polynomial_into(&above, exponent * three, factored)?;
        self.multiply_constant(factored, &below, -exponent * three);
        Ok(true)
    }

    /// fᵉ = s²ᵉ g⁻ᵉ for a factor g of the basis with f g = s²
    fn by_square_product(
        &mut self,
        part: &Polynomial,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<bool, Obstacle> {
        let nested: Vec<Polynomial> = self
            .bases()
            .map(|(_, base)| base.polynomial.clone())
            .filter(|g| g != part && g.term_count() <= MOST_TERMS && !self.roots_in(g).is_empty())
            .filter(|g| g.variables().into_iter().all(|v| !self.is_stale_root(v)))
            .collect();
        if nested.len() > MOST_PRODUCTS {
            return Ok(false);
        }
        for other in nested {
            self.charge(part, &other)?;
            let product = self.reduce(part.mul(&other))?;
            let available = self.roots_in(&part.add(&other));
            let Some(root) = self.square_root(&product, &available, DEEPEST_ROOT)? else { continue };
            let Some(below) = self.full_norm(&other)?.filter(|_| !root.is_zero()) else { continue };
            if !self.exclude_zeros_below(&root)? {
                continue;
            }
            factored.denested += 1;
            self.exclude_zeros(below);
            self.raise_fraction(&root, exponent * Ratio::from_integer(2), factored)?;
            self.raise_part(&other, -exponent, factored)?;
            return Ok(true);
        }
        Ok(false)
    }

    /// Multiplies by qᵉ, including the integer of its denominator.
    fn raise_fraction(
        &mut self,
        q: &Fraction,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        self.factor_fraction_into(q, exponent, factored)?;
        self.multiply_constant(factored, &q.divisor, -exponent);
        Ok(())
    }

    /// Returns a root of a radicand that contains roots, if one is in use: it can depend on others
    /// in unknown ways.
    pub fn nested_radical(&self) -> Option<Fraction> {
        let nested = |&variable: &u32| {
            self.is_current_root(variable)
                && self
                    .relation_of(variable)
                    .is_some_and(|relation| !self.roots_in(&relation.value).is_empty())
        };
        (0..self.generator_count()).find(nested).map(|variable| Polynomial::variable(variable).into())
    }

    fn is_stale_root(&self, variable: u32) -> bool {
        matches!(self.generator(variable), Generator::Root { .. }) && !self.is_current_root(variable)
    }

    fn is_active_base(&self, polynomial: &Polynomial) -> bool {
        self.bases().any(|(_, base)| base.polynomial == *polynomial)
    }
}
