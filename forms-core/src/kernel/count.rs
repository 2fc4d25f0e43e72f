//! Cost of a program: its operations by kind, and one weighted number to compare programs by.

use super::program::{Instruction, Program};
use std::fmt;

/// Cost of a division relative to an addition.
const DIVISION: u32 = 4;
/// Cost of a square root relative to an addition.
const SQUARE_ROOT: u32 = 5;
/// Cost of a compensated sum of two products relative to an addition: two products, their errors,
/// and the sums of both.
const PRODUCTS: u32 = 6;
/// Cost of a general power relative to an addition.
const POWER: u32 = 30;
/// Approximate number of evaluations of the integrand for one integral.
const NODES: u32 = 60;
/// Cost of a conditional relative to an addition.
const SELECT: u32 = 2;

/// Operations of a program; arguments and numbers cost nothing.
///
/// A fused instruction counts as the additions and multiplications that it consists of, so that a
/// count gives the arithmetic of a formula on any target; [`OperationCount::fused`] gives the
/// number of instructions that fusing saves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct OperationCount {
    /// Additions and subtractions.
    pub adds: usize,
    /// Multiplications.
    pub multiplies: usize,
    /// Number of additions that are one instruction with a multiplication.
    pub fused: usize,
    /// Changes of sign.
    pub negations: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Functions of the operation table, and powers with exponents that need the general power
    /// function.
    pub function_calls: usize,
    /// Conditionals that select one of two values.
    pub selects: usize,
}

impl OperationCount {
    /// Returns the number of arithmetic operations: all but function calls and conditionals.
    pub fn arithmetic(&self) -> usize {
        self.adds + self.multiplies + self.negations + self.divisions + self.square_roots
    }
}

impl fmt::Display for OperationCount {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kinds = [
            (self.adds, "addition", "additions"),
            (self.multiplies, "multiplication", "multiplications"),
            (self.negations, "negation", "negations"),
            (self.divisions, "division", "divisions"),
            (self.square_roots, "square root", "square roots"),
            (self.function_calls, "function call", "function calls"),
            (self.selects, "conditional", "conditionals"),
        ];
        let parts: Vec<String> = kinds
            .iter()
            .filter(|(count, ..)| *count > 0)
            .map(|(count, one, many)| format!("{count} {}", if *count == 1 { one } else { many }))
            .collect();
        if parts.is_empty() { f.write_str("none") } else { f.write_str(&parts.join(", ")) }
    }
}

impl Program {
    /// Counts the operations of each kind.
    pub fn operations(&self) -> OperationCount {
        let mut count = OperationCount::default();
        for instruction in &self.instructions {
            match instruction {
                Instruction::Constant(_) | Instruction::Argument(_) => {}
                Instruction::Add(..) | Instruction::Subtract(..) => count.adds += 1,
                Instruction::Multiply(..) => count.multiplies += 1,
                Instruction::MultiplyAdd(..) => {
                    count.adds += 1;
                    count.multiplies += 1;
                    count.fused += 1;
                }
                Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_) => {
                    count.adds += 1;
                    count.multiplies += 2;
                }
                Instruction::Divide(..) => count.divisions += 1,
                Instruction::Negate(_) => count.negations += 1,
                Instruction::Sqrt(_) => count.square_roots += 1,
                Instruction::Power(..) | Instruction::Call(..) | Instruction::Quadrature { .. } => {
                    count.function_calls += 1;
                }
                Instruction::Select { .. } => count.selects += 1,
            }
        }
        count
    }

    /// Returns the cost in units of one addition.
    pub fn cost(&self) -> u32 {
        let cost = |instruction: &Instruction| match instruction {
            Instruction::Constant(_) | Instruction::Argument(_) => 0,
            Instruction::Add(..)
            | Instruction::Subtract(..)
            | Instruction::Multiply(..)
            | Instruction::Negate(_) => 1,
            Instruction::MultiplyAdd(..) => 2,
            Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_) => PRODUCTS,
            Instruction::Divide(..) => DIVISION,
            Instruction::Sqrt(_) => SQUARE_ROOT,
            Instruction::Power(..) => POWER,
            Instruction::Call(operation, _) => operation.row().cost,
            Instruction::Quadrature { integrand, .. } => NODES * integrand.cost(),
            Instruction::Select { .. } => SELECT,
        };
        self.instructions.iter().map(cost).sum()
    }
}
