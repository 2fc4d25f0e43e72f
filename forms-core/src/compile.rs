//! Compilation: the only pipeline from a text to decided statements and compiled kernels.
//!
//! ```text
//! text ─ read ─▶ Theory ─┬─ statements ─ decide ─────────────────────────────▶ verdicts ──┐
//!                        └─ kernels ─ chosen form │ rules ─ generate ─▶ CompiledKernel ───┴─▶ Compiled
//! ```
//! A kernel is computed by its stable form: the form given by `by`, the form chosen in a file of
//! forms, or the result of the rewriting rules. The choice is a stage of this pipeline, so that no
//! front end can omit it, and the chosen form is proved to have the value of the formula wherever
//! the formula is defined.

use crate::check::{decide_all, objection, read_theory};
use crate::decide::Verdict;
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::Pool;
use crate::generation::{self, Fault, Generated};
use crate::kernel::Program;
use crate::rounding::{ErrorBound, Unbounded};
use crate::stability::{Choices, by_rules};
use crate::syntax::{Position, Source};
use crate::theory::{Kernel, Statement, Theory};

/// Options of a compilation.
#[derive(Clone, Copy, Debug, Default)]
pub struct Options<'a> {
    /// Text of a file of forms chosen for the kernels ([`crate::stability::written`]). Entries that
    /// belong to earlier formulas are ignored; [`Choices::objection`] names them. An error in this
    /// text is reported at the beginning of the compiled text, with its own line and column.
    pub choices: Option<&'a str>,
    /// Whether the statements are left undecided, where only kernels are needed.
    pub kernels_only: bool,
}

/// Compiled text.
#[derive(Clone, Debug, Default)]
pub struct Compiled {
    /// Diagnostics for the author: errors, statements whose verdict does not match their claim,
    /// claims of kernels that were not proved.
    pub diagnostics: Vec<Diagnostic>,
    /// Statements in order, each with its verdict; empty where they were not decided.
    pub statements: Vec<(Statement, Verdict)>,
    /// Kernels in order, without those that have faults.
    pub kernels: Vec<CompiledKernel>,
    /// Declarations of the text.
    pub theory: Theory,
}

/// Kernel as programs, computed by a stable form that is proved to have the value of its formula.
#[derive(Clone, Debug)]
pub struct CompiledKernel {
    kernel: Kernel,
    generated: Generated,
}

/// Stack size of the thread that compiles: recursion walks trees as deep as the parser admits.
const STACK_BYTES: usize = 256 << 20;

/// Compiles a text, on a thread with a stack of its own that is large enough for every text.
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
    std::thread::scope(|scope| {
        let own = std::thread::Builder::new().stack_size(STACK_BYTES);
        match own.spawn_scoped(scope, || compile_here(text, options)) {
            Ok(thread) => thread.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)),
            // no thread can be started: the stack of the caller is enough for nearly every text
            Err(_) => compile_here(text, options),
        }
    })
}

/// Compiles a text on the present thread.
fn compile_here(text: &str, options: &Options<'_>) -> Compiled {
    let (mut theory, mut diagnostics) = read_theory(text);
    if let Some(choices) = options.choices {
        match Choices::read(choices) {
            Ok(choices) => {
                choices.apply(&mut theory);
            }
            Err(errors) => diagnostics.extend(errors.iter().map(|error| in_choices(choices, error))),
        }
    }
    compile_theory(theory, diagnostics, options)
}

/// Returns an error in a file of chosen forms as an error at the beginning of the text, whose spans
/// are those of another text.
fn in_choices(choices: &str, error: &Diagnostic) -> Diagnostic {
    let Position { line, column } = Source::new("", choices).position(error.span.start);
    let message = format!("line {line}, column {column} of the chosen forms: {}", error.message);
    Diagnostic { help: error.help.clone(), ..Diagnostic::new(Span::default(), message) }
}

/// Compiles a theory that was read; the given diagnostics of reading come first in the result.
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
/// If its expressions cannot be lowered, if two of its pieces are not proved to agree on their
/// common boundary, if the form given by `by` is not proved to have the value of the formula
/// wherever the formula is defined, or if the optimised program is not proved to compute that form,
/// which is a defect of this crate and not of the kernel.
pub fn compile_kernel(pool: &mut Pool, kernel: &Kernel) -> Result<Generated, Vec<Diagnostic>> {
    let rewritten = by_rules(pool, kernel);
    generation::generate(pool, kernel, &rewritten)
}

/// Returns the claims of the kernels of a theory that were not proved, in order.
pub fn kernel_faults(theory: &mut Theory) -> Vec<Fault> {
    let kernels = theory.kernels.clone();
    kernels.iter().flat_map(|kernel| generation::faults(&mut theory.pool, kernel)).collect()
}

impl Compiled {
    /// Returns the kernel with this name.
    pub fn kernel(&self, name: &str) -> Option<&CompiledKernel> {
        self.kernels.iter().find(|compiled| compiled.kernel.name == name)
    }
}

impl CompiledKernel {
    /// Returns the kernel as it was declared.
    pub fn kernel(&self) -> &Kernel {
        &self.kernel
    }

    /// Returns its programs, with the evidence that they agree with the formula.
    pub fn generated(&self) -> &Generated {
        &self.generated
    }

    /// Returns the program that computes it.
    pub fn program(&self) -> &Program {
        &self.generated.optimised
    }

    /// Computes its values in `f64`, within the bound that it promises.
    pub fn values(&self, arguments: &[f64]) -> Vec<f64> {
        self.generated.values(arguments)
    }

    /// Bounds the rounding error of each value over the whole domain, with at most `boxes`
    /// subdivisions.
    ///
    /// # Errors
    /// If the domain leaves an argument unbounded, or if no finite bound was found.
    pub fn rounding_bound(&self, boxes: usize) -> Result<Vec<ErrorBound>, Unbounded> {
        self.generated.optimised.error_bound(boxes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::MAXIMUM_NESTING;

    #[test]
    fn a_text_of_any_depth_is_compiled_or_refused() {
        for [open, close] in [["(", ")"], ["-(", ")"], ["abs(", ")"], ["(1 + ", ")"], ["1/(2 + ", ")"]] {
            // a sign is a level of its own
            let levels = if open == "-(" { 2 } else { 1 };
            for depth in [100, MAXIMUM_NESTING / levels - 1, MAXIMUM_NESTING + 1] {
                let nested = open.repeat(depth) + "x" + &close.repeat(depth);
                let text = format!("kernel deep(x) = {nested} where 1 <= x <= 2;");
                let compiled = compile(&text, &Options::default());
                let is_too_deep = depth > MAXIMUM_NESTING;
                assert_eq!(
                    compiled.diagnostics.is_empty(),
                    !is_too_deep,
                    "{open} {depth}: {:?}",
                    compiled.diagnostics
                );
            }
        }
    }

    #[test]
    fn an_error_in_the_chosen_forms_is_told_with_its_own_place() {
        let choices = "// chosen forms\nkernel growth(x) = expm1(y);";
        let options = Options { choices: Some(choices), ..Options::default() };
        let compiled = compile("kernel f(x) = x;\nkernel growth(x) = exp(x) - 1;", &options);
        let [found] = &compiled.diagnostics[..] else { panic!("{:?}", compiled.diagnostics) };
        assert_eq!(found.span, Span::default());
        assert!(found.message.starts_with("line 2, column 26 of the chosen forms:"), "{}", found.message);
    }
}
