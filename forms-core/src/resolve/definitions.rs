//! Definitions with arguments, and calls of them and of earlier kernels.
//!
//! ```text
//! let f(t) = …   the names in it are known ─────────────────────────────▶ Definition
//! f(q)           q evaluated, then the expression of f with q for t ─────▶ Value
//! k(q)           q evaluated, then put in the place of k's argument ─────▶ Value
//! ```
//! A definition is evaluated at each call, so that it can be a scalar, a form, a field or an array.
//! Its names are those that were known where it was written: a name that is local to the caller has
//! no meaning in it.

use super::arguments::{CALLED, called_argument, wrong_count};
use super::evaluation::{Evaluated, Evaluator};
use super::items::Resolver;
use crate::diagnostic::{Diagnostic, Kind, Span, counted};
use crate::expression::{Condition, Expr, Shape, Substitution};
use crate::syntax::ast::{self, Argument, ExprKind, Name};
use crate::syntax::words::is_function;
use crate::theory::names::{Names, VALUES, unusable};
use crate::theory::{Array, Definition, Kernel, Named, Value, describe};
use std::sync::Arc;

/// Maximum levels of nesting of a definition, with those of the definitions that it calls: the
/// evaluation of a call recurses this deep.
const MOST_NESTED: usize = 64;

impl Resolver {
    /// Declares `let ease(t) = t*t*(3 - 2*t);`.
    pub(super) fn definition(&mut self, name: &Name, arguments: &[Name], value: &ast::Expr) -> Evaluated<()> {
        self.theory.names.declare(name, Named::Pending)?;
        self.check_recursion(name)?;
        for (place, argument) in arguments.iter().enumerate() {
            self.check_argument(argument)?;
            if arguments[..place].iter().any(|earlier| earlier.text == argument.text) {
                return Err(Diagnostic::new(argument.span, "this argument occurs twice"));
            }
        }
        let arguments: Vec<String> = arguments.iter().map(|argument| argument.text.clone()).collect();
        let mut check =
            Check { names: &self.theory.names, definitions: &self.theory.definitions, bound: arguments };
        let nesting = check.expression(value)?;
        if nesting > MOST_NESTED {
            let message = format!(
                "`{}` is nested more than {MOST_NESTED} levels deep, with the definitions that it calls",
                name.text
            );
            return Err(Diagnostic::new(name.span, message).with_help("name an inner part with `let`"));
        }
        let arguments = check.bound;
        let definition = Definition { name: name.clone(), arguments, value: value.clone(), nesting };
        self.theory.definitions.push(Arc::new(definition));
        self.theory.names.set(name, Named::Definition(self.theory.definitions.len() - 1));
        Ok(())
    }

    /// Rejects an item that is on a cycle of calls; the cycle is reported at its first item.
    pub(super) fn check_recursion(&self, name: &Name) -> Evaluated<()> {
        match self.cycles.get(&name.text) {
            None => Ok(()),
            Some(None) => {
                let message = "this is on a cycle of calls that is reported above";
                Err(Diagnostic::new(name.span, message).of(Kind::Consequence))
            }
            Some(Some(cycle)) => Err(Diagnostic::new(name.span, cycle.clone()).with_help(
                "a formula can call only definitions and kernels above it; repetition is written `sum(q, k = 0..3)`",
            )),
        }
    }

    /// Checks that an argument has a new name, or that of a variable or unknown function, which it
    /// replaces in the definition.
    fn check_argument(&self, argument: &Name) -> Evaluated<()> {
        match self.theory.named(&argument.text) {
            None | Some(Named::Coordinate(_) | Named::Parameter(_) | Named::Function(_)) => Ok(()),
            Some(named @ (Named::Pending | Named::Poisoned)) => {
                Err(unusable(named, &argument.text, argument.span))
            }
            Some(other) => {
                let message = format!("`{}` is {} and cannot be an argument", argument.text, describe(other));
                Err(Diagnostic::new(argument.span, message)
                    .with_help("an argument is a coordinate, a param or a new name"))
            }
        }
    }
}

