//! Candidate points: small exact numbers first, within the simple bounds that conditions give.

use crate::enclosure::{Enclosure, Precision, enclose_number};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Relation, Symbol};
use crate::random::SplitMix;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;

/// Length of a chain of variables a < b < c … along which bounds propagate.
const CHAIN: usize = 4;

/// Precision of the bounds, in bits.
const PRECISION: Precision = Precision(192);

/// Numeric bounds of one variable; either can be missing.
#[derive(Clone, Debug, Default)]
pub(crate) struct Bounds {
    pub(crate) lower: Option<Rational>,
    pub(crate) upper: Option<Rational>,
}

/// Returns the bounds of each variable x that follow from conditions on a x + c, with c any
/// constant expression: `x < c`, `0 < 1 - 2*x`, `abs(x) < c`.
pub(crate) fn simple_bounds(pool: &Pool, conditions: &[Condition]) -> FxHashMap<Symbol, Bounds> {
    let mut bounds: FxHashMap<Symbol, Bounds> = FxHashMap::default();
    for condition in conditions {
        if pool.symbols_in(&[condition.left, condition.right]).len() == 1 {
            for (left, relation, right) in without_magnitude(pool, condition) {
                restrict(pool, left, relation, right, &mut bounds);
            }
        }
    }
    for _ in 0..CHAIN {
        conditions.iter().for_each(|condition| pass_on(pool, condition, &mut bounds));
    }
    bounds
}

/// Returns the sides, each as factor and expression, without a magnitude: |q| < c means q < c and
/// −q < c.
fn without_magnitude(pool: &Pool, condition: &Condition) -> Vec<(Side, Relation, Side)> {
    let (one, minus) = (Rational::one(), -Rational::one());
    let mirrored = condition.relation.mirrored();
    for (left, relation, right) in
        [(condition.left, condition.relation, condition.right), (condition.right, mirrored, condition.left)]
    {
        if let Node::Apply(Operation::Abs, inner) = pool.node(left)
            && matches!(relation, Relation::Less | Relation::LessEqual)
        {
            let bound = |sign: &Rational| ((sign.clone(), inner[0]), relation, (one.clone(), right));
            return vec![bound(&one), bound(&minus)];
        }
    }
    vec![((one.clone(), condition.left), condition.relation, (one, condition.right))]
}

type Side = (Rational, Expr);

fn restrict(
    pool: &Pool,
    left: Side,
    relation: Relation,
    right: Side,
    bounds: &mut FxHashMap<Symbol, Bounds>,
) {
    let side = |(factor, expression): Side| Some(Linear::of(pool, expression, DEEPEST)?.scaled(&factor));
    let (Some(left), Some(right)) = (side(left), side(right)) else { return };
    let Some(Linear { symbol: Some(symbol), slope, constant }) = left.add(&right.scaled(&-Rational::one()))
    else {
        return;
    };
    if !slope.is_zero() {
        let relation = if slope.is_negative() { relation.mirrored() } else { relation };
        let bound = constant.mul(&Enclosure::exact(&-slope.recip(), PRECISION));
        bounds.entry(symbol).or_default().restrict(relation, &bound);
    }
}

/// Propagates bounds: for a < b every upper bound of b is one of a, and every lower bound of a is
/// one of b.
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

/// Nesting depth of operations up to which a linear expression is recognised.
const DEEPEST: u32 = 8;

/// A linear expression a x + c; for a number, a = 0 and there is no x.
struct Linear {
    symbol: Option<Symbol>,
    slope: Rational,
    constant: Enclosure,
}

impl Linear {
    /// Returns the dependence of an expression on its only variable, if its form shows it directly.
    fn of(pool: &Pool, expression: Expr, depth: u32) -> Option<Linear> {
        let depth = depth.checked_sub(1)?;
        match pool.node(expression) {
            Node::Symbol(symbol) => {
                let constant = Enclosure::integer(0, PRECISION);
                Some(Linear { symbol: Some(*symbol), slope: Rational::one(), constant })
            }
            Node::Add(a, b) => Linear::of(pool, *a, depth)?.add(&Linear::of(pool, *b, depth)?),
            Node::Negate(a) => Some(Linear::of(pool, *a, depth)?.scaled(&-Rational::one())),
            Node::Multiply(a, b) => match (pool.as_number(*a), pool.as_number(*b)) {
                (Some(factor), None) => Some(Linear::of(pool, *b, depth)?.scaled(factor)),
                (None, Some(factor)) => Some(Linear::of(pool, *a, depth)?.scaled(factor)),
                _ => Linear::number(pool, expression),
            },
            Node::Divide(a, b) => match pool.as_number(*b) {
                Some(divisor) if !divisor.is_zero() => {
                    Some(Linear::of(pool, *a, depth)?.scaled(&divisor.recip()))
                }
                _ => Linear::number(pool, expression),
            },
            _ => Linear::number(pool, expression),
        }
    }

