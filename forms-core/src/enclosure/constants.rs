//! π and log 2, from series of reciprocals of integers; constants are computed once and kept.

use super::bounds::{Enclosure, Precision};
use super::range::Range;
use super::series::odd_reciprocals;
use num_bigint::BigInt;
use std::sync::OnceLock;

/// Precisions at which the constants are computed once and kept. The first one is nearly always
/// enough, and the second costs a millisecond. The others serve numbers near the ends of the range
/// of `f64`.
pub(super) const KEPT: [u32; 4] = [320, 1280, 2560, 5120];

/// A constant at each of these precisions.
pub(super) type Kept = [OnceLock<Range>; KEPT.len()];

/// Guard places that absorb the rounding of a few thousand terms.
pub(super) const GUARD: u32 = 24;

impl Enclosure {
    /// Encloses π.
    pub fn pi(precision: Precision) -> Self {
        Enclosure::from_range(pi(precision.0))
    }
}

/// Machin: π = 16 arctan(1/5) − 4 arctan(1/239)
pub(super) fn pi(precision: u32) -> Range {
    static KEPT_PI: Kept = [const { OnceLock::new() }; KEPT.len()];
    constant(precision, &KEPT_PI, |p| {
        combination(&[(16, 5), (-4, 239)], p, |reciprocal| reciprocal.square().negate())
    })
}

/// log 2 = 18 artanh(1/26) − 2 artanh(1/4801) + 8 artanh(1/8749)
pub(super) fn log_two(precision: u32) -> Range {
    static KEPT_LOG_TWO: Kept = [const { OnceLock::new() }; KEPT.len()];
    constant(precision, &KEPT_LOG_TWO, |p| combination(&[(18, 26), (-2, 4801), (8, 8749)], p, Range::square))
}

/// Returns a constant, kept at the precisions at which it was computed.
pub(super) fn constant(precision: u32, kept: &Kept, compute: impl Fn(u32) -> Range) -> Range {
    for (place, known) in KEPT.into_iter().zip(kept) {
        if precision + GUARD <= place {
            return known.get_or_init(|| compute(place)).rescaled(precision);
        }
    }
    compute(precision + GUARD).rescaled(precision)
}

/// Σ c Σₖ ratioᵏ/((2k+1) n) over the pairs (c, n), with the ratio ±1/n²
fn combination(terms: &[(i64, i64)], precision: u32, ratio: impl Fn(&Range) -> Range) -> Range {
    let mut sum = Range::integer(0, precision);
    for &(factor, n) in terms {
        let reciprocal = Range::quotient(&BigInt::from(1), &BigInt::from(n), precision);
        let ratio = ratio(&reciprocal);
        let term = odd_reciprocals(reciprocal, &ratio);
        sum = sum.add(&term.scaled(&BigInt::from(factor).into()));
    }
    sum
}
