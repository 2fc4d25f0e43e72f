//! Generation: a kernel of a source becomes a program that is proved to compute what was written.
//!
//! ```text
//! Kernel ─┬─ seams ─▶ the pieces of every `if` agree where they meet, or an error
//!         ├─ `by` ──▶ the form it is computed by is proved equal to the formula, or an error
//!         └─ lower ─▶ Program ─ optimise ─▶ Program ─ raise ─▶ proved equal to what it was lowered from (translation)
//! ```
//! Whoever makes a kernel into source or numbers makes it here, so that no kernel goes unchecked. What could not
//! be proved is said beside the kernel, and never passed off as a proof.

mod boundary;
mod cuts;
mod definedness;
mod effects;
mod entailment;
mod exact_point;
mod fault;
mod form_claim;
mod limit;
mod obligation;
mod opaque;
mod pieces;
mod ratios;
mod residue;
mod seam;
mod special_points;
mod translation;

pub(crate) use definedness::{guarded, is_kept};
pub use effects::{Specialisation, specialisations};
pub use fault::{Claim, Fault};
pub use translation::Translation;

use crate::diagnostic::Diagnostic;
use crate::expression::{Expr, Node, Pool, Seam};
use crate::kernel::{KernelSource, Program, lower, nearest_f64};
use crate::notation::results;
use crate::resolve::Kernel;

/// A kernel as programs.
#[derive(Clone, Debug)]
pub struct Generated {
    /// One instruction for each operation of the formula as it was written.
    pub written: Program,
    /// The form behind `by`, or the one that rules give, or the formula where there is none, at least cost; with products
    /// that cancel computed without loss where there is such a form, or a bound behind `within`.
    pub optimised: Program,
    /// What is known of their agreement.
    pub translation: Translation,
    /// The form that rules gave each output, where it is what the kernel is computed by.
    pub rewritten: Vec<String>,
    /// How far the kernel's `f64` value may be from the exact one, in units of 2⁻⁵³; none where nothing is promised.
    pub within: Option<f64>,
}

/// Longer forms are not quoted.
const LONGEST_FORM: usize = 200;

impl Generated {
    /// The kernel's values in `f64`, within what it promises.
    pub fn values(&self, arguments: &[f64]) -> Vec<f64> {
        match self.within {
            Some(within) => self.optimised.interpret_within(arguments, within),
            None => self.optimised.interpret(arguments),
        }
    }

    /// What the program is beside the formula, in sentences.
    pub fn account(&self) -> String {
        if self.rewritten.is_empty() {
            return self.translation.to_string();
        }
        let form = results(&self.rewritten);
        let form = if form.len() <= LONGEST_FORM { format!(": `{form}`") } else { String::new() };
        format!("{} Computed by an equal form that rules alone give{form}.", self.translation)
    }
}

/// Generates a kernel whose expressions belong to this pool. What rules made of its outputs, each step proved, is
/// what it is computed by where it has no form of its own; it may be empty.
///
/// # Errors
/// If it is no kernel, if two of its pieces are not shown to agree where they meet, if the form behind `by` is not proved
/// equal to the formula, or if the optimised program does not compute that form, which is a fault of this crate and not of
/// the kernel.
pub(crate) fn generate(
    pool: &mut Pool,
    kernel: &Kernel,
    rewritten: &[Expr],
) -> Result<Generated, Vec<Diagnostic>> {
    let source = KernelSource {
        name: kernel.name.clone(),
        docs: kernel.docs.clone(),
        public: kernel.public,
        arguments: kernel.arguments.clone(),
        outputs: kernel.outputs.clone(),
        domain: kernel.domain.clone(),
    };
    let lowered = |pool: &Pool, source: &KernelSource| {
        lower(pool, source).map_err(|error| vec![Diagnostic::new(kernel.span, error.to_string())])
    };
    let written = lowered(pool, &source)?;
    let faults = own_faults(pool, kernel);
    if !faults.is_empty() {
        return Err(faults.into_iter().map(|fault| fault.diagnostic).collect());
    }
    let form = with_form(kernel, &kernel.computed).or_else(|| with_form(kernel, rewritten));
    let computed = form.as_ref().unwrap_or(kernel);
    let program = lowered(pool, &KernelSource { outputs: computed.outputs.clone(), ..source })?;
    // a form that was chosen keeps the order of its sums and products, on which its rounding depends
    let optimised = if form.is_some() { program.in_order() } else { program.optimise() };
    // whoever gives a form to compute by, or a bound to keep to, wants accuracy first
    let is_stable = form.is_some() || kernel.within.is_some();
    let optimised = if is_stable { optimised.compensate() } else { optimised };
    let translation = translation::validate(pool, computed, &optimised);
    match translation.objection(kernel) {
        Some(objection) => Err(vec![objection]),
        None => {
            let (rewritten, within) = (pool.texts(rewritten), kernel.within.as_ref().map(nearest_f64));
            Ok(Generated { written, optimised, translation, rewritten, within })
        }
    }
}

/// What a kernel claims of itself and was not shown: that its pieces agree where they meet, that the form behind `by`
/// has the value of the formula wherever the formula has one, and that it has a value where each of its effects
/// vanishes.
pub fn faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let mut faults = own_faults(pool, kernel);
    if faults.is_empty()
        && !kernel.effects.is_empty()
        && let Err(found) = specialisations(pool, kernel)
    {
        faults
            .extend(found.into_iter().map(|diagnostic| Fault::told(&kernel.name, Claim::Effect, diagnostic)));
    }
    faults
}

/// Whether a kernel claims anything of itself: that a form behind `by` is its formula, that pieces agree where they
/// meet, or that it has a value where an effect vanishes.
pub fn makes_claims(pool: &Pool, kernel: &Kernel) -> bool {
    let expressions: Vec<Expr> = kernel.outputs.iter().chain(&kernel.computed).copied().collect();
    let is_claim = |part: &Expr| matches!(pool.node(*part), Node::Select { seam: Seam::Agrees, .. });
    !kernel.computed.is_empty()
        || !kernel.effects.is_empty()
        || pool.reachable(&expressions).iter().any(is_claim)
}

/// The same without its effects.
fn own_faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let faults = seam::faults(pool, kernel);
    if faults.is_empty() { form_faults(pool, kernel) } else { faults }
}

/// What is to be said of the form that a kernel is computed by. Where it has the value of the formula wherever there
/// is one, its pieces agree where those of the formula do. Nothing where there is no form.
pub(crate) fn form_faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let Some(form) = with_form(kernel, &kernel.computed) else { return Vec::new() };
    match form_claim::fault(pool, kernel) {
        Some(fault) => vec![fault],
        None => seam::faults(pool, &form),
    }
}

/// The kernel with this form for its formula, if there is one.
fn with_form(kernel: &Kernel, form: &[Expr]) -> Option<Kernel> {
    let mut with_form = (!form.is_empty()).then(|| kernel.clone())?;
    with_form.outputs = form.to_vec();
    with_form.computed = Vec::new();
    Some(with_form)
}
