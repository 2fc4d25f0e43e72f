//! First and last step of a derivation: the claim, and the verdict on it.

use super::scribe::{APART, Formula, Scribe};
use super::{Line, Step};
use crate::decide::Witness;
use crate::notation::{latex_of_condition, latex_of_name};
use crate::syntax::ast::{Claim, ItemKind};
use crate::theory::Statement;

/// Returns the step that shows the equation as it was written, with its own conditions.
pub(super) fn claim(scribe: &Scribe, claim: &ItemKind) -> Step {
    let ItemKind::Statement { claim, left, right, conditions, .. } = claim else {
        return Step::new("The claim", vec![]);
    };
    let title = match claim {
        Claim::Prove => "Claimed to hold",
        Claim::Refute => "Claimed to fail",
    };
    let mut lines = vec![Line::Formula(scribe.written(left).equals(scribe.written(right)))];
    if !conditions.is_empty() {
        let conditions: Vec<Formula> = conditions
            .iter()
            .map(|condition| {
                let span = condition.span.start as usize..condition.span.end as usize;
                let text = scribe.source.text.get(span).unwrap_or_default();
                Formula::new(text, latex_of_condition(scribe.theory, condition))
            })
            .collect();
        lines.push(Line::Words("where".into()));
        lines.push(Line::Formula(Formula::list(&conditions, APART)));
    }
    Step::new(title, lines)
}

pub(super) fn proved(scribe: &mut Scribe, statement: &Statement) -> Step {
    let conditions = conditions(scribe, statement);
    let sentence = if conditions.is_empty() {
        "The two sides are equal at every point."
    } else {
        "The two sides are equal at every point that meets"
    };
    Step::new("Proved", [Line::Words(sentence.into())].into_iter().chain(conditions).collect())
}

pub(super) fn refuted(scribe: &mut Scribe, statement: &Statement, witness: &Witness) -> Step {
    let at: Vec<Formula> = witness.point.iter().map(|(name, value)| assignment(name, value)).collect();
    let mut lines = if at.is_empty() {
        vec![Line::Words("The sides are numbers:".into())]
    } else {
        vec![Line::Words("At the point".into()), Line::Formula(Formula::list(&at, APART))]
    };
    let conditions = conditions(scribe, statement);
    if !conditions.is_empty() {
        lines.push(Line::Words("which meets".into()));
        lines.extend(conditions);
    }
    lines.push(Line::Words(match witness.component.as_str() {
        "" => "the sides are".into(),
        component => format!("the coefficients of {component} are"),
    }));
    lines.push(Line::Formula(side("left", &witness.left)));
    lines.push(Line::Formula(side("right", &witness.right)));
    lines.push(Line::Words(format!("left - right = {}", witness.difference)));
    lines.extend(witness.ratio.as_ref().map(|ratio| Line::Words(format!("Note that {ratio}."))));
    Step::new("Refuted", lines)
}

pub(super) fn open(reason: String) -> Step {
    Step::new("Undecided", vec![Line::Words(reason)])
}

fn conditions(scribe: &mut Scribe, statement: &Statement) -> Vec<Line> {
    let conditions = crate::decide::conditions(scribe.theory, statement);
    conditions.iter().map(|condition| Line::Formula(scribe.condition(condition))).collect()
}

/// Formula of a variable with its value; an unknown function or its derivative is named in the
/// language's notation.
pub(crate) fn assignment(name: &str, value: &str) -> Formula {
    let plain = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    let set = if plain { latex_of_name(name) } else { format!("\\texttt{{{}}}", name.replace('_', "\\_")) };
    Formula::new(format!("{name} = {value}"), format!("{set} = {}", digits(value)))
}

fn side(which: &str, value: &str) -> Formula {
    Formula::new(format!("{which} = {value}"), format!("\\text{{{which}}} = {}", digits(value)))
}

/// Returns a value in LaTeX: `1/2` as a fraction, `3.14…` with its dots.
pub(crate) fn digits(value: &str) -> String {
    let (sign, magnitude) = value.strip_prefix('-').map_or(("", value), |rest| ("-", rest));
    match magnitude.split_once('/') {
        Some((above, below)) => format!("{sign}\\tfrac{{{above}}}{{{below}}}"),
        None => value.replace('…', "\\ldots"),
    }
}
