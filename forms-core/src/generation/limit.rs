//! Limits at removable singularities: expressions as series about a point, with exact leading
//! coefficients.
//!
//! ```text
//! expression, variable = value + ε ─▶ Σ cₖ εᵛ⁺ᵏ, coefficients known up to some order ─▶ the limit c at ε = 0
//! ```
//! Arithmetic acts on the coefficients; a function f of a series c₀ + δ is Σ f⁽ᵏ⁾(c₀) δᵏ/k!. The
//! conditions of each step are recorded: every derivative that was taken, and the next one, has to
//! be defined at c₀, and every coefficient that is a divisor must not vanish. A limit is accepted
//! only if these conditions are shown to hold on the whole seam.

use super::pieces::negated;
use crate::assume::vanishes;
use crate::decide::contradiction;
use crate::expression::{Condition, Expr, Node, Operation, Pool, Relation, Substitution, Symbol, SymbolKind};
use num_rational::Ratio;
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Number of coefficients computed; leading coefficients that cancel are lost.
const TERMS: usize = 8;

/// Σ cₖ ε^(order + k), up to a remainder O(ε^(order + number of coefficients)).
#[derive(Clone)]
struct Series {
    order: i64,
    coefficients: Vec<Expr>,
}

impl Series {
    /// Returns the order of the remainder.
    fn end(&self) -> i64 {
        self.order + self.coefficients.len() as i64
    }
}

/// Expansion of expressions in which a variable is a series.
struct Expansion<'a> {
    pool: &'a mut Pool,
    variable: Symbol,
    /// The variable itself as a series.
    argument: Series,
    /// Expressions that have to be defined.
    defined: Vec<Expr>,
    /// Expressions that must not be zero.
    divisors: Vec<Expr>,
    /// Whether this is the expansion of a derivative to be integrated, in which no other derivative
    /// is integrated.
    is_slope: bool,
}

/// Returns the limit of an expression without `if` as a variable tends to a value, if it is shown
/// to exist wherever the conditions hold.
pub(super) fn limit(
    pool: &mut Pool,
    expression: Expr,
    (variable, value): (Symbol, Expr),
    conditions: &[Condition],
) -> Option<Expr> {
    let mut coefficients = vec![pool.integer(0); TERMS];
    (coefficients[0], coefficients[1]) = (value, pool.integer(1));
    let argument = Series { order: 0, coefficients };
    let (defined, divisors) = (vec![value], Vec::new());
    let mut expansion = Expansion { pool, variable, argument, defined, divisors, is_slope: false };
    let series = expansion.series(expression)?;
    let series = expansion.without_poles(series)?;
    let limit = match series.order {
        0 => *series.coefficients.first()?,
        _ => expansion.pool.integer(0),
    };
    let Expansion { mut defined, divisors, .. } = expansion;
    defined.push(limit);
    defined.extend(&divisors);
    let zero = pool.integer(0);
    let mut required = pool.domain(&defined);
    let relation = Relation::NotEqual;
    required.extend(divisors.into_iter().map(|left| Condition { left, relation, right: zero }));
    follow(pool, &required, conditions).then_some(limit)
}

/// Whether conditions are shown to hold wherever others do.
pub(super) fn follow(pool: &mut Pool, conditions: &[Condition], known: &[Condition]) -> bool {
    conditions.iter().all(|condition| holds(pool, condition, known))
}

/// Whether a condition follows from others, because they contradict its opposite.
pub(super) fn holds(pool: &mut Pool, condition: &Condition, known: &[Condition]) -> bool {
    if let Some(decided) = condition.decided(pool) {
        return decided;
    }
    let opposite: Vec<Condition> = known.iter().copied().chain(negated(condition)).collect();
    known.contains(condition) || contradiction(pool, &opposite).is_some()
}

