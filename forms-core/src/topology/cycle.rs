//! The cycle around a hole and the integral of a form over it.
//!
//! The sphere Sᵐ⁻¹ is parametrised by angles: x₁ = cos θ₁ … read from the last coordinate, which
//! carries the pole, so that S² in (x, y, z) is (sin θ cos φ, sin θ sin φ, cos θ), oriented
//! outwards.

use super::Study;
use super::report::Report;
use super::session::Session;
use super::shape::Hole;
use crate::decide::{Verdict, simplified_where};
use crate::expression::{Condition, Expr, Pool, Rational, Substitution, Symbol};
use crate::theory::{Named, Value};
use num_traits::{One, Zero};

/// Reports the cycle and the period; returns the period in the language's notation, or `None` if it
/// could not be found.
pub(super) fn period(session: &Session, study: &Study, hole: &Hole, report: &mut Report) -> Option<String> {
    let angles: Vec<String> =
        (1..hole.coordinates.len()).map(|number| session.fresh(&format!("t{number}"))).collect();
    let (angles_chart, cycle) = (session.fresh("Angles"), session.fresh("cycle"));
    let theory = &session.theory;
    let chart = &theory.charts[study.chart];
    let directions = directions(&angles);
    let components: Vec<String> = chart
        .coordinates
        .iter()
        .map(|coordinate| {
            let symbol = theory.coordinates[coordinate.0 as usize];
            match hole.coordinates.iter().position(|entry| entry.0 == symbol) {
                Some(place) => component(hole, place, &directions[place]),
                None => resting(session, study, symbol),
            }
        })
        .collect();
    let chart_item = format!("chart {angles_chart}({});", angles.join(", "));
    let map_item = format!("map {cycle}: {angles_chart} -> {} = ({});", chart.name, components.join(", "));
    let last = angles.len() - 1;
    let ranges: Vec<String> = angles
        .iter()
        .enumerate()
        .map(|(place, angle)| format!("{angle} = 0..{}pi", if place == last { "2*" } else { "" }))
        .collect();
    let integral = format!("integral(pullback({cycle}, {}), {})", study.name, ranges.join(", "));
    let items = format!("{chart_item}\n{map_item}");
    let period = match value(session, &items, &integral) {
        Ok(period) => period,
        Err(message) => {
            report.say(format!("the period over the sphere around the hole was not found: {message}"));
            return None;
        }
    };
    report.say("a cycle that does not contract to a point, and the period over it:");
    report.item(&chart_item);
    report.item(&map_item);
    let statement = format!("{integral} == {period}");
    match session.decide(&items, &statement) {
        Ok(Verdict::Proved(_)) => report.proved(&statement, &[]),
        Ok(verdict) => {
            report.undecided(&statement, &verdict);
            return None;
        }
        Err(message) => {
            report.say(message);
            return None;
        }
    }
    is_settled(session, &items, &period, report).then_some(period)
}

/// Whether the period is known to be zero or known to be nonzero.
fn is_settled(session: &Session, items: &str, period: &str, report: &mut Report) -> bool {
    let settled =
        period == "0" || matches!(session.decide(items, &format!("{period} == 0")), Ok(Verdict::Refuted(_)));
    if !settled {
        report.say(format!("whether {period} is zero is undecided"));
    }
    settled
}

/// Returns a point on the unit sphere by angles: cos t₁ for the last coordinate, then sin t₁ cos t₂
/// …; the first two coordinates contain the cosine and sine of the last angle.
fn directions(angles: &[String]) -> Vec<String> {
    let m = angles.len() + 1;
    let mut parts = vec![String::new(); m];
    let mut sines: Vec<String> = Vec::new();
    for (number, angle) in angles.iter().enumerate() {
        let product = |last: String| sines.iter().cloned().chain([last]).collect::<Vec<_>>().join("*");
        if number + 1 == angles.len() {
            (parts[0], parts[1]) = (product(format!("cos({angle})")), product(format!("sin({angle})")));
        } else {
            parts[m - 1 - number] = product(format!("cos({angle})"));
        }
        sines.push(format!("sin({angle})"));
    }
    parts
}

fn component(hole: &Hole, place: usize, direction: &str) -> String {
    let centre = &hole.coordinates[place].1;
    let scaled =
        if hole.radius == "1" { direction.to_owned() } else { format!("{}*{direction}", hole.radius) };
    if centre.is_zero() { scaled } else { format!("{centre} + {scaled}") }
}

/// Returns the fixed value of a coordinate that does not go around the hole: a number that meets
/// the conditions on this coordinate alone. Moving the sphere along the coordinate does not change
/// the period.
fn resting(session: &Session, study: &Study, symbol: Symbol) -> String {
    let mut pool = session.theory.pool.clone();
    let of_it = |c: &&Condition| session.theory.pool.symbols_in(&[c.left, c.right]) == [symbol];
    let conditions: Vec<Condition> = study.conditions.iter().filter(of_it).copied().collect();
    let bounds = conditions.iter().flat_map(|c| [c.left, c.right]);
    let mut numbers: Vec<Rational> =
        bounds.filter_map(|side| session.theory.pool.as_number(side).cloned()).collect();
    numbers.push(Rational::zero());
    numbers.sort();
    let mut candidates = vec![Rational::zero()];
    candidates
        .extend(numbers.windows(2).map(|pair| (&pair[0] + &pair[1]) / Rational::from_integer(2.into())));
    candidates.extend(numbers.first().map(|least| least - Rational::one()));
    candidates.extend(numbers.last().map(|largest| largest + Rational::one()));
    let fits = |value: &Rational, pool: &mut Pool| {
        let at: Substitution = [(symbol, pool.number(value.clone()))].into_iter().collect();
        conditions.iter().all(|condition| condition.substitute(pool, &at).decided(pool) == Some(true))
    };
    let found = candidates.iter().find(|value| fits(value, &mut pool));
    found.unwrap_or(&candidates[0]).to_string()
}

/// Returns the value of a scalar expression, simplified, in the language's notation.
pub(super) fn value(session: &Session, items: &str, expression: &str) -> Result<String, String> {
    let name = session.fresh("value");
    let mut theory = session.extended(&format!("{items}\nlet {name} = {expression};"))?;
    let Some(Named::Object(number)) = theory.named(&name) else {
        return Err("the expression has no value".into());
    };
    let scalar: Expr = match &theory.objects[*number].value {
        Value::Zero => return Ok("0".into()),
        Value::Scalar(scalar) => *scalar,
        other => return Err(format!("it is {}", other.kind())),
    };
    let conditions = theory.objects[*number].domain.clone();
    let simple = simplified_where(&mut theory.pool, &conditions, scalar);
    Ok(theory.pool.text(simple))
}
