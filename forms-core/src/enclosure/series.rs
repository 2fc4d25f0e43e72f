//! Power series of ranges with a rigorous remainder, and monotone functions evaluated at their
//! ends.

use super::bounds::{Enclosure, Value};
use super::range::Range;
use num_bigint::BigInt;

/// Divisors of the next power and of the current term of a series.
pub(super) struct Divisors {
    /// Divisor of the power that follows the k-th.
    pub(super) step: u64,
    /// Divisor of the k-th power that gives the k-th term.
    pub(super) term: u64,
}

/// Returns Σ aₖ with aₖ = bₖ/termₖ and bₖ₊₁ = bₖ·ratio/stepₖ, for |ratio|/stepₖ ≤ ½.
///
/// Rounding is covered by the arithmetic of ranges. Summation stops before the first |bₙ| ≤ 2⁻ᵖ,
/// and the omitted terms are |aₙ + aₙ₊₁ + …| ≤ |bₙ|·(1 + ½ + ¼ + …) = 2|bₙ| ≤ 2·2⁻ᵖ.
pub(super) fn series(first: Range, ratio: &Range, divisors: impl Fn(u64) -> Divisors) -> Range {
    sum_of(first, ratio, divisors, |_| true)
}

/// Returns the same sum for a ratio of any size and steps that grow: summation does not stop before
/// |ratio|/stepₖ ≤ ½ holds from there on.
pub(super) fn entire_series(first: Range, ratio: &Range, divisors: impl Fn(u64) -> Divisors) -> Range {
    let (doubled, precision) = (ratio.magnitude() << 1, ratio.precision);
    let shrinks = |step: u64| doubled <= BigInt::from(step) << precision;
    sum_of(first, ratio, divisors, shrinks)
}

fn sum_of(
    first: Range,
    ratio: &Range,
    divisors: impl Fn(u64) -> Divisors,
    may_end: impl Fn(u64) -> bool,
) -> Range {
    let mut sum = Range::integer(0, first.precision);
    let mut power = first;
    let mut k = 0;
    loop {
        let Divisors { step, term } = divisors(k);
        if power.is_within_one_unit() && may_end(step) {
            break;
        }
        if term == 1 {
            sum.accumulate(&power);
        } else {
            sum.accumulate(&power.divided_by_count(term));
        }
        power = power.multiply(ratio).divided_by_count(step);
        k += 1;
    }
    sum.widened(&2.into())
}

/// Σ ratioᵏ·first/(2k+1), which is artanh z for ratio = z² and arctan z for ratio = −z², with first
/// = z
pub(super) fn odd_reciprocals(first: Range, ratio: &Range) -> Range {
    series(first, ratio, |k| Divisors { step: 1, term: 2 * k + 1 })
}

impl Enclosure {
    /// Returns {f(x)} for an increasing f, given as its image of narrow ranges with `guard`
    /// additional places.
    pub(super) fn increasing(&self, guard: u32, image: impl Fn(&Range) -> Range) -> Enclosure {
        let precision = self.precision().0;
        let working = precision + guard;
        let image = match &self.0 {
            Value::Exact(value, _) => image(&Range::rational(value, working)),
            Value::Range(range) => {
                let range = range.rescaled(working);
                image(&range.lower_end()).hull(image(&range.upper_end()))
            }
        };
        Enclosure::from_range(image.rescaled(precision))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every term is exact here, so the enclosure of 2 depends on the remainder alone.
    #[test]
    fn the_remainder_of_the_geometric_series_is_enclosed_to_the_last_unit() {
        let half = Range::integer(1, 20).halved(1);
        let sum = series(Range::integer(1, 20), &half, |_| Divisors { step: 1, term: 1 });
        assert_eq!(sum.upper, Range::integer(2, 20).upper);
    }
}
