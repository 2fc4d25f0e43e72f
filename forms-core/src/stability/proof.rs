//! Proof: a form has the value of the formula wherever both are defined and the kernel's conditions hold.

use crate::expression::{Expr, Pool};
use crate::generation::{FORM, Translation, equality};
use crate::resolve::Kernel;

/// What is known of the equality of a form and the formula.
pub(super) fn proved(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    let pairs: Vec<(Expr, Expr)> = form.iter().copied().zip(kernel.outputs.iter().copied()).collect();
    equality(pool, &pairs, &kernel.domain, FORM) == Translation::Proved
}
