//! Equality of algebraic numbers by a separation bound, which separates zero from all other numbers
//! of their kind, and one enclosure.
//!
//! An expression in numbers, roots, and sines and cosines of rational multiples of π is U/L with
//! algebraic integers U and L. Let every conjugate of U be at most 2ᵘ and every conjugate of L at
//! most 2ˡ in size, and let D be the degree of a field that contains both. The norm of U is an
//! integer, so U = 0 or
//!
//! ```text
//! |U| ≥ 2^−(D−1)u,   |U/L| ≥ 2^−(l + (D−1)u)
//! ```
//! A number whose enclosure lies within that bound is zero. The bounds u and l follow the
//! operations: this is the BFMSS bound of Burnikel, Funke, Mehlhorn, Schirra and Schmitt, *A
//! Separation Bound for Real Algebraic Expressions* (ESA 2001). It does not construct a field, so
//! it decides nested roots of numbers for which no normal form is known.

use super::problem::Problem;
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{Expr, Node, Operation, Pool, Rational};
use crate::normal::prime_powers;
use crate::theory::{Statement, Theory};
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{One, Signed, ToPrimitive, Zero};
use rustc_hash::FxHashMap;

/// Limit on the binary places of a bound.
pub(super) const MOST_PLACES: u64 = 30_000;

/// Binary places beyond those of the bound, for the widths that operations add.
const SPARE_PLACES: [u64; 3] = [64, 256, 1024];

/// Limit on the number of parts of a circle.
const MOST_PARTS: u64 = 1 << 20;

/// Bounds on the conjugates of U and L: their binary logarithms, rounded up.
#[derive(Clone, Copy)]
struct Conjugates {
    above: u64,
    below: u64,
}

/// A number shown to be zero: its size is below 2⁻ⁿ, and every nonzero number of its kind has at
/// least this size.
#[derive(Clone, Copy, Debug)]
pub struct Separated {
    /// The number.
    pub number: Expr,
    /// n
    pub places: u64,
}

/// Returns the differences of a proof that shows that they are algebraic numbers and zero; empty if
/// this does not prove the statement.
pub fn separated(theory: &mut Theory, statement: &Statement) -> Vec<Separated> {
    let problem = Problem::new(theory, statement);
    all_separated(&theory.pool, &problem, MOST_PLACES).unwrap_or_default()
}

/// Whether all differences are numbers that bounds of this many places separate from all but zero.
pub(super) fn numbers_vanish(pool: &Pool, problem: &Problem, places: u64) -> bool {
    all_separated(pool, problem, places).is_some()
}

fn all_separated(pool: &Pool, problem: &Problem, most: u64) -> Option<Vec<Separated>> {
    let separate = |number: Expr| {
        let places = least_size(pool, number).filter(|&places| places <= most)?;
        is_within(pool, number, places).then_some(Separated { number, places })
    };
    problem.differences().into_iter().map(separate).collect()
}

/// Whether the number's size is certainly below 2⁻ⁿ.
fn is_within(pool: &Pool, number: Expr, places: u64) -> bool {
    let scale = Rational::one() / Rational::from_integer(BigInt::one() << places);
    for spare in SPARE_PLACES {
        let Ok(value) = enclose_number(pool, number, Precision((places + spare) as u32)) else { continue };
        if -&scale < value.lower() && value.upper() < scale {
            return true;
        }
        if !value.contains_zero() {
            return false;
        }
    }
    false
}

/// Returns n such that the number is zero or at least 2⁻ⁿ in size; `None` if it is not known to be
/// algebraic.
fn least_size(pool: &Pool, number: Expr) -> Option<u64> {
    let mut field = Field::default();
    for part in pool.reachable(&[number]) {
        if let Some(half_turns) = field.half_turns(pool, pool.node(part)) {
            field.angles.insert(part, half_turns);
        }
        if let Some(conjugates) = field.conjugates(pool, pool.node(part)) {
            field.numbers.insert(part, conjugates);
        }
    }
    let Conjugates { above, below } = *field.numbers.get(&number)?;
    below.checked_add((field.degree()? - 1).checked_mul(above)?)
}

/// Known bounds of the parts of an expression, and the field that contains the parts.
#[derive(Default)]
struct Field {
    numbers: FxHashMap<Expr, Conjugates>,
    /// Angles that are rational multiples of π, with their rational factors.
    angles: FxHashMap<Expr, Rational>,
    /// Radicands with the orders of their roots; a rational one is represented by its prime
    /// factors.
    roots: FxHashMap<Radicand, u64>,
    /// N of the cosine 2 cos(2π/N) in which the sines and cosines are polynomials.
    circle: u64,
}

