//! Signs: a change of sign moves into a difference or a number that has no other user, where it
//! costs nothing.
//!
//! −(a − b) = b − a, −(x (a − b)) = x (b − a), −(3 x) = (−3) x. A difference that other sums also
//! use is reversed if these sums can subtract instead of add.

use super::numbering::without_unused;
use super::program::{Instruction, Program, Value};
use rustc_hash::FxHashSet;

/// Largest number of operations that a sign moves through.
const DEEPEST: usize = 8;

/// Returns the program with its changes of sign absorbed where possible.
pub(super) fn absorb_signs(program: &Program) -> Program {
    let program = &turn_differences(program);
    let mut signs = Signs { instructions: program.instructions.clone(), uses: program.uses() };
    for place in (0..signs.instructions.len()).rev() {
        if let Instruction::Negate(inner) = signs.instructions[place]
            && signs.flip(inner, DEEPEST)
        {
            // the operand has no other user, so its new form replaces the negation
            signs.instructions[place] = signs.instructions[inner.place()].clone();
        }
    }
    without_unused(&program.with_instructions(signs.instructions, |value| value))
}

/// Reverses a − b to b − a if a change of sign uses it and all other users are sums that can take
/// −(a − b) instead.
fn turn_differences(program: &Program) -> Program {
    let mut instructions = program.instructions.clone();
    let mut images: Vec<Value> = (0..instructions.len() as u32).map(Value).collect();
    let mut users: Vec<Vec<usize>> = vec![vec![]; instructions.len()];
    for (place, instruction) in instructions.iter().enumerate() {
        instruction.operands().iter().for_each(|operand| users[operand.place()].push(place));
    }
    let roots: FxHashSet<Value> = program.roots().collect();
    // from the last to the first: once a sum of two differences adds the right one, it can take the
    // left one reversed
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

/// Returns the same sum with −d in place of d.
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
    /// Changes the sign of a value at no cost, if the value has no other user.
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
