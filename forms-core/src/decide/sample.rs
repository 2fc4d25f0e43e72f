//! Candidate points: small exact numbers first, inside the simple bounds that conditions give.

use crate::enclosure::{Enclosure, Precision, enclose};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Symbol};
use crate::random::SplitMix;
use crate::syntax::ast::Relation;
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;

/// How long a chain of variables a < b < c … passes its bounds on.
const CHAIN: usize = 4;

/// Bounds of one variable by numbers; either may be missing.
#[derive(Clone, Debug, Default)]
pub(super) struct Bounds {
    lower: Option<Rational>,
    upper: Option<Rational>,
}

/// What the conditions `x < c`, `c <= x`, `abs(x) < c` say of each variable, with c any expression of numbers.
pub(super) fn simple_bounds(pool: &Pool, conditions: &[Condition]) -> FxHashMap<Symbol, Bounds> {
    let mut bounds: FxHashMap<Symbol, Bounds> = FxHashMap::default();
    for condition in conditions {
        let (left, right) = (condition.left, condition.right);
        for (side, relation, other) in
            [(left, condition.relation, right), (right, condition.relation.mirrored(), left)]
        {
            if let Some(value) = constant(pool, other) {
                restrict_side(pool, side, (relation, &value), &mut bounds);
            }
        }
    }
    for _ in 0..CHAIN {
        conditions.iter().for_each(|condition| pass_on(pool, condition, &mut bounds));
    }
    bounds
}

/// From `x relation c`, or from |x| < c, which is −c < x < c.
fn restrict_side(
    pool: &Pool,
    side: Expr,
    (relation, value): (Relation, &Enclosure),
    bounds: &mut FxHashMap<Symbol, Bounds>,
) {
    match pool.node(side) {
        Node::Symbol(symbol) => bounds.entry(*symbol).or_default().restrict(relation, value),
        Node::Apply(Operation::Abs, inner) if matches!(relation, Relation::Less | Relation::LessEqual) => {
            if let Node::Symbol(symbol) = pool.node(inner[0]) {
                let known = bounds.entry(*symbol).or_default();
                known.restrict(relation, value);
                known.restrict(relation.mirrored(), &value.neg());
            }
        }
        _ => {}
    }
}

/// For a < b every upper bound of b is one of a, and every lower bound of a is one of b.
fn pass_on(pool: &Pool, condition: &Condition, bounds: &mut FxHashMap<Symbol, Bounds>) {
    let (Node::Symbol(left), Node::Symbol(right)) = (pool.node(condition.left), pool.node(condition.right))
    else {
        return;
    };
    let (smaller, larger) = match condition.relation {
        Relation::Less | Relation::LessEqual => (*left, *right),
        Relation::Greater | Relation::GreaterEqual => (*right, *left),
        Relation::NotEqual => return,
    };
    let upper = bounds.get(&larger).and_then(|known| known.upper.clone());
    let lower = bounds.get(&smaller).and_then(|known| known.lower.clone());
    let below = bounds.entry(smaller).or_default();
    below.upper = below.upper.take().into_iter().chain(upper).min();
    let above = bounds.entry(larger).or_default();
    above.lower = above.lower.take().into_iter().chain(lower).max();
}

fn constant(pool: &Pool, expression: Expr) -> Option<Enclosure> {
    if let Some(value) = pool.as_number(expression) {
        return Some(Enclosure::exact(value, Precision(64)));
    }
    enclose(pool, &[expression], &|_| None, &mut |_, _, _| None, Precision(64)).remove(0).ok()
}

impl Bounds {
    pub(super) fn restrict(&mut self, relation: Relation, value: &Enclosure) {
        match relation {
            Relation::Greater | Relation::GreaterEqual => {
                let bound = value.upper();
                if self.lower.as_ref().is_none_or(|lower| *lower < bound) {
                    self.lower = Some(bound);
                }
            }
            Relation::Less | Relation::LessEqual => {
                let bound = value.lower();
                if self.upper.as_ref().is_none_or(|upper| *upper > bound) {
                    self.upper = Some(bound);
                }
            }
            Relation::NotEqual => {}
        }
    }

