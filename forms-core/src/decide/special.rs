//! Points on thin strata: where a condition is an equation, or an angle is a multiple of a quarter
//! turn.
//!
//! ```text
//! weak conditions, angles ─▶ equations e = 0 ─ solved for a variable ─▶ s = v ─▶ the problem with v substituted for s
//! ```
//! Random points miss such strata, and an enclosure of cos π does not decide 1 + cos π <= 0. With v
//! substituted for s each side is brought to its normal form, which is exact, so that the search
//! for points decides such conditions.

use super::problem::{Component, Problem};
use super::report::simplified;
use super::witness::{Difference, Found, Search};
use crate::enclosure::{Precision, enclose_number};
use crate::expression::{
    Condition, Expr, Nature, Node, Operation, Pool, Rational, Relation, Substitution, Symbol,
};
use rustc_hash::FxHashMap;

/// Limit on the number of strata.
const MOST_STRATA: usize = 48;

/// Candidate points tried on each stratum.
const CANDIDATES: usize = 8;

/// Extrema are searched for only for conditions with at most this number of variables.
const MOST_VARIABLES: usize = 4;

const PRECISION: Precision = Precision(128);

/// Angles in quarter turns, the poles of half-angle tangents first.
const QUARTERS: &[i64] = &[2, 0, 1, -1, -2, 3, 4, 6, -6];

/// Result of the search on thin strata.
#[derive(Default)]
pub(super) struct Seen {
    /// Number of points at which everything holds and no difference is certain.
    pub(super) points: usize,
    /// A point at which the sides differ.
    pub(super) difference: Option<Difference>,
}

/// Tries points on the strata of a problem.
pub(super) fn look(pool: &mut Pool, problem: &Problem) -> Seen {
    let mut seen = Seen::default();
    for equation in equations(pool, problem).into_iter().take(MOST_STRATA) {
        let Some(stratum) = Stratum::of(pool, problem, &equation) else { continue };
        let mut search = Search::new(pool, &stratum.problem, 0);
        for _ in 0..CANDIDATES {
            match search.next() {
                Found::NoPoint => {}
                Found::Agrees => {
                    seen.points += 1;
                    break;
                }
                Found::Differs(difference) => {
                    seen.difference = Some(stratum.located(pool, difference));
                    return seen;
                }
            }
        }
    }
    seen
}

/// Returns lists of expressions that vanish together: squares of a sum, factors of weak conditions,
/// and distances of angles from quarter turns.
fn equations(pool: &mut Pool, problem: &Problem) -> Vec<Vec<Expr>> {
    let mut found: Vec<Vec<Expr>> = Vec::new();
    let mut add = |equation: Vec<Expr>| {
        if !found.contains(&equation) {
            found.push(equation);
        }
    };
    for condition in &problem.assumptions {
        if matches!(condition.relation, Relation::LessEqual | Relation::GreaterEqual) {
            let difference = pool.subtract(condition.left, condition.right);
            for factor in pool.factors_that_may_vanish(difference) {
                add(vanishing_together(pool, factor));
            }
        }
    }
    for interior in interiors(pool, problem) {
        add(interior);
    }
    for angle in angles(pool, problem) {
        for &quarters in QUARTERS {
            let (share, pi) = (pool.ratio(quarters, 2), pool.pi());
            let target = pool.multiply(share, pi);
            add(vec![pool.subtract(angle, target)]);
        }
    }
    found
}

/// Returns equations of points inside narrow domains far from the origin: the argument of an
/// inverse function is 0 or ±1/2, or a condition is at its extremum.
fn interiors(pool: &mut Pool, problem: &Problem) -> Vec<Vec<Expr>> {
    let mut found = Vec::new();
    for part in pool.reachable(&sides(problem)) {
        if let Node::Apply(Operation::Asin | Operation::Acos, of) = pool.node(part) {
            let argument = of[0];
            for (p, q) in [(0, 1), (1, 2), (-1, 2)] {
                let target = pool.ratio(p, q);
                found.push(vec![pool.subtract(argument, target)]);
            }
        }
    }
    for condition in &problem.assumptions {
        let difference = pool.subtract(condition.left, condition.right);
        let symbols = pool.symbols_in(&[difference]);
        if symbols.len() <= MOST_VARIABLES {
            found.push(symbols.into_iter().map(|symbol| pool.derivative(difference, symbol)).collect());
        }
    }
    found
}

