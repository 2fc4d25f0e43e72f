//! Emission of a whole source file: the definitions that kernels need, and a function for each.

use super::c::{C, Flavour};
use super::promise::{Promise, promise};
use super::target::{EmitError, Precision, Source, Target};
use super::{generic, names, rust, wgsl};
use crate::kernel::{Instruction, Program};

impl Source {
    /// Writes the documented function under this name.
    fn function(&self, name: &str, target: Target, precision: Precision) -> String {
        let promise = self.promise(target, precision);
        let (program, mut docs) = names::renamed(&self.program, &self.docs, target, name);
        let program = &program;
        match (&promise, &self.within) {
            (Some(promise), Some(within)) => docs.rounding = promise.sentence(within, target, precision),
            _ if precision != Precision::F64 => docs.rounding.clear(),
            _ => {}
        }
        let docs = &docs;
        let escalates = promise == Some(Promise::ByPrecision);
        match (target, precision) {
            (Target::Rust, Precision::DoubleDouble) => generic::double_double(program, docs, escalates),
            (Target::Rust, _) => match &self.within {
                Some(within) if escalates => rust::escalating(program, docs, within, precision),
                _ => rust::written(program, docs, generic::MATH, precision),
            },
            (Target::C, _) => C::new(Flavour::C, precision).function(program, docs),
            (Target::Cuda, _) => C::new(Flavour::Cuda, precision).function(program, docs),
            (Target::Wgsl, _) => wgsl::function_of(program, docs),
        }
    }

    /// Returns how the promise of the kernel is kept, if it has one.
    fn promise(&self, target: Target, precision: Precision) -> Option<Promise> {
        Some(promise(self, self.within.as_ref()?, target, precision))
    }

    /// Whether the kernel's Rust source needs the arithmetic of `forms_math`.
    fn needs_math(&self, precision: Precision) -> bool {
        match precision {
            Precision::F32 | Precision::F64 => {
                self.promise(Target::Rust, precision) == Some(Promise::ByPrecision)
                    || self.program.needs_math()
            }
            Precision::DoubleDouble => true,
        }
    }
}

/// Emits kernels as source that compiles as it stands: the definitions that they need, and a
/// documented function for each.
///
/// # Errors
/// The missing feature of the target, for the first kernel that needs it.
pub fn emit(kernels: &[Source], target: Target, precision: Precision) -> Result<String, EmitError> {
    if !target.has(precision) {
        return Err(EmitError::Precision(target, precision));
    }
    for kernel in kernels {
        check(&kernel.program, target, precision)?;
    }
    let programs: Vec<&Program> = kernels.iter().map(|kernel| &kernel.program).collect();
    let head = match target {
        Target::Rust if kernels.iter().any(|kernel| kernel.needs_math(precision)) => forms_math::source(),
        Target::Rust => String::new(),
        Target::C => C::new(Flavour::C, precision).head(&programs),
        Target::Cuda => C::new(Flavour::Cuda, precision).head(&programs),
        Target::Wgsl => wgsl::head(&programs),
    };
    let names: Vec<String> = programs.iter().map(|program| program.name.clone()).collect();
    let names = names::of_kernels(target, &names);
    let functions = kernels.iter().zip(&names).map(|(kernel, name)| kernel.function(name, target, precision));
    let functions: Vec<String> = functions.collect();
    let functions = functions.join("\n");
    // in Rust the needed definitions come last, so that the kernels can be read first
    let parts = if target == Target::Rust { [functions, head] } else { [head, functions] };
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    Ok(parts.join("\n"))
}

/// Checks that the target has every feature that the program needs.
fn check(program: &Program, target: Target, precision: Precision) -> Result<(), EmitError> {
    let kernel = || program.name.clone();
    for instruction in &program.instructions {
        match instruction {
            Instruction::Call(operation, _) => {
                let row = operation.row();
                let spelling = match target {
                    Target::Rust => Some(row.real),
                    Target::C => row.spelling.c,
                    Target::Wgsl => row.spelling.wgsl,
                    Target::Cuda => row.spelling.cuda,
                };
                if spelling.is_none() {
                    return Err(EmitError::Function { kernel: kernel(), function: row.name, target });
                }
            }
            Instruction::Constant(constant) if precision == Precision::F32 => {
                let nearest = constant.to_f32();
                if !nearest.is_finite() || (nearest == 0.0 && !constant.is_zero()) {
                    let number = constant.to_string();
                    return Err(EmitError::Number { kernel: kernel(), number, precision });
                }
            }
            Instruction::Quadrature { .. } if target != Target::Rust => {
                return Err(EmitError::Function { kernel: kernel(), function: "quadrature", target });
            }
            Instruction::Quadrature { integrand, .. } => check(integrand, target, precision)?,
            _ => {}
        }
    }
    Ok(())
}
