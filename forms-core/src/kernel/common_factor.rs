//! Common factors of two products whose sum or difference could cancel.
//!
//! ```text
//! a b − a c ─▶ a (b − c)        a b + a c ─▶ a (b + c)
//! ```
//! The right sides round twice, and cancel no rounded product. They take the place of compensation,
//! which costs more.

use super::numbering::number_values;
use super::program::{Instruction, Program, Value};

/// Takes the common factor out of sums and differences of two products that nothing else uses.
pub(super) fn take_out_common_factors(program: &Program) -> Program {
    let uses = program.uses();
    let product = |value: Value| match program.instruction(value) {
        Instruction::Multiply(a, b) if uses[value.place()] == 1 => Some([*a, *b]),
        _ => None,
    };
    let mut instructions: Vec<Instruction> = Vec::with_capacity(program.instructions.len());
    let mut values: Vec<Value> = Vec::with_capacity(program.instructions.len());
    let mut push = |instruction: Instruction| {
        instructions.push(instruction);
        Value(instructions.len() as u32 - 1)
    };
    for instruction in &program.instructions {
        let operands = match instruction {
            Instruction::Add(p, q) | Instruction::Subtract(p, q) => product(*p).zip(product(*q)),
            _ => None,
        };
        let value = match operands.and_then(|(left, right)| common(left, right)) {
            Some((factor, rest)) => {
                let [left, right] = rest.map(|value| values[value.place()]);
                let is_sum = matches!(instruction, Instruction::Add(..));
                let sum =
                    if is_sum { Instruction::Add(left, right) } else { Instruction::Subtract(left, right) };
                let sum = push(sum);
                push(Instruction::Multiply(values[factor.place()], sum))
            }
            None => push(instruction.with_operands(|operand| values[operand.place()])),
        };
        values.push(value);
    }
    number_values(&program.with_instructions(instructions, |root| values[root.place()]))
}

/// Returns the common factor of two products, and the other factor of each.
fn common([a, b]: [Value; 2], [c, d]: [Value; 2]) -> Option<(Value, [Value; 2])> {
    match () {
        () if a == c => Some((a, [b, d])),
        () if a == d => Some((a, [b, c])),
        () if b == c => Some((b, [a, d])),
        () if b == d => Some((b, [a, c])),
        () => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::formula::program;

    #[test]
    fn a_common_factor_is_taken_out_of_products_that_nothing_else_uses() {
        let cases: [(&[&str], usize); 5] = [
            (&["a*b - c*a"], 2),
            (&["a*b + a*c"], 2),
            (&["a*b - c*d"], 3),
            (&["a*b - a*c", "a*b"], 3),
            (&["a*a - b*a"], 2),
        ];
        for (formulas, operations) in cases {
            let taken = take_out_common_factors(&number_values(&program("a b c d", formulas)));
            assert_eq!(taken.operations().arithmetic(), operations, "{formulas:?}");
        }
    }

    #[test]
    fn the_difference_keeps_its_digits() {
        let near = 1.0 + f64::EPSILON;
        let difference = program("a b c", &["a*b - c*a"]).in_order();
        assert_eq!(difference.interpret(&[1.0 / 3.0, near, 1.0]), [f64::EPSILON / 3.0]);
    }
}
