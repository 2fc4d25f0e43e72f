//! Definite integrals from antiderivatives: the check of the derivative, the continuity over the
//! range, and the values at the ends.

use super::known_sign::Strictness;
use super::moments::by_moments;
use super::search::Search;
use super::signs::Region;
use super::{Failure, any_normal_form, normal_form};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, Substitution, Symbol};
use crate::normal::{Tower, Trigonometry};
use rustc_hash::FxHashMap;

/// An integral and the conditions on parameters under which it has this value.
#[derive(Clone, Debug)]
pub(crate) struct Integral {
    /// The value of the integral.
    pub(crate) value: Expr,
    /// Conditions on the parameters.
    pub(crate) conditions: Vec<Condition>,
    /// An antiderivative for the whole range, if there is one.
    pub(crate) antiderivative: Option<Expr>,
}

impl Region {
    /// Returns the first of some conditions that is not known to hold all over the ranges; the
    /// known ones are added to the assumptions. Boundaries, and conditions that something is not
    /// zero, are left to the continuity of the antiderivative. This gives no information about an
    /// unknown function: where one occurs, conditions have to hold on the closed ranges.
    pub(crate) fn unmet(
        &mut self,
        pool: &mut Pool,
        integrand: Expr,
        conditions: &[Condition],
    ) -> Option<Condition> {
        let strictness =
            if self.has_unknowns(pool, integrand) { Strictness::Strict } else { Strictness::Weak };
        self.first_unmet(pool, conditions, strictness)
    }

    /// Returns the first of some conditions that is not known to hold over the ranges, including
    /// their boundaries if `strictness` is strict.
    pub(crate) fn first_unmet(
        &mut self,
        pool: &mut Pool,
        conditions: &[Condition],
        strictness: Strictness,
    ) -> Option<Condition> {
        for &condition in conditions {
            if !self.varies(pool, condition.left) && !self.varies(pool, condition.right) {
                continue;
            }
            let difference = pool.subtract(condition.left, condition.right);
            let sign = self.sign(pool, difference);
            let is_far =
                strictness == Strictness::Weak || sign.is_some_and(|sign| sign.1 == Strictness::Strict);
            let holds = match condition.relation {
                Relation::NotEqual => is_far,
                Relation::Greater => is_far && sign.is_some_and(|sign| sign.0),
                Relation::Less => is_far && sign.is_some_and(|sign| !sign.0),
                Relation::GreaterEqual => sign.is_some_and(|sign| sign.0),
                Relation::LessEqual => sign.is_some_and(|sign| !sign.0),
            };
            if !holds {
                return Some(condition);
            }
            self.conditions.push(condition);
        }
        None
    }

    /// Whether an unknown function is evaluated at arguments that depend on a variable of a range.
    fn has_unknowns(&self, pool: &Pool, expression: Expr) -> bool {
        let is_unknown =
            |part: &Expr| matches!(pool.node(*part), Node::Jet { .. }) && self.varies(pool, *part);
        pool.reachable(&[expression]).iter().any(is_unknown)
    }

    /// Removes the innermost range, after the integration over it, together with the assumptions on
    /// its variable.
    pub(crate) fn forget_innermost(&mut self, pool: &Pool) {
        let Some((symbol, ..)) = self.ranges.pop() else { return };
        self.conditions.retain(|c| !pool.symbols_in(&[c.left, c.right]).contains(&symbol));
    }

    /// Returns the integral over the innermost range.
    ///
    /// # Errors
    /// The reason why it cannot be integrated, in words.
    pub(crate) fn integral(&self, pool: &mut Pool, integrand: Expr) -> Result<Integral, String> {
        let Some(&(variable, from, to)) = self.ranges.last() else {
            return Ok(Integral { value: integrand, conditions: vec![], antiderivative: None });
        };
        if from == to || pool.is_zero(integrand) {
            let zero = pool.integer(0);
            return Ok(Integral { value: zero, conditions: vec![], antiderivative: Some(zero) });
        }
        let mut tower = Tower::new(Trigonometry::Circle);
        if let Ok(normal) = normal_form(pool, &mut tower, integrand, &self.conditions)
            && let Ok((value, antiderivative)) = by_moments(pool, &mut tower, &normal, variable, (from, to))
        {
            return Ok(Integral { value, conditions: vec![], antiderivative: Some(antiderivative) });
        }
        if !pool.symbols_in(&[integrand]).contains(&variable) {
            let (length, x) = (pool.subtract(to, from), pool.symbol(variable));
            let value = pool.multiply(integrand, length);
            let antiderivative = Some(pool.multiply(integrand, x));
            return Ok(Integral { value, conditions: vec![], antiderivative });
        }
        match self.by_antiderivative(pool, integrand) {
            Ok(found) => Ok(found),
            Err(failure) => {
                if let Some(found) = self.by_pieces(pool, integrand)? {
                    return Ok(found);
                }
                self.by_primitives(pool, integrand)?.ok_or(failure.0)
            }
        }
    }

