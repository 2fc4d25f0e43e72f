//! Numbers of about 31 digits: the unevaluated sum of two `f64`.
//!
//! ```text
//! arithmetic ─┬─ exponential ─┬─ elementary functions ─ special functions
//!   └─ ends   └─ circular    ─┘
//! ```
//! The exponents are those of `f64`: a result beyond 2¹⁰²⁴ is infinite, and below 2⁻⁹⁰⁰ the second
//! word loses bits to underflow. The error bounds stated at the functions hold above 2⁻⁹⁰⁰.

mod arithmetic;
mod circular;
mod ends;
mod error_function;
mod exponential;
mod real;

/// high + low, with `high` the nearest `f64` to the sum; NaN and infinities have low = 0.
///
/// ```
/// use forms_math::{DoubleDouble, Real};
/// let third = DoubleDouble::from_f64(1.0) / DoubleDouble::from_f64(3.0);
/// assert_eq!((third.high(), third.low()), (1.0 / 3.0, 1.0 / 54.0 * f64::EPSILON * 4.5));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct DoubleDouble {
    high: f64,
    low: f64,
}

impl DoubleDouble {
    pub(crate) const ZERO: Self = Self { high: 0.0, low: 0.0 };
    pub(crate) const ONE: Self = Self { high: 1.0, low: 0.0 };
    pub(crate) const NAN: Self = Self { high: f64::NAN, low: 0.0 };

    /// Returns the sum of two numbers of any sizes.
    pub const fn new(high: f64, low: f64) -> Self {
        let (high, low) = crate::error_free::two_sum(high, low);
        if high.is_finite() { Self { high, low } } else { Self { high, low: 0.0 } }
    }

    /// Returns the nearest `f64`.
    pub const fn high(self) -> f64 {
        self.high
    }

    /// Returns the remainder after the nearest `f64`.
    pub const fn low(self) -> f64 {
        self.low
    }
}
