//! Generation: turns a kernel of a source into a program that is proved to compute the formula as
//! written.
//!
//! ```text
//! Kernel ─┬─ seams ─▶ the pieces of every `if` agree where they meet, or an error
//!         ├─ `by` ──▶ the form it is computed by is proved equal to the formula, or an error
//!         └─ lower ─▶ Program ─ optimise ─▶ Program ─ raise ─▶ proved equal to the lowered expressions (translation)
//! ```
//! All source text and all numbers of a kernel are made by this module, so that no kernel goes
//! unchecked. A claim that could not be proved is reported with the kernel, and never presented as
//! a proof.

mod approximation_claim;
mod boundary;
mod cuts;
mod definedness;
mod effects;
mod entailment;
mod exact_point;
mod fault;
mod form_claim;
mod limit;
mod nowhere;
mod obligation;
mod opaque;
mod pieces;
mod ratios;
mod residue;
mod roots;
mod seam;
mod sign;
mod special_points;
mod target_form;
mod translation;

pub(crate) use definedness::{guarded, is_kept};
pub use effects::{Specialisation, specialisations};
pub use fault::{Claim, Fault};
pub(crate) use target_form::TargetProgram;
pub use translation::Translation;

use crate::diagnostic::Diagnostic;
use crate::expression::{Expr, Node, Pool, Seam};
use crate::kernel::{KernelSource, Program, lower, nearest_f64};
use crate::notation::results;
use crate::theory::{FormTarget, Kernel};
use target_form::{target_programs, with_target_form};

/// Programs of a kernel.
#[derive(Clone, Debug)]
pub struct Generated {
    /// One instruction for each operation of the formula as written.
    pub written: Program,
    /// The form given after `by`, or the form that rewriting rules give, or the formula if there is
    /// neither, at least cost. If there is such a form, or a `within` bound, products that cancel
    /// are computed without loss.
    pub optimised: Program,
    /// Verdict on their agreement.
    pub translation: Translation,
    /// The form that rewriting rules gave each output, if the kernel is computed by it.
    pub rewritten: Vec<String>,
    /// Promised largest error of the kernel's `f64` value, in units of 2⁻⁵³; `None` if nothing is
    /// promised.
    pub promise: Option<f64>,
    /// The bound that keeps the promise, in units of 2⁻⁵³.
    pub bounded: Option<f64>,
    /// Largest relative error of the form before rounding; 0 unless it is an approximation.
    pub approximation: f64,
    /// Programs of the forms for one precision or target language.
    pub target_forms: Vec<TargetProgram>,
    /// Whether the kernel has an approximation that is not computed, because no bound shows that it
    /// keeps the promise.
    pub is_dropped: bool,
}

/// Describes an approximation in a sentence.
fn account_of_approximation(error: f64) -> String {
    // the bound is the float above the stated one
    let stated = error.next_down();
    format!("Proved to differ from its formula by at most {stated:e} of the value, before rounding.")
}

/// Length of the longest form that is quoted.
const LONGEST_FORM: usize = 200;

impl Generated {
    /// Compiles the formula of a kernel as it was written, without any other form and without a promise:
    /// it takes the least time, and loses whatever digits the formula loses.
    ///
    /// # Errors
    /// As [`compile_kernel`](crate::compile::compile_kernel).
    pub fn of_formula(pool: &mut Pool, kernel: &Kernel) -> Result<Self, Vec<Diagnostic>> {
        let plain = Kernel {
            computed: Vec::new(),
            approximation: None,
            target_forms: Vec::new(),
            within: None,
            ..kernel.clone()
        };
        generate(pool, &plain, &[])
    }

    /// Evaluates the kernel in `f64`, within the promised error.
    pub fn values(&self, arguments: &[f64]) -> Vec<f64> {
        match self.within() {
            Some(within) => self.optimised.interpret_within(arguments, within),
            None => self.optimised.interpret(arguments),
        }
    }

