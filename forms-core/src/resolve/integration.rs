//! `integral(w, u = a..b, v = c..e)`: the innermost range last, the form's coefficient in the order written.

use super::evaluation::{Evaluated, Evaluator};
use super::value::Value;
use crate::assume::is_at_most;
use crate::calculus::Blade;
use crate::diagnostic::{Diagnostic, Span};
use crate::expression::{Condition, Expr, Symbol};
use crate::integral::definite_integral;
use crate::syntax::ast::{self, Argument, ExprKind, Name, Relation};

/// One range of an integral.
struct Range {
    name: Name,
    symbol: Symbol,
    from: Expr,
    to: Expr,
}

impl Evaluator<'_> {
    pub(super) fn integral(&mut self, arguments: &[Argument], span: Span) -> Evaluated<Value> {
        let Some((Argument::Value(integrand), ranges)) = arguments.split_first() else {
            return Err(Diagnostic::new(span, "`integral` takes an integrand first: integral(w, u = 0..1)"));
        };
        if ranges.is_empty() {
            return Err(Diagnostic::new(span, "`integral` needs at least one range, as in `u = 0..1`"));
        }
        let ranges = ranges.iter().map(|range| self.range(range)).collect::<Evaluated<Vec<_>>>()?;
        let outer = std::mem::take(&mut self.scope);
        let value = self.value(integrand);
        let inner = std::mem::replace(&mut self.scope, outer);
        let mut integral = self.integrand(value?, &ranges, integrand.span)?;
        let assumptions = self.assumptions(inner.conditions(), &ranges);
        for range in ranges.iter().rev() {
            let (name, pool) = (&range.name.text, &mut self.theory.pool);
            integral = definite_integral(pool, integral, range.symbol, (range.from, range.to), &assumptions)
                .map_err(|reason| {
                    Diagnostic::new(integrand.span, format!("cannot integrate over `{name}`: {reason}"))
                })?;
        }
        for condition in inner.conditions().iter().copied() {
            let symbols = self.theory.pool.symbols_in(&[condition.left, condition.right]);
            if !ranges.iter().any(|range| symbols.contains(&range.symbol)) {
                self.scope.require(condition);
            }
        }
        for symbol in inner.used() {
            if !ranges.iter().any(|range| range.symbol == symbol) {
                self.scope.touch(symbol);
            }
        }
        Ok(Value::Scalar(integral))
    }

    fn range(&mut self, argument: &Argument) -> Evaluated<Range> {
        let Argument::Range { variable, from, to } = argument else {
            let span = if let Argument::Value(value) = argument { value.span } else { Span::default() };
            return Err(Diagnostic::new(span, "expected a range such as `u = 0..1`"));
        };
        let name = ast::Expr { kind: Box::new(ExprKind::Name(variable.text.clone())), span: variable.span };
        let symbol = self.variable_named(&name)?;
        let bounds = (self.scalar(from)?, self.scalar(to)?);
        self.scope.forget(symbol);
        Ok(Range { name: variable.clone(), symbol, from: bounds.0, to: bounds.1 })
    }

    /// The scalar to integrate: of a form its coefficient in the order of the ranges.
    fn integrand(&mut self, value: Value, ranges: &[Range], span: Span) -> Evaluated<Expr> {
        let form = match value {
            Value::Zero => return Ok(self.zero()),
            Value::Scalar(value) => return Ok(value),
            Value::Form(form) => form,
            Value::Field(_) => {
                return Err(Diagnostic::new(span, "expected a scalar or a form, found a vector field"));
            }
        };
        if form.degree() as usize != ranges.len() {
            return Err(Diagnostic::new(
                span,
                format!("a {}-form needs {} ranges, found {}", form.degree(), form.degree(), ranges.len()),
            ));
        }
        let mut blade = (Blade::SCALAR, 1);
        for range in ranges {
            let coordinate = self.coordinate(&range.name)?;
            blade = match blade.0.wedge(Blade::of(coordinate)) {
                Some((wedge, sign)) => (wedge, sign * blade.1),
                None => return Err(Diagnostic::new(range.name.span, "this variable has a range already")),
            };
        }
        let zero = self.zero();
        let coefficient = form.coefficient(blade.0).copied().unwrap_or(zero);
        Ok(if blade.1 < 0 { self.theory.pool.negate(coefficient) } else { coefficient })
    }

    /// What may be used about the integrand: where it is defined, its charts' domains, and the ranges that are
    /// known not to run backwards.
    fn assumptions(&mut self, inner: &[Condition], ranges: &[Range]) -> Vec<Condition> {
        let mut all: Vec<Condition> = inner.to_vec();
        all.extend(self.scope.conditions());
        for range in ranges {
            if !is_at_most(&mut self.theory.pool, range.from, range.to, &all) {
                continue;
            }
            let variable = self.theory.pool.symbol(range.symbol);
            all.push(Condition { left: variable, relation: Relation::GreaterEqual, right: range.from });
            all.push(Condition { left: variable, relation: Relation::LessEqual, right: range.to });
        }
        all
    }
}
