//! Results of the operations of the calculus, innermost first; the exterior derivative term by
//! term.

use super::definitions::expressions;
use super::scribe::{Formula, Scribe};
use super::{Line, Step};
use crate::calculus::{Blade, Coordinate, Form, contributions};
use crate::expression::{Expr as Scalar, Operation};
use crate::notation::latex_of_name;
use crate::syntax::ast::{Argument, Binary, Expr, ExprKind, ItemKind};
use crate::theory::{Named, Value};

/// Largest number of terms of a derivative that are listed one by one.
const MOST_TERMS: usize = 24;

/// Returns the step that lists the operations in the items on which a statement rests, then those
/// in the statement.
pub(super) fn step(scribe: &mut Scribe, items: &[&ItemKind], claim: &ItemKind) -> Option<Step> {
    let mut operations: Vec<&Expr> = Vec::new();
    for item in items.iter().copied().chain([claim]) {
        let top: &[&Expr] = &expressions(item);
        top.iter().for_each(|expression| collect(expression, &mut operations));
    }
    let mut lines: Vec<Line> = Vec::new();
    let mut known: Vec<Formula> = Vec::new();
    for operation in operations {
        let Some(value) = scribe.value_of(operation) else { continue };
        let (written, value) = (scribe.written(operation), scribe.value(&value));
        let says_nothing = written.text == value.text;
        let formula = written.equals(value);
        if !says_nothing && !known.contains(&formula) {
            lines.extend(terms_of_derivative(scribe, operation));
            lines.push(Line::Formula(formula.clone()));
            known.push(formula);
        }
    }
    (!lines.is_empty()).then(|| Step::new("Results of the exterior calculus", lines))
}

/// Collects wedge products and calls of the calculus, innermost first.
fn collect<'a>(expression: &'a Expr, found: &mut Vec<&'a Expr>) {
    expression.parts().into_iter().for_each(|part| collect(part, found));
    let is_operation = match &*expression.kind {
        ExprKind::Call { function, .. } => is_calculus(&function.text),
        ExprKind::Binary(Binary::Wedge, ..) => has_calculus(expression),
        _ => false,
    };
    if is_operation {
        found.push(expression);
    }
}

/// Whether a function belongs to the calculus and not to the table of operations.
fn is_calculus(name: &str) -> bool {
    name != "sqrt" && Operation::named(name).is_none() && crate::syntax::words::FUNCTIONS.contains(&name)
}

fn has_calculus(expression: &Expr) -> bool {
    expression.parts().into_iter().any(|part| {
        matches!(&*part.kind, ExprKind::Call { function, .. } if is_calculus(&function.text))
            || has_calculus(part)
    })
}

/// Returns the lines of d(w) = Σ ∂w_I/∂xᵢ dxᵢ∧dx_I, one for each nonzero contribution.
fn terms_of_derivative(scribe: &mut Scribe, operation: &Expr) -> Vec<Line> {
    let ExprKind::Call { function, index, arguments } = &*operation.kind else { return vec![] };
    let [Argument::Value(argument)] = arguments.as_slice() else { return vec![] };
    if function.text != "d" {
        return vec![];
    }
    let Some(Value::Form(form)) = scribe.value_of(argument) else { return vec![] };
    let along = along(scribe, index.as_ref());
    let derivatives = derivatives(scribe, &form, &along);
    if derivatives.len() < 2 || derivatives.len() > MOST_TERMS {
        return vec![];
    }
    derivatives
        .into_iter()
        .map(|(coordinate, blade, coefficient, raised, derivative)| {
            let left = partial(scribe, coordinate, coefficient, blade);
            Line::Formula(left.equals(scribe.term(derivative, raised)))
        })
        .collect()
}

/// Returns the coordinates along which a derivative is taken: those of one chart, or all.
fn along(scribe: &Scribe, index: Option<&Expr>) -> Vec<Coordinate> {
    if let Some(ExprKind::Name(name)) = index.map(|index| &*index.kind)
        && let Some(Named::Chart(number)) = scribe.theory.named(name)
    {
        return scribe.theory.charts[*number].coordinates.clone();
    }
    (0..scribe.theory.coordinates.len() as u8).map(Coordinate).collect()
}

/// xᵢ, dx_I, w_I, dx_J and ±∂w_I/∂xᵢ of a contribution.
type Derivative = (Coordinate, Blade, Scalar, Blade, Scalar);

/// Returns the nonzero contributions.
fn derivatives(scribe: &mut Scribe, form: &Form<Scalar>, along: &[Coordinate]) -> Vec<Derivative> {
    let mut found = Vec::new();
    for part in contributions(form, along) {
        let pool = &mut scribe.theory.pool;
        let derivative = pool.derivative(*part.value, scribe.theory.coordinates[part.coordinate.0 as usize]);
        if !pool.is_zero(derivative) {
            let signed = if part.sign < 0 { pool.negate(derivative) } else { derivative };
            found.push((part.coordinate, part.blade, *part.value, part.raised, signed));
        }
    }
    found
}

/// Formula `diff(f, x)*dx^dy^dz`, ∂f/∂x dx∧dy∧dz.
fn partial(scribe: &mut Scribe, coordinate: Coordinate, coefficient: Scalar, blade: Blade) -> Formula {
    let name = scribe.theory.coordinate_name(coordinate).to_owned();
    let function = scribe.scalar(coefficient);
    let others: Vec<String> =
        blade.coordinates().map(|c| scribe.theory.coordinate_name(c).to_owned()).collect();
    let basis: String = others.iter().map(|other| format!("^d{other}")).collect();
    let text = format!("diff({}, {name})*d{name}{basis}", function.text);
    let set: String =
        others.iter().map(|other| format!("\\wedge \\mathrm{{d}}{}", latex_of_name(other))).collect();
    let x = latex_of_name(&name);
    let latex = format!(
        "\\frac{{\\partial}}{{\\partial {x}}}\\left({}\\right)\\,\\mathrm{{d}}{x}{set}",
        function.latex
    );
    Formula::new(text, latex)
}
