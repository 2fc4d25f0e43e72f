//! A number and a bound of its error.
//!
//! ```text
//! bound ─ number (what each type states of its rounding) ─ Guarded ─┬─ arithmetic
//!                                                                    ├─ functions, special functions
//!                                                                    ├─ choices
//!                                                                    └─ numbers beyond the exponents
//! ```
//! The bound of a result is that of its own rounding and what the errors of the arguments make of it, to all orders.
//! Arguments of a kernel have no error. Where a function is not defined for all that an argument may be, the result has
//! no bound; where it is defined for none of it, the result is undefined: NaN without an error.

mod arithmetic;
mod beyond;
mod bound;
mod functions;
mod number;
mod real;
mod special;

pub use bound::{Bound, Magnitude};
pub use number::{Guardable, Units};

/// A number whose exact value is at most `error` away.
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
    /// A number without error.
    pub fn exact(value: T) -> Self {
        let known = value.exponent().is_some() || value == T::from_f64(0.0) || value.is_beyond().is_some();
        Self { value, error: if known { T::Bound::ZERO } else { T::Bound::INFINITE } }
    }

    /// A number and a bound of its error.
    pub fn new(value: T, error: T::Bound) -> Self {
        if value.is_nan() { Self::undecided(value) } else { Self { value, error } }
    }

    /// What is defined nowhere.
    pub fn undefined() -> Self {
        Self { value: T::nan(), error: T::Bound::ZERO }
    }

    /// A number of which nothing is known.
    pub(crate) fn undecided(value: T) -> Self {
        Self { value, error: T::Bound::INFINITE }
    }

    /// The number.
    pub fn value(self) -> T {
        self.value
    }

    /// The bound of its error.
    pub fn error(self) -> T::Bound {
        self.error
    }

    /// True where the exact value is no number.
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