/// Check of the names in a definition.
struct Check<'a> {
    names: &'a Names,
    definitions: &'a [Arc<Definition>],
    /// Names that the definition binds.
    bound: Vec<String>,
}

impl Check<'_> {
    /// Checks the names in an expression; returns its levels of nesting. Chains of operators are
    /// one level.
    fn expression(&mut self, expression: &ast::Expr) -> Evaluated<usize> {
        let (mut leftmost, mut nesting) = (expression, 0);
        while let ExprKind::Binary(_, _, left, right) = &*leftmost.kind {
            nesting = nesting.max(self.expression(right)?);
            leftmost = left;
        }
        let below = match &*leftmost.kind {
            ExprKind::Name(name) => {
                self.name(name, leftmost.span, VALUES)?;
                0
            }
            ExprKind::Basis(name) => {
                self.name(&name.text, name.span, "`chart`")?;
                0
            }
            ExprKind::Call { function, arguments, .. } => self.call(function, arguments, leftmost)?,
            ExprKind::Index { base, indices } if matches!(&*base.kind, ExprKind::Name(name) if name == "volume") => {
                self.deepest(indices)?
            }
            _ => self.deepest(leftmost.parts())?,
        };
        Ok(nesting.max(below) + 1)
    }

    fn deepest<'e>(&mut self, parts: impl IntoIterator<Item = &'e ast::Expr>) -> Evaluated<usize> {
        parts.into_iter().try_fold(0, |deepest, part| Ok(deepest.max(self.expression(part)?)))
    }

    /// Checks a call. The variable of a range can be a new name, bound in the call.
    fn call(&mut self, function: &Name, arguments: &[Argument], call: &ast::Expr) -> Evaluated<usize> {
        let callee = self.callee(function)?;
        let outside = self.bound.len();
        for argument in arguments {
            if let Argument::Range { variable, .. } = argument {
                self.bound.push(variable.text.clone());
            }
        }
        let deepest = self.deepest(call.parts());
        self.bound.truncate(outside);
        Ok(deepest?.max(callee))
    }

    /// Returns the levels of nesting of a called definition.
    fn callee(&self, function: &Name) -> Evaluated<usize> {
        let text = function.text.as_str();
        if self.bound.iter().any(|bound| bound == text) {
            return Err(called_argument(function));
        }
        match self.names.get(text) {
            Some(Named::Definition(number)) => Ok(self.definitions[*number].nesting),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, text, function.span)),
            None if !is_function(text) => Err(self.names.unknown(text, function.span, CALLED)),
            _ => Ok(0),
        }
    }

    fn name(&self, text: &str, span: Span, items: &str) -> Evaluated<()> {
        if text == "pi" || self.bound.iter().any(|bound| bound == text) {
            return Ok(());
        }
        match self.names.get(text) {
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, text, span)),
            Some(_) => Ok(()),
            None => Err(self.names.unknown(text, span, items)),
        }
    }
}

