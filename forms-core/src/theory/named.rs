//! Meanings of names.

use crate::calculus::Coordinate;
use crate::expression::{FunctionId, Symbol};

/// Meaning of a name in a file.
#[derive(Clone, Debug)]
pub enum Named {
    /// Chart, by its index.
    Chart(usize),
    /// Coordinate.
    Coordinate(Coordinate),
    /// Differential of a coordinate.
    Differential(Coordinate),
    /// Parameter.
    Parameter(Symbol),
    /// Unknown function, by its index.
    Function(FunctionId),
    /// Scalar, form or field, by its index.
    Object(usize),
    /// Map, by its index.
    Map(usize),
    /// Metric, by its index.
    Metric(usize),
    /// Kernel, by its index.
    Kernel(usize),
    /// Definition with arguments, by its index.
    Definition(usize),
    /// Array that is an argument of the kernel being read, by its index.
    Array(usize),
    /// Name whose declaration is being read and which cannot be used yet.
    Pending,
    /// Name whose declaration failed.
    Poisoned,
}

/// Describes the meaning of a name in words.
pub(crate) fn describe(named: &Named) -> &'static str {
    match named {
        Named::Chart(_) => "a chart",
        Named::Coordinate(_) => "a coordinate",
        Named::Differential(_) => "a differential",
        Named::Parameter(_) => "a param",
        Named::Function(_) => "an unknown function",
        Named::Object(_) => "a scalar, form or field",
        Named::Map(_) => "a map",
        Named::Metric(_) => "a metric",
        Named::Kernel(_) => "a kernel",
        Named::Definition(_) => "a definition with arguments",
        Named::Array(_) => "an array",
        Named::Pending | Named::Poisoned => "something with an error in it",
    }
}
