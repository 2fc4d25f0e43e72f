//! What one language says differently from another.

use super::unordered::Unordered;
use super::written::{Written, infix};
use crate::expression::Operation;
use crate::kernel::constant::Constant;
use crate::kernel::program::{ProductSum, Program};
use crate::syntax::ast::Relation;
use num_rational::Ratio;

/// A language that programs are written in.
pub(super) trait Dialect {
    /// How it chooses between two values.
    fn choices(&self) -> Choices<'_>;

    /// A number.
    fn number(&self, constant: &Constant) -> Written;
    /// √a
    fn sqrt(&self, value: &Written) -> Written;
    /// aʳ
    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written;
    /// A function of the op table.
    fn call(&self, operation: Operation, operands: &[&Written]) -> Written;
    /// a b − c d without cancellation of roundings.
    fn difference_of_products(&self, factors: [&Written; 4]) -> Written;
    /// a b + c d, likewise.
    fn sum_of_products(&self, factors: [&Written; 4]) -> Written;
    /// A product and a third number; as two operations where the language has no fused one.
    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let product = infix(a, "*", b);
        let [left, right] = sum.terms(&product, c);
        infix(left, if sum.is_difference() { "-" } else { "+" }, right)
    }

    /// The integral of a program of one output from the first operand to the second; the others are what it depends on
    /// beside its first argument. Only of languages with functions within functions.
    fn quadrature(&self, _integrand: &Program, _operands: &[&Written]) -> Written {
        Written::atom(self.nan())
    }

    /// NaN
    fn nan(&self) -> String;
    /// The statement that names a value.
    fn declaration(&self, name: &str, value: &str) -> String;
    /// The statements that return the outputs.
    fn results(&self, outputs: &[&str]) -> String;
}

/// How a language chooses between two values.
pub(super) enum Choices<'a> {
    /// By a function of both.
    Function(&'a dyn ChoiceFunction),
    /// By computing one of them.
    Branches(&'a dyn Branches),
}

/// Choices that compute both values.
pub(super) trait ChoiceFunction {
    /// A relation, and the values where it holds and where not; and what is to be where the sides cannot be compared.
    fn choice(
        &self,
        sides: [&Written; 2],
        relation: Relation,
        branches: [&Written; 2],
        unordered: Unordered,
    ) -> Written;
}

/// Choices by `if`.
pub(super) trait Branches {
    /// The statement that declares a variable which the branches assign to; nothing where `if` has a value.
    fn variable(&self, name: &str) -> Option<String>;
    /// A relation, or else equality, as a condition that NaN does not meet.
    fn comparison(&self, left: &Written, relation: Option<Relation>, right: &Written) -> String;
    /// What stands between `if` and its block.
    fn condition(&self, comparison: &str) -> String;
    /// The statements that leave the function with NaN for every output unless a comparison holds.
    fn leave_unless(&self, comparison: &str, outputs: usize) -> String;
}
