//! Definite integrals over one range: integrand in normal form, antiderivative by terms, values at the ends.
//!
//! ```text
//! integrand ─ normal form under the conditions ─▶ Σ c xᵏ cosᵖ(κx) sin^q(κx)
//!     ─ products to sums ─▶ Σ c xᵏ cos(mκx), xᵏ sin(mκx) ─ by parts ─▶ F(b) − F(a)
//! ```
//! Exact, with bounds that may be any expressions free of the variable. An integrand that is not of this kind
//! is refused with the reason.

mod harmonic;

use crate::assume::{Assumptions, Cases};
use crate::expression::{Condition, Expr, Operation, Pool, Rational, Symbol};
use crate::normal::{Fraction, Obstacle, Tower, Trigonometry, normalise};
use harmonic::{Harmonic, products_to_sums};
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// The highest power of a sine, cosine or variable that is integrated.
const HIGHEST_POWER: u32 = 64;

/// The integral of an expression over one variable from one bound to another.
///
/// # Errors
/// Says in words why it cannot be integrated: a denominator or root that depends on the variable, say.
pub(crate) fn definite_integral(
    pool: &mut Pool,
    integrand: Expr,
    variable: Symbol,
    bounds: (Expr, Expr),
    conditions: &[Condition],
) -> Result<Expr, String> {
    let mut tower = Tower::new(Trigonometry::Circle);
    let normal = normal_form(pool, &mut tower, integrand, conditions)?;
    let terms = tower.terms_in(pool, &normal, variable)?;
    let frequency = match &terms.frequency {
        Some(frequency) => tower.raise(pool, frequency),
        None => pool.integer(1),
    };
    let mut range = Range { pool, variable, bounds, frequency, moments: FxHashMap::default() };
    let mut integral = range.pool.integer(0);
    for term in terms.terms {
        if term.power.max(term.cosines).max(term.sines) > HIGHEST_POWER {
            return Err(format!("a power above the limit of {HIGHEST_POWER}"));
        }
        let coefficient = tower.raise(range.pool, &term.coefficient);
        for (harmonic, share) in products_to_sums(term.cosines, term.sines) {
            let moment = range.moment(term.power, harmonic);
            let share = range.pool.number(share);
            let scaled = range.pool.multiply(share, moment);
            let product = range.pool.multiply(coefficient, scaled);
            integral = range.pool.add(integral, product);
        }
    }
    Ok(integral)
}

/// The normal form where the conditions hold; roots in it must have one sign only.
fn normal_form(
    pool: &mut Pool,
    tower: &mut Tower,
    integrand: Expr,
    conditions: &[Condition],
) -> Result<Fraction, String> {
    let assumptions = Assumptions::new(pool, conditions);
    let reason = |obstacle: Obstacle| match obstacle {
        Obstacle::DivisionByZero => "it divides by zero".to_string(),
        Obstacle::Outside(part) | Obstacle::TooLarge(part) => part,
        Obstacle::Refine => "its radicands could not be factored".to_string(),
    };
    let mut given = Vec::new();
    let prepared = loop {
        tower.fix_signs(&given);
        let prepared = normalise(tower, pool, &[integrand]).map_err(reason)?;
        if prepared.open.is_empty() {
            break prepared;
        }
        match assumptions.cases(tower, pool, &[integrand], &given).map_err(reason)? {
            Cases::Signs(cases) if cases.len() == 1 => given.extend(&cases[0]),
            _ => return Err("the sign of something under a root is not known".into()),
        }
    };
    if tower.trigonometry() != Trigonometry::Circle {
        return Err("a root of a trigonometric expression remains".into());
    }
    Ok(prepared.exact(tower, pool).map_err(reason)?.remove(0))
}

/// ∫ xᵏ h(mκx) dx over one range, each moment once.
struct Range<'a> {
    pool: &'a mut Pool,
    variable: Symbol,
    bounds: (Expr, Expr),
    frequency: Expr,
    moments: FxHashMap<(u32, Harmonic), Expr>,
}

impl Range<'_> {
    fn moment(&mut self, power: u32, harmonic: Harmonic) -> Expr {
        if let Some(&known) = self.moments.get(&(power, harmonic)) {
            return known;
        }
        let antiderivative = self.antiderivative(power, harmonic);
        let at = |pool: &mut Pool, place: Expr| {
            let values = [(self.variable, place)].into_iter().collect();
            pool.substitute(antiderivative, &values)
        };
        let (upper, lower) = (at(self.pool, self.bounds.1), at(self.pool, self.bounds.0));
        let moment = self.pool.subtract(upper, lower);
        self.moments.insert((power, harmonic), moment);
        moment
    }

    /// xᵏ⁺¹/(k+1); xᵏ sin(ωx)/ω − k/ω ∫xᵏ⁻¹ sin(ωx); −xᵏ cos(ωx)/ω + k/ω ∫xᵏ⁻¹ cos(ωx), with ω = mκ.
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
