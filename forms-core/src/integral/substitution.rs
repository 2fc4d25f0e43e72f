//! Substitutions: ∫ h(g(x)) g′(x) dx = H(g(x)), with g a cosine, sine, exponential or square that
//! occurs.

use super::range::is_antiderivative;
use super::search::{Integrand, Search};
use super::{Failure, normal_form};
use crate::expression::{Condition, Expr, Node, Operation, Relation, Substitution, Symbol, SymbolKind};
use crate::normal::{Generator, Tower, Trigonometry};
use crate::polynomial::Polynomial;
use rustc_hash::FxHashMap;

impl Search<'_> {
    /// Returns an antiderivative by the first substitution that removes the variable and leads to
    /// an antiderivative.
    pub(super) fn by_substitution(
        &mut self,
        integrand: &mut Integrand,
        depth: u32,
    ) -> Result<Option<Expr>, Failure> {
        for generator in integrand.generators.clone() {
            let kind = integrand.tower.generator(generator).clone();
            let itself = Polynomial::variable(generator).into();
            let inner = match kind {
                Generator::Cosine(_) | Generator::Sine(_) | Generator::Exponential(_) => {
                    integrand.tower.raise(self.pool, &itself)
                }
                _ => continue,
            };
            if let Some(found) = self.substituted(integrand, inner, &kind, depth)
                && self.is_right(found, integrand)
            {
                return Ok(Some(found));
            }
        }
        let found = self.through_square(integrand, depth);
        Ok(found.filter(|&found| self.is_right(found, integrand)))
    }

    /// Whether the derivative is the integrand; a substitution may have lost a sign.
    fn is_right(&mut self, found: Expr, integrand: &Integrand) -> bool {
        let Integrand { expression, symbol, conditions, .. } = *integrand;
        is_antiderivative(self.pool, found, expression, symbol, conditions) == Ok(true)
    }

    /// ∫ f dx with y = g(x): f/g′ must be a function of y.
    fn substituted(
        &mut self,
        integrand: &mut Integrand,
        inner: Expr,
        kind: &Generator,
        depth: u32,
    ) -> Option<Expr> {
        let derivative = self.pool.derivative(inner, integrand.symbol);
        let quotient = self.pool.divide(integrand.expression, derivative);
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let images = self.images(integrand, inner, kind, y);
        let outer = self.in_terms_of(quotient, integrand, &images)?;
        let mut conditions = self.bounds_of(kind, y);
        for condition in integrand.conditions {
            let difference = self.pool.subtract(condition.left, condition.right);
            if let Some(left) = self.in_terms_of(difference, integrand, &images) {
                let right = self.pool.integer(0);
                conditions.push(Condition { left, relation: condition.relation, right });
            }
        }
        let found = self.antiderivative(outer, y, &conditions, depth).ok()?;
        let values: Substitution = [(y, inner)].into_iter().collect();
        Some(self.pool.substitute(found, &values))
    }

    /// Returns the replacements of g and, if g is a sine, of the cosine of the same angle.
    fn images(
        &mut self,
        integrand: &mut Integrand,
        inner: Expr,
        kind: &Generator,
        y: Symbol,
    ) -> FxHashMap<Expr, Expr> {
        let value = self.pool.symbol(y);
        let mut images: FxHashMap<Expr, Expr> = [(inner, value)].into_iter().collect();
        if let Generator::Sine(unit) = kind {
            let cosine = integrand.tower.element(Generator::Cosine(unit.clone()));
            let cosine = integrand.tower.raise(self.pool, &cosine);
            let square = self.pool.power(value, 2.into());
            let one = self.pool.integer(1);
            let rest = self.pool.subtract(one, square);
            images.insert(cosine, self.pool.sqrt(rest));
        }
        images
    }

    /// Returns the expression in normal form with the images substituted, if that frees it from the
    /// variable.
    fn in_terms_of(
        &mut self,
        expression: Expr,
        integrand: &Integrand,
        images: &FxHashMap<Expr, Expr>,
    ) -> Option<Expr> {
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(self.pool, &mut tower, expression, integrand.conditions).ok()?;
        let raised = tower.raise(self.pool, &normal);
        let replaced = self.pool.replace(raised, images);
        (!self.pool.symbols_in(&[replaced]).contains(&integrand.symbol)).then_some(replaced)
    }

    fn bounds_of(&mut self, kind: &Generator, y: Symbol) -> Vec<Condition> {
        let left = self.pool.symbol(y);
        let bounds: &[(Relation, i64)] = match kind {
            Generator::Exponential(_) => &[(Relation::Greater, 0)],
            _ => &[(Relation::GreaterEqual, -1), (Relation::LessEqual, 1)],
        };
        bounds
            .iter()
            .map(|&(relation, bound)| Condition { left, relation, right: self.pool.integer(bound) })
            .collect()
    }

    /// Substitutes y = cos u or sin u in an expression as it is written, with √(1 − y²) for the
    /// other function, for roots of sines and cosines.
    pub(super) fn through_circle(
        &mut self,
        expression: Expr,
        symbol: Symbol,
        conditions: &[Condition],
        depth: u32,
    ) -> Option<Expr> {
        let angles: Vec<Expr> = self
            .pool
            .reachable(&[expression])
            .into_iter()
            .filter_map(|part| match self.pool.node(part) {
                Node::Apply(Operation::Sin | Operation::Cos, q) => Some(q[0]),
                _ => None,
            })
            .filter(|angle| self.pool.symbols_in(&[*angle]).contains(&symbol))
            .collect();
        let angle = *angles.first()?;
        let pairs = [(Operation::Cos, Operation::Sin), (Operation::Sin, Operation::Cos)];
        pairs.into_iter().find_map(|functions| {
            let found = self.with_cofunction(expression, symbol, conditions, (angle, functions), depth)?;
            let is_right = is_antiderivative(self.pool, found, expression, symbol, conditions);
            (is_right == Ok(true)).then_some(found)
        })
    }

    /// Substitutes y = f(u), with the cofunction √(1 − y²), where one of the two is the sine and
    /// the other the cosine.
    fn with_cofunction(
        &mut self,
        expression: Expr,
        symbol: Symbol,
        conditions: &[Condition],
        (angle, (function, cofunction)): (Expr, (Operation, Operation)),
        depth: u32,
    ) -> Option<Expr> {
        let inner = self.pool.apply(function, &[angle]);
        let cofunction = self.pool.apply(cofunction, &[angle]);
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let value = self.pool.symbol(y);
        let square = self.pool.power(value, 2.into());
        let one = self.pool.integer(1);
        let rest = self.pool.subtract(one, square);
        let images: FxHashMap<Expr, Expr> =
            [(inner, value), (cofunction, self.pool.sqrt(rest))].into_iter().collect();
        let derivative = self.pool.derivative(inner, symbol);
        let quotient = self.pool.divide(expression, derivative);
        let outer = self.pool.replace(quotient, &images);
        if self.pool.symbols_in(&[outer]).contains(&symbol) {
            return None;
        }
        let minus_one = self.pool.integer(-1);
        let mut known = vec![
            Condition { left: value, relation: Relation::Greater, right: minus_one },
            Condition { left: value, relation: Relation::Less, right: one },
        ];
        for condition in conditions {
            let sides = [condition.left, condition.right].map(|side| self.pool.replace(side, &images));
            if !self.pool.symbols_in(&sides).contains(&symbol) {
                known.push(Condition { left: sides[0], relation: condition.relation, right: sides[1] });
            }
        }
        let found = self.antiderivative(outer, y, &known, depth).ok()?;
        let values: Substitution = [(y, inner)].into_iter().collect();
        Some(self.pool.substitute(found, &values))
    }

    /// Substitutes y = x²: f/2x must be even. The case x > 0 is examined, which decides the case x
    /// < 0.
    fn through_square(&mut self, integrand: &mut Integrand, depth: u32) -> Option<Expr> {
        let x = self.pool.symbol(integrand.symbol);
        let y = self.pool.declare_symbol("y", SymbolKind::Local);
        let value = self.pool.symbol(y);
        let root = self.pool.sqrt(value);
        let twice = self.pool.add(x, x);
        let quotient = self.pool.divide(integrand.expression, twice);
        let values: Substitution = [(integrand.symbol, root)].into_iter().collect();
        let composed = self.pool.substitute(quotient, &values);
        let zero = self.pool.integer(0);
        let mut conditions = vec![Condition { left: value, relation: Relation::Greater, right: zero }];
        for condition in integrand.conditions {
            conditions.push(condition.substitute(self.pool, &values));
        }
        let mut tower = Tower::new(Trigonometry::Circle);
        let normal = normal_form(self.pool, &mut tower, composed, &conditions).ok()?;
        let number = tower.variable_number(y);
        let root_remains = tower.generators_in(&normal, y).into_iter().any(|generator| {
            tower.radicand(generator).is_some_and(|(radicand, _)| radicand == Polynomial::variable(number))
        });
        if root_remains {
            return None;
        }
        let outer = tower.raise(self.pool, &normal);
        let found = self.antiderivative(outer, y, &conditions, depth).ok()?;
        let square = self.pool.power(x, 2.into());
        let values: Substitution = [(y, square)].into_iter().collect();
        Some(self.pool.substitute(found, &values))
    }
}