/// Radicand of a root.
#[derive(PartialEq, Eq, Hash)]
enum Radicand {
    Factor(BigInt),
    Other(Expr),
}

impl Field {
    /// Returns an upper bound on the degree of the field: φ(N)/2 times the orders of the roots.
    fn degree(&self) -> Option<u64> {
        let of_cosines = if self.circle > 2 { totient(self.circle) / 2 } else { 1 };
        self.roots.values().try_fold(of_cosines, |degree, order| degree.checked_mul(*order))
    }

    /// Adjoins a root of a number.
    fn adjoin_root(&mut self, pool: &Pool, radicand: Expr, order: u64) -> Option<()> {
        let radicands = match pool.as_number(radicand) {
            Some(value) if value.is_zero() => vec![],
            Some(value) => [value.numer(), value.denom()]
                .into_iter()
                .flat_map(|part| prime_powers(&part.abs()))
                .map(|(prime, _)| Radicand::Factor(prime))
                .collect(),
            None => vec![Radicand::Other(radicand)],
        };
        for radicand in radicands {
            let known = self.roots.entry(radicand).or_insert(1);
            *known = least_common_multiple(*known, order)?;
        }
        Some(())
    }

    /// Adjoins the cosine of a rational multiple of π.
    fn adjoin_cosine(&mut self, half_turns: &Rational) -> Option<()> {
        let turns = half_turns / Rational::from_integer(2.into());
        self.circle = least_common_multiple(self.circle.max(1), turns.denom().to_u64()?)?;
        (self.circle <= MOST_PARTS).then_some(())
    }

    fn half_turns(&self, pool: &Pool, node: &Node) -> Option<Rational> {
        let angle = |part: &Expr| self.angles.get(part);
        match node {
            Node::Pi => Some(Rational::one()),
            Node::Number(value) if value.is_zero() => Some(Rational::zero()),
            Node::Add(a, b) => Some(angle(a)? + angle(b)?),
            Node::Negate(a) => Some(-angle(a)?.clone()),
            Node::Multiply(a, b) => match (pool.as_number(*a), pool.as_number(*b)) {
                (Some(factor), _) => Some(factor * angle(b)?),
                (_, Some(factor)) => Some(angle(a)? * factor),
                _ => None,
            },
            Node::Divide(a, b) => Some(angle(a)? / pool.as_number(*b).filter(|divisor| !divisor.is_zero())?),
            _ => None,
        }
    }

    /// Applies the rules of the bound, and adjoins to the field the numbers that they need.
    fn conjugates(&mut self, pool: &Pool, node: &Node) -> Option<Conjugates> {
        let of = |part: &Expr| self.numbers.get(part).copied();
        match node {
            Node::Number(value) => {
                Some(Conjugates { above: value.numer().bits(), below: value.denom().bits() })
            }
            Node::Negate(a) => of(a),
            Node::Add(a, b) => of(a)?.plus(of(b)?),
            Node::Multiply(a, b) => of(a)?.times(of(b)?),
            Node::Divide(a, b) => of(a)?.times(of(b)?.inverse()),
            Node::Power(a, exponent) => {
                let order = u64::try_from(*exponent.denom()).ok()?;
                let root = of(a)?.root(order)?;
                self.adjoin_root(pool, *a, order)?;
                let power = root.power(exponent.numer().unsigned_abs())?;
                Some(if *exponent < Ratio::zero() { power.inverse() } else { power })
            }
            Node::Apply(Operation::Abs, arguments) => of(&arguments[0]),
            Node::Apply(operation @ (Operation::Sin | Operation::Cos | Operation::Tan), arguments) => {
                let half_turns = self.angles.get(&arguments[0])?.clone();
                if *operation != Operation::Cos {
                    // sin θ = cos(π/2 − θ)
                    self.adjoin_cosine(&(Rational::new(1.into(), 2.into()) - &half_turns))?;
                }
                if *operation != Operation::Sin {
                    self.adjoin_cosine(&half_turns)?;
                }
                // 2 sin and 2 cos are algebraic integers, at most 2 in size.
                Some(Conjugates { above: 1, below: 1 })
            }
            _ => None,
        }
    }
}

impl Conjugates {
    fn inverse(self) -> Self {
        Conjugates { above: self.below, below: self.above }
    }

    fn times(self, other: Self) -> Option<Self> {
        let above = self.above.checked_add(other.above)?;
        Some(Conjugates { above, below: self.below.checked_add(other.below)? })
    }

