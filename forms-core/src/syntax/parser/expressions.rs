//! Expressions by precedence, from tightest to loosest: `**` · unary `-` · `*` `/` `^` · `+` `-`.
//!
//! ```text
//! sum     = product { ("+" | "-") product }
//! product = unary { ("*" | "/" | "^") unary }
//! unary   = "-" unary | power
//! power   = postfix [ "**" unary ]
//! ```
//! Every tree is built together with its height, so that no tree becomes higher than
//! [`MAXIMUM_DEPTH`].

use super::cursor::{Parsed, Parser};
use super::{MAXIMUM_DEPTH, MAXIMUM_NESTING};
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::{Binary, Expr, ExprKind, Name};
use crate::syntax::number;
use crate::syntax::token::{Symbol, TokenKind};
use crate::syntax::words::{FUNCTIONS, Word};

/// Expression with the height of its tree, 1 for a leaf.
pub(super) struct Tree {
    pub(super) expr: Expr,
    pub(super) height: usize,
}

const SUM: &[(Symbol, Binary)] = &[(Symbol::Plus, Binary::Add), (Symbol::Minus, Binary::Subtract)];
const PRODUCT: &[(Symbol, Binary)] =
    &[(Symbol::Star, Binary::Multiply), (Symbol::Slash, Binary::Divide), (Symbol::Wedge, Binary::Wedge)];

