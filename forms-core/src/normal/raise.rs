//! Raising: fractions become structured expressions again, for readers.

use super::base::{Base, Sign};
use super::fraction::Fraction;
use super::generator::{Generator, Unit};
use super::tower::Tower;
use crate::expression::{Expr, Operation, Pool, Rational, Symbol};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One, Signed};
use rustc_hash::FxHashMap;

/// Largest number of terms of a numerator that is searched for factors.
const LARGEST_FACTORED: usize = 60;

impl Tower {
    /// Raises the fraction to an expression: a number, factors of the numerator, factors of the
    /// denominator.
    pub fn raise(&self, pool: &mut Pool, fraction: &Fraction) -> Expr {
        Raising { tower: self, pool, generators: FxHashMap::default() }.fraction(fraction)
    }

    /// Raises the angle or exponent that a generator is a function of.
    pub fn raise_unit(&self, pool: &mut Pool, unit: &Unit) -> Expr {
        self.raise(pool, &self.angle_of(unit))
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
}

/// Expressions of one tower. A generator is raised once, since many others can depend on it.
struct Raising<'a> {
    tower: &'a Tower,
    pool: &'a mut Pool,
    /// Raised generators: for a root its radicand, for any other generator the generator itself.
    generators: FxHashMap<u32, Expr>,
}

impl Raising<'_> {
    fn fraction(&mut self, fraction: &Fraction) -> Expr {
        if fraction.is_zero() {
            return self.pool.integer(0);
        }
        let (content, parts) = self.tower.numerator_factors(&fraction.numerator);
        let p = Rational::new(content, fraction.divisor.clone());
        let negative = p.is_negative();
        let p = p.abs();
        let mut above: Vec<Expr> = parts.iter().map(|(part, n)| self.power(part, *n)).collect();
        let mut below: Vec<Expr> = Vec::new();
        for power in &fraction.factors {
            let polynomial = self.tower.factor_polynomial(power.factor);
            let raised = self.power(polynomial, power.exponent.unsigned_abs());
            if power.exponent < 0 { above.push(raised) } else { below.push(raised) }
        }
        let numerator = product(self.pool, p.numer(), &above);
        let denominator = product(self.pool, p.denom(), &below);
        let quotient = self.pool.divide(numerator, denominator);
        if negative { self.pool.negate(quotient) } else { quotient }
    }

    fn power(&mut self, polynomial: &Polynomial, exponent: u32) -> Expr {
        if let [(variable, 1)] = polynomial.monomial_content().as_slice()
            && polynomial.term_count() == 1
            && polynomial.leading_coefficient().is_one()
        {
            return self.generator_power(*variable, exponent);
        }
        let base = self.polynomial(polynomial);
        self.pool.power(base, Ratio::from_integer(i64::from(exponent)))
    }

    fn polynomial(&mut self, polynomial: &Polynomial) -> Expr {
        let mut sum = self.pool.integer(0);
        let mut terms: Vec<(Vec<(u32, u32)>, BigInt)> = polynomial.terms().collect();
        terms.sort_by_key(|(_, coefficient)| coefficient.is_negative());
        for (monomial, coefficient) in terms {
            let factors: Vec<Expr> =
                monomial.iter().map(|&(variable, n)| self.generator_power(variable, n)).collect();
            let magnitude = product(self.pool, &coefficient.abs(), &factors);
            let term = if coefficient.is_negative() { self.pool.negate(magnitude) } else { magnitude };
            sum = self.pool.add(sum, term);
        }
        sum
    }

    fn generator_power(&mut self, variable: u32, exponent: u32) -> Expr {
        let tower = self.tower;
        let n = Ratio::from_integer(i64::from(exponent));
        let order = match tower.generator(variable) {
            Generator::Root { order, .. } => *order,
            _ => 1,
        };
        let base = match self.generators.get(&variable) {
            Some(&known) => known,
            None => {
                let base = self.generator_base(tower.generator(variable));
                self.generators.insert(variable, base);
                base
            }
        };
        self.pool.power(base, n / Ratio::from_integer(i64::from(order)))
    }

    /// Raises a generator, or the radicand of a root.
    fn generator_base(&mut self, generator: &Generator) -> Expr {
        match generator {
            Generator::Variable(symbol) => self.real_variable(*symbol),
            Generator::Pi => self.pool.pi(),
            Generator::Chord { sides, sine } => {
                let pool = &mut *self.pool;
                let (part, pi, two) = (pool.ratio(2, i64::from(*sides)), pool.pi(), pool.integer(2));
                let angle = pool.multiply(part, pi);
                let half = pool.apply(if *sine { Operation::Sin } else { Operation::Cos }, &[angle]);
                pool.multiply(two, half)
            }
            Generator::Jet { function, orders, arguments } => {
                let arguments: Vec<Expr> = arguments.iter().map(|a| self.fraction(a)).collect();
                self.pool.jet(*function, orders, &arguments)
            }
            Generator::Cosine(unit) => self.function(Operation::Cos, unit, 1),
            Generator::Sine(unit) => self.function(Operation::Sin, unit, 1),
            Generator::HalfTangent(unit) => self.function(Operation::Tan, unit, 2),
            Generator::Exponential(unit) => self.function(Operation::Exp, unit, 1),
            Generator::Root { base, negated, .. } => {
                let polynomial = &self.tower.bases[*base].polynomial;
                if *negated { self.polynomial(&polynomial.neg()) } else { self.polynomial(polynomial) }
            }
            Generator::Logarithm { base } => {
                let Base { polynomial, sign, .. } = &self.tower.bases[*base];
                let argument = match sign {
                    Some(Sign::Negative) => self.polynomial(&polynomial.neg()),
                    _ => self.polynomial(polynomial),
                };
                let is_positive = sign.is_some() || polynomial.as_constant().is_some();
                let magnitude =
                    if is_positive { argument } else { self.pool.apply(Operation::Abs, &[argument]) };
                self.pool.apply(Operation::Log, &[magnitude])
            }
            Generator::Opaque { operation, arguments } => {
                let arguments: Vec<Expr> = arguments.iter().map(|a| self.fraction(a)).collect();
                self.pool.apply(*operation, &arguments)
            }
        }
    }

    /// s′ = s − Σ v f
    fn real_variable(&mut self, symbol: Symbol) -> Expr {
        let pool = &mut *self.pool;
        let mut difference = pool.symbol(symbol);
        for drift in self.tower.drifts_of(symbol) {
            let with = pool.symbol(drift.with);
            let speed = pool.integer(drift.speed);
            let part = pool.multiply(speed, with);
            difference = pool.subtract(difference, part);
        }
        difference
    }

    fn function(&mut self, operation: Operation, unit: &Unit, halves: u32) -> Expr {
        let unit = Unit { divisor: unit.divisor * halves, ..unit.clone() };
        let argument = self.fraction(&self.tower.angle_of(&unit));
        self.pool.apply(operation, &[argument])
    }
}

/// number · ∏ factors, without the number if it is 1
fn product(pool: &mut Pool, number: &BigInt, factors: &[Expr]) -> Expr {
    let mut result = pool.number(Rational::from_integer(number.clone()));
    for &factor in factors {
        result = pool.multiply(result, factor);
    }
    result
}
