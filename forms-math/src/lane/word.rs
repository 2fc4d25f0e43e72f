//! Operations on a floating-point format that the functions of lanes need: arithmetic, comparisons
//! and bit operations.
//!
//! Every operation is one or a few instructions that every vector unit has, without calls and
//! branches, so that a loop over it is vectorised. Conversions between floating-point numbers and
//! integers add 1.5·2^(p−1), where p is the precision, which leaves the integer in the low bits.

use super::coefficients::{self, Coefficients};
use crate::float;
use core::cmp::Ordering;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Floating-point number of a format, in one lane of a vector.
pub(crate) trait Word:
    Copy
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// The format outside lanes.
    type Raw: Copy + 'static;
    /// Its polynomials and constants.
    const TABLE: Coefficients<Self::Raw>;
    /// Whether [`Word::fused`] rounds once.
    const FUSED: bool;
    /// Exponent of two up to which pair arithmetic is certainly valid.
    const LARGE: i32;
    /// Exponent of two down to which pair arithmetic is certainly valid: the rounding error of a
    /// product is still normal.
    const SMALL: i32;
    /// Precision in bits.
    const PRECISION: i32;
    /// Exponent of the largest power of two.
    const LARGEST_EXPONENT: i32;
    /// Number of bits of the largest multiple of π/2 for which [`Coefficients::half_pi`] is valid.
    const MULTIPLE_BITS: i32;

    /// Wraps a number.
    fn of(raw: Self::Raw) -> Self;
    /// Returns the nearest number of this format.
    fn literal(value: f64) -> Self;
    /// Converts to `f64`.
    fn to_double(self) -> f64;
    /// Computes self · factor + summand, with one rounding if the processor has an instruction for
    /// it.
    fn fused(self, factor: Self, summand: Self) -> Self;
    /// √x
    fn root(self) -> Self;
    /// |x|
    fn magnitude(self) -> Self;
    /// Returns |x| with the sign of `sign`.
    fn with_sign(self, sign: Self) -> Self;
    /// Returns the leading half of the significand.
    fn leading_half(self) -> Self;
    /// Adds 1.5·2^(p−1): the low bits of the sum are the nearest integer of `self`.
    fn shifted(self) -> Self;
    /// Subtracts 1.5·2^(p−1), which gives that nearest integer.
    fn unshifted(self) -> Self;
    /// Computes 2^k for an integer k in the range of exponents of normal numbers.
    fn power_of_two(self) -> Self;
    /// Returns (−k, 2^k) for the nearest integer k from −(b + p) to b + 1 − p, where b is the
    /// largest exponent. The power can be subnormal; it is 0 for the first k, and ∞ for the last.
    fn opposite_exponent_and_power(self) -> (Self, Self);
    /// Returns (k, m) with x = m 2^k and √½ ≤ m < √2, for a positive normal number.
    fn split(self) -> (Self, Self);
    /// Returns `odd` if the shifted integer is odd, and `even` if it is even.
    fn if_odd(shifted: Self, odd: Self, even: Self) -> Self;
    /// Returns −x if bit 1 of the shifted integer is set, otherwise x.
    fn negated_by_second_bit(self, shifted: Self) -> Self;

    /// Returns 2^exponent, at compile time.
    #[inline(always)]
    fn two_to(exponent: i32) -> Self {
        Self::literal(f64::from_bits(((1023 + i64::from(exponent)) as u64) << 52))
    }
    /// Returns NaN.
    #[inline(always)]
    fn not_a_number() -> Self {
        Self::literal(f64::NAN)
    }
    /// Returns ∞.
    #[inline(always)]
    fn infinity() -> Self {
        Self::literal(f64::INFINITY)
    }
    /// Evaluates c₀ + c₁ x + …: the even and the odd terms in parallel, each by Horner's rule in
    /// x², so that the second does not wait for the first.
    #[inline(always)]
    fn polynomial(self, coefficients: &'static [Self::Raw]) -> Self {
        let square = self * self;
        let (mut even, mut odd) = (Self::literal(0.0), Self::literal(0.0));
        let (pairs, rest) = coefficients.as_chunks::<2>();
        if let [last] = rest {
            even = Self::of(*last);
        }
        for (position, &[of_even, of_odd]) in pairs.iter().enumerate().rev() {
            let is_last = position + 1 == pairs.len();
            even = if is_last && rest.is_empty() {
                Self::of(of_even)
            } else {
                even.fused(square, Self::of(of_even))
            };
            odd = if is_last { Self::of(of_odd) } else { odd.fused(square, Self::of(of_odd)) };
        }
        odd.fused(self, even)
    }
}