impl Expansion<'_> {
    fn series(&mut self, expression: Expr) -> Option<Series> {
        let mut known: FxHashMap<Expr, Series> = FxHashMap::default();
        for part in self.pool.reachable(&[expression]) {
            let series = self.of_node(part, &known)?;
            known.insert(part, series);
        }
        known.remove(&expression)
    }

    fn of_node(&mut self, part: Expr, known: &FxHashMap<Expr, Series>) -> Option<Series> {
        let zero = self.pool.integer(0);
        if !self.pool.symbols_in(&[part]).contains(&self.variable) {
            self.defined.push(part);
            let mut coefficients = vec![zero; TERMS];
            coefficients[0] = part;
            return Some(Series { order: 0, coefficients });
        }
        match self.pool.node(part).clone() {
            Node::Symbol(_) => Some(self.argument.clone()),
            Node::Add(a, b) => Some(self.sum(&known[&a], &known[&b])),
            Node::Negate(a) => Some(self.scaled(&known[&a], Ratio::from_integer(-1))),
            Node::Multiply(a, b) => Some(self.product(&known[&a], &known[&b])),
            Node::Divide(a, b) => {
                let inverse = self.power(&known[&b], Ratio::from_integer(-1))?;
                Some(self.product(&known[&a], &inverse))
            }
            Node::Power(a, exponent) if exponent.is_integer() && exponent.is_positive() => {
                self.repeated(&known[&a], u32::try_from(*exponent.numer()).ok()?)
            }
            Node::Power(a, exponent) => self.power(&known[&a], exponent),
            Node::Apply(Operation::Tan, arguments) => {
                // expanded as a quotient, which can have a pole
                let sine = self.composed(Operation::Sin, &known[&arguments[0]])?;
                let cosine = self.composed(Operation::Cos, &known[&arguments[0]])?;
                let inverse = self.power(&cosine, Ratio::from_integer(-1))?;
                Some(self.product(&sine, &inverse))
            }
            Node::Apply(operation, arguments) => match arguments[..] {
                [argument] => self.composed(operation, &known[&argument]),
                _ => None,
            },
            Node::Number(_) | Node::Pi | Node::Jet { .. } | Node::Select { .. } => None,
        }
    }

    /// Removes the negative powers of a series, if their coefficients are shown to vanish.
    fn without_poles(&mut self, mut series: Series) -> Option<Series> {
        while series.order < 0 {
            if !vanishes(self.pool, *series.coefficients.first()?) {
                return None;
            }
            series.coefficients.remove(0);
            series.order += 1;
        }
        Some(series)
    }

    /// Returns the coefficient of ε^power, which is 0 below the order of the series.
    fn coefficient(&mut self, series: &Series, power: i64) -> Expr {
        let place = usize::try_from(power - series.order).ok();
        let known = place.and_then(|place| series.coefficients.get(place)).copied();
        known.unwrap_or_else(|| self.pool.integer(0))
    }

    fn sum(&mut self, a: &Series, b: &Series) -> Series {
        let (order, end) = (a.order.min(b.order), a.end().min(b.end()));
        let coefficients = (order..end).map(|power| {
            let (left, right) = (self.coefficient(a, power), self.coefficient(b, power));
            self.pool.add(left, right)
        });
        Series { order, coefficients: coefficients.collect() }
    }

    fn scaled(&mut self, a: &Series, factor: Ratio<i64>) -> Series {
        let factor = self.pool.ratio(*factor.numer(), *factor.denom());
        let coefficients = a.coefficients.iter().map(|&c| self.pool.multiply(factor, c)).collect();
        Series { order: a.order, coefficients }
    }

    fn product(&mut self, a: &Series, b: &Series) -> Series {
        let count = a.coefficients.len().min(b.coefficients.len());
        let mut coefficients = Vec::with_capacity(count);
        for n in 0..count {
            let mut sum = self.pool.integer(0);
            for k in 0..=n {
                let term = self.pool.multiply(a.coefficients[k], b.coefficients[n - k]);
                sum = self.pool.add(sum, term);
            }
            coefficients.push(sum);
        }
        Series { order: a.order + b.order, coefficients }
    }

    fn repeated(&mut self, a: &Series, times: u32) -> Option<Series> {
        if times > TERMS as u32 * 4 {
            return None;
        }
        let mut power = a.clone();
        for _ in 1..times {
            power = self.product(&power, a);
        }
        Some(power)
    }

    /// (c ε^m (1 + δ))^r = c^r ε^(m r) Σ (r over k) δᵏ; a fraction r needs m = 0, where the base
    /// stays positive.
    fn power(&mut self, a: &Series, exponent: Ratio<i64>) -> Option<Series> {
        let mut a = a.clone();
        while vanishes(self.pool, *a.coefficients.first()?) {
            a.coefficients.remove(0);
            a.order += 1;
        }
        if !exponent.is_integer() && a.order != 0 {
            return None;
        }
        let leading = a.coefficients[0];
        self.divisors.push(leading);
        let outer = self.pool.power(leading, exponent);
        self.defined.push(outer);
        let mut rest: Vec<Expr> = a.coefficients.iter().map(|&c| self.pool.divide(c, leading)).collect();
        rest[0] = self.pool.integer(0);
        let mut binomials = Vec::with_capacity(rest.len());
        let mut binomial = Ratio::from_integer(1);
        for k in 0..rest.len() as i64 {
            let factor = self.pool.ratio(*binomial.numer(), *binomial.denom());
            binomials.push(self.pool.multiply(factor, outer));
            binomial = binomial * (exponent - Ratio::from_integer(k)) / Ratio::from_integer(k + 1);
        }
        let mut power = self.powers_of(&Series { order: 0, coefficients: rest }, &binomials);
        power.order += a.order * exponent.to_integer() * i64::from(exponent.is_integer());
        Some(power)
    }

    /// Expands f(c₀ + δ) = Σ f⁽ᵏ⁾(c₀) δᵏ/k!, or f(c₀) + ∫ f′(c₀ + δ) dδ if f′ as written has no
    /// value at c₀.
    fn composed(&mut self, operation: Operation, inner: &Series) -> Option<Series> {
        let inner = self.without_poles(inner.clone())?;
        let end = inner.end().min(TERMS as i64);
        let coefficients: Vec<Expr> = (0..end).map(|power| self.coefficient(&inner, power)).collect();
        let inner = Series { order: 0, coefficients };
        let placeholder = self.pool.declare_symbol("t", SymbolKind::Local);
        let at = self.pool.symbol(placeholder);
        let function = self.pool.apply(operation, &[at]);
        let derivatives = self.derivatives_at(function, placeholder, &inner)?;
        if !self.is_undefined(derivatives[0]) && self.is_undefined(*derivatives.get(1)?) {
            if self.is_slope {
                return None;
            }
            return self.integrated((function, derivatives[0]), placeholder, inner);
        }
        let (zero, mut factorial, mut taylor) = (self.pool.integer(0), 1_i64, Vec::new());
        for (k, &value) in derivatives.iter().take(inner.coefficients.len()).enumerate() {
            let factor = self.pool.ratio(1, factorial);
            taylor.push(self.pool.multiply(factor, value));
            factorial *= k as i64 + 1;
        }
        self.defined.extend(derivatives);
        let mut delta = inner;
        delta.coefficients[0] = zero;
        Some(self.powers_of(&delta, &taylor))
    }

    /// Returns the derivatives f⁽ᵏ⁾(c₀), up to the order of the remainder.
    fn derivatives_at(&mut self, function: Expr, variable: Symbol, inner: &Series) -> Option<Vec<Expr>> {
        let at: Substitution = [(variable, *inner.coefficients.first()?)].into_iter().collect();
        let (mut derivative, mut values) = (function, Vec::new());
        for _ in 0..=inner.coefficients.len() {
            values.push(self.pool.substitute(derivative, &at));
            derivative = self.pool.derivative(derivative, variable);
        }
        Some(values)
    }

    /// Whether an expression is undefined by a condition between numbers, such as 0/0.
    fn is_undefined(&mut self, expression: Expr) -> bool {
        let domain = self.pool.domain(&[expression]);
        domain.iter().any(|condition| condition.decided(self.pool) == Some(false))
    }

    /// f(c₀) + ∫ f′(c₀ + δ) δ′ dε
    fn integrated(
        &mut self,
        (function, value): (Expr, Expr),
        placeholder: Symbol,
        inner: Series,
    ) -> Option<Series> {
        let derivative = self.pool.derivative(function, placeholder);
        let speed: Vec<Expr> = (1..inner.coefficients.len())
            .map(|k| {
                let factor = self.pool.integer(k as i64);
                self.pool.multiply(factor, inner.coefficients[k])
            })
            .collect();
        let (defined, divisors) = (std::mem::take(&mut self.defined), std::mem::take(&mut self.divisors));
        let mut of_slope = Expansion {
            pool: self.pool,
            variable: placeholder,
            argument: inner,
            defined,
            divisors,
            is_slope: true,
        };
        let slope = of_slope.series(derivative);
        let Expansion { defined, divisors, .. } = of_slope;
        (self.defined, self.divisors) = (defined, divisors);
        self.defined.push(value);
        let slope = self.product(&slope?, &Series { order: 0, coefficients: speed });
        let slope = self.without_poles(slope)?;
        let mut coefficients = vec![value];
        for power in 0..slope.end() {
            let (coefficient, part) = (self.coefficient(&slope, power), self.pool.ratio(1, power + 1));
            coefficients.push(self.pool.multiply(part, coefficient));
        }
        Some(Series { order: 0, coefficients })
    }

    /// Σ aₖ δᵏ for a series δ without constant term.
    fn powers_of(&mut self, delta: &Series, coefficients: &[Expr]) -> Series {
        let zero = self.pool.integer(0);
        let count = delta.coefficients.len();
        let mut sum = Series { order: 0, coefficients: vec![zero; count] };
        for &coefficient in coefficients.iter().rev() {
            sum = self.product(&sum, delta);
            sum.coefficients[0] = self.pool.add(sum.coefficients[0], coefficient);
        }
        sum
    }
}
