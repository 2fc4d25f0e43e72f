//! Domains of expressions: the condition under which each operation is real, and whether it holds
//! near points that a proof omits.
//!
//! An operation whose condition holds is continuous there, in all its operands. A condition with
//! `>` or `≠` is open: it holds in a neighbourhood of every point at which it holds. A condition
//! with `≥`, of a root or an arc sine, can fail arbitrarily near such a point.

use crate::expression::Expr;
use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::rational;
use crate::field::{Field, Kind};
use crate::sign::Seen;
use crate::theory::{Condition, Relation, Statement, Theory};
use crate::{Stop, rejected, uncovered};
use std::collections::BTreeSet;

impl Theory {
    /// Returns the condition on its operands under which an operation is real; `None` if it is real
    /// for all.
    pub(crate) fn need(&mut self, part: Expr) -> Result<Option<Condition>, Stop> {
        let (operation, a) = (self.pool.node(part).0.clone(), self.pool.node(part).1.to_vec());
        Ok(match operation {
            Divide => Some((a[1], Relation::NotZero)),
            Power(p, 1) => (p < 0).then(|| (a[0], Relation::NotZero)),
            Power(p, _) => Some((a[0], if p < 0 { Relation::Positive } else { Relation::NotNegative })),
            Function("tan") => Some((self.pool.make(Function("cos"), a), Relation::NotZero)),
            Function("log") => match self.pool.node(a[0]) {
                (Function("abs"), inner) => Some((inner[0], Relation::NotZero)),
                _ => Some((a[0], Relation::Positive)),
            },
            Function("asin") => {
                let (one, square) =
                    (self.pool.number(rational(1, 1)), self.pool.make(Power(2, 1), vec![a[0]]));
                Some((self.difference(one, square), Relation::NotNegative))
            }
            // smooth where it is declared, which need not be everywhere
            Jet(f, _) if !self.functions[f].1.is_empty() => {
                return uncovered("a function with a condition where the statement does not have it");
            }
            Function(_) | Jet(..) | Number(_) | Pi | Variable(_) | Add | Multiply => None,
        })
    }

    /// Whether a condition that holds at a point holds in a neighbourhood: it is strict, and its
    /// expression is defined in a neighbourhood.
    pub(crate) fn is_open(&mut self, (q, relation): Condition) -> Result<bool, Stop> {
        if relation == Relation::NotNegative {
            return Ok(false);
        }
        for part in self.pool.parts(&[q]) {
            if let Ok(Some((inner, Relation::NotNegative))) = self.need(part)
                && self.seen(inner, &[])? == Seen::Nothing
            {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Checks that every point of the statement is a limit of its points at which no cosine of the
    /// units is −1.
    ///
    /// Each unit is a number times a product of powers of variables. Those variables are perturbed,
    /// the others are fixed. Open conditions continue to hold. A non-strict condition also
    /// continues to hold if it does not depend on the perturbed variables, or if it is shown by
    /// conditions that continue to hold. The points at which a cosine is −1 are zeros of an
    /// analytic function that is not identically zero, so other points are arbitrarily near; both
    /// sides are continuous there.
    pub(crate) fn check_dense(&mut self, statement: &Statement, units: &[Expr]) -> Result<(), Stop> {
        let moved: BTreeSet<usize> = units.iter().flat_map(|unit| self.pool.variables(*unit)).collect();
        let stands = |theory: &Theory, q: Expr| theory.pool.variables(q).is_disjoint(&moved);
        let mut closed: Vec<Expr> = Vec::new();
        for part in &statement.nodes {
            if let Some((q, Relation::NotNegative)) = self.need(*part).unwrap_or(None) {
                closed.push(q);
            }
        }
        let conditions = statement.conditions.iter().filter(|condition| condition.1 == Relation::NotNegative);
        closed.extend(conditions.map(|condition| condition.0));
        closed.retain(|q| !stands(self, *q));
        let mut known: Vec<Condition> = Vec::new();
        for condition in &statement.conditions {
            if stands(self, condition.0) || self.is_open(*condition)? {
                known.push(*condition);
            }
        }
        let mut field = Field::default();
        for unit in units {
            let value = field.element(&self.pool, *unit)?;
            field.declare(Kind::Circle, &value)?;
        }
        for q in closed {
            if !field.shows(&mut self.pool, (q, Relation::NotNegative), &known)? {
                return rejected(
                    "a half angle excludes points that were not shown to be limits of others: a non-strict condition \
                     depends on the angle",
                );
            }
        }
        Ok(())
    }
}
