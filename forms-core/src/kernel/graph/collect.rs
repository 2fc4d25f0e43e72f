//! Collecting: the binary operations of a program become sums and products of any number of terms.
//!
//! A sum within a sum is flattened if it has no other user or is short; otherwise it stays one
//! term.

use super::{Coefficient, Exponent, Form, Graph, Scaled};
use crate::kernel::constant::Constant;
use crate::kernel::program::{Instruction, Program, Value};
use num_rational::Ratio;

/// Largest length of a sum or product with several users that is flattened: its use is found again
/// as a common part.
const SHARED_LENGTH: usize = 8;
/// Largest length of a sum or product.
const LONGEST: usize = 48;

/// Collects a program into sums and products.
pub(in crate::kernel) fn collect(program: &Program) -> Graph {
    let program = &program.unfused();
    let mut collector = Collector { graph: Graph::default(), values: Vec::new(), uses: program.uses() };
    for instruction in &program.instructions {
        let value = collector.instruction(instruction);
        collector.values.push(value);
    }
    collector.graph.roots = program.roots().map(|root| collector.values[root.place()]).collect();
    collector.graph
}

struct Collector {
    graph: Graph,
    values: Vec<Scaled>,
    uses: Vec<usize>,
}

impl Collector {
    fn instruction(&mut self, instruction: &Instruction) -> Scaled {
        let of = |value: &Value| self.values[value.place()];
        match instruction {
            Instruction::Constant(constant) => self.constant(constant),
            Instruction::Argument(place) => self.graph.plain(Form::Argument(*place)),
            Instruction::Add(a, b) => self.sum(*a, *b, Coefficient::ONE),
            Instruction::Subtract(a, b) => self.sum(*a, *b, Coefficient::MINUS_ONE),
            Instruction::Negate(a) => self.graph.scale(Coefficient::MINUS_ONE, of(a)),
            Instruction::Multiply(a, b) => self.product(*a, *b, Exponent::ONE),
            Instruction::Divide(a, b) if of(b).coefficient.is_zero() => {
                let (zero, numerator) = (of(b), of(a));
                let pole = self.graph.plain(Form::Power(zero, (-1).into()));
                self.graph.product(&[(numerator, Exponent::ONE), (pole, Exponent::ONE)])
            }
            Instruction::Divide(a, b) => self.product(*a, *b, Exponent::MINUS_ONE),
            Instruction::MultiplyAdd(..)
            | Instruction::DifferenceOfProducts(_)
            | Instruction::SumOfProducts(_) => unreachable!("products and sums are collected apart"),
            Instruction::Sqrt(a) => self.graph.power(of(a), Ratio::new(1, 2)),
            Instruction::Power(a, exponent) => self.graph.power(of(a), *exponent),
            Instruction::Call(operation, operands) => {
                let operands = operands.iter().map(of).collect();
                self.graph.plain(Form::Call(*operation, operands))
            }
            Instruction::Quadrature { integrand, operands } => {
                let operands = operands.iter().map(of).collect();
                self.graph.plain(Form::Quadrature(integrand.clone(), operands))
            }
            Instruction::Select { left, relation, right, then, otherwise } => {
                let operands = [left, right, then, otherwise].map(of);
                self.graph.plain(Form::Select(*relation, Box::new(operands)))
            }
        }
    }

    /// q πᵏ: q is a coefficient, π a factor.
    fn constant(&mut self, constant: &Constant) -> Scaled {
        if constant.pi_exponent == 0 {
            return self.graph.number(constant);
        }
        let factor = self.graph.number(&Constant::rational(constant.factor.clone()));
        let pi = self.graph.plain(Form::Number(Constant::pi()));
        let power = self.graph.power(pi, i64::from(constant.pi_exponent).into());
        self.graph.product(&[(factor, Exponent::ONE), (power, Exponent::ONE)])
    }

    /// a + c b
    fn sum(&mut self, a: Value, b: Value, sign: Coefficient) -> Scaled {
        let left = self.terms(a);
        let right: Vec<Scaled> = self.terms(b).into_iter().map(|term| self.graph.scale(sign, term)).collect();
        if left.len() + right.len() <= LONGEST {
            return self.graph.sum(&[left, right].concat());
        }
        let [left, right] = [a, b].map(|value| self.values[value.place()]);
        let right = self.graph.scale(sign, right);
        self.graph.sum(&[left, right])
    }

    fn terms(&mut self, value: Value) -> Vec<Scaled> {
        let scaled = self.values[value.place()];
        let terms = match self.graph.form(scaled.node) {
            Form::Sum(terms) if self.uses[value.place()] == 1 || terms.len() <= SHARED_LENGTH => {
                terms.clone()
            }
            _ => return vec![scaled],
        };
        let term = |(coefficient, node)| Scaled { coefficient, node };
        terms.into_iter().map(|inner| self.graph.scale(scaled.coefficient, term(inner))).collect()
    }

    /// a bᵉ with e = ±1; a long product with other users stays one factor.
    fn product(&mut self, a: Value, b: Value, exponent: Exponent) -> Scaled {
        let [left, right] = [a, b].map(|value| {
            let scaled = self.values[value.place()];
            let is_long = match self.graph.form(scaled.node) {
                Form::Product(factors) => {
                    factors.len() > if self.uses[value.place()] == 1 { LONGEST } else { SHARED_LENGTH }
                }
                _ => false,
            };
            (scaled, is_long)
        });
        if !left.1 && !right.1 {
            return self.graph.product(&[(left.0, Exponent::ONE), (right.0, exponent)]);
        }
        let node = self.graph.product_of(vec![(left.0.node, Exponent::ONE), (right.0.node, exponent)]);
        let by = right.0.coefficient.power(exponent.0.signum()).expect("divisions by zero are kept apart");
        let scaled = Scaled { coefficient: left.0.coefficient, node };
        self.graph.scale(by, scaled)
    }
}
