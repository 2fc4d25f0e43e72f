//! Fixed-point ranges [lower, upper]·2⁻ᵖ and their arithmetic, rounded outward.

use crate::expression::Rational;
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, Zero};

/// The reals from lower·2⁻ᵖ to upper·2⁻ᵖ.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Range {
    pub(super) lower: BigInt,
    pub(super) upper: BigInt,
    pub(super) precision: u32,
}

/// ⌊a·2⁻ˢ⌋
fn floor_shift(a: BigInt, shift: u32) -> BigInt {
    a >> shift
}

/// ⌈a·2⁻ˢ⌉ = −⌊−a·2⁻ˢ⌋
fn ceiling_shift(a: BigInt, shift: u32) -> BigInt {
    -(-a >> shift)
}

impl Range {
    pub(super) fn new(lower: BigInt, upper: BigInt, precision: u32) -> Self {
        debug_assert!(lower <= upper, "a range has its ends in order");
        Range { lower, upper, precision }
    }

    pub(super) fn integer(value: i64, precision: u32) -> Self {
        let scaled = BigInt::from(value) << precision;
        Range::new(scaled.clone(), scaled, precision)
    }

    /// Returns the narrowest range around a/b.
    pub(super) fn quotient(a: &BigInt, b: &BigInt, precision: u32) -> Self {
        let scaled = a << precision;
        Range::new(scaled.div_floor(b), Integer::div_ceil(&scaled, b), precision)
    }

    pub(super) fn rational(value: &Rational, precision: u32) -> Self {
        Range::quotient(value.numer(), value.denom(), precision)
    }

    /// Returns the same range at another precision, exactly if it is higher.
    pub(super) fn rescaled(&self, precision: u32) -> Self {
        if precision >= self.precision {
            let shift = precision - self.precision;
            return Range::new(&self.lower << shift, &self.upper << shift, precision);
        }
        let shift = self.precision - precision;
        let (lower, upper) =
            (floor_shift(self.lower.clone(), shift), ceiling_shift(self.upper.clone(), shift));
        Range::new(lower, upper, precision)
    }

    pub(super) fn lower_end(&self) -> Self {
        Range::new(self.lower.clone(), self.lower.clone(), self.precision)
    }

    pub(super) fn upper_end(&self) -> Self {
        Range::new(self.upper.clone(), self.upper.clone(), self.precision)
    }

