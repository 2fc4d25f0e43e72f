//! Arithmetic of the tower's field.

use super::fraction::Fraction;
use super::obstacle::Obstacle;
use super::power::{FactorPower, common_powers, merge_powers};
use super::tower::Tower;
use super::work::check_exponent;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed};

/// Largest power that stays a factor; a higher power is refused or multiplied out.
const LARGEST_FACTORED_POWER: i32 = 1024;

impl Tower {
    /// a + b
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub fn add(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() {
            return Ok(b.clone());
        }
        if b.is_zero() {
            return Ok(a.clone());
        }
        if a.factors == b.factors && a.divisor == b.divisor {
            let sum = a.numerator.add(&b.numerator);
            self.charge_divisions(&sum, &a.factors)?;
            return Ok(self.cancel(sum, a.divisor.clone(), a.factors.clone()));
        }
        if a.factors != b.factors
            && let Some((a, b)) = self.over_finer_factors(a, b)?
        {
            return self.add(&a, &b);
        }
        let divisor = a.divisor.lcm(&b.divisor);
        let common = common_powers(&a.factors, &b.factors);
        let left = self.raised(&a.numerator, &(&divisor / &a.divisor), &common.lacking_left)?;
        let right = self.raised(&b.numerator, &(&divisor / &b.divisor), &common.lacking_right)?;
        let sum = left.add(&right);
        self.charge_divisions(&sum, &common.all)?;
        Ok(self.cancel(sum, divisor, common.all))
    }

    /// Brings a numerator over a larger denominator.
    pub(super) fn raised(
        &mut self,
        numerator: &Polynomial,
        by: &BigInt,
        powers: &[FactorPower],
    ) -> Result<Polynomial, Obstacle> {
        let mut raised = if by.is_one() { numerator.clone() } else { numerator.scale(by) };
        for power in powers {
            let times = power.exponent.unsigned_abs();
            if let Some(variable) = self.factor_variable(power.factor) {
                check_exponent(raised.exponent_bound().saturating_add(times))?;
                raised = raised.multiply_by_monomial(&[(variable, times)]);
                continue;
            }
            let polynomial = self.factor_polynomial(power.factor).clone();
            self.check_power(&raised, &polynomial, u64::from(times))?;
            for _ in 0..times {
                self.charge(&raised, &polynomial)?;
                raised = self.reduce(raised.mul(&polynomial))?;
            }
        }
        self.reduce(raised)
    }

    /// Returns a polynomial that has the sign of N / ∏ Fᵉ wherever this is defined: N times the odd
    /// powers.
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub(crate) fn with_the_sign_of(&mut self, a: &Fraction) -> Result<Polynomial, Obstacle> {
        let is_odd = |power: &&FactorPower| power.exponent % 2 != 0;
        let odd: Vec<FactorPower> =
            a.factors.iter().filter(is_odd).map(|power| FactorPower { exponent: 1, ..*power }).collect();
        self.raised(&a.numerator, &BigInt::one(), &odd)
    }

    /// Returns the same element with every factor of the numerator multiplied out.
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub(crate) fn expanded(&mut self, a: &Fraction) -> Result<Fraction, Obstacle> {
        let (above, below): (Vec<FactorPower>, Vec<FactorPower>) =
            a.factors.iter().partition(|power| power.exponent < 0);
        if above.is_empty() {
            return Ok(a.clone());
        }
        let numerator = self.raised(&a.numerator, &BigInt::one(), &above)?;
        Ok(self.cancel(numerator, a.divisor.clone(), below))
    }

    /// −a
    pub fn negate(&self, a: &Fraction) -> Fraction {
        Fraction { numerator: a.numerator.neg(), ..a.clone() }
    }

    /// a − b
    ///
    /// # Errors
    /// The same as for a sum.
    pub fn subtract(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        let negated = self.negate(b);
        self.add(a, &negated)
    }

    /// a b
    ///
    /// # Errors
    /// [`Obstacle::TooLarge`] if the work exceeds the tower's limit.
    pub fn multiply(&mut self, a: &Fraction, b: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() || b.is_zero() {
            return Ok(Fraction::zero());
        }
        if a.is_polynomial() && b.is_polynomial() {
            self.charge(&a.numerator, &b.numerator)?;
            return Ok(self.reduce(a.numerator.mul(&b.numerator))?.into());
        }
        let left = self.cancel_in_product(a, b);
        let right = self.cancel_in_product(b, a);
        self.charge(&left.numerator, &right.numerator)?;
        let product = left.numerator.mul(&right.numerator);
        let divisor = &left.divisor * &right.divisor;
        let factors = merge_powers(&left.factors, &right.factors);
        for power in &factors {
            check_exponent(power.exponent.unsigned_abs())?;
        }
        let bound = self
            .generators
            .relations()
            .iter()
            .any(|relation| product.degree(relation.variable) >= relation.order);
        let reduced = if bound { self.reduce(product)? } else { product };
        if bound || factors.iter().any(|power| power.exponent < 0) {
            self.charge_divisions(&reduced, &factors)?;
            return Ok(self.cancel(reduced, divisor, factors));
        }
        Ok(Fraction { numerator: reduced, divisor, factors })
    }

