//! Raising: instructions become expressions again, to be proved equal to the expressions the kernel
//! was lowered from.

use super::constant::Constant;
use super::program::{Instruction, Program, Value};
use crate::expression::{Condition, Expr, Pool, Seam, Substitution, Symbol, SymbolKind};

/// Program as expressions.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Raised {
    /// Output expressions.
    pub outputs: Vec<Expr>,
    /// Conditions of the domain, outside which the program is NaN.
    pub domain: Vec<Condition>,
}

impl Program {
    /// Raises the program to expressions of these variables, one for each argument.
    pub fn raise(&self, pool: &mut Pool, arguments: &[Symbol]) -> Raised {
        debug_assert_eq!(arguments.len(), self.arguments.len());
        let mut values: Vec<Expr> = Vec::with_capacity(self.instructions.len());
        for instruction in &self.instructions {
            let expression = raise_instruction(instruction, pool, arguments, &values);
            values.push(expression);
        }
        let of = |value: Value| values[value.place()];
        let domain = self.domain.iter().map(|condition| Condition {
            left: of(condition.left),
            relation: condition.relation,
            right: of(condition.right),
        });
        Raised { outputs: self.outputs.iter().map(|&output| of(output)).collect(), domain: domain.collect() }
    }
}

fn raise_instruction(
    instruction: &Instruction,
    pool: &mut Pool,
    arguments: &[Symbol],
    values: &[Expr],
) -> Expr {
    let of = |value: &Value| values[value.place()];
    match instruction {
        Instruction::Constant(constant) => raise_constant(constant, pool),
        Instruction::Argument(place) => pool.symbol(arguments[*place as usize]),
        Instruction::Add(a, b) => pool.add(of(a), of(b)),
        Instruction::Subtract(a, b) => pool.subtract(of(a), of(b)),
        Instruction::Multiply(a, b) => pool.multiply(of(a), of(b)),
        Instruction::Divide(a, b) => pool.divide(of(a), of(b)),
        Instruction::MultiplyAdd(sum, [a, b, c]) => {
            let product = pool.multiply(of(a), of(b));
            let [left, right] = sum.terms(product, of(c));
            if sum.is_difference() { pool.subtract(left, right) } else { pool.add(left, right) }
        }
        Instruction::DifferenceOfProducts([a, b, c, d]) => {
            let (left, right) = (pool.multiply(of(a), of(b)), pool.multiply(of(c), of(d)));
            pool.subtract(left, right)
        }
        Instruction::SumOfProducts([a, b, c, d]) => {
            let (left, right) = (pool.multiply(of(a), of(b)), pool.multiply(of(c), of(d)));
            pool.add(left, right)
        }
        Instruction::Negate(a) => pool.negate(of(a)),
        Instruction::Sqrt(a) => pool.sqrt(of(a)),
        Instruction::Power(a, exponent) => pool.power(of(a), *exponent),
        Instruction::Call(operation, operands) => {
            let operands: Vec<Expr> = operands.iter().map(of).collect();
            pool.apply(*operation, &operands)
        }
        Instruction::Quadrature { integrand, operands } => {
            let operands: Vec<Expr> = operands.iter().map(of).collect();
            raise_quadrature(integrand, &operands, pool)
        }
        Instruction::Select { left, relation, right, then, otherwise } => {
            pool.select((of(left), *relation, of(right)), of(then), of(otherwise), Seam::Agrees)
        }
    }
}

/// Raises an integrand to an expression of its own variables, for which the captured values are
/// substituted afterwards.
fn raise_quadrature(integrand: &Program, operands: &[Expr], pool: &mut Pool) -> Expr {
    let [from, to, captured @ ..] = operands else { return pool.integer(0) };
    let names = integrand.arguments().to_vec();
    let variables: Vec<Symbol> =
        names.into_iter().map(|name| pool.declare_symbol(name, SymbolKind::Local)).collect();
    let value = integrand.raise(pool, &variables).outputs[0];
    let captured = variables[1..].iter().copied().zip(captured.iter().copied()).collect();
    let ends = [(), ()].map(|()| pool.declare_symbol("end", SymbolKind::Local));
    let [a, b] = ends.map(|end| pool.symbol(end));
    let integral = pool.quadrature(value, variables[0], a, b);
    let mut values: Substitution = captured;
    values.extend([(ends[0], *from), (ends[1], *to)]);
    pool.substitute(integral, &values)
}

/// q πᵏ
fn raise_constant(constant: &Constant, pool: &mut Pool) -> Expr {
    let factor = pool.number(constant.factor.clone());
    if constant.pi_exponent == 0 {
        return factor;
    }
    let pi = pool.pi();
    let power = pool.power(pi, i64::from(constant.pi_exponent).into());
    pool.multiply(factor, power)
}
