//! Potentials: candidates from the homotopy operator, each proved before it is reported.
//!
//! Around a point of the plane the form dθ = (x dy − y dx)/(x² + y²) has period 2π, and around a
//! point of space the solid-angle form β has period 4π. A closed form with period c is therefore
//! c/2π dθ, or c/4π β, plus a form that has a potential. Off a cut, θ = atan2(y, x) is a potential
//! of dθ, and (x dy − y dx)/(r(r + z)) is a potential of β: it fails only on the half line x = y =
//! 0, z ≤ 0, the Dirac string.

use super::Study;
use super::cycle::value;
use super::report::Report;
use super::session::Session;
use super::shape::Hole;
use crate::decide::Verdict;
use crate::expression::{Rational, Symbol};
use num_traits::Zero;

/// Reports a potential on the whole domain, if one is found.
pub(super) fn on_the_domain(session: &Session, study: &Study, hole: Option<&Hole>, report: &mut Report) {
    let mut candidates = vec![homotopy(session, study, &study.name)];
    candidates.extend(hole.and_then(|hole| logarithm(session, study, hole)));
    let potential = session.fresh("A");
    if !tell(session, study, &candidates, "", &potential, report) {
        report.say("a potential in closed form was not found");
    }
}

/// Returns c log r plus the result of the homotopy operator for the remaining form, with c = i_E w
/// for the dilation E around the hole: for a 1-form of weight 0 the operator alone would have to
/// divide by zero.
fn logarithm(session: &Session, study: &Study, hole: &Hole) -> Option<String> {
    if study.form.degree() != 1 {
        return None;
    }
    let theory = &session.theory;
    let from = |(symbol, centre): &(Symbol, Rational)| {
        let name = theory.pool.symbol_name(*symbol);
        (name.to_owned(), if centre.is_zero() { name.to_owned() } else { format!("({name} - ({centre}))") })
    };
    let places: Vec<(String, String)> = hole.coordinates.iter().map(from).collect();
    let dilation: Vec<String> = places.iter().map(|(name, x)| format!("{x}*@{name}")).collect();
    let contracted = format!("interior({}, {})", dilation.join(" + "), study.name);
    let name = session.fresh("c");
    let weight = written_out(session, &format!("let {name} = {contracted};"), &name)?;
    let squares: Vec<String> = places.iter().map(|(_, x)| format!("{x}**2")).collect();
    let factor = if weight == "1" { "1/2".to_owned() } else { format!("({weight})/2") };
    let logarithm = format!("{factor}*log({})", squares.join(" + "));
    Some(format!("{logarithm} + {}", homotopy(session, study, &format!("({} - d({logarithm}))", study.name))))
}

/// Reports a potential off a cut, for a form with a period.
pub(super) fn off_a_cut(session: &Session, study: &Study, hole: &Hole, period: &str, report: &mut Report) {
    let Some(standard) = Standard::around(session, study, hole) else {
        report.say("potentials off a cut are not searched for in this dimension");
        return;
    };
    let share = format!("({period})/({})", standard.period);
    let share = value(session, "", &share).unwrap_or(share);
    let times = |form: &str| if share == "1" { format!("({form})") } else { format!("({share})*({form})") };
    let rest = format!("({} - {})", study.name, times(&standard.form));
    let potential = session.fresh("A");
    report.say(format!("off {} the form has a potential:", standard.cut));
    let main = times(&standard.potential);
    let with_rest = format!("{main} + {}", homotopy(session, study, &rest));
    let candidates = [main, with_rest];
    if !tell(session, study, &candidates, &standard.condition, &potential, report) {
        report.say("    none was found in closed form");
    }
}

/// Poincaré's operator along the chart.
fn homotopy(session: &Session, study: &Study, form: &str) -> String {
    format!("potential[{}]({form})", session.theory.charts[study.chart].name)
}

/// Reports the first candidate that is proved to be a potential.
fn tell(
    session: &Session,
    study: &Study,
    candidates: &[String],
    condition: &str,
    name: &str,
    report: &mut Report,
) -> bool {
    for candidate in candidates {
        let item = format!("let {name} = {candidate};");
        let place = if condition.is_empty() { String::new() } else { format!(" where {condition}") };
        let chart = &session.theory.charts[study.chart].name;
        let statement = format!("d[{chart}]({name}) == {}{place}", study.name);
        if let Ok(Verdict::Proved(theorem)) = session.decide(&item, &statement) {
            let given: Vec<String> =
                study.conditions.iter().map(|known| known.text(&session.theory.pool)).collect();
            // Off a cut, the statement itself contains the condition.
            let mut beyond = if condition.is_empty() { theorem.conditions } else { Vec::new() };
            beyond.retain(|needed| !given.contains(needed));
            report.item(&item);
            if let Some(value) = written_out(session, &item, name).filter(|value| *value != *candidate) {
                report.item(&format!("// {name} = {value}"));
            }
            report.proved(&statement, &beyond);
            return true;
        }
    }
    false
}

/// Returns a named value, simplified, in the language's notation.
fn written_out(session: &Session, item: &str, name: &str) -> Option<String> {
    let mut theory = session.extended(item).ok()?;
    let crate::theory::Named::Object(number) = *theory.named(name)? else { return None };
    let object = theory.objects[number].clone();
    let simple = crate::notation::simplify(&mut theory, &object.domain, &object.value);
    Some(crate::notation::text(&theory, &simple))
}

/// The closed form with which every other form with a period is compared.
struct Standard {
    form: String,
    period: &'static str,
    potential: String,
    condition: String,
    cut: String,
}

impl Standard {
    fn around(session: &Session, study: &Study, hole: &Hole) -> Option<Self> {
        let theory = &session.theory;
        let chart = &theory.charts[study.chart];
        let names: Vec<String> = chart
            .coordinates
            .iter()
            .map(|coordinate| theory.coordinates[coordinate.0 as usize])
            .filter_map(|symbol| {
                let (_, centre) = hole.coordinates.iter().find(|entry| entry.0 == symbol)?;
                let name = theory.pool.symbol_name(symbol);
                Some(if centre.is_zero() { name.to_owned() } else { format!("({name} - ({centre}))") })
            })
            .collect();
        let differentials: Vec<String> = chart
            .coordinates
            .iter()
            .filter(|c| hole.coordinates.iter().any(|entry| entry.0 == theory.coordinates[c.0 as usize]))
            .map(|c| format!("d{}", theory.coordinate_name(*c)))
            .collect();
        match (names.as_slice(), differentials.as_slice()) {
            ([x, y], [dx, dy]) => Some(Standard {
                form: format!("({x}*{dy} - {y}*{dx})/({x}**2 + {y}**2)"),
                period: "2*pi",
                potential: format!("atan2({y}, {x})"),
                condition: format!("sqrt({x}**2 + {y}**2) + {x} > 0"),
                cut: format!("the cut {y} = 0, {x} <= 0"),
            }),
            ([x, y, z], [dx, dy, dz]) => {
                let r = format!("sqrt({x}**2 + {y}**2 + {z}**2)");
                Some(Standard {
                    form: format!("({x}*{dy}^{dz} + {y}*{dz}^{dx} + {z}*{dx}^{dy})/{r}**3"),
                    period: "4*pi",
                    potential: format!("({x}*{dy} - {y}*{dx})/({r}*({r} + {z}))"),
                    condition: format!("{r} + {z} > 0"),
                    cut: format!("the half line {x} = {y} = 0, {z} <= 0 (a Dirac string)"),
                })
            }
            _ => None,
        }
    }
}
