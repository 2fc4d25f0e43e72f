//! Opaque functions: expressions with a variable in the place of every function and radicand, and of every choice if
//! wanted, for proofs that need not look inside.
//!
//! A pass rewrites sums and products and leaves functions as they are. So operands of functions are compared first,
//! innermost functions first, and functions of equal operands become one variable; likewise equal radicands, whose roots
//! stay. What is left are roots of variables and rational functions, and where they are equal, so are the expressions:
//! at each point at which the expressions are defined the variables have values. The converse does not hold, as
//! sin² + cos² = 1 shows.

use super::cuts::Cuts;
use crate::expression::{Expr, Node, Operation, Pool, SymbolKind};
use crate::syntax::ast::Relation;
use rustc_hash::{FxHashMap, FxHashSet};

/// What a variable stands for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hidden {
    Radicand,
    Applied(Operation),
    Choice(Relation),
    Quadrature,
}

/// What has variables in its place.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Depth {
    /// Functions and radicands.
    Functions,
    /// Choices too, as functions of what they compare and of their branches.
    Choices,
}

/// A variable that stands for a function of operands, or for its only operand; they are opaque themselves.
struct Variable {
    hidden: Hidden,
    operands: Vec<Expr>,
    symbol: Expr,
}

/// The expressions with variables for functions and radicands; equal functions of equal operands are one variable.
pub(super) fn opaque(pool: &mut Pool, expressions: &[Expr], depth: Depth) -> Vec<Expr> {
    let mut images = Images {
        depth,
        variables: Variables::default(),
        plain: FxHashMap::default(),
        images: FxHashMap::default(),
    };
    images.of(pool, expressions)
}

/// What stands for the expressions met so far.
struct Images {
    depth: Depth,
    variables: Variables,
    /// As summands: a sum is made of what its summands are, so that a part of it that is a radicand elsewhere makes no
    /// difference.
    plain: FxHashMap<Expr, Expr>,
    /// As operands of anything else.
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

    /// The image of an expression whose operands have theirs.
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
                    // the integrands are compared as functions of their variable
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

/// The variables so far, and comparisons of what they stand for.
#[derive(Default)]
struct Variables {
    known: Vec<Variable>,
    cuts: Cuts,
}

impl Variables {
    /// The variable that stands for this.
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

    /// Whether two expressions of x and y are proved to be equal without a look inside functions and choices.
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
