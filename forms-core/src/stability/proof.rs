//! Proof: a form has the value of the formula wherever the formula has one and the kernel's conditions hold, and its
//! pieces agree where they meet. It is the proof that generation asks for again.

use crate::expression::{Expr, Node, Pool, Seam};
use crate::generation::{form_faults, guarded};
use crate::resolve::Kernel;
use rustc_hash::FxHashMap;

/// A form that is proved, or the same with the formula wherever it is not shown to have a value; nothing where
/// neither is.
pub(super) fn provable(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Vec<Expr>> {
    if proved(pool, kernel, form) {
        return Some(form.to_vec());
    }
    // what has the formula's value everywhere agrees with itself wherever the formula does
    let guarded = guarded(pool, kernel, form)?;
    let jumping = with_jumps(pool, &guarded);
    [guarded, jumping].into_iter().find(|other| other != form && proved(pool, kernel, other))
}

/// The form with nothing claimed at its seams.
fn with_jumps(pool: &mut Pool, form: &[Expr]) -> Vec<Expr> {
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for part in pool.reachable(form) {
        let node = pool.node(part).clone();
        let image = match node {
            Node::Select { left, relation, right, then, otherwise, .. } => {
                let [left, right, then, otherwise] = [left, right, then, otherwise].map(|part| images[&part]);
                pool.select((left, relation, right), then, otherwise, Seam::Jumps)
            }
            node => pool.image(part, node, &images),
        };
        images.insert(part, image);
    }
    form.iter().map(|output| images[output]).collect()
}

/// Whether a form may stand for the kernel's formula.
pub(super) fn proved(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    let computed = if form == kernel.outputs { Vec::new() } else { form.to_vec() };
    let mut kernel = kernel.clone();
    kernel.computed = computed;
    form_faults(pool, &kernel).is_empty()
}
