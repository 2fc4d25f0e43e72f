//! Results of kernels, and the forms by which they are computed: the one after `by`, and those for a precision or target.

use super::evaluation::Evaluated;
use super::items::Resolver;
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Rational, Shape, Symbol};
use crate::syntax::ast::{self, Item, ItemKind, Name};
use crate::theory::{FormTarget, TargetForm};
use num_traits::Signed;

/// Precision of the form after `by`.
const DOUBLE: &str = "f64";

/// Results of a kernel: their shapes, and all numbers in them.
#[derive(Clone, Default)]
pub(super) struct Results {
    pub(super) shapes: Vec<Shape>,
    pub(super) numbers: Vec<Expr>,
}

/// Forms of a kernel.
pub(super) struct Forms {
    /// The form after `by`; empty if there is none.
    pub(super) computed: Vec<Expr>,
    /// Its tolerance.
    pub(super) approximation: Option<Rational>,
    pub(super) target_forms: Vec<TargetForm>,
}

impl Resolver {
    /// Evaluates the forms of a kernel, with the conditions under which their integrals are valid.
    pub(super) fn kernel_forms(
        &mut self,
        item: &Item,
        symbols: &[Symbol],
        results: &Results,
    ) -> Evaluated<(Forms, Vec<Condition>)> {
        let ItemKind::Kernel { name, computed, approximation, target_forms, .. } = &item.kind else {
            return Err(Diagnostic::new(item.span, "expected a kernel"));
        };
        let (others, of_double): (Vec<_>, Vec<_>) =
            target_forms.iter().partition(|form| form.target.text != DOUBLE);
        let (computed, approximation) = match of_double.as_slice() {
            [] => (computed, approximation),
            [form] if computed.is_empty() => (&form.computed, &form.approximation),
            [.., form] => {
                return Err(Diagnostic::new(form.target.span, "the form after `by` is the one for `f64`")
                    .with_help("write `for f32 { by … }` for the form of another precision"));
            }
        };
        let mut form = |computed: &[ast::Expr], span: Span| {
            let ((form, narrowing), ..) = self.evaluate(|evaluator| {
                let results = evaluator.kernel_results(computed, symbols)?;
                Ok((results, evaluator.scope.narrowing().clone()))
            })?;
            check_count(&results.numbers, &form.numbers, name, span)?;
            check_shapes(results, &form, name, span)?;
            Ok((form.numbers, narrowing))
        };
        let (computed, mut narrowings) = form(computed, item.span)?;
        let mut outputs = Vec::new();
        for given in &others {
            let (form, narrowing) = form(&given.computed, given.target.span)?;
            narrowings.extend(narrowing);
            outputs.push(form);
        }
        let approximation = approximation.as_ref().map(|given| self.tolerance(given)).transpose()?;
        let target_forms = self.target_forms(&others, outputs)?;
        Ok((Forms { computed, approximation, target_forms }, narrowings.into_iter().collect()))
    }

    /// Returns the forms for other precisions and targets than `f64`, given the outputs of each.
    fn target_forms(
        &mut self,
        given: &[&ast::TargetForm],
        outputs: Vec<Vec<Expr>>,
    ) -> Evaluated<Vec<TargetForm>> {
        let mut forms: Vec<TargetForm> = Vec::new();
        for (ast::TargetForm { target: Name { text, span }, approximation, .. }, outputs) in
            given.iter().zip(outputs)
        {
            let Some(target) = FormTarget::ALL.into_iter().find(|target| target.name() == text) else {
                let message =
                    format!("`{text}` is not a precision or target that can have a form of its own");
                let help = "`f32`, `f64`, `c`, `cuda` and `wgsl` can; Rust computes the form for `f64`";
                return Err(Diagnostic::new(*span, message).with_help(help));
            };
            if forms.iter().any(|form| form.target == target) {
                return Err(Diagnostic::new(*span, format!("a kernel has at most one form for `{text}`")));
            }
            let approximation = approximation.as_ref().map(|given| self.tolerance(given)).transpose()?;
            forms.push(TargetForm { target, outputs, approximation, span: *span });
        }
        Ok(forms)
    }

    /// Evaluates the number after `approx`.
    fn tolerance(&mut self, given: &ast::Expr) -> Evaluated<Rational> {
        let (value, _, _) = self.evaluate(|evaluator| evaluator.scalar(given))?;
        let half = Rational::new(1.into(), 2.into());
        match self.theory.pool.as_number(value).filter(|number| number.is_positive() && **number < half) {
            Some(number) => Ok(number.clone()),
            None => Err(Diagnostic::new(given.span, "expected a rational number above 0 and below 1/2")
                .with_help("`approx 1e-17` allows a form to differ from its formula by 1e-17 of its value")),
        }
    }
}

/// Checks that the form given by `by` has as many outputs as the formula.
pub(super) fn check_count(outputs: &[Expr], computed: &[Expr], name: &Name, span: Span) -> Evaluated<()> {
    if computed.is_empty() || computed.len() == outputs.len() {
        return Ok(());
    }
    let (wanted, found) = (outputs.len(), computed.len());
    Err(Diagnostic::new(span, format!("`{}` has {wanted} outputs, but `by` gives {found}", name.text)))
}

/// Checks that the form given by `by` has the shapes of the formula.
fn check_shapes(outputs: &Results, computed: &Results, name: &Name, span: Span) -> Evaluated<()> {
    match outputs.shapes.iter().zip(&computed.shapes).find(|(wanted, found)| wanted != found) {
        None => Ok(()),
        Some((wanted, found)) => {
            let message = format!("the result of `{}` is {wanted}, but `by` gives {found}", name.text);
            Err(Diagnostic::new(span, message))
        }
    }
}
