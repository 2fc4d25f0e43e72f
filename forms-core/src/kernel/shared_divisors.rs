//! Divisors that several quotients share are inverted once.
//!
//! ```text
//! x/d, y/d, z/d ─▶ i = 1/d, x i, y i, z i
//! ```
//! A product by a reciprocal rounds twice where a quotient rounds once. For forms that keep the grouping
//! of their sums and products; others share more (see [`quotients`](super::quotients)).

use super::constant::Constant;
use super::program::{Instruction, Program, Value};
use rustc_hash::FxHashMap;

/// Number of quotients from which the reciprocal is worth its rounding.
const SHARED: usize = 3;

/// Inverts the divisors of three or more quotients.
pub(super) fn share_divisors(program: &Program) -> Program {
    let mut quotients: FxHashMap<Value, usize> = FxHashMap::default();
    for instruction in &program.instructions {
        if let Instruction::Divide(_, divisor) = instruction {
            *quotients.entry(*divisor).or_default() += 1;
        }
    }
    let is_number = |value: Value| matches!(program.instruction(value), Instruction::Constant(_));
    quotients.retain(|divisor, count| *count >= SHARED && !is_number(*divisor));
    let mut reciprocals: FxHashMap<Value, Value> = FxHashMap::default();
    program.rebuilt(|rebuilt, instruction| {
        let Instruction::Divide(dividend, divisor) = instruction else { return None };
        if !quotients.contains_key(divisor) {
            return None;
        }
        let reciprocal = *reciprocals.entry(*divisor).or_insert_with(|| {
            let one = rebuilt.integer(1);
            rebuilt.push(Instruction::Divide(one, rebuilt.value(*divisor)))
        });
        let is_one = program.instruction(*dividend) == &Instruction::Constant(Constant::integer(1));
        let product = Instruction::Multiply(rebuilt.value(*dividend), reciprocal);
        Some(if is_one { reciprocal } else { rebuilt.push(product) })
    })
}

#[cfg(test)]
mod tests {
    use crate::kernel::formula::program;

    #[test]
    fn three_quotients_share_a_reciprocal_and_two_keep_their_divisions() {
        for (formulas, divisions) in [
            (&["a/d", "b/d", "c/d"][..], 1),
            (&["a/d", "b/d"], 2),
            (&["1/d", "b/d", "c/d"], 1),
            (&["a/3", "b/3", "c/3"], 3),
        ] {
            let shared = program("a b c d", formulas).in_order_with_shared_divisors();
            assert_eq!(shared.operations().divisions, divisions, "{formulas:?}");
            let values = shared.interpret(&[1.0, 2.0, 6.0, 4.0]);
            assert_eq!(values, program("a b c d", formulas).interpret(&[1.0, 2.0, 6.0, 4.0]), "{formulas:?}");
        }
    }
}
