//! Metrics: their declaration, and the operations that take a metric.

use super::arguments::exactly;
use super::evaluation::{Evaluated, Evaluator};
use super::items::Resolver;
use super::quadratic::Entries;
use crate::assume::vanishes;
use crate::calculus::{
    Coordinate, Form, Metric, codifferential, curl, divergence, flat, gradient, hodge, inner_of_fields,
    inner_of_forms, laplacian, sharp, volume,
};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Relation};
use crate::syntax::ast::{self, ExprKind, Name};
use crate::theory::names::unusable;
use crate::theory::{Named, NamedMetric, Value, describe};
use num_rational::Ratio;

/// Maximum number of coordinates that one metric can couple with each other; larger blocks have too
/// many minors.
const LARGEST_BLOCK: u32 = 8;

impl Resolver {
    pub(super) fn metric(
        &mut self,
        name: &Name,
        chart: Option<&Name>,
        expression: &ast::Expr,
    ) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let ((chart, metric, regular), mut domain, used) = self.evaluate(|evaluator| {
            let entries = evaluator.quadratic_form(expression)?;
            let chart = evaluator.chart_of_metric(name, chart, &entries, expression.span)?;
            let metric = evaluator.metric_on(chart, &entries, expression.span)?;
            let regular = evaluator.where_regular(&metric, expression.span)?;
            Ok((chart, metric, regular))
        })?;
        domain.extend(regular);
        self.theory.metrics.push(NamedMetric { chart, metric, domain, used });
        self.theory.names.set(name, Named::Metric(self.theory.metrics.len() - 1));
        Ok(())
    }
}

