//! Intermediate representation of a kernel: instructions in the order of their evaluation.
//!
//! Every instruction computes one value from earlier values, and no value ever changes (static
//! single assignment). The representation is independent of precision and target: numbers are
//! exact, functions are rows of the operation table.

use super::constant::Constant;
use crate::expression::{Operation, Relation, Signature};
use num_rational::Ratio;

/// Value of an instruction, identified by the instruction's index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub(crate) u32);

impl Value {
    pub(crate) fn place(self) -> usize {
        self.0 as usize
    }
}

/// Sum or difference of a product a b and a number c, with its terms in the order in which they
/// were written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ProductSum {
    /// a b + c
    ProductPlus,
    /// c + a b
    PlusProduct,
    /// a b − c
    ProductMinus,
    /// c − a b
    MinusProduct,
}

impl ProductSum {
    /// Returns the left and the right term.
    pub(crate) fn terms<T>(self, product: T, other: T) -> [T; 2] {
        match self {
            ProductSum::ProductPlus | ProductSum::ProductMinus => [product, other],
            ProductSum::PlusProduct | ProductSum::MinusProduct => [other, product],
        }
    }

    /// Returns the factor a and the number c with the signs for which the sum is a b + c.
    pub(crate) fn signed<T>(self, factor: T, other: T, negate: impl FnOnce(T) -> T) -> [T; 2] {
        match self {
            ProductSum::ProductPlus | ProductSum::PlusProduct => [factor, other],
            ProductSum::ProductMinus => [factor, negate(other)],
            ProductSum::MinusProduct => [negate(factor), other],
        }
    }

    /// Whether the right term is subtracted from the left one.
    pub(crate) fn is_difference(self) -> bool {
        matches!(self, ProductSum::ProductMinus | ProductSum::MinusProduct)
    }
}

/// One operation on earlier values.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Instruction {
    /// An exact number.
    Constant(Constant),
    /// An argument of the kernel, by its index.
    Argument(u32),
    /// a + b
    Add(Value, Value),
    /// a − b
    Subtract(Value, Value),
    /// a b
    Multiply(Value, Value),
    /// a / b
    Divide(Value, Value),
    /// The product of the first two values plus or minus the third one, with one rounding if the
    /// target can do that.
    MultiplyAdd(ProductSum, [Value; 3]),
    /// a b − c d, compensated: within a few ulp of the exact value even if the products cancel.
    DifferenceOfProducts([Value; 4]),
    /// a b + c d, compensated in the same way.
    SumOfProducts([Value; 4]),
    /// −a
    Negate(Value),
    /// √a
    Sqrt(Value),
    /// aʳ with r rational; the non-negative branch if r is a fraction
    Power(Value, Ratio<i64>),
    /// A function of the operation table.
    Call(Operation, Box<[Value]>),
    /// ∫ₐᵇ w dt, computed numerically.
    Quadrature {
        /// The integrand, as a kernel of t and of the other values.
        integrand: Box<Program>,
        /// a, b, and the values other than t that the integrand depends on.
        operands: Box<[Value]>,
    },
    /// `then` if the relation holds, `otherwise` if it fails, NaN if the sides cannot be compared.
    Select {
        /// The relation's left side.
        left: Value,
        /// The relation.
        relation: Relation,
        /// The relation's right side.
        right: Value,
        /// The value if the relation holds.
        then: Value,
        /// The value if the relation fails.
        otherwise: Value,
    },
}

impl Instruction {
    /// Returns the values that the instruction is computed from.
    pub fn operands(&self) -> Vec<Value> {
        match self {
            Instruction::Constant(_) | Instruction::Argument(_) => vec![],
            Instruction::Negate(a) | Instruction::Sqrt(a) | Instruction::Power(a, _) => vec![*a],
            Instruction::Add(a, b)
            | Instruction::Subtract(a, b)
            | Instruction::Multiply(a, b)
            | Instruction::Divide(a, b) => vec![*a, *b],
            Instruction::MultiplyAdd(_, values) => values.to_vec(),
            Instruction::DifferenceOfProducts(factors) | Instruction::SumOfProducts(factors) => {
                factors.to_vec()
            }
            Instruction::Call(_, operands) | Instruction::Quadrature { operands, .. } => operands.to_vec(),
            Instruction::Select { left, right, then, otherwise, .. } => {
                vec![*left, *right, *then, *otherwise]
            }
        }
    }