    /// Returns the promise if it is kept by as much precision as each value needs; `None` if nothing
    /// is promised, or if a bound of the error over the whole domain keeps the promise.
    pub fn within(&self) -> Option<f64> {
        self.promise.filter(|_| self.bounded.is_none())
    }

    /// Returns the program that is computed in `f32`.
    pub fn single(&self) -> &Program {
        let form = self.target_forms.iter().find(|form| form.target == FormTarget::F32);
        form.map_or(&self.optimised, |form| &form.program)
    }

    /// Returns the program whose value is that of the formula in every precision.
    pub fn exact(&self) -> &Program {
        if self.approximation > 0.0 { &self.written } else { &self.optimised }
    }

    /// Describes in sentences how the program relates to the formula.
    pub fn account(&self) -> String {
        if self.approximation > 0.0 {
            return account_of_approximation(self.approximation);
        }
        if self.is_dropped {
            return format!(
                "{} The approximation is not computed: no bound shows that it keeps the promise of `within`.",
                self.translation
            );
        }
        if self.rewritten.is_empty() {
            return self.translation.to_string();
        }
        let form = results(&self.rewritten, &self.optimised.signature().results);
        let form = if form.len() <= LONGEST_FORM { format!(": `{form}`") } else { String::new() };
        format!("{} Computed by an equal form found by rewriting rules{form}.", self.translation)
    }
}

/// Generates a kernel whose expressions belong to this pool. `rewritten` holds the form that
/// rewriting rules gave its outputs, each step proved. The kernel is computed by it if it has no
/// form of its own. `rewritten` can be empty.
///
/// # Errors
/// If the kernel cannot be lowered, if two of its pieces are not shown to agree where they meet, if
/// the form given after `by` is not proved equal to the formula, or if the optimised program does
/// not compute that form, which is a fault of this crate and not of the kernel.
pub(crate) fn generate(
    pool: &mut Pool,
    kernel: &Kernel,
    rewritten: &[Expr],
) -> Result<Generated, Vec<Diagnostic>> {
    let source = KernelSource {
        name: kernel.name.clone(),
        docs: kernel.docs.clone(),
        public: kernel.public,
        signature: Some(kernel.signature.clone()),
        arguments: kernel.arguments.clone(),
        outputs: kernel.outputs.clone(),
        domain: kernel.domain.clone(),
    };
    let lowered = |pool: &Pool, source: &KernelSource| {
        lower(pool, source).map_err(|error| vec![Diagnostic::new(kernel.span, error.to_string())])
    };
    let written = lowered(pool, &source)?;
    if let Some(objection) = nowhere::objection(pool, kernel, &written) {
        return Err(vec![objection]);
    }
    let faults = own_faults(pool, kernel);
    if !faults.is_empty() {
        return Err(faults.into_iter().map(|fault| fault.diagnostic).collect());
    }
    let form = with_form(kernel, &kernel.computed).or_else(|| with_form(kernel, rewritten));
    let computed = form.as_ref().unwrap_or(kernel);
    let program = lowered(pool, &KernelSource { outputs: computed.outputs.clone(), ..source })?;
    let optimised = optimised(kernel, &program, form.is_some());
    let approximation = kernel.approximation.as_ref().map_or(0.0, |number| nearest_f64(number).next_up());
    let bounded = kernel.within.as_ref().and_then(|within| optimised.keeps(within, approximation));
    if approximation > 0.0 && kernel.within.is_some() && bounded.is_none() {
        // more precision brings the value of an approximation no closer to that of the formula
        let exact = Kernel { computed: Vec::new(), approximation: None, ..kernel.clone() };
        return generate(pool, &exact, rewritten).map(|found| Generated { is_dropped: true, ..found });
    }
    let translation = translation::validate(pool, computed, &optimised);
    match translation.objection(kernel) {
        Some(objection) => Err(vec![objection]),
        None => {
            let (rewritten, promise) = (pool.texts(rewritten), kernel.within.as_ref().map(nearest_f64));
            let target_forms = target_programs(pool, kernel)?;
            Ok(Generated {
                written,
                optimised,
                translation,
                rewritten,
                promise,
                bounded,
                approximation,
                target_forms,
                is_dropped: false,
            })
        }
    }
}

