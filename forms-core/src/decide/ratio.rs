//! Simple factors by which the sides of a false equation differ: 2, −1, π, sin θ, cos θ/r², a
//! Jacobian.
//!
//! The factor c = left/right is read off one component, and is reported only if left − c·right has
//! the normal form zero in every component.

use super::goal::Outcome;
use super::problem::Problem;
use super::proof::prove_zero;
use super::report::simplified_where;
use super::verdict::Ratio;
use crate::calculus::{Blade, Coordinate, Form, Pullback, Structured, pullback};
use crate::expression::Operation::{Cos, Exp, Sin, Tan};
use crate::expression::{Expr, Node, Pool};
use crate::normal::WORK_LIMIT;
use crate::theory::{Map, Theory};
use num_traits::{One, Zero};

/// Factors with more nodes are skipped.
const LARGEST_FACTOR: usize = 64;

/// A factor with more parts is no hint for a reader.
const MOST_PARTS: usize = 4;

/// The factor is not compared with Jacobians of maps between more coordinates.
const LARGEST_DIMENSION: usize = 4;

/// Returns the factor by which the two sides differ, if there is a simple one.
pub(super) fn ratio(theory: &mut Theory, problem: &Problem) -> Option<Ratio> {
    let pool = &mut theory.pool;
    let pair = problem.components.iter().find(|c| !pool.is_zero(c.left) && !pool.is_zero(c.right))?;
    let quotient = pool.divide(pair.left, pair.right);
    let factor = simplified_where(pool, &problem.assumptions, quotient);
    let zero = pool.as_number(factor).is_some_and(Zero::is_zero);
    if zero || pool.reachable(&[factor]).len() > LARGEST_FACTOR || has_unknown(pool, factor) {
        return None;
    }
    let jacobian_of = jacobian(theory, problem, factor);
    let pool = &mut theory.pool;
    if jacobian_of.is_none() && !is_simple(pool, factor) {
        return None;
    }
    let equal = problem.identical.iter().map(|&side| (side, side));
    let sides = problem.components.iter().map(|component| (component.left, component.right)).chain(equal);
    let mut rests = Vec::new();
    for (left, right) in sides {
        let scaled = pool.multiply(factor, right);
        rests.push(pool.subtract(left, scaled));
    }
    if prove_zero(pool, problem, rests, WORK_LIMIT) != Outcome::Zero {
        return None;
    }
    Some(Ratio { factor: pool.text(factor), jacobian_of })
}

/// Whether a factor is a product of a few powers of commonly forgotten factors: 2, π, sin θ, cos
/// θ/r², 1/√(u² + v² + h²).
fn is_simple(pool: &Pool, factor: Expr) -> bool {
    let mut parts = 0;
    let mut pending = vec![factor];
    while let Some(part) = pending.pop() {
        match pool.node(part) {
            Node::Power(a, _) if matches!(pool.node(*a), Node::Power(..)) => return false,
            Node::Negate(a) | Node::Power(a, _) => pending.push(*a),
            Node::Multiply(a, b) | Node::Divide(a, b) => pending.extend([*a, *b]),
            Node::Number(value) if value.is_one() => {}
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Apply(Sin | Cos | Tan | Exp, _) => {
                parts += 1;
            }
            Node::Add(..) if is_norm(pool, part) => parts += 1,
            Node::Add(..) | Node::Apply(..) | Node::Jet { .. } | Node::Select { .. } => return false,
        }
    }
    parts <= MOST_PARTS
}

/// Whether a sum consists of even powers and numbers.
fn is_norm(pool: &Pool, sum: Expr) -> bool {
    match pool.node(sum) {
        Node::Add(a, b) => is_norm(pool, *a) && is_norm(pool, *b),
        Node::Number(_) => true,
        Node::Power(_, n) => n.is_integer() && n.numer() % 2 == 0,
        _ => false,
    }
}

/// Whether a factor contains an unknown function: then it is not a forgotten factor.
fn has_unknown(pool: &Pool, factor: Expr) -> bool {
    pool.reachable(&[factor]).into_iter().any(|part| matches!(pool.node(part), Node::Jet { .. }))
}

/// Returns the map whose Jacobian, or its reciprocal, is a number times the factor; numbers
/// themselves are not Jacobians.
fn jacobian(theory: &mut Theory, problem: &Problem, factor: Expr) -> Option<String> {
    let symbols = theory.pool.symbols_in(&[factor]);
    if symbols.is_empty() {
        return None;
    }
    for map in theory.maps.clone() {
        let Some(jacobian) = jacobian_of(theory, &map) else { continue };
        let own = theory.pool.symbols_in(&[jacobian]);
        if has_unknown(&theory.pool, jacobian) || !symbols.iter().all(|symbol| own.contains(symbol)) {
            continue;
        }
        for candidate in [theory.pool.divide(factor, jacobian), theory.pool.multiply(factor, jacobian)] {
            let candidate = simplified_where(&mut theory.pool, &problem.assumptions, candidate);
            if theory.pool.symbols_in(&[candidate]).is_empty() {
                return Some(map.name);
            }
        }
    }
    None
}

/// Returns √Σ_I (F*dx_I)² over the basis forms of the source's degree, which is √det(JᵀJ);
/// F*(dx₁∧…∧dxₙ) if there is only one.
fn jacobian_of(theory: &mut Theory, map: &Map) -> Option<Expr> {
    let source = theory.charts[map.source].coordinates.clone();
    let target = theory.charts[map.target].coordinates.clone();
    if source.len() > target.len() || target.len() > LARGEST_DIMENSION {
        return None;
    }
    let components: Vec<(Coordinate, Expr)> =
        target.iter().copied().zip(map.components.iter().copied()).collect();
    let whole = source.iter().try_fold(Blade::SCALAR, |all, &c| Some(all.wedge(Blade::of(c))?.0))?;
    let ring = &mut Structured { pool: &mut theory.pool, coordinates: &theory.coordinates };
    let one = ring.pool.integer(1);
    let prepared = Pullback::new(ring, &components, &source);
    let mut minors = Vec::new();
    for basis in basis_forms(&target, source.len()) {
        let form = Form::from_terms(source.len() as u32, [(basis, one)]);
        let pulled = pullback(ring, &prepared, &form, |_, value| *value);
        minors.extend(pulled.coefficient(whole).copied());
    }
    match minors.as_slice() {
        [] => None,
        [single] => Some(*single),
        several => {
            let squares = several.iter().map(|&minor| ring.pool.power(minor, 2.into())).collect::<Vec<_>>();
            let sum = squares.into_iter().reduce(|a, b| ring.pool.add(a, b))?;
            Some(ring.pool.sqrt(sum))
        }
    }
}

/// Returns the basis forms of a degree in ascending order.
fn basis_forms(coordinates: &[Coordinate], degree: usize) -> Vec<Blade> {
    let mut all = vec![Blade::SCALAR];
    for &coordinate in coordinates {
        let raised: Vec<Blade> = all.iter().filter_map(|b| Some(b.wedge(Blade::of(coordinate))?.0)).collect();
        all.extend(raised);
    }
    all.retain(|blade| blade.degree() as usize == degree);
    all
}
