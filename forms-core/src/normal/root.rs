//! Roots: radicands are written over a coprime basis, with one root generator per factor.
//!
//! For a radicand c ∏ gᵢ^eᵢ (basis factors gᵢ, signs σᵢ with σᵢ gᵢ ≥ 0 in the region considered)
//! |c ∏ gᵢ^eᵢ|^r = |c|^r ∏ (σᵢ gᵢ)^(r eᵢ), and (σᵢ gᵢ)^(1/n) is a generator.
//! A factor whose sign matters and is unknown is reported; the decision procedure goes through the
//! cases. Exponentials are not factors of the basis: their powers are exponentials. Logarithms use
//! the same factors.

use super::base::{Base, Sign, SignConstraint};
use super::factored::{Factored, Power};
use super::fraction::Fraction;
use super::generator::{Generator, Trigonometry};
use super::obstacle::{Obstacle, OutsidePart};
use super::power::FactorPower;
use super::tower::Tower;
use super::work::check_exponent;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, Zero};

/// Largest order of a root generator.
const LARGEST_ORDER: u32 = 64;

/// Bound below which the prime factors of the radicand of a number are found.
const PRIME_BOUND: u32 = 4096;

impl Tower {
    /// Returns |q|^r for q ≠ 0, with the sign constraint of q itself unless this depends on an open
    /// sign.
    pub(super) fn magnitude_power(
        &mut self,
        q: &Fraction,
        r: Ratio<i64>,
    ) -> Result<(Fraction, Option<SignConstraint>), Obstacle> {
        let before = self.signs_asked();
        let factored = self.factor_radicand(q)?;
        let constraint = (self.signs_asked() == before).then(|| factored.constraint());
        let factored = self.with_numbers(factored, &q.divisor);
        let exponentials: Vec<_> = factored.exponentials.iter().map(|&(v, e)| (v, e * r)).collect();
        let exponent = self.exponent_of(&exponentials)?;
        let mut result = self.exponential(&exponent)?;
        self.signs.met.extend(factored.powers.iter().map(|power| power.base));
        for Power { base, exponent, .. } in factored.powers {
            let power = self.base_power(base, exponent * r)?;
            result = self.multiply(&result, &power)?;
        }
        Ok((result, constraint))
    }

    /// ∛q = ±∏ |gᵢ|^(eᵢ/3), with the sign of q. No factor changes the side of the fraction line, so that
    /// this is right at the zeros of q too.
    pub(super) fn cube_root(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        if q.is_zero() {
            return Ok(q.clone());
        }
        let SignConstraint { mut negative, odd, .. } = self.sign_constraint(q)?;
        let root = self.magnitude_power(q, Ratio::new(1, 3))?.0;
        for base in odd {
            negative ^= self.base_is_negative(base, Ratio::one());
        }
        Ok(if negative { self.negate(&root) } else { root })
    }

    /// Factors |q| over the basis, including its numeric factors.
    pub(super) fn factor_magnitude(&mut self, q: &Fraction) -> Result<Factored, Obstacle> {
        let factored = self.factor_radicand(q)?;
        let mut factored = self.with_numbers(factored, &q.divisor);
        factored.powers.retain(|power| !power.exponent.is_zero());
        Ok(factored)
    }

    /// Returns the sign constraint of an element over the bases known so far.
    pub fn sign_constraint(&mut self, q: &Fraction) -> Result<SignConstraint, Obstacle> {
        Ok(self.factor_radicand(q)?.constraint())
    }

    /// (σ g)^e as a power of the root of g, or of g itself if e is an integer.
    pub(super) fn base_power(&mut self, base: usize, exponent: Ratio<i64>) -> Result<Fraction, Obstacle> {
        let order = u32::try_from(*exponent.denom()).ok().filter(|n| *n <= LARGEST_ORDER);
        let order = order.ok_or_else(|| Obstacle::Outside(OutsidePart::Root(*exponent.denom())))?;
        if !self.bases[base].order.is_multiple_of(order) {
            self.bases[base].order = self.bases[base].order.lcm(&order);
            return Err(Obstacle::Refine);
        }
        let negative = self.base_is_negative(base, exponent);
        let order = self.bases[base].order;
        if exponent.is_integer() {
            let polynomial = &self.bases[base].polynomial;
            let signed = if negative { polynomial.neg() } else { polynomial.clone() };
            return self.integer_power(&signed.into(), *exponent.numer());
        }
        let root = self.root(base, order, negative);
        let times = (exponent * Ratio::from_integer(i64::from(order))).to_integer();
        self.root_power(root, order, times)
    }

