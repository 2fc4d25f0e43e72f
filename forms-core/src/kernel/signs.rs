//! Signs: a change of sign moves into a difference or a number that nothing else uses, where it costs nothing.
//!
//! −(a − b) = b − a, −(x (a − b)) = x (b − a), −(3 x) = (−3) x. A difference that other sums use as well is
//! turned round if they can subtract what they added.

use super::numbering::without_unused;
use super::program::{Instruction, Program, Value};
use rustc_hash::FxHashSet;

/// How many operations a sign moves through.
const DEEPEST: usize = 8;

/// The program with as few changes of sign as that leaves.
pub(super) fn absorb_signs(program: &Program) -> Program {
    let program = &turn_differences(program);
    let mut signs = Signs { instructions: program.instructions.clone(), uses: program.uses() };
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

/// Turns a − b into b − a where a change of sign uses it, and otherwise only sums that can take −(a − b) instead.
fn turn_differences(program: &Program) -> Program {
    let mut instructions = program.instructions.clone();
    let mut images: Vec<Value> = (0..instructions.len() as u32).map(Value).collect();
    let mut users: Vec<Vec<usize>> = vec![vec![]; instructions.len()];
    for (place, instruction) in instructions.iter().enumerate() {
        instruction.operands().iter().for_each(|operand| users[operand.place()].push(place));
    }
    let roots: FxHashSet<Value> = program.roots().collect();
    // the last first: a sum of two differences can take the left one turned once it adds the right one
    for place in (0..instructions.len()).rev() {
        let value = Value(place as u32);
        let Instruction::Subtract(a, b) = instructions[place] else { continue };
        let (signs, sums): (Vec<usize>, Vec<usize>) =
            users[place].iter().partition(|&&user| matches!(instructions[user], Instruction::Negate(_)));
        let turned: Option<Vec<Instruction>> =
            sums.iter().map(|&user| with_turned(&instructions[user], value)).collect();
        if let Some(turned) = turned
            && !signs.is_empty()
            && !roots.contains(&value)
        {
            instructions[place] = Instruction::Subtract(b, a);
            sums.iter().zip(turned).for_each(|(&user, turned)| instructions[user] = turned);
            signs.iter().for_each(|&sign| images[sign] = value);
        }
    }
    let image = |value: Value| images[value.place()];
    let instructions = instructions.iter().map(|instruction| instruction.with_operands(image)).collect();
    without_unused(&program.with_instructions(instructions, image))
}

/// The same sum with −d in place of d.
fn with_turned(sum: &Instruction, difference: Value) -> Option<Instruction> {
    match *sum {
        Instruction::Add(a, b) if b == difference && a != b => Some(Instruction::Subtract(a, b)),
        Instruction::Add(a, b) if a == difference && a != b => Some(Instruction::Subtract(b, a)),
        Instruction::Subtract(a, b) if b == difference && a != b => Some(Instruction::Add(a, b)),
        _ => None,
    }
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
