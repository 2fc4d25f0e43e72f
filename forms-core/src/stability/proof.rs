//! Proof: a form has the value of the formula wherever both are defined and the kernel's conditions hold, and its pieces
//! agree where they meet. It is the proof that generation asks for again.

use crate::expression::{Expr, Pool};
use crate::generation::form_faults;
use crate::resolve::Kernel;

/// Whether a form may stand for the kernel's formula.
pub(super) fn proved(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    let computed = if form == kernel.outputs { Vec::new() } else { form.to_vec() };
    let mut kernel = kernel.clone();
    kernel.computed = computed;
    form_faults(pool, &kernel).is_empty()
}
