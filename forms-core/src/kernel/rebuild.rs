//! Rebuilding: a pass over a program gives for each instruction those that take its place.
//!
//! ```text
//! p = a b;  q = p + c      ─▶  …      q becomes q′, and what uses q uses q′
//! ```

use super::constant::Constant;
use super::program::{Instruction, Program, Value};

/// The instructions that have taken the places of the first ones of a program.
pub(super) struct Rebuilt {
    instructions: Vec<Instruction>,
    /// For each instruction of the program the value that has taken its place.
    values: Vec<Value>,
}

impl Rebuilt {
    /// Appends an instruction on values among these instructions.
    pub(super) fn push(&mut self, instruction: Instruction) -> Value {
        self.instructions.push(instruction);
        Value(self.instructions.len() as u32 - 1)
    }

    /// Appends a whole number.
    pub(super) fn integer(&mut self, number: i64) -> Value {
        self.push(Instruction::Constant(Constant::integer(number)))
    }

    /// Returns the value that has taken the place of a value of the program.
    pub(super) fn value(&self, before: Value) -> Value {
        self.values[before.place()]
    }
}

impl Program {
    /// Returns the same kernel by other instructions: `replace` appends those that take the place of
    /// an instruction, and returns their value; `None` leaves it as it is.
    pub(super) fn rebuilt(
        &self,
        mut replace: impl FnMut(&mut Rebuilt, &Instruction) -> Option<Value>,
    ) -> Program {
        let count = self.instructions.len();
        let mut rebuilt =
            Rebuilt { instructions: Vec::with_capacity(count), values: Vec::with_capacity(count) };
        for instruction in &self.instructions {
            let value = replace(&mut rebuilt, instruction).unwrap_or_else(|| {
                let moved = instruction.with_operands(|before| rebuilt.value(before));
                rebuilt.push(moved)
            });
            rebuilt.values.push(value);
        }
        self.with_instructions(rebuilt.instructions, |root| rebuilt.values[root.place()])
    }

    /// Returns the function that gives the factors of a value, if it is a product that one
    /// instruction uses.
    pub(super) fn products_used_once(&self) -> impl Fn(Value) -> Option<[Value; 2]> {
        let uses = self.uses();
        move |value| match self.instruction(value) {
            Instruction::Multiply(a, b) if uses[value.place()] == 1 => Some([*a, *b]),
            _ => None,
        }
    }
}

/// Returns the sum of two values, or their difference.
pub(super) fn sum_or_difference(left: Value, right: Value, is_difference: bool) -> Instruction {
    if is_difference { Instruction::Subtract(left, right) } else { Instruction::Add(left, right) }
}
