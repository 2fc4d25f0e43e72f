//! A statement decomposed into one difference per component and the conditions that its points
//! satisfy.

use crate::calculus::Blade;
use crate::expression::{Condition, Expr, Pool};
use crate::theory::{Statement, Theory, Value};
use std::collections::BTreeMap;

/// One component of an equation.
#[derive(Clone, Debug)]
pub(super) struct Component {
    /// Name of the component: `dx^dy`, `@x`, or empty for a scalar.
    pub(super) label: String,
    pub(super) left: Expr,
    pub(super) right: Expr,
    pub(super) difference: Expr,
}

/// Equations to decide, with their assumptions.
pub(super) struct Problem {
    /// The components whose sides are not the same expression.
    pub(super) components: Vec<Component>,
    /// The common sides of the other components.
    pub(super) identical: Vec<Expr>,
    /// The `where` conditions, then the conditions under which both sides are defined.
    pub(super) assumptions: Vec<Condition>,
    /// Number of assumptions that come from a `where`.
    pub(super) stated: usize,
}

impl Problem {
    pub(super) fn new(theory: &mut Theory, statement: &Statement) -> Self {
        let sides = paired(theory, &statement.left, &statement.right);
        Problem::of_components(&mut theory.pool, sides, &statement.conditions, &statement.domain)
    }

    /// Creates the problem of scalar equations, wherever both sides are defined and the conditions
    /// hold.
    pub(super) fn of_scalars(pool: &mut Pool, sides: &[(Expr, Expr)], conditions: &[Condition]) -> Self {
        let mut expressions: Vec<Expr> = conditions.iter().flat_map(|c| [c.left, c.right]).collect();
        expressions.extend(sides.iter().flat_map(|&(left, right)| [left, right]));
        let domain = pool.domain(&expressions);
        let sides = sides.iter().map(|&(left, right)| (String::new(), left, right)).collect();
        Problem::of_components(pool, sides, conditions, &domain)
    }

    fn of_components(
        pool: &mut Pool,
        sides: Vec<(String, Expr, Expr)>,
        conditions: &[Condition],
        domain: &[Condition],
    ) -> Self {
        let (mut components, mut identical) = (Vec::new(), Vec::new());
        for (label, left, right) in sides {
            let difference = pool.subtract(left, right);
            if pool.is_zero(difference) {
                identical.push(left);
            } else {
                components.push(Component { label, left, right, difference });
            }
        }
        let mut assumptions: Vec<Condition> = Vec::new();
        for condition in conditions {
            if !assumptions.contains(condition) {
                assumptions.push(*condition);
            }
        }
        let stated = assumptions.len();
        assumptions.extend(domain.iter().filter(|condition| !conditions.contains(condition)));
        Problem { components, identical, assumptions, stated }
    }

    pub(super) fn differences(&self) -> Vec<Expr> {
        self.components.iter().map(|component| component.difference).collect()
    }
}

/// Pairs the components of two values; a component that one side lacks is zero.
fn paired(theory: &mut Theory, left: &Value, right: &Value) -> Vec<(String, Expr, Expr)> {
    let zero = theory.pool.integer(0);
    let mut sides: BTreeMap<(Blade, String), [Expr; 2]> = BTreeMap::new();
    for (place, value) in [left, right].into_iter().enumerate() {
        for (key, scalar) in labelled(theory, value) {
            sides.entry(key).or_insert([zero, zero])[place] = scalar;
        }
    }
    sides.into_iter().map(|((_, label), [left, right])| (label, left, right)).collect()
}

fn labelled(theory: &Theory, value: &Value) -> Vec<((Blade, String), Expr)> {
    match value {
        Value::Zero => vec![],
        Value::Scalar(scalar) => vec![((Blade::SCALAR, String::new()), *scalar)],
        // the sides of a statement are not arrays
        Value::Array(_) => vec![],
        Value::Form(form) => form
            .terms()
            .iter()
            .map(|(blade, scalar)| ((*blade, theory.blade_text(*blade)), *scalar))
            .collect(),
        Value::Field(field) => field
            .components()
            .map(|(coordinate, scalar)| {
                ((Blade::of(coordinate), format!("@{}", theory.coordinate_name(coordinate))), *scalar)
            })
            .collect(),
    }
}
