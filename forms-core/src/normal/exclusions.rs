//! Points that the normal forms of a tower leave out.

use super::generator::Unit;
use crate::polynomial::Polynomial;

/// Points that the normal forms of a tower leave out, and the half turns that it is for.
#[derive(Clone, Debug, Default)]
pub(super) struct Exclusions {
    /// Units at an odd multiple of π here: cos u = −1, sin u = 0.
    pub(super) half_turns: Vec<Unit>,
    /// Units whose half-angle tangents were used.
    pub(super) poles: Vec<Unit>,
    /// Polynomials that were divisors.
    pub(super) divisors: Vec<Polynomial>,
}