    fn number(pool: &Pool, expression: Expr) -> Option<Linear> {
        let value = enclose_number(pool, expression, PRECISION).ok()?;
        Some(Linear { symbol: None, slope: Rational::zero(), constant: value })
    }

    /// Returns the sum, if it contains at most one variable.
    fn add(&self, other: &Linear) -> Option<Linear> {
        let symbol = match (self.symbol, other.symbol) {
            (Some(own), Some(other)) if own != other => return None,
            (own, other) => own.or(other),
        };
        let constant = self.constant.add(&other.constant);
        Some(Linear { symbol, slope: &self.slope + &other.slope, constant })
    }

    fn scaled(&self, by: &Rational) -> Linear {
        let constant = self.constant.mul(&Enclosure::exact(by, PRECISION));
        Linear { symbol: self.symbol, slope: &self.slope * by, constant }
    }
}

impl Bounds {
    pub(super) fn restrict(&mut self, relation: Relation, value: &Enclosure) {
        let short = short_within(value);
        match relation {
            Relation::Greater | Relation::GreaterEqual => {
                let bound = short.unwrap_or_else(|| value.upper());
                if self.lower.as_ref().is_none_or(|lower| *lower < bound) {
                    self.lower = Some(bound);
                }
            }
            Relation::Less | Relation::LessEqual => {
                let bound = short.unwrap_or_else(|| value.lower());
                if self.upper.as_ref().is_none_or(|upper| *upper > bound) {
                    self.upper = Some(bound);
                }
            }
            Relation::NotEqual => {}
        }
    }

    /// Returns one end of the range, if it has one.
    fn end(&self) -> Option<Rational> {
        self.lower.as_ref().or(self.upper.as_ref()).cloned()
    }

    /// Returns a number within the bounds and close to one of them; the smaller the free number,
    /// the closer.
    fn place_close(&self, free: Rational) -> Rational {
        if self.lower.is_none() && self.upper.is_none() {
            return free;
        }
        let one = Rational::one();
        let near = if free.is_zero() { Rational::new(1.into(), 64.into()) } else { free.abs() };
        let width = match (&self.lower, &self.upper) {
            (Some(lower), Some(upper)) => upper - lower,
            _ => one.clone(),
        };
        // 0 < n/(1 + n) < 1 for every n > 0
        let distance = width * &near / (one + &near);
        let from_below = self.upper.is_none() || (self.lower.is_some() && free.is_positive());
        match (&self.lower, &self.upper) {
            (Some(lower), _) if from_below => {
                let value = lower + &distance;
                short_between(&value, lower, &(&value + &distance))
            }
            (_, Some(upper)) => {
                let value = upper - &distance;
                short_between(&value, &(&value - &distance), upper)
            }
            _ => free,
        }
    }

    /// Returns a number within the bounds, derived from a free number that ignores them.
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
                // 0 < w/(1 + w) < 1 for every w > 0; the sign of the free number selects the nearer
                // end
                let w = free.abs() + half;
                let above = if free.is_negative() { Rational::one() } else { w.clone() };
                let share = above / (Rational::one() + &w);
                short_between(&(lower + share * (upper - lower)), lower, upper)
            }
        }
    }
}

/// Largest denominator of a bound that is recognised as a simple number.
const LARGEST_DENOMINATOR: u32 = 64;

/// Limit on the terms of a continued fraction with such a denominator: the denominator is at least
/// the Fibonacci number of that order.
const MOST_DIGITS: u32 = 12;

/// Returns the number with the smallest denominator in an enclosure, if that denominator is small.
fn short_within(enclosure: &Enclosure) -> Option<Rational> {
    let found = match enclosure.as_exact() {
        Some(value) => Some(value.clone()),
        None => simplest(enclosure.lower().into_raw(), enclosure.upper().into_raw(), MOST_DIGITS),
    };
    found.filter(|value| *value.denom() <= LARGEST_DENOMINATOR.into())
}

