//! Kernels, and gradients of kernels declared earlier.

use super::evaluation::{Evaluated, Evaluator};
use super::items::Resolver;
use crate::decide::is_implied;
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Node, Rational, Symbol, SymbolKind};
use crate::syntax::ast::{self, Declared, Item, ItemKind, Name};
use crate::theory::names::unusable;
use crate::theory::{Effect, Kernel, KernelUnits, Named, Value, describe};
use num_traits::Signed;

impl Resolver {
    pub(super) fn kernel(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Kernel { name, arguments, outputs, computed, conditions, within, effects, .. } =
            &item.kind
        else {
            return Ok(());
        };
        self.theory.names.declare(name, Named::Pending)?;
        let mut locals = Vec::new();
        let result = self.kernel_arguments(arguments, &mut locals).and_then(|symbols| {
            let ((values, mentioned, narrowing), ..) = self.evaluate(|evaluator| {
                let values = evaluator.kernel_outputs(outputs, &symbols)?;
                let scope = &evaluator.scope;
                Ok((values, scope.mentioned().clone(), scope.narrowing().clone()))
            })?;
            let ((computed, of_form), ..) = self.evaluate(|evaluator| {
                let values = evaluator.kernel_outputs(computed, &symbols)?;
                Ok((values, evaluator.scope.narrowing().clone()))
            })?;
            check_count(&values, &computed, name, item.span)?;
            let domain = self.kernel_domain(conditions, &symbols)?;
            self.check_integrals(name, narrowing.into_iter().chain(of_form), &domain)?;
            let within = within.as_ref().map(|within| self.positive_number(within)).transpose()?;
            let effects = self.kernel_effects(effects, &symbols)?;
            Ok((symbols, (values, computed), (mentioned, domain), (within, effects)))
        });
        self.forget(locals);
        let (arguments, (outputs, computed), (mentioned, domain), (within, effects)) = result?;
        let formula = self.theory.pool.texts(&outputs);
        self.theory.kernels.push(Kernel {
            name: name.text.clone(),
            docs: item.docs.clone(),
            public: item.public,
            span: item.span,
            arguments,
            outputs,
            computed,
            domain,
            within,
            effects,
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            mentioned,
        });
        self.theory.names.set(name, Named::Kernel(self.theory.kernels.len() - 1));
        Ok(())
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

    /// Resolves `kernel g = grad(f; u, v);`: the partial derivatives of each output of f, on the
    /// domain of f. The form given by `by` is differentiated as well, unless it is piecewise.
    pub(super) fn gradient(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Gradient { name, of, by } = &item.kind else { return Ok(()) };
        self.theory.names.declare(name, Named::Pending)?;
        let kernel = match self.theory.named(&of.text) {
            Some(Named::Kernel(number)) => self.theory.kernels[*number].clone(),
            Some(named @ (Named::Pending | Named::Poisoned)) => {
                return Err(unusable(named, &of.text, of.span));
            }
            Some(other) => {
                let message = format!("expected a kernel, but `{}` is {}", of.text, describe(other));
                return Err(Diagnostic::new(of.span, message));
            }
            None => return Err(self.theory.names.unknown(&of.text, of.span, "`kernel`")),
        };
        let pool = &mut self.theory.pool;
        let mut variables = Vec::new();
        for variable in by {
            let argument = kernel.arguments.iter().find(|&&symbol| pool.symbol_name(symbol) == variable.text);
            let message = || format!("`{}` is not an argument of `{}`", variable.text, of.text);
            variables.push(*argument.ok_or_else(|| Diagnostic::new(variable.span, message()))?);
        }
        let mut derivatives = |values: &[Expr]| -> Vec<Expr> {
            let pairs = values.iter().flat_map(|&value| variables.iter().map(move |&by| (value, by)));
            pairs.map(|(value, by)| pool.derivative(value, by)).collect()
        };
        let (outputs, mut computed) = (derivatives(&kernel.outputs), derivatives(&kernel.computed));
        // a piece that holds at a single point does not determine the derivative there
        let is_piecewise = |part: &Expr| matches!(pool.node(*part), Node::Select { .. });
        if pool.reachable(&computed).iter().any(is_piecewise) {
            computed.clear();
        }
        let formula = self.theory.pool.texts(&outputs);
        let (name_text, docs) = (name.text.clone(), item.docs.clone());
        let of_this = Kernel { name: name_text, docs, public: item.public, span: item.span, ..kernel };
        self.theory.kernels.push(Kernel {
            outputs,
            computed,
            within: None,
            effects: Vec::new(),
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            ..of_this
        });
        self.theory.names.set(name, Named::Kernel(self.theory.kernels.len() - 1));
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

    pub(super) fn kernel_arguments(
        &mut self,
        arguments: &[Declared],
        locals: &mut Vec<String>,
    ) -> Evaluated<Vec<Symbol>> {
        let mut symbols = Vec::new();
        for Declared { name, .. } in arguments {
            let symbol = match self.theory.named(&name.text) {
                Some(Named::Coordinate(coordinate)) => self.theory.coordinates[coordinate.0 as usize],
                Some(Named::Parameter(symbol)) => *symbol,
                Some(named @ (Named::Pending | Named::Poisoned)) => {
                    return Err(unusable(named, &name.text, name.span));
                }
                Some(other) => {
                    let message = format!("`{}` is {} and cannot be an argument", name.text, describe(other));
                    return Err(Diagnostic::new(name.span, message)
                        .with_help("an argument is a coordinate, a param or a new name"));
                }
                None => {
                    let symbol = self.theory.pool.declare_symbol(&name.text, SymbolKind::Local);
                    self.theory.names.declare(name, Named::Parameter(symbol))?;
                    locals.push(name.text.clone());
                    symbol
                }
            };
            if symbols.contains(&symbol) {
                return Err(Diagnostic::new(name.span, "this argument occurs twice"));
            }
            symbols.push(symbol);
        }
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
    pub(super) fn kernel_outputs(
        &mut self,
        outputs: &[ast::Expr],
        arguments: &[Symbol],
    ) -> Evaluated<Vec<Expr>> {
        self.in_kernel = true;
        let values = outputs.iter().map(|output| self.kernel_output(output, arguments)).collect();
        self.in_kernel = false;
        values
    }

    fn kernel_output(&mut self, output: &ast::Expr, arguments: &[Symbol]) -> Evaluated<Expr> {
        let value = match self.value(output)? {
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
            Value::Zero => self.zero(),
            Value::Scalar(value) => value,
        };
        self.check_free(&[value], arguments, output.span)?;
        Ok(value)
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

/// Checks that the form given by `by` has as many outputs as the formula.
pub(super) fn check_count(outputs: &[Expr], computed: &[Expr], name: &Name, span: Span) -> Evaluated<()> {
    if computed.is_empty() || computed.len() == outputs.len() {
        return Ok(());
    }
    let (wanted, found) = (outputs.len(), computed.len());
    Err(Diagnostic::new(span, format!("`{}` has {wanted} outputs, but `by` gives {found}", name.text)))
}
