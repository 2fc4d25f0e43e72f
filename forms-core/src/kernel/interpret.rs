//! Interpreter: the values of a program in any precision, instruction by instruction.
//!
//! The precision is a type, as in the generated source: both compute the same operations in the
//! same order.

use super::program::{Instruction, Program, Value};
use crate::expression::Relation;
use forms_math::{
    Computation, DoubleDouble, Real, Tier, bounds_in_lanes, escalate_computation,
    escalate_double_double_computation, row_within,
};

/// Program with its numbers rounded to one precision.
#[derive(Clone, Debug)]
pub struct Interpreter<'a, T> {
    program: &'a Program,
    /// For each instruction, its number if it is a constant.
    constants: Vec<Option<T>>,
}

impl Program {
    /// Evaluates the outputs at these arguments; all are NaN outside the kernel's domain. A missing
    /// argument is NaN.
    pub fn interpret(&self, arguments: &[f64]) -> Vec<f64> {
        self.interpret_as(arguments)
    }

    /// Evaluates the outputs in the precision of the arguments.
    ///
    /// ```
    /// # use forms_core::compile::{Options, compile};
    /// let compiled = compile("kernel third(x) = x/3;", &Options::default());
    /// let third = compiled.kernels[0].program();
    /// assert_eq!(third.interpret_as(&[1.0_f32]), [1.0 / 3.0]);
    /// ```
    pub fn interpret_as<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        self.interpreter().values(arguments)
    }

    /// Prepares the program for many evaluations in one precision.
    pub fn interpreter<T: Real>(&self) -> Interpreter<'_, T> {
        let constants = self.instructions.iter().map(|instruction| match instruction {
            Instruction::Constant(constant) => Some(constant.to_real()),
            _ => None,
        });
        Interpreter { program: self, constants: constants.collect() }
    }
}

/// Program that can be evaluated in numbers of any kind.
struct InAnyPrecision<'a>(&'a Program);

impl Computation for InAnyPrecision<'_> {
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        self.0.interpret_as(arguments)
    }
}

impl Program {
    /// Evaluates the outputs within `within` units of 2⁻⁵³ of their exact values, in the precision
    /// that this needs at these arguments; NaN if no precision that is tried suffices.
    pub fn interpret_within(&self, arguments: &[f64], within: f64) -> Vec<f64> {
        self.interpret_with_tier(arguments, within).into_iter().map(|(value, _)| value).collect()
    }

    /// Evaluates the outputs within this error, each with the precision that it was taken from.
    pub fn interpret_with_tier(&self, arguments: &[f64], within: f64) -> Vec<(f64, Tier)> {
        escalate_computation(&InAnyPrecision(self), arguments, self.outputs.len(), within)
    }

    /// Evaluates the outputs within this error in the lanes of a batch, where the bound of their
    /// errors allows it.
    pub fn interpret_row_within(&self, arguments: &[f64], within: f64) -> Vec<f64> {
        row_within(&InAnyPrecision(self), arguments, self.outputs.len(), within)
    }

    /// Returns the bounds of the relative errors that lanes show at these arguments, in units of 2⁻⁵³;
    /// ∞ where they show none.
    pub fn bounds_in_lanes(&self, arguments: &[f64]) -> Vec<f64> {
        bounds_in_lanes(&InAnyPrecision(self), arguments)
    }

    /// Evaluates the outputs in double-double to at least 29 digits, in the precision that this
    /// needs, each with the precision that it was taken from; NaN if no precision that is tried
    /// suffices.
    pub fn interpret_double_double(&self, arguments: &[DoubleDouble]) -> Vec<(DoubleDouble, Tier)> {
        escalate_double_double_computation(&InAnyPrecision(self), arguments, self.outputs.len())
    }

    /// Evaluates one instruction in `f64`, given the values of all others.
    pub(crate) fn step(&self, place: usize, arguments: &[f64], values: &[f64]) -> f64 {
        match &self.instructions[place] {
            Instruction::Constant(constant) => constant.to_f64(),
            instruction => value_of(instruction, arguments, |value: Value| values[value.place()]),
        }
    }
}

