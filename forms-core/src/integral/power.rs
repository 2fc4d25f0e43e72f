//! Powers with symbolic exponents: ∫ xᵏ g^ν dx for a linear g = αx + β, g^ν = exp(ν log g).
//!
//! ```text
//! ∫ gʲ g^ν dx = g^μ/(αμ),   μ = ν + j + 1;   g^μ is continuous where g ≥ 0 if μ > 0, with the value 0 at g = 0
//! ```

use super::known_sign::Strictness;
use super::search::{Integrand, Search};
use super::signs::Region;
use super::{Failure, normal_form};
use crate::assume::is_at_most;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, Symbol};
use crate::normal::{Fraction, Generator, Tower, Trigonometry};
use rustc_hash::FxHashMap;

/// Highest power of the variable next to the symbolic power that is expanded.
const HIGHEST_POWER: i32 = 32;

/// The linear function that is raised to a power: g or −g, whichever is positive, and its slope.
struct Base {
    positive: Expr,
    slope: Expr,
    /// The value of the function at zero, if that is not zero itself.
    offset: Option<Expr>,
}

impl Search<'_> {
    /// Returns an antiderivative of a sum of products of a power of the variable and symbolic
    /// powers of one linear function.
    pub(super) fn symbolic_power(&mut self, integrand: &mut Integrand) -> Result<Option<Expr>, Failure> {
        let x = integrand.tower.variable_number(integrand.symbol);
        let mut generators = vec![x];
        let mut exponents = Vec::new();
        let mut number = None;
        for &generator in integrand.generators.iter().filter(|generator| **generator != x) {
            let Some((base, exponent)) = power_of(integrand.tower, generator, integrand.symbol) else {
                return Ok(None);
            };
            if *number.get_or_insert(base) != base {
                return Ok(None);
            }
            generators.push(generator);
            exponents.push(exponent);
        }
        let Some(number) = number else { return Ok(None) };
        let Some(terms) = integrand.tower.laurent_terms(&integrand.normal, &generators) else {
            return Ok(None);
        };
        let Some(base) = self.base(integrand, number, x)? else { return Ok(None) };
        let mut sum = self.pool.integer(0);
        for (powers, coefficient) in terms {
            let mut exponent = self.pool.integer(0);
            for (share, times) in exponents.iter().zip(&powers[1..]) {
                let share = integrand.tower.raise(self.pool, share);
                let times = self.pool.integer(i64::from(*times));
                let part = self.pool.multiply(times, share);
                exponent = self.pool.add(exponent, part);
            }
            let coefficient = integrand.tower.raise(self.pool, &coefficient);
            let Some(integral) = self.expanded(&base, powers[0], exponent) else { return Ok(None) };
            let term = self.pool.multiply(coefficient, integral);
            sum = self.pool.add(sum, term);
        }
        Ok(Some(sum))
    }

    fn base(&mut self, integrand: &mut Integrand, number: usize, x: u32) -> Result<Option<Base>, Failure> {
        let tower = &mut *integrand.tower;
        let polynomial = tower.base(number).polynomial.clone();
        let function = tower.rational_function(&polynomial.clone().into(), x)?;
        if function.numerator.degree() != 1 || !function.denominator.is_empty() {
            return Ok(None);
        }
        let linear = tower.raise(self.pool, &polynomial.into());
        let slope = tower.raise(self.pool, &function.numerator.coefficient(1));
        let offset = function.numerator.coefficient(0);
        let offset = (!offset.is_zero()).then(|| tower.raise(self.pool, &offset));
        let zero = self.pool.integer(0);
        if is_at_most(self.pool, zero, linear, integrand.conditions) {
            return Ok(Some(Base { positive: linear, slope, offset }));
        }
        if !is_at_most(self.pool, linear, zero, integrand.conditions) {
            return Ok(None);
        }
        let (positive, slope) = (self.pool.negate(linear), self.pool.negate(slope));
        let offset = offset.map(|offset| self.pool.negate(offset));
        Ok(Some(Base { positive, slope, offset }))
    }

    /// ∫ xᵏ g^ν dx with x = (g − β)/α: Σⱼ C(k, j) (−β)ᵏ⁻ʲ α⁻ᵏ ∫ gʲ g^ν dx.
    fn expanded(&mut self, base: &Base, power: i32, exponent: Expr) -> Option<Expr> {
        if power > HIGHEST_POWER || (power < 0 && base.offset.is_some()) {
            return None;
        }
        let scale = self.pool.power(base.slope, (-i64::from(power)).into());
        let Some(offset) = base.offset else {
            let whole = self.power_integral(base, power, exponent);
            return Some(self.pool.multiply(scale, whole));
        };
        let negated = self.pool.negate(offset);
        let mut sum = self.pool.integer(0);
        let mut binomial = 1_i64;
        for j in 0..=power {
            let lower = self.pool.power(negated, i64::from(power - j).into());
            let choices = self.pool.integer(binomial);
            let factor = self.pool.multiply(choices, lower);
            let part = self.power_integral(base, j, exponent);
            let term = self.pool.multiply(factor, part);
            sum = self.pool.add(sum, term);
            binomial = binomial * i64::from(power - j) / i64::from(j + 1);
        }
        Some(self.pool.multiply(scale, sum))
    }

    /// ∫ gʲ g^ν dx = g^μ/(αμ)
    fn power_integral(&mut self, base: &Base, power: i32, exponent: Expr) -> Expr {
        let raised = self.pool.integer(i64::from(power) + 1);
        let exponent = self.pool.add(exponent, raised);
        let logarithm = self.pool.apply(Operation::Log, &[base.positive]);
        let argument = self.pool.multiply(exponent, logarithm);
        let value = self.pool.apply(Operation::Exp, &[argument]);
        let divisor = self.pool.multiply(base.slope, exponent);
        self.pool.divide(value, divisor)
    }
}