    fn by_antiderivative(&self, pool: &mut Pool, integrand: Expr) -> Result<Integral, Failure> {
        let whole = self.evaluated(pool, integrand);
        let Some(&(variable, from, to)) = self.ranges.last() else { return whole };
        if whole.is_ok() || !has_waves(pool, integrand, variable) {
            return whole;
        }
        // tan(u/2) has a pole at u = π, but none about the middle of each half of a period
        let half = pool.ratio(1, 2);
        let sum = pool.add(from, to);
        let middle = pool.multiply(half, sum);
        let mut total = Integral { value: pool.integer(0), conditions: vec![], antiderivative: None };
        for (from, to) in [(from, middle), (middle, to)] {
            let Ok(part) = self.centred(pool, integrand, (from, to)) else { return whole };
            total.value = pool.add(total.value, part.value);
            total.conditions.extend(part.conditions);
        }
        Ok(total)
    }

    /// Returns the integral over a part of the range, with the variable measured from the middle.
    fn centred(
        &self,
        pool: &mut Pool,
        integrand: Expr,
        (from, to): (Expr, Expr),
    ) -> Result<Integral, Failure> {
        let Some((&(variable, ..), outer)) = self.ranges.split_last() else {
            return Err("there is no range".into());
        };
        let half = pool.ratio(1, 2);
        let (sum, difference) = (pool.add(from, to), pool.subtract(to, from));
        let (middle, reach) = (pool.multiply(half, sum), pool.multiply(half, difference));
        let x = pool.symbol(variable);
        let moved = pool.add(x, middle);
        let shift: Substitution = [(variable, moved)].into_iter().collect();
        let lower = pool.negate(reach);
        let mut ranges = outer.to_vec();
        ranges.push((variable, lower, reach));
        let mut conditions: Vec<Condition> =
            self.conditions.iter().map(|condition| condition.substitute(pool, &shift)).collect();
        conditions.push(Condition { left: x, relation: Relation::GreaterEqual, right: lower });
        conditions.push(Condition { left: x, relation: Relation::LessEqual, right: reach });
        let region = Region { ranges, conditions };
        let shifted = pool.substitute(integrand, &shift);
        region.evaluated(pool, shifted)
    }

    /// Returns A(b) − A(a) if an antiderivative A is found and verified to be right and continuous.
    fn evaluated(&self, pool: &mut Pool, integrand: Expr) -> Result<Integral, Failure> {
        let Some(&(variable, from, to)) = self.ranges.last() else {
            return Err("there is no range".into());
        };
        let mut search = Search { pool, region: self };
        let found = search.antiderivative(integrand, variable, &self.conditions, super::search::DEPTH)?;
        let antiderivative = self.without_magnitudes(pool, found, variable)?;
        if !is_antiderivative(pool, antiderivative, integrand, variable, &self.conditions)? {
            return Err(format!("no antiderivative of `{}` was found", pool.text(integrand)).into());
        }
        let mut conditions = Vec::new();
        for part in self.without_powers(pool, antiderivative) {
            conditions.extend(self.where_extended(pool, part, variable)?);
        }
        let upper = self.limit_at(pool, antiderivative, variable, to);
        let lower = self.limit_at(pool, antiderivative, variable, from);
        let difference = pool.subtract(upper, lower);
        let (value, positive) = self.with_powers_of_zero(pool, difference)?;
        conditions.extend(positive);
        Ok(Integral { value, conditions, antiderivative: Some(antiderivative) })
    }

