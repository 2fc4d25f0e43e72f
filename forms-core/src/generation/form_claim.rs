//! The claim of a form: it has the value of the formula wherever the formula has one, on the
//! kernel's domain.
//!
//! ```text
//! form ─┬─ special points ──▶ a point at which it has no value, or a different one
//!       ├─ equation ────────▶ equal wherever both have a value, output by output
//!       └─ definedness ─────▶ it has a value wherever the formula has one
//! ```
//! The form of an approximation (`by F approx E`) has a claim of its own.

use super::approximation_claim;
use super::definedness::{self, Breach, Definedness};
use super::fault::{Claim, Fault};
use super::translation::{EFFORT, FORM, Translation, equality};
use crate::decide::{UnknownReason, Witness};
use crate::diagnostic::Diagnostic;
use crate::expression::{Expr, Pool};
use crate::theory::Kernel;

/// Returns the fault of a form given after `by` that is not proved to have the value of the
/// formula, wherever the formula has one on the kernel's domain. Special points are tested first: a
/// form that differs only on a stratum is refuted there.
pub(super) fn fault(pool: &mut Pool, kernel: &Kernel) -> Option<Fault> {
    if let Some(tolerance) = &kernel.approximation {
        return approximation_claim::fault(pool, kernel, tolerance);
    }
    if let Some(breach) = definedness::first_breach(pool, kernel, &kernel.computed) {
        return Some(broken(kernel, &breach));
    }
    for (&form, &formula) in kernel.computed.iter().zip(&kernel.outputs) {
        // output by output: an output can have a value where another has none
        match equality(pool, &[(form, formula)], &kernel.domain, FORM) {
            Translation::Proved => {}
            Translation::Refuted(witness) => return Some(different(kernel, witness)),
            Translation::Unknown { reason, .. } => {
                let breach = definedness::any_breach(pool, kernel, &kernel.computed);
                return Some(
                    breach.map_or_else(|| undecided(kernel, reason), |breach| broken(kernel, &breach)),
                );
            }
        }
    }
    match definedness::of_form(pool, kernel, &kernel.computed) {
        Definedness::Kept => None,
        Definedness::Broken(breach) => Some(broken(kernel, &breach)),
        Definedness::Undecided { reason } => Some(undefined(kernel, reason)),
    }
}

/// Whether a form is proved equal to the formula wherever both have a value, with the budget of a
/// search. No points are searched for that refute it.
pub(super) fn is_equal(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    let mut outputs = form.iter().zip(&kernel.outputs);
    outputs.all(|(&form, &formula)| equality(pool, &[(form, formula)], &kernel.domain, EFFORT).is_proved())
}

fn broken(kernel: &Kernel, breach: &Breach) -> Fault {
    let name = &kernel.name;
    let what = if breach.form.is_ok() {
        "differs from its formula"
    } else {
        "is undefined at a point where its formula has a value"
    };
    let message = format!("the stable form of `{name}` {what}\n{}", breach.text());
    let help = if breach.form.is_ok() {
        EQUAL
    } else {
        "handle these points in a separate branch, `if d != 0 { … } else { … }`, or exclude them with `where`"
    };
    let diagnostic = Diagnostic::new(kernel.span, message).with_help(help);
    Fault::refuted(name, Claim::By, breach.witness(), diagnostic)
}

fn different(kernel: &Kernel, witness: Witness) -> Fault {
    let message = format!("the stable form of `{}` differs from its formula\n{witness}", kernel.name);
    let diagnostic = Diagnostic::new(kernel.span, message).with_help(EQUAL);
    Fault::refuted(&kernel.name, Claim::By, witness, diagnostic)
}

fn undecided(kernel: &Kernel, reason: UnknownReason) -> Fault {
    let message =
        format!("cannot decide whether the stable form of `{}` equals its formula: {reason}", kernel.name);
    let diagnostic = Diagnostic::new(kernel.span, message).with_help(EQUAL);
    Fault::unknown(&kernel.name, Claim::By, reason, diagnostic)
}

fn undefined(kernel: &Kernel, reason: UnknownReason) -> Fault {
    let message = format!(
        "cannot decide whether the stable form of `{}` is defined wherever its formula is: {reason}",
        kernel.name
    );
    let diagnostic = Diagnostic::new(kernel.span, message)
        .with_help("state the condition after `where`, or handle these points in a separate branch");
    Fault::unknown(&kernel.name, Claim::By, reason, diagnostic)
}

const EQUAL: &str = "the form after `by` must have the value of the formula wherever the formula is defined";
