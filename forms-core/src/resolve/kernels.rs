//! Kernels: their arguments, formulas, domains and effects.
//!
//! An array among the arguments or results is the list of its entries by rows; its shape is in the
//! kernel's signature.

use super::evaluation::{Evaluated, Evaluator};
use super::items::Resolver;
use super::kernel_forms::{Forms, Results};
use crate::decide::is_implied;
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Node, Parameter, Rational, Shape, Signature, Symbol, SymbolKind};
use crate::syntax::ast::{self, Declared, Item, ItemKind, Name};
use crate::theory::names::unusable;
use crate::theory::{Array, Effect, Kernel, KernelUnits, Named, Value, describe};
use num_traits::Signed;
use std::collections::BTreeSet;

/// Formulas of a kernel as evaluated.
struct Body {
    results: Results,
    forms: Forms,
    mentioned: BTreeSet<String>,
    defined: Vec<Condition>,
    domain: Vec<Condition>,
    within: Option<Rational>,
    effects: Vec<Effect>,
}

impl Resolver {
    pub(super) fn kernel(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Kernel { name, arguments, .. } = &item.kind else { return Ok(()) };
        self.theory.names.declare(name, Named::Pending)?;
        self.check_recursion(name)?;
        let mut locals = Vec::new();
        let result = self.kernel_arguments(arguments, &mut locals).and_then(|(parameters, symbols)| {
            let body = self.kernel_body(item, &symbols)?;
            Ok((parameters, symbols, body))
        });
        self.forget(locals);
        let (parameters, arguments, body) = result?;
        let Body { results: Results { shapes, numbers: outputs }, forms, mentioned, .. } = body;
        let formula = self.theory.pool.texts(&outputs);
        self.theory.kernels.push(Kernel {
            name: name.text.clone(),
            docs: item.docs.clone(),
            public: item.public,
            span: item.span,
            signature: Signature { parameters, results: shapes },
            arguments,
            outputs,
            computed: forms.computed,
            approximation: forms.approximation,
            target_forms: forms.target_forms,
            domain: body.domain,
            within: body.within,
            effects: body.effects,
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            mentioned,
            defined: body.defined,
        });
        self.theory.names.set(name, Named::Kernel(self.theory.kernels.len() - 1));
        Ok(())
    }

    /// Evaluates everything after the head of a kernel.
    fn kernel_body(&mut self, item: &Item, symbols: &[Symbol]) -> Evaluated<Body> {
        let ItemKind::Kernel { name, outputs, conditions, within, effects, .. } = &item.kind else {
            return Err(Diagnostic::new(item.span, "expected a kernel"));
        };
        let ((results, mentioned, narrowing), defined, _) = self.evaluate(|evaluator| {
            let results = evaluator.kernel_results(outputs, symbols)?;
            let scope = &evaluator.scope;
            Ok((results, scope.mentioned().clone(), scope.narrowing().clone()))
        })?;
        let (forms, of_forms) = self.kernel_forms(item, symbols, &results)?;
        let domain = self.kernel_domain(conditions, symbols)?;
        self.check_integrals(name, narrowing.into_iter().chain(of_forms), &domain)?;
        let within = within.as_ref().map(|within| self.positive_number(within)).transpose()?;
        let effects = self.kernel_effects(effects, symbols)?;
        Ok(Body { results, forms, mentioned, defined, domain, within, effects })
    }

    /// Rejects a kernel if the value of an integral in it is only valid under a condition that the
    /// kernel's domain does not imply: where that condition fails, the integral has a value but the
    /// kernel would have none.
    fn check_integrals(
        &mut self,
        name: &Name,
        narrowing: impl Iterator<Item = Condition>,
        domain: &[Condition],
    ) -> Evaluated<()> {
        for condition in narrowing {
            if !is_implied(&mut self.theory.pool, &condition, domain) {
                let text = condition.text(&self.theory.pool);
                let message =
                    format!("the value of an integral in `{}` is known only where `{text}`", name.text);
                return Err(Diagnostic::new(name.span, message).with_help(format!("add `where {text}`")));
            }
        }
        Ok(())
    }

    /// Removes the names that were local to an item.
    pub(super) fn forget(&mut self, locals: Vec<String>) {
        locals.iter().for_each(|local| self.theory.names.remove(local));
    }

    /// Evaluates the number after `within`.
    pub(super) fn positive_number(&mut self, within: &ast::Expr) -> Evaluated<Rational> {
        let (value, _, _) = self.evaluate(|evaluator| evaluator.scalar(within))?;
        match self.theory.pool.as_number(value).filter(|number| number.is_positive()) {
            Some(number) => Ok(number.clone()),
            None => Err(Diagnostic::new(within.span, "expected a positive rational number")
                .with_help("`within 1` allows an error of 2**-53 of the value")),
        }
    }

