//! Differences between the target languages.

use super::unordered::Unordered;
use super::written::{Written, infix};
use crate::expression::{Operation, Relation};
use crate::kernel::{Constant, ProductSum, Program};
use num_rational::Ratio;

/// Language that programs are written in.
pub(super) trait Dialect {
    /// Returns the mechanism that selects one of two values.
    fn choices(&self) -> Choices<'_>;

    /// Writes a number.
    fn number(&self, constant: &Constant) -> Written;
    /// √a
    fn sqrt(&self, value: &Written) -> Written;
    /// aʳ
    fn power(&self, value: &Written, exponent: Ratio<i64>) -> Written;
    /// Writes a call of a function of the operation table.
    fn call(&self, operation: Operation, operands: &[&Written]) -> Written;
    /// a b − c d without loss by cancellation of rounded products.
    fn difference_of_products(&self, factors: [&Written; 4]) -> Written;
    /// a b + c d, without such a loss.
    fn sum_of_products(&self, factors: [&Written; 4]) -> Written;
    /// Writes a product plus or minus a third number, as two operations if the language has no
    /// fused one.
    fn multiply_add(&self, sum: ProductSum, [a, b, c]: [&Written; 3]) -> Written {
        let product = infix(a, "*", b);
        let [left, right] = sum.terms(&product, c);
        infix(left, if sum.is_difference() { "-" } else { "+" }, right)
    }

    /// Writes the integral of a program with one output from the first operand to the second; the
    /// remaining operands are the arguments of the program after its first. Only for languages with
    /// functions within functions.
    fn quadrature(&self, _integrand: &Program, _operands: &[&Written]) -> Written {
        Written::atom(self.nan())
    }

    /// NaN
    fn nan(&self) -> String;
    /// Writes the statement that names a value.
    fn declaration(&self, name: &str, value: &str) -> String;
    /// Writes the statements that return the outputs.
    fn results(&self, outputs: &[&str]) -> String;
}

/// Mechanism by which a language selects one of two values.
pub(super) enum Choices<'a> {
    /// A function of both values.
    Function(&'a dyn ChoiceFunction),
    /// Branches, one of which is computed.
    Branches(&'a dyn Branches),
}

/// Conditionals that compute both values.
pub(super) trait ChoiceFunction {
    /// Writes the selection between the value for a relation that holds and the value for one that
    /// fails. `unordered` is the behaviour if the sides cannot be compared.
    fn choice(
        &self,
        sides: [&Written; 2],
        relation: Relation,
        branches: [&Written; 2],
        unordered: Unordered,
    ) -> Written;
}

/// Conditionals by `if`.
pub(super) trait Branches {
    /// Writes the declaration of a variable that the branches assign to; `None` if `if` has a
    /// value.
    fn variable(&self, name: &str) -> Option<String>;
    /// Writes a relation, or equality if there is none, as a condition that is false for NaN.
    fn comparison(&self, left: &Written, relation: Option<Relation>, right: &Written) -> String;
    /// Writes the text between `if` and its block.
    fn condition(&self, comparison: &str) -> String;
    /// Declares a variable that says whether all conditions of the domain hold, in a language that
    /// computes the outputs in any case and then chooses between them and NaN: loops without branches
    /// are vectorised. `None` in others.
    fn inside(&self, _name: &str, _comparisons: &[String], _outputs: usize) -> Option<String> {
        None
    }
    /// Chooses between one of the outputs and NaN by such a variable.
    fn if_inside(&self, _name: &str, value: &Written, _outputs: usize) -> Written {
        value.clone()
    }
    /// Writes the statements that return NaN for every output unless a comparison holds; nothing in a
    /// language that chooses at the end.
    fn leave_unless(&self, _comparison: &str, _outputs: usize) -> String {
        String::new()
    }
}
