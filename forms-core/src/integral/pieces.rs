//! Integrands with absolute values: the range is split into pieces on which each absolute value has
//! one sign.
//!
//! ```text
//! |q| ─ zeros of q, exact ─▶ a ≤ r₁ ≤ … ≤ b ─ the sign between two zeros is that at their middle ─▶ ±q on each piece
//! ```
//! All zeros of q are known (`integral/zeros.rs`), so q has one sign between neighbouring zeros. An
//! absolute value that does not depend on the variable is a constant for the integral.

use super::normal_form;
use super::range::Integral;
use super::signs::Region;
use crate::assume::is_at_most;
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, SymbolKind};
use crate::normal::{Tower, Trigonometry};
use num_rational::Ratio;
use rustc_hash::FxHashMap;
use std::cmp::Ordering;

/// Precision in bits of the comparison of places.
const PRECISION: Precision = Precision(128);

/// A magnitude as it is written, and its argument.
type Magnitude = (Expr, Expr);

impl Region {
    /// Returns the integral over the innermost range if magnitudes with open signs occur; `None` if
    /// none occur.
    pub(super) fn by_pieces(&self, pool: &mut Pool, integrand: Expr) -> Result<Option<Integral>, String> {
        let Some((&(variable, from, to), outer)) = self.ranges.split_last() else { return Ok(None) };
        let (moving, still): (Vec<Magnitude>, Vec<Magnitude>) = magnitudes(pool, integrand)
            .into_iter()
            .filter(|magnitude| magnitudes(pool, magnitude.1).is_empty())
            .partition(|magnitude| pool.symbols_in(&[magnitude.1]).contains(&variable));
        if !still.is_empty() {
            return self.with_constants(pool, integrand, &still).map(Some);
        }
        if moving.is_empty() {
            return Ok(None);
        }
        match self.order(pool, from, to) {
            Some(Ordering::Less | Ordering::Equal) => {}
            Some(Ordering::Greater) => {
                let mut ranges = outer.to_vec();
                ranges.push((variable, to, from));
                let back = Region { ranges, conditions: self.conditions.clone() };
                let found = back.by_pieces(pool, integrand)?;
                return Ok(found.map(|found| Integral { value: pool.negate(found.value), ..found }));
            }
            None => return Err(not_ordered(pool, from, to)),
        }
        let mut places = vec![from, to];
        for (_, inner) in &moving {
            let zeros = self.zeros(pool, *inner).map_err(|failure| failure.0)?;
            for zero in zeros {
                self.insert(pool, &mut places, zero)?;
            }
        }
        let mut total = Integral { value: pool.integer(0), conditions: vec![], antiderivative: None };
        for ends in places.windows(2) {
            let part = self.piece(pool, integrand, &moving, (ends[0], ends[1]))?;
            total.value = pool.add(total.value, part.value);
            total.conditions.extend(part.conditions);
        }
        Ok(Some(total))
    }

    /// Returns the integral with the magnitudes that do not depend on the variable replaced by
    /// nonnegative constants.
    fn with_constants(
        &self,
        pool: &mut Pool,
        integrand: Expr,
        still: &[Magnitude],
    ) -> Result<Integral, String> {
        let (mut images, mut back) = (FxHashMap::default(), FxHashMap::default());
        let mut conditions = self.conditions.clone();
        for (written, _) in still {
            let symbol = pool.declare_symbol("c", SymbolKind::Local);
            let (left, right) = (pool.symbol(symbol), pool.integer(0));
            conditions.push(Condition { left, relation: Relation::GreaterEqual, right });
            images.insert(*written, left);
            back.insert(symbol, *written);
        }
        let replaced = pool.replace(integrand, &images);
        let found = Region { ranges: self.ranges.clone(), conditions }.integral(pool, replaced)?;
        let conditions = found.conditions.iter().map(|condition| condition.substitute(pool, &back)).collect();
        let value = pool.substitute(found.value, &back);
        Ok(Integral { value, conditions, antiderivative: None })
    }