/// Optimises the program of a kernel, which computes its formula or another form of it.
fn optimised(kernel: &Kernel, program: &Program, is_form: bool) -> Program {
    // a chosen form keeps the order of its sums and products, because its rounding depends on that
    // order
    let optimised = match (is_form, kernel.within.is_some()) {
        // where rules gave the form, and no bound is promised, time counts as well
        (true, false) if kernel.computed.is_empty() => program.in_order_with_shared_divisors(),
        (true, _) => program.in_order(),
        (false, _) => program.optimise(),
    };
    // a form to compute by, or an error bound, asks for accuracy first
    let is_stable = is_form || kernel.within.is_some();
    if is_stable { optimised.compensate() } else { optimised }
}

/// Returns the claims of a kernel about itself that were not proved: that its pieces agree where
/// they meet, that the form given after `by` has the value of the formula wherever the formula has
/// one, and that the kernel has a value where each of its effects vanishes.
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

/// Whether a kernel makes a claim about itself: that a form given after `by` is its formula, that
/// pieces agree where they meet, or that it has a value where an effect vanishes.
pub fn makes_claims(pool: &Pool, kernel: &Kernel) -> bool {
    let expressions: Vec<Expr> = kernel.outputs.iter().chain(&kernel.computed).copied().collect();
    let is_claim = |part: &Expr| matches!(pool.node(*part), Node::Select { seam: Seam::Agrees, .. });
    !kernel.computed.is_empty()
        || !kernel.target_forms.is_empty()
        || !kernel.effects.is_empty()
        || pool.reachable(&expressions).iter().any(is_claim)
}

/// Returns the faults of a kernel apart from its effects.
fn own_faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let mut faults = seam::faults(pool, kernel);
    if faults.is_empty() {
        faults = form_faults(pool, kernel);
        for form in &kernel.target_forms {
            faults.extend(form_faults(pool, &with_target_form(kernel, form)));
        }
    }
    faults
}

/// Returns the faults of the form that a kernel is computed by. If the form has the value of the
/// formula wherever the formula has one, its pieces agree where the pieces of the formula do. Empty
/// if there is no form.
pub(crate) fn form_faults(pool: &mut Pool, kernel: &Kernel) -> Vec<Fault> {
    let Some(form) = with_form(kernel, &kernel.computed) else { return Vec::new() };
    match form_claim::fault(pool, kernel) {
        Some(fault) => vec![fault],
        // pieces of an approximation that are close to one formula are close to each other
        None if kernel.approximation.is_some() => Vec::new(),
        None => seam::faults(pool, &form),
    }
}

/// Whether a form is proved equal to the formula of a kernel, wherever both have a value.
pub(crate) fn form_is_equal(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    form_claim::is_equal(pool, kernel, form)
}

/// Whether a form is shown to have a value wherever the formula of a kernel has one, and its pieces
/// to agree where those of the formula do.
pub(crate) fn form_has_values(pool: &mut Pool, kernel: &Kernel, form: &[Expr]) -> bool {
    definedness::is_kept_by_form(pool, kernel, form)
        && with_form(kernel, form).is_none_or(|form| seam::faults(pool, &form).is_empty())
}

/// Returns the kernel with this form as its formula, if there is a form.
fn with_form(kernel: &Kernel, form: &[Expr]) -> Option<Kernel> {
    let mut with_form = (!form.is_empty()).then(|| kernel.clone())?;
    with_form.outputs = form.to_vec();
    with_form.computed = Vec::new();
    Some(with_form)
}
