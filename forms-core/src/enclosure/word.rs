//! Ranges in machine words: a first estimate of values, a hundred times cheaper than enclosures of
//! any precision.
//!
//! A range is [lower, upper]·2⁻³⁰ in integers, with every operation rounded outward, so its
//! conclusions are certain. Numbers that do not fit, and every function beyond arithmetic and
//! square roots, give [`Undecided::Unknown`]: the caller continues with
//! [`enclose`](super::enclose).

use super::bounds::Undecided;
use crate::expression::{Expr, Node, Operation, Pool, Rational, Relation, Symbol};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};

/// Binary places after the point.
const PLACES: u32 = 30;

/// The number 1.
const UNIT: i64 = 1 << PLACES;

/// A closed interval that contains a real number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct WordRange {
    lower: i64,
    upper: i64,
}

type Decided = Result<WordRange, Undecided>;

/// Returns a range if its ends fit in machine words.
fn fitting(lower: i128, upper: i128) -> Decided {
    match (i64::try_from(lower), i64::try_from(upper)) {
        (Ok(lower), Ok(upper)) => Ok(WordRange { lower, upper }),
        _ => Err(Undecided::Unknown),
    }
}

/// ⌈a/b⌉ for b > 0
fn ceiling(a: i128, b: i128) -> i128 {
    -(-a).div_euclid(b)
}

impl WordRange {
    /// Returns the narrowest range around p/q.
    pub(crate) fn rational(value: &Rational) -> Decided {
        let (lower, upper) = match (value.numer().to_i64(), value.denom().to_i64()) {
            (Some(p), Some(q)) => {
                let (scaled, q) = (i128::from(p) << PLACES, i128::from(q));
                (scaled.div_euclid(q), ceiling(scaled, q))
            }
            _ => {
                let scaled: BigInt = value.numer() << PLACES;
                let end = |end: BigInt| end.to_i128().ok_or(Undecided::Unknown);
                (end(scaled.div_floor(value.denom()))?, end(Integer::div_ceil(&scaled, value.denom()))?)
            }
        };
        fitting(lower, upper)
    }

    fn one() -> Self {
        WordRange { lower: UNIT, upper: UNIT }
    }

    /// Whether the value is known exactly.
    fn is_point(self) -> bool {
        self.lower == self.upper
    }

    fn contains_zero(self) -> bool {
        self.lower <= 0 && self.upper >= 0
    }

    /// Whether both contain a common number.
    pub(crate) fn intersects(self, other: Self) -> bool {
        self.lower <= other.upper && other.lower <= self.upper
    }

    /// Whether the relation holds; `None` if that is not certain.
    pub(crate) fn decide(self, relation: Relation, other: Self) -> Option<bool> {
        let (holds, fails) = match relation {
            Relation::Less => (self.upper < other.lower, self.lower >= other.upper),
            Relation::LessEqual => (self.upper <= other.lower, self.lower > other.upper),
            Relation::Greater => (self.lower > other.upper, self.upper <= other.lower),
            Relation::GreaterEqual => (self.lower >= other.upper, self.upper < other.lower),
            Relation::NotEqual => (!self.intersects(other), self.is_point() && self == other),
        };
        (holds || fails).then_some(holds)
    }

    /// [a, b] + [c, d] = [a + c, b + d]
    fn add(self, other: Self) -> Decided {
        let ends = (self.lower.checked_add(other.lower), self.upper.checked_add(other.upper));
        let (Some(lower), Some(upper)) = ends else { return Err(Undecided::Unknown) };
        Ok(WordRange { lower, upper })
    }

    /// −[a, b] = [−b, −a]
    fn negate(self) -> Decided {
        fitting(-i128::from(self.upper), -i128::from(self.lower))
    }

    /// [a, b]·[c, d] = [min, max] of ac, ad, bc, bd
    fn multiply(self, other: Self) -> Decided {
        let product = |a: i64, b: i64| i128::from(a) * i128::from(b);
        let (a, b) = (product(self.lower, other.lower), product(self.lower, other.upper));
        let (c, d) = (product(self.upper, other.lower), product(self.upper, other.upper));
        let (least, largest) = (a.min(b).min(c).min(d), a.max(b).max(c).max(d));
        fitting(least >> PLACES, -(-largest >> PLACES))
    }