macro_rules! word {
    (
        $lane:ident, $raw:ident, $bits:ident, $table:ident,
        $precision:literal, $small:literal, $large:literal, $multiple:literal
    ) => {
        #[doc = concat!("A lane of `", stringify!($raw), "`, with or without fused multiply-add.")]
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $lane<const FMA: bool>(pub $raw);

        impl<const FMA: bool> $lane<FMA> {
            const SHIFT: $raw = 1.5 * (1u64 << ($precision - 1)) as $raw;
            /// Bits of √½, at which significands begin, and their distance from the bits of 1.
            const LEAST: $bits = core::$raw::consts::FRAC_1_SQRT_2.to_bits();
            const OFFSET: $bits = (1.0 as $raw).to_bits() - Self::LEAST;
            /// Number whose low bits can be set to those of an integer.
            const INTEGER: $raw = (1u64 << ($precision - 1)) as $raw;
            const BIAS: $raw = (1.0 as $raw).to_bits() as f64 as $raw / (1u64 << ($precision - 1)) as $raw;
            /// Summand for an integer k that makes the low bits of the sum the stored exponent of
            /// 2^(k + p).
            const EXPONENT_SHIFT: $raw = Self::SHIFT + ($raw::MAX_EXP - 1 + $precision) as $raw;
            /// 2^−p
            const UNIT_ROUNDOFF: $raw = 1.0 / (1u64 << $precision) as $raw;
            const SIGN: $bits = 1 << ($bits::BITS - 1);
        }

        impl<const FMA: bool> Word for $lane<FMA> {
            type Raw = $raw;
            const TABLE: Coefficients<$raw> = coefficients::$table;
            const FUSED: bool = FMA;
            const LARGE: i32 = $large;
            const SMALL: i32 = $small;
            const PRECISION: i32 = $precision;
            const LARGEST_EXPONENT: i32 = $raw::MAX_EXP - 1;
            const MULTIPLE_BITS: i32 = $multiple;

            #[inline(always)]
            fn of(raw: $raw) -> Self {
                Self(raw)
            }
            #[inline(always)]
            fn literal(value: f64) -> Self {
                Self(value as $raw)
            }
            #[inline(always)]
            fn to_double(self) -> f64 {
                self.0.into()
            }
            #[inline(always)]
            fn fused(self, factor: Self, summand: Self) -> Self {
                if FMA { Self(float::$raw::mul_add(self.0, factor.0, summand.0)) } else { self * factor + summand }
            }
            #[inline(always)]
            fn root(self) -> Self {
                Self(float::$raw::sqrt(self.0))
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                Self(self.0.abs())
            }
            #[inline(always)]
            fn with_sign(self, sign: Self) -> Self {
                Self(self.0.copysign(sign.0))
            }
            #[inline(always)]
            fn leading_half(self) -> Self {
                Self($raw::from_bits(self.0.to_bits() & ($bits::MAX << ($precision / 2 + $precision % 2))))
            }
            #[inline(always)]
            fn shifted(self) -> Self {
                Self(self.0 + Self::SHIFT)
            }
            #[inline(always)]
            fn unshifted(self) -> Self {
                Self(self.0 - Self::SHIFT)
            }
            #[inline(always)]
            fn power_of_two(self) -> Self {
                let exponent = self.shifted().0.to_bits() << ($precision - 1);
                Self($raw::from_bits(exponent.wrapping_add((1.0 as $raw).to_bits())))
            }
            #[inline(always)]
            fn opposite_exponent_and_power(self) -> (Self, Self) {
                let shifted = self.0 + Self::EXPONENT_SHIFT;
                let above = $raw::from_bits(shifted.to_bits() << ($precision - 1));
                (Self(Self::EXPONENT_SHIFT - shifted), Self(above * Self::UNIT_ROUNDOFF))
            }
            #[inline(always)]
            fn split(self) -> (Self, Self) {
                let bits = self.0.to_bits().wrapping_add(Self::OFFSET);
                let exponent = $raw::from_bits((bits >> ($precision - 1)) | Self::INTEGER.to_bits());
                let significand = (bits & ((1 << ($precision - 1)) - 1)).wrapping_add(Self::LEAST);
                (Self(exponent - (Self::INTEGER + Self::BIAS)), Self($raw::from_bits(significand)))
            }
            #[inline(always)]
            fn if_odd(shifted: Self, odd: Self, even: Self) -> Self {
                let mask = (shifted.0.to_bits() & 1).wrapping_neg();
                Self($raw::from_bits((odd.0.to_bits() & mask) | (even.0.to_bits() & !mask)))
            }
            #[inline(always)]
            fn negated_by_second_bit(self, shifted: Self) -> Self {
                let sign = (shifted.0.to_bits() << ($bits::BITS - 2)) & Self::SIGN;
                Self($raw::from_bits(self.0.to_bits() ^ sign))
            }
        }

        word!(@operator $lane, Add, add, +);
        word!(@operator $lane, Sub, sub, -);
        word!(@operator $lane, Mul, mul, *);
        word!(@operator $lane, Div, div, /);

        impl<const FMA: bool> Neg for $lane<FMA> {
            type Output = Self;
            #[inline(always)]
            fn neg(self) -> Self {
                Self(-self.0)
            }
        }

        // Each comparison is a single hardware comparison: comparisons through `Ordering` are not
        // vectorised.
        impl<const FMA: bool> PartialOrd for $lane<FMA> {
            #[inline(always)]
            fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
                self.0.partial_cmp(&other.0)
            }
            #[inline(always)]
            fn lt(&self, other: &Self) -> bool {
                self.0 < other.0
            }
            #[inline(always)]
            fn le(&self, other: &Self) -> bool {
                self.0 <= other.0
            }
            #[inline(always)]
            fn gt(&self, other: &Self) -> bool {
                self.0 > other.0
            }
            #[inline(always)]
            fn ge(&self, other: &Self) -> bool {
                self.0 >= other.0
            }
        }
    };
    (@operator $lane:ident, $trait:ident, $name:ident, $operator:tt) => {
        impl<const FMA: bool> $trait for $lane<FMA> {
            type Output = Self;
            #[inline(always)]
            fn $name(self, other: Self) -> Self {
                Self(self.0 $operator other.0)
            }
        }
    };
}

word!(Lane64, f64, u64, F64, 53, -900, 990, 20);
word!(Lane32, f32, u32, F32, 24, -95, 120, 12);
