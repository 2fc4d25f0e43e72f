//! Forms of kernels for one precision or target language.

use crate::diagnostic::Span;
use crate::expression::{Expr, Rational};

/// Form by which a kernel is computed in one precision or target language.
#[derive(Clone, Debug)]
pub struct TargetForm {
    /// Where it is computed.
    pub target: FormTarget,
    /// The form of each output.
    pub outputs: Vec<Expr>,
    /// Largest relative error of this form where it is only close to the formula.
    pub approximation: Option<Rational>,
    /// Span of its target in the source.
    pub span: Span,
}

/// Precision or target language that a form is given for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FormTarget {
    /// Single precision, in every language.
    F32,
    /// C, in every precision.
    C,
    /// CUDA, in every precision.
    Cuda,
    /// WGSL.
    Wgsl,
}

impl FormTarget {
    /// Every target.
    pub const ALL: [FormTarget; 4] = [FormTarget::F32, FormTarget::C, FormTarget::Cuda, FormTarget::Wgsl];

    /// Returns the name in the language.
    pub fn name(self) -> &'static str {
        match self {
            FormTarget::F32 => "f32",
            FormTarget::C => "c",
            FormTarget::Cuda => "cuda",
            FormTarget::Wgsl => "wgsl",
        }
    }
}
