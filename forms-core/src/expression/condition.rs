//! Relations between expressions: `where` conditions, and conditions under which an expression is
//! defined.

use super::node::Expr;
use super::pool::Pool;
use super::substitution::Substitution;
use crate::expression::Relation;

/// A relation between two expressions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Condition {
    /// The left side.
    pub left: Expr,
    /// The relation.
    pub relation: Relation,
    /// The right side.
    pub right: Expr,
}

impl Condition {
    /// Returns the condition in the language's own notation.
    pub fn text(&self, pool: &Pool) -> String {
        format!("{} {} {}", pool.text(self.left), self.relation.text(), pool.text(self.right))
    }

    /// Decides the condition if both sides are numbers.
    pub fn decided(&self, pool: &Pool) -> Option<bool> {
        let (left, right) = (pool.as_number(self.left)?, pool.as_number(self.right)?);
        Some(self.relation.admits(left.cmp(right)))
    }

    /// Replaces every variable of the condition simultaneously.
    #[must_use]
    pub fn substitute(&self, pool: &mut Pool, values: &Substitution) -> Self {
        let sides = pool.substitute_all(&[self.left, self.right], values);
        Condition { left: sides[0], relation: self.relation, right: sides[1] }
    }
}
