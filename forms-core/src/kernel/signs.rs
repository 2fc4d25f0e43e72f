//! Signs: a change of sign moves into a difference or a number that nothing else uses, where it costs nothing.
//!
//! −(a − b) = b − a, −(x (a − b)) = x (b − a), −(3 x) = (−3) x

use super::numbering::without_unused;
use super::program::{Instruction, Program, Value};

/// How many operations a sign moves through.
const DEEPEST: usize = 8;

/// The program with as few changes of sign as that leaves.
pub(super) fn absorb_signs(program: &Program) -> Program {
    let mut uses = vec![0usize; program.instructions.len()];
    for operand in program.instructions.iter().flat_map(Instruction::operands).chain(program.roots()) {
        uses[operand.place()] += 1;
    }
    let mut signs = Signs { instructions: program.instructions.clone(), uses };
    for place in (0..signs.instructions.len()).rev() {
        if let Instruction::Negate(inner) = signs.instructions[place]
            && signs.flip(inner, DEEPEST)
        {
            // nothing else uses the operand: its new form stands in the negation's place
            signs.instructions[place] = signs.instructions[inner.place()].clone();
        }
    }
    without_unused(&program.with_instructions(signs.instructions, |value| value))
}

struct Signs {
    instructions: Vec<Instruction>,
    uses: Vec<usize>,
}

impl Signs {
    /// Gives a value the other sign at no cost, if that can be done unseen.
    fn flip(&mut self, value: Value, depth: usize) -> bool {
        if depth == 0 || self.uses[value.place()] != 1 {
            return false;
        }
        let instruction = self.instructions[value.place()].clone();
        let flipped = match instruction {
            Instruction::Subtract(a, b) => Instruction::Subtract(b, a),
            Instruction::Constant(constant) => Instruction::Constant(constant.negated()),
            Instruction::Add(a, b) if self.flip(a, depth - 1) => Instruction::Subtract(a, b),
            Instruction::Add(a, b) if self.flip(b, depth - 1) => Instruction::Subtract(b, a),
            Instruction::Multiply(a, b) | Instruction::Divide(a, b)
                if self.flip(a, depth - 1) || self.flip(b, depth - 1) =>
            {
                instruction
            }
            _ => return false,
        };
        self.instructions[value.place()] = flipped;
        true
    }
}
