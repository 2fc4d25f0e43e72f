//! Programs of a kernel for one precision or target language, `for f32 { by … }`. Each form is proved like the one
//! after `by`.

use super::translation::Translation;
use super::{Generated, account_of_approximation, generate};
use crate::diagnostic::Diagnostic;
use crate::expression::Pool;
use crate::kernel::Program;
use crate::theory::{FormTarget, Kernel, TargetForm};

/// Program by which a kernel is computed in one precision or target language.
#[derive(Clone, Debug)]
pub struct TargetProgram {
    /// Where it is computed.
    pub target: FormTarget,
    /// The form at least cost, with products that cancel computed without loss.
    pub program: Program,
    /// Largest relative error of the form before rounding; 0 unless it is an approximation.
    pub approximation: f64,
    /// Program of the formula.
    pub formula: Program,
}

impl TargetProgram {
    /// Describes in a sentence how the program relates to the formula.
    pub fn account(&self) -> String {
        if self.approximation > 0.0 {
            return account_of_approximation(self.approximation);
        }
        let target = self.target.name();
        format!("{} Computed by its form for `{target}`.", Translation::Proved)
    }
}

/// Generates the forms of a kernel for one precision or target language.
pub(super) fn target_programs(
    pool: &mut Pool,
    kernel: &Kernel,
) -> Result<Vec<TargetProgram>, Vec<Diagnostic>> {
    let programs = kernel.target_forms.iter().map(|form| {
        let Generated { written: formula, optimised: program, approximation, .. } =
            generate(pool, &with_target_form(kernel, form), &[])?;
        Ok(TargetProgram { target: form.target, program, approximation, formula })
    });
    programs.collect()
}

/// Returns the kernel that is computed by one of its forms for a target, where it promises nothing.
pub(super) fn with_target_form(kernel: &Kernel, form: &TargetForm) -> Kernel {
    Kernel {
        computed: form.outputs.clone(),
        approximation: form.approximation.clone(),
        span: form.span,
        target_forms: Vec::new(),
        within: None,
        ..kernel.clone()
    }
}
