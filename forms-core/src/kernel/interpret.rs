//! The interpreter: the values of a program in `f64`, instruction by instruction.

use super::program::{Instruction, Program, Value, holds};
use crate::expression::Operation;
use num_rational::Ratio;

impl Program {
    /// The outputs at these arguments; all NaN outside the kernel's domain. An argument left out is NaN.
    pub fn interpret(&self, arguments: &[f64]) -> Vec<f64> {
        let mut values: Vec<f64> = Vec::with_capacity(self.instructions.len());
        for instruction in &self.instructions {
            let value = value_of(instruction, arguments, |value: Value| values[value.place()]);
            values.push(value);
        }
        let of = |value: Value| values[value.place()];
        let inside = self.domain.iter().all(|condition| {
            holds(condition.relation, of(condition.left), of(condition.right)) == Some(true)
        });
        self.outputs.iter().map(|&output| if inside { of(output) } else { f64::NAN }).collect()
    }
}

fn value_of(instruction: &Instruction, arguments: &[f64], of: impl Fn(Value) -> f64) -> f64 {
    match instruction {
        Instruction::Constant(constant) => constant.to_f64(),
        Instruction::Argument(place) => arguments.get(*place as usize).copied().unwrap_or(f64::NAN),
        Instruction::Add(a, b) => of(*a) + of(*b),
        Instruction::Subtract(a, b) => of(*a) - of(*b),
        Instruction::Multiply(a, b) => of(*a) * of(*b),
        Instruction::Divide(a, b) => of(*a) / of(*b),
        Instruction::MultiplyAdd(sum, [a, b, c]) => {
            let [left, right] = sum.terms(of(*a) * of(*b), of(*c));
            if sum.is_difference() { left - right } else { left + right }
        }
        Instruction::DifferenceOfProducts([a, b, c, d]) => {
            difference_of_products(of(*a), of(*b), of(*c), of(*d))
        }
        Instruction::SumOfProducts([a, b, c, d]) => difference_of_products(of(*a), of(*b), -of(*c), of(*d)),
        Instruction::Negate(a) => -of(*a),
        Instruction::Sqrt(a) => of(*a).sqrt(),
        Instruction::Power(a, exponent) => power(of(*a), *exponent),
        Instruction::Call(operation, operands) => call(*operation, operands, of),
        Instruction::Select { left, relation, right, then, otherwise } => {
            match holds(*relation, of(*left), of(*right)) {
                Some(true) => of(*then),
                Some(false) => of(*otherwise),
                None => f64::NAN,
            }
        }
    }
}

/// a b − c d by the error of one product, after Kahan.
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    let error = (-c).mul_add(d, product);
    a.mul_add(b, -product) + error
}

fn call(operation: Operation, operands: &[Value], of: impl Fn(Value) -> f64) -> f64 {
    let operands: Vec<f64> = operands.iter().map(|&operand| of(operand)).collect();
    operation.apply(&operands)
}

/// xʳ: a fraction of a negative number has no real value.
pub(crate) fn power(x: f64, exponent: Ratio<i64>) -> f64 {
    x.powf(*exponent.numer() as f64 / *exponent.denom() as f64)
}