    /// Returns the integral between two neighbouring zeros, with the sign of every magnitude there.
    fn piece(
        &self,
        pool: &mut Pool,
        integrand: Expr,
        moving: &[Magnitude],
        (from, to): (Expr, Expr),
    ) -> Result<Integral, String> {
        let Some((&(variable, ..), outer)) = self.ranges.split_last() else {
            return Err("there is no range".into());
        };
        let (half, sum) = (pool.ratio(1, 2), pool.add(from, to));
        let middle = pool.multiply(half, sum);
        let x = pool.symbol(variable);
        let mut conditions = self.conditions.clone();
        conditions.push(Condition { left: x, relation: Relation::GreaterEqual, right: from });
        conditions.push(Condition { left: x, relation: Relation::LessEqual, right: to });
        let zero = pool.integer(0);
        let mut images = FxHashMap::default();
        for &(written, inner) in moving {
            let at_middle = pool.substitute(inner, &[(variable, middle)].into_iter().collect());
            let sign = self.order(pool, at_middle, zero).ok_or_else(|| {
                format!("the sign of `{}` is not known on the whole range", pool.text(inner))
            })?;
            let image = if sign == Ordering::Less { pool.negate(inner) } else { inner };
            images.insert(written, image);
            let relation = if sign == Ordering::Less { Relation::LessEqual } else { Relation::GreaterEqual };
            conditions.push(Condition { left: inner, relation, right: zero });
        }
        let signed = pool.replace(integrand, &images);
        let mut ranges = outer.to_vec();
        ranges.push((variable, from, to));
        Region { ranges, conditions }.integral(pool, signed)
    }

    /// Inserts a place between the ends in order, unless it lies outside.
    fn insert(&self, pool: &mut Pool, places: &mut Vec<Expr>, place: Expr) -> Result<(), String> {
        for number in 0..places.len() {
            match self.order(pool, place, places[number]) {
                Some(Ordering::Equal) => return Ok(()),
                Some(Ordering::Less) => {
                    if number > 0 {
                        places.insert(number, place);
                    }
                    return Ok(());
                }
                Some(Ordering::Greater) => {}
                None => return Err(not_ordered(pool, place, places[number])),
            }
        }
        Ok(())
    }

    /// Compares two numbers wherever the conditions hold; less and greater do not exclude equality.
    pub(super) fn order(&self, pool: &mut Pool, a: Expr, b: Expr) -> Option<Ordering> {
        let difference = pool.subtract(a, b);
        let mut tower = Tower::new(Trigonometry::Circle);
        let known = normal_form(pool, &mut tower, difference, &self.conditions);
        if known.is_ok_and(|normal| normal.is_zero()) {
            return Some(Ordering::Equal);
        }
        if pool.symbols_in(&[difference]).is_empty() {
            let value = enclose_number(pool, difference, PRECISION).ok()?;
            return match (value.is_positive(), value.is_negative()) {
                (true, _) => Some(Ordering::Greater),
                (_, true) => Some(Ordering::Less),
                _ => None,
            };
        }
        if is_at_most(pool, a, b, &self.conditions) {
            return Some(Ordering::Less);
        }
        if is_at_most(pool, b, a, &self.conditions) {
            return Some(Ordering::Greater);
        }
        let sign = self.sign(pool, difference)?;
        Some(if sign.0 { Ordering::Greater } else { Ordering::Less })
    }
}

fn not_ordered(pool: &Pool, a: Expr, b: Expr) -> String {
    format!("it is not known which of `{}` and `{}` is larger", pool.text(a), pool.text(b))
}

/// Returns |q| and √(q²) in an expression, inner ones before outer ones.
fn magnitudes(pool: &Pool, expression: Expr) -> Vec<Magnitude> {
    let magnitude = |part: Expr| match pool.node(part) {
        Node::Apply(Operation::Abs, q) => Some((part, q[0])),
        Node::Power(square, exponent) if *exponent == Ratio::new(1, 2) => match pool.node(*square) {
            Node::Power(q, inner) if *inner == Ratio::from_integer(2) => Some((part, *q)),
            _ => None,
        },
        _ => None,
    };
    pool.reachable(&[expression]).into_iter().filter_map(magnitude).collect()
}
