//! Generation: a kernel of a source becomes a program that is proved to compute what was written.
//!
//! ```text
//! Kernel ─┬─ seams ─▶ the pieces of every `if` agree where they meet, or an error
//!         └─ lower ─▶ Program ─ optimise ─▶ Program ─ raise ─▶ proved equal to the formula (translation)
//! ```
//! Whoever makes a kernel into source or numbers makes it here, so that no kernel goes unchecked. What could not
//! be proved is said beside the kernel, and never passed off as a proof.

mod boundary;
mod matching;
mod pieces;
mod seam;
mod translation;

pub use translation::Translation;

use crate::diagnostic::Diagnostic;
use crate::expression::Pool;
use crate::kernel::{KernelSource, Program, lower};
use crate::resolve::Kernel;

/// A kernel as programs.
#[derive(Clone, Debug)]
pub struct Generated {
    /// One instruction for each operation as it was written.
    pub written: Program,
    /// The same at least cost.
    pub optimised: Program,
    /// What is known of their agreement.
    pub translation: Translation,
}

/// Generates a kernel whose expressions belong to this pool.
///
/// ```
/// use forms_core::{check::read_theory, generation::generate};
/// let (mut theory, errors) = read_theory("kernel seventh(x) = x**7;");
/// assert!(errors.is_empty());
/// let generated = generate(&mut theory.pool, &theory.kernels[0])?;
/// assert!(generated.translation.is_proved());
/// # Ok::<(), Vec<forms_core::diagnostic::Diagnostic>>(())
/// ```
///
/// # Errors
/// If it is no kernel, if two of its pieces are not shown to agree where they meet, or if the optimised program
/// does not compute the formula, which is a fault of this crate and not of the kernel.
pub fn generate(pool: &mut Pool, kernel: &Kernel) -> Result<Generated, Vec<Diagnostic>> {
    let source = KernelSource {
        name: kernel.name.clone(),
        docs: kernel.docs.clone(),
        public: kernel.public,
        arguments: kernel.arguments.clone(),
        outputs: kernel.outputs.clone(),
        domain: kernel.domain.clone(),
    };
    let written =
        lower(pool, &source).map_err(|error| vec![Diagnostic::new(kernel.span, error.to_string())])?;
    let faults = seam::faults(pool, kernel);
    if !faults.is_empty() {
        return Err(faults);
    }
    let optimised = written.optimise();
    let translation = translation::validate(pool, kernel, &optimised);
    match translation.objection(kernel) {
        Some(objection) => Err(vec![objection]),
        None => Ok(Generated { written, optimised, translation }),
    }
}
