//! Partial integration: ∫ (u + v L) = S L + ∫ (u − S L′) with S = ∫ v, for L a logarithm or inverse function.

use super::Failure;
use super::search::{Integrand, Search};
use crate::expression::{Expr, Pool};
use crate::normal::{Fraction, Generator};

impl Search<'_> {
    /// An antiderivative, if one logarithm or inverse function occurs to the first power.
    pub(super) fn by_parts(
        &mut self,
        integrand: &mut Integrand,
        depth: u32,
    ) -> Result<Option<Expr>, Failure> {
        let is_function = |generator: &Generator| {
            matches!(generator, Generator::Opaque { .. } | Generator::Logarithm { .. })
        };
        let functions = integrand.such_that(is_function);
        let Some(&function) = functions.first() else { return Ok(None) };
        let Some(terms) = integrand.tower.laurent_terms(&integrand.normal, &[function]) else {
            return Ok(None);
        };
        let share = |power: i32, pool: &mut Pool| {
            let term = terms.iter().find(|(exponents, _)| exponents[0] == power);
            integrand.tower.raise(pool, term.map_or(&Fraction::zero(), |(_, coefficient)| coefficient))
        };
        let (u, v) = (share(0, self.pool), share(1, self.pool));
        if terms.iter().any(|(exponents, _)| !(0..=1).contains(&exponents[0])) {
            return Ok(None);
        }
        let itself = crate::polynomial::Polynomial::variable(function).into();
        let logarithm = integrand.tower.raise(self.pool, &itself);
        let outer = self.antiderivative(v, integrand.symbol, integrand.conditions, depth)?;
        let derivative = self.pool.derivative(logarithm, integrand.symbol);
        let product = self.pool.multiply(outer, derivative);
        let rest = self.pool.subtract(u, product);
        let inner = self.antiderivative(rest, integrand.symbol, integrand.conditions, depth)?;
        let whole = self.pool.multiply(outer, logarithm);
        Ok(Some(self.pool.add(whole, inner)))
    }
}
