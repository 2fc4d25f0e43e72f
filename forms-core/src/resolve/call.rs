//! Function calls: the functions of the op table, the operators of exterior calculus, and unknown
//! functions.

use super::arguments::{CALLED, called_argument, exactly, plain_arguments, wrong_count};
use super::evaluation::{Evaluated, Evaluator};
use super::scope::Scope;
use crate::calculus::{
    Coordinate, Field, Form, Pullback, bracket, exterior_derivative, interior, lie_of_form, lie_of_scalar,
    pairing, pullback,
};
use crate::diagnostic::{Diagnostic, Span, counted};
use crate::expression::{Expr, Extremum, Node, Operation, Substitution, Symbol};
use crate::syntax::ast::{self, Argument, ExprKind, Name};
use crate::syntax::words::{COMMON_FUNCTIONS, METRIC_OPERATIONS};
use crate::theory::names::unusable;
use crate::theory::{Map, Named, Value, describe};
use num_rational::Ratio;

impl Evaluator<'_> {
    pub(super) fn call(
        &mut self,
        function: &Name,
        index: Option<&ast::Expr>,
        arguments: &[Argument],
        span: Span,
    ) -> Evaluated<Value> {
        let name = function.text.as_str();
        if name == "integral" {
            return self.integral(arguments, span);
        }
        if name == "quadrature" {
            return self.quadrature(arguments, span);
        }
        if name == "boundary_integral" {
            return self.boundary_integral(arguments, span);
        }
        if matches!(name, "sum" | "product") && self.is_free(name) {
            return self.repeated(name, arguments, span);
        }
        let plain = plain_arguments(arguments)?;
        if let ("norm", None, [argument]) = (name, index, plain.as_slice())
            && let Value::Array(array) = self.value(argument)?
        {
            return Ok(self.euclidean_norm(&array.entries));
        }
        if METRIC_OPERATIONS.contains(&name) {
            return self.metric_operation(function, index, &plain, span);
        }
        match (name, index) {
            ("d", _) => self.exterior(index, &plain, span),
            ("potential", _) => self.potential(index, &plain, span),
            (_, Some(index)) => Err(Diagnostic::new(index.span, format!("`{name}` takes no `[…]`"))),
            ("interior", _) => self.interior_product(&plain, span),
            ("lie", _) => self.lie_derivative(&plain, span),
            ("bracket", _) => self.lie_bracket(&plain, span),
            ("pair", _) => self.pair(&plain, span),
            ("pullback", _) => self.pull(&plain, span),
            ("diff", _) => self.partial_derivative(&plain, span),
            ("sqrt", _) => self.square_root(&plain, span),
            ("dot", _) if self.is_free(name) => self.dot(&plain, span),
            ("cross", _) if self.is_free(name) => self.cross(&plain, span),
            ("transpose", _) if self.is_free(name) => self.transpose(&plain, span),
            _ if COMMON_FUNCTIONS.contains(&name) && !self.is_free(name) => {
                self.composed(function, &plain, span)
            }
            ("min", _) => self.extremum(Extremum::Least, &plain, span),
            ("max", _) => self.extremum(Extremum::Greatest, &plain, span),
            ("copysign", _) => self.copied_sign(&plain, span),
            ("sec", _) => self.reciprocal_of(Operation::Cos, name, &plain, span),
            ("csc", _) => self.reciprocal_of(Operation::Sin, name, &plain, span),
            ("cot", _) => self.cotangent(&plain, span),
            _ => match Operation::named(name) {
                Some(operation) => self.operation(operation, &plain, span),
                None => self.composed(function, &plain, span),
            },
        }
    }

    /// Whether the file gives a name no meaning of its own, so that it is that of a function.
    fn is_free(&self, name: &str) -> bool {
        self.theory.named(name).is_none() && self.bindings.get(name).is_none()
    }

    /// Evaluates `d(w)`, with derivatives along all coordinates, or `d[R3](w)`, along the
    /// coordinates of one chart.
    fn exterior(
        &mut self,
        index: Option<&ast::Expr>,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let [argument] = exactly::<1>(arguments, "d", span)?;
        let value = self.value(argument)?;
        let along = match index {
            Some(chart) => self.chart_coordinates(chart)?,
            None => self.theory.coordinates_in(&value.scalars()),
        };
        let form = match value {
            Value::Zero => return Ok(Value::Zero),
            Value::Scalar(f) => Form::scalar(&self.ring(), f),
            Value::Form(form) => form,
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("`d` takes a form, and this is {}", other.kind());
                return Err(Diagnostic::new(argument.span, message));
            }
        };
        Ok(Value::Form(exterior_derivative(&mut self.ring(), &form, &along)))
    }

    pub(super) fn chart_coordinates(&self, chart: &ast::Expr) -> Evaluated<Vec<Coordinate>> {
        let ExprKind::Name(text) = &*chart.kind else {
            return Err(Diagnostic::new(chart.span, "expected the name of a chart"));
        };
        let number = self.chart(&Name { text: text.clone(), span: chart.span })?;
        Ok(self.theory.charts[number].coordinates.clone())
    }

    /// Returns the index of the chart with this name.
    pub(super) fn chart(&self, name: &Name) -> Evaluated<usize> {
        match self.theory.named(&name.text) {
            Some(Named::Chart(number)) => Ok(*number),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, &name.text, name.span)),
            Some(other) => Err(Diagnostic::new(
                name.span,
                format!("expected a chart, but `{}` is {}", name.text, describe(other)),
            )),
            None => Err(self.theory.names.unknown(&name.text, name.span, "`chart`")),
        }
    }

    pub(super) fn field(&mut self, argument: &ast::Expr) -> Evaluated<Field<Expr>> {
        match self.value(argument)? {
            Value::Field(field) => Ok(field),
            Value::Zero => Ok(Field::zero()),
            other => Err(Diagnostic::new(
                argument.span,
                format!("expected a vector field, found {}", other.kind()),
            )),
        }
    }

    fn interior_product(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [field, form] = exactly::<2>(arguments, "interior", span)?;
        let x = self.field(field)?;
        let zero = self.zero();
        match self.value(form)? {
            Value::Zero => Ok(Value::Zero),
            Value::Scalar(_) => Ok(Value::Scalar(zero)),
            Value::Form(w) => Ok(Value::from_form(interior(&mut self.ring(), &x, &w), zero)),
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("expected a form, found {}", other.kind());
                Err(Diagnostic::new(form.span, message).with_help("the field comes first: interior(X, w)"))
            }
        }
    }

    fn lie_derivative(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [field, argument] = exactly::<2>(arguments, "lie", span)?;
        let x = self.field(field)?;
        match self.value(argument)? {
            Value::Zero => Ok(Value::Zero),
            Value::Scalar(f) => Ok(Value::Scalar(lie_of_scalar(&mut self.ring(), &x, &f))),
            Value::Field(y) => Ok(Value::Field(bracket(&mut self.ring(), &x, &y))),
            Value::Form(w) => {
                let components: Vec<Expr> = x.components().map(|component| *component.1).collect();
                let along = self.theory.coordinates_in(&components);
                Ok(Value::Form(lie_of_form(&mut self.ring(), &x, &w, &along)))
            }
            Value::Array(array) => {
                let message = format!("expected a scalar, form or field, found {}", array.shape);
                Err(Diagnostic::new(argument.span, message))
            }
        }
    }

    fn lie_bracket(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [x, y] = exactly::<2>(arguments, "bracket", span)?;
        let (x, y) = (self.field(x)?, self.field(y)?);
        Ok(Value::Field(bracket(&mut self.ring(), &x, &y)))
    }

    /// Evaluates `pair(w, X, Y)`; the number of fields equals the degree of the form.
    fn pair(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let Some((form, fields)) = arguments.split_first() else {
            return Err(Diagnostic::new(span, "`pair` takes a form and one field for each of its degrees"));
        };
        let w = match self.value(form)? {
            Value::Zero => return Ok(Value::Zero),
            Value::Form(w) => w,
            other => {
                return Err(Diagnostic::new(form.span, format!("expected a form, found {}", other.kind())));
            }
        };
        if fields.len() != w.degree() as usize {
            return Err(Diagnostic::new(
                span,
                format!(
                    "a {}-form takes {}, found {}",
                    w.degree(),
                    counted(w.degree() as usize, "field"),
                    fields.len()
                ),
            ));
        }
        let fields = fields.iter().map(|field| self.field(field)).collect::<Evaluated<Vec<_>>>()?;
        let fields: Vec<&Field<Expr>> = fields.iter().collect();
        Ok(Value::Scalar(pairing(&mut self.ring(), &w, &fields)))
    }

    /// Evaluates `pullback(F, w)`. The conditions that `w` requires are required at the image
    /// points.
    pub(super) fn pull(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [map, argument] = exactly::<2>(arguments, "pullback", span)?;
        let map = self.map(map)?;
        // conditions stated for this point do not hold for its image
        let given = std::mem::take(&mut self.given);
        let result = self.apart(|evaluator| evaluator.value(argument));
        self.given = given;
        let (value, inner) = result?;
        let target = self.theory.charts[map.target].clone();
        let source = self.theory.charts[map.source].coordinates.clone();
        let symbols: Vec<Symbol> =
            target.coordinates.iter().map(|c| self.theory.coordinates[c.0 as usize]).collect();
        let images: Substitution = symbols.iter().copied().zip(map.components.iter().copied()).collect();
        self.compose_scope(inner, &map, &target.conditions, &images);
        let components: Vec<(Coordinate, Expr)> =
            target.coordinates.iter().copied().zip(map.components.iter().copied()).collect();
        match value {
            Value::Zero => Ok(Value::Zero),
            Value::Scalar(f) => Ok(Value::Scalar(self.theory.pool.substitute(f, &images))),
            Value::Form(w) => {
                let composed = self.composed_form(&w, &images);
                let mut ring = self.ring();
                let prepared = Pullback::new(&mut ring, &components, &source);
                Ok(Value::Form(pullback(&mut ring, &prepared, &composed, |_, value| *value)))
            }
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("`pullback` takes a scalar or a form, and this is {}", other.kind());
                Err(Diagnostic::new(argument.span, message))
            }
        }
    }

    /// Composes the coefficients with the map in one pass, so that they continue to share
    /// subexpressions.
    pub(super) fn composed_form(&mut self, w: &Form<Expr>, images: &Substitution) -> Form<Expr> {
        let values: Vec<Expr> = w.terms().iter().map(|term| term.1).collect();
        let composed = self.theory.pool.substitute_all(&values, images);
        Form::from_terms(w.degree(), w.terms().iter().map(|term| term.0).zip(composed))
    }

    fn compose_scope(
        &mut self,
        inner: Scope,
        map: &Map,
        target: &[crate::expression::Condition],
        images: &Substitution,
    ) {
        inner.mentioned().iter().for_each(|name| self.scope.mention(name));
        let narrowing = inner.narrowing().clone();
        let (conditions, used) = inner.into_parts();
        for condition in map.domain.iter().copied() {
            self.scope.adopt(condition, map.narrowing.contains(&condition));
        }
        for condition in conditions.iter().chain(target) {
            let composed = condition.substitute(&mut self.theory.pool, images);
            if self.theory.narrowing.contains(condition) {
                self.theory.narrowing.insert(composed);
            }
            self.scope.adopt(composed, narrowing.contains(condition));
        }
        for symbol in used.into_iter().filter(|symbol| !images.contains_key(symbol)) {
            self.scope.touch(symbol);
        }
        map.used.iter().for_each(|symbol| self.scope.touch(*symbol));
    }

    pub(super) fn map(&mut self, argument: &ast::Expr) -> Evaluated<Map> {
        let ExprKind::Name(text) = &*argument.kind else {
            return Err(Diagnostic::new(argument.span, "expected the name of a map"));
        };
        self.scope.mention(text);
        match self.theory.named(text) {
            Some(Named::Map(number)) => Ok(self.theory.maps[*number].clone()),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, text, argument.span)),
            Some(other) => Err(Diagnostic::new(
                argument.span,
                format!("expected a map, but `{text}` is {}", describe(other)),
            )
            .with_help("the map comes first: pullback(F, w)")),
            None => Err(self.theory.names.unknown(text, argument.span, "`map` or `warp`")),
        }
    }

    /// Evaluates `diff(f, x, y)`.
    fn partial_derivative(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let Some((function, by)) = arguments.split_first().filter(|(_, by)| !by.is_empty()) else {
            return Err(Diagnostic::new(span, "`diff` takes a scalar and one or more variables: diff(f, x)"));
        };
        let mut value = self.scalar(function)?;
        for variable in by {
            let symbol = self.variable_named(variable)?;
            value = self.theory.pool.derivative(value, symbol);
        }
        Ok(Value::Scalar(value))
    }

    /// Returns the variable named by a coordinate or a param.
    pub(super) fn variable_named(&self, expression: &ast::Expr) -> Evaluated<Symbol> {
        let ExprKind::Name(text) = &*expression.kind else {
            return Err(Diagnostic::new(expression.span, "expected the name of a coordinate or param"));
        };
        if let Some(value) = self.bindings.get(text) {
            return self.bound_variable(text, value, expression.span);
        }
        match self.theory.named(text) {
            Some(Named::Parameter(symbol)) => Ok(*symbol),
            _ => {
                let name = Name { text: text.clone(), span: expression.span };
                Ok(self.theory.coordinates[self.coordinate(&name)?.0 as usize])
            }
        }
    }

    /// Returns the variable that is the value of a bound name.
    fn bound_variable(&self, name: &str, value: &Value, place: Span) -> Evaluated<Symbol> {
        if let Value::Scalar(scalar) = value
            && let Node::Symbol(symbol) = self.theory.pool.node(*scalar)
        {
            return Ok(*symbol);
        }
        let message = format!("expected a coordinate or param, but `{name}` has a value here");
        Err(Diagnostic::new(place, message))
    }

    fn square_root(&mut self, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        let [argument] = exactly::<1>(arguments, "sqrt", span)?;
        let radicand = self.scalar(argument)?;
        self.require_power(radicand, Ratio::new(1, 2));
        Ok(Value::Scalar(self.theory.pool.sqrt(radicand)))
    }

    fn operation(&mut self, operation: Operation, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        if arguments.len() != operation.arity() {
            return Err(wrong_count(operation.row().name, operation.arity(), arguments.len(), span));
        }
        let values = arguments.iter().map(|argument| self.scalar(argument)).collect::<Evaluated<Vec<_>>>()?;
        let domain = self.theory.pool.operation_domain(operation, &values);
        self.require(domain);
        Ok(Value::Scalar(self.theory.pool.apply(operation, &values)))
    }

    /// Evaluates `L(a, b)` for an unknown function, a definition or a kernel.
    fn composed(&mut self, function: &Name, arguments: &[&ast::Expr], span: Span) -> Evaluated<Value> {
        if self.bindings.get(&function.text).is_some() {
            return Err(called_argument(function));
        }
        let number = match self.theory.named(&function.text) {
            Some(Named::Function(number)) => *number,
            Some(&Named::Definition(number)) => return self.defined_value(number, arguments, span),
            Some(&Named::Kernel(number)) => return self.kernel_value(number, function, arguments, span),
            Some(named @ (Named::Pending | Named::Poisoned)) => {
                return Err(unusable(named, &function.text, function.span));
            }
            Some(other) => {
                return Err(Diagnostic::new(
                    function.span,
                    format!("`{}` is {} and takes no arguments", function.text, describe(other)),
                )
                .with_help("write `*` for a product"));
            }
            None => return Err(self.theory.names.unknown(&function.text, function.span, CALLED)),
        };
        let wanted = self.theory.pool.function(number).arguments.len();
        if arguments.len() != wanted {
            return Err(wrong_count(&function.text, wanted, arguments.len(), span));
        }
        let values = arguments.iter().map(|argument| self.scalar(argument)).collect::<Evaluated<Vec<_>>>()?;
        Ok(self.function_value(number, &values))
    }
}
