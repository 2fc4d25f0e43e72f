//! What is generated of a kernel: its body, for every kind of number.

use crate::Real;

/// A kernel of `ARGUMENTS` numbers with `OUTPUTS` values.
///
/// Outside its domain, and where an argument it depends on is NaN, every output is NaN.
pub trait Formula<const ARGUMENTS: usize, const OUTPUTS: usize> {
    /// Whether lanes may give up on arguments, because the body has more than arithmetic, roots, absolute values
    /// and choices.
    const MAY_GIVE_UP: bool = true;

    /// The values at these arguments.
    fn value<T: Real>(arguments: [T; ARGUMENTS]) -> [T; OUTPUTS];
}
