//! What is generated of a kernel: its body, for every kind of number.

use crate::Real;

/// A kernel of `ARGUMENTS` numbers with `OUTPUTS` values.
///
/// Outside its domain, and where an argument it depends on is NaN, every output is NaN.
pub trait Formula<const ARGUMENTS: usize, const OUTPUTS: usize> {
    /// The values at these arguments.
    fn value<T: Real>(arguments: [T; ARGUMENTS]) -> [T; OUTPUTS];
}