    /// U/L + U′/L′ = (U L′ + U′ L)/(L L′)
    fn plus(self, other: Self) -> Option<Self> {
        let (left, right) = (self.times(other.inverse())?.above, other.times(self.inverse())?.above);
        Some(Conjugates { above: left.max(right).checked_add(1)?, below: self.times(other)?.below })
    }

    fn power(self, n: u64) -> Option<Self> {
        Some(Conjugates { above: self.above.checked_mul(n)?, below: self.below.checked_mul(n)? })
    }

    /// (U/L)^(1/n) is (U Lⁿ⁻¹)^(1/n)/L and U/(Uⁿ⁻¹ L)^(1/n): the first is used where L has the
    /// smaller bound.
    fn root(self, n: u64) -> Option<Self> {
        if self.above < self.below {
            return Some(self.inverse().root(n)?.inverse());
        }
        let radicand = self.below.checked_mul(n - 1)?.checked_add(self.above)?;
        Some(Conjugates { above: radicand.div_ceil(n), below: self.below })
    }
}

fn least_common_multiple(a: u64, b: u64) -> Option<u64> {
    (a / a.gcd(&b)).checked_mul(b)
}

/// Euler's φ
fn totient(n: u64) -> u64 {
    let (mut rest, mut totient) = (n, n);
    let mut prime = 2;
    while prime * prime <= rest {
        if rest.is_multiple_of(prime) {
            totient -= totient / prime;
            while rest.is_multiple_of(prime) {
                rest /= prime;
            }
        }
        prime += 1;
    }
    if rest > 1 { totient - totient / rest } else { totient }
}

#[cfg(test)]
mod tests {
    use super::{Field, least_size, totient};
    use crate::enclosure::{Precision, enclose_number};
    use crate::expression::{Expr, Pool, Rational};
    use num_bigint::BigInt;
    use num_traits::{One, Signed};

    fn root(pool: &mut Pool, radicand: i64, order: i64) -> Expr {
        let radicand = pool.integer(radicand);
        pool.power(radicand, num_rational::Ratio::new(1, order))
    }

    /// Returns best approximations p/q of a number: for a root they come as close to it as a
    /// separation bound allows.
    fn convergents(value: f64) -> Vec<(i64, i64)> {
        let (mut found, mut rest) = (vec![(1, 0)], value);
        let mut last = (0, 1);
        for _ in 0..12 {
            let whole = rest.floor() as i64;
            let (p, q) = *found.last().unwrap();
            found.push((whole * p + last.0, whole * q + last.1));
            last = (p, q);
            rest = 1.0 / (rest - rest.floor());
        }
        found
    }

    #[test]
    fn a_number_that_is_not_zero_is_at_least_its_bound() {
        let mut pool = Pool::new();
        for (radicand, order) in [(2, 2), (3, 2), (2, 3), (5, 3), (7, 4), (3, 5)] {
            for (p, q) in convergents(f64::from(radicand).powf(1.0 / f64::from(order))) {
                let root = root(&mut pool, radicand.into(), order.into());
                let (p, q) = (pool.integer(p), pool.integer(q));
                let product = pool.multiply(q, root);
                let difference = pool.subtract(product, p);
                let places = least_size(&pool, difference).expect("an algebraic number");
                let value = enclose_number(&pool, difference, Precision(200)).expect("a number");
                let least = Rational::new(BigInt::one(), BigInt::one() << places);
                assert!(value.lower().abs().min(value.upper().abs()) >= least, "{}", pool.text(difference));
            }
        }
    }

    #[test]
    fn the_degree_is_that_of_the_field_of_the_roots() {
        let mut pool = Pool::new();
        let roots =
            [(2, 2), (8, 2), (12, 3), (18, 3)].map(|(radicand, order)| root(&mut pool, radicand, order));
        let mut field = Field::default();
        for part in pool.reachable(&roots) {
            field.conjugates(&pool, pool.node(part)).map(|known| field.numbers.insert(part, known));
        }
        assert_eq!(field.degree(), Some(6 * 3));
    }

    #[test]
    fn totients_count_what_is_coprime() {
        for n in 1..200_u64 {
            assert_eq!(totient(n), (1..=n).filter(|k| num_integer::gcd(*k, n) == 1).count() as u64);
        }
    }

    #[test]
    fn what_is_not_algebraic_has_no_bound() {
        let mut pool = Pool::new();
        let two = pool.integer(2);
        let transcendental = pool.apply(crate::expression::Operation::Exp, &[two]);
        assert_eq!(least_size(&pool, transcendental), None);
        let pi = pool.pi();
        assert_eq!(least_size(&pool, pi), None);
    }
}
