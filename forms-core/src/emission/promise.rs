//! `within` promises in a target: kept by higher precision, kept by a bound of the rounding error,
//! or not kept and reported.

use super::features::check;
use super::target::{Precision, Source, Target};
use crate::expression::Rational;
use crate::kernel::nearest_f64;
use crate::rounding::{Arithmetic, units};

/// How the emitted value of a kernel with `within` relates to the exact one.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Promise {
    /// The promise is kept by the precision that it needs.
    ByPrecision,
    /// The rounding error of the form is bounded by this number of units, which is within the
    /// promise.
    ByBound(f64),
    /// The form is computed in double precision, and rounded: within the bound in units of single
    /// precision, if it is known.
    InDouble {
        /// The bound, which is within the promise.
        bound: Option<f64>,
        /// Reason why single precision alone does not keep the promise.
        reason: String,
    },
    /// The promise is not kept, for this reason.
    NotKept(String),
}

/// Decides how a promise is kept if a kernel is emitted in a precision of a target.
pub(super) fn promise(source: &Source, within: &Rational, target: Target, precision: Precision) -> Promise {
    if target == Target::Rust && precision == Precision::DoubleDouble {
        return Promise::ByPrecision;
    }
    let arithmetic = arithmetic(target, precision);
    let approximation = source.approximated.as_ref().map_or(0.0, |approximated| approximated.error);
    let promise = match source.program.bounds_of_promise(arithmetic) {
        Ok(bounds) => match units(&bounds, arithmetic, approximation) {
            Some(units) if units <= nearest_f64(within).next_down() => Promise::ByBound(units),
            Some(units) => Promise::NotKept(format!(
                "the relative rounding error is bounded only by {units:.1}·{} on the domain",
                unit(precision)
            )),
            None => {
                let absolute = bounds.iter().map(|bound| bound.absolute).fold(0.0, f64::max);
                Promise::NotKept(format!(
                    "the absolute rounding error is bounded by {absolute:.1e} on the domain; no relative bound \
                     is known"
                ))
            }
        },
        Err(reason) => Promise::NotKept(format!("no error bound is known, because {reason}")),
    };
    match promise {
        // numbers with more digits are available
        Promise::NotKept(_) if target == Target::Rust => Promise::ByPrecision,
        Promise::NotKept(reason) if precision == Precision::F32 && target != Target::Wgsl => {
            Promise::InDouble { bound: bound_in_double(source, within), reason }
        }
        promise => promise,
    }
}

/// Units of 2⁻⁵³ in a unit of 2⁻²⁴.
const UNITS_OF_SINGLE: f64 = (1_u64 << 29) as f64;

/// Returns the bound in units of 2⁻²⁴ for a form that is computed in double precision and rounded to single, if
/// it is within the promise: rounding takes one unit.
fn bound_in_double(source: &Source, within: &Rational) -> Option<f64> {
    let approximation = source.approximated.as_ref().map_or(0.0, |approximated| approximated.error);
    let bounds = source.program.bounds_of_promise(Arithmetic::DOUBLE).ok()?;
    let in_double = units(&bounds, Arithmetic::DOUBLE, approximation)?;
    let in_single = (1.0 + in_double / UNITS_OF_SINGLE * (1.0 + f64::EPSILON)).next_up();
    (in_single <= nearest_f64(within).next_down()).then_some(in_single)
}

/// Returns the arithmetic of a target other than Rust.
pub(super) fn arithmetic(target: Target, precision: Precision) -> Arithmetic {
    match (target, precision) {
        (Target::Wgsl, _) => Arithmetic::SHADER,
        (_, Precision::F32) => Arithmetic::SINGLE,
        _ => Arithmetic::DOUBLE,
    }
}

fn unit(precision: Precision) -> &'static str {
    if precision == Precision::F32 { Arithmetic::SINGLE.unit_name() } else { Arithmetic::DOUBLE.unit_name() }
}

impl Promise {
    /// Returns the sentence about the promise in the documentation of the function.
    pub(super) fn sentence(&self, within: &Rational, target: Target, precision: Precision) -> String {
        let unit = unit(precision);
        match self {
            Promise::ByPrecision if precision == Precision::DoubleDouble => {
                "Its relative error is at most 2⁻⁹⁸; its value is NaN if no available precision reaches this bound."
                    .to_string()
            }
            Promise::ByPrecision => format!(
                "Its relative error is at most {within}·{unit}; its value is NaN if no available precision reaches \
                 this bound."
            ),
            Promise::ByBound(units) => format!(
                "Its relative error is at most {within}·{unit}: the bound of the rounding error is \
                 {units:.1}·{unit}{}.",
                assumption(target, precision)
            ),
            Promise::InDouble { bound: Some(units), .. } => format!(
                "Its relative error is at most {within}·{unit}: it is computed in `double`, and the bound of the \
                 rounding error with that of the result is {units:.1}·{unit}{}.",
                assumption(target, Precision::F64)
            ),
            Promise::InDouble { bound: None, reason } => format!(
                "`within {within}` is not guaranteed by the generated code: {reason}. It is computed in `double`, and \
                 rounded."
            ),
            Promise::NotKept(reason) => format!("`within {within}` is not guaranteed by the generated code: {reason}."),
        }
    }
}

/// Returns the assumption of a bound about the compiler and the library of a target, if the
/// specification of its language does not state them.
pub(super) fn assumption(target: Target, precision: Precision) -> &'static str {
    if target == Target::Wgsl {
        return "";
    }
    if precision == Precision::F32 {
        ", if library functions are within 4 ulp and fast-math optimisation is off"
    } else {
        ", if library functions are within 2 ulp and fast-math optimisation is off"
    }
}

/// Returns the sentence about a promise that a bound keeps in `f64`, in the documentation of a
/// function of Rust.
pub fn promised_by_bound(within: &Rational, units: f64) -> String {
    Promise::ByBound(units).sentence(within, Target::Rust, Precision::F64)
}

/// Lists the promises that these kernels do not keep in a target, one per line. Kernels that the
/// target cannot express are skipped.
///
/// ```
/// use forms_core::{check::read_theory, compile::compile_kernel};
/// use forms_core::emission::{KernelDocs, Precision, Source, Target, broken_promises};
/// let (mut theory, _) = read_theory("kernel k(x) = (1 - cos(x))/x**2 within 2;");
/// let kernel = theory.kernels[0].clone();
/// let generated = compile_kernel(&mut theory.pool, &kernel).unwrap();
/// let source = Source { within: kernel.within, ..generated.into() };
/// let lines = broken_promises(&[source], Target::C, Precision::F64);
/// assert!(lines[0].starts_with("`k`: `within 2` is not guaranteed by the generated code"));
/// ```
pub fn broken_promises(kernels: &[Source], target: Target, precision: Precision) -> Vec<String> {
    let line = |source: &Source| {
        let source = &source.in_target(target, precision);
        let within = source.within.as_ref()?;
        check(&source.program, target, precision).ok()?;
        let promise = promise(source, within, target, precision);
        matches!(promise, Promise::NotKept(_) | Promise::InDouble { bound: None, .. })
            .then(|| format!("`{}`: {}", source.program.name(), promise.sentence(within, target, precision)))
    };
    kernels.iter().filter_map(line).collect()
}
