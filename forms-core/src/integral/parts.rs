//! Integration by parts: ∫ (u + v Lⁿ) = S Lⁿ + ∫ (u − n S Lⁿ⁻¹ L′) with S = ∫ v, for L a logarithm
//! or inverse function and u of lower degree in it.

use super::Failure;
use super::search::{Integrand, Search};
use crate::expression::Expr;
use crate::normal::Generator;

/// The highest power of a logarithm or inverse function; each step of the search lowers it by one.
const HIGHEST_POWER: i32 = 3;

impl Search<'_> {
    /// Returns an antiderivative, if the integrand is a polynomial in a logarithm or inverse
    /// function.
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
        let highest = terms.iter().map(|(exponents, _)| exponents[0]).max().unwrap_or(0);
        if !(1..=HIGHEST_POWER).contains(&highest) || terms.iter().any(|(exponents, _)| exponents[0] < 0) {
            return Ok(None);
        }
        let itself = crate::polynomial::Polynomial::variable(function).into();
        let logarithm = integrand.tower.raise(self.pool, &itself);
        let (mut v, mut rest) = (self.pool.integer(0), self.pool.integer(0));
        for (exponents, coefficient) in &terms {
            let coefficient = integrand.tower.raise(self.pool, coefficient);
            if exponents[0] == highest {
                v = coefficient;
            } else {
                let power = self.pool.power(logarithm, i64::from(exponents[0]).into());
                let term = self.pool.multiply(coefficient, power);
                rest = self.pool.add(rest, term);
            }
        }
        let outer = self.antiderivative(v, integrand.symbol, integrand.conditions, depth)?;
        let power = self.pool.power(logarithm, i64::from(highest).into());
        let slope = self.pool.derivative(power, integrand.symbol);
        let product = self.pool.multiply(outer, slope);
        let rest = self.pool.subtract(rest, product);
        let inner = self.antiderivative(rest, integrand.symbol, integrand.conditions, depth)?;
        let whole = self.pool.multiply(outer, power);
        Ok(Some(self.pool.add(whole, inner)))
    }
}
