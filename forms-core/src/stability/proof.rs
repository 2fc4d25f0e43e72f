//! Proof that a form has the value of the formula wherever the formula is defined and the kernel's
//! conditions hold, and that its pieces agree where they meet. Generation repeats the same proof.

use crate::expression::{Expr, Node, Pool, Rational, Seam};
use crate::generation::{form_faults, form_has_values, form_is_equal, guarded};
use crate::theory::Kernel;
use rustc_hash::FxHashMap;

/// Returns the form if it is proved, or else the form with the formula used wherever the form is
/// not proved to have a value; `None` if neither is proved.
pub(super) fn provable(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> Option<Vec<Expr>> {
    if !form_is_equal(pool, kernel, form) {
        return None;
    }
    if form_has_values(pool, kernel, form) {
        return Some(form.to_vec());
    }
    // the formula in the place of an equal form changes no value. A form that has the formula's value
    // everywhere agrees at its seams wherever the formula does, so no claim is needed there
    let guarded = guarded(pool, kernel, form)?;
    let jumping = with_jumps(pool, &guarded);
    [guarded, jumping].into_iter().find(|other| other != form && form_has_values(pool, kernel, other))
}

/// Returns the form with no claim of agreement at its seams.
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

/// Whether a form is proved to have the value of the kernel's formula.
pub(super) fn proved(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    form == kernel.outputs || form_is_equal(pool, kernel, form) && form_has_values(pool, kernel, form)
}

/// Whether a form is proved to be within a tolerance of the kernel's formula.
pub(super) fn proved_close(pool: &mut Pool, kernel: &Kernel, form: &[Expr], tolerance: &Rational) -> bool {
    let (computed, approximation) = (form.to_vec(), Some(tolerance.clone()));
    form_faults(pool, &Kernel { computed, approximation, ..kernel.clone() }).is_empty()
}
