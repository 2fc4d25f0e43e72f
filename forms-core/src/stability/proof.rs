//! Proof: a form has the value of the formula wherever the formula has one and the kernel's conditions hold, and its pieces
//! agree where they meet. It is the proof that generation asks for again.

use crate::expression::{Expr, Pool};
use crate::generation::{form_faults, guarded};
use crate::resolve::Kernel;

/// A form that is proved, or the same with the formula wherever it is not shown to have a value; nothing where neither is.
pub(super) fn provable(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Vec<Expr>> {
    if proved(pool, kernel, form) {
        return Some(form.to_vec());
    }
    let guarded = guarded(pool, kernel, form).filter(|guarded| guarded != form)?;
    proved(pool, kernel, &guarded).then_some(guarded)
}

/// Whether a form may stand for the kernel's formula.
pub(super) fn proved(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    let computed = if form == kernel.outputs { Vec::new() } else { form.to_vec() };
    let mut kernel = kernel.clone();
    kernel.computed = computed;
    form_faults(pool, &kernel).is_empty()
}
