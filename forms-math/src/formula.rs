//! Generated code of a kernel: its body, for every number type; and computations that are known only at run time.

use alloc::vec::Vec;

use crate::Real;

/// Kernel of `ARGUMENTS` numbers with `OUTPUTS` values.
///
/// Outside its domain, and if an argument that it depends on is NaN, every output is NaN.
pub trait Formula<const ARGUMENTS: usize, const OUTPUTS: usize> {
    /// Whether lanes can give up on arguments, because the body contains more than arithmetic,
    /// roots, absolute values and choices.
    const MAY_GIVE_UP: bool = true;

    /// Computes the values at these arguments.
    fn value<T: Real>(arguments: [T; ARGUMENTS]) -> [T; OUTPUTS];
}

/// Computation in every number type: a formula that is known only at run time.
pub trait Computation {
    /// Computes the outputs in one number type.
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T>;
}
