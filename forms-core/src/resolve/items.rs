//! Items of a file, in order: each declares a name or makes a claim.

use super::cycles::{Cycles, cycles};
use super::declarations::Declarations;
use super::evaluation::{Evaluated, Evaluator, Trace};
use crate::calculus::{Coordinate, MAXIMUM_COORDINATES};
use crate::diagnostic::{Diagnostic, Kind, MOST_DIAGNOSTICS, Span};
use crate::expression::{Condition, Symbol, SymbolKind};
use crate::steps;
use crate::syntax::ast::{self, Declared, Item, ItemKind, Name};
use crate::theory::{Chart, Named, Object, Theory, Value};
use rustc_hash::FxHashSet;

/// Resolves a whole file: returns its declarations and claims, and all errors in it.
pub fn resolve(file: &ast::File) -> (Theory, Vec<Diagnostic>) {
    let mut resolver = Resolver::default();
    resolver.file(file);
    (resolver.theory, resolver.errors)
}

/// Resolves a whole file and records the value of each of its expressions.
pub fn resolve_traced(file: &ast::File) -> (Theory, Trace, Vec<Diagnostic>) {
    let mut resolver = Resolver { trace: Some(Trace::default()), ..Resolver::default() };
    resolver.file(file);
    (resolver.theory, resolver.trace.unwrap_or_default(), resolver.errors)
}

#[derive(Default)]
pub(super) struct Resolver {
    pub(super) theory: Theory,
    pub(super) declared: Declarations,
    pub(super) errors: Vec<Diagnostic>,
    /// Names of the statements so far.
    pub(super) statement_names: FxHashSet<String>,
    /// Definitions and kernels on cycles of calls.
    pub(super) cycles: Cycles,
    /// Values of all expressions so far, recorded on request.
    trace: Option<Trace>,
}

impl Resolver {
    fn file(&mut self, file: &ast::File) {
        self.cycles = cycles(file);
        for item in &file.items {
            steps::limited(steps::STATEMENT, || self.item(item));
        }
        self.attribute_statements();
        self.drop_consequences();
    }

    /// Drops errors that only follow from another error, unless there is no other: an item that
    /// cannot be resolved is never dropped silently.
    fn drop_consequences(&mut self) {
        if self.errors.iter().any(|error| error.kind != Kind::Consequence) {
            self.errors.retain(|error| error.kind != Kind::Consequence);
        }
    }

    fn item(&mut self, item: &Item) {
        let result = match &item.kind {
            ItemKind::Chart { name, coordinates, conditions } => self.chart(name, coordinates, conditions),
            ItemKind::ProductChart { name, factors, conditions } => {
                self.product_chart(name, factors, conditions)
            }
            ItemKind::Param { names, conditions } => self.parameters(names, conditions),
            ItemKind::Function { name, arguments, conditions, .. } => {
                self.function(name, arguments, conditions)
            }
            ItemKind::Let { name, value, .. } => self.object(name, value, |_, _| Ok(())),
            ItemKind::Definition { name, arguments, value } => self.definition(name, arguments, value),
            ItemKind::Form { name, degree, chart, value, .. } => {
                self.form(name, *degree, chart.as_ref(), value)
            }
            ItemKind::Field { name, chart, value } => self.field(name, chart.as_ref(), value),
            ItemKind::Map { name, source, target, components } => self.map(name, source, target, components),
            ItemKind::Metric { name, chart, value } => self.metric(name, chart.as_ref(), value),
            ItemKind::Statement { .. } => self.statement(item),
            ItemKind::Kernel { .. } => self.kernel(item),
            ItemKind::Derivatives { .. } => self.derivatives(item),
            ItemKind::Warp(warp) => self.warp(item, warp),
        };
        if let Err(error) = result {
            self.errors.push(error);
        }
        if self.errors.len() >= MOST_DIAGNOSTICS {
            // later errors are not shown
            self.theory.names.be_terse();
        }
        self.theory.names.end_item();
    }

    /// Runs an evaluation in a new scope.
    pub(super) fn evaluate<T>(
        &mut self,
        body: impl FnOnce(&mut Evaluator) -> Evaluated<T>,
    ) -> Evaluated<(T, Vec<Condition>, Vec<Symbol>)> {
        let mut evaluator = Evaluator::new(&mut self.theory, &self.declared);
        evaluator.trace = self.trace.take();
        let result = body(&mut evaluator);
        let Evaluator { scope, trace, .. } = evaluator;
        self.trace = trace;
        let (result, (domain, used)) = (result?, scope.into_parts());
        Ok((result, domain, used))
    }