    /// Returns the narrowest range around both.
    pub(super) fn hull(self, other: Range) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        Range::new(self.lower.min(other.lower), self.upper.max(other.upper), self.precision)
    }

    /// Returns the part within [−1, 1], for a range that meets it.
    pub(super) fn within_unit(self) -> Self {
        let one = BigInt::one() << self.precision;
        Range::new(self.lower.max(-&one), self.upper.min(one), self.precision)
    }

    /// Returns midpoint and radius, if the radius has less than half the places and so is
    /// negligible compared with the midpoint.
    pub(super) fn narrow_ball(&self) -> Option<(Range, BigInt)> {
        let middle: BigInt = (&self.lower + &self.upper) >> 1;
        let radius = &self.upper - &middle;
        let narrow = radius.bits() < u64::from(self.precision / 2);
        narrow.then(|| (Range::new(middle.clone(), middle, self.precision), radius))
    }

    pub(super) fn contains_zero(&self) -> bool {
        !self.lower.is_positive() && !self.upper.is_negative()
    }

    /// Returns the largest absolute value, in units of 2⁻ᵖ.
    pub(super) fn magnitude(&self) -> BigInt {
        self.lower.abs().max(self.upper.abs())
    }

    /// Whether |x| ≤ 2⁻ᵖ throughout.
    pub(super) fn is_within_one_unit(&self) -> bool {
        self.lower.bits() <= 1 && self.upper.bits() <= 1
    }

    /// Returns n with |x| < 2ⁿ throughout.
    pub(super) fn magnitude_bits(&self) -> u64 {
        self.lower.bits().max(self.upper.bits()).saturating_sub(u64::from(self.precision))
    }

    /// Moves both ends outward by some units of 2⁻ᵖ.
    pub(super) fn widened(self, units: &BigInt) -> Self {
        Range::new(self.lower - units, self.upper + units, self.precision)
    }

    /// [a, b] + [c, d] = [a + c, b + d]
    pub(super) fn add(&self, other: &Range) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        Range::new(&self.lower + &other.lower, &self.upper + &other.upper, self.precision)
    }

    /// Adds to this range in place.
    pub(super) fn accumulate(&mut self, other: &Range) {
        debug_assert_eq!(self.precision, other.precision);
        self.lower += &other.lower;
        self.upper += &other.upper;
    }

    /// [a, b] − [c, d] = [a − d, b − c]
    pub(super) fn subtract(&self, other: &Range) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        Range::new(&self.lower - &other.upper, &self.upper - &other.lower, self.precision)
    }

    /// −[a, b] = [−b, −a]
    pub(super) fn negate(&self) -> Self {
        Range::new(-&self.upper, -&self.lower, self.precision)
    }

    /// [a, b]·[c, d] = [min, max] of ac, ad, bc, bd
    pub(super) fn multiply(&self, other: &Range) -> Self {
        debug_assert_eq!(self.precision, other.precision);
        let (lower, upper) = product_ends(self, other);
        let p = self.precision;
        Range::new(floor_shift(lower, p), ceiling_shift(upper, p), p)
    }

    /// [a, b]·n/d for an exact n/d, rounded once
    pub(super) fn scaled(&self, factor: &Rational) -> Self {
        let (a, b) = (&self.lower * factor.numer(), &self.upper * factor.numer());
        let (lower, upper) = if factor.is_negative() { (b, a) } else { (a, b) };
        let d = factor.denom();
        Range::new(lower.div_floor(d), Integer::div_ceil(&upper, d), self.precision)
    }

    /// [a, b]/n for n > 0
    pub(super) fn divided_by_count(&self, n: u64) -> Self {
        if n == 1 {
            return self.clone();
        }
        let negated: BigInt = -&self.upper;
        Range::new(floor_quotient(&self.lower, n), -floor_quotient(&negated, n), self.precision)
    }

    /// [a, b]/2ˢ
    pub(super) fn halved(&self, times: u32) -> Self {
        let (lower, upper) = (self.lower.clone(), self.upper.clone());
        Range::new(floor_shift(lower, times), ceiling_shift(upper, times), self.precision)
    }

    /// [a, b]·2ˢ
    pub(super) fn doubled(&self, times: u32) -> Self {
        Range::new(&self.lower << times, &self.upper << times, self.precision)
    }

    /// {x² : x ∈ [a, b]}, which is narrower than [a, b]·[a, b] where 0 lies inside
    pub(super) fn square(&self) -> Self {
        let largest = self.magnitude();
        let smallest =
            if self.contains_zero() { BigInt::zero() } else { self.lower.abs().min(self.upper.abs()) };
        let p = self.precision;
        Range::new(floor_shift(&smallest * &smallest, p), ceiling_shift(&largest * &largest, p), p)
    }

    /// [a, b]/[c, d] = [min, max] of a/c, a/d, b/c, b/d, for 0 ∉ [c, d]
    pub(super) fn divide(&self, other: &Range) -> Self {
        debug_assert!(self.precision == other.precision && !other.contains_zero());
        if other.upper.is_negative() {
            return self.negate().divide(&other.negate());
        }
        let p = self.precision;
        let below = if self.lower.is_negative() { &other.lower } else { &other.upper };
        let above = if self.upper.is_negative() { &other.upper } else { &other.lower };
        let (lower, upper) = (&self.lower << p, &self.upper << p);
        Range::new(lower.div_floor(below), Integer::div_ceil(&upper, above), p)
    }

    /// √[a, b] = [√a, √b] for a ≥ 0, where √(n·2⁻ᵖ) = √(n·2ᵖ)·2⁻ᵖ
    pub(super) fn sqrt(&self) -> Self {
        debug_assert!(!self.lower.is_negative());
        let lower = (&self.lower << self.precision).sqrt();
        let radicand = &self.upper << self.precision;
        let root = radicand.sqrt();
        let upper = if &root * &root < radicand { root + 1 } else { root };
        Range::new(lower, upper, self.precision)
    }
}

/// ⌊a/n⌋ for n > 0
fn floor_quotient(a: &BigInt, n: u64) -> BigInt {
    let truncated = a / n;
    if a.is_negative() && &truncated * n != *a { truncated - 1 } else { truncated }
}

/// Returns the least and the largest product, chosen by the signs of the ends.
fn product_ends(a: &Range, b: &Range) -> (BigInt, BigInt) {
    let pick = |nonnegative: bool, yes, no| if nonnegative { yes } else { no };
    let (b_lower, b_upper) = (!b.lower.is_negative(), !b.upper.is_negative());
    if !a.lower.is_negative() {
        let lower = pick(b_lower, &a.lower, &a.upper) * &b.lower;
        return (lower, pick(b_upper, &a.upper, &a.lower) * &b.upper);
    }
    if !a.upper.is_positive() {
        let lower = pick(b_upper, &a.lower, &a.upper) * &b.upper;
        return (lower, pick(b_lower, &a.upper, &a.lower) * &b.lower);
    }
    let lower = (&a.lower * &b.upper).min(&a.upper * &b.lower);
    (lower, (&a.lower * &b.lower).max(&a.upper * &b.upper))
}
