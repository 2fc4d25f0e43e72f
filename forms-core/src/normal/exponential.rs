//! Exponentials, logarithms and the powers between them.
//!
//! ```text
//! exponent Σ qₖ mₖ / D ─ one denominator D for all, remainders modulo D ─▶ E(m₁/D)^n₁ E(m₂/D)^n₂ … |g|^q
//! log |c ∏ gᵢ^eᵢ exp u| ─ coprime factors of all radicands and arguments ─▶ Σ eᵢ log|gᵢ| + u
//! ```
//! The exponents m/D that occur are linearly independent over ℚ, since a fraction over one
//! denominator has only one remainder; exp(q log|g|) with a number q is a power of |g|, and any
//! other product with a logarithm is an exponent like all others. A logarithm needs no sign: log q
//! is defined for q > 0 only, where it is log|q|.

use super::factored::Power;
use super::fraction::Fraction;
use super::generator::{Generator, Quantity, Unit};
use super::obstacle::{Obstacle, OutsidePart, SizeLimit};
use super::power::{FactorPower, common_powers, merge_powers};
use super::tower::Tower;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Largest power of one exponential, and largest divisor of an exponent, that are formed.
const LARGEST_MULTIPLE: u32 = 1 << 12;

/// Largest number of terms of a common denominator of exponents.
const LARGEST_DENOMINATOR: usize = 64;

/// Monomial in lexicographic order: the variable with the smallest number counts most.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Lexicographic(Vec<(u32, u32)>);

impl Ord for Lexicographic {
    fn cmp(&self, other: &Self) -> Ordering {
        for (a, b) in self.0.iter().zip(&other.0) {
            let order = b.0.cmp(&a.0).then(a.1.cmp(&b.1));
            if order != Ordering::Equal {
                return order;
            }
        }
        self.0.len().cmp(&other.0.len())
    }
}

impl PartialOrd for Lexicographic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Lexicographic {
    /// m/n, if n divides m.
    fn over(&self, divisor: &Self) -> Option<Self> {
        let mut quotient = self.0.clone();
        for &(variable, exponent) in &divisor.0 {
            let place = quotient.iter().position(|entry| entry.0 == variable && entry.1 >= exponent)?;
            quotient[place].1 -= exponent;
        }
        quotient.retain(|entry| entry.1 > 0);
        Some(Lexicographic(quotient))
    }

    fn times(&self, other: &Self) -> Self {
        let mut product: BTreeMap<u32, u32> = self.0.iter().copied().collect();
        for &(variable, exponent) in &other.0 {
            *product.entry(variable).or_insert(0) += exponent;
        }
        Lexicographic(product.into_iter().collect())
    }
}

/// Terms of a polynomial with rational coefficients.
type RationalTerms = BTreeMap<Lexicographic, Rational>;

impl Tower {
    /// Returns exp q as a product of powers of generators.
    pub(super) fn exponential(&mut self, argument: &Fraction) -> Result<Fraction, Obstacle> {
        let mut product = Fraction::one();
        for (quantity, coefficient) in self.exponent_parts(argument)? {
            let power = self.exponential_of_part(quantity, &coefficient)?;
            product = self.multiply(&product, &power)?;
        }
        Ok(product)
    }

    /// (cosh q, sinh q): (e^q ± e^−q)/2
    pub(super) fn hyperbolic(&mut self, argument: &Fraction) -> Result<(Fraction, Fraction), Obstacle> {
        let up = self.exponential(argument)?;
        let down = self.inverse(&up)?;
        let half = Fraction::number(&Rational::new(1.into(), 2.into()));
        let (sum, difference) = (self.add(&up, &down)?, self.subtract(&up, &down)?);
        Ok((self.multiply(&half, &sum)?, self.multiply(&half, &difference)?))
    }

