//! Continuity over closed ranges, shown by the signs that the operations of a function require.

use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Power, Variable};
use crate::expression::{Expr, rational};
use crate::field::Field;
use crate::interval::Interval;
use crate::point::Point;
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Theory};
use crate::{Stop, uncovered};
use std::collections::HashMap;

/// Maximum number of boxes examined for one sign.
const MOST_BOXES: usize = 32;

/// Maximum order of the derivatives examined for a nonzero one.
const MOST_DERIVATIVES: usize = 4;

/// Range of an integral, with the place of its variable in the source.
#[derive(Clone)]
pub(crate) struct Range {
    pub(crate) variable: usize,
    pub(crate) from: Expr,
    pub(crate) to: Expr,
    pub(crate) place: usize,
}

/// Ranges and conditions for the points at which an antiderivative is examined.
pub(crate) struct Region<'a> {
    pub(crate) ranges: &'a [Range],
    pub(crate) conditions: Vec<Condition>,
}

impl Theory {
    /// Checks that every operation of an antiderivative is continuous over the closed ranges.
    pub(crate) fn check_continuous(&mut self, antiderivative: Expr, region: &Region) -> Result<(), Stop> {
        for part in self.pool.parts(&[antiderivative]) {
            let needed = self.need(part)?;
            if let Some((q, relation)) = needed
                && !self.holds(q, relation, region)?
                && !(relation == Relation::NotZero && self.leaves_out_zeros(q, region)?)
            {
                return uncovered("an antiderivative that was not shown to be continuous");
            }
        }
        Ok(())
    }

    /// Checks that an integrand is real over the range of the last variable u except for countably
    /// many values of u, and that, with countably many exceptions, the formal derivative of an
    /// antiderivative is its derivative.
    pub(crate) fn check_almost_everywhere(
        &mut self,
        needs: &[Condition],
        antiderivative: Expr,
        region: &Region,
    ) -> Result<(), Stop> {
        let Some(u) = region.ranges.last().map(|range| range.variable) else { return Ok(()) };
        for (q, relation) in needs {
            let is_real = match relation {
                Relation::NotZero => self.has_few_zeros(*q, region)?,
                Relation::NotNegative => self.holds(*q, *relation, region)?,
                Relation::Positive => {
                    self.holds(*q, *relation, region)?
                        || self.holds(*q, Relation::NotNegative, region)? && self.has_few_zeros(*q, region)?
                }
            };
            if self.pool.variables(*q).contains(&u) && !is_real {
                return uncovered("an integrand that was not shown to be defined on the range");
            }
        }
        for part in self.pool.parts(&[antiderivative]) {
            let kink = match (self.pool.node(part).0.clone(), self.need(part)?) {
                (Function("abs"), _) => self.pool.node(part).1[0],
                (_, Some((q, Relation::NotNegative))) => q,
                _ => continue,
            };
            if self.pool.variables(kink).contains(&u) && !self.has_few_zeros(kink, region)? {
                return uncovered("an antiderivative that was not shown to be differentiable");
            }
        }
        Ok(())
    }

    /// Whether q vanishes for at most countably many u of the range, whatever the other variables
    /// are. This holds if q vanishes nowhere, if it holds for the factors of q, or if q is analytic
    /// in u and q or a derivative of q is nonzero at either end or at the midpoint.
    fn has_few_zeros(&mut self, q: Expr, region: &Region) -> Result<bool, Stop> {
        if self.holds(q, Relation::NotZero, region)? {
            return Ok(true);
        }
        let (operation, a) = (self.pool.node(q).0.clone(), self.pool.node(q).1.to_vec());
        match operation {
            Power(p, _) if p > 0 => return self.has_few_zeros(a[0], region),
            Function("abs") | Divide => return self.has_few_zeros(a[0], region),
            Multiply => return Ok(self.has_few_zeros(a[0], region)? && self.has_few_zeros(a[1], region)?),
            _ => {}
        }
        let Some((range, outer)) = region.ranges.split_last() else { return Ok(false) };
        if !self.is_analytic(q, range.variable, region)? {
            return Ok(false);
        }
        let (u, half) = (range.variable, self.pool.number(rational(1, 2)));
        let sum = self.pool.make(Add, vec![range.from, range.to]);
        let middle = self.pool.make(Multiply, vec![half, sum]);
        let is_outer = |c: &&Condition| !self.pool.variables(c.0).contains(&u);
        let conditions = region.conditions.iter().filter(is_outer).copied().collect();
        let outer = Region { ranges: outer, conditions };
        let mut derivative = q;
        for _ in 0..=MOST_DERIVATIVES {
            for place in [range.to, range.from, middle] {
                let value = self.pool.substitute(derivative, &HashMap::from([(u, place)]));
                if self.holds(value, Relation::NotZero, &outer)? {
                    return Ok(true);
                }
            }
            derivative = self.pool.derivative(derivative, u);
        }
        Ok(false)
    }

