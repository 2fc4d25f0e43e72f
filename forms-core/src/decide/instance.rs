//! Instances of problems with integrals of unknown functions: polynomials replace the functions.
//!
//! ```text
//! f, g, Φ = ∫ f g  ─▶  f = 1 + 2s + …, g = 3 + s + …  ─▶  Φ integrated exactly
//! ```
//! The values of an unknown function and the values of its integrals are not independent (∫ f² is
//! not negative), so they are not chosen one by one: a refutation names the functions.

use super::problem::{Component, Problem};
use crate::expression::{Condition, Expr, FunctionId, Node, Pool, Substitution};
use crate::integral::Region;
use rustc_hash::FxHashMap;
use std::ops::Range;

/// Choices of functions: the first one, and the ones that are tried when the first decides nothing.
pub(super) const FIRST_CHOICE: Range<u64> = 0..1;
pub(super) const MORE_CHOICES: Range<u64> = 1..3;

/// Functions of more variables are replaced by polynomials with fewer terms.
const FEW_VARIABLES: usize = 2;

/// A problem to search for points.
pub(super) struct Instance {
    pub(super) problem: Problem,
    /// Unknown functions with the polynomials that replace them.
    pub(super) functions: Vec<(String, String)>,
    /// Whether a point at which the sides differ refutes the statement.
    pub(super) refutes: bool,
}

/// Returns the instances of a problem in which functions stand for integrals. `None` if there is no
/// such function: then only values and derivatives at the points matter.
pub(super) fn instances(pool: &mut Pool, problem: &Problem, choices: Range<u64>) -> Option<Vec<Instance>> {
    let mut expressions = problem.differences();
    let conditions = problem.assumptions.iter().flat_map(|c| [c.left, c.right]);
    let in_conditions = has_primitives(pool, &conditions.collect::<Vec<_>>());
    expressions.extend(problem.components.iter().flat_map(|c| [c.left, c.right]));
    if !in_conditions && !has_primitives(pool, &expressions) {
        return None;
    }
    let mut found: Vec<Instance> = choices.filter_map(|choice| instance(pool, problem, choice)).collect();
    if found.is_empty() && !in_conditions {
        // the conditions contain no integrals, so a point that meets them is valid whatever the
        // integrals are
        let problem = copied(problem, |expression| expression);
        found.push(Instance { problem, functions: vec![], refutes: false });
    }
    Some(found)
}

fn has_primitives(pool: &Pool, expressions: &[Expr]) -> bool {
    pool.reachable(expressions)
        .into_iter()
        .any(|part| matches!(pool.node(part), Node::Jet { function, .. } if pool.is_primitive(*function)))
}

fn instance(pool: &mut Pool, problem: &Problem, choice: u64) -> Option<Instance> {
    let mut functions = Functions { choice, known: FxHashMap::default(), conditions: vec![] };
    let mut expressions: Vec<Expr> =
        problem.components.iter().flat_map(|c| [c.left, c.right, c.difference]).collect();
    expressions.extend(problem.assumptions.iter().flat_map(|c| [c.left, c.right]));
    let images = functions.all(pool, &expressions)?;
    let images: FxHashMap<Expr, Expr> = expressions.into_iter().zip(images).collect();
    let mut problem = copied(problem, |expression| images.get(&expression).copied().unwrap_or(expression));
    problem.assumptions.append(&mut functions.conditions);
    let mut known: Vec<(FunctionId, Expr)> = functions.known.into_iter().collect();
    known.sort_unstable();
    let functions = known
        .into_iter()
        .map(|(function, value)| (pool.function(function).name.clone(), pool.text(value)))
        .collect();
    Some(Instance { problem, functions, refutes: true })
}

fn copied(problem: &Problem, image: impl Fn(Expr) -> Expr) -> Problem {
    let component = |component: &Component| Component {
        label: component.label.clone(),
        left: image(component.left),
        right: image(component.right),
        difference: image(component.difference),
    };
    let condition = |condition: &Condition| Condition {
        left: image(condition.left),
        relation: condition.relation,
        right: image(condition.right),
    };
    Problem {
        components: problem.components.iter().map(component).collect(),
        identical: problem.identical.clone(),
        assumptions: problem.assumptions.iter().map(condition).collect(),
        stated: problem.stated,
    }
}

