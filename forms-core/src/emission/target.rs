//! Target languages, precisions and the features that they lack; kernels to be emitted.

use super::docs::KernelDocs;
use crate::expression::Rational;
use crate::generation::{Generated, TargetProgram};
use crate::kernel::Program;
use crate::rounding;
use crate::theory::FormTarget;
use std::fmt;

/// A language that kernels are emitted in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target {
    /// Rust, with the standard library.
    Rust,
    /// A header of C99 and C++17, with `math.h`.
    C,
    /// The shading language of WebGPU, in single precision.
    Wgsl,
    /// CUDA, functions of the device without any header, as NVRTC compiles them.
    Cuda,
}

impl Target {
    /// Every target.
    pub const ALL: [Target; 4] = [Target::Rust, Target::C, Target::Wgsl, Target::Cuda];

    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Target::Rust => "rust",
            Target::C => "c",
            Target::Wgsl => "wgsl",
            Target::Cuda => "cuda",
        }
    }

    /// Returns the name in prose.
    pub(super) fn title(self) -> &'static str {
        match self {
            Target::Rust => "Rust",
            Target::C => "C",
            Target::Wgsl => "WGSL",
            Target::Cuda => "CUDA",
        }
    }

    /// Returns the default precision of the target.
    pub fn usual_precision(self) -> Precision {
        if self == Target::Wgsl { Precision::F32 } else { Precision::F64 }
    }

    pub(super) fn has(self, precision: Precision) -> bool {
        match precision {
            Precision::F32 => true,
            Precision::F64 => self != Target::Wgsl,
            Precision::DoubleDouble => self == Target::Rust,
        }
    }
}

/// Number type of emitted source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    /// Single precision.
    F32,
    /// Double precision.
    F64,
    /// Two doubles, about 31 digits.
    DoubleDouble,
}

impl Precision {
    /// Every precision.
    pub const ALL: [Precision; 3] = [Precision::F32, Precision::F64, Precision::DoubleDouble];

    /// Returns the name on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
            Precision::DoubleDouble => "dd",
        }
    }
}

/// Feature that a target lacks.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum EmitError {
    /// The target does not have this precision.
    Precision(Target, Precision),
    /// The target does not have a function that the kernel calls.
    Function {
        /// The kernel.
        kernel: String,
        /// The function.
        function: &'static str,
        /// The target.
        target: Target,
    },
    /// A number of the kernel is infinite in this precision, or is rounded to zero although it is
    /// not zero.
    Number {
        /// The kernel.
        kernel: String,
        /// The number.
        number: String,
        /// The precision.
        precision: Precision,
    },
}

impl EmitError {
    /// Returns what the user can do, as a sentence without a full stop.
    pub fn help(&self) -> &'static str {
        match self {
            EmitError::Precision(_, Precision::DoubleDouble) => "the target `rust` supports it",
            EmitError::Precision(..) => "the targets `rust`, `c` and `cuda` support it",
            EmitError::Function { .. } => "the target `rust` has it",
            EmitError::Number { .. } => "the targets `rust`, `c` and `cuda` hold it in the precision `f64`",
        }
    }
}

impl fmt::Display for EmitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EmitError::Precision(target, precision) => {
                write!(
                    f,
                    "the target `{}` does not support the precision `{}`",
                    target.name(),
                    precision.name()
                )
            }
            EmitError::Function { kernel, function, target } => write!(
                f,
                "the kernel `{kernel}` calls `{function}`, which the target `{}` does not have",
                target.name()
            ),
            EmitError::Number { kernel, number, precision } => write!(
                f,
                "the kernel `{kernel}` contains the number {number}, which overflows or underflows in `{}`",
                precision.name()
            ),
        }
    }
}

impl std::error::Error for EmitError {}

/// Kernel to be emitted.
#[derive(Clone, Debug)]
pub struct Source {
    /// Program of the kernel.
    pub program: Program,
    /// Documentation above the function.
    pub docs: KernelDocs,
    /// Promised largest distance of its `f64` value from the exact one, in units of 2⁻⁵³ of the
    /// exact value; in `f32` of 2⁻²⁴. Kept by higher precision in Rust, and elsewhere if a bound of
    /// the rounding error shows it.
    pub within: Option<Rational>,
    /// The formula, if the program only approximates it.
    pub approximated: Option<Approximated>,
    /// Forms for one precision or target, the first of which that applies is computed.
    pub target_forms: Vec<TargetProgram>,
}

/// Whether a form given for a precision or target is computed in this precision of this target.
fn applies(form: FormTarget, target: Target, precision: Precision) -> bool {
    match form {
        FormTarget::F32 => precision == Precision::F32,
        FormTarget::C => target == Target::C,
        FormTarget::Cuda => target == Target::Cuda,
        FormTarget::Wgsl => target == Target::Wgsl,
    }
}

impl Source {
    /// Returns the kernel as it is computed in this precision of this target.
    pub(super) fn in_target(&self, target: Target, precision: Precision) -> Source {
        let mut source = self.clone();
        let own = self.target_forms.iter().find(|form| applies(form.target, target, precision));
        if let Some(form) = own.cloned() {
            source.docs.rounding = rounding::sentence(&form.program).unwrap_or_default();
            source.docs.translation = form.account();
            source.program = form.program;
            source.approximated = approximated(form.formula, form.approximation);
        }
        source
    }
}

/// Formula of a kernel whose form is an approximation.
#[derive(Clone, Debug)]
pub struct Approximated {
    /// Program of the formula, for precisions in which the approximation is not good enough.
    pub formula: Program,
    /// Largest relative error of the approximation before rounding.
    pub error: f64,
}

impl From<Generated> for Source {
    /// Takes the programs and the approximation of a kernel, without documentation and promise.
    fn from(generated: Generated) -> Self {
        let Generated { written, optimised, approximation, target_forms, .. } = generated;
        Source {
            program: optimised,
            docs: KernelDocs::default(),
            within: None,
            approximated: approximated(written, approximation),
            target_forms,
        }
    }
}

/// Returns the formula beside an approximation; `None` for a form without an error.
fn approximated(formula: Program, error: f64) -> Option<Approximated> {
    (error > 0.0).then_some(Approximated { formula, error })
}