/// Returns the number with the smallest denominator from a/b to c/d, by the continued fraction that
/// the ends share, if it has at most `digits` terms: ⌊x⌋ + 1/y with the simplest y between the
/// reciprocals of the remainders.
fn simplest((a, b): (BigInt, BigInt), (c, d): (BigInt, BigInt), digits: u32) -> Option<Rational> {
    let (whole, rest) = a.div_mod_floor(&b);
    if rest.is_zero() {
        return Some(Rational::from_integer(whole));
    }
    let above = &c - &whole * &d;
    if above >= d {
        return Some(Rational::from_integer(whole + 1));
    }
    let inner = simplest((d, above), (b, rest), digits.checked_sub(1)?)?;
    Some(Rational::from_integer(whole) + inner.recip())
}

/// Returns a nearby number with a short denominator.
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

/// A deterministic sequence of small exact numbers: the same input gives the same numbers.
#[derive(Clone, Debug)]
pub(super) struct Sequence(SplitMix);

/// Numbers that are easy to check by hand, the most frequently used ones first.
const SIMPLE: &[(i64, i64)] =
    &[(1, 1), (2, 1), (1, 2), (3, 1), (-1, 1), (3, 2), (-2, 1), (1, 3), (5, 1), (0, 1)];

/// First round that tries small numbers close to the bounds, and the period of these rounds. With a
/// condition x > −1/10, a statement that holds for x > 0 fails, if anywhere, between −1/10 and 0.
const FIRST_CLOSE: u32 = 24;
const CLOSE: u32 = 2;

fn is_close(round: u32) -> bool {
    round >= FIRST_CLOSE && round.is_multiple_of(CLOSE)
}

impl Sequence {
    pub(super) fn new(seed: u64) -> Self {
        Sequence(SplitMix(seed))
    }

    /// Returns the next number: one of the simple ones at first, then more and more varied.
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
        let number = Rational::new((sign * numerator).into(), denominator.into());
        if is_close(round) && numerator > denominator { number.recip() } else { number }
    }

    /// Returns values for the variables, within their bounds.
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
                    // a bound may belong to the range; the condition itself decides
                    Some(bounds) if free.is_zero() && round % 2 == 1 => bounds.end().unwrap_or(free),
                    Some(bounds) if is_close(round) => bounds.place_close(free),
                    Some(bounds) => bounds.place(free),
                    None => free,
                };
                (*symbol, value)
            })
            .collect()
    }
}

/// Returns the value of an unknown function's derivative at one place: small, and not 0 in the
/// first rounds.
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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fraction(p: i64, q: i64) -> Rational {
        Rational::new(p.into(), q.into())
    }

    proptest! {
        #[test]
        fn the_simplest_number_of_an_interval_has_the_least_denominator(
            p in -500i64..500,
            q in 1i64..97,
            width in 1i64..9999,
        ) {
            let lower = fraction(p, q);
            let upper = &lower + fraction(1, width);
            let found = simplest(lower.clone().into_raw(), upper.clone().into_raw(), MOST_DIGITS);
            let with = |d: i64| (&lower * fraction(d, 1)).ceil() / fraction(d, 1);
            let first = (1..=i64::from(LARGEST_DENOMINATOR)).map(with).find(|value| *value <= upper);
            let small = found.filter(|value| *value.denom() <= LARGEST_DENOMINATOR.into());
            prop_assert_eq!(small.as_ref().map(Rational::denom), first.as_ref().map(Rational::denom));
            prop_assert!(small.is_none_or(|value| lower <= value && value <= upper));
        }
    }

    #[test]
    fn bounds_are_short_where_the_enclosure_allows() {
        let pi = Enclosure::pi(PRECISION);
        assert_eq!(short_within(&pi), None);
        let third = Enclosure::exact(&fraction(-1, 3), PRECISION);
        assert_eq!(short_within(&third), Some(fraction(-1, 3)));
        assert_eq!(short_within(&pi.sub(&pi).add(&third)), Some(fraction(-1, 3)));
        assert_eq!(short_within(&Enclosure::exact(&fraction(1, 65), PRECISION)), None);
    }
}
