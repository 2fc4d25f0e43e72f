//! Compilation: the one way from a text to decided statements and compiled kernels.
//!
//! ```text
//! text ─ read ─▶ Theory ─┬─ statements ─ decide ─────────────────────────────▶ verdicts ──┐
//!                        └─ kernels ─ chosen form │ rules ─ generate ─▶ CompiledKernel ───┴─▶ Compiled
//! ```
//! A kernel is computed by its stable form: the one behind `by`, the one chosen in a file of forms, or the one that
//! rules give. Choosing it is a stage of this pipeline, so that no front end can leave it out, and what is chosen is
//! proved to have the value of the formula wherever the formula has one.

use crate::check::{decide_all, objection, read_theory};
use crate::decide::Verdict;
use crate::diagnostic::Diagnostic;
use crate::expression::Pool;
use crate::generation::{self, Fault, Generated};
use crate::kernel::Program;
use crate::resolve::{Kernel, Statement, Theory};
use crate::rounding::{ErrorBound, Unbounded};
use crate::stability::{Choices, by_rules};

/// What a compilation is to do beside reading.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// The text of a file of forms chosen for the kernels ([`crate::stability::written`]).
    pub choices: Option<&'a str>,
    /// Whether the statements are left undecided, where kernels alone are wanted.
    pub kernels_only: bool,
}

/// A compiled text.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// Everything its author has to be told: mistakes, statements that are not as claimed, claims of kernels that
    /// were not shown.
    pub diagnostics: Vec<Diagnostic>,
    /// The statements in order, each with its verdict; none where they were not to be decided.
    pub statements: Vec<(Statement, Verdict)>,
    /// The kernels in order, those with faults left out.
    pub kernels: Vec<CompiledKernel>,
    /// What the text declares.
    pub theory: Theory,
}

/// A kernel that is proved to compute its formula by a stable form, as programs.
#[derive(Clone, Debug)]
pub struct CompiledKernel {
    kernel: Kernel,
    generated: Generated,
}

/// Compiles a text.
///
/// ```
/// use forms_core::compile::{Options, compile};
/// let compiled = compile("kernel growth(x) = exp(x) - 1; prove zero: exp(0) - 1 == 0;", &Options::default());
/// assert!(compiled.diagnostics.is_empty());
/// // what cancels as it is written is computed by an equal form that does not
/// assert_eq!(compiled.kernel("growth").unwrap().values(&[1e-17]), [1e-17]);
/// assert_eq!(compiled.statements[0].1.name(), "proved");
/// ```
pub fn compile(text: &str, options: &Options<'_>) -> Compiled {
    let (mut theory, mut diagnostics) = read_theory(text);
    if let Some(choices) = options.choices {
        match Choices::read(choices) {
            Ok(choices) => {
                choices.apply(&mut theory);
            }
            Err(errors) => diagnostics.extend(errors),
        }
    }
    compile_theory(theory, diagnostics, options)
}

/// Compiles what was read, beside the mistakes that were found in it.
pub fn compile_theory(
    mut theory: Theory,
    mut diagnostics: Vec<Diagnostic>,
    options: &Options<'_>,
) -> Compiled {
    let verdicts = if options.kernels_only { Vec::new() } else { decide_all(&mut theory) };
    let statements: Vec<(Statement, Verdict)> = theory.statements.iter().cloned().zip(verdicts).collect();
    diagnostics.extend(statements.iter().filter_map(|(statement, verdict)| objection(statement, verdict)));
    let mut kernels = Vec::new();
    for kernel in theory.kernels.clone() {
        match compile_kernel(&mut theory.pool, &kernel) {
            Ok(generated) => kernels.push(CompiledKernel { kernel, generated }),
            Err(found) => diagnostics.extend(found),
        }
    }
    Compiled { diagnostics, statements, kernels, theory }
}

/// Compiles one kernel, whose expressions belong to this pool.
///
/// # Errors
/// If it is no kernel, if two of its pieces are not shown to agree where they meet, if the form behind `by` is not
/// proved to have the value of the formula wherever the formula has one, or if the optimised program does not compute
/// that form, which is a fault of this crate and not of the kernel.
pub fn compile_kernel(pool: &mut Pool, kernel: &Kernel) -> Result<Generated, Vec<Diagnostic>> {
    let rewritten = by_rules(pool, kernel);
    generation::generate(pool, kernel, &rewritten)
}

/// What the kernels of a theory claim of themselves and was not shown, in order.
pub fn kernel_faults(theory: &mut Theory) -> Vec<Fault> {
    let kernels = theory.kernels.clone();
    kernels.iter().flat_map(|kernel| generation::faults(&mut theory.pool, kernel)).collect()
}

impl Compiled {
    /// The kernel of that name.
    pub fn kernel(&self, name: &str) -> Option<&CompiledKernel> {
        self.kernels.iter().find(|compiled| compiled.kernel.name == name)
    }
}

impl CompiledKernel {
    /// The kernel as it was declared.
    pub fn kernel(&self) -> &Kernel {
        &self.kernel
    }

    /// Its programs, and what is known of their agreement with the formula.
    pub fn generated(&self) -> &Generated {
        &self.generated
    }

    /// The program it is computed by.
    pub fn program(&self) -> &Program {
        &self.generated.optimised
    }

    /// Its values in `f64`, within what it promises.
    pub fn values(&self, arguments: &[f64]) -> Vec<f64> {
        self.generated.values(arguments)
    }

    /// Bounds of the rounding error of each value over the whole domain, from at most so many boxes.
    ///
    /// # Errors
    /// If the domain leaves an argument unbounded, or if no finite bound was found.
    pub fn rounding_bound(&self, boxes: usize) -> Result<Vec<ErrorBound>, Unbounded> {
        self.generated.optimised.error_bound(boxes)
    }
}
