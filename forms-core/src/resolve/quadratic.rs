//! Right side of a `metric` declaration: a quadratic form in the differentials, where `*` is the
//! symmetric product.

use super::evaluation::{Evaluated, Evaluator};
use crate::calculus::{Coordinate, Form};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Expr, Rational};
use crate::syntax::ast::{self, Binary, ExprKind};
use crate::theory::{Named, Value};
use std::collections::BTreeMap;

/// Entries gᵢⱼ with i ≤ j; an off-diagonal entry stands for both gᵢⱼ and gⱼᵢ.
pub(super) type Entries = BTreeMap<(Coordinate, Coordinate), Expr>;

/// Symmetric tensor of degree 0, 1 or 2.
enum Tensor {
    /// A scalar, the literal 0 included.
    Scalar(Value),
    /// A 1-form.
    Linear(Form<Expr>),
    /// A quadratic form.
    Quadratic(Entries),
}

impl Tensor {
    fn kind(&self) -> &'static str {
        match self {
            Tensor::Scalar(_) => "a scalar",
            Tensor::Linear(_) => "a 1-form",
            Tensor::Quadratic(_) => "a quadratic form",
        }
    }
}

impl Evaluator<'_> {
    /// Evaluates an expression that must be a quadratic form, and returns its entries.
    pub(super) fn quadratic_form(&mut self, expression: &ast::Expr) -> Evaluated<Entries> {
        match self.tensor(expression)? {
            Tensor::Quadratic(entries) => Ok(entries),
            other => Err(Diagnostic::new(
                expression.span,
                format!("a metric is a quadratic form in the differentials, and this is {}", other.kind()),
            )
            .with_help("write it as in `dx**2 + dy**2` or `dx*dy`")),
        }
    }

    /// Evaluates a symmetric tensor. Chains of operators are evaluated in a loop, as for any
    /// expression.
    fn tensor(&mut self, expression: &ast::Expr) -> Evaluated<Tensor> {
        let mut spine = Vec::new();
        let mut leftmost = expression;
        while let ExprKind::Binary(operator, place, left, right) = &*leftmost.kind {
            if *operator == Binary::Wedge {
                break;
            }
            spine.push((*operator, *place, left.span, right));
            leftmost = left;
        }
        let mut tensor = self.leaf(leftmost)?;
        while let Some((operator, place, left_span, right)) = spine.pop() {
            tensor = self.combined(operator, place, (tensor, left_span), right)?;
            self.check_size(place)?;
        }
        Ok(tensor)
    }

    fn leaf(&mut self, expression: &ast::Expr) -> Evaluated<Tensor> {
        match &*expression.kind {
            ExprKind::Negate(inner) => {
                let tensor = self.tensor(inner)?;
                let minus_one = self.theory.pool.integer(-1);
                return self
                    .scaled(tensor, |evaluator, value| Ok(evaluator.theory.pool.multiply(minus_one, value)));
            }
            ExprKind::Name(name) if matches!(self.theory.named(name), Some(Named::Metric(_))) => {
                let named = self.metric_named(name, expression.span)?;
                let entries = named.metric.entries().iter().filter(|((i, j), _)| i <= j);
                return Ok(Tensor::Quadratic(entries.map(|(place, value)| (*place, *value)).collect()));
            }
            ExprKind::Binary(operator, ..) if *operator != Binary::Wedge => return self.tensor(expression),
            _ => {}
        }
        match self.value(expression)? {
            value @ (Value::Zero | Value::Scalar(_)) => Ok(Tensor::Scalar(value)),
            Value::Form(form) if form.degree() == 1 => Ok(Tensor::Linear(form)),
            other => Err(Diagnostic::new(
                expression.span,
                format!("a metric is built from 1-forms, and this is {}", other.kind()),
            )
            .with_help("inside a metric `*` is the symmetric product: dx*dy")),
        }
    }

    fn combined(
        &mut self,
        operator: Binary,
        place: Span,
        (left, left_span): (Tensor, Span),
        right: &ast::Expr,
    ) -> Evaluated<Tensor> {
        if operator == Binary::Power {
            return self.raised((left, left_span), right);
        }
        let other = self.tensor(right)?;
        match operator {
            Binary::Add => self.tensor_sum(left, other, place),
            Binary::Subtract => {
                let minus_one = self.theory.pool.integer(-1);
                let negated = self
                    .scaled(other, |evaluator, value| Ok(evaluator.theory.pool.multiply(minus_one, value)))?;
                self.tensor_sum(left, negated, place)
            }
            Binary::Divide => {
                let Tensor::Scalar(divisor) = other else {
                    return Err(Diagnostic::new(right.span, format!("cannot divide by {}", other.kind())));
                };
                self.scaled(left, |evaluator, value| {
                    match evaluator.quotient(Value::Scalar(value), divisor.clone(), right.span)? {
                        Value::Scalar(quotient) => Ok(quotient),
                        _ => Ok(value),
                    }
                })
            }
            _ => self.tensor_product(left, other, place),
        }
    }

    /// Applies a function to each coefficient.
    fn scaled(
        &mut self,
        tensor: Tensor,
        mut change: impl FnMut(&mut Self, Expr) -> Evaluated<Expr>,
    ) -> Evaluated<Tensor> {
        Ok(match tensor {
            Tensor::Scalar(value) => {
                let scalar = self.scalar_of(&value);
                Tensor::Scalar(Value::Scalar(change(self, scalar)?))
            }
            Tensor::Linear(form) => {
                let mut terms = Vec::with_capacity(form.terms().len());
                for (blade, value) in form.terms() {
                    terms.push((*blade, change(self, *value)?));
                }
                Tensor::Linear(Form::from_terms(1, terms))
            }
            Tensor::Quadratic(entries) => {
                let mut changed = Entries::new();
                for (place, value) in entries {
                    changed.insert(place, change(self, value)?);
                }
                Tensor::Quadratic(changed)
            }
        })
    }

    fn scalar_of(&mut self, value: &Value) -> Expr {
        if let Value::Scalar(scalar) = value { *scalar } else { self.zero() }
    }

    fn tensor_sum(&mut self, left: Tensor, right: Tensor, place: Span) -> Evaluated<Tensor> {
        match (left, right) {
            (Tensor::Scalar(Value::Zero), other) | (other, Tensor::Scalar(Value::Zero)) => Ok(other),
            (Tensor::Scalar(a), Tensor::Scalar(b)) => Ok(Tensor::Scalar(self.sum(a, b, place)?)),
            (Tensor::Linear(a), Tensor::Linear(b)) => Ok(Tensor::Linear(a.add(&mut self.ring(), &b))),
            (Tensor::Quadratic(mut a), Tensor::Quadratic(b)) => {
                for (place, value) in b {
                    self.add_entry(&mut a, place, value);
                }
                Ok(Tensor::Quadratic(a))
            }
            (a, b) => Err(Diagnostic::new(place, format!("cannot add {} and {}", a.kind(), b.kind()))),
        }
    }

    fn add_entry(&mut self, entries: &mut Entries, place: (Coordinate, Coordinate), value: Expr) {
        let zero = self.zero();
        let entry = entries.entry(place).or_insert(zero);
        *entry = self.theory.pool.add(*entry, value);
    }

    fn tensor_product(&mut self, left: Tensor, right: Tensor, place: Span) -> Evaluated<Tensor> {
        match (left, right) {
            (Tensor::Scalar(a), Tensor::Scalar(b)) => Ok(Tensor::Scalar(self.product(a, b, place)?)),
            (Tensor::Scalar(a), other) | (other, Tensor::Scalar(a)) => {
                let factor = self.scalar_of(&a);
                self.scaled(other, |evaluator, value| Ok(evaluator.theory.pool.multiply(factor, value)))
            }
            (Tensor::Linear(a), Tensor::Linear(b)) => Ok(Tensor::Quadratic(self.symmetric_product(&a, &b))),
            (a, b) => Err(Diagnostic::new(
                place,
                format!("the product of {} and {} is not quadratic in the differentials", a.kind(), b.kind()),
            )),
        }
    }

    /// Returns the symmetric product a b = Σ (aᵢbⱼ + aⱼbᵢ)/2 dxⁱ dxʲ.
    fn symmetric_product(&mut self, a: &Form<Expr>, b: &Form<Expr>) -> Entries {
        let half = self.theory.pool.number(Rational::new(1.into(), 2.into()));
        let mut entries = Entries::new();
        for (left, p) in a.terms() {
            for (right, q) in b.terms() {
                let (Some(i), Some(j)) = (left.coordinates().next(), right.coordinates().next()) else {
                    continue;
                };
                let product = self.theory.pool.multiply(*p, *q);
                let share = if i == j { product } else { self.theory.pool.multiply(half, product) };
                self.add_entry(&mut entries, (i.min(j), i.max(j)), share);
            }
        }
        entries
    }

    /// Evaluates `dx**2` and powers of scalars.
    fn raised(&mut self, (base, span): (Tensor, Span), exponent: &ast::Expr) -> Evaluated<Tensor> {
        match base {
            Tensor::Scalar(value) => Ok(Tensor::Scalar(self.power((value, span), exponent)?)),
            Tensor::Linear(form) => {
                let written = self.scalar(exponent)?;
                let two = Rational::from_integer(2.into());
                if self.theory.pool.as_number(written) != Some(&two) {
                    let message = "inside a metric a 1-form is squared or multiplied by another one";
                    return Err(Diagnostic::new(exponent.span, message).with_help("write `dx**2`"));
                }
                Ok(Tensor::Quadratic(self.symmetric_product(&form, &form)))
            }
            Tensor::Quadratic(_) => Err(Diagnostic::new(
                span,
                "a power of a quadratic form is not quadratic in the differentials",
            )),
        }
    }
}