impl Parser<'_> {
    /// Parses one expression.
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        Ok(self.sum()?.expr)
    }

    pub(super) fn sum(&mut self) -> Parsed<Tree> {
        self.chain(SUM, Self::product)
    }

    fn product(&mut self) -> Parsed<Tree> {
        self.chain(PRODUCT, Self::unary)
    }

    /// Parses a left-associative chain: `a ∘ b ∘ c` is `(a ∘ b) ∘ c`.
    fn chain(
        &mut self,
        operators: &[(Symbol, Binary)],
        operand: fn(&mut Self) -> Parsed<Tree>,
    ) -> Parsed<Tree> {
        let mut left = operand(self)?;
        while let Some(&TokenKind::Symbol(next)) = self.peek()
            && let Some(&(symbol, operation)) = operators.iter().find(|(symbol, _)| *symbol == next)
        {
            let place = self.expect(symbol)?;
            let right = operand(self)?;
            if operation == Binary::Wedge {
                self.warn_of_power(place, &left.expr, &right.expr);
            }
            left = self.binary(operation, place, left, right)?;
        }
        Ok(left)
    }

    /// Parses a signed expression: `-x**2` is `-(x**2)`, and `-a*b` is `(-a)*b`.
    fn unary(&mut self) -> Parsed<Tree> {
        self.enter()?;
        let tree = match self.eat(Symbol::Minus) {
            Some(minus) => {
                let Tree { expr, height } = self.unary()?;
                let span = minus.to(expr.span);
                self.tree(ExprKind::Negate(expr), span, height)?
            }
            None => self.power()?,
        };
        self.nesting -= 1;
        Ok(tree)
    }

    /// Parses a right-associative power: `a**b**c` is `a**(b**c)`, and `x**-2` is allowed.
    fn power(&mut self) -> Parsed<Tree> {
        let base = self.postfix()?;
        match self.eat(Symbol::Power) {
            None => Ok(base),
            Some(place) => {
                let exponent = self.unary()?;
                self.binary(Binary::Power, place, base, exponent)
            }
        }
    }

    /// Parses a primary expression other than a name: a number, a bracket, `@x` or `if`.
    pub(super) fn primary(&mut self) -> Parsed<Tree> {
        let span = self.span();
        match self.peek() {
            Some(TokenKind::Number(text)) => self.number(text),
            Some(TokenKind::Symbol(Symbol::OpenParen)) => self.parenthesised(),
            Some(TokenKind::Symbol(Symbol::OpenBracket)) => self.array(),
            Some(TokenKind::Symbol(Symbol::At)) => {
                self.position += 1;
                let name = self.name("a coordinate after `@`")?;
                let span = span.to(name.span);
                self.tree(ExprKind::Basis(name), span, 0)
            }
            Some(TokenKind::Name(text)) if text == "if" => self.select(),
            Some(TokenKind::Symbol(Symbol::Star)) if self.follows_star() => {
                Err(self.unexpected("an expression", Some("a power is written `**`, without a space")))
            }
            Some(TokenKind::Symbol(Symbol::OpenBrace)) => {
                Err(self.unexpected("an expression", Some("what several kernels use is a `let` above them")))
            }
            _ => Err(self.unexpected("an expression", None)),
        }
    }

    /// Whether the previous token is `*`: two separate stars are not a power.
    fn follows_star(&self) -> bool {
        let before = self.position.checked_sub(1).map(|before| &self.tokens[before].kind);
        before == Some(&TokenKind::Symbol(Symbol::Star))
    }

    fn number(&mut self, text: &str) -> Parsed<Tree> {
        let span = self.span();
        self.position += 1;
        match number::value(text) {
            Ok(value) => self.tree(ExprKind::Number(value), span, 0),
            Err(malformed) => {
                let mut diagnostic = Diagnostic::new(span, malformed.message);
                diagnostic.help = malformed.help;
                Err(self.report(diagnostic))
            }
        }
    }

    fn parenthesised(&mut self) -> Parsed<Tree> {
        let open = self.expect(Symbol::OpenParen)?;
        let mut tree = self.sum()?;
        if self.at(Symbol::Comma) {
            let help = "several values can only be the whole of a kernel or map";
            return Err(self.unexpected("`)`", Some(help)));
        }
        let close = self.close_expression(open, Symbol::CloseParen, "an operator or `)`")?;
        tree.expr.span = open.to(close);
        Ok(tree)
    }

    /// Takes a name that refers to a value or a function.
    pub(super) fn reference(&mut self, text: &str) -> Parsed<Name> {
        let span = self.span();
        match self.reserved(text) {
            Some(Word::Item) => Err(self.unexpected("an expression", None)),
            Some(Word::Rust) => {
                let help = format!("`{text}` is a Rust keyword and cannot be a name");
                Err(self.unexpected("an expression", Some(&help)))
            }
            Some(Word::Function) | None => {
                self.position += 1;
                Ok(Name { text: text.to_owned(), span })
            }
        }
    }

    /// Reports `x^2`, which is almost always meant as a power.
    fn warn_of_power(&mut self, place: Span, left: &Expr, right: &Expr) {
        let TokenKind::Number(digits) = &self.tokens[self.position - 1].kind else {
            return;
        };
        let sign = match &*right.kind {
            ExprKind::Number(_) => "",
            ExprKind::Negate(inner) if matches!(*inner.kind, ExprKind::Number(_)) => "-",
            _ => return,
        };
        let base = match &*left.kind {
            ExprKind::Name(name) if FUNCTIONS.contains(&name.as_str()) => format!("{name}(…)"),
            ExprKind::Name(name) => name.clone(),
            _ => "…".to_owned(),
        };
        let message = "`^` is the wedge product, but its right operand is a number";
        let help = format!("use `**` for powers: `{base}**{sign}{digits}`");
        self.report(Diagnostic::new(place, message).with_help(help));
    }

    fn binary(&mut self, operation: Binary, place: Span, left: Tree, right: Tree) -> Parsed<Tree> {
        let span = left.expr.span.to(right.expr.span);
        let height = left.height.max(right.height);
        self.tree_at(place, ExprKind::Binary(operation, place, left.expr, right.expr), span, height)
    }

    /// Builds a tree whose highest part has the height `below`.
    pub(super) fn tree(&mut self, kind: ExprKind, span: Span, below: usize) -> Parsed<Tree> {
        self.tree_at(span, kind, span, below)
    }

    /// Builds a tree, and reports it at `place` if it is too high.
    fn tree_at(&mut self, place: Span, kind: ExprKind, span: Span, below: usize) -> Parsed<Tree> {
        if below >= MAXIMUM_DEPTH {
            let message = format!("the expression is nested more than {MAXIMUM_DEPTH} operations deep");
            let help = "name a subexpression with `let`, or group long sums with brackets";
            return Err(self.report(Diagnostic::new(place, message).with_help(help)));
        }
        Ok(Tree { expr: Expr { kind: Box::new(kind), span }, height: below + 1 })
    }

    /// Enters one more level of nesting; an error at the maximum.
    pub(super) fn enter(&mut self) -> Parsed<()> {
        if self.nesting == MAXIMUM_NESTING {
            let message = format!("the expression is nested more than {MAXIMUM_NESTING} levels deep");
            let diagnostic = Diagnostic::new(self.span(), message).with_help("name an inner part with `let`");
            return Err(self.report(diagnostic));
        }
        self.nesting += 1;
        Ok(())
    }
}
