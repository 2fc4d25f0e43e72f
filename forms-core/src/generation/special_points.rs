//! Special points: candidates for a point at which a form differs from its formula.
//!
//! Arguments take the values 0, ±1, ±1/2, ±2, … and, if they occur in angles, multiples of π/2, in
//! every combination. An argument is also set to where a relevant expression vanishes, by solving
//! for it. The points thus lie on strata of lower dimension as well, which points in general
//! position never meet. The sequence is the same for the same kernel.

use super::boundary::sheets;
use super::exact_point::Point;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, Symbol};
use crate::random::SplitMix;
use rustc_hash::FxHashSet;

/// Numbers that arguments take, the simplest first; a fraction p/q is the pair (p, q).
const NUMBERS: &[(i64, i64)] =
    &[(0, 1), (1, 1), (-1, 1), (2, 1), (1, 2), (-1, 2), (-2, 1), (1, 4), (3, 1), (-1, 4), (10, 1), (1, 10)];

/// Multiples of π/2 that an angle takes.
const QUARTER_TURNS: &[i64] = &[2, 1, -1, -2];

/// Largest number of solutions of one equation that are used.
const MOST_SOLUTIONS: usize = 6;

/// Special points of one kernel.
pub(super) struct SpecialPoints {
    arguments: Vec<Symbol>,
    /// Values that each argument takes.
    values: Vec<Vec<Expr>>,
    /// Arguments and their values where some expression vanishes.
    solutions: Vec<(Symbol, Expr)>,
    random: SplitMix,
    round: usize,
}

impl SpecialPoints {
    /// Creates the special points of some arguments, including points where the expressions `zeros`
    /// vanish.
    pub(super) fn new(pool: &mut Pool, arguments: &[Symbol], expressions: &[Expr], zeros: &[Expr]) -> Self {
        let angles = in_angles(pool, expressions);
        let numbers: Vec<Expr> = NUMBERS.iter().map(|&(p, q)| pool.ratio(p, q)).collect();
        let pi = pool.pi();
        let turns: Vec<Expr> = QUARTER_TURNS
            .iter()
            .map(|&quarters| {
                let (whole, half) = (pool.integer(quarters / 2), pool.integer(2));
                match quarters {
                    2 | -2 => pool.multiply(whole, pi),
                    _ => {
                        let turn = pool.divide(pi, half);
                        if quarters < 0 { pool.negate(turn) } else { turn }
                    }
                }
            })
            .collect();
        let values = arguments.iter().map(|argument| {
            let mut values = numbers[..1].to_vec();
            if angles.contains(argument) {
                values.extend(&turns);
            }
            values.extend(&numbers[1..]);
            values
        });
        let values = values.collect();
        let solutions = solutions(pool, arguments, zeros);
        SpecialPoints { arguments: arguments.to_vec(), values, solutions, random: SplitMix(0x5eed), round: 0 }
    }

    /// Returns the values of an argument that are simpler than the given one, the simplest first:
    /// numbers before multiples of π.
    pub(super) fn simpler(&self, pool: &Pool, argument: Symbol, value: Expr) -> Vec<Expr> {
        let place = self.arguments.iter().position(|&known| known == argument);
        let mut values = place.map_or_else(Vec::new, |place| self.values[place].clone());
        values.sort_by_key(|&value| pool.as_number(value).is_none());
        values.into_iter().take_while(|&known| known != value).collect()
    }

    /// Returns the next point.
    pub(super) fn next(&mut self, pool: &mut Pool) -> Point {
        let round = self.round;
        self.round += 1;
        let mut point: Point = Point::default();
        for (place, &argument) in self.arguments.iter().enumerate() {
            let values = &self.values[place];
            let index = if self.arguments.len() == 1 {
                round % values.len()
            } else {
                // the simplest values are drawn most often
                let random = self.random.next();
                let most = if random & 1 == 0 { values.len().min(4) } else { values.len() };
                (random >> 8) as usize % most
            };
            point.insert(argument, values[index]);
        }
        if round % 2 == 1 && !self.solutions.is_empty() {
            let (argument, value) = self.solutions[(round / 2) % self.solutions.len()];
            let value = pool.substitute(value, &point);
            point.insert(argument, value);
        }
        point
    }
}

/// Returns the variables that occur in the argument of a sine, cosine or tangent.
fn in_angles(pool: &Pool, expressions: &[Expr]) -> FxHashSet<Symbol> {
    let mut found = FxHashSet::default();
    for part in pool.reachable(expressions) {
        if let Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, q) = pool.node(part) {
            found.extend(pool.symbols_in(&[q[0]]));
        }
    }
    found
}

/// Solves for the arguments at which expressions vanish, in terms of the other arguments.
fn solutions(pool: &mut Pool, arguments: &[Symbol], zeros: &[Expr]) -> Vec<(Symbol, Expr)> {
    let zero = pool.integer(0);
    let mut found: Vec<(Symbol, Expr)> = Vec::new();
    for &left in zeros {
        let condition = Condition { left, relation: Relation::LessEqual, right: zero };
        let mut count = 0;
        for sheet in sheets(pool, &condition) {
            for solution in sheet.solutions(pool, &[]) {
                let Node::Symbol(symbol) = *pool.node(solution.part) else { continue };
                for (value, _) in solution.values {
                    if arguments.contains(&symbol)
                        && count < MOST_SOLUTIONS
                        && !found.contains(&(symbol, value))
                    {
                        count += 1;
                        found.push((symbol, value));
                    }
                }
            }
        }
    }
    found
}
