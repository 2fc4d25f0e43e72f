//! Steps of a proof: the generators of each case, and the numerators that cancel.

use super::scribe::{Formula, Scribe};
use super::{Line, Step};
use crate::decide::{Bound, Cancellation, Case, Separated, account, separated, vanishing_angles};
use crate::expression::{Expr, Operation};
use crate::normal::Sign;
use crate::theory::Statement;

/// Numerators with more characters in total are put on separate lines.
const LONGEST_SUM: usize = 160;

/// If a numerator is longer than this, only the number of numerators is given.
const LONGEST_NUMERATOR: usize = 400;

/// Returns a step for each case of a proof by normal forms, or for each number or angle that
/// vanishes.
pub(super) fn steps(scribe: &mut Scribe, statement: &Statement) -> Vec<Step> {
    let Some(account) = account(scribe.theory, statement) else {
        let numbers = separated(scribe.theory, statement);
        if !numbers.is_empty() {
            return numbers.iter().map(|number| within_separation(scribe, number)).collect();
        }
        let angles = vanishing_angles(scribe.theory, statement);
        return angles.into_iter().map(|angle| vanishing(scribe, angle)).collect();
    };
    let several = account.cases.len() > 1;
    let cases = account.cases.iter().enumerate();
    cases.map(|(number, case)| step(scribe, case, several.then_some(number + 1))).collect()
}

/// Step for an angle that vanishes: sin D = 0, cos D = 1, −2π < D < 2π.
fn vanishing(scribe: &mut Scribe, angle: Expr) -> Step {
    let pool = &mut scribe.theory.pool;
    let (sine, cosine) = (pool.apply(Operation::Sin, &[angle]), pool.apply(Operation::Cos, &[angle]));
    let [angle, sine, cosine] = [angle, sine, cosine].map(|expression| scribe.plain(expression));
    let equals = |side: &Formula, value: &str| {
        Line::Formula(Formula::new(format!("{} = {value}", side.text), format!("{} = {value}", side.latex)))
    };
    let range =
        Formula::new(format!("-2*pi < {} < 2*pi", angle.text), format!("-2\\pi < {} < 2\\pi", angle.latex));
    let lines = vec![
        Line::Words(
            "The inverse functions are angles whose sines and cosines are algebraic. By normal form".into(),
        ),
        equals(&sine, "0"),
        equals(&cosine, "1"),
        Line::Words("so that the angle is a multiple of a full turn; their principal values give".into()),
        Line::Formula(range),
        Line::Words("and the only multiple in this range is".into()),
        equals(&angle, "0"),
    ];
    Step::new("Left minus right, as an angle", lines)
}

/// Step for a number that vanishes by its separation bound: |D| < 2⁻ⁿ, and D = 0 or |D| ≥ 2⁻ⁿ.
fn within_separation(scribe: &mut Scribe, separated: &Separated) -> Step {
    let number = scribe.plain(separated.number);
    let places = separated.places;
    let compared = |relation: &str, latex: &str| {
        Line::Formula(Formula::new(
            format!("abs({}) {relation} 2**-{places}", number.text),
            format!("\\left|{}\\right| {latex} 2^{{-{places}}}", number.latex),
        ))
    };
    let lines = vec![
        Line::Words(
            "The difference is an algebraic number. If it were not zero, its separation bound would give"
                .into(),
        ),
        compared(">=", "\\ge"),
        Line::Words("but an enclosure with rational ends shows".into()),
        compared("<", "<"),
    ];
    Step::new("Left minus right, as an algebraic number", lines)
}

fn step(scribe: &mut Scribe, case: &Case, number: Option<usize>) -> Step {
    let title = match number {
        Some(number) => format!("Left minus right, case {number}"),
        None => "Left minus right".to_string(),
    };
    let mut lines = Vec::new();
    if !case.signs.is_empty() {
        lines.push(Line::Words(if number.is_some() { "Where" } else { "With the signs" }.into()));
        lines.extend(case.signs.iter().map(|&(factor, sign)| Line::Formula(signed(scribe, factor, sign))));
    }
    if case.components.is_empty() {
        lines.push(Line::Words("Both sides are the same.".into()));
    }
    let relations: Vec<Line> = case.generators.iter().flat_map(|bound| relation(scribe, bound)).collect();
    if !relations.is_empty() {
        lines.push(Line::Words(
            "The computation uses polynomials in the variables and these generators:".into(),
        ));
        lines.extend(relations);
    }
    for component in &case.components {
        lines.extend(cancellation(scribe, component));
    }
    Step::new(title, lines)
}

