//! The back ends, and the error that each may have: in units in the last place, from the true value
//! for functions, and from the interpreter for kernels.

use super::table::Function;
use super::truth::Format;
use forms_core::emission::Precision;
use forms_core::expression::Operation;

/// Largest errors of numbers with more digits: units of 2⁻¹⁰⁶ and of 2⁻²⁴⁸.
pub(crate) const DOUBLE_DOUBLE: f64 = 128.0;
pub(crate) const WIDE: f64 = 4.0;

/// A way to compute a kernel in the precision of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BackEnd {
    Interpreter(Precision),
    /// A lane of a batch, with and without the fused instruction.
    Lane(Format, bool),
    /// A function or the type of a formula.
    Rust(Precision),
    RustFormula(Format),
    C(Format),
    /// Compiled as C++.
    Cuda(Format),
}

impl BackEnd {
    /// Returns the format of the arguments and of the values.
    pub(crate) fn format(self) -> Format {
        match self {
            Self::Interpreter(Precision::F32) | Self::Rust(Precision::F32) => Format::F32,
            Self::Lane(format, _) | Self::RustFormula(format) | Self::C(format) | Self::Cuda(format) => {
                format
            }
            _ => Format::F64,
        }
    }

    /// Returns the largest error of a function at these arguments.
    pub(crate) fn tolerance(self, function: Function, row: &[f64]) -> f64 {
        let size = row.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        let is_arithmetic = !matches!(function, Function::Operation(_) | Function::Power(..));
        match (self, function) {
            // the GNU library loses bits at the angle nearest to a multiple of π/2
            (_, Function::Operation(Operation::Cos | Operation::Tan)) if size > 1e200 => 15.0,
            (_, Function::DifferenceOfProducts | Function::SumOfProducts) => 2.0,
            (_, Function::MultiplyAdd) => 1.5,
            (_, Function::Operation(Operation::Abs)) => 0.0,
            _ if is_arithmetic => 0.5,
            (Self::Lane(..), _) => 2.0,
            // as stated in `Arithmetic::DOUBLE`
            (_, Function::Operation(Operation::Erfc)) => 5.0,
            (_, Function::Power(..)) => 3.0,
            _ => 1.5,
        }
    }

    /// Whether the back end may give up at these arguments and return NaN: a batch computes them as
    /// single numbers.
    pub(crate) fn gives_up(self, function: Function, row: &[f64]) -> bool {
        let Self::Lane(format, _) = self else { return false };
        let [exponential, angle, largest] = match format {
            Format::F64 => [700.0, 1e6, 1e300],
            Format::F32 => [80.0, 6e3, 1e36],
        };
        let size = row.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        match function {
            Function::Operation(operation) => match operation {
                Operation::Sin | Operation::Cos | Operation::Tan => size > angle,
                Operation::Exp | Operation::Expm1 | Operation::Sinh | Operation::Cosh => size > exponential,
                Operation::Atan | Operation::Erf => size > largest,
                Operation::Atan2 => size >= largest || size == 0.0,
                Operation::Hypot => !(1e-135..1e148).contains(&size) || self.format() == Format::F32,
                Operation::Cbrt => true,
                _ => is_special(operation),
            },
            Function::Power(..) => true,
            _ => false,
        }
    }

    /// Returns the largest error of a kernel, compared with the interpreter of the same precision.
    /// C and CUDA have other implementations of functions and of compensated products.
    pub(crate) fn tolerance_of_kernel(self, has_functions: bool) -> f64 {
        match self {
            // sums are fused, and the kernels have sums that cancel
            Self::Cuda(_) => 512.0,
            Self::C(_) if has_functions => 4.0,
            _ => 0.0,
        }
    }
}

/// Functions that lanes do not compute.
fn is_special(operation: Operation) -> bool {
    matches!(
        operation,
        Operation::Erfc
            | Operation::Expint1
            | Operation::Expint2
            | Operation::Expint3
            | Operation::Dilog
            | Operation::Clausen
    )
}
