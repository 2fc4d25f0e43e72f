//! Claims of a warp as statements: its density is the density of its map, and its inverse is the
//! inverse of the map.
//!
//! The generated parts have empty spans next to the source from which they are made, each part at a
//! place of its own.

use super::ast::{Argument, Binary, Claim, Condition, Expr, ExprKind, Item, ItemKind, Name, Warp};
use crate::diagnostic::Span;
use crate::expression::Relation;
use num_rational::BigRational;

impl Warp {
    /// Returns the claims `NAME_density: pullback(NAME, density*form) == du^dv`, or `-du^dv` for a
    /// map that reverses the orientation, and `NAME_inverse` if there is an inverse.
    pub fn claims(&self, item: &Item, reverses: bool) -> Vec<Item> {
        let mut claims = vec![self.density_claim(item, reverses)];
        claims.extend(self.inverse_claim(item));
        claims
    }

    /// Returns `pullback(NAME, density*form)`.
    pub(crate) fn density_on_the_square(&self) -> Expr {
        let span = self.density.span;
        let product = binary(Binary::Multiply, self.density.clone(), self.form.clone(), before(span));
        self.pulled_back(product, behind(span))
    }

    fn density_claim(&self, item: &Item, reverses: bool) -> Item {
        let differential = |uniform: &Name| name(&format!("d{}", uniform.text), before(uniform.span));
        let area = self.joined(Binary::Wedge, self.name.span, differential);
        let right = if reverses {
            Expr { kind: Box::new(ExprKind::Negate(area)), span: before(self.name.span) }
        } else {
            area
        };
        let docs = format!(
            "The density of `{}` is the density of its map, which {} the orientation.",
            self.name.text,
            if reverses { "reverses" } else { "preserves" }
        );
        self.statement(item, "density", docs, self.density_on_the_square(), right)
    }

    /// Returns the claim `pullback(NAME, a)*@u + pullback(NAME, b)*@v == u*@u + v*@v`, which
    /// contains one equation for each uniform random number.
    fn inverse_claim(&self, item: &Item) -> Option<Item> {
        if self.inverse.is_empty() {
            return None;
        }
        let along = |value: Expr, uniform: &Name, span: Span| {
            let basis = Expr { kind: Box::new(ExprKind::Basis(uniform.clone())), span: before(uniform.span) };
            binary(Binary::Multiply, value, basis, before(span))
        };
        let mut values = self.inverse.iter();
        let left = self.joined(Binary::Add, self.target.span, |uniform| {
            let own = || name(&uniform.text, before(uniform.span));
            let value = values.next().cloned().unwrap_or_else(own);
            let span = value.span;
            along(self.pulled_back(value, behind(span)), uniform, span)
        });
        let right = self.joined(Binary::Add, self.name.span, |uniform| {
            along(name(&uniform.text, before(uniform.span)), uniform, uniform.span)
        });
        let docs = format!("The inverse of `{}` returns the uniform random numbers.", self.name.text);
        Some(self.statement(item, "inverse", docs, left, right))
    }

    /// Returns the domain of the uniform random numbers, `0 < u < 1` for each, followed by the
    /// warp's own conditions.
    pub(crate) fn all_conditions(&self) -> Vec<Condition> {
        let inside = self.uniforms.iter().map(|uniform| {
            let span = before(uniform.name.span);
            let variable = name(&uniform.name.text, span);
            let rest = vec![(Relation::Less, variable), (Relation::Less, number(1, span))];
            Condition { first: number(0, span), rest, span }
        });
        inside.chain(self.conditions.iter().cloned()).collect()
    }

    fn statement(&self, item: &Item, part: &str, docs: String, left: Expr, right: Expr) -> Item {
        let name = self.part(part);
        let conditions = self.all_conditions();
        let kind = ItemKind::Statement { claim: Claim::Prove, name, left, right, conditions };
        Item { docs: vec![docs], public: false, span: item.span, kind }
    }

    /// Returns the name `NAME_part`.
    pub(crate) fn part(&self, part: &str) -> Name {
        Name { text: format!("{}_{part}", self.name.text), span: self.name.span }
    }

    fn pulled_back(&self, value: Expr, span: Span) -> Expr {
        let map = Argument::Value(name(&self.name.text, before(self.name.span)));
        let function = Name { text: "pullback".to_owned(), span: self.name.span };
        let arguments = vec![map, Argument::Value(value)];
        Expr { kind: Box::new(ExprKind::Call { function, index: None, arguments }), span }
    }

    /// Makes an expression for each uniform random number and joins them by an operator.
    fn joined(&self, operator: Binary, place: Span, mut part: impl FnMut(&Name) -> Expr) -> Expr {
        let parts: Vec<Expr> = self.uniforms.iter().map(|uniform| part(&uniform.name)).collect();
        let joined = parts.into_iter().reduce(|all, next| binary(operator, all, next, behind(place)));
        joined.unwrap_or_else(|| number(1, before(place)))
    }
}

/// Returns the empty span directly before a span.
fn before(span: Span) -> Span {
    Span::new(span.start, span.start)
}

/// Returns the empty span directly after a span.
fn behind(span: Span) -> Span {
    Span::new(span.end, span.end)
}

fn name(text: &str, span: Span) -> Expr {
    Expr { kind: Box::new(ExprKind::Name(text.to_owned())), span }
}

fn number(value: i64, span: Span) -> Expr {
    Expr { kind: Box::new(ExprKind::Number(BigRational::from_integer(value.into()))), span }
}

fn binary(operator: Binary, left: Expr, right: Expr, span: Span) -> Expr {
    Expr { kind: Box::new(ExprKind::Binary(operator, span, left, right)), span }
}
