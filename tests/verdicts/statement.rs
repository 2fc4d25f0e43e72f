//! Statements: two sides, and the conditions under which they are claimed to be equal.

use crate::dice::Dice;
use crate::notation;
use crate::tree::{Tree, number};
use std::fmt;

/// The two sides of an equation.
pub(crate) type Equation = [Tree; 2];

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Relation {
    Less,
    LessEqual,
    NotEqual,
}

/// Relation between two expressions.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Condition {
    pub(crate) left: Tree,
    pub(crate) relation: Relation,
    pub(crate) right: Tree,
}

impl Condition {
    pub(crate) fn less(left: &Tree, right: &Tree) -> Self {
        Condition { left: left.clone(), relation: Relation::Less, right: right.clone() }
    }
    pub(crate) fn less_equal(left: &Tree, right: &Tree) -> Self {
        Condition { relation: Relation::LessEqual, ..Condition::less(left, right) }
    }
    pub(crate) fn not_equal(left: &Tree, right: &Tree) -> Self {
        Condition { relation: Relation::NotEqual, ..Condition::less(left, right) }
    }
    pub(crate) fn positive(tree: &Tree) -> Self {
        Condition::less(&number(0), tree)
    }
}

impl fmt::Display for Condition {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let relation = match self.relation {
            Relation::Less => "<",
            Relation::LessEqual => "<=",
            Relation::NotEqual => "!=",
        };
        write!(f, "{} {relation} {}", self.left, self.right)
    }
}

/// Equation with conditions.
#[derive(Clone, Debug)]
pub(crate) struct Statement {
    pub(crate) sides: Equation,
    pub(crate) conditions: Vec<Condition>,
}

impl From<Equation> for Statement {
    fn from(sides: Equation) -> Self {
        Statement { sides, conditions: Vec::new() }
    }
}

impl Statement {
    pub(crate) fn new(sides: Equation, conditions: impl IntoIterator<Item = Condition>) -> Self {
        Statement { sides, conditions: conditions.into_iter().collect() }
    }

    /// Returns the text of a file with this statement.
    pub(crate) fn source(&self) -> String {
        let statement = self.to_string();
        let maps = notation::declarations(&statement);
        format!("chart P(x, y); param a, b where a > 0, b > 0; {maps}prove s: {statement};")
    }

    /// Returns a random side.
    pub(crate) fn expression(&mut self, dice: &mut Dice) -> &mut Tree {
        &mut self.sides[dice.below(2) as usize]
    }
}

impl fmt::Display for Statement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} == {}", self.sides[0], self.sides[1])?;
        for (place, condition) in self.conditions.iter().enumerate() {
            write!(f, "{}{condition}", if place == 0 { " where " } else { ", " })?;
        }
        Ok(())
    }
}