    /// Declares the arguments of a kernel; returns them as declared, and the variable of each number
    /// among them.
    pub(super) fn kernel_arguments(
        &mut self,
        arguments: &[Declared],
        locals: &mut Vec<String>,
    ) -> Evaluated<(Vec<Parameter>, Vec<Symbol>)> {
        let (mut parameters, mut symbols): (Vec<Parameter>, Vec<Symbol>) = (Vec::new(), Vec::new());
        for Declared { name, extents, .. } in arguments {
            let shape = Shape::of(extents).unwrap_or_default();
            let own = match shape {
                Shape::Number => vec![self.kernel_argument(name, locals)?],
                _ => self.array_argument(name, shape, locals)?,
            };
            if own.iter().any(|symbol| symbols.contains(symbol)) {
                return Err(Diagnostic::new(name.span, "this argument occurs twice"));
            }
            let parameter = Parameter { name: name.text.clone(), shape };
            check_entry_names(&parameters, &parameter, name)?;
            parameters.push(parameter);
            symbols.extend(own);
        }
        Ok((parameters, symbols))
    }

    fn kernel_argument(&mut self, name: &Name, locals: &mut Vec<String>) -> Evaluated<Symbol> {
        match self.theory.named(&name.text) {
            Some(Named::Coordinate(coordinate)) => Ok(self.theory.coordinates[coordinate.0 as usize]),
            Some(Named::Parameter(symbol)) => Ok(*symbol),
            Some(Named::Array(_)) => Err(Diagnostic::new(name.span, "this argument occurs twice")),
            Some(named @ (Named::Pending | Named::Poisoned)) => Err(unusable(named, &name.text, name.span)),
            Some(other) => {
                let message = format!("`{}` is {} and cannot be an argument", name.text, describe(other));
                Err(Diagnostic::new(name.span, message)
                    .with_help("an argument is a coordinate, a param or a new name"))
            }
            None => {
                let symbol = self.theory.pool.declare_symbol(&name.text, SymbolKind::Local);
                self.theory.names.declare(name, Named::Parameter(symbol))?;
                locals.push(name.text.clone());
                Ok(symbol)
            }
        }
    }

    /// Declares an array; returns the variable of each of its entries.
    fn array_argument(
        &mut self,
        name: &Name,
        shape: Shape,
        locals: &mut Vec<String>,
    ) -> Evaluated<Vec<Symbol>> {
        match self.theory.named(&name.text) {
            None => {}
            Some(named @ (Named::Pending | Named::Poisoned)) => {
                return Err(unusable(named, &name.text, name.span));
            }
            Some(other) => {
                let message = format!("`{}` is {} and cannot be an array", name.text, describe(other));
                return Err(Diagnostic::new(name.span, message).with_help("an array has a new name"));
            }
        }
        let pool = &mut self.theory.pool;
        let names = shape.names(&name.text).into_iter();
        let symbols: Vec<Symbol> = names.map(|name| pool.declare_symbol(name, SymbolKind::Local)).collect();
        let entries = symbols.iter().map(|&symbol| pool.symbol(symbol)).collect();
        self.theory.names.declare(name, Named::Array(self.theory.arrays.len()))?;
        self.theory.arrays.push(Array { shape, entries });
        locals.push(name.text.clone());
        Ok(symbols)
    }

    pub(super) fn kernel_domain(
        &mut self,
        conditions: &[ast::Condition],
        arguments: &[Symbol],
    ) -> Evaluated<Vec<Condition>> {
        let (domain, _, _) = self.evaluate(|evaluator| {
            let mut domain = Vec::new();
            for condition in conditions {
                let single = evaluator.conditions(condition)?;
                let sides: Vec<Expr> = single.iter().flat_map(|c| [c.left, c.right]).collect();
                evaluator.check_free(&sides, arguments, condition.span)?;
                domain.extend(single);
            }
            Ok(domain)
        })?;
        Ok(domain)
    }
}

/// Maximum number of effects of one kernel: each effect doubles the number of its specialisations.
const MOST_EFFECTS: usize = 6;