    /// Returns every relation of a `where`, followed by the conditions under which its sides are
    /// defined.
    pub(super) fn conditions(&mut self, conditions: &[ast::Condition]) -> Evaluated<Vec<Condition>> {
        let (mut all, domain, _) = self.evaluate(|evaluator| {
            let mut all = Vec::new();
            for condition in conditions {
                all.extend(evaluator.conditions(condition)?);
            }
            Ok(all)
        })?;
        all.extend(domain);
        Ok(all)
    }

    fn chart(
        &mut self,
        name: &Name,
        coordinates: &[Declared],
        conditions: &[ast::Condition],
    ) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let mut numbers = Vec::new();
        for declared in coordinates {
            let number = self.coordinate(&declared.name)?;
            if numbers.contains(&number) {
                return Err(Diagnostic::new(declared.name.span, "this coordinate occurs twice in the chart"));
            }
            numbers.push(number);
        }
        let conditions = self.conditions(conditions)?;
        self.add_chart(name, numbers, conditions);
        Ok(())
    }

    fn add_chart(&mut self, name: &Name, coordinates: Vec<Coordinate>, conditions: Vec<Condition>) {
        self.theory.charts.push(Chart { name: name.text.clone(), coordinates, conditions });
        self.theory.names.set(name, Named::Chart(self.theory.charts.len() - 1));
    }

    /// Returns the coordinate with this name: the existing one, or a new one, declared together
    /// with its differential.
    pub(super) fn coordinate(&mut self, name: &Name) -> Evaluated<Coordinate> {
        if let Some(Named::Coordinate(known)) = self.theory.named(&name.text) {
            return Ok(*known);
        }
        let number = self.theory.coordinates.len();
        if number == MAXIMUM_COORDINATES {
            return Err(Diagnostic::new(
                name.span,
                format!("a file can declare at most {MAXIMUM_COORDINATES} coordinates"),
            )
            .with_help("coordinates of the same name are shared between charts"));
        }
        let coordinate = Coordinate(number as u8);
        self.theory.names.declare(name, Named::Coordinate(coordinate))?;
        let differential = format!("d{}", name.text);
        if let Err(error) =
            self.theory.names.declare_text(&differential, name.span, Named::Differential(coordinate))
        {
            self.theory.names.remove(&name.text);
            return Err(error.with_help(format!(
                "the coordinate `{}` reserves the name `{differential}` for its differential",
                name.text
            )));
        }
        let symbol = self.theory.pool.declare_symbol(&name.text, SymbolKind::Coordinate);
        self.theory.coordinates.push(symbol);
        Ok(coordinate)
    }

    fn product_chart(
        &mut self,
        name: &Name,
        factors: &[Name],
        conditions: &[ast::Condition],
    ) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let (mut coordinates, mut all): (Vec<Coordinate>, Vec<Condition>) = (Vec::new(), Vec::new());
        for factor in factors {
            let (number, _, _) = self.evaluate(|evaluator| evaluator.chart(factor))?;
            let chart = &self.theory.charts[number];
            if let Some(shared) = chart.coordinates.iter().find(|c| coordinates.contains(c)) {
                let shared = self.theory.coordinate_name(*shared);
                return Err(Diagnostic::new(
                    factor.span,
                    format!("the factors of a product chart share the coordinate `{shared}`"),
                ));
            }
            coordinates.extend(&chart.coordinates);
            all.extend(&chart.conditions);
        }
        all.extend(self.conditions(conditions)?);
        self.add_chart(name, coordinates, all);
        Ok(())
    }

    fn parameters(&mut self, names: &[Declared], conditions: &[ast::Condition]) -> Evaluated<()> {
        let mut symbols = Vec::new();
        for declared in names {
            let symbol = self.theory.pool.declare_symbol(&declared.name.text, SymbolKind::Parameter);
            self.theory.names.declare(&declared.name, Named::Parameter(symbol))?;
            symbols.push(symbol);
        }
        let conditions = self.conditions(conditions)?;
        for &symbol in &symbols {
            self.declared.parameters.insert(symbol, self.connected(symbol, &symbols, &conditions));
        }
        Ok(())
    }

    /// Returns the conditions that constrain a param, directly or through another param of the same
    /// declaration.
    fn connected(&self, symbol: Symbol, group: &[Symbol], conditions: &[Condition]) -> Vec<Condition> {
        let mut reached = vec![symbol];
        let mut found: Vec<Condition> = Vec::new();
        loop {
            let before = found.len();
            for condition in
                conditions.iter().filter(|condition| !found.contains(condition)).copied().collect::<Vec<_>>()
            {
                let symbols = self.theory.pool.symbols_in(&[condition.left, condition.right]);
                if symbols.iter().any(|s| reached.contains(s)) {
                    found.push(condition);
                    reached.extend(symbols.into_iter().filter(|s| group.contains(s)));
                }
            }
            if found.len() == before {
                return found;
            }
        }
    }

    fn function(&mut self, name: &Name, arguments: &[Name], conditions: &[ast::Condition]) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let mut symbols = Vec::new();
        for argument in arguments {
            let (symbol, _, _) = self.evaluate(|evaluator| {
                let kind = Box::new(ast::ExprKind::Name(argument.text.clone()));
                evaluator.variable_named(&ast::Expr { kind, span: argument.span })
            })?;
            if symbols.contains(&symbol) {
                return Err(Diagnostic::new(argument.span, "this argument occurs twice"));
            }
            symbols.push(symbol);
        }
        let function = self.theory.pool.declare_function(&name.text, symbols);
        self.theory.names.set(name, Named::Function(function));
        let conditions = self.conditions(conditions)?;
        self.declared.functions.insert(function, conditions);
        Ok(())
    }

    /// Declares a named value; `check` can reject it.
    fn object(
        &mut self,
        name: &Name,
        value: &ast::Expr,
        check: impl FnOnce(&mut Evaluator, &mut Value) -> Evaluated<()>,
    ) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        let ((value, narrowing), domain, used) = self.evaluate(|evaluator| {
            let mut evaluated = evaluator.value(value)?;
            check(evaluator, &mut evaluated)?;
            Ok((evaluated, evaluator.scope.narrowing().clone()))
        })?;
        self.theory.objects.push(Object { value, domain, narrowing, used, unit: None });
        self.theory.names.set(name, Named::Object(self.theory.objects.len() - 1));
        Ok(())
    }

    fn form(
        &mut self,
        name: &Name,
        degree: Option<(u32, Span)>,
        chart: Option<&Name>,
        expression: &ast::Expr,
    ) -> Evaluated<()> {
        self.object(name, expression, |evaluator, value| {
            if let (Value::Zero, Some((k, _))) = (&*value, degree) {
                *value = Value::Form(crate::calculus::Form::zero(k));
            }
            let found = match &*value {
                Value::Form(form) => form.degree(),
                Value::Scalar(_) | Value::Zero => 0,
                Value::Field(_) => {
                    return Err(Diagnostic::new(expression.span, "expected a form, found a vector field")
                        .with_help("declare it with `field`"));
                }
                Value::Array(array) => {
                    let message = format!("expected a form, found {}", array.shape);
                    return Err(Diagnostic::new(expression.span, message).with_help("declare it with `let`"));
                }
            };
            if let Some((wanted, span)) = degree
                && wanted != found
            {
                return Err(Diagnostic::new(
                    span,
                    format!("the degree is declared as {wanted}, but the form has degree {found}"),
                ));
            }
            if let (Some(chart), Value::Form(form)) = (chart, &*value) {
                let coordinates = form.terms().iter().flat_map(|term| term.0.coordinates()).collect();
                evaluator.check_on_chart(chart, coordinates, "d", expression.span)?;
            }
            Ok(())
        })
    }

    fn field(&mut self, name: &Name, chart: Option<&Name>, expression: &ast::Expr) -> Evaluated<()> {
        self.object(name, expression, |evaluator, value| {
            if *value == Value::Zero {
                *value = Value::Field(crate::calculus::Field::zero());
            }
            let Value::Field(field) = &*value else {
                return Err(Diagnostic::new(
                    expression.span,
                    format!("expected a vector field, found {}", value.kind()),
                )
                .with_help("`@x` is the coordinate vector field of `x`"));
            };
            if let Some(chart) = chart {
                let coordinates = field.components().map(|component| component.0).collect();
                evaluator.check_on_chart(chart, coordinates, "@", expression.span)?;
            }
            Ok(())
        })
    }
}

impl Evaluator<'_> {
    /// Checks that the differentials or basis fields of a value belong to the chart it is declared
    /// on.
    pub(super) fn check_on_chart(
        &mut self,
        chart: &Name,
        coordinates: Vec<Coordinate>,
        prefix: &str,
        span: Span,
    ) -> Evaluated<()> {
        let number = self.chart(chart)?;
        self.check_directions(number, coordinates, prefix, span)
    }

    /// Checks that these coordinates belong to a chart.
    pub(super) fn check_directions(
        &self,
        chart: usize,
        coordinates: Vec<Coordinate>,
        prefix: &str,
        span: Span,
    ) -> Evaluated<()> {
        let chart = &self.theory.charts[chart];
        match coordinates.into_iter().find(|coordinate| !chart.coordinates.contains(coordinate)) {
            None => Ok(()),
            Some(missing) => {
                let missing = self.theory.coordinate_name(missing);
                Err(Diagnostic::new(
                    span,
                    format!(
                        "`{prefix}{missing}` occurs, but `{missing}` is not a coordinate of `{}`",
                        chart.name
                    ),
                ))
            }
        }
    }
}
