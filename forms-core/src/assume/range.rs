//! Ranges of angles, with ends a + bπ, wherever the conditions hold.
//!
//! ```text
//! conditions ─ linear in quantities ─▶ bounds of a combination ─┐
//! inverse functions ─ principal values, signs of arguments ─────┴─▶ range of their sum
//! ```
//! Ends are exact, a + bπ with rational a and b, so that ±π itself is distinguished from nearby
//! numbers.

use crate::enclosure::{Enclosure, Precision};
use crate::expression::{Rational, Relation};
use crate::normal::Fraction;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// Precision in bits with which ends are compared and tangents are enclosed.
pub(super) const PRECISION: Precision = Precision(128);

/// Precision in bits of an end's tangent.
const TANGENT_PRECISION: Precision = Precision(32);

/// The product of generators in a term; π is one of the generators.
type Monomial = Vec<(u32, u32)>;

/// An end a + bπ of a range; it belongs to the range unless the end is open.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct End {
    pub(super) rational: BigRational,
    pub(super) turns: BigRational,
    pub(super) open: bool,
}

/// The numbers between two ends; a missing end is infinite.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Range {
    pub(crate) lower: Option<End>,
    pub(crate) upper: Option<End>,
}

impl End {
    /// The end (p/q)π.
    pub(super) fn of_pi(p: i64, q: i64, open: bool) -> Self {
        End { rational: BigRational::zero(), turns: BigRational::new(p.into(), q.into()), open }
    }

    /// A rational end that belongs to the range.
    pub(super) fn number(rational: &BigRational) -> Self {
        End { rational: rational.clone(), turns: BigRational::zero(), open: false }
    }

    pub(super) fn add(&self, other: &End) -> End {
        End {
            rational: &self.rational + &other.rational,
            turns: &self.turns + &other.turns,
            open: self.open || other.open,
        }
    }

    fn scaled(&self, by: &BigRational) -> End {
        End { rational: &self.rational * by, turns: &self.turns * by, open: self.open }
    }

    pub(super) fn enclosure(&self, precision: Precision) -> Enclosure {
        let turns = Enclosure::exact(&self.turns, precision).mul(&Enclosure::pi(precision));
        Enclosure::exact(&self.rational, precision).add(&turns)
    }

    /// Compares the number with another one, if the order is certain; ignores whether the ends are
    /// open.
    pub(super) fn compare(&self, other: &End) -> Option<Ordering> {
        let difference = self.add(&other.scaled(&-BigRational::from_integer(1.into())));
        if difference.rational.is_zero() {
            return Some(difference.turns.cmp(&BigRational::zero()));
        }
        let enclosure = difference.enclosure(PRECISION);
        match (enclosure.is_positive(), enclosure.is_negative()) {
            (true, _) => Some(Ordering::Greater),
            (_, true) => Some(Ordering::Less),
            _ => None,
        }
    }
}

impl Range {
    /// Range from (p/q)π to (r/s)π, with open or closed ends.
    pub(crate) fn of_pi(lower: (i64, i64, bool), upper: (i64, i64, bool)) -> Self {
        Range {
            lower: Some(End::of_pi(lower.0, lower.1, lower.2)),
            upper: Some(End::of_pi(upper.0, upper.1, upper.2)),
        }
    }

    /// Range that contains only the number a + bπ.
    fn only(rational: &BigRational, turns: &BigRational) -> Self {
        let end = End { rational: rational.clone(), turns: turns.clone(), open: false };
        Range { lower: Some(end.clone()), upper: Some(end) }
    }

    /// Returns the range of x + y.
    pub(crate) fn add(&self, other: &Range) -> Range {
        let sum = |a: &Option<End>, b: &Option<End>| Some(a.as_ref()?.add(b.as_ref()?));
        Range { lower: sum(&self.lower, &other.lower), upper: sum(&self.upper, &other.upper) }
    }

    /// Returns the range of q x.
    pub(crate) fn scaled(&self, by: &BigRational) -> Range {
        let scale = |end: &Option<End>| end.as_ref().map(|end| end.scaled(by));
        let (lower, upper) = (scale(&self.lower), scale(&self.upper));
        if by.is_negative() { Range { lower: upper, upper: lower } } else { Range { lower, upper } }
    }