    /// Returns log q for q > 0, from the factors of q.
    pub(super) fn logarithm(&mut self, argument: &Fraction) -> Result<Fraction, Obstacle> {
        if argument.is_zero() {
            return Err(Obstacle::Outside(OutsidePart::LogarithmOfZero));
        }
        let factored = self.factor_magnitude(argument)?;
        let mut sum = self.exponent_of(&factored.exponentials)?;
        for Power { base, exponent, .. } in factored.powers {
            let logarithm = self.element(Generator::Logarithm { base });
            let share = Fraction::number(&rational(exponent));
            let term = self.multiply(&share, &logarithm)?;
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    /// Returns the exponent Σ e u of a product of powers (exp u)ᵉ.
    pub(super) fn exponent_of(&mut self, powers: &[(u32, Ratio<i64>)]) -> Result<Fraction, Obstacle> {
        let mut sum = Fraction::zero();
        for &(variable, exponent) in powers {
            let Generator::Exponential(unit) = self.generator(variable).clone() else { continue };
            let share = rational(exponent) / Rational::from_integer(unit.divisor.into());
            let quantity = self.quantity(&unit.quantity);
            let term = self.multiply(&Fraction::number(&share), &quantity)?;
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    /// exp(c m/D), which is |g|^c if m/D is log|g|.
    fn exponential_of_part(
        &mut self,
        quantity: Quantity,
        coefficient: &Rational,
    ) -> Result<Fraction, Obstacle> {
        let outside = || Obstacle::Outside(OutsidePart::Exponent(coefficient.clone()));
        if let ([(variable, 1)], []) = (quantity.monomial.as_slice(), quantity.factors.as_slice())
            && let Generator::Logarithm { base } = *self.generator(*variable)
        {
            let part = |number: &BigInt| number.to_i64().ok_or_else(outside);
            return self.base_power(base, Ratio::new(part(coefficient.numer())?, part(coefficient.denom())?));
        }
        let needed = coefficient.denom().to_u32().filter(|d| *d <= LARGEST_MULTIPLE).ok_or_else(outside)?;
        let divisor = *self.denominators.of_exponents.entry(quantity.clone()).or_insert(needed);
        if !divisor.is_multiple_of(needed) {
            let finer = divisor.lcm(&needed);
            if finer > LARGEST_MULTIPLE {
                return Err(outside());
            }
            self.denominators.of_exponents.insert(quantity, finer);
            return Err(Obstacle::Refine);
        }
        let multiple = (coefficient * Rational::from_integer(divisor.into())).to_integer();
        let multiple = multiple.to_i64().filter(|m| m.unsigned_abs() <= u64::from(LARGEST_MULTIPLE));
        let generator = self.element(Generator::Exponential(Unit { quantity, divisor }));
        self.integer_power(&generator, multiple.ok_or_else(outside)?)
    }

    /// Returns the exponents m/D that an element is a rational combination of, with their
    /// coefficients.
    fn exponent_parts(&mut self, argument: &Fraction) -> Result<Vec<(Quantity, Rational)>, Obstacle> {
        let argument = self.expanded(argument)?;
        if argument.factors.is_empty() && self.denominators.of_all_exponents.is_empty() {
            return self.linear_parts(&argument);
        }
        let Some((numerator, divisor, below)) = self.over_free_denominator(&argument)? else {
            return self.linear_parts(&argument);
        };
        let common = common_powers(&below, &self.denominators.of_all_exponents);
        if common.all != self.denominators.of_all_exponents {
            self.denominators.of_all_exponents = common.all;
            return Err(Obstacle::Refine);
        }
        let denominator = self.product_of(&common.all)?;
        let numerator = self.raised(&numerator, &BigInt::one(), &common.lacking_left)?;
        let (quotient, remainder) = divide(&numerator, &divisor, &denominator);
        let parts = |terms: RationalTerms, factors: Vec<FactorPower>| {
            let part = move |(monomial, coefficient): (Lexicographic, Rational)| {
                (Quantity { monomial: monomial.0, factors: factors.clone() }, coefficient)
            };
            terms.into_iter().rev().map(part)
        };
        Ok(parts(quotient, Vec::new()).chain(parts(remainder, common.all)).collect())
    }

    /// ∏ Fᵉ multiplied out.
    fn product_of(&mut self, powers: &[FactorPower]) -> Result<Polynomial, Obstacle> {
        let mut product = Polynomial::one();
        for power in powers {
            let factor = self.factor_polynomial(power.factor).clone();
            for _ in 0..power.exponent {
                product = product.mul(&factor);
                if product.term_count() > LARGEST_DENOMINATOR {
                    return Err(Obstacle::TooLarge(SizeLimit::ExponentDenominator(LARGEST_DENOMINATOR)));
                }
            }
        }
        Ok(product)
    }

    /// N/(d ∏ Fᵉ) with F free of bound generators: 1/ρ is ρⁿ⁻¹/f, and 1/(A + Bρ) has a conjugate.
    /// `None` if a factor has neither.
    fn over_free_denominator(
        &mut self,
        a: &Fraction,
    ) -> Result<Option<(Polynomial, BigInt, Vec<FactorPower>)>, Obstacle> {
        let (mut numerator, mut divisor) = (a.numerator.clone(), a.divisor.clone());
        let mut below: Vec<FactorPower> = Vec::new();
        for power in &a.factors {
            let factor = self.factor_polynomial(power.factor).clone();
            if self.is_free(&factor) {
                below = merge_powers(&below, &[*power]);
                continue;
            }
            let Some((above, norm)) = self.rationalised(&factor)? else { return Ok(None) };
            if factor.term_count() > 1 {
                self.exclude_zeros(norm.clone()); // the conjugate may vanish where the factor does not
            }
            let monomial = norm.monomial_content();
            let (sign, content) = (norm.leading_coefficient().signum(), norm.content());
            let primitive = norm.primitive_part();
            let rest = primitive.divide_by_monomial(&monomial).unwrap_or(primitive);
            let mut parts: Vec<(Polynomial, u32)> =
                monomial.into_iter().map(|(variable, n)| (Polynomial::variable(variable), n)).collect();
            parts.push((rest.scale(&rest.leading_coefficient().signum()), 1));
            for _ in 0..power.exponent {
                self.charge(&numerator, &above)?;
                numerator = self.reduce(numerator.mul(&above))?.scale(&sign);
                divisor *= &content;
            }
            for (part, n) in parts.into_iter().filter(|(part, _)| part.as_constant().is_none()) {
                let named = FactorPower { factor: self.factor(part), exponent: n as i32 * power.exponent };
                below = merge_powers(&below, &[named]);
            }
        }
        Ok(Some((numerator, divisor, below)))
    }

    /// Returns G and n, free of bound generators, with F G = n.
    fn rationalised(&mut self, factor: &Polynomial) -> Result<Option<(Polynomial, Polynomial)>, Obstacle> {
        if let [(variable, 1)] = factor.monomial_content().as_slice()
            && factor.term_count() == 1
            && matches!(self.generator(*variable), Generator::Root { .. })
            && let Some(relation) = self.relation_of(*variable).cloned()
        {
            let power = Polynomial::variable(*variable).pow(relation.order - 1);
            return Ok(Some((power, relation.value)).filter(|(_, norm)| self.is_free(norm)));
        }
        Ok(self.conjugate(factor)?.filter(|(_, norm)| self.is_free(norm)))
    }

    /// Whether no bound generator occurs.
    fn is_free(&self, polynomial: &Polynomial) -> bool {
        polynomial.variables().into_iter().all(|variable| self.relation_of(variable).is_none())
    }
}

/// N/d = Q D + R with no term of R divisible by the leading term of D.
fn divide(numerator: &Polynomial, divisor: &BigInt, by: &Polynomial) -> (RationalTerms, RationalTerms) {
    let terms = |polynomial: &Polynomial, divisor: &BigInt| -> RationalTerms {
        let rational = |coefficient| Rational::new(coefficient, divisor.clone());
        polynomial.terms().map(|(monomial, c)| (Lexicographic(monomial), rational(c))).collect()
    };
    let (mut rest, by) = (terms(numerator, divisor), terms(by, &BigInt::one()));
    let (mut quotient, mut remainder) = (RationalTerms::new(), RationalTerms::new());
    let Some((leading, first)) = by.last_key_value() else { return (quotient, rest) };
    while let Some((monomial, coefficient)) = rest.pop_last() {
        let Some(share) = monomial.over(leading) else {
            remainder.insert(monomial, coefficient);
            continue;
        };
        let factor = coefficient / first;
        for (other, c) in by.iter().rev().skip(1) {
            let place = share.times(other);
            let entry = rest.entry(place.clone()).or_insert_with(Rational::zero);
            *entry -= &factor * c;
            if entry.is_zero() {
                rest.remove(&place);
            }
        }
        quotient.insert(share, factor);
    }
    (quotient, remainder)
}

fn rational(ratio: Ratio<i64>) -> Rational {
    Rational::new((*ratio.numer()).into(), (*ratio.denom()).into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quotient_times_divisor_and_remainder_make_the_dividend() {
        // (x³ + 2xy)/3 by x + y, x before y: x³ + 2xy = (x² − xy + y² + 2y)(x + y) − y³ − 2y²
        let term = |m: &[(u32, u32)], c: i64| (m.to_vec(), BigInt::from(c));
        let dividend = Polynomial::from_terms([term(&[(0, 3)], 1), term(&[(0, 1), (1, 1)], 2)]);
        let by = Polynomial::variable(0).add(&Polynomial::variable(1));
        let (quotient, remainder) = divide(&dividend, &3.into(), &by);
        let third = |p: i64| Rational::new(p.into(), 3.into());
        let expected = |terms: &[(&[(u32, u32)], i64)]| -> RationalTerms {
            terms.iter().map(|(m, c)| (Lexicographic(m.to_vec()), third(*c))).collect()
        };
        let whole = [(&[(0, 2)][..], 1), (&[(0, 1), (1, 1)], -1), (&[(1, 2)], 1), (&[(1, 1)], 2)];
        assert_eq!(quotient, expected(&whole));
        assert_eq!(remainder, expected(&[(&[(1, 3)][..], -1), (&[(1, 2)], -2)]));
    }
}
