//! Postfix expressions: calls and indices directly after a name or bracket, `f(a, b)`, `d[R3](w)`,
//! `bracket(X, Y)[x]`, `R[1, 2]`.
//!
//! ```text
//! postfix  = ( name [ index ] [ arguments ] | primary ) { index }
//! index    = "[" sum { "," sum } "]"
//! argument = name "=" sum ".." sum | sum
//! ```

use super::cursor::{Parsed, Parser};
use super::expressions::Tree;
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::{Argument, ExprKind, Name};
use crate::syntax::token::{Symbol, TokenKind};

impl Parser<'_> {
    pub(super) fn postfix(&mut self) -> Parsed<Tree> {
        let mut tree = match self.peek() {
            Some(TokenKind::Name(text)) if text != "if" => {
                let name = self.reference(text)?;
                self.named(name)?
            }
            _ => self.primary()?,
        };
        while self.at(Symbol::OpenBracket) {
            let index = self.index()?;
            tree = self.indexed(tree, index)?;
        }
        Ok(tree)
    }

    /// Parses an expression that begins with a name: a call if round brackets follow, with or
    /// without an index before them.
    fn named(&mut self, name: Name) -> Parsed<Tree> {
        let index = if self.at(Symbol::OpenBracket) { Some(self.index()?) } else { None };
        if self.at(Symbol::OpenParen) {
            let index = index.map(|index| self.single(index)).transpose()?;
            return self.call(name, index);
        }
        let span = name.span;
        let tree = self.tree(ExprKind::Name(name.text), span, 0)?;
        match index {
            Some(index) => self.indexed(tree, index),
            None => Ok(tree),
        }
    }

    fn indexed(&mut self, base: Tree, index: Vec<Tree>) -> Parsed<Tree> {
        let span = self.since(base.expr.span);
        let below = index.iter().fold(base.height, |below, index| below.max(index.height));
        let indices = index.into_iter().map(|index| index.expr).collect();
        self.tree(ExprKind::Index { base: base.expr, indices }, span, below)
    }

    /// Parses `[dx^dy]` or `[1, 2]`.
    fn index(&mut self) -> Parsed<Vec<Tree>> {
        let open = self.expect(Symbol::OpenBracket)?;
        let mut index = vec![self.sum()?];
        while self.eat(Symbol::Comma).is_some() && !self.at(Symbol::CloseBracket) {
            index.push(self.sum()?);
        }
        self.close_expression(open, Symbol::CloseBracket, "an operator, `,` or `]`")?;
        Ok(index)
    }

    /// Returns the only index, as in `d[R3](w)`.
    fn single(&mut self, index: Vec<Tree>) -> Parsed<Tree> {
        let mut rest = index.into_iter();
        match (rest.next(), rest.next()) {
            (Some(only), None) => Ok(only),
            (_, second) => {
                let span = second.map_or(self.span(), |second| second.expr.span);
                let message = "a function takes one name in square brackets, as in `d[R3](w)`";
                Err(self.report(Diagnostic::new(span, message)))
            }
        }
    }

    /// Parses `[a, b, c]`.
    pub(super) fn array(&mut self) -> Parsed<Tree> {
        let open = self.expect(Symbol::OpenBracket)?;
        let mut entries = vec![self.sum()?];
        while self.eat(Symbol::Comma).is_some() && !self.at(Symbol::CloseBracket) {
            entries.push(self.sum()?);
        }
        let below = entries.iter().map(|entry| entry.height).max().unwrap_or(0);
        let entries = entries.into_iter().map(|entry| entry.expr).collect();
        let close = self.close_expression(open, Symbol::CloseBracket, "an operator, `,` or `]`")?;
        self.tree(ExprKind::Array(entries), open.to(close), below)
    }

    fn call(&mut self, function: Name, index: Option<Tree>) -> Parsed<Tree> {
        let open = self.expect(Symbol::OpenParen)?;
        let mut below = index.as_ref().map_or(0, |index| index.height);
        let mut arguments = Vec::new();
        while !self.at(Symbol::CloseParen) {
            let (argument, height) = self.argument()?;
            below = below.max(height);
            arguments.push(argument);
            if self.eat(Symbol::Comma).is_none() {
                break;
            }
        }
        self.close_arguments(open)?;
        let span = self.since(function.span);
        let index = index.map(|index| index.expr);
        self.tree(ExprKind::Call { function, index, arguments }, span, below)
    }

    fn close_arguments(&mut self, open: Span) -> Parsed<Span> {
        if self.at(Symbol::Range) || self.at(Symbol::Equal) {
            return Err(self.unexpected("an operator, `,` or `)`", Some("a range is written `x = 0..1`")));
        }
        self.close_expression(open, Symbol::CloseParen, "an operator, `,` or `)`")
    }

    /// Parses one argument; returns it with its height.
    fn argument(&mut self) -> Parsed<(Argument, usize)> {
        if self.peek_at(1) != Some(&TokenKind::Symbol(Symbol::Assign)) {
            let Tree { expr, height } = self.sum()?;
            return Ok((Argument::Value(expr), height));
        }
        let variable = self.name("a variable before `=`")?;
        self.expect(Symbol::Assign)?;
        let from = self.sum()?;
        if self.eat(Symbol::Range).is_none() {
            return Err(self.unexpected("`..`", Some("a range is written `x = 0..1`")));
        }
        let to = self.sum()?;
        let height = from.height.max(to.height);
        Ok((Argument::Range { variable, from: from.expr, to: to.expr }, height))
    }
}
