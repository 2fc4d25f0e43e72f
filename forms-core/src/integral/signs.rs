//! Signs over the range of an integral, proved: the variables of the ranges run over [0, 1], and
//! the parameters have the signs that the conditions give. Expressions that are not polynomial are
//! enclosed on smaller and smaller boxes.

use super::bernstein::{Knowledge, UnitBox};
use super::known_sign::{KnownSign, Strictness};
use super::normal_form;
use crate::assume::is_at_most;
use crate::enclosure::{Enclosure, Precision, enclose};
use crate::expression::{
    Condition, Expr, Nature, Node, Pool, Rational, Relation, Substitution, Symbol, SymbolKind,
};
use crate::normal::{Generator, Tower, Trigonometry};
use num_traits::Zero;

/// Limit on the boxes on which an expression that is not polynomial is enclosed.
const MOST_BOXES: usize = 400;

/// The ranges, outermost first, and the assumptions on everything else.
#[derive(Clone)]
pub(crate) struct Region {
    /// Variable, lower and upper bound.
    pub(crate) ranges: Vec<(Symbol, Expr, Expr)>,
    pub(crate) conditions: Vec<Condition>,
}

impl Region {
    /// Returns the sign that an expression has all over the ranges.
    pub(super) fn sign(&self, pool: &mut Pool, q: Expr) -> Option<KnownSign> {
        let negated = pool.negate(q);
        let mut seen = None;
        for (positive, value) in [(true, q), (false, negated)] {
            match pool.nature(value) {
                Nature::Positive => return Some((positive, Strictness::Strict)),
                Nature::NotNegative => seen = Some((positive, Strictness::Weak)),
                Nature::Open => {}
            }
        }
        if let Some(found) = self.sign_of_waves(pool, q) {
            return Some(found);
        }
        let (on_box, sides) = self.on_box(pool, q);
        let found =
            self.algebraic_sign(pool, on_box, &sides).or_else(|| self.enclosed_sign(pool, on_box, &sides));
        if found.is_some_and(|sign| sign.1 == Strictness::Strict) {
            return found;
        }
        seen.or(found).or_else(|| {
            let zero = pool.integer(0);
            if is_at_most(pool, zero, q, &self.conditions) {
                return Some((true, Strictness::Weak));
            }
            is_at_most(pool, q, zero, &self.conditions).then_some((false, Strictness::Weak))
        })
    }

    /// Returns the expression with x = a + (b − a) τ for every range, and the variables τ.
    fn on_box(&self, pool: &mut Pool, q: Expr) -> (Expr, Vec<Symbol>) {
        let (mut value, mut sides) = (q, Vec::new());
        for (symbol, from, to) in self.ranges.iter().rev() {
            if !pool.symbols_in(&[value]).contains(symbol) {
                continue;
            }
            let tau = pool.declare_symbol("tau", SymbolKind::Local);
            let side = pool.symbol(tau);
            let length = pool.subtract(*to, *from);
            let step = pool.multiply(length, side);
            let image = pool.add(*from, step);
            let values: Substitution = [(*symbol, image)].into_iter().collect();
            value = pool.substitute(value, &values);
            sides.push(tau);
        }
        (value, sides)
    }

    fn algebraic_sign(&self, pool: &mut Pool, q: Expr, sides: &[Symbol]) -> Option<KnownSign> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let outside = |symbol: &Symbol| self.ranges.iter().any(|range| range.0 == *symbol);
        let free: Vec<Condition> = self
            .conditions
            .iter()
            .copied()
            .filter(|c| !pool.symbols_in(&[c.left, c.right]).iter().any(outside))
            .collect();
        let mut known = free.clone();
        let (zero, one) = (pool.integer(0), pool.integer(1));
        for &side in sides {
            let left = pool.symbol(side);
            known.push(Condition { left, relation: Relation::GreaterEqual, right: zero });
            known.push(Condition { left, relation: Relation::LessEqual, right: one });
        }
        let value = normal_form(pool, &mut tower, q, &known).ok()?;
        let mut knowledge = Knowledge::default();
        for condition in &free {
            let difference = pool.subtract(condition.left, condition.right);
            let Ok(difference) = normal_form(pool, &mut tower, difference, &known) else { continue };
            knowledge.learn(&tower, &difference, condition.relation);
        }
        let mut variables: Vec<u32> = sides.iter().map(|&side| tower.variable_number(side)).collect();
        let circular =
            |variable: &u32| matches!(tower.generator(*variable), Generator::Cosine(_) | Generator::Sine(_));
        let circular: Vec<u32> = (0..tower.generator_count()).filter(circular).collect();
        variables.extend(&circular);
        knowledge.sign_of_fraction(&tower, &value, &UnitBox { sides: variables, circular })
    }
}

