//! The scribe writes values and source expressions as formulas, in both notations at once.

use crate::calculus::{Blade, Form};
use crate::expression::{Condition, Expr};
use crate::notation::{latex, latex_as_written, latex_of_relation, simplify, text};
use crate::resolve::Trace;
use crate::syntax::Source;
use crate::syntax::ast::{self, Binary, ExprKind};
use crate::theory::{Theory, Value};

/// A value that takes more characters is represented by its size.
const LONGEST: usize = 600;

/// A formula in the language's notation and in LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Formula {
    /// The formula in the language's notation, with `=` for equality.
    pub text: String,
    /// The formula in LaTeX.
    pub latex: String,
}

/// Separator between formulas on one line.
pub(super) const APART: &str = ",\\quad ";

impl Formula {
    pub(super) fn new(text: impl Into<String>, latex: impl Into<String>) -> Self {
        Formula { text: text.into(), latex: latex.into() }
    }

    /// Returns the formula a = b.
    pub(super) fn equals(self, right: Formula) -> Self {
        Formula::new(format!("{} = {}", self.text, right.text), format!("{} = {}", self.latex, right.latex))
    }

    /// Joins formulas with commas, and in LaTeX with the given separator.
    pub(super) fn list(formulas: &[Formula], between: &str) -> Self {
        let join = |part: fn(&Formula) -> &str, between: &str| {
            formulas.iter().map(part).collect::<Vec<_>>().join(between)
        };
        Formula::new(join(|f| &f.text, ", "), join(|f| &f.latex, between))
    }
}

/// Writes formulas about one theory and its source.
pub(super) struct Scribe<'a> {
    pub(super) source: &'a Source,
    pub(super) theory: &'a mut Theory,
    pub(super) trace: &'a Trace,
    /// Conditions that hold at the points of the statement.
    pub(super) assumptions: &'a [Condition],
}

impl Scribe<'_> {
    /// Returns an expression as its author wrote it, on one line.
    pub(super) fn written(&self, expression: &ast::Expr) -> Formula {
        Formula::new(self.text_as_written(expression), latex_as_written(self.theory, expression))
    }

    /// Returns the text of an expression in its source. The text of an expression without a place
    /// in the source, such as a claim of a warp, is assembled.
    fn text_as_written(&self, expression: &ast::Expr) -> String {
        let of = |part: &ast::Expr| self.text_as_written(part);
        let factor = |part: &ast::Expr| match &*part.kind {
            ExprKind::Binary(Binary::Add | Binary::Subtract, ..) => format!("({})", of(part)),
            _ => of(part),
        };
        let span = expression.span.start as usize..expression.span.end as usize;
        match &*expression.kind {
            _ if !span.is_empty() => {
                let text = self.source.text.get(span).unwrap_or_default();
                text.split_whitespace().collect::<Vec<_>>().join(" ")
            }
            ExprKind::Name(name) => name.clone(),
            ExprKind::Number(value) => value.to_string(),
            ExprKind::Basis(name) => format!("@{}", name.text),
            ExprKind::Negate(inner) => format!("-{}", factor(inner)),
            ExprKind::Binary(Binary::Add, _, a, b) => format!("{} + {}", of(a), of(b)),
            ExprKind::Binary(Binary::Wedge, _, a, b) => format!("{}^{}", factor(a), factor(b)),
            ExprKind::Binary(_, _, a, b) => format!("{}*{}", factor(a), factor(b)),
            ExprKind::Call { function, arguments, .. } => {
                let values = arguments.iter().map(|argument| match argument {
                    ast::Argument::Value(value) => of(value),
                    ast::Argument::Range { variable, .. } => variable.text.clone(),
                });
                format!("{}({})", function.text, values.collect::<Vec<_>>().join(", "))
            }
            ExprKind::Index { .. } | ExprKind::Array(_) | ExprKind::Select { .. } => String::new(),
        }
    }

    /// Returns a value, simplified under the statement's conditions.
    pub(super) fn value(&mut self, value: &Value) -> Formula {
        let simple = simplify(self.theory, self.assumptions, value);
        let written = text(self.theory, &simple);
        let length = written.chars().count();
        if length > LONGEST {
            let size = format!("{} of {length} characters", value.kind());
            return Formula::new(format!("({size})"), format!("\\langle\\text{{{size}}}\\rangle"));
        }
        Formula::new(written, latex(self.theory, &simple))
    }

    /// Returns a scalar, simplified.
    pub(super) fn scalar(&mut self, scalar: Expr) -> Formula {
        self.value(&Value::Scalar(scalar))
    }

    /// Returns a scalar without simplification.
    pub(super) fn plain(&mut self, scalar: Expr) -> Formula {
        let value = Value::Scalar(scalar);
        Formula::new(text(self.theory, &value), latex(self.theory, &value))
    }

    /// Returns a coefficient with its basis form.
    pub(super) fn term(&mut self, coefficient: Expr, blade: Blade) -> Formula {
        if blade == Blade::SCALAR {
            return self.scalar(coefficient);
        }
        self.value(&Value::Form(Form::from_terms(blade.degree(), [(blade, coefficient)])))
    }

    /// Returns a condition without simplification.
    pub(super) fn condition(&mut self, condition: &Condition) -> Formula {
        let [left, right] = [condition.left, condition.right].map(|side| self.plain(side));
        Formula::new(
            condition.text(&self.theory.pool),
            format!("{} {} {}", left.latex, latex_of_relation(condition.relation), right.latex),
        )
    }

    /// Returns the value to which an expression of the source was evaluated.
    pub(super) fn value_of(&self, expression: &ast::Expr) -> Option<Value> {
        self.trace.get(&expression.span).cloned()
    }
}