impl Evaluator<'_> {
    /// Returns the index of the named chart, or else of the chart whose coordinates are those of
    /// the differentials.
    fn chart_of_metric(
        &mut self,
        name: &Name,
        chart: Option<&Name>,
        entries: &Entries,
        span: Span,
    ) -> Evaluated<usize> {
        let mut coordinates: Vec<Coordinate> = entries.keys().flat_map(|&(i, j)| [i, j]).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        if let Some(chart) = chart {
            self.check_on_chart(chart, coordinates, "d", span)?;
            return self.chart(chart);
        }
        let fits = |number: &usize| {
            let mut own = self.theory.charts[*number].coordinates.clone();
            own.sort_unstable();
            own == coordinates
        };
        let fitting: Vec<usize> = (0..self.theory.charts.len()).filter(fits).collect();
        match fitting.as_slice() {
            [chart] => Ok(*chart),
            [] => Err(Diagnostic::new(name.span, "no chart has exactly the coordinates of this metric")
                .with_help(format!("name its chart: metric {} on C = …", name.text))),
            _ => Err(Diagnostic::new(name.span, "several charts have the coordinates of this metric")
                .with_help(format!("name its chart: metric {} on C = …", name.text))),
        }
    }

    fn metric_on(&mut self, chart: usize, entries: &Entries, span: Span) -> Evaluated<Metric<Expr>> {
        let order = self.theory.charts[chart].coordinates.clone();
        if Metric::largest_block(&order, entries) > LARGEST_BLOCK {
            return Err(Diagnostic::new(
                span,
                format!("the metric couples more than {LARGEST_BLOCK} coordinates with each other"),
            ));
        }
        Ok(Metric::new(&mut self.ring(), &order, entries))
    }

    /// Returns the conditions under which the determinant is not zero; an error if it vanishes
    /// everywhere.
    fn where_regular(&mut self, metric: &Metric<Expr>, span: Span) -> Evaluated<Vec<Condition>> {
        let blocks: Vec<Expr> = metric.block_determinants().copied().collect();
        if blocks.iter().any(|&determinant| vanishes(&self.theory.pool, determinant)) {
            return Err(Diagnostic::new(span, "the metric is degenerate: its determinant is zero")
                .with_help("the 1-forms of a metric must span all coordinate directions of its chart"));
        }
        let right = self.zero();
        let factors = blocks.iter().flat_map(|&block| self.theory.pool.factors_that_may_vanish(block));
        let factors: Vec<Expr> = factors.collect();
        Ok(factors.into_iter().map(|left| Condition { left, relation: Relation::NotEqual, right }).collect())
    }

    /// Returns the metric with this name and records its dependencies in the scope.
    pub(super) fn metric_named(&mut self, text: &str, span: Span) -> Evaluated<NamedMetric> {
        match self.theory.named(text) {
            Some(Named::Metric(number)) => {
                let named = self.theory.metrics[*number].clone();
                self.scope.mention(text);
                named.domain.iter().for_each(|condition| self.scope.require(*condition));
                named.used.iter().for_each(|symbol| self.scope.touch(*symbol));
                Ok(named)
            }
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, text, span)),
            Some(other) => {
                Err(Diagnostic::new(span, format!("expected a metric, but `{text}` is {}", describe(other))))
            }
            None => Err(self.theory.names.unknown(text, span, "`metric`")),
        }
    }

    fn metric_index(&mut self, index: &ast::Expr) -> Evaluated<NamedMetric> {
        let ExprKind::Name(text) = &*index.kind else {
            return Err(Diagnostic::new(index.span, "expected the name of a metric"));
        };
        self.metric_named(text, index.span)
    }

    /// Evaluates `volume[g]`.
    pub(super) fn volume(&mut self, index: &ast::Expr) -> Evaluated<Value> {
        let named = self.metric_index(index)?;
        Ok(Value::Form(volume(&mut self.ring(), &named.metric)))
    }

    /// Evaluates `hodge[g](w)` and the other operations that take a metric.
    pub(super) fn metric_operation(
        &mut self,
        function: &Name,
        index: Option<&ast::Expr>,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let name = function.text.as_str();
        let Some(index) = index else {
            return Err(Diagnostic::new(function.span, format!("`{name}` needs a metric"))
                .with_help(format!("write `{name}[g]` for a metric g")));
        };
        if name == "volume" {
            return Err(Diagnostic::new(span, "`volume[g]` takes no arguments"));
        }
        let NamedMetric { metric, chart, .. } = self.metric_index(index)?;
        if name == "inner" {
            let [a, b] = exactly::<2>(arguments, name, span)?;
            return self.inner(&metric, chart, (a, b), span);
        }
        let [argument] = exactly::<1>(arguments, name, span)?;
        match name {
            "hodge" | "codiff" | "laplace" => self.on_form(name, &metric, chart, argument),
            "sharp" => {
                let w = self.form_on(chart, argument)?;
                if w.degree() != 1 {
                    let message = format!("`sharp` takes a 1-form, and this has degree {}", w.degree());
                    return Err(Diagnostic::new(argument.span, message));
                }
                Ok(Value::Field(sharp(&mut self.ring(), &metric, &w)))
            }
            "grad" => {
                let f = self.scalar(argument)?;
                Ok(Value::Field(gradient(&mut self.ring(), &metric, &f)))
            }
            "norm" => self.norm(&metric, chart, argument),
            _ => self.on_field(name, &metric, chart, argument),
        }
    }

    fn on_form(
        &mut self,
        name: &str,
        metric: &Metric<Expr>,
        chart: usize,
        argument: &ast::Expr,
    ) -> Evaluated<Value> {
        let w = self.form_on(chart, argument)?;
        let zero = self.zero();
        if w.degree() > metric.dimension() || (name == "codiff" && w.degree() == 0) {
            return Ok(Value::Zero);
        }
        let mut ring = self.ring();
        let result = match name {
            "hodge" => hodge(&mut ring, metric, &w),
            "codiff" => codifferential(&mut ring, metric, &w),
            _ => laplacian(&mut ring, metric, &w),
        };
        Ok(Value::from_form(result, zero))
    }

    /// Evaluates `flat`, `div` and `curl`.
    fn on_field(
        &mut self,
        name: &str,
        metric: &Metric<Expr>,
        chart: usize,
        argument: &ast::Expr,
    ) -> Evaluated<Value> {
        let x = self.field(argument)?;
        self.check_directions(chart, x.components().map(|part| part.0).collect(), "@", argument.span)?;
        let mut ring = self.ring();
        match name {
            "flat" => Ok(Value::Form(flat(&mut ring, metric, &x))),
            "div" => Ok(Value::Scalar(divergence(&mut ring, metric, &x))),
            _ if metric.dimension() == 3 => Ok(Value::Field(curl(&mut ring, metric, &x))),
            _ => Err(Diagnostic::new(
                argument.span,
                format!("`curl` needs three dimensions, and the metric has {}", metric.dimension()),
            )
            .with_help("in any dimension, d(flat[g](X)) is the 2-form that corresponds to the curl")),
        }
    }

    fn inner(
        &mut self,
        metric: &Metric<Expr>,
        chart: usize,
        (left, right): (&ast::Expr, &ast::Expr),
        span: Span,
    ) -> Evaluated<Value> {
        let (a, b) = (self.value(left)?, self.value(right)?);
        for (value, written) in [(&a, left), (&b, right)] {
            self.check_value_on(chart, value, written.span)?;
        }
        match (a, b) {
            (Value::Zero, _) | (_, Value::Zero) => Ok(Value::Zero),
            (Value::Scalar(a), Value::Scalar(b)) => Ok(Value::Scalar(self.theory.pool.multiply(a, b))),
            (Value::Field(x), Value::Field(y)) => {
                Ok(Value::Scalar(inner_of_fields(&mut self.ring(), metric, &x, &y)))
            }
            (Value::Form(a), Value::Form(b)) if a.degree() == b.degree() => {
                Ok(Value::Scalar(inner_of_forms(&mut self.ring(), metric, &a, &b)))
            }
            (a, b) => Err(Diagnostic::new(
                span,
                format!(
                    "`inner` takes two forms of one degree or two fields, found {} and {}",
                    a.kind(),
                    b.kind()
                ),
            )
            .with_help("`flat[g](X)` converts a field to a 1-form, `sharp[g](w)` a 1-form to a field")),
        }
    }

    /// Evaluates the norm: √g(X, X) of a field, √⟨w, w⟩ of a form, the absolute value of a scalar.
    fn norm(&mut self, metric: &Metric<Expr>, chart: usize, argument: &ast::Expr) -> Evaluated<Value> {
        let value = self.value(argument)?;
        self.check_value_on(chart, &value, argument.span)?;
        let square = match value {
            Value::Zero => return Ok(Value::Zero),
            Value::Scalar(f) => {
                let magnitude = self.theory.pool.apply(crate::expression::Operation::Abs, &[f]);
                return Ok(Value::Scalar(magnitude));
            }
            Value::Field(x) => inner_of_fields(&mut self.ring(), metric, &x, &x),
            Value::Form(w) => inner_of_forms(&mut self.ring(), metric, &w, &w),
            Value::Array(array) => {
                let message = format!("expected a scalar, form or field, found {}", array.shape);
                return Err(Diagnostic::new(argument.span, message)
                    .with_help("`norm(p)` is the Euclidean length of a vector"));
            }
        };
        let domain = self.theory.pool.power_domain(square, Ratio::new(1, 2));
        self.require(domain);
        Ok(Value::Scalar(self.theory.pool.sqrt(square)))
    }

    /// Evaluates a form with differentials of the chart only; a scalar is a form of degree 0.
    fn form_on(&mut self, chart: usize, argument: &ast::Expr) -> Evaluated<Form<Expr>> {
        let value = self.value(argument)?;
        self.check_value_on(chart, &value, argument.span)?;
        match value {
            Value::Zero => Ok(Form::zero(0)),
            Value::Scalar(f) => Ok(Form::scalar(&self.ring(), f)),
            Value::Form(form) => Ok(form),
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("expected a form, found {}", other.kind());
                Err(Diagnostic::new(argument.span, message)
                    .with_help("`flat[g](X)` converts a field to a 1-form"))
            }
        }
    }

    fn check_value_on(&self, chart: usize, value: &Value, span: Span) -> Evaluated<()> {
        match value {
            Value::Zero | Value::Scalar(_) | Value::Array(_) => Ok(()),
            Value::Form(form) => {
                let coordinates = form.terms().iter().flat_map(|term| term.0.coordinates()).collect();
                self.check_directions(chart, coordinates, "d", span)
            }
            Value::Field(field) => {
                self.check_directions(chart, field.components().map(|part| part.0).collect(), "@", span)
            }
        }
    }
}