    /// Returns the range of x − kπ − (p/q)π with the integer k that brings its middle nearest to 0.
    pub(crate) fn modulo_pi(&self, (p, q): (i64, i64)) -> Range {
        let (Some(lower), Some(upper)) = (&self.lower, &self.upper) else { return self.clone() };
        let shift = BigRational::new(p.into(), q.into());
        let half = BigRational::new(1.into(), 2.into());
        let middle = lower.add(upper).scaled(&half).enclosure(PRECISION).lower();
        let pi = Enclosure::pi(PRECISION).lower();
        let whole = (middle / pi - &shift).round();
        self.add(&Range::only(&BigRational::zero(), &-(whole + shift)))
    }

    /// Whether −π p/q < x < π p/q throughout.
    pub(crate) fn is_within(&self, p: i64, q: i64) -> bool {
        let inside = |end: &Option<End>, sign: i64, outside: Ordering| {
            end.as_ref().is_some_and(|end| match end.compare(&End::of_pi(sign * p, q, false)) {
                Some(Ordering::Equal) => end.open,
                Some(order) => order != outside,
                None => false,
            })
        };
        inside(&self.lower, -1, Ordering::Less) && inside(&self.upper, 1, Ordering::Greater)
    }

    /// Whether (2k − 1)π < x < (2k + 1)π throughout, for some integer k.
    pub(crate) fn avoids_half_turns(&self) -> bool {
        let half = BigRational::new(1.into(), 2.into());
        self.scaled(&half).modulo_pi((0, 1)).is_within(1, 2)
    }

    /// Returns bounds of tan x, if x stays between −π/2 and π/2.
    pub(crate) fn tangents(&self) -> (Option<Rational>, Option<Rational>) {
        let quarter = |sign: i64| End::of_pi(sign, 2, true);
        let above = |end: &Option<End>| {
            end.as_ref().is_some_and(|end| {
                matches!(end.compare(&quarter(-1)), Some(Ordering::Greater | Ordering::Equal))
            })
        };
        let below = |end: &Option<End>| {
            end.as_ref()
                .is_some_and(|end| matches!(end.compare(&quarter(1)), Some(Ordering::Less | Ordering::Equal)))
        };
        if !above(&self.lower) || !below(&self.upper) {
            return (None, None);
        }
        let lower = self.lower.as_ref().and_then(tangent).map(|value| value.lower());
        let upper = self.upper.as_ref().and_then(tangent).map(|value| value.upper());
        (lower, upper)
    }

    fn narrow(&mut self, from_below: bool, end: End) {
        let (place, better) =
            if from_below { (&mut self.lower, Ordering::Greater) } else { (&mut self.upper, Ordering::Less) };
        let replaces = place.as_ref().is_none_or(|known| match end.compare(known) {
            Some(Ordering::Equal) => end.open && !known.open,
            order => order == Some(better),
        });
        if replaces {
            *place = Some(end);
        }
    }
}

/// Returns the tangent of an end that is not a pole, exact at multiples of π/4.
fn tangent(end: &End) -> Option<Enclosure> {
    let quarters = &end.turns * BigRational::from_integer(4.into());
    if end.rational.is_zero()
        && quarters.is_integer()
        && quarters.abs() <= BigRational::from_integer(1.into())
    {
        return Some(Enclosure::exact(&quarters, TANGENT_PRECISION));
    }
    let is_pole = end.rational.is_zero() && (&end.turns * BigRational::from_integer(2.into())).is_integer();
    if is_pole { None } else { end.enclosure(TANGENT_PRECISION).tan().ok() }
}

/// A linear combination Σ c m + a + bπ of monomials m.
#[derive(Clone, Debug, Default)]
struct Linear {
    terms: Vec<(Monomial, BigRational)>,
    rational: BigRational,
    turns: BigRational,
}

impl Linear {
    fn of(pi: Option<u32>, terms: impl IntoIterator<Item = (Monomial, BigRational)>) -> Self {
        let mut linear = Linear::default();
        for (monomial, coefficient) in terms {
            match monomial.as_slice() {
                [] => linear.rational += coefficient,
                [(variable, 1)] if Some(*variable) == pi => linear.turns += coefficient,
                _ => linear.terms.push((monomial, coefficient)),
            }
        }
        linear.terms.sort_by(|a, b| a.0.cmp(&b.0));
        linear
    }
}

