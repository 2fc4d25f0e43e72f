//! Fusing: a product with a single sum as its user becomes one instruction with that sum, and the
//! reverse.
//!
//! ```text
//! p = a b;  p + c ─▶ a b + c        p = a b, q = c d;  p − q ─▶ a b − c d, compensated
//! ```
//! A fused instruction differs from the original in its rounding alone: one rounding instead of two
//! if the target has the instruction. Compensation is for forms that were chosen for their
//! accuracy, since it doubles the cost.

use super::common_factor::take_out_common_factors;
use super::numbering::without_unused;
use super::program::{Instruction, ProductSum, Program, Value};
use super::rebuild::{Rebuilt, sum_or_difference};
use super::schedule::schedule;

/// Fuses products that have a single sum as their user into that sum.
pub(super) fn fuse(program: &Program) -> Program {
    let product = program.products_used_once();
    rewritten(program, |instruction| {
        let (a, b, is_difference) = match *instruction {
            Instruction::Add(a, b) => (a, b, false),
            Instruction::Subtract(a, b) => (a, b, true),
            _ => return None,
        };
        let fused = |sum, [x, y]: [Value; 2], other| Instruction::MultiplyAdd(sum, [x, y, other]);
        match (product(a), product(b)) {
            (_, Some(right)) if is_difference => Some(fused(ProductSum::MinusProduct, right, a)),
            (_, Some(right)) => Some(fused(ProductSum::PlusProduct, right, a)),
            (Some(left), None) if is_difference => Some(fused(ProductSum::ProductMinus, left, b)),
            (Some(left), None) => Some(fused(ProductSum::ProductPlus, left, b)),
            (None, None) => None,
        }
    })
}

/// Compensates the sums and differences of two products whose terms may cancel.
pub(super) fn compensate(program: &Program) -> Program {
    let product = program.products_used_once();
    rewritten(program, |instruction| match *instruction {
        Instruction::Add(p, q) => {
            let ([a, b], [c, d]) = (product(p)?, product(q)?);
            // the terms of a sum of squares do not cancel
            (a != b || c != d).then_some(Instruction::SumOfProducts([a, b, c, d]))
        }
        Instruction::Subtract(p, q) => {
            let ([a, b], [c, d]) = (product(p)?, product(q)?);
            Some(Instruction::DifferenceOfProducts([a, b, c, d]))
        }
        _ => None,
    })
}

/// Replaces some instructions of a program by others of the same value.
fn rewritten(program: &Program, replacement: impl Fn(&Instruction) -> Option<Instruction>) -> Program {
    let instructions = program.instructions.iter();
    let rewritten = instructions.map(|i| replacement(i).unwrap_or_else(|| i.clone())).collect();
    without_unused(&program.with_instructions(rewritten, |value| value))
}

/// Treatment of compensated products when instructions are split.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Compensated {
    Kept,
    Split,
    /// Split, with 0 added in place of the correction.
    Corrected,
}

/// Appends a b ± c d in separate operations.
fn products(
    rebuilt: &mut Rebuilt,
    [a, b, c, d]: [Value; 4],
    is_difference: bool,
    compensated: Compensated,
) -> Value {
    let left = rebuilt.push(Instruction::Multiply(a, b));
    let right = rebuilt.push(Instruction::Multiply(c, d));
    let value = rebuilt.push(sum_or_difference(left, right, is_difference));
    if compensated != Compensated::Corrected {
        return value;
    }
    let correction = rebuilt.integer(0);
    rebuilt.push(Instruction::Add(value, correction))
}

impl Program {
    /// Returns the same kernel with compensated sums and differences of two products that may
    /// cancel, computed without loss.
    pub fn compensate(&self) -> Program {
        schedule(&fuse(&compensate(&take_out_common_factors(&self.unfused()))))
    }

    /// Returns the same kernel with fused and compensated instructions split into additions,
    /// subtractions and multiplications.
    pub(crate) fn unfused(&self) -> Program {
        self.taken_apart(Compensated::Split)
    }

    /// Returns the same kernel with the roundings of a target that may round the product of a fused
    /// instruction: a compensated product is then a plain one, to which a rounded correction is
    /// added.
    pub(crate) fn with_rounded_corrections(&self) -> Program {
        self.taken_apart(Compensated::Corrected)
    }

    /// Returns the same kernel with a separate rounding for each product that is not compensated.
    pub(crate) fn with_separate_roundings(&self) -> Program {
        self.taken_apart(Compensated::Kept)
    }

    fn taken_apart(&self, compensated: Compensated) -> Program {
        self.rebuilt(|rebuilt, instruction| match instruction {
            Instruction::MultiplyAdd(sum, values) => {
                let [a, b, c] = values.map(|value| rebuilt.value(value));
                let product = rebuilt.push(Instruction::Multiply(a, b));
                let [left, right] = sum.terms(product, c);
                Some(rebuilt.push(sum_or_difference(left, right, sum.is_difference())))
            }
            Instruction::DifferenceOfProducts(factors) if compensated != Compensated::Kept => {
                let factors = factors.map(|factor| rebuilt.value(factor));
                Some(products(rebuilt, factors, true, compensated))
            }
            Instruction::SumOfProducts(factors) if compensated != Compensated::Kept => {
                let factors = factors.map(|factor| rebuilt.value(factor));
                Some(products(rebuilt, factors, false, compensated))
            }
            _ => None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::formula::program;
    use crate::kernel::numbering::number_values;

    #[test]
    fn a_product_that_one_sum_uses_is_fused_into_it() {
        let cases: [(&[&str], usize); 6] = [
            (&["a*b + c"], 1),
            (&["c - a*b"], 1),
            (&["a*b - c"], 1),
            (&["a*b + c*d"], 1),
            (&["a*b + c*d + a*c"], 2),
            (&["a*b + c", "a*b"], 0),
        ];
        for (formulas, expected) in cases {
            let written = number_values(&program("a b c d", formulas));
            let fused = fuse(&written);
            assert_eq!(fused.operations().fused, expected, "{formulas:?}");
            assert_eq!(fused.operations().arithmetic(), written.operations().arithmetic(), "{formulas:?}");
        }
    }

    #[test]
    fn what_was_fused_can_be_taken_apart() {
        let written = number_values(&program("a b c d", &["a*b + c*d - (a*c - b)", "c - d*d"]));
        assert_eq!(fuse(&written).operations().fused, 3);
        assert_eq!(fuse(&written).unfused().operations(), written.operations());
        assert_eq!(compensate(&written).unfused().operations(), written.operations());
    }

    #[test]
    fn products_that_cancel_keep_their_digits_and_squares_that_cannot_are_left() {
        let near = 1.0 + f64::EPSILON;
        let difference = number_values(&program("a b c d", &["a*b - c*d"])).compensate();
        assert_eq!(difference.interpret(&[near, near, 1.0, near + f64::EPSILON]), [f64::EPSILON.powi(2)]);
        let squares = program("a c", &["a*a + c*c"]).compensate();
        assert_eq!(squares.operations().fused, 1);
    }
}
