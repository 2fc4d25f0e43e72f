//! Witness points, named by a certificate or found by the checker: points where two sides differ,
//! and points that show that a statement is not vacuous.

use crate::expression::Expr;
use crate::expression::rational;
use crate::interval::Interval;
use crate::line::Line;
use crate::point::Point;
use crate::theory::{Condition, Relation, Statement, Theory};
use crate::{Stop, malformed, rejected, uncovered};
use num_rational::BigRational;
use std::collections::{BTreeSet, HashMap};

/// Maximum number of points tried to show that a statement is not vacuous.
const MOST_POINTS: u64 = 400;

/// Exponent n of the nearly constant functions exp(2⁻ⁿ…) at some of the points, which can be
/// enclosed for arguments that are physical constants.
const FLAT: u32 = 60;

/// Values tried for variables.
const VALUES: [(i64, i64); 30] = [
    (1, 2),
    (1, 1),
    (2, 1),
    (1, 3),
    (3, 4),
    (3, 2),
    (-1, 2),
    (1, 4),
    (-1, 1),
    (3, 1),
    (5, 4),
    (1, 10),
    (-2, 1),
    (0, 1),
    (7, 3),
    (5, 1),
    (-3, 2),
    (1, 100),
    (10, 1),
    (9, 10),
    (4, 3),
    (-1, 4),
    (100, 1),
    (99, 100),
    (-3, 1),
    (-1, 10),
    (2, 3),
    (1, 1000),
    (-10, 1),
    (1000, 1),
];

/// Checks the point of a refutation: every condition holds there, and the enclosures of the two
/// sides are disjoint.
pub(crate) fn check(theory: &mut Theory, statement: &Statement, lines: &[Line]) -> Result<(), Stop> {
    let count = lines.iter().position(|line| line.0 != "at").unwrap_or(lines.len());
    let (at, rest) = lines.split_at(count);
    let point = listed(theory, at)?.completed(0);
    let [(component_line, component), (left_line, left), (right_line, right)] = rest else {
        return Err(malformed("a refutation is a point, a component, a left and a right value"));
    };
    if [component_line.as_str(), left_line, right_line] != ["component", "left", "right"] {
        return Err(malformed("a refutation is a point, a component, a left and a right value"));
    }
    let Some(sides) = statement.components.get(component) else { return rejected("no such component") };
    let mut known = HashMap::new();
    if !meets(theory, &point, &statement.conditions, &mut known) {
        return rejected("a condition is not certain at the point");
    }
    // both sides must be defined in every component
    for side in statement.components.values().flatten() {
        point.enclosed(&theory.pool, *side, &mut known)?;
    }
    let [a, b] = [known[&sides[0]].clone(), known[&sides[1]].clone()];
    if a.low <= b.high && b.low <= a.high {
        return rejected("the enclosures of the sides overlap at the point");
    }
    if is_rounded(&a, &number(theory, left)?, left) && is_rounded(&b, &number(theory, right)?, right) {
        Ok(())
    } else {
        rejected("the sides have other values than the certificate states")
    }
}

/// Checks that a statement is not vacuous, by the point that the certificate names, or else by one
/// that is found.
pub(crate) fn check_inhabited(theory: &mut Theory, statement: &Statement, at: &[Line]) -> Result<(), Stop> {
    if at.is_empty() {
        return find(theory, statement);
    }
    let point = listed(theory, at)?.completed(0);
    if is_of(theory, &point, statement) {
        Ok(())
    } else {
        rejected("the point was not shown to satisfy the conditions of the statement")
    }
}

fn listed(theory: &mut Theory, at: &[Line]) -> Result<Point, Stop> {
    let mut point = Point::default();
    for (_, rest) in at {
        let (name, value) = rest.split_once(" = ").ok_or_else(|| malformed("a point without a value"))?;
        let (place, value) = (theory.expression(name)?, number(theory, value)?);
        point.set(&theory.pool, place, value)?;
    }
    Ok(point)
}

fn meets(
    theory: &Theory,
    point: &Point,
    conditions: &[Condition],
    known: &mut HashMap<Expr, Interval>,
) -> bool {
    conditions.iter().all(|(expr, relation)| {
        let sign = point.enclosed(&theory.pool, *expr, known).ok().and_then(|value| value.sign());
        match relation {
            Relation::Positive => sign == Some(1),
            Relation::NotNegative => matches!(sign, Some(0 | 1)),
            Relation::NotZero => matches!(sign, Some(1 | -1)),
        }
    })
}

/// Whether every condition holds and both sides are defined at a point.
fn is_of(theory: &Theory, point: &Point, statement: &Statement) -> bool {
    let mut known = HashMap::new();
    meets(theory, point, &statement.conditions, &mut known)
        && statement
            .components
            .values()
            .flatten()
            .all(|side| point.enclosed(&theory.pool, *side, &mut known).is_ok())
}

/// Searches for a point among values that satisfy the conditions on each single variable.
fn find(theory: &mut Theory, statement: &Statement) -> Result<(), Stop> {
    let mut variables: BTreeSet<usize> = BTreeSet::new();
    for part in &statement.nodes {
        variables.extend(theory.pool.variables(*part));
    }
    let mut conditions = statement.conditions.clone();
    conditions.sort_by_cached_key(|condition| theory.pool.parts(&[condition.0]).len());
    let fits = |v: usize, value: &BigRational| {
        let point = Point::within(HashMap::from([(v, Interval::number(value.clone()))])).completed(0);
        let is_alone = |condition: &&Condition| theory.pool.variables(condition.0) == BTreeSet::from([v]);
        let own: Vec<Condition> = conditions.iter().filter(is_alone).copied().collect();
        meets(theory, &point, &own, &mut HashMap::new())
    };
    let values = VALUES.map(|(p, q)| rational(p, q));
    let choices: Vec<(usize, Vec<BigRational>)> = variables
        .into_iter()
        .map(|v| (v, values.iter().filter(|value| fits(v, value)).cloned().collect()))
        .collect();
    if choices.iter().all(|(_, fitting)| !fitting.is_empty()) {
        let mut random = 1_u64;
        for round in 0..MOST_POINTS {
            let mut variables = HashMap::new();
            for (v, fitting) in &choices {
                random =
                    random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                let chosen = (random >> 33) as usize % fitting.len();
                variables.insert(*v, Interval::number(fitting[chosen].clone()));
            }
            let point = Point::within(variables).completed(if round % 4 == 3 { FLAT } else { 0 });
            if meets(theory, &point, &conditions, &mut HashMap::new()) && is_of(theory, &point, statement) {
                return Ok(());
            }
        }
    }
    uncovered("no point was found that satisfies the conditions of the statement")
}

fn number(theory: &mut Theory, text: &str) -> Result<BigRational, Stop> {
    let expr = theory.expression(text)?;
    theory.pool.as_number(expr).cloned().ok_or_else(|| malformed(format!("`{text}` is not a number")))
}

/// Whether a decimal equals the value to its last digit; a fraction must equal the value.
fn is_rounded(value: &Interval, number: &BigRational, text: &str) -> bool {
    let places = text.split_once('.').map_or(0, |(_, digits)| digits.len());
    // tolerance for the width of the enclosure: 10⁻³⁶
    let width = rational(1, 1) / rational(10, 1).pow(36);
    let unit = if places == 0 { rational(0, 1) } else { rational(1, 10).pow(places.min(4096) as i32) };
    let half = unit / rational(2, 1) + width;
    value.low >= number - &half && value.high <= number + half
}