    /// Replaces log|q| by log q or log(−q), by the sign of q over the range.
    fn without_magnitudes(
        &self,
        pool: &mut Pool,
        expression: Expr,
        variable: Symbol,
    ) -> Result<Expr, Failure> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for part in pool.reachable(&[expression]) {
            let Node::Apply(Operation::Log, arguments) = pool.node(part) else { continue };
            let Node::Apply(Operation::Abs, inner) = pool.node(arguments[0]).clone() else { continue };
            let argument = match self.sign(pool, inner[0]) {
                Some((true, _)) => inner[0],
                Some((false, _)) => pool.negate(inner[0]),
                None if self.varies(pool, inner[0]) => {
                    return Err(not_known(pool, inner[0], Relation::NotEqual, variable));
                }
                None => continue,
            };
            let logarithm = pool.apply(Operation::Log, &[argument]);
            images.insert(part, logarithm);
        }
        Ok(pool.replace(expression, &images))
    }

    /// Whether an expression depends on a variable of a range.
    pub(super) fn varies(&self, pool: &Pool, expression: Expr) -> bool {
        let symbols = pool.symbols_in(&[expression]);
        self.ranges.iter().any(|range| symbols.contains(&range.0))
    }

    /// Shows that every part of an antiderivative is defined and continuous over the closed range.
    /// A requirement that does not depend on the variable becomes a condition and is returned.
    pub(super) fn where_continuous(
        &self,
        pool: &mut Pool,
        antiderivative: Expr,
        variable: Symbol,
    ) -> Result<Vec<Condition>, Failure> {
        let mut conditions = Vec::new();
        let zero = pool.integer(0);
        for part in pool.reachable(&[antiderivative]) {
            if matches!(pool.node(part), Node::Apply(Operation::Atan2, _) | Node::Select { .. }) {
                return Err(format!("`{}` may be discontinuous", pool.text(part)).into());
            }
            if let Some(Condition { left, relation, .. }) = needs(pool, part) {
                let sign = self.sign(pool, left);
                let holds = match relation {
                    Relation::GreaterEqual => matches!(sign, Some((true, _))),
                    Relation::Greater => sign == Some((true, Strictness::Strict)),
                    _ => matches!(sign, Some((_, Strictness::Strict))),
                };
                if holds {
                    continue;
                }
                if self.varies(pool, left) {
                    return Err(not_known(pool, left, relation, variable));
                }
                let factors = match relation {
                    Relation::NotEqual => pool.factors_that_may_vanish(left),
                    _ => vec![left],
                };
                conditions.extend(factors.into_iter().map(|left| Condition { left, relation, right: zero }));
            }
        }
        Ok(conditions)
    }
}

/// Returns the failure that a condition of continuity is not known to hold.
fn not_known(pool: &Pool, left: Expr, relation: Relation, variable: Symbol) -> Failure {
    let claim = match relation {
        Relation::GreaterEqual => "is not negative",
        Relation::Greater => "is positive",
        _ => "is not zero",
    };
    let (left, name) = (pool.text(left), pool.symbol_name(variable));
    format!("it is not known that `{left}` {claim} on the whole range of `{name}`").into()
}

/// Whether A′ = f wherever the conditions hold.
pub(super) fn is_antiderivative(
    pool: &mut Pool,
    candidate: Expr,
    integrand: Expr,
    variable: Symbol,
    conditions: &[Condition],
) -> Result<bool, Failure> {
    let plain = without_magnitudes_in_logarithms(pool, candidate);
    let derivative = pool.derivative(plain, variable);
    let difference = pool.subtract(derivative, integrand);
    let mut tower = Tower::new(Trigonometry::Circle);
    let is_zero = any_normal_form(pool, &mut tower, difference, conditions)?.is_zero();
    Ok(is_zero && (tower.holds_everywhere() || tower.leaves_out_single_values_of(variable)))
}

/// Replaces log|q| by log q, which has the same derivative q′/q.
fn without_magnitudes_in_logarithms(pool: &mut Pool, expression: Expr) -> Expr {
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for part in pool.reachable(&[expression]) {
        let Node::Apply(Operation::Log, arguments) = pool.node(part) else { continue };
        let Node::Apply(Operation::Abs, inner) = pool.node(arguments[0]).clone() else { continue };
        let logarithm = pool.apply(Operation::Log, &inner);
        images.insert(part, logarithm);
    }
    pool.replace(expression, &images)
}

/// Returns the condition under which one operation is defined, and therefore continuous.
fn needs(pool: &mut Pool, part: Expr) -> Option<Condition> {
    match pool.node(part).clone() {
        Node::Divide(_, divisor) => pool.quotient_domain(divisor),
        Node::Power(base, exponent) => pool.power_domain(base, exponent),
        Node::Apply(operation, arguments) => pool.operation_domain(operation, &arguments),
        _ => None,
    }
}

/// Whether a sine, cosine or tangent of the variable occurs.
fn has_waves(pool: &Pool, expression: Expr, variable: Symbol) -> bool {
    pool.reachable(&[expression]).into_iter().any(|part| {
        matches!(pool.node(part), Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, q)
            if pool.symbols_in(q).contains(&variable))
    })
}
