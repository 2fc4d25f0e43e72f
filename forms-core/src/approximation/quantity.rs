//! Expressions of one quantity: a variable, or a common part through which a form and a formula
//! depend on all their variables, with the range that conditions leave to it.
//!
//! ```text
//! (1 − cos √(x² + y²))/(x² + y²)  ─ x² + y² = w², √(x² + y²) = w ─▶  (1 − cos w)/w²,  w ≥ 0
//! ```

use super::one_variable::OneVariable;
use crate::decide::contradiction;
use crate::enclosure::{Enclosure, Precision, enclose_number};
use crate::expression::{Condition, Expr, Node, Operation, Pool, Rational, Relation, Symbol, SymbolKind};
use num_rational::Ratio;
use num_traits::{Signed, Zero};
use rustc_hash::FxHashMap;

/// Binary places to which a number in a condition is enclosed.
const PRECISION: Precision = Precision(128);

/// Returns the ways in which a form and a formula are functions of one quantity with a bounded range.
pub(super) fn in_one_variable(
    pool: &mut Pool,
    (form, formula): (Expr, Expr),
    known: &[Condition],
) -> Vec<OneVariable> {
    let parts = common_parts(pool, form, formula);
    let of_part = |part: Expr| by_part(pool, (form, formula), part, known);
    parts.into_iter().filter_map(of_part).collect()
}

/// Returns the variables of the formula and the parts that vary and that both expressions have, the
/// largest first.
fn common_parts(pool: &Pool, form: Expr, formula: Expr) -> Vec<Expr> {
    let of_form = pool.reachable(&[form]);
    let mut parts = pool.reachable(&[formula]);
    parts.retain(|part| {
        let is_common = || of_form.binary_search(part).is_ok() && !pool.symbols_in(&[*part]).is_empty();
        *part != formula && (matches!(pool.node(*part), Node::Symbol(_)) || is_common())
    });
    parts.reverse();
    parts
}

/// An expression as a function of a new variable w, which stands for a part of it or for the square
/// root of this part.
pub(super) struct Quantity {
    pub(super) variable: Symbol,
    pub(super) part: Expr,
    pub(super) is_root: bool,
    pub(super) expression: Expr,
}

/// Returns the ways in which an expression is a function of one quantity.
pub(super) fn quantities(pool: &mut Pool, expression: Expr) -> Vec<Quantity> {
    let mut found = Vec::new();
    for part in common_parts(pool, expression, expression) {
        if let Some((variable, is_root, expressions)) = replaced(pool, &[expression], part) {
            found.push(Quantity { variable, part, is_root, expression: expressions[0] });
        }
    }
    found
}

/// Replaces a part by a new variable, or its square root by a new variable and the part by its
/// square if the first expression contains this root; `None` if other variables remain.
fn replaced(pool: &mut Pool, expressions: &[Expr], part: Expr) -> Option<(Symbol, bool, Vec<Expr>)> {
    let root = pool.power(part, Ratio::new(1, 2));
    let is_root = pool.reachable(&expressions[..1]).contains(&root);
    let variable = pool.declare_symbol("w", SymbolKind::Local);
    let new = pool.symbol(variable);
    let mut images: FxHashMap<Expr, Expr> = [(part, new)].into_iter().collect();
    if is_root {
        let square = pool.power(new, Ratio::from_integer(2));
        images.extend([(root, new), (part, square)]);
    }
    let images: Vec<Expr> = expressions.iter().map(|&expression| pool.replace(expression, &images)).collect();
    (pool.symbols_in(&images) == [variable]).then_some((variable, is_root, images))
}

/// Makes both functions of a part; `None` if other variables remain, or if the conditions do not
/// bound the part.
fn by_part(
    pool: &mut Pool,
    (form, formula): (Expr, Expr),
    part: Expr,
    known: &[Condition],
) -> Option<OneVariable> {
    let (variable, is_root, expressions) = replaced(pool, &[formula, form], part)?;
    let of_part = range(pool, part, known);
    let range = if is_root {
        let root = pool.power(part, Ratio::new(1, 2));
        root_range(range(pool, root, known), of_part)?
    } else {
        of_part?
    };
    let range = if matches!(pool.node(part), Node::Symbol(_)) { range } else { widened(range) };
    Some(OneVariable { variable, form: expressions[1], formula: expressions[0], range })
}