    /// One end of the range, if it has one.
    fn end(&self) -> Option<Rational> {
        self.lower.as_ref().or(self.upper.as_ref()).cloned()
    }

    /// A number within the bounds, from one that knows none.
    fn place(&self, free: Rational) -> Rational {
        let half = Rational::new(1.into(), 2.into());
        match (&self.lower, &self.upper) {
            (None, None) => free,
            (Some(lower), None) if free > *lower => free,
            (Some(lower), None) => short(&(lower + free.abs() + half)),
            (None, Some(upper)) if free < *upper => free,
            (None, Some(upper)) => short(&(upper - free.abs() - half)),
            (Some(lower), Some(upper)) if *lower < free && free < *upper => free,
            (Some(lower), Some(upper)) => {
                // 0 < w/(1 + w) < 1 for every w > 0, nearer to the end that the sign tells
                let w = free.abs() + half;
                let above = if free.is_negative() { Rational::one() } else { w.clone() };
                let share = above / (Rational::one() + &w);
                short_between(&(lower + share * (upper - lower)), lower, upper)
            }
        }
    }
}

/// A number nearby with a short denominator.
fn short(value: &Rational) -> Rational {
    let scale = Rational::from_integer(8.into());
    (value * &scale).round() / scale
}

fn short_between(value: &Rational, lower: &Rational, upper: &Rational) -> Rational {
    let mut scale = Rational::from_integer(8.into());
    for _ in 0..40 {
        let candidate = (value * &scale).round() / &scale;
        if *lower < candidate && candidate < *upper {
            return candidate;
        }
        scale *= Rational::from_integer(8.into());
    }
    value.clone()
}

/// A fixed sequence of small exact numbers, the same for the same input.
#[derive(Clone, Debug)]
pub(super) struct Sequence(SplitMix);

/// Numbers people can check by hand, the first ones the most often used.
const SIMPLE: &[(i64, i64)] =
    &[(1, 1), (2, 1), (1, 2), (3, 1), (-1, 1), (3, 2), (-2, 1), (1, 3), (5, 1), (0, 1)];

impl Sequence {
    pub(super) fn new(seed: u64) -> Self {
        Sequence(SplitMix(seed))
    }

    /// The next number: from the simple ones at first, then more and more varied.
    pub(super) fn number(&mut self, round: u32) -> Rational {
        let random = self.0.next();
        if round < 8 || random.is_multiple_of(4) {
            let known = SIMPLE.len().min(3 + round as usize) as u64;
            let (p, q) = SIMPLE[((random >> 8) % known) as usize];
            return Rational::new(p.into(), q.into());
        }
        let magnitude = 1_i64 << (round / 8).min(10);
        let numerator = (random >> 8) as i64 % (8 * magnitude + 1);
        let denominator = 1 + (random >> 40) as i64 % 7;
        let sign = if random & 1 == 0 { 1 } else { -1 };
        Rational::new((sign * numerator).into(), denominator.into())
    }

    /// Values for the variables, within their bounds.
    pub(super) fn point(
        &mut self,
        symbols: &[Symbol],
        bounds: &FxHashMap<Symbol, Bounds>,
        round: u32,
    ) -> FxHashMap<Symbol, Rational> {
        symbols
            .iter()
            .map(|symbol| {
                let free = self.number(round);
                let value = match bounds.get(symbol) {
                    // a bound may belong to the range; the condition itself says so
                    Some(bounds) if free.is_zero() && round % 2 == 1 => bounds.end().unwrap_or(free),
                    Some(bounds) => bounds.place(free),
                    None => free,
                };
                (*symbol, value)
            })
            .collect()
    }
}

/// The value of an unknown function's derivative at one place: small, and not 0 at first.
pub(super) fn jet_value(seed: u64, number: usize, round: u32, bounds: Option<&Bounds>) -> Rational {
    let mut sequence = Sequence::new(seed ^ (number as u64 + 1).wrapping_mul(0xd6e8_feb8_6659_fd93));
    let mut value = sequence.number(round);
    if value.is_zero() && round < 16 {
        value = Rational::one();
    }
    match bounds {
        Some(bounds) => bounds.place(value),
        None => value,
    }
}
