//! Drifts: the motions of a frame.

use crate::expression::Symbol;

/// Motion of s with f at a speed v.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drift {
    /// s
    pub moved: Symbol,
    /// f, which moves with no variable.
    pub with: Symbol,
    /// v
    pub speed: i64,
}