/// Bounds of rational combinations of quantities that follow from the conditions.
#[derive(Clone, Debug, Default)]
pub(crate) struct Ranges {
    /// Combinations that are positive, or only not negative if the flag is not set.
    known: Vec<(Linear, bool)>,
}

impl Ranges {
    /// Learns `difference relation 0`, for a difference that is a polynomial over a positive
    /// number. `pi` is the generator π, if it is one of the generators.
    pub(crate) fn learn(&mut self, pi: Option<u32>, difference: &Fraction, relation: Relation) {
        let Some(polynomial) = difference.as_polynomial() else { return };
        let sign: i64 = match relation {
            Relation::Greater | Relation::GreaterEqual => 1,
            Relation::Less | Relation::LessEqual => -1,
            Relation::NotEqual => return,
        };
        let open = matches!(relation, Relation::Greater | Relation::Less);
        let terms = polynomial.terms().map(|(monomial, c)| (monomial, BigRational::from_integer(c * sign)));
        let linear = Linear::of(pi, terms);
        if !linear.terms.is_empty() {
            self.known.push((linear, open));
        }
    }

    /// Returns the range of a rational combination of quantities.
    pub(crate) fn of(
        &self,
        pi: Option<u32>,
        terms: impl IntoIterator<Item = (Monomial, BigRational)>,
    ) -> Range {
        let linear = Linear::of(pi, terms);
        let constant = Range::only(&linear.rational, &linear.turns);
        constant.add(&self.of_terms(pi, &linear.terms))
    }

    /// Returns the range of a combination from a condition on the whole combination, or else term
    /// by term.
    fn of_terms(&self, pi: Option<u32>, terms: &[(Monomial, BigRational)]) -> Range {
        if terms.is_empty() {
            return Range::only(&BigRational::zero(), &BigRational::zero());
        }
        let mut range = self.of_conditions(terms);
        if range.lower.is_none() && range.upper.is_none() {
            range = pi.map_or_else(Range::default, |pi| self.without_pi(pi, terms));
        }
        if (range.lower.is_none() || range.upper.is_none()) && terms.len() > 1 {
            let zero = Range::only(&BigRational::zero(), &BigRational::zero());
            let apart =
                terms.iter().fold(zero, |sum, term| sum.add(&self.of_terms(pi, std::slice::from_ref(term))));
            range = Range { lower: range.lower.or(apart.lower), upper: range.upper.or(apart.upper) };
        }
        if let ([term], false) = (terms, range.lower.is_some() && range.upper.is_some()) {
            let through = self.through_others(term);
            range = Range { lower: range.lower.or(through.lower), upper: range.upper.or(through.upper) };
        }
        range
    }

    /// Returns the range of a monomial m from conditions a m + b s + k > 0 with a bound of s: m >
    /// −(b s + k)/a, or < for negative a.
    fn through_others(&self, (monomial, coefficient): &(Monomial, BigRational)) -> Range {
        let mut range = Range::default();
        for (known, open) in &self.known {
            let [first, second] = known.terms.as_slice() else { continue };
            let (own, other) = if first.0 == *monomial { (first, second) } else { (second, first) };
            if own.0 != *monomial {
                continue;
            }
            let factor = &own.1 / coefficient;
            let scale = -factor.recip();
            let rest = self.of_conditions(&[(other.0.clone(), &other.1 * &scale)]);
            let end = if factor.is_positive() { rest.lower } else { rest.upper };
            let Some(end) = end else { continue };
            let constant = End { rational: known.rational.clone(), turns: known.turns.clone(), open: *open };
            range.narrow(factor.is_positive(), end.add(&constant.scaled(&scale)));
        }
        range
    }

    /// Returns the range of Σ c m from conditions λ(Σ c m) + k > 0: Σ c m > −k/λ, or < for negative
    /// λ.
    fn of_conditions(&self, terms: &[(Monomial, BigRational)]) -> Range {
        let mut range = Range::default();
        for (known, open) in &self.known {
            if known.terms.len() != terms.len() {
                continue;
            }
            let factor = &known.terms[0].1 / &terms[0].1;
            let alike = known.terms.iter().zip(terms).all(|(a, b)| a.0 == b.0 && a.1 == &b.1 * &factor);
            if alike {
                let end = End { rational: known.rational.clone(), turns: known.turns.clone(), open: *open };
                range.narrow(factor.is_positive(), end.scaled(&-factor.recip()));
            }
        }
        range
    }

