//! Half turns: the signs of sine and cosine of an angle that stays within a half turn.

use super::range::{End, PRECISION, Range};
use crate::enclosure::Enclosure;
use crate::expression::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering;

impl Range {
    /// Returns the sign of the sine on this range: whether the sine is never negative (true) or
    /// never positive (false), and whether it is never zero.
    pub(crate) fn sign_of_sine(&self) -> Option<(bool, bool)> {
        self.sign_between_multiples((0, 1))
    }

    /// Returns the sign of the cosine on this range, in the same form.
    pub(crate) fn sign_of_cosine(&self) -> Option<(bool, bool)> {
        self.sign_between_multiples((1, 2))
    }

    /// Returns the ends as fractions of π, if they are multiples of π/4 or π/6 and at most half a
    /// turn apart.
    pub(crate) fn within_half_a_turn(&self) -> Option<(Rational, Rational)> {
        let (lower, upper) = (self.lower.as_ref()?, self.upper.as_ref()?);
        let is_simple = |end: &End| {
            end.rational.is_zero() && [4, 6].iter().any(|&n| (&end.turns * BigInt::from(n)).is_integer())
        };
        let width = &upper.turns - &lower.turns;
        (is_simple(lower) && is_simple(upper) && width <= BigRational::from_integer(1.into()))
            .then(|| (lower.turns.clone(), upper.turns.clone()))
    }

    /// Returns the sign of sin(x + (p/q)π), which is the sign of (−1)ᵐ where x + (p/q)π lies
    /// between mπ and (m + 1)π.
    fn sign_between_multiples(&self, (p, q): (i64, i64)) -> Option<(bool, bool)> {
        let (lower, upper) = (self.lower.as_ref()?, self.upper.as_ref()?);
        let shift = End::of_pi(p, q, false);
        let (lower, upper) = (lower.add(&shift), upper.add(&shift));
        let start = lower.enclosure(PRECISION).div(&Enclosure::pi(PRECISION)).ok()?.lower();
        let first = start.round().to_integer();
        for multiple in [&first - 1, first.clone(), &first + 1] {
            let from = End { rational: BigRational::zero(), turns: multiple.clone().into(), open: false };
            let to = from.add(&End::of_pi(1, 1, false));
            let above = lower.compare(&from);
            let below = upper.compare(&to);
            let is_inside = matches!(above, Some(Ordering::Greater | Ordering::Equal))
                && matches!(below, Some(Ordering::Less | Ordering::Equal));
            if is_inside {
                let strict = (above == Some(Ordering::Greater) || lower.open)
                    && (below == Some(Ordering::Less) || upper.open);
                return Some((multiple.is_even(), strict));
            }
        }
        None
    }
}
