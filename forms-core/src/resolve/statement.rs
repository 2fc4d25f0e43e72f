//! Statements and kernels: what is claimed and what is generated.

use super::evaluation::{Evaluated, Evaluator};
use super::items::Resolver;
use super::names::describe;
use super::theory::{Kernel, KernelUnits, Named, Statement};
use super::value::Value;
use crate::diagnostic::Diagnostic;
use crate::expression::{Condition, Expr, Node, Symbol, SymbolKind};
use crate::syntax::ast::{self, Claim, Declared, Item, ItemKind};
use std::collections::BTreeSet;

impl Resolver {
    pub(super) fn statement(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Statement { claim, name, left, right, conditions } = &item.kind else { return Ok(()) };
        if self.theory.statements.iter().any(|statement| statement.name == name.text) {
            return Err(Diagnostic::new(
                name.span,
                format!("a statement named `{}` exists already", name.text),
            ));
        }
        let evaluated = self.evaluate(|evaluator| {
            let mut own = Vec::new();
            for condition in conditions {
                own.extend(evaluator.conditions(condition)?);
            }
            evaluator.given = own.clone();
            let sides = (evaluator.value(left)?, evaluator.value(right)?);
            comparable(&sides.0, &sides.1).map_err(|message| Diagnostic::new(item.span, message))?;
            Ok((sides, own, evaluator.scope.mentioned().clone()))
        });
        let (evaluated, obstacle) = match evaluated {
            Err(diagnostic) if diagnostic.is_open => {
                let nothing = ((Value::Zero, Value::Zero), Vec::new(), BTreeSet::new());
                ((nothing, Vec::new(), Vec::new()), Some(diagnostic.message))
            }
            evaluated => (evaluated?, None),
        };
        let (((left, right), mut own, mentioned), domain, used) = evaluated;
        own.extend(self.chart_conditions(&used));
        self.theory.statements.push(Statement {
            name: name.text.clone(),
            docs: item.docs.clone(),
            claim: *claim,
            span: item.span,
            name_span: name.span,
            left,
            right,
            obstacle,
            conditions: own,
            domain,
            mentioned,
        });
        Ok(())
    }

    /// The domains of charts, as far as every coordinate they mention is used.
    fn chart_conditions(&self, used: &[Symbol]) -> Vec<Condition> {
        let mut found: Vec<Condition> = Vec::new();
        for chart in &self.theory.charts {
            let own = chart.coordinates.iter().map(|c| self.theory.coordinates[c.0 as usize]);
            if !own.into_iter().any(|symbol| used.contains(&symbol)) {
                continue;
            }
            for condition in &chart.conditions {
                let mentioned = self.theory.pool.symbols_in(&[condition.left, condition.right]);
                let mut coordinates = mentioned
                    .into_iter()
                    .filter(|symbol| self.theory.pool.symbol_kind(*symbol) == SymbolKind::Coordinate);
                if coordinates.all(|symbol| used.contains(&symbol)) && !found.contains(condition) {
                    found.push(*condition);
                }
            }
        }
        found
    }

    /// Tells each kernel the claims that speak of the maps it uses or, without a map, of the values it uses;
    /// and those that speak of nothing else than it does.
    pub(super) fn attribute_statements(&mut self) {
        let theory = &mut self.theory;
        for kernel in &mut theory.kernels {
            let is_map = |name: &&String| matches!(theory.names.get(name), Some(Named::Map(_)));
            let maps: BTreeSet<&String> = kernel.mentioned.iter().filter(is_map).collect();
            let speaks_of_it = |statement: &&Statement| {
                let shared = statement.mentioned.intersection(&kernel.mentioned).collect::<BTreeSet<_>>();
                let whole = !shared.is_empty() && shared.len() == statement.mentioned.len();
                let relevant = if maps.is_empty() { !shared.is_empty() } else { !shared.is_disjoint(&maps) };
                statement.claim == Claim::Prove && (whole || relevant)
            };
            kernel.statements = theory
                .statements
                .iter()
                .filter(speaks_of_it)
                .map(|statement| statement.name.clone())
                .collect();
        }
    }

    pub(super) fn kernel(&mut self, item: &Item) -> Evaluated<()> {
        let ItemKind::Kernel { name, arguments, outputs, conditions, .. } = &item.kind else { return Ok(()) };
        self.theory.names.declare(name, Named::Poisoned)?;
        let mut locals = Vec::new();
        let result = self.kernel_arguments(arguments, &mut locals).and_then(|symbols| {
            let ((values, mentioned), _, _) = self.evaluate(|evaluator| {
                let values: Vec<Expr> = outputs
                    .iter()
                    .map(|output| evaluator.kernel_output(output, &symbols))
                    .collect::<Evaluated<_>>()?;
                Ok((values, evaluator.scope.mentioned().clone()))
            })?;
            let domain = self.kernel_domain(conditions, &symbols)?;
            Ok((symbols, values, mentioned, domain))
        });
        for local in locals {
            self.theory.names.remove(&local);
        }
        let (arguments, outputs, mentioned, domain) = result?;
        let formula = self.theory.pool.texts(&outputs);
        self.theory.kernels.push(Kernel {
            name: name.text.clone(),
            docs: item.docs.clone(),
            public: item.public,
            span: item.span,
            arguments,
            outputs,
            domain,
            formula,
            units: KernelUnits::default(),
            statements: Vec::new(),
            mentioned,
        });
        self.theory.names.set(name, Named::Kernel(self.theory.kernels.len() - 1));
        Ok(())
    }

    fn kernel_arguments(
        &mut self,
        arguments: &[Declared],
        locals: &mut Vec<String>,
    ) -> Evaluated<Vec<Symbol>> {
        let mut symbols = Vec::new();
        for Declared { name, .. } in arguments {
            let symbol = match self.theory.named(&name.text) {
                Some(Named::Coordinate(coordinate)) => self.theory.coordinates[coordinate.0 as usize],
                Some(Named::Parameter(symbol)) => *symbol,
                Some(other) => {
                    let message = format!("`{}` is {} and no argument", name.text, describe(other));
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

    fn kernel_domain(
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

impl Evaluator<'_> {
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

    /// That expressions depend on a kernel's arguments and nothing else.
    fn check_free(
        &self,
        values: &[Expr],
        arguments: &[Symbol],
        span: crate::diagnostic::Span,
    ) -> Evaluated<()> {
        let pool = &self.theory.pool;
        if let Some(free) = pool.symbols_in(values).into_iter().find(|symbol| !arguments.contains(symbol)) {
            return Err(Diagnostic::new(
                span,
                format!("`{}` is not an argument of the kernel", pool.symbol_name(free)),
            )
            .with_help(format!("add `{}` to the kernel's arguments", pool.symbol_name(free))));
        }
        for node in pool.reachable(values) {
            if let Node::Jet { function, .. } = pool.node(node) {
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

fn comparable(left: &Value, right: &Value) -> Result<(), String> {
    let alike = match (left, right) {
        (Value::Zero, _) | (_, Value::Zero) => true,
        (Value::Scalar(_), Value::Scalar(_)) | (Value::Field(_), Value::Field(_)) => true,
        (Value::Form(a), Value::Form(b)) => a.degree() == b.degree(),
        _ => false,
    };
    if alike { Ok(()) } else { Err(format!("cannot compare {} with {}", left.kind(), right.kind())) }
}
