//! Relations between inverse trigonometric functions: m α + n β = (k/12)π, found at a point and
//! proved.
//!
//! ```text
//! arcs ─ values at one point ─▶ candidates ─ proved as angles ─▶ β replaced by ((k/12)π − m α)/n
//! ```
//! α is another inverse function or an angle whose sine, cosine or tangent occurs in the argument
//! of β: asin(sin x) is x, or π − x, depending on the conditions on x.
//!
//! The values only suggest candidates; a replacement is made only if it is proved wherever the
//! conditions hold.

use super::angle::prove_angle;
use super::goal::{Outcome, Task};
use super::problem::Problem;
use super::sample::{Sequence, simple_bounds};
use crate::enclosure::{Enclosure, Precision, enclose};
use crate::expression::{Expr, Node, Operation, Pool, Rational};
use crate::normal::is_arc;

/// Largest number of inverse functions between which relations are searched for.
const MOST_ARCS: usize = 8;

/// Largest number of angles whose sums and differences are also tried.
const MOST_COMBINED: usize = 3;

/// Points tried in the search for one at which all functions have values.
const POINTS: u32 = 64;

/// Divisor of the work limit for the proof of one candidate: most candidates are wrong.
const SHARE: u64 = 16;

const PRECISION: Precision = Precision(96);

/// The multiples m, n of a relation; the second function is replaced, so n is 1 or −1.
const MULTIPLES: &[(i64, i64)] = &[(1, 1), (1, -1), (2, 1), (2, -1), (3, 1), (3, -1)];

/// The right side of a relation is a multiple of π divided by this.
const PARTS: i64 = 12;

/// Replaces the inverse functions in an expression that depend on others.
pub(super) fn eliminated(pool: &mut Pool, task: Task, expression: Expr, shown: &mut Vec<Expr>) -> Expr {
    let mut arcs = arcs_in(pool, expression);
    if arcs.len() > MOST_ARCS {
        return expression;
    }
    let angles = angles_in(pool, &arcs);
    let sought: Vec<Expr> = angles.iter().chain(&arcs).copied().collect();
    let Some(mut values) = values_at_a_point(pool, task.problem, &sought) else { return expression };
    let values_of_arcs = values.split_off(angles.len());
    let angles: Vec<(Expr, Enclosure)> = angles.into_iter().zip(values).collect();
    let mut reduced = expression;
    let mut kept: Vec<(Expr, Enclosure)> = Vec::new();
    for (arc, value) in arcs.drain(..).zip(values_of_arcs) {
        let own = angles_in(pool, &[arc]);
        let others: Vec<&(Expr, Enclosure)> =
            angles.iter().filter(|(angle, _)| own.contains(angle)).chain(&kept).collect();
        let replacement = replacement(pool, task, (arc, &value), &others, shown);
        match replacement {
            Some(other) => {
                let wanted = pool.node(arc).clone();
                let replaced = |node: &Node, _: &_| (*node == wanted).then_some(other);
                reduced = pool.replace_all(&[reduced], replaced)[0];
            }
            None => kept.push((arc, value)),
        }
    }
    reduced
}

fn arcs_in(pool: &Pool, expression: Expr) -> Vec<Expr> {
    let is_arc = |part: &Expr| matches!(pool.node(*part), Node::Apply(operation, _) if is_arc(*operation));
    pool.reachable(&[expression]).into_iter().filter(is_arc).collect()
}

/// Returns the arguments of sines, cosines and tangents within expressions, then the sums and
/// differences of two of them.
fn angles_in(pool: &mut Pool, expressions: &[Expr]) -> Vec<Expr> {
    let angle = |part: Expr| match pool.node(part) {
        Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, of) => Some(of[0]),
        _ => None,
    };
    let mut angles: Vec<Expr> = Vec::new();
    for angle in pool.reachable(expressions).into_iter().filter_map(angle) {
        if !angles.contains(&angle) {
            angles.push(angle);
        }
    }
    let single = angles.clone();
    if single.len() <= MOST_COMBINED {
        for (place, &a) in single.iter().enumerate() {
            for &b in &single[..place] {
                angles.extend([pool.add(a, b), pool.subtract(a, b)]);
            }
        }
    }
    angles
}

/// Returns an inverse function in terms of one of the others, or as a fraction of π.
fn replacement(
    pool: &mut Pool,
    task: Task,
    (arc, value): (Expr, &Enclosure),
    others: &[&(Expr, Enclosure)],
    shown: &mut Vec<Expr>,
) -> Option<Expr> {
    if let Some(angle) = part_of_pi(pool, value)
        && holds(pool, task, arc, angle, shown)
    {
        return Some(angle);
    }
    for (other, other_value) in others {
        for &(m, n) in MULTIPLES {
            let (m, n) = (Rational::from_integer(m.into()), Rational::from_integer(n.into()));
            let scaled = |q: &Rational, value: &Enclosure| Enclosure::exact(q, PRECISION).mul(value);
            let sum = scaled(&m, other_value).add(&scaled(&n, value));
            let Some(angle) = part_of_pi(pool, &sum) else { continue };
            // n β = (k/12)π − m α with n² = 1, where β is the arc and α the other
            let (m, n) = (pool.number(m), pool.number(n));
            let multiple = pool.multiply(m, *other);
            let difference = pool.subtract(angle, multiple);
            let candidate = pool.multiply(n, difference);
            if holds(pool, task, arc, candidate, shown) {
                return Some(candidate);
            }
        }
    }
    None
}

fn holds(pool: &mut Pool, task: Task, arc: Expr, candidate: Expr, shown: &mut Vec<Expr>) -> bool {
    let angle = pool.subtract(arc, candidate);
    let task = Task { work: task.work / SHARE, ..task };
    prove_angle(pool, task, angle, shown) == Outcome::Zero
}

/// Returns (k/12)π, if the value may equal it.
fn part_of_pi(pool: &mut Pool, value: &Enclosure) -> Option<Expr> {
    let parts = Enclosure::integer(PARTS, PRECISION).mul(value).div(&Enclosure::pi(PRECISION)).ok()?;
    let whole = parts.lower().round();
    if !parts.contains(&whole) && !parts.contains(&(&whole + Rational::from_integer(1.into()))) {
        return None;
    }
    let part = pool.number(whole / Rational::from_integer(PARTS.into()));
    let pi = pool.pi();
    Some(pool.multiply(part, pi))
}

/// Returns the values of the functions at a point that meets the conditions.
fn values_at_a_point(pool: &Pool, problem: &Problem, arcs: &[Expr]) -> Option<Vec<Enclosure>> {
    let mut expressions: Vec<Expr> =
        problem.assumptions.iter().flat_map(|condition| [condition.left, condition.right]).collect();
    let sides = expressions.len();
    expressions.extend(arcs);
    let symbols = pool.symbols_in(&expressions);
    let bounds = simple_bounds(pool, &problem.assumptions);
    (0..POINTS).find_map(|round| {
        let point = Sequence::new(u64::from(round) + 1).point(&symbols, &bounds, round);
        let value_of = |symbol| point.get(&symbol).map(|value| Enclosure::exact(value, PRECISION));
        let values = enclose(pool, &expressions, &value_of, &mut |_, _, _| None, PRECISION);
        let values: Vec<Enclosure> = values.into_iter().collect::<Result<_, _>>().ok()?;
        let holds = problem
            .assumptions
            .iter()
            .zip(values[..sides].chunks(2))
            .all(|(condition, pair)| pair[0].decide(condition.relation, &pair[1]) == Some(true));
        holds.then(|| values[sides..].to_vec())
    })
}
