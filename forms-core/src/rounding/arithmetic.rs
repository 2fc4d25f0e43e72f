//! Rounding models of the floating-point arithmetics that kernels run on.

use crate::expression::Operation;
use crate::kernel::{Constant, Instruction, Program, Value};

/// Rounding model of a target: relative error bounds of its operations, and absolute error bounds
/// near underflow.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arithmetic {
    /// Unit roundoff, which bounds half an ulp relative to a normal number; the unit in which
    /// `within` bounds are stated.
    pub unit: f64,
    /// Relative error of sums, products and constants.
    operation: f64,
    quotient: f64,
    root: f64,
    /// Relative error of functions and powers; infinite where the target states no usable bound.
    function: f64,
    /// Relative error of a b − c d computed without cancellation.
    products: f64,
    /// Absolute error of a value near the smallest positive numbers.
    underflow: f64,
    /// Absolute error of a sum there: sums are exact unless subnormal numbers are flushed to zero.
    underflow_of_sum: f64,
    /// Largest finite number.
    pub(super) largest: f64,
}

const DOUBLE: f64 = f64::EPSILON / 2.0;
const SINGLE: f64 = f32::EPSILON as f64 / 2.0;

impl Arithmetic {
    /// IEEE 754 `f64`, with library functions accurate to 2 ulp.
    pub const DOUBLE: Arithmetic = Arithmetic {
        unit: DOUBLE,
        operation: DOUBLE,
        quotient: DOUBLE,
        root: DOUBLE,
        function: 4.0 * DOUBLE,
        products: 4.0 * DOUBLE,
        // half the smallest positive number, rounded up
        underflow: f64::from_bits(1),
        underflow_of_sum: 0.0,
        largest: f64::MAX,
    };

    /// IEEE 754 `f32`, with library functions accurate to 4 ulp, as stated for CUDA.
    pub const SINGLE: Arithmetic = Arithmetic {
        unit: SINGLE,
        operation: SINGLE,
        quotient: SINGLE,
        root: SINGLE,
        function: 8.0 * SINGLE,
        products: 4.0 * SINGLE,
        underflow: f32::from_bits(1) as f64,
        underflow_of_sum: 0.0,
        largest: f32::MAX as f64,
    };

    /// `f32` of WGSL: sums and products can be rounded in either direction, quotients are accurate
    /// to 2.5 ulp, roots to 5 ulp; subnormal numbers can be flushed to zero. The errors of its
    /// functions are stated as absolute errors.
    ///
    /// Source: WebGPU Shading Language, §15.7.4 Floating Point Accuracy.
    pub const SHADER: Arithmetic = Arithmetic {
        operation: 2.0 * SINGLE,
        quotient: 5.0 * SINGLE,
        root: 10.0 * SINGLE,
        function: f64::INFINITY,
        products: 8.0 * SINGLE,
        underflow: f32::MIN_POSITIVE as f64,
        underflow_of_sum: f32::MIN_POSITIVE as f64,
        ..Arithmetic::SINGLE
    };

    /// Returns the relative and the absolute perturbation that rounding adds to the value of an
    /// instruction.
    pub(super) fn rounding(&self, program: &Program, place: usize) -> (f64, f64) {
        let is_power_of_two = |value: Value| match &program.instructions()[value.place()] {
            Instruction::Constant(constant) => {
                let number = constant.to_f64();
                constant.pi_exponent == 0 && self.holds(constant) && number.to_bits() << 12 == 0
            }
            _ => false,
        };
        match &program.instructions()[place] {
            Instruction::Constant(constant) if self.holds(constant) => (0.0, 0.0),
            Instruction::Argument(_) => (0.0, self.underflow_of_sum),
            Instruction::Negate(_) | Instruction::Select { .. } => (0.0, 0.0),
            Instruction::Call(Operation::Abs, _) => (0.0, 0.0),
            Instruction::Add(..) | Instruction::Subtract(..) => (self.operation, self.underflow_of_sum),
            Instruction::Sqrt(_) => (self.root, self.underflow_of_sum),
            Instruction::Multiply(a, b) if is_power_of_two(*a) || is_power_of_two(*b) => {
                (0.0, self.underflow)
            }
            Instruction::Divide(_, b) if is_power_of_two(*b) && self.quotient == self.operation => {
                (0.0, self.underflow)
            }
            Instruction::Constant(_) | Instruction::Multiply(..) => (self.operation, self.underflow),
            Instruction::Divide(..) => (self.quotient, self.underflow),
            Instruction::MultiplyAdd(..) => unreachable!("roundings were separated"),
            Instruction::DifferenceOfProducts(_) | Instruction::SumOfProducts(_) => {
                (self.products, self.underflow)
            }
            Instruction::Power(..) | Instruction::Call(..) => (self.function, self.underflow),
            // the truncation error of the quadrature rule is estimated at run time, not bounded
            // here
            Instruction::Quadrature { .. } => (f64::INFINITY, f64::INFINITY),
        }
    }

    /// Whether the constant is exactly representable in this arithmetic.
    pub(super) fn holds(&self, constant: &Constant) -> bool {
        let number = if self.largest == f64::MAX { constant.to_f64() } else { constant.to_f32().into() };
        constant.pi_exponent == 0
            && num_rational::BigRational::from_float(number).is_some_and(|exact| exact == constant.factor)
    }
}
