//! Rounding analysis: a bound on the difference between a kernel's value in `f64`, or in the
//! arithmetic of another target, and the exact value, over the whole domain.
//!
//! ```text
//! domain ─▶ boxes ─┬─ ranges: all values of each instruction, with rounding            (forward)
//!    ▲             └─ sensitivities: derivatives of the output by each value           (backward)
//!    └── split the worst ◀── Σ |∂output/∂vᵢ|·|vᵢ|·εᵢ
//! ```
//! Rounding turns each instruction's value vᵢ into vᵢ(1 + δᵢ) + ηᵢ, with |δᵢ| ≤ εᵢ and |ηᵢ| at most
//! half the smallest subnormal number. The output is a differentiable function of all δᵢ and ηᵢ, so
//! that by the mean value theorem its error is Σ ∂output/∂vᵢ · (vᵢδᵢ + ηᵢ) at some perturbed
//! values, all of which lie in the ranges. No second-order term is omitted.
//!
//! Source: the sum is the first-order term of A. Solovyev et al., Rigorous estimation of
//! floating-point round-off errors with symbolic Taylor expansions, ACM TOPLAS 41 (2018), without
//! the remainder term, which the perturbed ranges cover.

mod arithmetic;
mod domain;
mod interval;
mod search;
mod sensitivity;

#[cfg(feature = "internals")]
pub use arithmetic::Arithmetic;
#[cfg(not(feature = "internals"))]
pub(crate) use arithmetic::Arithmetic;

use crate::expression::Rational;
use crate::kernel::{Program, nearest_f64};
use std::fmt;

/// Error bounds of one output, valid wherever the kernel is defined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBound {
    /// Bound of |computed − true|.
    pub absolute: f64,
    /// Bound of |computed − true|/|true|, if the output is bounded away from 0.
    pub relative: Option<f64>,
}

impl ErrorBound {
    /// Returns the relative bound in units of 2⁻⁵³, half an ulp.
    pub fn units(&self) -> Option<f64> {
        self.relative.map(|relative| relative * (1u64 << 53) as f64)
    }
}

impl fmt::Display for ErrorBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(&Arithmetic::DOUBLE))
    }
}

impl ErrorBound {
    /// Returns the bound in the units of an arithmetic.
    fn text(&self, arithmetic: &Arithmetic) -> String {
        match self.relative {
            Some(relative) => {
                format!("{:.1}·{} of its magnitude", relative / arithmetic.unit, arithmetic.unit_name())
            }
            None => format!("{:.1e}", self.absolute),
        }
    }
}

/// Reason why there is no bound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unbounded {
    /// The domain does not bound this argument on both sides.
    Argument(String),
    /// On one of the boxes, an operation can overflow or is undefined, or a condition is undecided.
    Undecided,
    /// The kernel contains an operation that the analysis does not cover: a numerical integral.
    NotStraight,
}

impl fmt::Display for Unbounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Unbounded::Argument(name) => write!(f, "the domain does not bound `{name}` on both sides"),
            Unbounded::Undecided => f.write_str("no bound was found on the whole domain"),
            Unbounded::NotStraight => f.write_str("it contains a numerical integral"),
        }
    }
}

/// Maximum number of boxes for the bound in a kernel's documentation. It is small because the bound
/// is computed at compile time of the user's crate.
const BOXES_OF_DOCUMENTATION: usize = 64;

/// Maximum number of boxes for the bound that keeps a promise.
const BOXES_OF_PROMISE: usize = 256;

/// Returns the sentence on rounding in a kernel's documentation: a bound for each output, or `None`
/// where there is none.
pub fn sentence(program: &Program) -> Option<String> {
    Some(format!("{}.", claim(program, Arithmetic::DOUBLE)?))
}

/// Returns the bounds in the arithmetic of a target as a claim without a full stop, or `None` where
/// there is none.
pub(crate) fn claim(program: &Program, arithmetic: Arithmetic) -> Option<String> {
    let bounds = program.error_bound_in(arithmetic, BOXES_OF_DOCUMENTATION).ok()?;
    let bounds: Vec<String> = bounds.iter().map(|bound| bound.text(&arithmetic)).collect();
    let of = if bounds.len() == 1 { "its value" } else { "each value" };
    Some(format!(
        "The rounding error of {of} in `{}` is at most {}, everywhere on the domain (bound)",
        arithmetic.format(),
        bounds.join(", ")
    ))
}

/// Returns a bound of the relative error of every value, in units of the arithmetic; `None` if there
/// is only an absolute one. `approximation` is the relative error before rounding.
pub(crate) fn units(bounds: &[ErrorBound], arithmetic: Arithmetic, approximation: f64) -> Option<f64> {
    let worst = bounds.iter().try_fold(0.0, |worst: f64, bound| Some(worst.max(bound.relative?)))?;
    // (1 + ε)(1 + δ) − 1, rounded upward
    let both = (worst + approximation + worst * approximation) * (1.0 + 4.0 * f64::EPSILON);
    (!both.is_nan()).then_some(both / arithmetic.unit)
}

impl Program {
    /// Bounds the rounding error of each output over the whole domain, with at most `boxes`
    /// subdivisions.
    ///
    /// Functions of the op table are assumed accurate to 2 ulp, sine and cosine of large angles to an
    /// absolute error. More boxes make the bound sharper.
    ///
    /// ```
    /// use forms_core::compile::{Options, compile};
    /// let compiled = compile("kernel half_root(x) = sqrt(x)/3 where 1 <= x <= 4;", &Options::default());
    /// let program = compiled.kernels[0].program();
    /// // the root's rounding and that of the factor 1/3 or of the division
    /// let units = program.error_bound(100).unwrap()[0].units().unwrap();
    /// assert!(units >= 1.5 && units < 3.5, "{units}");
    /// ```
    ///
    /// # Errors
    /// If the domain leaves an argument unbounded, or if no finite bound was found.
    pub fn error_bound(&self, boxes: usize) -> Result<Vec<ErrorBound>, Unbounded> {
        self.error_bound_in(Arithmetic::DOUBLE, boxes)
    }

    /// Returns a bound of the relative error of every value in `f64`, in units of 2⁻⁵³, if it is
    /// below `within`. `approximation` is the relative error before rounding.
    pub(crate) fn keeps(&self, within: &Rational, approximation: f64) -> Option<f64> {
        let bounds = self.bounds_of_promise(Arithmetic::DOUBLE).ok()?;
        let units = units(&bounds, Arithmetic::DOUBLE, approximation)?;
        (units <= nearest_f64(within).next_down()).then_some(units)
    }

    /// Returns the bounds that decide whether a promise is kept.
    pub(crate) fn bounds_of_promise(&self, arithmetic: Arithmetic) -> Result<Vec<ErrorBound>, Unbounded> {
        self.error_bound_in(arithmetic, BOXES_OF_PROMISE)
    }

    /// Bounds the rounding errors as [`Program::error_bound`] does, for operations that round as in
    /// `arithmetic`.
    ///
    /// # Errors
    /// If the domain leaves an argument unbounded, or if no finite bound was found.
    pub fn error_bound_in(&self, arithmetic: Arithmetic, boxes: usize) -> Result<Vec<ErrorBound>, Unbounded> {
        // the bound with two roundings instead of one, and with products whose roundings cancel,
        // also covers fused instructions
        let split = if arithmetic.is_fused { self.unfused() } else { self.with_rounded_corrections() };
        search::error_bound(&split, arithmetic, boxes)
    }
}
