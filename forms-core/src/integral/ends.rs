//! Values of an antiderivative at the ends of the range, with inverse functions of special values
//! expressed in π.

use super::normal_form;
use super::signs::Region;
use crate::expression::{Expr, Node, Operation, Pool, Rational, Substitution, Symbol};
use crate::normal::{Tower, Trigonometry};
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Two fractions: q² for some q ≥ 0, and the angle in units of π.
type Special = ((i64, i64), (i64, i64));

/// q² and atan q/π for q ≥ 0
const TANGENTS: &[Special] = &[((0, 1), (0, 1)), ((1, 3), (1, 6)), ((1, 1), (1, 4)), ((3, 1), (1, 3))];

/// q² and asin q/π for q ≥ 0
const SINES: &[Special] =
    &[((0, 1), (0, 1)), ((1, 4), (1, 6)), ((1, 2), (1, 4)), ((3, 4), (1, 3)), ((1, 1), (1, 2))];

impl Region {
    /// Returns the expression at one value of the variable.
    pub(super) fn value_at(&self, pool: &mut Pool, expression: Expr, variable: Symbol, place: Expr) -> Expr {
        let values: Substitution = [(variable, place)].into_iter().collect();
        let value = pool.substitute(expression, &values);
        let mut known: FxHashMap<Expr, Expr> = FxHashMap::default();
        for part in pool.reachable(&[value]) {
            let Node::Apply(operation, arguments) = pool.node(part).clone() else { continue };
            let argument = pool.replace(arguments[0], &known);
            let special = match operation {
                Operation::Atan => self.special_angle(pool, argument, TANGENTS),
                Operation::Asin => self.special_angle(pool, argument, SINES),
                Operation::Tan => self.special_tangent(pool, argument),
                _ => None,
            };
            if let Some(special) = special {
                known.insert(part, special);
            }
        }
        pool.replace(value, &known)
    }

    /// Returns tan(rπ) for the multiples of π in the table.
    fn special_tangent(&self, pool: &mut Pool, q: Expr) -> Option<Expr> {
        let pi = pool.pi();
        let turns = pool.divide(q, pi);
        let mut tower = Tower::new(Trigonometry::Circle);
        let turns = normal_form(pool, &mut tower, turns, &self.conditions).ok()?.as_number()?;
        let entry =
            TANGENTS.iter().find(|(_, (p, n))| Rational::new((*p).into(), (*n).into()) == turns.abs())?;
        let square = pool.ratio(entry.0.0, entry.0.1);
        let value = if pool.is_zero(square) { square } else { pool.sqrt(square) };
        Some(if turns.is_negative() { pool.negate(value) } else { value })
    }

    fn special_angle(&self, pool: &mut Pool, q: Expr, table: &[Special]) -> Option<Expr> {
        let square = pool.power(q, 2.into());
        let mut is_square = |((p, n), _): &&Special| {
            let value = pool.ratio(*p, *n);
            let difference = pool.subtract(square, value);
            let mut tower = Tower::new(Trigonometry::Circle);
            normal_form(pool, &mut tower, difference, &self.conditions).is_ok_and(|normal| normal.is_zero())
        };
        let (p, n) = table.iter().find(|entry| is_square(entry))?.1;
        let share = pool.ratio(p, n);
        let pi = pool.pi();
        let angle = pool.multiply(share, pi);
        if p == 0 {
            return Some(angle);
        }
        Some(if self.sign(pool, q)?.0 { angle } else { pool.negate(angle) })
    }
}
