//! Opaque functions: expressions with a variable in the place of every function and radicand, and of every choice and
//! sum if wanted, for proofs that need not look inside.
//!
//! A pass rewrites sums and products and leaves functions as they are. So operands of functions are compared first,
//! innermost functions first, and functions of equal operands become one variable; likewise equal radicands, whose roots
//! stay. What is left are roots of variables and rational functions, and where they are equal, so are the expressions:
//! at each point at which the expressions are defined the variables have values. The converse does not hold, as
//! sin² + cos² = 1 shows.

use crate::decide::{Effort, Equations, Finding};
use crate::expression::{Expr, Node, Operation, Pool, SymbolKind};
use crate::syntax::ast::Relation;
use rustc_hash::{FxHashMap, FxHashSet};

/// Most pairs of operands differ, which a few points show; the others are small.
const EFFORT: Effort = Effort { work: 1_000_000, candidates: 24, points: 4 };

/// What a variable stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hidden {
    Radicand,
    Applied(Operation),
    Choice(Relation),
    Sum,
}

/// What has variables in its place.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Depth {
    /// Functions and radicands.
    Functions,
    /// Choices too, as functions of what they compare and of their branches.
    Choices,
    /// Sums too, where they are not themselves summands.
    Sums,
}

/// A variable that stands for a function of operands, or for its only operand; they are opaque themselves.
struct Variable {
    hidden: Hidden,
    operands: Vec<Expr>,
    symbol: Expr,
}

/// The expressions with variables for functions and radicands; equal functions of equal operands are one variable.
pub(super) fn opaque(pool: &mut Pool, expressions: &[Expr], depth: Depth) -> Vec<Expr> {
    let reachable = pool.reachable(expressions);
    let radicand = |expression: &Expr| match pool.node(*expression) {
        Node::Power(base, exponent) if !exponent.is_integer() => Some(*base),
        _ => None,
    };
    let radicands: FxHashSet<Expr> = reachable.iter().filter_map(radicand).collect();
    let sums = if depth == Depth::Sums { whole_sums(pool, &reachable) } else { FxHashSet::default() };
    let mut variables: Vec<Variable> = Vec::new();
    // a sum is made of what its summands are, so that a part of it that is a radicand elsewhere makes no difference
    let mut plain: FxHashMap<Expr, Expr> = FxHashMap::default();
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for expression in reachable {
        let mut image = match pool.node(expression).clone() {
            node @ (Node::Add(..) | Node::Negate(_)) => pool.image(expression, node, &plain),
            Node::Apply(operation, operands) => {
                let operands = operands.iter().map(|operand| images[operand]).collect();
                variable(pool, &mut variables, Hidden::Applied(operation), operands)
            }
            Node::Select { left, relation, right, then, otherwise, .. } if depth >= Depth::Choices => {
                let operands = [left, right, then, otherwise].map(|operand| images[&operand]);
                variable(pool, &mut variables, Hidden::Choice(relation), operands.to_vec())
            }
            node => pool.image(expression, node, &images),
        };
        plain.insert(expression, image);
        let is_one_already = matches!(pool.node(image), Node::Symbol(_) | Node::Number(_));
        if radicands.contains(&expression) && !is_one_already {
            image = variable(pool, &mut variables, Hidden::Radicand, vec![image]);
        } else if sums.contains(&expression) && !is_one_already {
            image = variable(pool, &mut variables, Hidden::Sum, vec![image]);
        }
        images.insert(expression, image);
    }
    expressions.iter().map(|expression| images[expression]).collect()
}

/// The sums that are operands of anything but sums.
fn whole_sums(pool: &Pool, expressions: &[Expr]) -> FxHashSet<Expr> {
    let mut sums = FxHashSet::default();
    for expression in expressions {
        let node = pool.node(*expression);
        if matches!(node, Node::Add(..) | Node::Negate(_)) {
            continue;
        }
        node.for_each_operand(|operand| {
            if matches!(pool.node(operand), Node::Add(..)) {
                sums.insert(operand);
            }
        });
    }
    sums
}

/// The variable that stands for this.
fn variable(pool: &mut Pool, variables: &mut Vec<Variable>, hidden: Hidden, operands: Vec<Expr>) -> Expr {
    for known in variables.iter().filter(|known| known.hidden == hidden) {
        if are_equal(pool, &known.operands, &operands) {
            return known.symbol;
        }
    }
    let symbol = pool.declare_symbol(format!("opaque_{}", variables.len()), SymbolKind::Local);
    let symbol = pool.symbol(symbol);
    variables.push(Variable { hidden, operands, symbol });
    symbol
}

pub(super) fn are_equal(pool: &mut Pool, left: &[Expr], right: &[Expr]) -> bool {
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
    fn outputs(values: &str, depth: Depth) -> (Pool, Vec<Expr>) {
        let (theory, errors) = read_theory(&format!("kernel f(x, y) = ({values});"));
        assert!(errors.is_empty(), "{errors:?}");
        let mut pool = theory.pool;
        let images = opaque(&mut pool, &theory.kernels[0].outputs, depth);
        (pool, images)
    }

    fn are_alike(left: &str, right: &str) -> bool {
        let (mut pool, images) = outputs(&format!("{left}, {right}"), Depth::Choices);
        are_equal(&mut pool, &images[..1], &images[1..])
    }

    #[test]
    fn equal_operands_make_one_variable() {
        assert!(are_alike("sin((x + y)**2)", "sin(x**2 + 2*x*y + y**2)"));
        assert!(are_alike("exp(x*sqrt(y*(x + 1)))", "exp(sqrt(x*y + y)*x)"));
        assert!(are_alike("(x + y)**(3/2)*x", "(x + y)*sqrt(x + y)*x"));
        assert!(are_alike("sqrt(x + y)*sin(x + y + 1)", "sqrt(x + y)*sin(x + (y + 1))"));
    }

    #[test]
    fn choices_between_equal_branches_make_one_variable() {
        let choice = |x: &str| format!("if jump {x} > y {{ sin({x}) }} else {{ {x}*y }}");
        assert!(are_alike(&choice("(x*(x + y))"), &choice("(x**2 + x*y)")));
        assert!(!are_alike(&choice("(x*(x + y))"), &choice("(x**2 + y)")));
    }

    #[test]
    fn sums_are_opaque_as_operands() {
        let values = "(x + y)**40*x, x*(y + x)**40, (x + y)*x, x**2 + y*x";
        let (mut pool, images) = outputs(values, Depth::Sums);
        assert!(are_equal(&mut pool, &images[..1], &images[1..2]));
        assert!(!are_equal(&mut pool, &images[2..3], &images[3..]));
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