/// The functions chosen so far.
struct Functions {
    choice: u64,
    known: FxHashMap<FunctionId, Expr>,
    /// Conditions under which the integrals have their values.
    conditions: Vec<Condition>,
}

impl Functions {
    /// Returns the expressions with the chosen functions substituted; `None` if one of their
    /// integrals is not known.
    fn all(&mut self, pool: &mut Pool, expressions: &[Expr]) -> Option<Vec<Expr>> {
        let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
        for expression in pool.reachable(expressions) {
            let node = pool.node(expression).clone();
            let image = match &node {
                Node::Jet { function, orders, arguments } if pool.quadrature_of(*function).is_none() => {
                    let places: Vec<Expr> = arguments.iter().map(|argument| images[argument]).collect();
                    if pool.is_primitive(*function) {
                        self.integral(pool, *function, orders, &places)?
                    } else {
                        self.value(pool, *function, orders, &places)
                    }
                }
                _ => pool.image(expression, node, &images),
            };
            images.insert(expression, image);
        }
        Some(expressions.iter().map(|expression| images[expression]).collect())
    }

    /// Returns a derivative of the polynomial that replaces a function.
    fn value(&mut self, pool: &mut Pool, function: FunctionId, orders: &[u32], places: &[Expr]) -> Expr {
        let symbols = pool.function(function).arguments.clone();
        let mut value = match self.known.get(&function) {
            Some(&known) => known,
            None => {
                let chosen = self.polynomial(pool, function);
                self.known.insert(function, chosen);
                chosen
            }
        };
        for (&symbol, &order) in symbols.iter().zip(orders) {
            (0..order).for_each(|_| value = pool.derivative(value, symbol));
        }
        let values: Substitution = symbols.into_iter().zip(places.iter().copied()).collect();
        pool.substitute(value, &values)
    }

    /// Returns c + Σ (cᵢxᵢ + cᵢ′xᵢ²) + Σ cᵢⱼxᵢxⱼ with small coefficients, and for one variable also
    /// c″x⁴: no quadrature rule with few points is exact for all of these. With more than
    /// `FEW_VARIABLES` variables there are no squares, only neighbours are multiplied, and in the
    /// first choice not even these.
    fn polynomial(&self, pool: &mut Pool, function: FunctionId) -> Expr {
        let symbols = pool.function(function).arguments.clone();
        let variables: Vec<Expr> = symbols.iter().map(|&symbol| pool.symbol(symbol)).collect();
        let mut terms = vec![pool.integer(1)];
        for (place, &x) in variables.iter().enumerate() {
            terms.push(x);
            if variables.len() <= FEW_VARIABLES {
                terms.push(pool.power(x, 2.into()));
                terms.extend(variables[..place].iter().map(|&y| pool.multiply(x, y)));
            } else if place > 0 && self.choice > 0 {
                terms.push(pool.multiply(x, variables[place - 1]));
            }
        }
        if let [x] = variables[..] {
            terms.push(pool.power(x, 4.into()));
        }
        let mut state = self.choice.wrapping_mul(31).wrapping_add(7 * u64::from(function.0) + 3);
        let mut sum = pool.integer(0);
        for term in terms {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let coefficient = pool.integer(1 + ((state >> 40) % 5) as i64);
            let scaled = pool.multiply(coefficient, term);
            sum = pool.add(sum, scaled);
        }
        sum
    }

    /// Returns the integral that a primitive stands for.
    fn integral(
        &mut self,
        pool: &mut Pool,
        function: FunctionId,
        orders: &[u32],
        places: &[Expr],
    ) -> Option<Expr> {
        let (integrand, variables) = pool.primitive_integrand_at(function, orders, places)?;
        let mut value = self.all(pool, &[integrand])?[0];
        let zero = pool.integer(0);
        let ranges =
            variables.into_iter().zip(places).map(|(variable, &end)| (variable, zero, end)).collect();
        let mut region = Region { ranges, conditions: vec![] };
        while !region.ranges.is_empty() {
            let found = region.integral(pool, value).ok()?;
            self.conditions.extend(found.conditions);
            value = found.value;
            region.forget_innermost(pool);
        }
        Some(value)
    }
}