/// Returns the range of a square root from that of itself and that of its radicand.
fn root_range(of_root: Option<[Rational; 2]>, of_part: Option<[Rational; 2]>) -> Option<[Rational; 2]> {
    of_root.or_else(|| Some([Rational::zero(), root_above(&of_part?[1])?]))
}

/// Returns the range that conditions between an expression and numbers leave to it.
fn range(pool: &mut Pool, expression: Expr, known: &[Condition]) -> Option<[Rational; 2]> {
    let mut bounds = Bounds::default();
    let negative = pool.negate(expression);
    let size = pool.apply(Operation::Abs, &[expression]);
    let squares = [pool.power(expression, Ratio::from_integer(2)), pool.multiply(expression, expression)];
    for condition in known {
        let sides = [
            (condition.left, condition.relation, condition.right),
            (condition.right, condition.relation.mirrored(), condition.left),
        ];
        for (side, relation, number) in sides {
            if ![expression, negative, size, squares[0], squares[1]].contains(&side) {
                continue;
            }
            let Some([least, most]) = number_range(pool, number) else { continue };
            let is_upper = matches!(relation, Relation::Less | Relation::LessEqual);
            match side {
                _ if relation == Relation::NotEqual => {}
                side if side == expression && is_upper => bounds.at_most(most),
                side if side == expression => bounds.at_least(least),
                side if side == negative && is_upper => bounds.at_least(-most),
                side if side == negative => bounds.at_most(-least),
                side if is_upper => {
                    let most = if side == size {
                        most
                    } else {
                        widened([Rational::zero(), root_above(&most)?])[1].clone()
                    };
                    bounds.at_most(most.clone());
                    bounds.at_least(-most);
                }
                _ => {}
            }
        }
    }
    if bounds.lower.is_none() || bounds.lower.as_ref().is_some_and(Signed::is_negative) {
        let zero = pool.integer(0);
        let below = Condition { left: expression, relation: Relation::Less, right: zero };
        let all: Vec<Condition> = known.iter().copied().chain([below]).collect();
        if !matches!(pool.node(expression), Node::Symbol(_)) && contradiction(pool, &all).is_some() {
            bounds.at_least(Rational::zero());
        }
    }
    let (lower, upper) = (bounds.lower?, bounds.upper?);
    (lower <= upper).then_some([lower, upper])
}

/// Returns a slightly larger range: a program compares rounded values of a part that is computed, so
/// that a piece is also used a little beyond its condition.
fn widened([lower, upper]: [Rational; 2]) -> [Rational; 2] {
    let more = Rational::new(1.into(), (1_i64 << 20).into());
    let [below, above] = [&lower, &upper].map(|end| end.abs() * &more);
    [lower - below, upper + above]
}

/// Bounds of a quantity.
#[derive(Default)]
struct Bounds {
    lower: Option<Rational>,
    upper: Option<Rational>,
}

impl Bounds {
    fn at_least(&mut self, bound: Rational) {
        self.lower = Some(self.lower.take().map_or(bound.clone(), |known| known.max(bound)));
    }

    fn at_most(&mut self, bound: Rational) {
        self.upper = Some(self.upper.take().map_or(bound.clone(), |known| known.min(bound)));
    }
}

/// Encloses an expression without variables.
fn number_range(pool: &Pool, number: Expr) -> Option<[Rational; 2]> {
    if !pool.symbols_in(&[number]).is_empty() {
        return None;
    }
    let value = enclose_number(pool, number, PRECISION).ok()?;
    Some([value.lower(), value.upper()])
}

/// Returns a number whose square is at least this one.
fn root_above(square: &Rational) -> Option<Rational> {
    Some(Enclosure::exact(square, PRECISION).power(Ratio::new(1, 2)).ok()?.upper())
}
