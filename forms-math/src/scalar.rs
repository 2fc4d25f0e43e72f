//! Operations that elementary and special functions need from a single number, and choices by its
//! order.

use crate::Real;

/// [`Real`] that is a single number: code can branch on its order, and its precision is known.
pub trait Scalar: Real + PartialOrd + Send + Sync + 'static {
    /// Number of bits of the significand.
    const PRECISION: u32;
    /// Type in which tables of this type are computed, so that each entry is rounded once.
    type Wider: Scalar;
    /// Rounds to the nearest number.
    fn rounded(wider: Self::Wider) -> Self;

    /// π
    fn pi() -> Self;
    /// ln 2
    fn ln_2() -> Self;
    /// Euler's constant γ
    fn euler_gamma() -> Self;
    /// Converts an integer to the nearest number.
    fn from_integer(value: i64) -> Self;
    /// Returns e of a finite non-zero number m 2ᵉ with ½ ≤ |m| < 1.
    fn exponent(self) -> Option<i64>;
    /// Whether this is NaN.
    #[inline(always)]
    fn is_nan(self) -> bool {
        self.partial_cmp(&self).is_none()
    }
    /// self · 2^exponent
    fn scaled(self, exponent: i64) -> Self;
    /// Returns (q mod 4, self − q π/2) with q the nearest integer. The remainder has a small
    /// relative error.
    fn quadrant(self) -> (u8, Self);
    /// (sin x, cos x)
    fn sine_and_cosine(self) -> (Self, Self);
}

/// Choices by a single comparison, for types with a hardware order.
macro_rules! either_choices {
    () => {
        #[inline(always)]
        fn either_if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left < right { then } else { otherwise }
        }
        #[inline(always)]
        fn either_if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left <= right { then } else { otherwise }
        }
        #[inline(always)]
        fn either_if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left == right { then } else { otherwise }
        }
    };
}
pub(crate) use either_choices;

/// All choices of types with a hardware order.
macro_rules! choices {
    () => {
        #[inline(always)]
        fn if_less(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left < right {
                then
            } else if left >= right {
                otherwise
            } else {
                Self::nan()
            }
        }
        #[inline(always)]
        fn if_less_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left <= right {
                then
            } else if left > right {
                otherwise
            } else {
                Self::nan()
            }
        }
        #[inline(always)]
        fn if_equal(left: Self, right: Self, then: Self, otherwise: Self) -> Self {
            if left == right {
                then
            } else if left.partial_cmp(&right).is_some() {
                otherwise
            } else {
                Self::nan()
            }
        }
        $crate::scalar::either_choices!();
    };
}
pub(crate) use choices;