impl Region {
    /// Returns the strict sign of an expression by enclosures on boxes that cover the sides and the
    /// bounds of the parameters.
    fn enclosed_sign(&self, pool: &Pool, q: Expr, sides: &[Symbol]) -> Option<KnownSign> {
        let symbols = pool.symbols_in(&[q]);
        let mut whole = Vec::new();
        for symbol in &symbols {
            whole.push(if sides.contains(symbol) {
                (Rational::zero(), Rational::from_integer(1.into()))
            } else {
                self.numeric_bounds(pool, *symbol)?
            });
        }
        let mut boxes = vec![whole];
        let mut sign: Option<bool> = None;
        let mut looked_at = 0;
        while let Some(part) = boxes.pop() {
            looked_at += 1;
            if looked_at > MOST_BOXES {
                return None;
            }
            let value = |symbol: Symbol| {
                let place = symbols.iter().position(|other| *other == symbol)?;
                Some(Enclosure::between(&part[place].0, &part[place].1, Precision(64)))
            };
            let enclosed = enclose(pool, &[q], &value, &mut |_, _, _| None, Precision(64)).remove(0).ok();
            let here = enclosed.as_ref().and_then(|enclosed| {
                if enclosed.is_positive() { Some(true) } else { enclosed.is_negative().then_some(false) }
            });
            match here {
                Some(positive) if sign.is_none_or(|known| known == positive) => sign = Some(positive),
                Some(_) => return None,
                None => boxes.extend(halved(part)?),
            }
        }
        sign.map(|positive| (positive, Strictness::Strict))
    }

    /// Returns the numbers between which conditions confine a parameter.
    fn numeric_bounds(&self, pool: &Pool, symbol: Symbol) -> Option<(Rational, Rational)> {
        let (mut lower, mut upper) = (None, None);
        for condition in &self.conditions {
            let is_symbol = |side: Expr| *pool.node(side) == Node::Symbol(symbol);
            let below = matches!(condition.relation, Relation::Less | Relation::LessEqual);
            let (bound, is_upper) = match (is_symbol(condition.left), is_symbol(condition.right)) {
                (true, false) => (pool.as_number(condition.right), below),
                (false, true) => (pool.as_number(condition.left), !below),
                _ => continue,
            };
            if condition.relation == Relation::NotEqual {
                continue;
            }
            let Some(bound) = bound.cloned() else { continue };
            if is_upper {
                upper = Some(upper.map_or(bound.clone(), |known: Rational| known.min(bound)));
            } else {
                lower = Some(lower.map_or(bound.clone(), |known: Rational| known.max(bound)));
            }
        }
        lower.zip(upper)
    }
}

/// Returns the two halves of a box along its longest side.
fn halved(part: Vec<(Rational, Rational)>) -> Option<[Vec<(Rational, Rational)>; 2]> {
    let length = |side: &(Rational, Rational)| &side.1 - &side.0;
    let place = (0..part.len()).max_by_key(|&place| length(&part[place]))?;
    let middle = (&part[place].0 + &part[place].1) / Rational::from_integer(2.into());
    let (mut lower, mut upper) = (part.clone(), part);
    lower[place].1 = middle.clone();
    upper[place].0 = middle;
    Some([lower, upper])
}
