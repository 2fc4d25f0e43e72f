//! A number and a bound of its error.
//!
//! ```text
//! bound ─ number (rounding errors of each type) ─ Guarded ─┬─ arithmetic
//!                                                          ├─ functions, special functions
//!                                                          ├─ choices
//!                                                          └─ numbers beyond the exponents
//! ```
//! The bound of a result consists of its own rounding error and the propagated errors of the
//! arguments, to all orders. Arguments of a kernel have no error. If a function is undefined for a
//! part of the possible arguments, the result has no bound; if it is undefined for all of them, the
//! result is undefined: NaN without an error.

mod arithmetic;
mod beyond;
mod bound;
mod functions;
mod number;
mod real;
mod special;

pub use bound::{Bound, Magnitude};
pub use number::{Guardable, Units};

/// Number whose exact value is at most `error` away.
///
/// ```
/// use forms_math::{Guarded, Real};
/// let x = Guarded::<f64>::from_f64(1.0) / Guarded::from_f64(3.0);
/// assert!(x.error() > 0.0 && x.error() <= 2.0_f64.powi(-54));
/// // both are close, so that their difference is exact, and keeps the error of x
/// let difference = x - Guarded::from_f64(0.333);
/// assert!(difference.error() >= x.error() && difference.error() < 1.001 * x.error());
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Guarded<T: Guardable> {
    value: T,
    error: T::Bound,
}

impl<T: Guardable> Guarded<T> {
    /// Creates a number without error.
    pub fn exact(value: T) -> Self {
        let known = value.exponent().is_some() || value == T::from_f64(0.0) || value.is_beyond().is_some();
        Self { value, error: if known { T::Bound::ZERO } else { T::Bound::INFINITE } }
    }

    /// Creates a number with an error bound.
    pub fn new(value: T, error: T::Bound) -> Self {
        if value.is_nan() { Self::undecided(value) } else { Self { value, error } }
    }

    /// Returns an undefined value.
    pub fn undefined() -> Self {
        Self { value: T::nan(), error: T::Bound::ZERO }
    }

    /// Returns a number without a known bound.
    pub(crate) fn undecided(value: T) -> Self {
        Self { value, error: T::Bound::INFINITE }
    }

    /// Returns the number.
    pub fn value(self) -> T {
        self.value
    }

    /// Returns the error bound.
    pub fn error(self) -> T::Bound {
        self.error
    }

    /// Whether the exact value is undefined.
    pub fn is_undefined(self) -> bool {
        self.value.is_nan() && self.error.is_zero()
    }

    fn is_exact(self) -> bool {
        self.error.is_zero()
    }

    fn is_exact_zero(self) -> bool {
        self.is_exact() && self.value == T::from_f64(0.0)
    }
}
