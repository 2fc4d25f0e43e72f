//! Fractions back to structured expressions, for people to read.

use super::fraction::Fraction;
use super::generator::{Generator, Unit};
use super::root::{Base, Sign};
use super::tower::Tower;
use crate::expression::{Expr, Operation, Pool, Rational, Symbol};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One, Signed};

/// A numerator of more terms is not searched for factors.
const LARGEST_FACTORED: usize = 60;

impl Tower {
    /// The fraction as an expression: a number, factors of the numerator, factors of the denominator.
    pub fn raise(&self, pool: &mut Pool, fraction: &Fraction) -> Expr {
        if fraction.is_zero() {
            return pool.integer(0);
        }
        let (content, parts) = self.numerator_factors(&fraction.numerator);
        let p = Rational::new(content, fraction.divisor.clone());
        let negative = p.is_negative();
        let p = p.abs();
        let mut above: Vec<Expr> = parts.iter().map(|(part, n)| self.raise_power(pool, part, *n)).collect();
        let mut below: Vec<Expr> = Vec::new();
        for power in &fraction.factors {
            let polynomial = self.factor_polynomial(power.factor);
            let raised = self.raise_power(pool, polynomial, power.exponent.unsigned_abs());
            if power.exponent < 0 { above.push(raised) } else { below.push(raised) }
        }
        let numerator = product(pool, p.numer(), &above);
        let denominator = product(pool, p.denom(), &below);
        let quotient = pool.divide(numerator, denominator);
        if negative { pool.negate(quotient) } else { quotient }
    }

    fn numerator_factors(&self, numerator: &Polynomial) -> (BigInt, Vec<(Polynomial, u32)>) {
        let bound = numerator.variables().into_iter().any(|v| self.relation_of(v).is_some());
        if bound || numerator.term_count() > LARGEST_FACTORED {
            let mut content = numerator.content();
            if numerator.leading_coefficient().is_negative() {
                content = -content;
            }
            let monomial = numerator.monomial_content();
            let primitive = numerator.primitive_part();
            let rest = primitive.divide_by_monomial(&monomial).unwrap_or(primitive);
            let mut parts: Vec<(Polynomial, u32)> =
                monomial.into_iter().map(|(variable, n)| (Polynomial::variable(variable), n)).collect();
            if !rest.is_one() {
                parts.push((rest, 1));
            }
            return (content, parts);
        }
        numerator.square_free()
    }

    fn raise_power(&self, pool: &mut Pool, polynomial: &Polynomial, exponent: u32) -> Expr {
        if let [(variable, 1)] = polynomial.monomial_content().as_slice()
            && polynomial.term_count() == 1
            && polynomial.leading_coefficient().is_one()
        {
            return self.raise_generator(pool, *variable, exponent);
        }
        let base = self.raise_polynomial(pool, polynomial);
        pool.power(base, Ratio::from_integer(i64::from(exponent)))
    }

    fn raise_polynomial(&self, pool: &mut Pool, polynomial: &Polynomial) -> Expr {
        let mut sum = pool.integer(0);
        let mut terms: Vec<(Vec<(u32, u32)>, BigInt)> = polynomial.terms().collect();
        terms.sort_by_key(|(_, coefficient)| coefficient.is_negative());
        for (monomial, coefficient) in terms {
            let factors: Vec<Expr> =
                monomial.iter().map(|&(variable, n)| self.raise_generator(pool, variable, n)).collect();
            let magnitude = product(pool, &coefficient.abs(), &factors);
            let term = if coefficient.is_negative() { pool.negate(magnitude) } else { magnitude };
            sum = pool.add(sum, term);
        }
        sum
    }

    fn raise_generator(&self, pool: &mut Pool, variable: u32, exponent: u32) -> Expr {
        let n = Ratio::from_integer(i64::from(exponent));
        let base = match self.generator(variable).clone() {
            Generator::Variable(symbol) => self.raise_real_variable(pool, symbol),
            Generator::Pi => pool.pi(),
            Generator::Chord { sides, sine } => {
                let (part, pi, two) = (pool.ratio(2, i64::from(sides)), pool.pi(), pool.integer(2));
                let angle = pool.multiply(part, pi);
                let half = pool.apply(if sine { Operation::Sin } else { Operation::Cos }, &[angle]);
                pool.multiply(two, half)
            }
            Generator::Jet { function, orders, arguments } => {
                let arguments: Vec<Expr> = arguments.iter().map(|a| self.raise(pool, a)).collect();
                pool.jet(function, &orders, &arguments)
            }
            Generator::Cosine(unit) => self.raise_function(pool, Operation::Cos, &unit, 1),
            Generator::Sine(unit) => self.raise_function(pool, Operation::Sin, &unit, 1),
            Generator::HalfTangent(unit) => self.raise_function(pool, Operation::Tan, &unit, 2),
            Generator::Exponential(unit) => self.raise_function(pool, Operation::Exp, &unit, 1),
            Generator::Root { base, order, negated } => {
                let polynomial = &self.bases[base].polynomial;
                let radicand = if negated { polynomial.neg() } else { polynomial.clone() };
                let radicand = self.raise_polynomial(pool, &radicand);
                return pool.power(radicand, n / Ratio::from_integer(i64::from(order)));
            }
            Generator::Logarithm { base } => {
                let Base { polynomial, sign, .. } = &self.bases[base];
                let argument = match sign {
                    Some(Sign::Negative) => self.raise_polynomial(pool, &polynomial.neg()),
                    _ => self.raise_polynomial(pool, polynomial),
                };
                let is_positive = sign.is_some() || polynomial.as_constant().is_some();
                let magnitude = if is_positive { argument } else { pool.apply(Operation::Abs, &[argument]) };
                pool.apply(Operation::Log, &[magnitude])
            }
            Generator::Opaque { operation, arguments } => {
                let arguments: Vec<Expr> = arguments.iter().map(|a| self.raise(pool, a)).collect();
                pool.apply(operation, &arguments)
            }
        };
        pool.power(base, n)
    }

    /// s′ = s − Σ v f
    fn raise_real_variable(&self, pool: &mut Pool, symbol: Symbol) -> Expr {
        let mut difference = pool.symbol(symbol);
        for drift in self.drifts_of(symbol) {
            let with = pool.symbol(drift.with);
            let speed = pool.integer(drift.speed);
            let part = pool.multiply(speed, with);
            difference = pool.subtract(difference, part);
        }
        difference
    }

    fn raise_function(&self, pool: &mut Pool, operation: Operation, unit: &Unit, halves: u32) -> Expr {
        let unit = Unit { divisor: unit.divisor * halves, ..unit.clone() };
        let argument = self.raise_unit(pool, &unit);
        pool.apply(operation, &[argument])
    }

    /// The angle or exponent that a generator is a function of.
    pub fn raise_unit(&self, pool: &mut Pool, unit: &Unit) -> Expr {
        self.raise(pool, &self.angle_of(unit))
    }
}

/// number · ∏ factors, the number left out if it is 1
fn product(pool: &mut Pool, number: &BigInt, factors: &[Expr]) -> Expr {
    let mut result = pool.number(Rational::from_integer(number.clone()));
    for &factor in factors {
        result = pool.multiply(result, factor);
    }
    result
}
