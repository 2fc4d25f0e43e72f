//! Search for an antiderivative: selects the method that fits the generators that depend on the
//! variable.

use super::rational::Rational;
use super::signs::Region;
use super::{Failure, normal_form};
use crate::expression::{Condition, Expr, Pool, Symbol};
use crate::normal::{Fraction, Generator, Tower, Trigonometry};

/// Limit on nested substitutions and integrations by parts.
pub(super) const DEPTH: u32 = 4;

/// The search for one antiderivative.
pub(super) struct Search<'a> {
    pub(super) pool: &'a mut Pool,
    pub(super) region: &'a Region,
}

/// An integrand in normal form.
pub(super) struct Integrand<'a> {
    pub(super) expression: Expr,
    pub(super) normal: Fraction,
    pub(super) tower: &'a mut Tower,
    pub(super) symbol: Symbol,
    /// The generators that depend on the variable.
    pub(super) generators: Vec<u32>,
    pub(super) conditions: &'a [Condition],
}

impl Integrand<'_> {
    /// Returns the generators that satisfy a test.
    pub(super) fn such_that(&self, test: impl Fn(&Generator) -> bool) -> Vec<u32> {
        self.generators.iter().copied().filter(|&g| test(self.tower.generator(g))).collect()
    }
}

impl Search<'_> {
    /// Returns an expression whose derivative may be the integrand; the caller has to check it.
    pub(super) fn antiderivative(
        &mut self,
        expression: Expr,
        symbol: Symbol,
        conditions: &[Condition],
        depth: u32,
    ) -> Result<Expr, Failure> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = match normal_form(self.pool, &mut tower, expression, conditions) {
            Ok(normal) => normal,
            Err(failure) if depth > 0 => {
                let found = self.through_circle(expression, symbol, conditions, depth - 1);
                return found.ok_or(failure);
            }
            Err(failure) => return Err(failure),
        };
        let generators = tower.generators_in(&normal, symbol);
        let mut integrand =
            Integrand { expression, normal, tower: &mut tower, symbol, generators, conditions };
        self.by_method(&mut integrand, depth)
    }

    fn by_method(&mut self, integrand: &mut Integrand, depth: u32) -> Result<Expr, Failure> {
        let is_variable = |generator: &Generator| matches!(generator, Generator::Variable(_));
        if integrand.such_that(is_variable).len() == integrand.generators.len() {
            return self.rational(integrand.tower, &integrand.normal, integrand.symbol);
        }
        if let Some(found) = self.by_unknown_functions(integrand, depth)? {
            return Ok(found);
        }
        if let Some(found) = self.exponential(integrand)? {
            return Ok(found);
        }
        if let Some(found) = self.symbolic_power(integrand)? {
            return Ok(found);
        }
        if let Some(found) = self.radical(integrand)? {
            return Ok(found);
        }
        if depth == 0 {
            return Err(self.not_integrable(integrand));
        }
        if let Some(found) = self.by_parts(integrand, depth - 1)? {
            return Ok(found);
        }
        if let Some(found) = self.by_substitution(integrand, depth - 1)? {
            return Ok(found);
        }
        if let Some(found) = self.by_half_tangent(integrand)? {
            return Ok(found);
        }
        Err(self.not_integrable(integrand))
    }

    pub(super) fn not_integrable(&mut self, integrand: &Integrand) -> Failure {
        let name = self.pool.symbol_name(integrand.symbol).to_string();
        let text = integrand.tower.raise(self.pool, &integrand.normal);
        format!("no antiderivative of `{}` with respect to `{name}` is known", self.pool.text(text)).into()
    }

    /// Integrates a rational function of the variable.
    pub(super) fn rational(
        &mut self,
        tower: &mut Tower,
        integrand: &Fraction,
        symbol: Symbol,
    ) -> Result<Expr, Failure> {
        let mut rational = Rational { pool: self.pool, tower, region: self.region, symbol };
        let parts = rational.antiderivative(integrand)?;
        let mut sum = self.pool.integer(0);
        for part in parts {
            let term = part.expression(self.pool);
            sum = self.pool.add(sum, term);
        }
        Ok(sum)
    }
}
