//! Opaque functions: expressions with a variable in the place of every function and root, for proofs that need not look
//! inside.
//!
//! A pass rewrites sums and products and leaves functions and roots as they are. So operands of functions are compared
//! first, innermost functions first, and functions of equal operands become one variable. What is left are rational
//! functions of these variables, and where they are equal, so are the expressions: at each point at which the expressions
//! are defined the variables have values. The converse does not hold, as sin² + cos² = 1 shows.

use crate::decide::{Effort, Equations, Finding};
use crate::expression::{Expr, Node, Operation, Pool, SymbolKind};
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// Operands are small, and there are many pairs of them.
const EFFORT: Effort = Effort { work: 100_000, candidates: 24, points: 4 };

#[derive(Clone, Copy, PartialEq, Eq)]
enum Function {
    Root(i64),
    Applied(Operation),
}

/// A variable that stands for a function of operands, which are opaque themselves.
struct Variable {
    function: Function,
    operands: Vec<Expr>,
    symbol: Expr,
}

/// The expressions with variables for functions and roots; equal functions of equal operands are one variable.
pub(super) fn opaque(pool: &mut Pool, expressions: &[Expr]) -> Vec<Expr> {
    let mut variables: Vec<Variable> = Vec::new();
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for expression in pool.reachable(expressions) {
        let image = match pool.node(expression).clone() {
            Node::Apply(operation, operands) => {
                let operands = operands.iter().map(|operand| images[operand]).collect();
                variable(pool, &mut variables, Function::Applied(operation), operands)
            }
            Node::Power(base, exponent) if !exponent.is_integer() => {
                let root =
                    variable(pool, &mut variables, Function::Root(*exponent.denom()), vec![images[&base]]);
                pool.power(root, Ratio::from_integer(*exponent.numer()))
            }
            node => pool.image(expression, node, &images),
        };
        images.insert(expression, image);
    }
    expressions.iter().map(|expression| images[expression]).collect()
}

/// The variable of this function of these operands.
fn variable(pool: &mut Pool, variables: &mut Vec<Variable>, function: Function, operands: Vec<Expr>) -> Expr {
    for known in variables.iter().filter(|known| known.function == function) {
        if are_equal(pool, &known.operands, &operands) {
            return known.symbol;
        }
    }
    let symbol = pool.declare_symbol(format!("opaque_{}", variables.len()), SymbolKind::Local);
    let symbol = pool.symbol(symbol);
    variables.push(Variable { function, operands, symbol });
    symbol
}

fn are_equal(pool: &mut Pool, left: &[Expr], right: &[Expr]) -> bool {
    let sides: Vec<(Expr, Expr)> =
        left.iter().copied().zip(right.iter().copied()).filter(|(left, right)| left != right).collect();
    sides.is_empty()
        || matches!(
            (Equations { sides: &sides, conditions: &[] }).decide(pool, EFFORT),
            Finding::Equal { .. }
        )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// The outputs of the kernel `f(x, y) = (…)`, made opaque.
    fn outputs(values: &str) -> (Pool, Vec<Expr>) {
        let (theory, errors) = read_theory(&format!("kernel f(x, y) = ({values});"));
        assert!(errors.is_empty(), "{errors:?}");
        let mut pool = theory.pool;
        let images = opaque(&mut pool, &theory.kernels[0].outputs);
        (pool, images)
    }

    fn are_alike(left: &str, right: &str) -> bool {
        let (mut pool, images) = outputs(&format!("{left}, {right}"));
        are_equal(&mut pool, &images[..1], &images[1..])
    }

    #[test]
    fn equal_operands_make_one_variable() {
        assert!(are_alike("sin((x + y)**2)", "sin(x**2 + 2*x*y + y**2)"));
        assert!(are_alike("exp(x*sqrt(y*(x + 1)))", "exp(sqrt(x*y + y)*x)"));
        assert!(are_alike("x**(3/2)*y", "x**(1/2)*(x**(1/2))**2*y"));
    }

    #[test]
    fn different_operands_and_functions_stay_apart() {
        assert!(!are_alike("sin(x + y)", "sin(x - y)"));
        assert!(!are_alike("sin(x)", "cos(x)"));
        assert!(!are_alike("x**(1/2)", "x**(1/3)"));
    }

    #[test]
    fn what_takes_a_look_inside_is_left_alone() {
        assert!(!are_alike("sin(x)**2 + cos(x)**2", "1"));
    }
}