    /// ρᵏ. If ρⁿ is a sum, a power with k ≥ n is kept as a known factor, so that the sum is
    /// multiplied out only if another sum needs it.
    fn root_power(&mut self, root: u32, order: u32, times: i64) -> Result<Fraction, Obstacle> {
        let radicand_terms = self.relation_of(root).map_or(1, |relation| relation.value.term_count());
        let exponent = match i32::try_from(times) {
            Ok(exponent) if radicand_terms > 1 && times >= i64::from(order) => exponent,
            _ => return self.integer_power(&Polynomial::variable(root).into(), times),
        };
        check_exponent(exponent.unsigned_abs())?;
        let factor = self.factor(Polynomial::variable(root));
        Ok(Fraction {
            numerator: Polynomial::one(),
            divisor: BigInt::one(),
            factors: vec![FactorPower { factor, exponent: -exponent }],
        })
    }

    /// Whether −g is the positive one; requests the sign unless an even power makes it irrelevant.
    fn base_is_negative(&mut self, base: usize, exponent: Ratio<i64>) -> bool {
        if self.is_manifestly_not_negative(&self.bases[base].polynomial) {
            return false;
        }
        if exponent.is_integer() && exponent.numer().is_even() {
            return false;
        }
        self.ask_for_sign(base);
        self.bases[base].sign == Some(Sign::Negative)
    }

    /// Returns the generator ρ with ρⁿ = ±g.
    fn root(&mut self, base: usize, order: u32, negated: bool) -> u32 {
        let polynomial = &self.bases[base].polynomial;
        let value = if negated { polynomial.neg() } else { polynomial.clone() };
        let variable = self.variable_of(Generator::Root { base, order, negated });
        self.bind(variable, order, value);
        variable
    }

    /// Whether a generator is the root of ±g with the sign that g has here. A root of the other
    /// sign case is imaginary.
    pub(super) fn is_current_root(&self, variable: u32) -> bool {
        let Generator::Root { base, order, negated } = *self.generator(variable) else { return false };
        let base = &self.bases[base];
        !base.retired && base.order == order && (base.sign == Some(Sign::Negative)) == negated
    }

    /// Factors numerator and denominator over the basis of radicands; new factors join the basis.
    fn factor_radicand(&mut self, q: &Fraction) -> Result<Factored, Obstacle> {
        let mut factored =
            Factored { constant: BigInt::one(), powers: Vec::new(), exponentials: Vec::new(), denested: 0 };
        self.factor_fraction_into(q, Ratio::one(), &mut factored)?;
        factored.drop_neutral();
        Ok(factored)
    }

    /// Multiplies by qᵉ, without the integer of its denominator.
    pub(super) fn factor_fraction_into(
        &mut self,
        q: &Fraction,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        self.factor_polynomial_into(&q.numerator, exponent, factored)?;
        for power in &q.factors {
            let polynomial = self.factor_polynomial(power.factor).clone();
            let below = -exponent * Ratio::from_integer(i64::from(power.exponent));
            self.factor_polynomial_into(&polynomial, below, factored)?;
        }
        Ok(())
    }

    /// Multiplies by fᵉ.
    pub(super) fn factor_polynomial_into(
        &mut self,
        polynomial: &Polynomial,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        let variables = polynomial.variables();
        if self.trigonometry == Trigonometry::Circle && variables.iter().any(|&v| self.is_trigonometric(v)) {
            self.trigonometry = Trigonometry::HalfAngle;
            return Err(Obstacle::Refine);
        }
        let bound: Vec<u32> = variables.iter().copied().filter(|&v| self.relation_of(v).is_some()).collect();
        let monomial = polynomial.monomial_content();
        let primitive = polynomial.primitive_part();
        let rest = primitive.divide_by_monomial(&monomial).unwrap_or(primitive);
        let known = self.bases.iter().any(|base| !base.retired && base.polynomial == rest);
        let nested = bound.iter().any(|&v| rest.contains(v));
        let (content, parts) =
            if known || nested { (BigInt::one(), vec![(rest, 1)]) } else { rest.square_free() };
        let sign = if polynomial.leading_coefficient().is_negative() { -1 } else { 1 };
        let constant = polynomial.content() * sign * content.abs();
        self.multiply_constant(factored, &constant, exponent);
        for (variable, power) in monomial {
            let power = exponent * Ratio::from_integer(i64::from(power));
            self.raise_variable(variable, power, factored)?;
        }
        for (part, power) in parts {
            if part.as_constant().is_none() {
                let power = exponent * Ratio::from_integer(i64::from(power));
                if nested && !known {
                    self.raise_nested(&part, power, factored)?;
                } else {
                    self.raise_part(&part, power, factored)?;
                }
            }
        }
        Ok(())
    }