    /// Whether every operation on an operand that depends on u is analytic over the whole range.
    fn is_analytic(&mut self, q: Expr, u: usize, region: &Region) -> Result<bool, Stop> {
        for part in self.pool.parts(&[q]) {
            if !self.pool.variables(part).contains(&u) {
                continue;
            }
            let is_analytic = match (self.pool.node(part).0.clone(), self.need(part)?) {
                (Jet(..), _) => false,
                (Function("abs"), _) => {
                    let inner = self.pool.node(part).1[0];
                    self.holds(inner, Relation::NotZero, region)?
                }
                (_, Some((q, Relation::NotNegative))) => self.holds(q, Relation::Positive, region)?,
                (_, Some((q, relation))) => self.holds(q, relation, region)?,
                (_, None) => true,
            };
            if !is_analytic {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Whether q ≠ 0 can become a condition of the statement: q must be a nonzero polynomial in
    /// parameters. The other conditions of the statement must be open, so that the remaining points
    /// are dense among the original ones.
    fn leaves_out_zeros(&mut self, q: Expr, region: &Region) -> Result<bool, Stop> {
        let is_bound =
            |v: &usize| self.bound.contains(v) || region.ranges.iter().any(|range| range.variable == *v);
        let variables = self.pool.variables(q);
        let is_polynomial = self.pool.parts(&[q]).into_iter().all(|part| match self.pool.node(part).0 {
            Number(_) | Variable(_) | Add | Multiply => true,
            Power(p, 1) => *p > 0,
            _ => false,
        });
        if variables.iter().any(is_bound)
            || !is_polynomial
            || Field::default().element(&self.pool, q)?.numerator.is_zero()
        {
            return Ok(false);
        }
        self.require(q, Relation::NotZero);
        self.scope.is_narrowed = true;
        Ok(true)
    }

    /// Whether an expression has a sign over the whole closed ranges.
    pub(crate) fn holds(&mut self, q: Expr, relation: Relation, region: &Region) -> Result<bool, Stop> {
        if relation == Relation::NotZero {
            let negated = self.pool.negate(q);
            return Ok(self.holds(q, Relation::Positive, region)?
                || self.holds(negated, Relation::Positive, region)?);
        }
        let least = if relation == Relation::Positive { Seen::Positive } else { Seen::NotNegative };
        Ok(self.seen(q, &region.conditions)? >= least
            || self.is_between(q, relation, region)?
            || self.is_enclosed(q, relation, region))
    }

    /// Decides the sign of q of degree 2 in u by its Bernstein form Σ cₖ Bₖ with c₀ = q(a),
    /// c₁ = q(a) + q′(a)(b − a)/2, c₂ = q(b): if no cₖ is negative and q is nonzero at both ends, q has
    /// no zero between.
    fn is_between(&mut self, q: Expr, relation: Relation, region: &Region) -> Result<bool, Stop> {
        let Some((range, outer)) = region.ranges.split_last() else { return Ok(false) };
        let u = range.variable;
        if !self.pool.variables(q).contains(&u) || !self.is_polynomial(q, u) {
            return Ok(false);
        }
        let first = self.pool.derivative(q, u);
        let second = self.pool.derivative(first, u);
        let third = self.pool.derivative(second, u);
        if !Field::default().element(&self.pool, third)?.numerator.is_zero() {
            return Ok(false);
        }
        let images = [range.from, range.to].map(|bound| HashMap::from([(u, bound)]));
        let [lower, upper] = images.each_ref().map(|images| self.pool.substitute(q, images));
        let slope = self.pool.substitute(first, &images[0]);
        let width = self.difference(range.to, range.from);
        let half = self.pool.number(rational(1, 2));
        let rise = self.pool.make(Multiply, vec![slope, width]);
        let rise = self.pool.make(Multiply, vec![half, rise]);
        let middle = self.pool.make(Add, vec![lower, rise]);
        let is_outer = |c: &&Condition| !self.pool.variables(c.0).contains(&u);
        let conditions = region.conditions.iter().filter(is_outer).copied().collect();
        let outer = Region { ranges: outer, conditions };
        Ok(self.holds(lower, relation, &outer)?
            && self.holds(upper, relation, &outer)?
            && self.holds(middle, Relation::NotNegative, &outer)?)
    }

    /// Whether an expression is polynomial in a variable, as written.
    fn is_polynomial(&self, q: Expr, u: usize) -> bool {
        self.pool.parts(&[q]).into_iter().all(|part| {
            let (operation, a) = self.pool.node(part);
            let varies = |expr: Expr| self.pool.variables(expr).contains(&u);
            match operation {
                Add | Multiply | Variable(_) => true,
                Divide => !varies(a[1]),
                Power(p, 1) if *p >= 0 => true,
                _ => !varies(part),
            }
        })
    }

    /// Decides the sign by enclosures on boxes, where the range of every variable has numeric
    /// bounds.
    fn is_enclosed(&self, q: Expr, relation: Relation, region: &Region) -> bool {
        let mut start: HashMap<usize, Interval> = HashMap::new();
        for v in self.pool.variables(q) {
            let Some(range) = region.ranges.iter().find(|range| range.variable == v) else { return false };
            let ends = [range.from, range.to].map(|bound| Point::default().value(&self.pool, bound));
            let [Ok(a), Ok(b)] = ends else { return false };
            start.insert(v, Interval { low: a.low.min(b.low), high: a.high.max(b.high) });
        }
        let (mut open, mut boxes) = (vec![start], 0);
        while let Some(next) = open.pop() {
            boxes += 1;
            let value = Point::within(next.clone()).value(&self.pool, q);
            let zero = rational(0, 1);
            let holds = |value: Interval| {
                value.low > zero || (relation == Relation::NotNegative && value.low == zero)
            };
            if value.is_ok_and(holds) {
                continue;
            }
            let widest = next.iter().max_by_key(|(v, side)| (&side.high - &side.low, **v));
            let Some((v, side)) = widest.filter(|_| boxes < MOST_BOXES) else { return false };
            let middle = (&side.low + &side.high) / rational(2, 1);
            for half in [
                Interval { low: side.low.clone(), high: middle.clone() },
                Interval { low: middle.clone(), high: side.high.clone() },
            ] {
                let mut part = next.clone();
                part.insert(*v, half);
                open.push(part);
            }
        }
        true
    }
}
