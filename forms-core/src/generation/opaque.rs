//! Opaque functions: replaces every function and radicand, and optionally every conditional, by a
//! variable (uninterpreted functions), for proofs that need not look inside.
//!
//! A pass rewrites sums and products and leaves functions as they are. Operands of functions are
//! therefore compared first, innermost functions first, and functions of equal operands become one
//! variable. Equal radicands also become one variable, and their roots stay. The remaining
//! expressions contain roots of variables and rational functions. If they are equal, so are the
//! original expressions: at each point at which the expressions are defined the variables have
//! values. The converse does not hold, as sin² + cos² = 1 shows.

use super::cuts::Cuts;
use crate::expression::{Expr, Node, Operation, Pool, Relation, SymbolKind};
use rustc_hash::{FxHashMap, FxHashSet};

/// Kind of expression that a variable replaces.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hidden {
    Radicand,
    Applied(Operation),
    Choice(Relation),
    Quadrature,
}

/// Kinds of expressions that are replaced by variables.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    /// Functions and radicands.
    Functions,
    /// Conditionals too, as functions of the compared expressions and of the branches.
    Choices,
}

/// Variable that replaces a function of operands, or its only operand; the operands are opaque
/// themselves.
struct Variable {
    hidden: Hidden,
    operands: Vec<Expr>,
    symbol: Expr,
}

/// Replaces functions and radicands by variables; equal functions of equal operands become one
/// variable.
pub(super) fn opaque(pool: &mut Pool, expressions: &[Expr], depth: Depth) -> Vec<Expr> {
    let mut images = Images {
        depth,
        variables: Variables::default(),
        plain: FxHashMap::default(),
        images: FxHashMap::default(),
    };
    images.of(pool, expressions)
}

/// Images of the expressions met so far.
struct Images {
    depth: Depth,
    variables: Variables,
    /// Images of expressions as summands: a summand that is also a radicand elsewhere is not
    /// replaced by a variable in its sum.
    plain: FxHashMap<Expr, Expr>,
    /// Images of expressions as operands of any other operation.
    images: FxHashMap<Expr, Expr>,
}

impl Images {
    fn of(&mut self, pool: &mut Pool, expressions: &[Expr]) -> Vec<Expr> {
        let reachable = pool.reachable(expressions);
        let radicand = |expression: &Expr| match pool.node(*expression) {
            Node::Power(base, exponent) if !exponent.is_integer() => Some(*base),
            _ => None,
        };
        let radicands: FxHashSet<Expr> = reachable.iter().filter_map(radicand).collect();
        for expression in reachable {
            if self.images.contains_key(&expression) {
                continue;
            }
            let mut image = self.image(pool, expression);
            self.plain.insert(expression, image);
            let is_one_already = matches!(pool.node(image), Node::Symbol(_) | Node::Number(_));
            if radicands.contains(&expression) && !is_one_already {
                image = self.variables.variable(pool, Hidden::Radicand, vec![image]);
            }
            self.images.insert(expression, image);
        }
        expressions.iter().map(|expression| self.images[expression]).collect()
    }

    /// Returns the image of an expression whose operands have images.
    fn image(&mut self, pool: &mut Pool, expression: Expr) -> Expr {
        match pool.node(expression).clone() {
            node @ (Node::Add(..) | Node::Negate(_)) => pool.image(expression, node, &self.plain),
            Node::Apply(operation, operands) => {
                let operands = operands.iter().map(|operand| self.images[operand]).collect();
                self.variables.variable(pool, Hidden::Applied(operation), operands)
            }
            Node::Select { left, relation, right, then, otherwise, .. } if self.depth == Depth::Choices => {
                let operands = [left, right, then, otherwise].map(|operand| self.images[&operand]);
                self.variables.variable(pool, Hidden::Choice(relation), operands.to_vec())
            }
            Node::Jet { function, orders, arguments } if orders.iter().all(|&order| order == 0) => {
                match pool.integrand_at(function, &arguments) {
                    // integrands are compared as functions of their integration variable
                    Some((integrand, _)) => {
                        let mut operands = self.of(pool, &[integrand]);
                        operands.extend(arguments[..2].iter().map(|end| self.images[end]));
                        self.variables.variable(pool, Hidden::Quadrature, operands)
                    }
                    None => pool.image(expression, pool.node(expression).clone(), &self.images),
                }
            }
            node => pool.image(expression, node, &self.images),
        }
    }
}

/// Variables introduced so far, and comparisons of the operands that they replace.
#[derive(Default)]
struct Variables {
    known: Vec<Variable>,
    cuts: Cuts,
}

impl Variables {
    /// Returns the variable that replaces this kind of expression with these operands.
    fn variable(&mut self, pool: &mut Pool, hidden: Hidden, operands: Vec<Expr>) -> Expr {
        for known in self.known.iter().filter(|known| known.hidden == hidden) {
            if self.cuts.are_equal(pool, &known.operands, &operands) {
                return known.symbol;
            }
        }
        let symbol = pool.declare_symbol(format!("opaque_{}", self.known.len()), SymbolKind::Local);
        let symbol = pool.symbol(symbol);
        self.known.push(Variable { hidden, operands, symbol });
        symbol
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::check::read_theory;

    /// Whether two expressions of x and y are proved equal without looking inside functions and
    /// conditionals.
    fn are_alike(left: &str, right: &str) -> bool {
        let (theory, errors) = read_theory(&format!("kernel f(x, y) = ({left}, {right});"));
        assert!(errors.is_empty(), "{errors:?}");
        let mut pool = theory.pool;
        let images = opaque(&mut pool, &theory.kernels[0].outputs, Depth::Choices);
        Cuts::default().are_equal(&mut pool, &images[..1], &images[1..])
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
    fn quadratures_are_compared_by_their_integrands() {
        let of = |integrand: &str| format!("quadrature({integrand}, t = 0..y)");
        assert!(are_alike(&of("exp(-(x + t)**2)/(1 + t)"), &of("exp(-x**2 - 2*x*t - t**2)*(1/(t + 1))")));
        assert!(!are_alike(&of("exp(-x*t)"), &of("exp(x*t)")));
        assert!(!are_alike(&of("exp(-x*t)"), "quadrature(exp(-x*t), t = 0..x)"));
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
