//! Translations that change no expression, and the frame that moves with them.
//!
//! ```text
//! expressions ─ their largest linear parts ─▶ rows ─ row echelon form ─▶ pivots, free variables
//! ```
//! Expressions depend on their variables only through their largest linear parts, Σ m_s s +
//! constant. A direction v with m·v = 0 for every linear part is a translation that changes no
//! expression: there is one for each variable f without a pivot, with v_f = 1. No linear part
//! contains f in the frame s = s′ + Σ v_s f.
//!
//! Where there is a choice, coordinates are left without a pivot, so that parameters become
//! relative to them.

use crate::expression::{Expr, Node, Pool, Rational, Symbol, SymbolKind};
use crate::normal::Drift;
use num_traits::{One, ToPrimitive, Zero};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// Σ m_s s, without the constant.
type Linear = BTreeMap<Column, Rational>;

/// A variable; coordinates sort last.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
struct Column {
    is_coordinate: bool,
    symbol: Symbol,
}

/// Returns the frame that moves with the translations that change no expression; empty if there are
/// none.
pub(super) fn frame(pool: &Pool, expressions: &[Expr]) -> Vec<Drift> {
    let parts = pool.reachable(expressions);
    if every_variable_is_bare(pool, &parts) {
        return Vec::new();
    }
    let mut echelon = Echelon::default();
    let rows = linear_parts(pool, expressions, parts);
    let columns: FxHashSet<Symbol> = rows.iter().flat_map(|row| row.keys().map(|c| c.symbol)).collect();
    for row in rows {
        echelon.insert(row);
        if echelon.rows.len() == columns.len() {
            return Vec::new();
        }
    }
    echelon.drifts()
}

/// Whether every variable alone is an operand of some operation other than a sum or a multiple, so
/// that no translation remains.
fn every_variable_is_bare(pool: &Pool, parts: &[Expr]) -> bool {
    let is_number = |operand: &Expr| pool.as_number(*operand).is_some();
    let mut bare: FxHashSet<Symbol> = FxHashSet::default();
    let mut variables = 0;
    for &part in parts {
        match pool.node(part) {
            Node::Symbol(_) => variables += 1,
            Node::Add(..) | Node::Negate(_) => {}
            Node::Multiply(a, b) if is_number(a) || is_number(b) => {}
            Node::Divide(_, b) if is_number(b) => {}
            node => node.for_each_operand(|operand| {
                if let Node::Symbol(symbol) = pool.node(operand) {
                    bare.insert(*symbol);
                }
            }),
        }
    }
    bare.len() == variables
}

/// Returns the linear parts that are operands of an operation other than a sum or a multiple, or
/// that are whole expressions.
fn linear_parts(pool: &Pool, expressions: &[Expr], parts: Vec<Expr>) -> Vec<Linear> {
    let mut known: FxHashMap<Expr, Linear> = FxHashMap::default();
    let mut largest: Vec<Expr> = Vec::new();
    for expression in parts {
        match linear(pool, expression, &known) {
            Some(part) => {
                known.insert(expression, part);
            }
            None => pool.node(expression).for_each_operand(|operand| largest.push(operand)),
        }
    }
    largest.extend(expressions);
    largest.sort_unstable();
    largest.dedup();
    let parts = largest.into_iter().filter_map(|part| known.remove(&part));
    parts.filter(|part| !part.is_empty()).collect()
}

fn linear(pool: &Pool, expression: Expr, known: &FxHashMap<Expr, Linear>) -> Option<Linear> {
    match pool.node(expression) {
        Node::Number(_) => Some(Linear::new()),
        Node::Symbol(symbol) => {
            let is_coordinate = pool.symbol_kind(*symbol) == SymbolKind::Coordinate;
            Some([(Column { is_coordinate, symbol: *symbol }, Rational::one())].into_iter().collect())
        }
        Node::Add(a, b) => {
            let mut sum = known.get(a)?.clone();
            add_multiple(&mut sum, &Rational::one(), known.get(b)?);
            Some(sum)
        }
        Node::Negate(a) => Some(scaled(known.get(a)?, &-Rational::one())),
        Node::Multiply(a, b) => match (pool.as_number(*a), pool.as_number(*b)) {
            (Some(number), _) => Some(scaled(known.get(b)?, number)),
            (_, Some(number)) => Some(scaled(known.get(a)?, number)),
            _ => None,
        },
        Node::Divide(a, b) => {
            let number = pool.as_number(*b).filter(|number| !number.is_zero())?;
            Some(scaled(known.get(a)?, &number.recip()))
        }
        _ => None,
    }
}

fn scaled(part: &Linear, number: &Rational) -> Linear {
    let mut sum = Linear::new();
    add_multiple(&mut sum, number, part);
    sum
}

/// Adds number·part to a sum.
fn add_multiple(sum: &mut Linear, number: &Rational, part: &Linear) {
    for (column, coefficient) in part {
        let entry = sum.entry(*column).or_insert_with(Rational::zero);
        *entry += number * coefficient;
        if entry.is_zero() {
            sum.remove(column);
        }
    }
}

