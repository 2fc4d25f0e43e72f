//! Decomposition of a fraction into a sum of c · xᵏ cosᵖ(κx) sin^q(κx) in one variable, if there is
//! one.

use super::fraction::Fraction;
use super::generator::{Generator, Unit};
use super::tower::Tower;
use crate::expression::{Pool, Symbol};
use crate::polynomial::Polynomial;

/// coefficient · xᵏ cosᵖ(κx) sin^q(κx)
#[derive(Clone, Debug)]
pub struct Term {
    /// Factor that does not depend on x.
    pub coefficient: Fraction,
    /// k
    pub power: u32,
    /// p
    pub cosines: u32,
    /// q
    pub sines: u32,
}

/// Sum of terms, with the frequency κ that they share if any of them oscillates.
#[derive(Clone, Debug)]
pub struct Terms {
    /// The terms.
    pub terms: Vec<Term>,
    /// κ
    pub frequency: Option<Fraction>,
}

impl Tower {
    /// Splits the fraction by powers of a variable and of one sine and cosine.
    ///
    /// # Errors
    /// The reason, which names the other part that depends on the variable.
    pub fn terms_in(&mut self, pool: &Pool, fraction: &Fraction, symbol: Symbol) -> Result<Terms, String> {
        let name = pool.symbol_name(symbol).to_string();
        let fraction = &self.expanded(fraction).map_err(|_| "the integrand is too large".to_string())?;
        let factors: Vec<Polynomial> =
            fraction.factors.iter().map(|power| self.factor_polynomial(power.factor).clone()).collect();
        if factors.iter().any(|factor| factor.variables().into_iter().any(|v| self.depends(v, symbol))) {
            return Err(format!("the denominator depends on `{name}`"));
        }
        let x = self.variable_of(Generator::Variable(symbol));
        let unit = self.oscillation(pool, &fraction.numerator, symbol, x)?;
        let variables = match &unit {
            Some(unit) => vec![
                x,
                self.variable_of(Generator::Cosine(unit.clone())),
                self.variable_of(Generator::Sine(unit.clone())),
            ],
            None => vec![x],
        };
        let terms = fraction
            .numerator
            .split_by(&variables)
            .into_iter()
            .map(|(exponents, numerator)| Term {
                coefficient: self.cancel(numerator, fraction.divisor.clone(), fraction.factors.clone()),
                power: exponents[0],
                cosines: exponents.get(1).copied().unwrap_or(0),
                sines: exponents.get(2).copied().unwrap_or(0),
            })
            .collect();
        let frequency = unit.map(|unit| self.frequency(&unit, x));
        Ok(Terms { terms, frequency })
    }

    /// Returns the single unit κx whose sine or cosine occurs, where κ is a number times a power of
    /// π.
    fn oscillation(
        &self,
        pool: &Pool,
        numerator: &Polynomial,
        symbol: Symbol,
        x: u32,
    ) -> Result<Option<Unit>, String> {
        let name = pool.symbol_name(symbol);
        let mut found: Option<Unit> = None;
        for variable in numerator.variables() {
            if variable == x || !self.depends(variable, symbol) {
                continue;
            }
            let (Generator::Cosine(unit) | Generator::Sine(unit)) = self.generator(variable) else {
                return Err(format!("the integrand is not polynomial or trigonometric in `{name}`"));
            };
            let number = |&(v, _): &(u32, u32)| v == x || *self.generator(v) == Generator::Pi;
            let linear = unit.quantity.monomial.contains(&(x, 1));
            if !linear || !unit.quantity.factors.is_empty() || !unit.quantity.monomial.iter().all(number) {
                return Err(format!("an angle is not a constant multiple of `{name}`"));
            }
            match &found {
                Some(known) if known != unit => {
                    return Err(format!("incommensurable angles in `{name}`"));
                }
                _ => found = Some(unit.clone()),
            }
        }
        Ok(found)
    }

    /// Returns κ of the unit κx.
    fn frequency(&self, unit: &Unit, x: u32) -> Fraction {
        let quantity = self.quantity(&unit.quantity);
        let numerator = quantity.numerator.divide_by_monomial(&[(x, 1)]).unwrap_or(quantity.numerator);
        self.cancel(numerator, unit.divisor.into(), quantity.factors)
    }

    /// Whether a generator depends on a real variable.
    pub(super) fn depends(&self, variable: u32, symbol: Symbol) -> bool {
        match self.generator(variable) {
            Generator::Variable(other) => *other == symbol,
            Generator::Pi | Generator::Chord { .. } => false,
            Generator::Jet { arguments, .. } | Generator::Opaque { arguments, .. } => {
                arguments.iter().any(|argument| self.fraction_depends(argument, symbol))
            }
            Generator::Cosine(unit)
            | Generator::Sine(unit)
            | Generator::HalfTangent(unit)
            | Generator::Exponential(unit) => self.fraction_depends(&self.quantity(&unit.quantity), symbol),
            Generator::Root { base, .. } | Generator::Logarithm { base } => {
                let polynomial = &self.bases[*base].polynomial;
                polynomial.variables().into_iter().any(|v| self.depends(v, symbol))
            }
        }
    }

    fn fraction_depends(&self, fraction: &Fraction, symbol: Symbol) -> bool {
        let below = fraction.factors.iter().map(|power| self.factor_polynomial(power.factor));
        std::iter::once(&fraction.numerator)
            .chain(below)
            .any(|polynomial| polynomial.variables().into_iter().any(|v| self.depends(v, symbol)))
    }
}
