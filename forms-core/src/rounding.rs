//! Rounding: how far a kernel's value in `f64`, or in the arithmetic of another target, can be from the true one, anywhere on
//! its domain.
//!
//! ```text
//! domain ─▶ boxes ─┬─ ranges: every value that rounding can make of each instruction   (forward)
//!    ▲             └─ sensitivities: how the output answers a change of each            (backward)
//!    └── split the worst ◀── Σ |∂output/∂vᵢ|·|vᵢ|·εᵢ
//! ```
//! Rounding makes vᵢ(1 + δᵢ) + ηᵢ of each instruction's value vᵢ, with |δᵢ| ≤ εᵢ and |ηᵢ| at most half the least
//! subnormal number. The output is a differentiable function of all δᵢ and ηᵢ, so that by the mean value theorem its
//! error is Σ ∂output/∂vᵢ · (vᵢδᵢ + ηᵢ) at some perturbed values, all of which lie in the ranges. No term of second
//! order is left out.
//!
//! Source: the sum is that of A. Solovyev et al., Rigorous estimation of floating-point round-off errors with symbolic
//! Taylor expansions, ACM TOPLAS 41 (2018), without its remainder, which the perturbed ranges contain.

mod arithmetic;
mod domain;
mod interval;
mod search;
mod sensitivity;

pub use arithmetic::Arithmetic;

use crate::kernel::Program;
use std::fmt;

/// Bounds of the error of one output, wherever the kernel is defined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ErrorBound {
    /// Of |computed − true|.
    pub absolute: f64,
    /// Of |computed − true|/|true|, if the output is kept away from 0.
    pub relative: Option<f64>,
}

impl ErrorBound {
    /// The relative bound in units of 2⁻⁵³, half an ulp.
    pub fn units(&self) -> Option<f64> {
        self.relative.map(|relative| relative * (1u64 << 53) as f64)
    }
}

impl fmt::Display for ErrorBound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.units() {
            Some(units) => write!(f, "{units:.1}·2⁻⁵³ of its size"),
            None => write!(f, "{:.1e}", self.absolute),
        }
    }
}

/// Why there is no bound.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Unbounded {
    /// The domain leaves this argument without an end.
    Argument(String),
    /// Within the boxes that were tried, an operation may overflow or is not defined, or a choice is not decided.
    Undecided,
    /// It contains an operation that is not followed: a numerical integral.
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

/// Boxes for what is said beside a kernel, which is generated inside the compiler of whoever uses it.
const BOXES_OF_DOCUMENTATION: usize = 64;

/// What is said beside a kernel of its rounding: a bound for each output, or nothing where there is none.
pub fn sentence(program: &Program) -> Option<String> {
    let bounds = program.error_bound(BOXES_OF_DOCUMENTATION).ok()?;
    let bounds: Vec<String> = bounds.iter().map(ErrorBound::to_string).collect();
    let of = if bounds.len() == 1 { "Its value" } else { "Each value" };
    Some(format!("{of} in `f64` is within {} of the true one, anywhere on the domain.", bounds.join(", ")))
}

impl Program {
    /// Bounds of the rounding error of each output over the whole domain, from at most so many boxes.
    ///
    /// Functions of the op table are taken to be within 2 ulp. More boxes make the bound sharper.
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

    /// [`Program::error_bound`] where operations round so.
    ///
    /// # Errors
    /// If the domain leaves an argument unbounded, or if no finite bound was found.
    pub fn error_bound_in(&self, arithmetic: Arithmetic, boxes: usize) -> Result<Vec<ErrorBound>, Unbounded> {
        // two roundings instead of one, and products whose roundings cancel, bound those of fused instructions
        search::error_bound(&self.unfused(), arithmetic, boxes)
    }
}
