//! Matching: two forms of an expression compared part by part.
//!
//! ```text
//! atan2(√p, q) if r < s …   written  ─▶  every root, function and choice gets a variable, operands first
//! atan2(√p′, q′) if r′ < s′ … found  ─▶  one whose operands are equal to those of a written one gets its variable
//!                                        what is left between them are equations of fractions
//! ```
//! What is equal with the parts as free variables is equal with what they stand for; the reverse is not so, and then
//! nothing is said here. The proof is as long as the forms, where going through the pieces of every choice and through the
//! powers of every root is not.

use crate::decide::{Effort, Equations, Finding};
use crate::expression::{Expr, Node, Operation, Pool, SymbolKind};
use crate::syntax::ast::Relation;
use num_rational::Ratio;
use rustc_hash::FxHashMap;

/// What is done to the operands of a part.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Head {
    Root(Ratio<i64>),
    Function(Operation),
    Choice(Relation),
}

impl Head {
    fn of(node: &Node) -> Option<Head> {
        match node {
            Node::Power(_, exponent) if !exponent.is_integer() => Some(Head::Root(*exponent)),
            Node::Apply(operation, _) => Some(Head::Function(*operation)),
            Node::Select { relation, .. } => Some(Head::Choice(*relation)),
            _ => None,
        }
    }
}

/// A part of the written form, and the variable that stands for it.
struct Part {
    head: Head,
    operands: Vec<Expr>,
    variable: Expr,
}

/// Whether the sides of each pair, found and written, are shown to be equal wherever both are defined.
pub(super) fn agree(pool: &mut Pool, pairs: &[(Expr, Expr)], effort: Effort) -> bool {
    let (found, written): (Vec<Expr>, Vec<Expr>) = pairs.iter().copied().unzip();
    let mut parts = Vec::new();
    let written = with_variables(pool, &written, |pool, head, operands| {
        let variable = variable(pool);
        parts.push(Part { head, operands, variable });
        variable
    });
    let found = with_variables(pool, &found, |pool, head, operands| {
        let same = parts.iter().find(|part| part.head == head && equal(pool, &operands, &part.operands, effort));
        same.map_or_else(|| variable(pool), |part| part.variable)
    });
    equal(pool, &found, &written, effort)
}

fn variable(pool: &mut Pool) -> Expr {
    let symbol = pool.declare_symbol("part", SymbolKind::Local);
    pool.symbol(symbol)
}

/// The expressions with a variable for every part, which `named` chooses by the head and the operands.
fn with_variables(
    pool: &mut Pool,
    expressions: &[Expr],
    mut named: impl FnMut(&mut Pool, Head, Vec<Expr>) -> Expr,
) -> Vec<Expr> {
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for expression in pool.reachable(expressions) {
        let node = pool.node(expression).clone();
        let image = match Head::of(&node) {
            Some(head) => {
                let operands = node.operands().iter().map(|operand| images[operand]).collect();
                named(pool, head, operands)
            }
            None => pool.image(expression, node, &images),
        };
        images.insert(expression, image);
    }
    expressions.iter().map(|expression| images[expression]).collect()
}

/// Whether these are proved equal one by one.
fn equal(pool: &mut Pool, found: &[Expr], written: &[Expr], effort: Effort) -> bool {
    let mut pairs = found.iter().copied().zip(written.iter().copied());
    pairs.all(|(a, b)| {
        let equation = Equations { sides: &[(a, b)], conditions: &[] };
        a == b || matches!(equation.decide(pool, effort), Finding::Equal { .. })
    })
}
