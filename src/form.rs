//! A form evaluated at compile time, as its author would write it.

use std::fmt;

/// A scalar or form, its coefficients simplified: what [`form!`](crate::form!) evaluates to.
///
/// Coefficients that are zero are left out. Where a coefficient has no simpler form that is certainly equal to it
/// (say, it hangs on the sign of something unknown), it stands as it was arrived at.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Form {
    /// k of a k-form; 0 for a scalar.
    pub degree: u32,
    /// Basis form and coefficient, in the order of the coordinates: `("dx^dy", "2*x")`. The basis form of a
    /// scalar is `1`.
    pub terms: &'static [(&'static str, &'static str)],
    /// The whole form in the language's notation; a macro body can repeat it.
    pub text: &'static str,
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text)
    }
}
