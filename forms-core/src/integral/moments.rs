//! Integrals by moments: ∫ xᵏ h(mκx) dx, each computed once, and ∫₀¹ tᵖ dt.

use super::harmonic::{Harmonic, products_to_sums};
use super::{Failure, normal_form};
use crate::expression::{Condition, Expr, Operation, Pool, Rational, Symbol};
use crate::normal::{Fraction, Generator, Tower, Trigonometry};
use num_rational::Ratio;
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// The highest power of a sine, cosine or variable that is integrated.
pub(super) const HIGHEST_POWER: u32 = 64;

/// Returns the integral of Σ c xᵏ cosᵖ(κx) sin^q(κx) from one bound to another, if the integrand is
/// of that kind, and an antiderivative.
pub(super) fn by_moments(
    pool: &mut Pool,
    tower: &mut Tower,
    normal: &Fraction,
    variable: Symbol,
    bounds: (Expr, Expr),
) -> Result<(Expr, Expr), Failure> {
    let terms = tower.terms_in(pool, normal, variable)?;
    let frequency = match &terms.frequency {
        Some(frequency) => tower.raise(pool, frequency),
        None => pool.integer(1),
    };
    let mut range = Range { pool, variable, bounds, frequency, moments: FxHashMap::default() };
    let mut integral = range.pool.integer(0);
    let mut antiderivative = integral;
    for term in terms.terms {
        if term.power.max(term.cosines).max(term.sines) > HIGHEST_POWER {
            return Err(format!("a power above the limit of {HIGHEST_POWER}").into());
        }
        let coefficient = tower.raise(range.pool, &term.coefficient);
        for (harmonic, share) in products_to_sums(term.cosines, term.sines) {
            let share = range.pool.number(share);
            let (moment, before) = range.moment(term.power, harmonic);
            for (sum, part) in [(&mut integral, moment), (&mut antiderivative, before)] {
                let scaled = range.pool.multiply(share, part);
                let product = range.pool.multiply(coefficient, scaled);
                *sum = range.pool.add(*sum, product);
            }
        }
    }
    Ok((integral, antiderivative))
}

/// The moments ∫ xᵏ h(mκx) dx over one range, each computed once.
struct Range<'a> {
    pool: &'a mut Pool,
    variable: Symbol,
    bounds: (Expr, Expr),
    frequency: Expr,
    /// Each moment with its antiderivative.
    moments: FxHashMap<(u32, Harmonic), (Expr, Expr)>,
}

impl Range<'_> {
    fn moment(&mut self, power: u32, harmonic: Harmonic) -> (Expr, Expr) {
        if let Some(&known) = self.moments.get(&(power, harmonic)) {
            return known;
        }
        let antiderivative = self.antiderivative(power, harmonic);
        let at = |pool: &mut Pool, place: Expr| {
            let values = [(self.variable, place)].into_iter().collect();
            pool.substitute(antiderivative, &values)
        };
        let (upper, lower) = (at(self.pool, self.bounds.1), at(self.pool, self.bounds.0));
        let moment = (self.pool.subtract(upper, lower), antiderivative);
        self.moments.insert((power, harmonic), moment);
        moment
    }

    /// xᵏ⁺¹/(k+1); xᵏ sin(ωx)/ω − k/ω ∫xᵏ⁻¹ sin(ωx); −xᵏ cos(ωx)/ω + k/ω ∫xᵏ⁻¹ cos(ωx), with ω =
    /// mκ.
    fn antiderivative(&mut self, power: u32, harmonic: Harmonic) -> Expr {
        let x = self.pool.symbol(self.variable);
        let Harmonic::Wave { multiple, is_sine } = harmonic else {
            let raised = self.pool.power(x, Ratio::from_integer(i64::from(power) + 1));
            let share = self.pool.ratio(1, i64::from(power) + 1);
            return self.pool.multiply(share, raised);
        };
        let m = self.pool.integer(i64::from(multiple));
        let omega = self.pool.multiply(m, self.frequency);
        let angle = self.pool.multiply(omega, x);
        let outer = if is_sine { Operation::Cos } else { Operation::Sin };
        let wave = self.pool.apply(outer, &[angle]);
        let raised = self.pool.power(x, Ratio::from_integer(i64::from(power)));
        let product = self.pool.multiply(raised, wave);
        let mut result = self.pool.divide(product, omega);
        if is_sine {
            result = self.pool.negate(result);
        }
        if power == 0 {
            return result;
        }
        let inner = self.antiderivative(power - 1, Harmonic::Wave { multiple, is_sine: !is_sine });
        let k = self.pool.number(Rational::from_integer(power.into()));
        let share = self.pool.divide(k, omega);
        let rest = self.pool.multiply(share, inner);
        if is_sine { self.pool.add(result, rest) } else { self.pool.subtract(result, rest) }
    }
}

/// Returns Σ c/(p + 1) for an integrand Σ c tᵖ, if it has this form: ∫₀¹ tᵖ dt, and for p < −1 its
/// finite part.
///
/// # Errors
/// If a term has p = −1.
pub(crate) fn power_integral(
    pool: &mut Pool,
    integrand: Expr,
    variable: Symbol,
    conditions: &[Condition],
) -> Result<Option<Expr>, String> {
    let mut tower = Tower::new(Trigonometry::Circle);
    let Ok(normal) = normal_form(pool, &mut tower, integrand, conditions) else { return Ok(None) };
    let t = tower.variable_number(variable);
    let generators = tower.generators_in(&normal, variable);
    let mut steps = Vec::new();
    for &generator in &generators {
        match tower.generator(generator) {
            Generator::Variable(_) => steps.push(Ratio::from_integer(1)),
            Generator::Root { order, .. } => {
                let radicand = tower.radicand(generator).map(|(radicand, _)| radicand);
                if radicand != Some(crate::polynomial::Polynomial::variable(t)) {
                    return Ok(None);
                }
                steps.push(Ratio::new(1, i64::from(*order)));
            }
            _ => return Ok(None),
        }
    }
    let Some(terms) = tower.laurent_terms(&normal, &generators) else { return Ok(None) };
    let mut sum = pool.integer(0);
    for (exponents, coefficient) in terms {
        let power = exponents
            .iter()
            .zip(&steps)
            .fold(Ratio::from_integer(1), |sum, (&exponent, step)| sum + step * i64::from(exponent));
        if power.is_zero() {
            return Err(
                "a term of a coefficient is homogeneous of degree -k, where k is the degree of the form"
                    .into(),
            );
        }
        let share = pool.ratio(*power.denom(), *power.numer());
        let coefficient = tower.raise(pool, &coefficient);
        let term = pool.multiply(share, coefficient);
        sum = pool.add(sum, term);
    }
    Ok(Some(sum))
}