impl<T: Real> Interpreter<'_, T> {
    /// Evaluates the outputs at these arguments; all are NaN outside the kernel's domain. A missing
    /// argument is NaN.
    pub fn values(&self, arguments: &[T]) -> Vec<T> {
        let values = self.steps(arguments);
        let of = |value: Value| values[value.place()];
        let inside = |output: T| {
            self.program.domain.iter().rev().fold(output, |value, condition| {
                let sides = [of(condition.left), of(condition.right)];
                choice(sides, condition.relation, [value, T::nan()])
            })
        };
        self.program.outputs.iter().map(|&output| inside(of(output))).collect()
    }

    /// Evaluates every instruction at these arguments, inside or outside the kernel's domain.
    pub(crate) fn steps(&self, arguments: &[T]) -> Vec<T> {
        let mut values: Vec<T> = Vec::with_capacity(self.program.instructions.len());
        for (instruction, constant) in self.program.instructions.iter().zip(&self.constants) {
            let of = |value: Value| values[value.place()];
            let value = constant.unwrap_or_else(|| value_of(instruction, arguments, of));
            values.push(value);
        }
        values
    }
}

fn value_of<T: Real>(instruction: &Instruction, arguments: &[T], of: impl Fn(Value) -> T) -> T {
    match instruction {
        Instruction::Constant(constant) => constant.to_real(),
        Instruction::Argument(place) => arguments.get(*place as usize).copied().unwrap_or_else(T::nan),
        Instruction::Add(a, b) => of(*a) + of(*b),
        Instruction::Subtract(a, b) => of(*a) - of(*b),
        Instruction::Multiply(a, b) => of(*a) * of(*b),
        Instruction::Divide(a, b) => of(*a) / of(*b),
        Instruction::MultiplyAdd(sum, values) => {
            let [a, b, c] = values.map(of);
            let [a, c] = sum.signed(a, c, |value| -value);
            a.mul_add(b, c)
        }
        Instruction::DifferenceOfProducts(factors) => {
            let [a, b, c, d] = factors.map(of);
            T::difference_of_products(a, b, c, d)
        }
        Instruction::SumOfProducts(factors) => {
            let [a, b, c, d] = factors.map(of);
            T::sum_of_products(a, b, c, d)
        }
        Instruction::Negate(a) => -of(*a),
        Instruction::Sqrt(a) => of(*a).sqrt(),
        Instruction::Power(a, exponent) => of(*a).power(*exponent.numer(), *exponent.denom()),
        Instruction::Call(operation, operands) => {
            let operands: Vec<T> = operands.iter().map(|&operand| of(operand)).collect();
            operation.apply(&operands)
        }
        Instruction::Quadrature { integrand, operands } => {
            let [from, to, captured @ ..] = &operands[..] else { return T::nan() };
            let captured: Vec<T> = captured.iter().map(|&operand| of(operand)).collect();
            let interpreter = integrand.interpreter::<T>();
            T::quadrature(of(*from), of(*to), |t| {
                let arguments: Vec<T> = std::iter::once(t).chain(captured.iter().copied()).collect();
                interpreter.values(&arguments)[0]
            })
        }
        Instruction::Select { left, relation, right, then, otherwise } => {
            choice([of(*left), of(*right)], *relation, [of(*then), of(*otherwise)])
        }
    }
}

/// Selects the first branch if the relation holds, the second if it fails, and NaN if the sides
/// cannot be compared.
fn choice<T: Real>([left, right]: [T; 2], relation: Relation, [then, otherwise]: [T; 2]) -> T {
    match relation {
        Relation::Less => T::if_less(left, right, then, otherwise),
        Relation::Greater => T::if_less(right, left, then, otherwise),
        Relation::LessEqual => T::if_less_equal(left, right, then, otherwise),
        Relation::GreaterEqual => T::if_less_equal(right, left, then, otherwise),
        Relation::NotEqual => T::if_equal(left, right, otherwise, then),
    }
}
