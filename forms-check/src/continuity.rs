//! Continuity over closed ranges: what a function is made of has the signs there that it needs.

use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::{Expr, rational};
use crate::field::Field;
use crate::integral::Range;
use crate::interval::Interval;
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Theory};
use crate::witness::Point;
use crate::{Stop, uncovered};
use std::collections::HashMap;

/// How many boxes are looked at for one sign.
const MOST_BOXES: usize = 32;

/// What is known of the points at which an antiderivative is looked at.
pub(crate) struct Region<'a> {
    pub(crate) ranges: &'a [Range],
    pub(crate) conditions: Vec<Condition>,
}

impl Theory {
    /// That every part of an antiderivative is continuous over the closed ranges.
    pub(crate) fn check_continuous(&mut self, antiderivative: Expr, region: &Region) -> Result<(), Stop> {
        for part in self.pool.parts(&[antiderivative]) {
            let (operation, a) = (self.pool.node(part).0.clone(), self.pool.node(part).1.to_vec());
            let needed = match operation {
                Divide => Some((a[1], Relation::NotZero)),
                Power(p, 1) => (p < 0).then(|| (a[0], Relation::NotZero)),
                Power(p, _) => Some((a[0], if p < 0 { Relation::Positive } else { Relation::NotNegative })),
                Function("tan") => Some((self.pool.make(Function("cos"), a), Relation::NotZero)),
                Function("log") => match self.pool.node(a[0]) {
                    (Function("abs"), inner) => Some((inner[0], Relation::NotZero)),
                    _ => Some((a[0], Relation::Positive)),
                },
                Function("asin") => {
                    let (one, square) =
                        (self.pool.number(rational(1, 1)), self.pool.make(Power(2, 1), vec![a[0]]));
                    Some((self.difference(one, square), Relation::NotNegative))
                }
                // smooth where it is declared, which may not be everywhere
                Jet(f, _) if !self.functions[f].1.is_empty() => {
                    return uncovered("the integral of a function with a condition");
                }
                Function(_) | Jet(..) | Number(_) | Pi | Variable(_) | Add | Multiply => None,
            };
            if let Some((q, relation)) = needed
                && !self.holds(q, relation, region)?
                && !(relation == Relation::NotZero && self.leaves_out_zeros(q, region)?)
            {
                return uncovered("an antiderivative that is not seen to be continuous");
            }
        }
        Ok(())
    }

    /// Of parameters it becomes a condition that a polynomial is not zero; the statement's others have to be open, so
    /// that its points are dense among those that it had.
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

    /// Whether something has a sign all over the closed ranges.
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

    /// Of q of degree 2 in u: Σ cₖ Bₖ with c₀ = q(a), c₁ = q(a) + q′(a)(b − a)/2, c₂ = q(b), and what keeps above no
    /// negative cₖ and is not zero at either end has no zero between.
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

    /// Whether an expression is polynomial in a variable, as it is written.
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

    /// The same by enclosures on boxes, where all variables run between numbers.
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
