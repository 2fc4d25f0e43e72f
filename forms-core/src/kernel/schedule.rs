//! Scheduling: the order of the instructions that keeps the fewest values alive at once (register
//! pressure).
//!
//! List scheduling runs backwards from the results. Among the instructions whose users have all
//! been placed, the one that starts the fewest new live ranges goes last; among equals, the one
//! whose result was requested last. Numbers and arguments are in memory and do not count. The
//! instructions of the domain stay before all others.

use super::program::{Instruction, Program, Value};
use std::ops::Range;

/// Largest number of instructions of a program that is reordered.
const LONGEST: usize = 4_000;

/// Returns the program in the order that keeps the fewest values alive; on a tie, in its own order.
pub(super) fn schedule(program: &Program) -> Program {
    if program.instructions.len() > LONGEST {
        return program.clone();
    }
    let head = program.head();
    let mut order = ordered(program, 0..head);
    order.extend(ordered(program, head..program.instructions.len()));
    let scheduled = reordered(program, &order);
    if scheduled.live_values() < program.live_values() { scheduled } else { program.clone() }
}

/// Returns the program with its instructions in the given order of their indices.
fn reordered(program: &Program, order: &[usize]) -> Program {
    let mut places = vec![Value(0); order.len()];
    let mut instructions = Vec::with_capacity(order.len());
    for &place in order {
        places[place] = Value(instructions.len() as u32);
        instructions.push(program.instructions[place].with_operands(|operand| places[operand.place()]));
    }
    program.with_instructions(instructions, |root| places[root.place()])
}

/// Whether the value of an instruction occupies a register.
fn is_computed(instruction: &Instruction) -> bool {
    !matches!(instruction, Instruction::Constant(_) | Instruction::Argument(_))
}

/// Returns the indices of a part of the program in the order of their evaluation.
fn ordered(program: &Program, part: Range<usize>) -> Vec<usize> {
    let mut waiting = vec![0usize; program.instructions.len()];
    for instruction in &program.instructions[part.clone()] {
        instruction.operands().iter().for_each(|operand| waiting[operand.place()] += 1);
    }
    let mut ready: Vec<usize> = part.clone().filter(|&place| waiting[place] == 0).collect();
    // the results are requested in their order, so the first one is placed last
    ready.reverse();
    let mut alive = vec![false; program.instructions.len()];
    program.roots().for_each(|root| alive[root.place()] = true);
    let mut order = Vec::with_capacity(part.len());
    while let Some(next) = best(program, &ready, &alive) {
        let place = ready.remove(next);
        order.push(place);
        for operand in program.instructions[place].operands() {
            alive[operand.place()] = true;
            waiting[operand.place()] -= 1;
            if waiting[operand.place()] == 0 && part.contains(&operand.place()) {
                ready.push(operand.place());
            }
        }
    }
    order.reverse();
    order
}

/// Returns which of the ready instructions starts the fewest live ranges.
fn best(program: &Program, ready: &[usize], alive: &[bool]) -> Option<usize> {
    let brought = |place: usize| {
        let mut operands = program.instructions[place].operands();
        operands.sort_unstable();
        operands.dedup();
        operands.retain(|operand| !alive[operand.place()] && is_computed(program.instruction(*operand)));
        operands.len() as i64 - i64::from(is_computed(&program.instructions[place]))
    };
    (0..ready.len()).rev().min_by_key(|&at| brought(ready[at]))
}

impl Program {
    /// Returns the number of instructions before the conditions of the domain can be decided.
    pub(crate) fn head(&self) -> usize {
        let sides = self.domain.iter().flat_map(|condition| [condition.left, condition.right]);
        sides.max().map_or(0, |last| last.place() + 1)
    }

    /// Returns the largest number of computed values that are alive at once.
    pub fn live_values(&self) -> usize {
        let mut last_use = vec![0; self.instructions.len()];
        for (place, instruction) in self.instructions.iter().enumerate() {
            instruction.operands().iter().for_each(|operand| last_use[operand.place()] = place);
        }
        self.outputs.iter().for_each(|output| last_use[output.place()] = self.instructions.len());
        let head = self.head();
        let sides = self.domain.iter().flat_map(|condition| [condition.left, condition.right]);
        sides.for_each(|side| last_use[side.place()] = last_use[side.place()].max(head));
        let mut ends = vec![0usize; self.instructions.len() + 1];
        let (mut alive, mut most) = (0usize, 0);
        for (place, instruction) in self.instructions.iter().enumerate() {
            alive -= ends[place];
            if is_computed(instruction) && last_use[place] > place {
                alive += 1;
                ends[last_use[place]] += 1;
            }
            most = most.max(alive);
        }
        most
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::formula::program;

    #[test]
    fn sums_of_products_are_finished_one_by_one() {
        // both products of each sum, and a finished sum together with the next product
        let written = program("a b c d", &["a*b", "c*d", "a*c", "b*d"]);
        assert_eq!(written.live_values(), 4);
        let breadth_first =
            program("a b c d", &["a*b + c*d", "a*c + b*d", "a*d + b*c", "sin(a*b) + sin(c*d)"]);
        assert!(schedule(&breadth_first).live_values() <= breadth_first.live_values());
    }

    #[test]
    fn a_program_that_computes_everything_first_is_put_in_order() {
        let tidy = program("a b c d", &["(sin(a) + sin(b)) + (sin(c) + sin(d))"]);
        let mut order: Vec<usize> = (0..tidy.instructions.len()).collect();
        // the sines before the sums
        order.sort_by_key(|&place| matches!(tidy.instructions[place], Instruction::Add(..)));
        let untidy = reordered(&tidy, &order);
        assert_eq!((tidy.live_values(), untidy.live_values()), (3, 4));
        assert_eq!(schedule(&untidy).live_values(), 3);
    }
}