/// Returns the sides of the components and of the conditions.
fn sides(problem: &Problem) -> Vec<Expr> {
    let sides = problem.components.iter().flat_map(|c| [c.left, c.right]);
    sides.chain(problem.assumptions.iter().flat_map(|c| [c.left, c.right])).collect()
}

/// Returns the expressions that have to vanish for a factor to vanish: both parts of a sum of
/// squares or magnitudes, and the argument of a magnitude.
pub(super) fn vanishing_together(pool: &Pool, factor: Expr) -> Vec<Expr> {
    match pool.node(factor) {
        Node::Add(a, b) if pool.nature(*a) != Nature::Open && pool.nature(*b) != Nature::Open => {
            [vanishing_together(pool, *a), vanishing_together(pool, *b)].concat()
        }
        Node::Apply(Operation::Abs, of) => vanishing_together(pool, of[0]),
        Node::Power(base, _) => vanishing_together(pool, *base),
        _ => vec![factor],
    }
}

/// Returns the arguments of the sines, cosines and tangents of a problem.
fn angles(pool: &Pool, problem: &Problem) -> Vec<Expr> {
    let mut angles: Vec<Expr> = Vec::new();
    for part in pool.reachable(&sides(problem)) {
        if let Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, of) = pool.node(part)
            && !angles.contains(&of[0])
        {
            angles.push(of[0]);
        }
    }
    angles
}

/// A problem with expressions substituted for variables.
pub(super) struct Stratum {
    pub(super) problem: Problem,
    values: Vec<(Symbol, Expr)>,
}

impl Stratum {
    /// Returns the stratum on which expressions vanish; `None` if one of them cannot be solved for
    /// a variable.
    pub(super) fn of(pool: &mut Pool, problem: &Problem, equations: &[Expr]) -> Option<Stratum> {
        let mut values: Vec<(Symbol, Expr)> = Vec::new();
        for &equation in equations {
            let known: Substitution = values.iter().copied().collect();
            let equation = pool.substitute(equation, &known);
            if pool.is_zero(equation) {
                continue;
            }
            let (symbol, value) = solved(pool, equation)?;
            let one: Substitution = [(symbol, value)].into_iter().collect();
            for known in &mut values {
                known.1 = pool.substitute(known.1, &one);
            }
            values.push((symbol, value));
        }
        let substitution: Substitution = values.iter().copied().collect();
        let problem = mapped(pool, problem, |pool, expression| pool.substitute(expression, &substitution));
        Some(Stratum { problem, values })
    }

    /// Adds the values of the solved variables to the point of a difference. A variable that no
    /// longer occurs in the problem can have any value.
    fn located(&self, pool: &mut Pool, mut difference: Difference) -> Difference {
        for &(symbol, value) in &self.values {
            let mut places = Substitution::default();
            for other in pool.symbols_in(&[value]) {
                let name = pool.symbol_name(other).to_string();
                let known = difference.point.iter().find(|(known, _)| *known == name);
                let number = known.and_then(|(_, text)| text.parse::<Rational>().ok()).unwrap_or_default();
                if known.is_none() {
                    difference.point.push((name, number.to_string()));
                }
                places.insert(other, pool.number(number));
            }
            let value = pool.substitute(value, &places);
            let value = simplified(pool, value);
            difference.point.push((pool.symbol_name(symbol).to_string(), pool.text(value)));
        }
        difference
    }
}

/// Maps each side of the problem and brings the image to its normal form.
pub(super) fn mapped(pool: &mut Pool, problem: &Problem, image: impl Fn(&mut Pool, Expr) -> Expr) -> Problem {
    let mut image = |expression: Expr| {
        let image = image(pool, expression);
        simplified(pool, image)
    };
    let mut components = Vec::new();
    for Component { label, left, right, difference } in &problem.components {
        let (left, right, difference) = (image(*left), image(*right), image(*difference));
        components.push(Component { label: label.clone(), left, right, difference });
    }
    let mut assumptions = Vec::new();
    for Condition { left, relation, right } in &problem.assumptions {
        let (left, right) = (image(*left), image(*right));
        assumptions.push(Condition { left, relation: *relation, right });
    }
    let identical = problem.identical.iter().map(|&side| image(side)).collect();
    Problem { components, identical, assumptions, stated: problem.stated }
}