    /// Returns the range of π Σ c m where the sum has rational bounds.
    fn without_pi(&self, pi: u32, terms: &[(Monomial, BigRational)]) -> Range {
        let divided = |(monomial, c): &(Monomial, BigRational)| {
            let place = monomial.iter().position(|factor| *factor == (pi, 1))?;
            let mut rest = monomial.clone();
            rest.remove(place);
            (!rest.is_empty()).then(|| (rest, c.clone()))
        };
        let Some(divided) = terms.iter().map(divided).collect::<Option<Vec<_>>>() else {
            return Range::default();
        };
        let turned = |end: Option<End>| {
            end.filter(|end| end.turns.is_zero()).map(|end| End {
                rational: BigRational::zero(),
                turns: end.rational,
                open: end.open,
            })
        };
        let range = self.of_terms(Some(pi), &divided);
        Range { lower: turned(range.lower), upper: turned(range.upper) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polynomial::Polynomial;

    fn rational(p: i64, q: i64) -> BigRational {
        BigRational::new(p.into(), q.into())
    }

    /// Ranges with 0 < v₁ < π and 0 < v₂ < 1, where generator 0 is π, and 1 and 2 are variables.
    fn ranges() -> Ranges {
        let mut ranges = Ranges::default();
        let (pi, v, w) = (Polynomial::variable(0), Polynomial::variable(1), Polynomial::variable(2));
        ranges.learn(Some(0), &v.clone().into(), Relation::Greater);
        ranges.learn(Some(0), &v.sub(&pi).into(), Relation::Less);
        ranges.learn(Some(0), &w.clone().into(), Relation::Greater);
        ranges.learn(Some(0), &w.sub(&Polynomial::one()).into(), Relation::Less);
        ranges
    }

    #[test]
    fn a_combination_lies_between_the_sums_of_its_bounds() {
        // 2 v₁ − π v₂ + π/2 ∈ (−π/2, 5π/2)
        let terms = [
            (vec![(1, 1)], rational(2, 1)),
            (vec![(0, 1), (2, 1)], rational(-1, 1)),
            (vec![(0, 1)], rational(1, 2)),
        ];
        let range = ranges().of(Some(0), terms);
        assert_eq!(range, Range::of_pi((-1, 2, true), (5, 2, true)));
    }

    #[test]
    fn an_open_end_at_pi_is_within_pi_and_a_closed_one_is_not() {
        assert!(Range::of_pi((-1, 1, true), (1, 1, true)).is_within(1, 1));
        assert!(!Range::of_pi((-1, 1, true), (1, 1, false)).is_within(1, 1));
        assert!(!Range::of_pi((-1, 1, true), (5, 4, true)).is_within(1, 1));
        assert!(!Range { lower: None, upper: None }.is_within(1, 1));
    }

    #[test]
    fn a_condition_on_a_sum_bounds_the_sum_and_not_its_parts() {
        let mut ranges = Ranges::default();
        let sum = Polynomial::variable(1).add(&Polynomial::variable(2));
        ranges.learn(Some(0), &sum.clone().into(), Relation::GreaterEqual);
        ranges.learn(Some(0), &sum.sub(&Polynomial::variable(0)).into(), Relation::Less);
        let both = [(vec![(1, 1)], rational(1, 1)), (vec![(2, 1)], rational(1, 1))];
        assert_eq!(ranges.of(Some(0), both.clone()), Range::of_pi((0, 1, false), (1, 1, true)));
        assert_eq!(ranges.of(Some(0), [both[0].clone()]), Range::default());
    }

    #[test]
    fn a_tangent_is_exact_at_a_quarter_of_pi_and_enclosed_elsewhere() {
        let (lower, upper) = Range::of_pi((-1, 4, true), (1, 6, true)).tangents();
        assert_eq!(lower, Some(rational(-1, 1)));
        let upper = upper.unwrap();
        // √3/3
        assert!(&upper * &upper >= rational(1, 3) && upper < rational(58, 100));
        assert_eq!(Range::of_pi((0, 1, true), (3, 4, true)).tangents(), (None, None));
    }
}
