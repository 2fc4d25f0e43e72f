//! Parts of inverse trigonometric functions that square roots do not reach: thirds, fifths, …
//!
//! ```text
//! acos(αv + β)/d in a sine or cosine ─▶ v = (cos(dw) − β)/α, 0 ≤ dw ≤ π: acos(αv + β) is dw, its part w
//! ```
//! Every v has its w, w = acos(αv + β)/d, so a statement that holds for all w holds for all v. The
//! same is done for asin with −π/2 ≤ dw ≤ π/2 and for atan with −π/2 < dw < π/2.

use super::problem::{Component, Problem};
use crate::assume::vanishes;
use crate::expression::{
    Condition, Expr, Node, Operation, Pool, Rational, Relation, Substitution, Symbol, SymbolKind,
};
use crate::normal::{Tower, Trigonometry, normalise};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use rustc_hash::FxHashMap;

/// Largest odd denominator of a part; smaller parts are not replaced.
const SMALLEST_PART: u32 = 15;

/// An inverse function that occurs in parts, with the number of parts.
struct Parted {
    operation: Operation,
    argument: Expr,
    parts: BigInt,
}

/// Returns the problem with a variable replaced such that an inverse function that occurs in parts
/// becomes a multiple of a new variable.
pub(super) fn with_whole_parts(pool: &mut Pool, problem: &Problem) -> Option<Problem> {
    let parted = first_parted(pool, &problem.differences())?;
    let (variable, slope, offset) = linear(pool, parted.argument)?;
    let part = pool.declare_symbol("w", SymbolKind::Local);
    let (count, part) = (pool.number(Rational::from_integer(parted.parts)), pool.symbol(part));
    let angle = pool.multiply(count, part);
    let (wave, bounds) = principal(pool, parted.operation, angle)?;
    let rest = pool.subtract(wave, offset);
    let slope = pool.number(slope);
    let values: Substitution = [(variable, pool.divide(rest, slope))].into_iter().collect();
    let mut image = |expression: Expr| {
        let substituted = pool.substitute(expression, &values);
        with_angle(pool, substituted, (parted.operation, wave), angle)
    };
    let components = problem
        .components
        .iter()
        .map(|component| Component {
            label: component.label.clone(),
            left: image(component.left),
            right: image(component.right),
            difference: image(component.difference),
        })
        .collect();
    let mut assumptions: Vec<Condition> = problem
        .assumptions
        .iter()
        .map(|c| Condition { left: image(c.left), relation: c.relation, right: image(c.right) })
        .collect();
    assumptions.extend(bounds);
    Some(Problem { components, identical: vec![], assumptions, stated: problem.stated })
}

/// Returns the first inverse function whose odd part occurs in the angle of a sine, cosine or
/// tangent.
fn first_parted(pool: &mut Pool, expressions: &[Expr]) -> Option<Parted> {
    let mut found: Option<Parted> = None;
    for part in pool.reachable(expressions) {
        let Node::Apply(Operation::Sin | Operation::Cos | Operation::Tan, of) = pool.node(part).clone()
        else {
            continue;
        };
        let mut tower = Tower::new(Trigonometry::Circle);
        let Ok(prepared) = normalise(&mut tower, pool, &of) else { continue };
        let Ok(angles) = prepared.exact(&mut tower, pool) else { continue };
        for (quantity, coefficient) in tower.linear_parts(&angles[0]).ok()? {
            let Some((operation, arguments)) = tower.arc_of(&quantity) else { continue };
            let mut parts = coefficient.denom().clone();
            while parts.is_even() {
                parts /= 2;
            }
            if parts.is_one() || parts > SMALLEST_PART.into() {
                continue;
            }
            let argument = tower.raise(pool, &arguments[0]);
            match &mut found {
                None => found = Some(Parted { operation, argument, parts }),
                Some(known) if known.operation == operation && known.argument == argument => {
                    known.parts = known.parts.lcm(&parts);
                }
                Some(_) => {}
            }
        }
    }
    found
}

/// Returns v, α and β of an expression αv + β with a number α.
fn linear(pool: &mut Pool, expression: Expr) -> Option<(Symbol, Rational, Expr)> {
    for symbol in pool.symbols_in(&[expression]) {
        let mut tower = Tower::new(Trigonometry::Circle);
        let prepared = normalise(&mut tower, pool, &[expression]).ok()?;
        let normal = prepared.exact(&mut tower, pool).ok()?.remove(0);
        let variable = tower.variable_number(symbol);
        if tower.generators_in(&normal, symbol) != [variable] || !prepared.is_unconditional() {
            continue;
        }
        let Ok(function) = tower.rational_function(&normal, variable) else { continue };
        let slope = function.numerator.coefficient(1).as_number();
        let is_linear = function.numerator.degree() == 1 && function.denominator.is_empty();
        let holds = is_linear && tower.holds_everywhere();
        if let (Some(slope), true) = (slope.filter(|slope| !slope.is_zero()), holds) {
            let offset = tower.raise(pool, &function.numerator.coefficient(0));
            return Some((symbol, slope, offset));
        }
    }
    None
}

/// Returns the value that the inverse function maps to an angle, and the principal range of the
/// angle as conditions.
fn principal(pool: &mut Pool, operation: Operation, angle: Expr) -> Option<(Expr, [Condition; 2])> {
    let (pi, zero, half, minus_half) = (pool.pi(), pool.integer(0), pool.ratio(1, 2), pool.ratio(-1, 2));
    let (right, left) = (pool.multiply(half, pi), pool.multiply(minus_half, pi));
    use Relation::{Greater, GreaterEqual, Less, LessEqual};
    let (function, lower, upper) = match operation {
        Operation::Acos => (Operation::Cos, (GreaterEqual, zero), (LessEqual, pi)),
        Operation::Asin => (Operation::Sin, (GreaterEqual, left), (LessEqual, right)),
        Operation::Atan => (Operation::Tan, (Greater, left), (Less, right)),
        _ => return None,
    };
    let wave = pool.apply(function, &[angle]);
    let bounds = [lower, upper].map(|(relation, right)| Condition { left: angle, relation, right });
    Some((wave, bounds))
}

/// Replaces the inverse function of a trigonometric value by its angle in an expression.
fn with_angle(pool: &mut Pool, expression: Expr, (operation, wave): (Operation, Expr), angle: Expr) -> Expr {
    let mut images: FxHashMap<Expr, Expr> = FxHashMap::default();
    for part in pool.reachable(&[expression]) {
        let argument = match pool.node(part) {
            Node::Apply(other, of) if *other == operation => of[0],
            _ => continue,
        };
        let difference = pool.subtract(argument, wave);
        if argument == wave || vanishes(pool, difference) {
            images.insert(part, angle);
        }
    }
    pool.replace(expression, &images)
}