/// Returns the base and ν of exp(ν log|g|), if the generator has this form and ν does not depend on
/// the variable.
fn power_of(tower: &mut Tower, generator: u32, symbol: Symbol) -> Option<(usize, Fraction)> {
    let argument = tower.argument(generator)?;
    let moving = tower.generators_in(&argument, symbol);
    let &[logarithm] = moving.as_slice() else { return None };
    let Generator::Logarithm { base } = *tower.generator(logarithm) else { return None };
    let terms = tower.laurent_terms(&argument, &[logarithm])?;
    match terms.as_slice() {
        [(powers, exponent)] if powers == &[1] => Some((base, exponent.clone())),
        _ => None,
    }
}

/// Returns μ and g of a power g^μ as it is written, exp(μ log g).
fn as_power(pool: &Pool, part: Expr) -> Option<(Expr, Expr)> {
    let Node::Apply(Operation::Exp, argument) = pool.node(part) else { return None };
    let Node::Multiply(exponent, logarithm) = pool.node(argument[0]) else { return None };
    let Node::Apply(Operation::Log, base) = pool.node(*logarithm) else { return None };
    Some((*exponent, base[0]))
}

impl Region {
    /// Returns the expressions whose continuity implies the continuity of an expression: a power
    /// g^μ with g ≥ 0 and μ > 0 is continuous where g and μ are.
    pub(super) fn without_powers(&self, pool: &mut Pool, expression: Expr) -> Vec<Expr> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        let mut parts = Vec::new();
        let one = pool.integer(1);
        for part in pool.reachable(&[expression]) {
            let Some((exponent, base)) = as_power(pool, part) else { continue };
            let rises = self.sign(pool, exponent) == Some((true, Strictness::Strict));
            if rises && matches!(self.sign(pool, base), Some((true, _))) {
                images.insert(part, one);
                parts.extend([exponent, base]);
            }
        }
        parts.push(pool.replace(expression, &images));
        parts
    }

    /// Returns the value of an antiderivative with g^μ = 0 where g = 0, and g > 0 as a condition
    /// where that is not known.
    pub(super) fn with_powers_of_zero(
        &self,
        pool: &mut Pool,
        value: Expr,
    ) -> Result<(Expr, Vec<Condition>), Failure> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        let mut conditions = Vec::new();
        let zero = pool.integer(0);
        for part in pool.reachable(&[value]) {
            let Some((_, base)) = as_power(pool, part) else { continue };
            let mut tower = Tower::new(Trigonometry::Circle);
            if normal_form(pool, &mut tower, base, &self.conditions).is_ok_and(|normal| normal.is_zero()) {
                images.insert(part, zero);
                continue;
            }
            match self.sign(pool, base) {
                Some((true, Strictness::Strict)) => {}
                Some((true, _)) if self.varies(pool, base) => {}
                _ if self.varies(pool, base) => {
                    return Err(format!("it is not known that `{}` is positive", pool.text(base)).into());
                }
                _ => conditions.push(Condition { left: base, relation: Relation::Greater, right: zero }),
            }
        }
        Ok((pool.replace(value, &images), conditions))
    }
}