    /// Multiplies by cᵉ for a number c. The sign of a constant in the denominator moves to the
    /// numerator; its magnitude stays a power with the same exponent.
    pub(super) fn multiply_constant(
        &mut self,
        factored: &mut Factored,
        constant: &BigInt,
        exponent: Ratio<i64>,
    ) {
        if constant.is_negative() && exponent.numer().is_odd() {
            factored.constant = -&factored.constant;
        }
        if exponent.is_integer() && exponent.is_positive() {
            factored.constant *= num_traits::pow(constant.abs(), *exponent.numer() as usize);
        } else if !constant.abs().is_one() {
            self.raise_number(&constant.abs(), exponent, factored);
        }
    }

    /// Multiplies by a power of a generator in a radicand: ρ^k is g^(k/n) for a root, any other
    /// generator is a factor of its own.
    fn raise_variable(
        &mut self,
        variable: u32,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        match *self.generator(variable) {
            Generator::Root { base, order, .. } => {
                // this is the root of g only as long as g is assumed to be positive
                if self.bases[base].sign.is_none()
                    && !self.is_manifestly_not_negative(&self.bases[base].polynomial)
                {
                    self.ask_for_sign(base);
                }
                factored.raise_root(base, exponent / Ratio::from_integer(i64::from(order)));
                return Ok(());
            }
            Generator::Exponential(_) => {
                factored.exponentials.push((variable, exponent));
                return Ok(());
            }
            _ => {}
        }
        self.raise_part(&Polynomial::variable(variable), exponent, factored)
    }

    /// Multiplies by a power of a square-free factor: it equals a base, is coprime to all bases, or
    /// splits one.
    pub(super) fn raise_part(
        &mut self,
        part: &Polynomial,
        exponent: Ratio<i64>,
        factored: &mut Factored,
    ) -> Result<(), Obstacle> {
        let mut rest = part.clone();
        for base in 0..self.bases.len() {
            if self.bases[base].retired || rest.as_constant().is_some() {
                continue;
            }
            if self.bases[base].polynomial == rest {
                factored.raise(base, exponent);
                return Ok(());
            }
            let common = self.bases[base].polynomial.gcd(&rest);
            if common.as_constant().is_some() {
                continue;
            }
            if common != self.bases[base].polynomial {
                self.split_base(base, &common);
                return Err(Obstacle::Refine);
            }
            rest = rest.divide_exact(&common).unwrap_or(rest);
            factored.raise(base, exponent);
        }
        if rest.as_constant().is_none() {
            let base = self.add_base(rest);
            factored.raise(base, exponent);
        } else if rest.leading_coefficient().is_negative() && exponent.numer().is_odd() {
            factored.constant = -&factored.constant;
        }
        Ok(())
    }

    fn split_base(&mut self, base: usize, common: &Polynomial) {
        self.bases[base].retired = true;
        let cofactor = self.bases[base].polynomial.divide_exact(common);
        self.add_base(common.clone());
        if let Some(cofactor) = cofactor {
            self.add_base(cofactor.primitive_part());
        }
    }

    fn add_base(&mut self, polynomial: Polynomial) -> usize {
        let known = self.bases.iter().position(|base| !base.retired && base.polynomial == polynomial);
        known.unwrap_or_else(|| {
            self.bases.push(Base { polynomial, order: 1, retired: false, sign: None, sign_needed: false });
            self.bases.len() - 1
        })
    }

    /// Writes the numeric factor, constant over divisor, as powers of primes.
    fn with_numbers(&mut self, mut factored: Factored, divisor: &BigInt) -> Factored {
        let constant = factored.constant.abs();
        self.raise_number(&constant, Ratio::one(), &mut factored);
        self.raise_number(divisor, -Ratio::one(), &mut factored);
        factored.drop_neutral();
        factored
    }

    fn raise_number(&mut self, number: &BigInt, exponent: Ratio<i64>, factored: &mut Factored) {
        for (prime, power) in prime_powers(number) {
            let base = self.add_base(Polynomial::constant(prime));
            factored.raise(base, exponent * Ratio::from_integer(i64::from(power)));
        }
    }
}

/// Factors a positive number into small primes and a remainder, which is replaced by its square
/// root if it is a square.
pub(crate) fn prime_powers(number: &BigInt) -> Vec<(BigInt, u32)> {
    let mut rest = number.clone();
    let mut powers = Vec::new();
    for prime in 2..PRIME_BOUND {
        if rest.is_one() {
            break;
        }
        let prime = BigInt::from(prime);
        let mut power = 0;
        while rest.is_multiple_of(&prime) {
            rest /= &prime;
            power += 1;
        }
        if power > 0 {
            powers.push((prime, power));
        }
    }
    if !rest.is_one() {
        let square = rest.sqrt();
        if &square * &square == rest {
            powers.push((square, 2));
        } else {
            powers.push((rest, 1));
        }
    }
    powers
}
