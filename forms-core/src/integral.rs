//! Definite integrals over one range: a verified antiderivative, and its values at the ends.
//!
//! ```text
//! integrand ─ normal form under the conditions ─┬─ polynomial and waves of one frequency ─▶ moments
//!                                               └─ search: partial fractions, exponentials, roots, substitution,
//!                                                     parts, derivatives of expressions in unknown functions
//!                                                     ─▶ A(x) ─ A′ = f? ─ continuous on [a, b]? ─▶ A(b) − A(a)
//!           |q| ─▶ pieces between the zeros of q
//!           unknown functions, no derivative ─▶ products ─▶ primitives Φ(b) − Φ(a)
//! ```
//! The search need not be rigorous: an antiderivative is accepted only by its derivative and its
//! continuity. If it is continuous on the closed range and differentiable inside, with A′ = f, it
//! gives the integral, also an improper one.

mod bernstein;
mod ends;
mod exponential;
mod half_tangent;
mod harmonic;
mod improper;
mod known_sign;
mod moments;
mod parts;
mod pieces;
mod power;
mod primitive;
mod radical;
mod range;
mod rational;
mod search;
mod signs;
mod substitution;
mod unknown;
mod wave;
mod zeros;

pub(crate) use known_sign::Strictness;
pub(crate) use moments::power_integral;
pub(crate) use signs::Region;

use crate::assume::{Assumptions, Cases};
use crate::expression::{Condition, Expr, Pool};
use crate::normal::{Fraction, Tower, Trigonometry, normalise};

/// Reason why there is no antiderivative, in words.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failure(pub(crate) String);

impl From<String> for Failure {
    fn from(reason: String) -> Self {
        Failure(reason)
    }
}

impl From<&str> for Failure {
    fn from(reason: &str) -> Self {
        Failure(reason.to_string())
    }
}

/// Returns the normal form where the conditions hold. Roots in it must have a single sign, and no
/// root of a sine or cosine is allowed to remain.
fn normal_form(
    pool: &mut Pool,
    tower: &mut Tower,
    expression: Expr,
    conditions: &[Condition],
) -> Result<Fraction, Failure> {
    let normal = any_normal_form(pool, tower, expression, conditions)?;
    if tower.trigonometry() != Trigonometry::Circle {
        return Err("a root of a trigonometric expression remains".into());
    }
    if !tower.holds_everywhere() {
        return Err("its normal form does not hold where a nested radical divides by zero".into());
    }
    Ok(normal)
}

/// Returns the expression through its normal form, in which powers of a root are combined;
/// unchanged if it has no normal form.
fn tidied(pool: &mut Pool, expression: Expr, conditions: &[Condition]) -> Expr {
    let mut tower = Tower::new(Trigonometry::Circle);
    match normal_form(pool, &mut tower, expression, conditions) {
        Ok(normal) => tower.raise(pool, &normal),
        Err(_) => expression,
    }
}

/// Returns the normal form, possibly in half-angle tangents.
fn any_normal_form(
    pool: &mut Pool,
    tower: &mut Tower,
    expression: Expr,
    conditions: &[Condition],
) -> Result<Fraction, Failure> {
    let assumptions = Assumptions::new(pool, conditions);
    let mut given = Vec::new();
    let prepared = loop {
        tower.fix_signs(&given);
        let prepared = normalise(tower, pool, &[expression])?;
        if prepared.open.is_empty() {
            break prepared;
        }
        match assumptions.cases(tower, pool, &[expression], &given)? {
            Cases::Signs(cases) if cases.len() == 1 => given.extend(&cases[0]),
            _ => return Err("the sign of a radicand is not known".into()),
        }
    };
    Ok(prepared.exact(tower, pool)?.remove(0))
}