impl Resolver {
    /// Resolves the entries of an `effects { … }` clause.
    fn kernel_effects(&mut self, effects: &[ast::Effect], arguments: &[Symbol]) -> Evaluated<Vec<Effect>> {
        let mut resolved: Vec<Effect> = Vec::new();
        for ast::Effect { name, variable, value } in effects {
            let span = name.span.to(value.span);
            if resolved.len() == MOST_EFFECTS {
                return Err(Diagnostic::new(span, format!("a kernel has at most {MOST_EFFECTS} effects"))
                    .with_help("each of them doubles the number of its specialisations"));
            }
            if resolved.iter().any(|effect| effect.name == name.text) {
                return Err(Diagnostic::new(name.span, format!("the effect `{}` occurs twice", name.text)));
            }
            let named = |symbol: &&Symbol| self.theory.pool.symbol_name(**symbol) == variable.text;
            if matches!(self.theory.named(&variable.text), Some(Named::Array(_))) {
                let message =
                    format!("`{}` is an array, and an effect is switched off by a number", variable.text);
                let help = format!("name an entry: `{}_0`", variable.text);
                return Err(Diagnostic::new(variable.span, message).with_help(help));
            }
            let Some(&symbol) = arguments.iter().find(named) else {
                let message = format!("`{}` is not an argument of the kernel", variable.text);
                return Err(Diagnostic::new(variable.span, message).with_help(
                    "an effect is switched off by the value of an argument, as in `sigma_a = 0`",
                ));
            };
            if resolved.iter().any(|effect| effect.variable == symbol) {
                let message = format!("`{}` already switches off another effect", variable.text);
                return Err(Diagnostic::new(variable.span, message));
            }
            let ((value, is_own), _, _) = self.evaluate(|evaluator| {
                let found = evaluator.scalar(value)?;
                evaluator.check_free(&[found], arguments, value.span)?;
                Ok((found, evaluator.theory.pool.symbols_in(&[found]).contains(&symbol)))
            })?;
            if is_own {
                let message = format!("the value of `{}` cannot depend on itself", variable.text);
                return Err(Diagnostic::new(span, message));
            }
            resolved.push(Effect { name: name.text.clone(), variable: symbol, value, span });
        }
        Ok(resolved)
    }
}

impl Evaluator<'_> {
    /// Evaluates expressions that must be scalars.
    pub(super) fn kernel_outputs(
        &mut self,
        outputs: &[ast::Expr],
        arguments: &[Symbol],
    ) -> Evaluated<Vec<Expr>> {
        let Results { shapes, numbers } = self.kernel_results(outputs, arguments)?;
        match outputs.iter().zip(shapes).find(|(_, shape)| *shape != Shape::Number) {
            None => Ok(numbers),
            Some((output, shape)) => {
                Err(Diagnostic::new(output.span, format!("expected a scalar, found {shape}")))
            }
        }
    }

    /// Evaluates the results of a kernel.
    pub(super) fn kernel_results(
        &mut self,
        outputs: &[ast::Expr],
        arguments: &[Symbol],
    ) -> Evaluated<Results> {
        self.in_kernel = true;
        let mut results = Results::default();
        let evaluated = outputs.iter().try_for_each(|output| {
            let (shape, numbers) = self.kernel_result(output, arguments)?;
            results.shapes.push(shape);
            results.numbers.extend(numbers);
            Ok(())
        });
        self.in_kernel = false;
        evaluated.map(|()| results)
    }

    fn kernel_result(&mut self, output: &ast::Expr, arguments: &[Symbol]) -> Evaluated<(Shape, Vec<Expr>)> {
        let (shape, values) = match self.value(output)? {
            Value::Form(form) => {
                return Err(Diagnostic::new(
                    output.span,
                    format!("a kernel computes scalars, and this is a {}-form", form.degree()),
                )
                .with_help("take a coefficient, as in `pullback(F, w)[du^dv]`"));
            }
            Value::Field(_) => {
                return Err(Diagnostic::new(
                    output.span,
                    "a kernel computes scalars, and this is a vector field",
                )
                .with_help("take a component, as in `X[x]`"));
            }
            Value::Zero => (Shape::Number, vec![self.zero()]),
            Value::Scalar(value) => (Shape::Number, vec![value]),
            Value::Array(Array { shape, entries }) => (shape, entries),
        };
        self.check_free(&values, arguments, output.span)?;
        Ok((shape, values))
    }

    /// Checks that expressions depend on the kernel's arguments only.
    fn check_free(&self, values: &[Expr], arguments: &[Symbol], span: Span) -> Evaluated<()> {
        let pool = &self.theory.pool;
        if let Some(free) = pool.symbols_in(values).into_iter().find(|symbol| !arguments.contains(symbol)) {
            return Err(Diagnostic::new(
                span,
                format!("`{}` is not an argument of the kernel", pool.symbol_name(free)),
            )
            .with_help(format!("add `{}` to the kernel's arguments", pool.symbol_name(free))));
        }
        for node in pool.reachable(values) {
            if let Node::Jet { function, .. } = pool.node(node)
                && pool.quadrature_of(*function).is_none()
            {
                return Err(Diagnostic::new(
                    span,
                    format!(
                        "`{}` is an unknown function, which a kernel cannot compute",
                        pool.function(*function).name
                    ),
                ));
            }
        }
        Ok(())
    }
}

/// Checks that the numbers of an argument have other names than those of the arguments before it.
fn check_entry_names(earlier: &[Parameter], parameter: &Parameter, name: &Name) -> Evaluated<()> {
    let own = parameter.shape.names(&parameter.name);
    for other in earlier {
        let names = other.shape.names(&other.name);
        if let Some(shared) = own.iter().find(|own| names.contains(own)) {
            let array = if other.shape == Shape::Number { parameter } else { other };
            let message = format!("`{shared}` is also the name of an entry of the array `{}`", array.name);
            return Err(Diagnostic::new(name.span, message).with_help("rename one of the two"));
        }
    }
    Ok(())
}
