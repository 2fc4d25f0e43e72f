//! Divisions by roots of numbers become products.
//!
//! ```text
//! x/√c ─▶ x √(1/c)        x/(y √c) ─▶ (x/y) √(1/c)
//! ```
//! A root of a number is rounded once in either case; a product takes a fraction of the time of a
//! quotient.

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
    program.rebuilt(|rebuilt, instruction| {
        let Instruction::Divide(dividend, divisor) = instruction else { return None };
        let (rest, number) = split(*divisor)?;
        let dividend = rebuilt.value(*dividend);
        let quotient = rest.map_or(dividend, |rest| {
            let divide = Instruction::Divide(dividend, rebuilt.value(rest));
            rebuilt.push(divide)
        });
        let inverse = rebuilt.push(Instruction::Constant(number.reciprocal()));
        let root = rebuilt.push(Instruction::Sqrt(inverse));
        Some(rebuilt.push(Instruction::Multiply(quotient, root)))
    })
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