    /// Returns the same operation on other values.
    pub(crate) fn with_operands(&self, of: impl Fn(Value) -> Value) -> Instruction {
        match self {
            Instruction::Constant(_) | Instruction::Argument(_) => self.clone(),
            Instruction::Add(a, b) => Instruction::Add(of(*a), of(*b)),
            Instruction::Subtract(a, b) => Instruction::Subtract(of(*a), of(*b)),
            Instruction::Multiply(a, b) => Instruction::Multiply(of(*a), of(*b)),
            Instruction::Divide(a, b) => Instruction::Divide(of(*a), of(*b)),
            Instruction::MultiplyAdd(sum, values) => Instruction::MultiplyAdd(*sum, values.map(of)),
            Instruction::DifferenceOfProducts(factors) => Instruction::DifferenceOfProducts(factors.map(of)),
            Instruction::SumOfProducts(factors) => Instruction::SumOfProducts(factors.map(of)),
            Instruction::Negate(a) => Instruction::Negate(of(*a)),
            Instruction::Sqrt(a) => Instruction::Sqrt(of(*a)),
            Instruction::Power(a, exponent) => Instruction::Power(of(*a), *exponent),
            Instruction::Call(operation, arguments) => {
                Instruction::Call(*operation, arguments.iter().map(|&a| of(a)).collect())
            }
            Instruction::Quadrature { integrand, operands } => Instruction::Quadrature {
                integrand: integrand.clone(),
                operands: operands.iter().map(|&a| of(a)).collect(),
            },
            Instruction::Select { left, relation, right, then, otherwise } => Instruction::Select {
                left: of(*left),
                relation: *relation,
                right: of(*right),
                then: of(*then),
                otherwise: of(*otherwise),
            },
        }
    }
}

/// A relation between two values.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Comparison {
    /// The left side.
    pub left: Value,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub right: Value,
}

/// Whether a relation holds between two numbers; `None` if a number is NaN.
pub(super) fn holds(relation: Relation, left: f64, right: f64) -> Option<bool> {
    left.partial_cmp(&right).map(|order| relation.admits(order))
}

/// Kernel as instructions.
///
/// Its value is NaN wherever a condition of its domain fails, and wherever an argument it depends
/// on is NaN.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Program {
    pub(crate) name: String,
    pub(crate) public: bool,
    pub(crate) signature: Signature,
    pub(crate) arguments: Vec<String>,
    pub(crate) instructions: Vec<Instruction>,
    pub(crate) outputs: Vec<Value>,
    pub(crate) domain: Vec<Comparison>,
}

impl Program {
    /// Returns the kernel's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether the kernel is visible outside its module.
    pub fn is_public(&self) -> bool {
        self.public
    }

    /// Returns the arguments and results as declared. The instructions know only the numbers in
    /// them.
    pub fn signature(&self) -> &Signature {
        &self.signature
    }

    /// Returns the names of the arguments, arrays by their entries.
    pub fn arguments(&self) -> &[String] {
        &self.arguments
    }

    /// Returns the instructions, operands before results.
    pub fn instructions(&self) -> &[Instruction] {
        &self.instructions
    }

    /// Returns the output values.
    pub fn outputs(&self) -> &[Value] {
        &self.outputs
    }

    /// Returns the conditions of the domain, outside which the kernel is NaN.
    pub fn domain(&self) -> &[Comparison] {
        &self.domain
    }

    pub(crate) fn instruction(&self, value: Value) -> &Instruction {
        &self.instructions[value.place()]
    }

    /// Whether `f64` can represent each number of the program, possibly rounded.
    pub(crate) fn is_representable(&self) -> bool {
        self.instructions.iter().all(|instruction| match instruction {
            Instruction::Constant(constant) => constant.is_representable(),
            _ => true,
        })
    }

    /// Returns the same kernel with the integrands of its quadratures replaced.
    pub(super) fn with_integrands(&self, of: impl Fn(&Program) -> Program) -> Program {
        let instructions = self.instructions.iter().map(|instruction| match instruction {
            Instruction::Quadrature { integrand, operands } => {
                Instruction::Quadrature { integrand: Box::new(of(integrand)), operands: operands.clone() }
            }
            other => other.clone(),
        });
        self.with_instructions(instructions.collect(), |root| root)
    }

    /// Counts the uses of each value, by instructions and as a root.
    pub(crate) fn uses(&self) -> Vec<usize> {
        let mut uses = vec![0; self.instructions.len()];
        for value in self.instructions.iter().flat_map(Instruction::operands).chain(self.roots()) {
            uses[value.place()] += 1;
        }
        uses
    }

    /// Returns the requested values: the sides of the domain's conditions, then the outputs.
    pub(crate) fn roots(&self) -> impl Iterator<Item = Value> {
        self.domain
            .iter()
            .flat_map(|condition| [condition.left, condition.right])
            .chain(self.outputs.iter().copied())
    }

    /// Returns the same kernel computed by other instructions; `of` maps each root to its value
    /// among them.
    pub(crate) fn with_instructions(
        &self,
        instructions: Vec<Instruction>,
        of: impl Fn(Value) -> Value,
    ) -> Program {
        let roots: Vec<Value> = self.roots().map(of).collect();
        self.with_roots(instructions, &roots)
    }

    /// Returns the same kernel computed by other instructions, with these roots in the order of
    /// [`Program::roots`].
    pub(crate) fn with_roots(&self, instructions: Vec<Instruction>, roots: &[Value]) -> Program {
        let (sides, outputs) = roots.split_at(2 * self.domain.len());
        let conditions = self.domain.iter().zip(sides.chunks_exact(2));
        Program {
            name: self.name.clone(),
            public: self.public,
            signature: self.signature.clone(),
            arguments: self.arguments.clone(),
            instructions,
            outputs: outputs.to_vec(),
            domain: conditions
                .map(|(condition, side)| Comparison {
                    left: side[0],
                    relation: condition.relation,
                    right: side[1],
                })
                .collect(),
        }
    }
}
