//! Reasons for giving up and reasons for vacuous statements, as data; their texts are printed with
//! the verdicts.

use crate::normal::{OutsidePart, SizeLimit};
use std::fmt;

/// Reason why a statement is undecided.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum UnknownReason {
    /// No value of a side was found although one can exist, with the message about it.
    NoValue(String),
    /// No valid point was found: the statement is proved, but can be vacuous.
    NoPoint,
    /// The computed value of an integral is valid only under this condition.
    NarrowIntegral {
        /// The condition, in the language's notation.
        condition: String,
    },
    /// The normal forms of the sides differ, but no counterexample was found.
    DifferentNormalForms,
    /// A part lies outside the class that is decided.
    Outside(OutsidePart),
    /// A normal form is too large.
    TooLarge(SizeLimit),
    /// Radicands could not be factored.
    UnfactoredRadicands,
    /// The case split is too large.
    OpenSigns,
    /// Too many choices of angles can be odd multiples of π.
    HalfTurns,
    /// A stratum has half turns that the whole did not have.
    FurtherHalfTurn,
    /// The points at which a divisor of the normal form vanishes are not known.
    DivisorZeros,
    /// The points outside which the normal forms hold are all there are, but a point was found.
    Vacuous(EmptyReason),
    /// No sign of a sine or cosine that decides the statement follows from the conditions.
    NoTrigonometricSigns,
    /// The sides do not differ by angles that are shown to vanish.
    NoAngles,
    /// No part of an inverse function becomes a variable such that the statement is proved.
    NoPrincipalBranches,
    /// The differences are not numbers that a separation bound shows to be zero.
    NoNumbers,
    /// No condition amounts to an equation that decides the statement.
    NoEquations,
    /// The claim of a kernel was not shown.
    Kernel(KernelReason),
}

impl fmt::Display for UnknownReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            UnknownReason::NoValue(message) => write!(f, "{message}"),
            UnknownReason::NoPoint => {
                write!(f, "no point was found at which both sides are defined and every condition holds")
            }
            UnknownReason::NarrowIntegral { condition } => {
                write!(f, "the value of an integral in the statement is known only where `{condition}`")
            }
            UnknownReason::DifferentNormalForms => write!(
                f,
                "the two sides have different normal forms, but no point was found at which they differ"
            ),
            UnknownReason::Outside(part) => write!(f, "outside the class that Forms decides: {part}"),
            UnknownReason::TooLarge(limit) => write!(f, "the normal form is too large: {limit}"),
            UnknownReason::UnfactoredRadicands => write!(f, "the radicands could not be factored"),
            UnknownReason::OpenSigns => write!(f, "too many factors of radicands have an open sign"),
            UnknownReason::HalfTurns => write!(f, "too many angles may be odd multiples of pi"),
            UnknownReason::FurtherHalfTurn => {
                write!(f, "where some angles are odd multiples of pi, a further angle can be one too")
            }
            UnknownReason::DivisorZeros => {
                write!(f, "the zeros of a divisor in the normal form could not be determined")
            }
            UnknownReason::NoTrigonometricSigns => {
                write!(f, "no signs of sines and cosines that follow from the conditions decide it")
            }
            UnknownReason::NoAngles => write!(f, "the sides do not differ by angles that vanish"),
            UnknownReason::NoPrincipalBranches => {
                write!(f, "no inverse function occurs in parts that decide it as variables")
            }
            UnknownReason::NoNumbers => {
                write!(f, "the sides do not differ by numbers that are known to be zero")
            }
            UnknownReason::NoEquations => write!(f, "no condition amounts to an equation that decides it"),
            UnknownReason::Vacuous(reason) => write!(f, "{reason}"),
            UnknownReason::Kernel(reason) => write!(f, "{reason}"),
        }
    }
}

/// Reason why a claim about a kernel was not shown.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum KernelReason {
    /// The claim could not be examined, with the message to the author of the kernel.
    Reported(String),
    /// No point was found at which the kernel is defined.
    NoPoint,
    /// The kernel is defined nowhere.
    DefinedNowhere(EmptyReason),
    /// The kernel has more than this number of pieces.
    Pieces(usize),
    /// The branches of a conditional have more than this number of pieces.
    BranchPieces(usize),
    /// The form has more than this number of paths through its conditionals.
    Paths(usize),
    /// A condition under which the form has a value was not proved.
    Undefined {
        /// The condition, in the language's notation.
        condition: String,
        /// The part of the form that needs it.
        part: String,
    },
    /// An approximation was not shown to be close to its formula under these conditions; empty for
    /// the whole domain.
    NotClose(String),
    /// The equation of a seam could not be solved completely.
    UnsolvedSeam,
    /// A branch is not defined on a seam, for a reason if it is known.
    UndefinedBranch(Option<EmptyReason>),
}

impl fmt::Display for KernelReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            KernelReason::Reported(message) => write!(f, "{message}"),
            KernelReason::NoPoint => write!(f, "no point was found at which it is defined"),
            KernelReason::DefinedNowhere(reason) => write!(f, "it is defined nowhere: {reason}"),
            KernelReason::Pieces(most) => write!(f, "it has more than {most} pieces"),
            KernelReason::BranchPieces(most) => write!(f, "the branches have more than {most} pieces"),
            KernelReason::Paths(most) => write!(f, "the form has more than {most} paths through `if`"),
            KernelReason::Undefined { condition, part } => {
                write!(f, "`{condition}`, which `{part}` requires, was not proved")
            }
            KernelReason::NotClose(path) if path.is_empty() => {
                write!(f, "no expansion shows it on the whole domain")
            }
            KernelReason::NotClose(path) => write!(f, "no expansion shows it where {path}"),
            KernelReason::UnsolvedSeam => {
                write!(f, "the equation of the seam could not be solved completely")
            }
            KernelReason::UndefinedBranch(None) => write!(f, "a branch is not defined there"),
            KernelReason::UndefinedBranch(Some(reason)) => {
                write!(f, "a branch is not defined there: {reason}")
            }
        }
    }
}

impl From<KernelReason> for UnknownReason {
    fn from(reason: KernelReason) -> Self {
        UnknownReason::Kernel(reason)
    }
}

/// Reason why no point meets the conditions of a statement.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EmptyReason {
    /// No point meets this condition.
    Condition(String),
    /// The conditions contradict each other.
    Contradiction,
    /// The conditions fail in every case of the signs that matter.
    NoCase,
    /// A divisor is zero at every point.
    DivisionByZero,
    /// A divisor has no zeros.
    NoZeros,
}

impl fmt::Display for EmptyReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EmptyReason::Condition(condition) => write!(f, "no point satisfies `{condition}`"),
            EmptyReason::Contradiction => write!(f, "its conditions contradict each other"),
            EmptyReason::NoCase => write!(f, "no point meets its conditions"),
            EmptyReason::DivisionByZero => write!(f, "a divisor is zero at every point"),
            EmptyReason::NoZeros => write!(f, "the divisor has no zeros"),
        }
    }
}