    /// Returns the numerator of `a` over the denominator of `b`. A factor that `a` itself has in
    /// its denominator does not divide its numerator, so it is not tried again.
    fn cancel_in_product(&mut self, a: &Fraction, b: &Fraction) -> Fraction {
        if b.is_polynomial() {
            return a.numerator.clone().into();
        }
        if a.factors.is_empty() {
            return self.cancel(a.numerator.clone(), b.divisor.clone(), b.factors.clone());
        }
        let settled =
            |power: &FactorPower| a.factors.iter().any(|own| own.factor == power.factor && own.exponent > 0);
        let (kept, open): (Vec<FactorPower>, Vec<FactorPower>) =
            b.factors.iter().partition(|power| settled(power));
        let mut over = self.cancel(a.numerator.clone(), b.divisor.clone(), open);
        over.factors = merge_powers(&over.factors, &kept);
        over
    }

    /// aⁿ for a product of generators without a numeric coefficient, by its exponents.
    fn power_of_generators(&mut self, a: &Fraction, n: u64) -> Result<Option<Fraction>, Obstacle> {
        if !a.is_polynomial() || a.numerator.term_count() != 1 || !a.numerator.leading_coefficient().is_one()
        {
            return Ok(None);
        }
        let mut monomial = a.numerator.monomial_content();
        for (_, exponent) in &mut monomial {
            let raised = u64::from(*exponent).saturating_mul(n);
            *exponent = u32::try_from(raised).unwrap_or(u32::MAX);
            check_exponent(*exponent)?;
        }
        monomial.retain(|power| power.1 != 0);
        Ok(Some(self.reduce(Polynomial::monomial_of(&monomial))?.into()))
    }

    /// 1/a, whose numerator becomes one or more known factors.
    ///
    /// # Errors
    /// [`Obstacle::DivisionByZero`] for a = 0.
    pub fn inverse(&mut self, a: &Fraction) -> Result<Fraction, Obstacle> {
        if a.is_zero() {
            return Err(Obstacle::DivisionByZero);
        }
        let (content, below) = self.split(&a.numerator)?;
        let above: Vec<FactorPower> = a.factors.iter().map(|power| power.inverse()).collect();
        let numerator =
            Polynomial::constant(if content.is_negative() { -&a.divisor } else { a.divisor.clone() });
        Ok(self.cancel(numerator, content.abs(), merge_powers(&above, &below)))
    }

    /// aⁿ with a sum in the numerator kept as a factor, so that it is multiplied out only if a sum
    /// needs it.
    ///
    /// # Errors
    /// The same as for [`Tower::integer_power`].
    pub(super) fn factored_power(&mut self, a: &Fraction, exponent: i64) -> Result<Fraction, Obstacle> {
        let times = i32::try_from(exponent).ok().filter(|n| (2..=LARGEST_FACTORED_POWER).contains(n));
        let Some(times) = times.filter(|_| a.numerator.term_count() > 1) else {
            return self.integer_power(a, exponent);
        };
        let (content, parts) = self.split(&a.numerator)?;
        let above: Vec<FactorPower> = parts.iter().map(|power| power.inverse()).collect();
        let raise = |power: FactorPower| FactorPower { exponent: power.exponent * times, ..power };
        let powers = merge_powers(&above, &a.factors).into_iter().map(raise).collect();
        let numerator = Polynomial::constant(num_traits::pow(content, times as usize));
        Ok(self.cancel(numerator, num_traits::pow(a.divisor.clone(), times as usize), powers))
    }

    /// aⁿ
    ///
    /// # Errors
    /// [`Obstacle::DivisionByZero`] for a negative power of 0, [`Obstacle::TooLarge`] beyond the
    /// limits.
    pub fn integer_power(&mut self, a: &Fraction, exponent: i64) -> Result<Fraction, Obstacle> {
        if exponent < 0 {
            let inverse = self.inverse(a)?;
            return self.integer_power(&inverse, -exponent);
        }
        self.check_power(&Polynomial::one(), &a.numerator, exponent.unsigned_abs())?;
        if let Some(power) = self.power_of_generators(a, exponent.unsigned_abs())? {
            return Ok(power);
        }
        let mut result: Option<Fraction> = None;
        let mut square = a.clone();
        let mut rest = exponent;
        while rest > 0 {
            if rest % 2 == 1 {
                result = Some(match result {
                    Some(result) => self.multiply(&result, &square)?,
                    None => square.clone(),
                });
            }
            rest /= 2;
            if rest > 0 {
                square = self.multiply(&square, &square.clone())?;
            }
        }
        Ok(result.unwrap_or_else(Fraction::one))
    }
}