/// Rows in reduced echelon form: the first entry of a row is 1, in its pivot column, where all
/// other rows have 0.
#[derive(Default)]
struct Echelon {
    rows: BTreeMap<Column, Linear>,
}

impl Echelon {
    fn insert(&mut self, mut row: Linear) {
        let pivots: Vec<Column> =
            row.keys().filter(|column| self.rows.contains_key(column)).copied().collect();
        for pivot in pivots {
            let factor = -row[&pivot].clone();
            add_multiple(&mut row, &factor, &self.rows[&pivot]);
        }
        let Some((&pivot, leading)) = row.first_key_value() else { return };
        let row = scaled(&row, &leading.recip());
        for other in self.rows.values_mut() {
            if let Some(factor) = other.get(&pivot).map(|factor| -factor) {
                add_multiple(other, &factor, &row);
            }
        }
        self.rows.insert(pivot, row);
    }

    /// Returns the drifts v_s = −m_sf for the row of the pivot s. A variable with which another
    /// moves by a fraction is left as it is.
    fn drifts(&self) -> Vec<Drift> {
        let mut drifts = Vec::new();
        let mut fractional = Vec::new();
        for (pivot, row) in &self.rows {
            for (column, coefficient) in row.iter().filter(|(column, _)| *column != pivot) {
                match coefficient.is_integer().then(|| (-coefficient.numer()).to_i64()).flatten() {
                    Some(speed) => {
                        drifts.push(Drift { moved: pivot.symbol, with: column.symbol, speed });
                    }
                    None => fractional.push(column.symbol),
                }
            }
        }
        drifts.retain(|drift| !fractional.contains(&drift.with));
        drifts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Substitution;

    /// The parameters a, b and the coordinates x, y.
    fn world() -> (Pool, [Symbol; 4]) {
        let mut pool = Pool::new();
        let mut declare = |name, kind| pool.declare_symbol(name, kind);
        let a = declare("a", SymbolKind::Parameter);
        let b = declare("b", SymbolKind::Parameter);
        let x = declare("x", SymbolKind::Coordinate);
        let y = declare("y", SymbolKind::Coordinate);
        (pool, [a, b, x, y])
    }

    /// Returns the expression with every moved variable s replaced by s + Σ v f.
    fn moved(pool: &mut Pool, expression: Expr, drifts: &[Drift]) -> Expr {
        let mut values = Substitution::default();
        for drift in drifts {
            let (with, speed) = (pool.symbol(drift.with), pool.integer(drift.speed));
            let part = pool.multiply(speed, with);
            let so_far = values.get(&drift.moved).copied().unwrap_or_else(|| pool.symbol(drift.moved));
            let sum = pool.add(so_far, part);
            values.insert(drift.moved, sum);
        }
        pool.substitute(expression, &values)
    }

    #[test]
    fn what_depends_on_differences_alone_is_free_of_the_observer_in_its_frame() {
        let (mut pool, [a, b, x, _]) = world();
        let [p, q, o] = [a, b, x].map(|symbol| pool.symbol(symbol));
        let (left, right) = (pool.subtract(p, o), pool.subtract(o, q));
        let (left, right) = (pool.power(left, 2.into()), pool.power(right, 3.into()));
        let product = pool.multiply(left, right);
        let drifts = frame(&pool, &[product]);
        let with = |moved| Drift { moved, with: x, speed: 1 };
        assert_eq!(drifts, [with(a), with(b)]);
        let image = moved(&mut pool, product, &drifts);
        let parts = linear_parts(&pool, &[image], pool.reachable(&[image]));
        assert!(parts.iter().flat_map(|part| part.keys()).all(|column| column.symbol != x));
    }

    #[test]
    fn a_single_occurrence_outside_a_difference_forbids_the_frame() {
        let (mut pool, [a, b, x, _]) = world();
        let [p, q, o] = [a, b, x].map(|symbol| pool.symbol(symbol));
        let (left, right) = (pool.subtract(p, o), pool.subtract(o, q));
        let (left, right) = (pool.power(left, 2.into()), pool.power(right, 3.into()));
        let product = pool.multiply(left, right);
        for bare in [p, q, o] {
            let cosine = pool.apply(crate::expression::Operation::Cos, &[bare]);
            let sum = pool.add(product, cosine);
            assert_eq!(frame(&pool, &[sum]), []);
            let sum = pool.add(product, bare);
            assert_eq!(frame(&pool, &[sum]), []);
        }
    }

    #[test]
    fn variables_move_at_the_speeds_that_keep_linear_parts_as_they_are() {
        let (mut pool, [a, b, x, y]) = world();
        let [p, q, o, r] = [a, b, x, y].map(|symbol| pool.symbol(symbol));
        let two = pool.integer(2);
        let twice = pool.multiply(two, o);
        let (left, right) = (pool.add(p, twice), pool.subtract(q, r));
        let (left, right) = (pool.power(left, 2.into()), pool.power(right, 2.into()));
        let sum = pool.add(left, right);
        let drifts = frame(&pool, &[sum]);
        assert_eq!(drifts, [Drift { moved: a, with: x, speed: -2 }, Drift { moved: b, with: y, speed: 1 }]);
    }
}
