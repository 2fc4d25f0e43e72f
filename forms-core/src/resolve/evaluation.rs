//! Evaluation of expressions: names, numbers, operators along their left spine, coefficients.

use super::bindings::Bindings;
use super::declarations::Declarations;
use super::scope::Scope;
use crate::calculus::{Blade, Coordinate, Field, Form, Structured};
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, FunctionId, Seam, Symbol};
use crate::syntax::ast::{self, Binary, ExprKind, Name};
use crate::theory::names::{VALUES, not_declared, unusable};
use crate::theory::{Named, Theory, Value, describe};
use num_traits::Zero;
use rustc_hash::FxHashMap;

/// Maximum number of nodes in the expressions of a file.
const MOST_NODES: usize = 1_000_000;

/// Result of an evaluation; the error is the complete diagnostic.
pub(super) type Evaluated<T> = Result<T, Diagnostic>;

/// Evaluates expressions against the declarations read so far. One scope collects the conditions
/// and variables of one value.
pub(super) struct Evaluator<'a> {
    pub(super) theory: &'a mut Theory,
    pub(super) scope: Scope,
    /// Conditions with which each param and unknown function was declared.
    pub(super) declared: &'a Declarations,
    /// Conditions that the statement itself places on its points.
    pub(super) given: Vec<Condition>,
    /// Whether a kernel is being evaluated: there, integrals without a closed form are computed
    /// numerically.
    pub(super) in_kernel: bool,
    /// Value of each expression in the source, recorded on request. An expression that is evaluated
    /// several times, in a definition with arguments or in a sum, has no entry.
    pub(super) trace: Option<Trace>,
    /// Names bound by the definition or sum being evaluated.
    pub(super) bindings: Bindings,
}

/// Value of each expression of a source, by its place.
pub type Trace = FxHashMap<Span, Value>;

impl<'a> Evaluator<'a> {
    pub(super) fn new(theory: &'a mut Theory, declared: &'a Declarations) -> Self {
        Evaluator {
            theory,
            scope: Scope::default(),
            declared,
            given: Vec::new(),
            in_kernel: false,
            trace: None,
            bindings: Bindings::default(),
        }
    }

