//! Conditionals whose sides cannot be compared because one is NaN: which of them can rely on their
//! branches or on the outputs to make the kernel NaN there.
//!
//! ```text
//! c = if l < r { a } else { b },  l is NaN ─▶ c has to be NaN:  b is NaN too     ─▶ one comparison, b where it fails
//!                                                               the outputs are  ─▶ one comparison, c is arbitrary
//!                                                               else             ─▶ two comparisons
//! ```
//! Arithmetic, roots and functions of a NaN are NaN. A NaN therefore propagates from operands to
//! results, except from the branches of a conditional, which may not be taken, and from the sides
//! of a conditional that does not test for NaN. Conditionals are settled one after another, and an
//! unsettled one counts as one that does not test: so no two rely on each other.

use crate::kernel::{Instruction, Program, Value};
use num_traits::Zero;

/// Value of a conditional whose sides cannot be compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unordered {
    /// NaN.
    Nan,
    /// The value for a relation that holds, which is NaN there.
    Then,
    /// The value for a relation that fails, which is NaN there.
    Otherwise,
    /// Either value, since every output is NaN there.
    Either,
}

/// Returns the behaviour of each instruction that is a conditional, and `Nan` for all others.
pub(super) fn unordered(program: &Program) -> Vec<Unordered> {
    let mut choices = Choices { program, settled: vec![None; program.instructions.len()] };
    let mut open = choices.settle_by_branches();
    while !open.is_empty() {
        open = choices.settle_by_outputs(open);
    }
    choices.settled.into_iter().map(|settled| settled.unwrap_or(Unordered::Nan)).collect()
}

struct Choices<'a> {
    program: &'a Program,
    /// Behaviour of the conditionals settled so far.
    settled: Vec<Option<Unordered>>,
}