fn signed(scribe: &mut Scribe, factor: crate::expression::Expr, sign: Sign) -> Formula {
    let factor = scribe.plain(factor);
    match sign {
        Sign::Positive => Formula::new(format!("{} >= 0", factor.text), format!("{} \\ge 0", factor.latex)),
        Sign::Negative => Formula::new(format!("{} <= 0", factor.text), format!("{} \\le 0", factor.latex)),
    }
}

/// Returns a generator ρ, with ρⁿ = f if that relation defines it; for a half-angle tangent, the
/// sine in terms of it.
fn relation(scribe: &mut Scribe, bound: &Bound) -> Vec<Line> {
    let generator = scribe.plain(bound.generator);
    let formula = match (&bound.relation, bound.half_angle) {
        (Some((order, value)), _) => {
            let value = scribe.plain(*value);
            let raised = Formula::new(
                format!("({})**{order}", generator.text),
                format!("\\left({}\\right)^{{{order}}}", generator.latex),
            );
            raised.equals(value)
        }
        (None, Some(angle)) => {
            let angle = scribe.plain(angle);
            let sine =
                Formula::new(format!("sin({})", angle.text), format!("\\sin\\left({}\\right)", angle.latex));
            let quotient = Formula::new(
                format!("2*t/(1 + t**2), t = {}", generator.text),
                format!("\\frac{{2\\,t}}{{1 + t^{{2}}}},\\quad t = {}", generator.latex),
            );
            sine.equals(quotient)
        }
        (None, None) => generator,
    };
    vec![Line::Formula(formula)]
}

/// Returns the numerators over one denominator and the fact that their sum is zero: in one formula,
/// or with a line for each numerator.
fn cancellation(scribe: &mut Scribe, component: &Cancellation) -> Vec<Line> {
    let numerators: Vec<Formula> = component.numerators.iter().map(|&n| scribe.plain(n)).collect();
    let denominator = scribe.plain(component.denominator);
    let place = match component.component.as_str() {
        "" => "Left minus right".to_string(),
        component => format!("The coefficient of {component}"),
    };
    let lengths: Vec<usize> = numerators.iter().map(|n| n.text.chars().count()).collect();
    if lengths.iter().any(|&length| length > LONGEST_NUMERATOR) {
        let count = numerators.len();
        return vec![Line::Words(format!(
            "{place} has {count} numerators, which add up to the zero polynomial."
        ))];
    }
    let over = Line::Formula(denominator.clone());
    if lengths.iter().sum::<usize>() > LONGEST_SUM {
        let above = [Line::Words(format!("{place} has, over the denominator")), over];
        let between = [Line::Words("these numerators, which add up to 0:".into())];
        let each = numerators.into_iter().map(Line::Formula);
        return above.into_iter().chain(between).chain(each).collect();
    }
    let sum = |part: fn(&Formula) -> &str, brackets: [&str; 2]| {
        let parts: Vec<String> =
            numerators.iter().map(|n| format!("{}{}{}", brackets[0], part(n), brackets[1])).collect();
        parts.join(" + ")
    };
    let mut text = sum(|n| &n.text, ["(", ")"]);
    let mut latex = sum(|n| &n.latex, ["\\left(", "\\right)"]);
    if denominator.text != "1" {
        text = format!("({text})/({})", denominator.text);
        latex = format!("\\frac{{{latex}}}{{{}}}", denominator.latex);
    }
    let formula = Line::Formula(Formula::new(format!("{text} = 0"), format!("{latex} = 0")));
    if component.component.is_empty() {
        vec![formula]
    } else {
        vec![Line::Words(format!("{place}:")), formula]
    }
}
