//! Signs that are known, with or without zero.

/// Whether a sign excludes zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Strictness {
    /// Zero is possible.
    Weak,
    /// Zero is excluded.
    Strict,
}

/// A sign and whether it excludes zero: (true, _) is positive.
pub(super) type KnownSign = (bool, Strictness);
