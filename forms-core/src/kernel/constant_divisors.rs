//! Divisions by roots of numbers become products.
//!
//! ```text
//! x/√c ─▶ x √(1/c)        x/(y √c) ─▶ (x/y) √(1/c)
//! ```
//! A root of a number is rounded once in either case; a product takes a fraction of the time of a
//! quotient.

use super::constant::Constant;
use super::program::{Instruction, Program, Value};

/// Replaces divisions by roots of numbers.
pub(super) fn invert_constant_divisors(program: &Program) -> Program {
    // the number under the root, where a value is the root of a positive number
    let radicand = |value: Value| match program.instruction(value) {
        Instruction::Sqrt(radicand) => match program.instruction(*radicand) {
            Instruction::Constant(number) if !number.is_negative() && !number.is_zero() => Some(number),
            _ => None,
        },
        _ => None,
    };
    let split = |divisor: Value| match program.instruction(divisor) {
        Instruction::Multiply(a, b) => {
            let [left, right] = [radicand(*a), radicand(*b)];
            right.map(|number| (Some(*a), number)).or(left.map(|number| (Some(*b), number)))
        }
        _ => radicand(divisor).map(|number| (None, number)),
    };
    let mut instructions: Vec<Instruction> = Vec::with_capacity(program.instructions.len());
    let mut values: Vec<Value> = Vec::with_capacity(program.instructions.len());
    let mut push = |instruction: Instruction| {
        instructions.push(instruction);
        Value(instructions.len() as u32 - 1)
    };
    for instruction in &program.instructions {
        let value = match instruction {
            Instruction::Divide(dividend, divisor) => {
                let Some((rest, number)) = split(*divisor) else {
                    values.push(push(instruction.with_operands(|operand| values[operand.place()])));
                    continue;
                };
                let dividend = values[dividend.place()];
                let quotient =
                    rest.map_or(dividend, |rest| push(Instruction::Divide(dividend, values[rest.place()])));
                let root = root(&mut push, number);
                push(Instruction::Multiply(quotient, root))
            }
            other => push(other.with_operands(|operand| values[operand.place()])),
        };
        values.push(value);
    }
    program.with_instructions(instructions, |root| values[root.place()])
}

/// Appends √(1/c).
fn root(push: &mut impl FnMut(Instruction) -> Value, number: &Constant) -> Value {
    let inverse = push(Instruction::Constant(number.reciprocal()));
    push(Instruction::Sqrt(inverse))
}

#[cfg(test)]
mod tests {
    use crate::kernel::formula::program;

    #[test]
    fn divisions_by_roots_of_numbers_become_products() {
        for (formulas, divisions) in [
            (&["x/sqrt(2)"][..], 0),
            (&["x/(y*sqrt(2))", "x/y"], 1),
            (&["x/sqrt(y)"], 1),
            (&["sqrt(2)/x"], 1),
        ] {
            let written = program("x y", formulas);
            for changed in [written.in_order(), written.optimise()] {
                assert_eq!(changed.operations().divisions, divisions, "{formulas:?}");
                for (value, expected) in
                    changed.interpret(&[3.0, 7.0]).iter().zip(written.interpret(&[3.0, 7.0]))
                {
                    assert!((value / expected - 1.0).abs() < 4.0 * f64::EPSILON, "{formulas:?}");
                }
            }
        }
    }
}
