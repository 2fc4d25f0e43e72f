//! Features of targets that kernels need: functions, quadratures, numbers within the range.

use super::shader_functions::definition;
use super::target::{EmitError, Precision, Target};
use crate::kernel::{Instruction, Program};

/// Checks that the target has every feature that the program needs.
pub(super) fn check(program: &Program, target: Target, precision: Precision) -> Result<(), EmitError> {
    let kernel = || program.name.clone();
    for instruction in &program.instructions {
        match instruction {
            Instruction::Call(operation, _) => {
                let row = operation.row();
                let has = match target {
                    Target::Rust => true,
                    Target::C => row.spelling.c.is_some(),
                    Target::Wgsl => row.spelling.wgsl.is_some() || definition(*operation).is_some(),
                    Target::Cuda => row.spelling.cuda.is_some(),
                };
                if !has {
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
