//! Closed but not exact: whether a closed form has a potential on its domain, and if not, the cycle
//! that shows it.
//!
//! ```text
//! form ─ d w == 0 ─▶ closed
//! domain's conditions ─ shape ─▶ contractible, or around one hole like a sphere
//!       contractible ─▶ a potential
//!       a hole       ─▶ cycle ─ integral ─▶ period ─┬─ 0 ─▶ a potential
//!                                                   └─ c ─▶ none; one off a cut
//! ```
//! By Poincaré's lemma every closed form on a star-shaped domain is exact. ℝⁿ without a linear
//! subspace of codimension m contracts onto the sphere Sᵐ⁻¹ around it; a closed form of degree m −
//! 1 ≥ 1 is exact there if its integral over that sphere is zero, and a closed form of any other
//! degree ≥ 1 is exact (de Rham's theorem). Everything that is reported is a statement of the
//! language, decided like any other statement.

mod cycle;
mod potential;
mod report;
mod session;
mod shape;

pub use report::{Line, Report};

use crate::calculus::Form;
use crate::decide::Verdict;
use crate::expression::{Condition, Expr};
use crate::syntax::Source;
use crate::theory::{Named, Value};
use session::Session;
use shape::{Hole, Shape};

/// The form to study.
struct Study {
    name: String,
    form: Form<Expr>,
    chart: usize,
    /// The domain: the chart's conditions, and the conditions under which the form is defined.
    conditions: Vec<Condition>,
}

/// Reports the potentials of a form in a source without errors.
///
/// ```
/// use forms_core::syntax::Source;
/// use forms_core::topology::topology;
/// let text = "chart R2(x, y) where x**2 + y**2 > 0; form angle = (x*dy - y*dx)/(x**2 + y**2);";
/// let report = topology(&Source::new("angle.forms", text), "angle").expect("a form on one chart");
/// assert!(report.to_string().contains("== 2*pi"));
/// ```
///
/// # Errors
/// If there is no form of that name, or no unique chart for it.
pub fn topology(source: &Source, name: &str) -> Result<Report, String> {
    let session = Session::new(source)?;
    let study = study(&session, name)?;
    let mut report = Report::default();
    let chart = &session.theory.charts[study.chart];
    let closed = format!("d[{}]({name}) == 0", chart.name);
    let verdict = session.decide("", &closed)?;
    let stated = || chart.conditions.iter().map(|condition| condition.text(&session.theory.pool)).collect();
    let conditions: Vec<String> = match &verdict {
        Verdict::Proved(theorem) => theorem.conditions.clone(),
        _ => stated(),
    };
    report.say(introduction(&session, &study, &conditions));
    match verdict {
        Verdict::Proved(_) => report.proved(&closed, &[]),
        Verdict::Refuted(witness) => {
            report.say(format!("the form is not closed: {closed} fails {witness}"));
            report.say("a form that is not closed has no potential");
            return Ok(report);
        }
        verdict => {
            report.undecided(&closed, &verdict);
            return Ok(report);
        }
    }
    match shape::shape(&session, &study.conditions) {
        Shape::Contractible => {
            report.say("the domain contracts to a point, so every closed form on it has a potential");
            potential::on_the_domain(&session, &study, None, &mut report);
        }
        Shape::Around(hole) => around(&session, &study, &hole, &mut report),
        Shape::Unknown(reason) => {
            report.say(format!("the shape of the domain is not known: {reason}"));
            potential::on_the_domain(&session, &study, None, &mut report);
        }
    }
    Ok(report)
}

fn around(session: &Session, study: &Study, hole: &Hole, report: &mut Report) {
    let sphere = hole.coordinates.len() - 1;
    report.say(format!("the domain contracts to the sphere S{sphere} around {}", hole.place));
    if study.form.degree() as usize != sphere {
        report.say(format!(
            "on such a domain only {sphere}-forms can be closed but not exact, so this form has a potential"
        ));
        return potential::on_the_domain(session, study, Some(hole), report);
    }
    match cycle::period(session, study, hole, report) {
        Some(period) if period == "0" => {
            report.say("the period is zero, so the form has a potential on the whole domain");
            potential::on_the_domain(session, study, Some(hole), report);
        }
        Some(period) => {
            report
                .say("a form with a potential has period zero (Stokes), so none exists on the whole domain");
            potential::off_a_cut(session, study, hole, &period, report);
        }
        None => {}
    }
}

/// Returns the form of that name and its chart.
fn study(session: &Session, name: &str) -> Result<Study, String> {
    let theory = &session.theory;
    let (form, domain) = match theory.named(name) {
        Some(Named::Object(number)) => match &theory.objects[*number].value {
            Value::Form(form) => (form.clone(), &theory.objects[*number].domain),
            other => {
                return Err(format!("`{name}` is {}; only forms have periods and potentials", other.kind()));
            }
        },
        Some(_) => return Err(format!("`{name}` is not a form")),
        None => return Err(format!("`{name}` is not declared")),
    };
    let fitting = theory.charts_with(&theory.coordinates_of(&form));
    let smallest = fitting.iter().map(|&chart| theory.charts[chart].coordinates.len()).min();
    let smallest: Vec<usize> = fitting
        .into_iter()
        .filter(|&chart| Some(theory.charts[chart].coordinates.len()) == smallest)
        .collect();
    match smallest.as_slice() {
        [chart] => {
            let stated = &theory.charts[*chart].conditions;
            let own = domain.iter().filter(|condition| !stated.contains(condition));
            let conditions = stated.iter().chain(own).copied().collect();
            Ok(Study { name: name.to_owned(), form, chart: *chart, conditions })
        }
        [] => Err(format!("no chart has all coordinates of `{name}`")),
        several => {
            let names: Vec<&str> = several.iter().map(|&chart| theory.charts[chart].name.as_str()).collect();
            Err(format!("`{name}` belongs to several charts: {}", names.join(", ")))
        }
    }
}

/// Describes the form: degree, chart and domain.
fn introduction(session: &Session, study: &Study, conditions: &[String]) -> String {
    let theory = &session.theory;
    let chart = &theory.charts[study.chart];
    let coordinates: Vec<&str> = chart.coordinates.iter().map(|c| theory.coordinate_name(*c)).collect();
    let domain =
        if conditions.is_empty() { String::new() } else { format!(" where {}", conditions.join(", ")) };
    let degree = study.form.degree();
    format!("`{}` is a {degree}-form on {}({}){domain}", study.name, chart.name, coordinates.join(", "))
}

impl Report {
    fn say(&mut self, words: impl Into<String>) {
        self.lines.push(Line::Words(words.into()));
    }

    fn undecided(&mut self, statement: &str, verdict: &Verdict) {
        let reason = verdict.reason().unwrap_or_default();
        self.say(format!("{statement} is undecided: {reason}"));
    }

    fn item(&mut self, item: &str) {
        self.lines.push(Line::Item(item.to_owned()));
    }

    /// Adds a proved statement with the conditions it needs in addition to the conditions of the
    /// domain.
    fn proved(&mut self, statement: &str, beyond: &[String]) {
        self.lines.push(Line::Proved { statement: statement.to_owned(), beyond: beyond.to_vec() });
    }
}
