//! Result of [`form!`](crate::form!): a form evaluated at compile time, in the notation of the
//! language.

use std::fmt;

/// Scalar or form with simplified coefficients: the value of [`form!`](crate::form!).
///
/// Zero coefficients are omitted. A coefficient stays as computed if no simpler form is certainly
/// equal to it, for example because it depends on an unknown sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Form {
    /// Degree k of a k-form; 0 for a scalar.
    pub degree: u32,
    /// Pairs of basis form and coefficient, in the order of the coordinates: `("dx^dy", "2*x")`.
    /// The basis form of a scalar is `1`.
    pub terms: &'static [(&'static str, &'static str)],
    /// The whole form in the notation of the language, valid in a macro body.
    pub text: &'static str,
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text)
    }
}
