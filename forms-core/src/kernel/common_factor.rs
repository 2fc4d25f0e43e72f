//! Common factors of two products whose sum or difference could cancel.
//!
//! ```text
//! a b − a c ─▶ a (b − c)        a b + a c ─▶ a (b + c)
//! ```
//! The right sides round twice, and cancel no rounded product. They take the place of compensation,
//! which costs more.

use super::numbering::number_values;
use super::program::{Instruction, Program, Value};
use super::rebuild::sum_or_difference;

/// Takes the common factor out of sums and differences of two products that nothing else uses.
pub(super) fn take_out_common_factors(program: &Program) -> Program {
    let product = program.products_used_once();
    let taken = program.rebuilt(|rebuilt, instruction| {
        let (p, q, is_difference) = match instruction {
            Instruction::Add(p, q) => (p, q, false),
            Instruction::Subtract(p, q) => (p, q, true),
            _ => return None,
        };
        let (factor, rest) = common(product(*p)?, product(*q)?)?;
        let [left, right] = rest.map(|value| rebuilt.value(value));
        let sum = rebuilt.push(sum_or_difference(left, right, is_difference));
        Some(rebuilt.push(Instruction::Multiply(rebuilt.value(factor), sum)))
    });
    number_values(&taken)
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
