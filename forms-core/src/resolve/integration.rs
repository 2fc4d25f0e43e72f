//! `integral(w, u = a..b, v = c..e)`: ranges from outermost to innermost; the coefficient of the
//! form is taken in the order written.

use super::evaluation::{Evaluated, Evaluator};
use super::scope::Scope;
use crate::assume::is_at_most;
use crate::calculus::{Blade, Form};
use crate::diagnostic::{Diagnostic, Kind, Span, counted};
use crate::expression::{Condition, Expr, Relation, Symbol, SymbolKind};
use crate::integral::{Region, Strictness};
use crate::syntax::ast::{self, Argument, ExprKind, Name};
use crate::theory::{Integration, Named, Value};

/// Range of an integral.
#[derive(Clone)]
pub(super) struct Range {
    pub(super) name: Name,
    pub(super) symbol: Symbol,
    pub(super) from: Expr,
    pub(super) to: Expr,
}

impl Evaluator<'_> {
    pub(super) fn integral(&mut self, arguments: &[Argument], span: Span) -> Evaluated<Value> {
        let Some((Argument::Value(integrand), ranges)) = arguments.split_first() else {
            return Err(Diagnostic::new(span, "`integral` takes an integrand first: integral(w, u = 0..1)"));
        };
        if ranges.is_empty() {
            return Err(Diagnostic::new(span, "`integral` needs at least one range, as in `u = 0..1`"));
        }
        let (ranges, bounds) = self.ranges(ranges)?;
        let (value, inner) =
            self.bound_by(&ranges, |evaluator| evaluator.apart(|evaluator| evaluator.value(integrand)))?;
        let coefficient = self.integrand(value, &ranges, integrand.span)?;
        let defined: Vec<Condition> = bounds.conditions().iter().chain(inner.conditions()).copied().collect();
        let integral = self.iterated(coefficient, &ranges, &defined, integrand.span)?;
        self.keep_outside(&bounds, &ranges);
        self.keep_outside(&inner, &ranges);
        Ok(Value::Scalar(integral))
    }

    /// Evaluates `quadrature(f, t = a..b)`, an integral that stays unevaluated. In a statement the
    /// integrand must be known to be defined on the whole range. In a kernel this is not checked: a
    /// point where the integrand is undefined shows up when the kernel is computed.
    pub(super) fn quadrature(&mut self, arguments: &[Argument], span: Span) -> Evaluated<Value> {
        let [Argument::Value(integrand), range @ Argument::Range { variable, .. }] = arguments else {
            let message = "`quadrature` takes an integrand and one range: quadrature(f, t = 0..1)";
            return Err(Diagnostic::new(span, message));
        };
        // the variable can be a new, local name
        if self.bindings.are_in_body() && self.is_local(&variable.text) {
            let symbol = self.theory.pool.declare_symbol(&variable.text, SymbolKind::Local);
            let value = Value::Scalar(self.theory.pool.symbol(symbol));
            return self
                .with_bound(&variable.text, value, |evaluator| evaluator.quadrature_over(integrand, range));
        }
        let is_new = self.theory.named(&variable.text).is_none();
        if is_new {
            let symbol = self.theory.pool.declare_symbol(&variable.text, SymbolKind::Local);
            self.theory.names.declare(variable, Named::Parameter(symbol))?;
        }
        let value = self.quadrature_over(integrand, range);
        if is_new {
            self.theory.names.remove(&variable.text);
        }
        value
    }

    /// Whether a name in the body of a definition or sum is new in it, although the kernel that is
    /// being read can have an argument of the same name.
    fn is_local(&self, name: &str) -> bool {
        match self.theory.named(name) {
            None => true,
            Some(Named::Parameter(symbol)) => self.theory.pool.symbol_kind(*symbol) == SymbolKind::Local,
            Some(_) => self.bindings.get(name).is_some(),
        }
    }

    fn quadrature_over(&mut self, integrand: &ast::Expr, range: &Argument) -> Evaluated<Value> {
        let (ranges, bounds) = self.ranges(std::slice::from_ref(range))?;
        let (value, inner) =
            self.bound_by(&ranges, |evaluator| evaluator.apart(|evaluator| evaluator.scalar(integrand)))?;
        if !self.in_kernel {
            let mut region = self.region(value, inner.conditions(), &ranges);
            let unmet = region.first_unmet(&mut self.theory.pool, inner.conditions(), Strictness::Strict);
            if let Some(condition) = unmet {
                let text = condition.text(&self.theory.pool);
                let message = format!("it is not known that `{text}` holds on the whole range");
                return Err(Diagnostic::new(integrand.span, message));
            }
        }
        let Range { symbol, from, to, .. } = ranges[0];
        let integral = self.theory.pool.quadrature(value, symbol, from, to);
        self.keep_outside(&bounds, &ranges);
        self.keep_outside(&inner, &ranges);
        Ok(Value::Scalar(integral))
    }

    /// Evaluates an integrand, without the statement's conditions that mention the variables of the
    /// ranges: those conditions do not hold for the bound variables.
    fn bound_by<T>(
        &mut self,
        ranges: &[Range],
        body: impl FnOnce(&mut Self) -> Evaluated<T>,
    ) -> Evaluated<T> {
        let given = self.given.clone();
        let pool = &self.theory.pool;
        self.given.retain(|condition| {
            let symbols = pool.symbols_in(&[condition.left, condition.right]);
            !ranges.iter().any(|range| symbols.contains(&range.symbol))
        });
        let value = body(self);
        self.given = given;
        value
    }

    /// Returns the ranges, outermost first, and the conditions under which their bounds are
    /// defined. A bound can mention outer variables only.
    pub(super) fn ranges(&mut self, arguments: &[Argument]) -> Evaluated<(Vec<Range>, Scope)> {
        let (ranges, scope) = self.apart(|evaluator| {
            arguments.iter().map(|argument| evaluator.range(argument)).collect::<Evaluated<Vec<_>>>()
        })?;
        for (place, range) in ranges.iter().enumerate() {
            let mentioned = self.theory.pool.symbols_in(&[range.from, range.to]);
            if let Some(inner) = ranges[place..].iter().find(|inner| mentioned.contains(&inner.symbol)) {
                let (own, other) = (&range.name.text, &inner.name.text);
                return Err(Diagnostic::new(
                    range.name.span,
                    format!("the bounds of `{own}` mention `{other}`, which has no value outside its range"),
                )
                .with_help(
                    "ranges are written outermost first; a bound may mention the variables before it",
                ));
            }
        }
        Ok((ranges, scope))
    }

    /// Evaluates in a new scope and returns that scope with the value.
    pub(super) fn apart<T>(&mut self, body: impl FnOnce(&mut Self) -> Evaluated<T>) -> Evaluated<(T, Scope)> {
        let outer = std::mem::take(&mut self.scope);
        let value = body(self);
        let inner = std::mem::replace(&mut self.scope, outer);
        Ok((value?, inner))
    }

    /// Integrates over the innermost range first; `defined` holds the conditions under which the
    /// integrand is defined.
    pub(super) fn iterated(
        &mut self,
        integrand: Expr,
        ranges: &[Range],
        defined: &[Condition],
        span: Span,
    ) -> Evaluated<Expr> {
        let mut region = self.region(integrand, defined, ranges);
        // Domains of charts only limit the coordinates; the integrand can be defined beyond them.
        let charts = &self.theory.charts;
        let is_domain =
            |condition: &&Condition| charts.iter().any(|chart| chart.conditions.contains(condition));
        let (domains, needed): (Vec<&Condition>, Vec<&Condition>) = defined.iter().partition(is_domain);
        let (domains, needed): (Vec<Condition>, Vec<Condition>) =
            (domains.into_iter().copied().collect(), needed.into_iter().copied().collect());
        let pool = &mut self.theory.pool;
        let outside = region.first_unmet(pool, &domains, Strictness::Weak);
        if let Some(condition) = outside.or_else(|| region.unmet(pool, integrand, &needed)) {
            let text = condition.text(&self.theory.pool);
            let message = format!("cannot integrate: it is not known that `{text}` holds on the whole range");
            return Err(Diagnostic::new(span, message));
        }
        let whole = region.clone();
        let mut integral = integrand;
        for range in ranges.iter().rev() {
            let attempt = region.integral(&mut self.theory.pool, integral);
            if self.in_kernel && attempt.is_err() {
                // an integral without a closed form is computed numerically if its integrand is
                // known to be continuous
                let mut whole = whole.clone();
                if whole.first_unmet(&mut self.theory.pool, defined, Strictness::Strict).is_none() {
                    integral = self.theory.pool.quadrature(integral, range.symbol, range.from, range.to);
                    region.forget_innermost(&self.theory.pool);
                    continue;
                }
            }
            let found = attempt.map_err(|reason| {
                let message = format!("cannot integrate over `{}`: {reason}", range.name.text);
                // An integrand that is continuous on a closed box has an integral; with a
                // singularity the integral can fail to exist.
                match whole.clone().first_unmet(&mut self.theory.pool, defined, Strictness::Strict) {
                    None => Diagnostic::new(span, message).of(Kind::Open),
                    Some(_) => Diagnostic::new(span, message),
                }
            })?;
            self.theory.integrations.push(Integration {
                place: range.name.span,
                variable: range.symbol,
                integrand: integral,
                antiderivative: found.antiderivative,
                conditions: region.conditions.clone(),
            });
            self.narrow(found.conditions);
            integral = found.value;
            region.forget_innermost(&self.theory.pool);
        }
        Ok(integral)
    }

    /// Requires conditions under which the computed value of an integral is valid. A condition `≠
    /// 0` can be a limitation of the closed form alone, and is recorded as narrowing; an inequality
    /// states where the integral converges.
    pub(super) fn narrow(&mut self, conditions: Vec<Condition>) {
        for condition in conditions {
            let is_narrowing = condition.relation == Relation::NotEqual;
            if is_narrowing {
                self.theory.narrowing.insert(condition);
            }
            self.scope.adopt(condition, is_narrowing);
        }
    }

    /// Keeps the conditions and variables of an inner scope that do not involve the variables of
    /// the ranges.
    pub(super) fn keep_outside(&mut self, inner: &Scope, ranges: &[Range]) {
        inner.mentioned().iter().for_each(|name| self.scope.mention(name));
        for condition in inner.conditions().iter().copied() {
            let symbols = self.theory.pool.symbols_in(&[condition.left, condition.right]);
            if !ranges.iter().any(|range| symbols.contains(&range.symbol)) {
                self.scope.adopt(condition, inner.narrowing().contains(&condition));
            }
        }
        for symbol in inner.used() {
            if !ranges.iter().any(|range| range.symbol == symbol) {
                self.scope.touch(symbol);
            }
        }
    }

    fn range(&mut self, argument: &Argument) -> Evaluated<Range> {
        let Argument::Range { variable, from, to } = argument else {
            let span = if let Argument::Value(value) = argument { value.span } else { Span::default() };
            return Err(Diagnostic::new(span, "expected a range such as `u = 0..1`"));
        };
        let name = ast::Expr { kind: Box::new(ExprKind::Name(variable.text.clone())), span: variable.span };
        let symbol = self.variable_named(&name)?;
        let bounds = (self.scalar(from)?, self.scalar(to)?);
        Ok(Range { name: variable.clone(), symbol, from: bounds.0, to: bounds.1 })
    }

    /// Returns the scalar to integrate: for a form, its coefficient in the order of the ranges.
    fn integrand(&mut self, value: Value, ranges: &[Range], span: Span) -> Evaluated<Expr> {
        let form = match value {
            Value::Zero => return Ok(self.zero()),
            Value::Scalar(value) => return Ok(value),
            Value::Form(form) => form,
            other @ (Value::Field(_) | Value::Array(_)) => {
                let message = format!("expected a scalar or a form, found {}", other.kind());
                return Err(Diagnostic::new(span, message));
            }
        };
        if form.degree() as usize != ranges.len() {
            return Err(Diagnostic::new(
                span,
                format!(
                    "a {}-form needs {}, found {}",
                    form.degree(),
                    counted(form.degree() as usize, "range"),
                    ranges.len()
                ),
            ));
        }
        let blade = self.blade_of(ranges)?;
        Ok(self.signed_coefficient(&form, blade))
    }

    /// Returns the differentials of the ranges as a sorted basis form, with the sign of the
    /// permutation that sorts them.
    pub(super) fn blade_of(&self, ranges: &[Range]) -> Evaluated<(Blade, i8)> {
        let mut product = (Blade::SCALAR, 1);
        for range in ranges {
            let coordinate = self.coordinate(&range.name)?;
            product = match product.0.wedge(Blade::of(coordinate)) {
                Some((wedge, sign)) => (wedge, sign * product.1),
                None => return Err(Diagnostic::new(range.name.span, "this variable has a range already")),
            };
        }
        Ok(product)
    }

    pub(super) fn signed_coefficient(&mut self, form: &Form<Expr>, (blade, sign): (Blade, i8)) -> Expr {
        let zero = self.zero();
        let coefficient = form.coefficient(blade).copied().unwrap_or(zero);
        if sign < 0 { self.theory.pool.negate(coefficient) } else { coefficient }
    }

    /// Requires the chart domains whose coordinates all occur free in these expressions: those
    /// domains hold for every statement that uses the expressions.
    pub(super) fn require_domains(&mut self, written: &[Expr], bound: &[Symbol]) {
        let theory = &self.theory;
        let free: Vec<Symbol> =
            theory.pool.symbols_in(written).into_iter().filter(|symbol| !bound.contains(symbol)).collect();
        let is_free = |symbol: &Symbol| {
            theory.pool.symbol_kind(*symbol) != SymbolKind::Coordinate || free.contains(symbol)
        };
        let speaks_of = |condition: &&Condition| {
            let symbols = theory.pool.symbols_in(&[condition.left, condition.right]);
            symbols.iter().any(|symbol| free.contains(symbol)) && symbols.iter().all(is_free)
        };
        let conditions = theory.charts.iter().flat_map(|chart| &chart.conditions);
        let found: Vec<Condition> = conditions.filter(speaks_of).copied().collect();
        found.into_iter().for_each(|condition| self.scope.require(condition));
    }

    /// Returns the ranges with the assumptions on them: the conditions that do not involve the
    /// variables of the ranges, and that each variable lies in its range if the lower bound is
    /// known to be at most the upper.
    fn region(&mut self, integrand: Expr, defined: &[Condition], ranges: &[Range]) -> Region {
        let mut written = vec![integrand];
        written.extend(ranges.iter().flat_map(|range| [range.from, range.to]));
        let variables: Vec<Symbol> = ranges.iter().map(|range| range.symbol).collect();
        self.require_domains(&written, &variables);
        let outside = |condition: &&Condition| {
            let symbols = self.theory.pool.symbols_in(&[condition.left, condition.right]);
            !ranges.iter().any(|range| symbols.contains(&range.symbol))
        };
        let known = self.scope.conditions().iter().chain(&self.given).chain(defined);
        let mut conditions: Vec<Condition> = known.filter(outside).copied().collect();
        for range in ranges {
            if !is_at_most(&mut self.theory.pool, range.from, range.to, &conditions) {
                continue;
            }
            let variable = self.theory.pool.symbol(range.symbol);
            conditions.push(Condition {
                left: variable,
                relation: Relation::GreaterEqual,
                right: range.from,
            });
            conditions.push(Condition { left: variable, relation: Relation::LessEqual, right: range.to });
        }
        let ranges = ranges.iter().map(|range| (range.symbol, range.from, range.to)).collect();
        Region { ranges, conditions }
    }
}
