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
    /// Relative errors of the functions that have another one.
    functions: &'static [(Operation, f64)],
    /// Relative error of a b − c d computed without cancellation.
    products: f64,
    /// Absolute error of a value near the smallest positive numbers.
    underflow: f64,
    /// Absolute error of a sum there: sums are exact unless subnormal numbers are flushed to zero.
    underflow_of_sum: f64,
    /// Whether a b + c is rounded once wherever the target has an instruction for it. Otherwise the
    /// correction of a compensated product can be 0, and adding it is one more rounding.
    pub(super) is_fused: bool,
    /// Largest finite number.
    pub(super) largest: f64,
}

/// Functions that WGSL lacks, with the relative errors of the functions that emission defines for
/// them: each of their operations has the largest error that WGSL allows.
const SHADER_FUNCTIONS: [(Operation, f64); 4] = [
    (Operation::Expm1, 14.0 * SINGLE),
    (Operation::Log1p, 32.0 * SINGLE),
    (Operation::Erf, 10.0 * SINGLE),
    (Operation::Hypot, 24.0 * SINGLE),
];

/// The function of `f64` that libraries compute less accurately than the others: within 5 ulp, as
/// stated for CUDA.
const DOUBLE_FUNCTIONS: [(Operation, f64); 1] = [(Operation::Erfc, 10.0 * DOUBLE)];

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
        functions: &DOUBLE_FUNCTIONS,
        products: 4.0 * DOUBLE,
        // half the smallest positive number, rounded up
        underflow: f64::from_bits(1),
        underflow_of_sum: 0.0,
        is_fused: true,
        largest: f64::MAX,
    };

    /// IEEE 754 `f32`, with library functions accurate to 4 ulp, as stated for CUDA.
    pub const SINGLE: Arithmetic = Arithmetic {
        unit: SINGLE,
        operation: SINGLE,
        quotient: SINGLE,
        root: SINGLE,
        function: 8.0 * SINGLE,
        functions: &[],
        products: 4.0 * SINGLE,
        underflow: f32::from_bits(1) as f64,
        underflow_of_sum: 0.0,
        is_fused: true,
        largest: f32::MAX as f64,
    };

    /// `f32` of WGSL: sums and products can be rounded in either direction, quotients are accurate
    /// to 2.5 ulp, roots to 5 ulp; subnormal numbers can be flushed to zero; `fma` can round its
    /// product. The errors of its own functions are stated as absolute errors.
    ///
    /// Source: WebGPU Shading Language, §15.7.4 Floating Point Accuracy.
    pub const SHADER: Arithmetic = Arithmetic {
        operation: 2.0 * SINGLE,
        quotient: 5.0 * SINGLE,
        root: 10.0 * SINGLE,
        function: f64::INFINITY,
        functions: &SHADER_FUNCTIONS,
        is_fused: false,
        products: 8.0 * SINGLE,
        underflow: f32::MIN_POSITIVE as f64,
        underflow_of_sum: f32::MIN_POSITIVE as f64,
        ..Arithmetic::SINGLE
    };

    /// Returns the name of the number format.
    pub(crate) fn format(&self) -> &'static str {
        if self.unit == SINGLE { "f32" } else { "f64" }
    }

    /// Returns the unit roundoff as text.
    pub(crate) fn unit_name(&self) -> &'static str {
        if self.unit == SINGLE { "2⁻²⁴" } else { "2⁻⁵³" }
    }

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
            Instruction::Power(..) => (self.function, self.underflow),
            Instruction::Call(operation, _) => (self.function_error(*operation), self.underflow),
            // the truncation error of the quadrature rule is estimated at run time, not bounded
            // here
            Instruction::Quadrature { .. } => (f64::INFINITY, f64::INFINITY),
        }
    }

    /// Returns the relative error bound of a function; infinite where the target states none.
    pub fn function_error(&self, operation: Operation) -> f64 {
        let own = self.functions.iter().find(|(function, _)| *function == operation);
        own.map_or(self.function, |&(_, error)| error)
    }

    /// Whether the constant is exactly representable in this arithmetic.
    pub(super) fn holds(&self, constant: &Constant) -> bool {
        let number = if self.largest == f64::MAX { constant.to_f64() } else { constant.to_f32().into() };
        constant.pi_exponent == 0
            && num_rational::BigRational::from_float(number).is_some_and(|exact| exact == constant.factor)
    }
}