impl Choices<'_> {
    /// Settles the conditionals that have a branch with both sides in it, and returns the indices
    /// of the others.
    fn settle_by_branches(&mut self) -> Vec<usize> {
        let mut open = Vec::new();
        for (place, instruction) in self.program.instructions.iter().enumerate() {
            let Instruction::Select { left, right, then, otherwise, .. } = instruction else { continue };
            let branches = [(*otherwise, Unordered::Otherwise), (*then, Unordered::Then)];
            let found = branches.into_iter().find(|(branch, _)| {
                let spreads = self.spreading_to(&[*branch]);
                spreads[left.place()] && spreads[right.place()]
            });
            match found {
                Some((_, unordered)) => self.settled[place] = Some(unordered),
                None => open.push(place),
            }
        }
        open
    }

    /// Settles the conditionals whose sides propagate NaN to every output anyway, and one that has
    /// to test; returns the others.
    fn settle_by_outputs(&mut self, mut open: Vec<usize>) -> Vec<usize> {
        let spreads = self.spreading_to_outputs();
        open.retain(|&place| {
            let Instruction::Select { left, right, .. } = self.program.instructions[place] else {
                return false;
            };
            let is_free = spreads[left.place()] && spreads[right.place()];
            if is_free {
                self.settled[place] = Some(Unordered::Either);
            }
            !is_free
        });
        // prefer one that propagates its NaN to the outputs: the others need not test the same
        // sides
        let looking = open.iter().position(|&place| spreads[place]).unwrap_or(0);
        if !open.is_empty() {
            self.settled[open.remove(looking)] = Some(Unordered::Nan);
        }
        open
    }

    /// Returns which values make every output NaN if they are NaN; numbers, which never are, count
    /// too.
    fn spreading_to_outputs(&self) -> Vec<bool> {
        let sides = self.program.domain.iter().flat_map(|condition| [condition.left, condition.right]);
        let sides: Vec<Value> = sides.collect();
        let mut every = vec![true; self.program.instructions.len()];
        for &output in &self.program.outputs {
            let roots: Vec<Value> = sides.iter().copied().chain([output]).collect();
            let spreads = self.spreading_to(&roots);
            every.iter_mut().zip(spreads).for_each(|(every, spreads)| *every &= spreads);
        }
        every
    }

    /// Returns which values make one of these roots NaN if they are NaN; numbers count too.
    fn spreading_to(&self, roots: &[Value]) -> Vec<bool> {
        let mut spreads = vec![false; self.program.instructions.len()];
        roots.iter().for_each(|root| spreads[root.place()] = true);
        for (place, instruction) in self.program.instructions.iter().enumerate().rev() {
            if spreads[place] {
                self.spreading_through(place).iter().for_each(|operand| spreads[operand.place()] = true);
            }
            spreads[place] |= matches!(instruction, Instruction::Constant(_));
        }
        spreads
    }

    /// Returns the operands that make this instruction's value NaN if they are NaN.
    fn spreading_through(&self, place: usize) -> Vec<Value> {
        match &self.program.instructions[place] {
            Instruction::Quadrature { .. } => vec![],
            Instruction::Power(_, exponent) if exponent.is_zero() => vec![],
            Instruction::Select { left, right, .. } => match self.settled[place] {
                None | Some(Unordered::Either) => vec![],
                Some(_) => vec![*left, *right],
            },
            other => other.operands(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Unordered::{Either, Nan, Otherwise, Then};
    use super::*;
    use crate::kernel::formula::program;
    use crate::kernel::numbering::number_values;

    /// Returns the behaviour of the conditionals of kernels of x, y and z, in the order of their
    /// computation.
    fn choices(formulas: &[&str]) -> Vec<Unordered> {
        let program = number_values(&program("x y z", formulas));
        let is_choice = |place: &usize| matches!(program.instructions[*place], Instruction::Select { .. });
        let choices = unordered(&program);
        (0..choices.len()).filter(is_choice).map(|place| choices[place]).collect()
    }

    #[test]
    fn a_branch_with_both_sides_in_it_is_nan_where_they_cannot_be_compared() {
        assert_eq!(choices(&["if x < 1 { y } else { x*z }"]), [Otherwise]);
        assert_eq!(choices(&["if x < 1 { sin(x) } else { y }"]), [Then]);
        assert_eq!(choices(&["if x < y { x - y } else { x }"]), [Then]);
        assert_eq!(choices(&["if x < y { x } else { y }"]), [Nan]);
    }

    #[test]
    fn what_every_output_has_in_it_needs_no_second_comparison() {
        assert_eq!(choices(&["x + (if x < 1 { y } else { z })"]), [Either]);
        assert_eq!(choices(&["x + (if x < y { 1 } else { z })"]), [Nan]);
        assert_eq!(choices(&["x + (if x < 1 { y } else { z })", "x"]), [Either]);
        assert_eq!(choices(&["x + (if x < 1 { y } else { z })", "y"]), [Nan]);
    }

    #[test]
    fn of_choices_by_the_same_sides_one_looks() {
        assert_eq!(choices(&["(if x < 1 { y } else { z }) + (if x < 2 { z } else { y })"]), [Nan, Either]);
        // the inner conditional may not be taken, so the outer one tests for itself
        assert_eq!(
            choices(&["if y < 1 { if x < 1 { y } else { z } } else { if x < 1 { z } else { 1 } }"]),
            [Nan; 3]
        );
    }

    #[test]
    fn a_choice_that_looks_spares_those_within_it() {
        let inner = "if x < 1 { y } else { z }";
        assert_eq!(choices(&[&format!("if x < 2 {{ 1 }} else {{ {inner} }}")]), [Either, Nan]);
        assert_eq!(choices(&[&format!("if x < 2 {{ 1 }} else {{ x*({inner}) }}")]), [Either, Otherwise]);
        assert_eq!(choices(&[&format!("if y < 2 {{ 1 }} else {{ {inner} }}")]), [Nan, Nan]);
    }
}