    /// 1/[a, b] = [1/b, 1/a] for 0 outside [a, b]
    fn reciprocal(self) -> Decided {
        if self.lower == 0 && self.upper == 0 {
            return Err(Undecided::Undefined);
        }
        if self.contains_zero() {
            return Err(Undecided::Unknown);
        }
        if self.upper < 0 {
            return self.negate()?.reciprocal()?.negate();
        }
        let one = i128::from(UNIT) << PLACES;
        fitting(one.div_euclid(self.upper.into()), ceiling(one, self.lower.into()))
    }

    /// |[a, b]|
    fn magnitude(self) -> Decided {
        match self.contains_zero() {
            true => fitting(0, i128::from(self.upper).max(-i128::from(self.lower))),
            false if self.upper < 0 => self.negate(),
            false => Ok(self),
        }
    }

    /// √[a, b] = [√a, √b] for a ≥ 0, where √(n·2⁻³⁰) = √(n·2³⁰)·2⁻³⁰
    fn sqrt(self) -> Decided {
        if self.upper < 0 {
            return Err(Undecided::Undefined);
        }
        if self.lower < 0 {
            return Err(Undecided::Unknown);
        }
        let scaled = |end: i64| (end as u128) << PLACES;
        let root = scaled(self.upper).isqrt();
        let upper = if root * root < scaled(self.upper) { root + 1 } else { root };
        fitting(scaled(self.lower).isqrt() as i128, upper as i128)
    }

    /// xⁿ for n ≥ 0 by repeated squaring; for even n of |x|, so that no width is added around 0.
    fn integer_power(self, n: u64) -> Decided {
        let mut square = if n.is_multiple_of(2) { self.magnitude()? } else { self };
        let (mut rest, mut power) = (n, WordRange::one());
        while rest > 0 {
            if rest % 2 == 1 {
                power = power.multiply(square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.multiply(square)?;
            }
        }
        Ok(power)
    }

    /// xʳ for an integer or half-integer r
    fn power(self, exponent: Ratio<i64>) -> Decided {
        let root = match *exponent.denom() {
            1 => self,
            2 => self.sqrt()?,
            _ => return Err(Undecided::Unknown),
        };
        let power = root.integer_power(exponent.numer().unsigned_abs())?;
        if exponent.is_negative() { power.reciprocal() } else { Ok(power) }
    }
}

/// Returns the ranges of expressions at given values of the variables; undecided if an expression
/// is not arithmetic.
pub(crate) fn word_ranges(
    pool: &Pool,
    expressions: &[Expr],
    value: impl Fn(Symbol) -> Decided,
) -> Result<Vec<WordRange>, Undecided> {
    let order = pool.reachable(expressions);
    let Some(last) = order.last() else { return Ok(Vec::new()) };
    let mut known = vec![WordRange::one(); last.0 as usize + 1];
    for &expression in &order {
        let of = |operand: &Expr| known[operand.0 as usize];
        let range = match pool.node(expression) {
            Node::Number(number) => WordRange::rational(number)?,
            Node::Symbol(symbol) => value(*symbol)?,
            Node::Add(a, b) => of(a).add(of(b))?,
            Node::Negate(a) => of(a).negate()?,
            Node::Multiply(a, b) => of(a).multiply(of(b))?,
            Node::Divide(a, b) => of(a).multiply(of(b).reciprocal()?)?,
            Node::Power(a, exponent) => of(a).power(*exponent)?,
            Node::Apply(Operation::Abs, arguments) => of(&arguments[0]).magnitude()?,
            Node::Pi | Node::Apply(..) | Node::Jet { .. } | Node::Select { .. } => {
                return Err(Undecided::Unknown);
            }
        };
        known[expression.0 as usize] = range;
    }
    Ok(expressions.iter().map(|expression| known[expression.0 as usize]).collect())
}