    pub(super) fn ring(&mut self) -> Structured<'_> {
        Structured { pool: &mut self.theory.pool, coordinates: &self.theory.coordinates }
    }

    pub(super) fn zero(&mut self) -> Expr {
        self.theory.pool.integer(0)
    }

    /// Requires the condition under which an operation is defined, if there is one.
    pub(super) fn require(&mut self, condition: Option<Condition>) {
        condition.into_iter().for_each(|condition| self.scope.require(condition));
    }

    /// Evaluates an expression. Chains of operators are evaluated in a loop; only brackets recurse.
    pub(super) fn value(&mut self, expression: &ast::Expr) -> Evaluated<Value> {
        let mut spine = Vec::new();
        let mut leftmost = expression;
        while let ExprKind::Binary(operator, place, left, right) = &*leftmost.kind {
            spine.push((*operator, *place, left.span, right));
            leftmost = left;
        }
        let mut value = self.operand(leftmost)?;
        while let Some((operator, place, left_span, right)) = spine.pop() {
            value = self.binary(operator, place, (value, left_span), right)?;
            self.check_size(place)?;
        }
        if let Some(trace) = self.trace.as_mut().filter(|_| !self.bindings.are_in_body()) {
            trace.insert(expression.span, value.clone());
        }
        Ok(value)
    }

    /// Checks that the expressions so far fit in memory: calculus can make expressions much larger
    /// than their source.
    pub(super) fn check_size(&self, span: Span) -> Evaluated<()> {
        if self.theory.pool.len() <= MOST_NODES {
            return Ok(());
        }
        Err(Diagnostic::new(
            span,
            format!("the expressions of this file have more than {MOST_NODES} distinct subexpressions"),
        ))
    }

    fn operand(&mut self, expression: &ast::Expr) -> Evaluated<Value> {
        match &*expression.kind {
            ExprKind::Number(value) if value.is_zero() => Ok(Value::Zero),
            ExprKind::Number(value) => Ok(Value::Scalar(self.theory.pool.number(value.clone()))),
            ExprKind::Name(name) => self.name(name, expression.span),
            ExprKind::Basis(name) => self.basis(name),
            ExprKind::Negate(inner) => {
                let value = self.value(inner)?;
                Ok(self.negated(value))
            }
            ExprKind::Call { function, index, arguments } => {
                let value = self.call(function, index.as_ref(), arguments, expression.span)?;
                self.check_size(expression.span)?;
                Ok(value)
            }
            ExprKind::Index { base, indices } => self.indexed(base, indices),
            ExprKind::Array(entries) => self.array(entries),
            ExprKind::Select { condition, then, otherwise, jump } => {
                let seam = if *jump { Seam::Jumps } else { Seam::Agrees };
                self.select(condition, then, otherwise, seam)
            }
            ExprKind::Binary(operator, place, left, right) => {
                let value = self.value(left)?;
                self.binary(*operator, *place, (value, left.span), right)
            }
        }
    }

    fn name(&mut self, text: &str, span: Span) -> Evaluated<Value> {
        if text == "pi" {
            return Ok(Value::Scalar(self.theory.pool.pi()));
        }
        if let Some(value) = self.bindings.get(text) {
            return Ok(value.clone());
        }
        let Some(named) = self.theory.names.get(text).cloned() else {
            return Err(self.unknown(text, span));
        };
        match named {
            Named::Coordinate(coordinate) => {
                let symbol = self.theory.coordinates[coordinate.0 as usize];
                Ok(self.variable(symbol))
            }
            Named::Parameter(symbol) => Ok(self.variable(symbol)),
            Named::Differential(coordinate) => {
                self.scope.touch(self.theory.coordinates[coordinate.0 as usize]);
                Ok(Value::Form(Form::differential(&mut self.ring(), coordinate)))
            }
            Named::Function(function) => self.own_value(function),
            Named::Object(number) => {
                self.scope.mention(text);
                let object = self.theory.objects[number].clone();
                for condition in &object.domain {
                    self.scope.adopt(*condition, object.narrowing.contains(condition));
                }
                object.used.iter().for_each(|symbol| self.scope.touch(*symbol));
                Ok(object.value)
            }
            Named::Array(number) => Ok(Value::Array(self.theory.arrays[number].clone())),
            named @ (Named::Pending | Named::Poisoned) => Err(unusable(&named, text, span)),
            other => {
                let message = format!("`{text}` is {} and has no value here", describe(&other));
                let is_called = matches!(other, Named::Kernel(_) | Named::Definition(_));
                let help = is_called.then(|| format!("write its arguments in brackets: `{text}(…)`"));
                Err(Diagnostic { help, ..Diagnostic::new(span, message) })
            }
        }
    }

    /// Returns the error for an undeclared name. A likely cause of an undeclared `da` is that `a`
    /// is a param.
    fn unknown(&self, text: &str, span: Span) -> Diagnostic {
        let inner = text.strip_prefix('d').and_then(|rest| self.theory.names.get(rest));
        match inner {
            Some(Named::Parameter(_)) => not_declared(text, span).with_help(format!(
                "`{}` is a param, a constant; only coordinates have differentials",
                &text[1..]
            )),
            _ => self.theory.names.unknown(text, span, VALUES),
        }
    }

    fn variable(&mut self, symbol: Symbol) -> Value {
        self.scope.touch(symbol);
        for condition in self.declared.of_parameter(symbol) {
            self.scope.require(condition);
        }
        Value::Scalar(self.theory.pool.symbol(symbol))
    }

    /// Returns an unknown function at the arguments it was declared with.
    fn own_value(&mut self, function: FunctionId) -> Evaluated<Value> {
        let symbols = self.theory.pool.function(function).arguments.clone();
        let mut arguments = Vec::with_capacity(symbols.len());
        for symbol in symbols {
            if let Value::Scalar(argument) = self.variable(symbol) {
                arguments.push(argument);
            }
        }
        Ok(self.function_value(function, &arguments))
    }

    /// Returns an unknown function at the given arguments and requires the conditions it was
    /// declared with.
    pub(super) fn function_value(&mut self, function: FunctionId, arguments: &[Expr]) -> Value {
        let symbols = self.theory.pool.function(function).arguments.clone();
        let values = symbols.into_iter().zip(arguments.iter().copied()).collect();
        for condition in self.declared.of_function(function) {
            let composed = condition.substitute(&mut self.theory.pool, &values);
            self.scope.require(composed);
        }
        let orders = vec![0; arguments.len()];
        Value::Scalar(self.theory.pool.jet(function, &orders, arguments))
    }

    fn basis(&mut self, name: &Name) -> Evaluated<Value> {
        let coordinate = self.coordinate(name)?;
        self.scope.touch(self.theory.coordinates[coordinate.0 as usize]);
        let one = self.theory.pool.integer(1);
        Ok(Value::Field(Field::along(&self.ring(), coordinate, one)))
    }

    /// Returns the coordinate with this name.
    pub(super) fn coordinate(&self, name: &Name) -> Evaluated<Coordinate> {
        match self.theory.names.get(&name.text) {
            Some(Named::Coordinate(coordinate)) => Ok(*coordinate),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, &name.text, name.span)),
            Some(other) => Err(Diagnostic::new(
                name.span,
                format!("expected a coordinate, but `{}` is {}", name.text, describe(other)),
            )),
            None => Err(self.theory.names.unknown(&name.text, name.span, "`chart`")),
        }
    }

    /// Evaluates an expression that must be a scalar; the literal 0 is one.
    pub(super) fn scalar(&mut self, expression: &ast::Expr) -> Evaluated<Expr> {
        match self.value(expression)? {
            Value::Zero => Ok(self.zero()),
            Value::Scalar(value) => Ok(value),
            other => {
                Err(Diagnostic::new(expression.span, format!("expected a scalar, found {}", other.kind())))
            }
        }
    }

    /// Evaluates `w[dx^dy]`, `X[x]` or `p[0]`.
    fn indexed(&mut self, base: &ast::Expr, indices: &[ast::Expr]) -> Evaluated<Value> {
        let is_volume = matches!(&*base.kind, ExprKind::Name(name) if name == "volume");
        let value = if is_volume { Value::Zero } else { self.value(base)? };
        match (value, indices) {
            (Value::Array(array), _) => self.entry(&array, indices),
            (_, [index]) if is_volume => self.volume(index),
            (value, [index]) => self.coefficient(value, base.span, index),
            (_, [_, second, ..]) => Err(Diagnostic::new(second.span, "only a matrix takes two indices")),
            (_, []) => Ok(Value::Zero),
        }
    }

    /// Returns a coefficient of a form or a component of a field.
    fn coefficient(&mut self, value: Value, place: Span, index: &ast::Expr) -> Evaluated<Value> {
        match value {
            Value::Zero | Value::Array(_) => Ok(Value::Zero),
            Value::Field(field) => {
                let ExprKind::Name(text) = &*index.kind else {
                    return Err(Diagnostic::new(index.span, "expected a coordinate, as in `X[x]`"));
                };
                let coordinate = self.coordinate(&Name { text: text.clone(), span: index.span })?;
                let zero = self.zero();
                Ok(Value::Scalar(field.component(coordinate).copied().unwrap_or(zero)))
            }
            Value::Form(form) => self.form_coefficient(&form, index),
            Value::Scalar(_) => {
                let help = match &*index.kind {
                    ExprKind::Number(_) => "an array is declared with its entries: `kernel f(p[3]) = …`",
                    _ => "`w[dx^dy]` takes a coefficient of a form, `X[x]` a component of a field",
                };
                Err(Diagnostic::new(place, "a scalar has no coefficients").with_help(help))
            }
        }
    }

    fn form_coefficient(&mut self, form: &Form<Expr>, index: &ast::Expr) -> Evaluated<Value> {
        let wanted = self.blade(index)?;
        let Some((blade, sign)) = wanted else {
            return Err(Diagnostic::new(index.span, "a differential occurs twice, so this basis form is 0"));
        };
        if blade.degree() != form.degree() {
            return Err(Diagnostic::new(
                index.span,
                format!(
                    "expected a basis {}-form, as the form has that degree, found degree {}",
                    form.degree(),
                    blade.degree()
                ),
            ));
        }
        let zero = self.zero();
        let value = form.coefficient(blade).copied().unwrap_or(zero);
        Ok(Value::Scalar(if sign < 0 { self.theory.pool.negate(value) } else { value }))
    }

    /// Returns the sorted basis form of `dx^dy` and the sign of the permutation that sorts it.
    fn blade(&self, index: &ast::Expr) -> Evaluated<Option<(Blade, i8)>> {
        match &*index.kind {
            ExprKind::Name(text) => match self.theory.names.get(text) {
                Some(Named::Differential(coordinate)) => Ok(Some((Blade::of(*coordinate), 1))),
                Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, text, index.span)),
                Some(other) => Err(Diagnostic::new(
                    index.span,
                    format!("expected a differential such as `dx`, but `{text}` is {}", describe(other)),
                )),
                None => Err(self.unknown(text, index.span)),
            },
            ExprKind::Binary(Binary::Wedge, _, left, right) => {
                let (left, right) = (self.blade(left)?, self.blade(right)?);
                Ok(left.zip(right).and_then(|((a, s), (b, t))| {
                    let (blade, sign) = a.wedge(b)?;
                    Some((blade, s * t * sign))
                }))
            }
            _ => Err(Diagnostic::new(index.span, "expected a basis form such as `dx^dy`")),
        }
    }

    fn select(
        &mut self,
        condition: &ast::Condition,
        then: &ast::Expr,
        otherwise: &ast::Expr,
        seam: Seam,
    ) -> Evaluated<Value> {
        let conditions = self.conditions(condition)?;
        let place = otherwise.span;
        let branches = (self.numbers(then)?, self.numbers(otherwise)?);
        self.entrywise("`if` needs branches of one shape", place, branches, |pool, then, otherwise| {
            conditions.iter().rev().fold(then, |value, &Condition { left, relation, right }| {
                pool.select((left, relation, right), value, otherwise, seam)
            })
        })
    }

    /// Splits a chain of relations into single relations.
    pub(super) fn conditions(&mut self, condition: &ast::Condition) -> Evaluated<Vec<Condition>> {
        let mut left = self.scalar(&condition.first)?;
        let mut single = Vec::new();
        for (relation, right) in &condition.rest {
            let right = self.scalar(right)?;
            single.push(Condition { left, relation: *relation, right });
            left = right;
        }
        Ok(single)
    }
}