impl Evaluator<'_> {
    /// Evaluates the body of a definition, which sees these names and no others that are bound.
    fn in_definition<T>(&mut self, names: Vec<(String, Value)>, body: impl FnOnce(&mut Self) -> T) -> T {
        let outer = self.bindings.enter(names);
        let value = body(self);
        self.bindings.leave(outer);
        value
    }

    /// Evaluates an expression in which one more name is bound.
    pub(super) fn with_bound<T>(&mut self, name: &str, value: Value, body: impl FnOnce(&mut Self) -> T) -> T {
        let names = self.bindings.with(name, value);
        self.in_definition(names, body)
    }

    /// Evaluates a call of a definition.
    pub(super) fn defined_value(
        &mut self,
        number: usize,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let definition = Arc::clone(&self.theory.definitions[number]);
        let name = &definition.name;
        if arguments.len() != definition.arguments.len() {
            let declared = format!("it is defined as `{}({})`", name.text, definition.arguments.join(", "));
            return Err(wrong_count(&name.text, definition.arguments.len(), arguments.len(), span)
                .with_related(
                    name.span.to(definition.value.span),
                    format!("the definition of `{}`", name.text),
                )
                .with_help(declared));
        }
        self.bindings.count(span)?;
        self.scope.mention(&name.text);
        let values = arguments.iter().map(|argument| self.value(argument)).collect::<Evaluated<Vec<_>>>()?;
        let bound = definition.arguments.iter().cloned().zip(values).collect();
        self.in_definition(bound, |evaluator| evaluator.value(&definition.value)).map_err(|error| match error
            .related
        {
            None => error.with_related(span, format!("the call of `{}`", name.text)),
            Some(_) => error,
        })
    }

    /// Evaluates a call of a kernel with one result in the formula of another kernel.
    pub(super) fn kernel_value(
        &mut self,
        number: usize,
        function: &Name,
        arguments: &[&ast::Expr],
        span: Span,
    ) -> Evaluated<Value> {
        let kernel = self.theory.kernels[number].clone();
        if !self.in_kernel {
            let message =
                format!("`{}` is a kernel, which only the formula of a kernel can call", kernel.name);
            return Err(Diagnostic::new(function.span, message)
                .with_help("write what both use as a definition: `let f(x) = …`"));
        }
        let [result] = kernel.signature.results[..] else {
            let results = counted(kernel.signature.results.len(), "result");
            let message =
                format!("`{}` has {results}, and only a kernel with one can be called", kernel.name);
            return Err(Diagnostic::new(function.span, message));
        };
        let images = self.images(&kernel, arguments, span)?;
        for condition in kernel.defined.iter().chain(&kernel.domain) {
            self.require_of_call(&kernel.name, *condition, &images, span)?;
        }
        self.scope.mention(&kernel.name);
        kernel.mentioned.iter().for_each(|name| self.scope.mention(name));
        Ok(Array::value(result, self.theory.pool.substitute_all(&kernel.outputs, &images)))
    }

    /// Evaluates the arguments of a kernel; returns the value of each number among them.
    fn images(&mut self, kernel: &Kernel, arguments: &[&ast::Expr], span: Span) -> Evaluated<Substitution> {
        let parameters = &kernel.signature.parameters;
        if arguments.len() != parameters.len() {
            return Err(wrong_count(&kernel.name, parameters.len(), arguments.len(), span)
                .with_related(kernel.span, format!("the definition of `{}`", kernel.name))
                .with_help(format!("it is defined as `{}({})`", kernel.name, kernel.signature)));
        }
        let mut values: Vec<Expr> = Vec::with_capacity(kernel.arguments.len());
        for (parameter, argument) in parameters.iter().zip(arguments) {
            let value = self.numbers(argument)?;
            match (parameter.shape, value) {
                (Shape::Number, Value::Scalar(scalar)) => values.push(scalar),
                (shape, Value::Zero) => {
                    let zero = self.zero();
                    values.extend(vec![zero; shape.entries()]);
                }
                (shape, Value::Array(array)) if array.shape == shape => values.extend(array.entries),
                (shape, other) => {
                    let (name, kind) = (&parameter.name, other.kind());
                    let message = format!("`{}` takes {shape} for `{name}`, found {kind}", kernel.name);
                    return Err(Diagnostic::new(argument.span, message)
                        .with_help(format!("it is defined as `{}({})`", kernel.name, kernel.signature)));
                }
            }
        }
        Ok(kernel.arguments.iter().copied().zip(values).collect())
    }

    /// Requires a condition of a called kernel at its arguments; an error if it certainly fails.
    fn require_of_call(
        &mut self,
        kernel: &str,
        condition: Condition,
        images: &Substitution,
        span: Span,
    ) -> Evaluated<()> {
        let composed = condition.substitute(&mut self.theory.pool, images);
        if composed.decided(&self.theory.pool) == Some(false) {
            let text = condition.text(&self.theory.pool);
            let message = format!("`{kernel}` has no value here: it is defined where `{text}`");
            return Err(Diagnostic::new(span, message));
        }
        self.scope.require(composed);
        Ok(())
    }
}