/// Returns s and v if e = 0 means s = v: e is linear in s as it is written, and its slope is a
/// nonzero number. The derivative alone is not enough: the derivative of atan(tan s) is 1, but the
/// expression is zero at all multiples of π.
pub(super) fn solved(pool: &mut Pool, equation: Expr) -> Option<(Symbol, Expr)> {
    for symbol in pool.symbols_in(&[equation]) {
        if !is_linear(pool, equation, symbol) {
            continue;
        }
        let slope = pool.derivative(equation, symbol);
        let slope = simplified(pool, slope);
        if !enclose_number(pool, slope, PRECISION)
            .is_ok_and(|slope| slope.is_positive() || slope.is_negative())
        {
            continue;
        }
        let origin: Substitution = [(symbol, pool.integer(0))].into_iter().collect();
        let rest = pool.substitute(equation, &origin);
        let quotient = pool.divide(rest, slope);
        let value = pool.negate(quotient);
        return Some((symbol, simplified(pool, value)));
    }
    None
}

/// Whether an expression is a sum of terms without a symbol and of multiples of it by such terms:
/// its degree in the symbol, computed once for each shared part, is at most 1. Any other operation
/// on the symbol counts as degree 2.
fn is_linear(pool: &Pool, expression: Expr, symbol: Symbol) -> bool {
    let mut degrees: FxHashMap<Expr, u32> = FxHashMap::default();
    for part in pool.reachable(&[expression]) {
        let of = |operand: &Expr| degrees[operand];
        let degree = match pool.node(part) {
            Node::Symbol(own) => u32::from(*own == symbol),
            Node::Negate(a) => of(a),
            Node::Add(a, b) => of(a).max(of(b)),
            Node::Multiply(a, b) => of(a) + of(b),
            Node::Divide(a, b) if of(b) == 0 => of(a),
            node => {
                let mut is_free = true;
                node.for_each_operand(|operand| is_free &= degrees[&operand] == 0);
                if is_free { 0 } else { 2 }
            }
        };
        degrees.insert(part, degree.min(2));
    }
    degrees[&expression] <= 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::resolve::resolve;
    use crate::syntax::read;
    use crate::theory::Value;

    /// Returns the value that e = 0 gives a variable.
    fn solution_of(equation: &str) -> Option<String> {
        let (file, errors) = read(&format!("chart L(x, y, z); let e = {equation};"));
        assert!(errors.is_empty(), "{equation}");
        let (mut theory, errors) = resolve(&file);
        assert!(errors.is_empty(), "{equation}");
        let Value::Scalar(expression) = theory.objects[0].value else { panic!("{equation} is a scalar") };
        solved(&mut theory.pool, expression).map(|(symbol, value)| {
            format!("{} = {}", theory.pool.symbol_name(symbol), theory.pool.text(value))
        })
    }

    #[test]
    fn an_equation_that_is_linear_as_written_has_one_solution() {
        for (equation, solution) in [
            ("2*x - 3", "x = 3/2"),
            ("x/2 + y*z", "x = -2*y*z"),
            ("y*z*x + 3*y - 4*z + x**2 - y", "none"),
            ("x**2 + sin(x) - y", "y = x**2 + sin(x)"),
            ("pi*x - 1", "x = 1/pi"),
        ] {
            assert_eq!(solution_of(equation).unwrap_or_else(|| "none".into()), solution, "{equation}");
        }
    }

    #[test]
    fn an_equation_with_a_constant_derivative_may_have_more_than_one_solution() {
        for equation in [
            "atan(tan(x))",
            "2*atan(tan(x/2)) - 1",
            "atan2(sin(x), cos(x))",
            "asin(sin(x))*2 + atan(tan(x))",
            "acos(cos(x))",
            "atan(x) + atan(1/x) + x",
            "abs(x) - 1",
            "log(exp(x)) - 1",
        ] {
            assert_eq!(solution_of(equation), None, "{equation}");
        }
    }
}
