//! Conditions, and the constructs that contain them: `where 0 < theta < pi, n > 0` and `if u > 0 {
//! u } else { 0 }`.
//!
//! ```text
//! where     = [ "where" condition { "," condition } ]
//! condition = sum relation sum { relation sum }
//! select    = "if" [ "jump" ] condition block "else" ( select | block )
//! ```

use super::cursor::{Parsed, Parser};
use super::expressions::Tree;
use crate::diagnostic::Diagnostic;
use crate::expression::Relation;
use crate::syntax::ast::{Condition, ExprKind};
use crate::syntax::token::{Symbol, TokenKind};

impl Parser<'_> {
    /// Parses the conditions of a `where`; empty if there is none.
    pub(super) fn conditions(&mut self) -> Parsed<Vec<Condition>> {
        let mut conditions = Vec::new();
        if self.eat_word("where") {
            self.more_conditions(&mut conditions)?;
        }
        Ok(conditions)
    }

    /// Parses the conditions after a `where`.
    pub(super) fn more_conditions(&mut self, conditions: &mut Vec<Condition>) -> Parsed<()> {
        loop {
            conditions.push(self.condition()?.0);
            if self.at_word("and") {
                let diagnostic = Diagnostic::new(self.span(), "expected `,` between conditions, found `and`");
                self.report(diagnostic.with_help("separate conditions with `,`"));
                self.position += 1;
            } else if self.at_word("or") {
                let help = "conditions all hold at once; state alternatives separately";
                return Err(self.unexpected("`,` or `;` after the condition", Some(help)));
            } else if self.eat(Symbol::Comma).is_none() {
                return Ok(());
            }
        }
    }

    /// Parses one condition; returns it with the height of its highest side.
    fn condition(&mut self) -> Parsed<(Condition, usize)> {
        let Tree { expr: first, mut height } = self.sum()?;
        let mut rest = Vec::new();
        while let Some(relation) = self.relation() {
            self.position += 1;
            let side = self.sum()?;
            height = height.max(side.height);
            rest.push((relation, side.expr));
        }
        if rest.is_empty() || self.at(Symbol::Equal) || self.at(Symbol::Assign) {
            return Err(self.missing_relation());
        }
        let span = self.since(first.span);
        Ok((Condition { first, rest, span }, height))
    }

    fn missing_relation(&mut self) -> super::cursor::Reported {
        let help = match self.peek() {
            Some(TokenKind::Symbol(Symbol::Equal | Symbol::Assign)) => {
                Some("an equation is not a condition; put the value in its place")
            }
            _ if self.looks_like_factor() => Some("write `*` between factors"),
            _ => None,
        };
        self.unexpected("`<`, `<=`, `>`, `>=` or `!=`", help)
    }

    fn relation(&self) -> Option<Relation> {
        match self.peek()? {
            TokenKind::Symbol(Symbol::Less) => Some(Relation::Less),
            TokenKind::Symbol(Symbol::LessEqual) => Some(Relation::LessEqual),
            TokenKind::Symbol(Symbol::Greater) => Some(Relation::Greater),
            TokenKind::Symbol(Symbol::GreaterEqual) => Some(Relation::GreaterEqual),
            TokenKind::Symbol(Symbol::NotEqual) => Some(Relation::NotEqual),
            _ => None,
        }
    }

    /// Parses `if condition { then } else { otherwise }`.
    pub(super) fn select(&mut self) -> Parsed<Tree> {
        self.enter()?;
        let start = self.span();
        self.eat_word("if");
        let jump = self.eat_word("jump");
        let (condition, height) = self.condition()?;
        let then = self.block("`{` after the condition")?;
        if !self.eat_word("else") {
            return Err(self.unexpected("`else`", Some("a piecewise expression has a value everywhere")));
        }
        let otherwise =
            if self.at_word("if") { self.select()? } else { self.block("`{` or `if` after `else`")? };
        self.nesting -= 1;
        let span = self.since(start);
        let below = height.max(then.height).max(otherwise.height);
        let kind = ExprKind::Select { condition, then: then.expr, otherwise: otherwise.expr, jump };
        self.tree(kind, span, below)
    }

    /// Parses `{ value }`.
    fn block(&mut self, expected: &str) -> Parsed<Tree> {
        if !self.at(Symbol::OpenBrace) {
            let help = (self.at(Symbol::Comma) || self.at_word("and"))
                .then_some("an `if` takes one condition; put a second `if` inside");
            return Err(self.unexpected(expected, help));
        }
        let open = self.expect(Symbol::OpenBrace)?;
        let value = self.sum()?;
        self.close_expression(open, Symbol::CloseBrace, "an operator or `}`")?;
        Ok(value)
    }
}
