//! Kernels, and the bodies that may have several values.
//!
//! ```text
//! kernel  = "kernel" name "(" { declared } ")" [ ":" values ] "=" values { where | effects }
//! values  = "(" sum "," … ")" | sum
//! effects = "effects" "{" name ":" name "=" sum { ";" … } "}"
//! ```

use super::cursor::{Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Effect, Expr, ItemKind};
use crate::syntax::token::{Symbol, TokenKind};

impl Parser<'_> {
    pub(super) fn kernel(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the kernel's name")?;
        let arguments = self.declared_list("an argument")?;
        let mut units = Vec::new();
        if self.at_annotation() {
            self.expect(Symbol::Colon)?;
            units = self.values()?;
        }
        self.assign()?;
        let outputs = self.values()?;
        let mut conditions = Vec::new();
        let mut effects = Vec::new();
        loop {
            let place = self.span();
            let repeated = if self.eat_word("where") {
                let repeated = !conditions.is_empty();
                self.more_conditions(&mut conditions)?;
                repeated.then_some("`where`")
            } else if self.eat_word("effects") {
                let repeated = !effects.is_empty();
                self.effects(&mut effects)?;
                repeated.then_some("`effects`")
            } else {
                return Ok(ItemKind::Kernel { name, arguments, units, outputs, conditions, effects });
            };
            if let Some(word) = repeated {
                self.report(Diagnostic::new(place, format!("a kernel has one {word}")));
            }
        }
    }

    /// One value, or several in round brackets.
    pub(super) fn values(&mut self) -> Parsed<Vec<Expr>> {
        if !self.at_list() {
            return Ok(vec![self.expression()?]);
        }
        let open = self.expect(Symbol::OpenParen)?;
        let mut values = vec![self.expression()?];
        while self.eat(Symbol::Comma).is_some() && !self.at(Symbol::CloseParen) {
            values.push(self.expression()?);
        }
        self.close(open, Symbol::CloseParen, "an operator, `,` or `)`")?;
        Ok(values)
    }

    /// Whether the next token opens a bracket that holds commas of its own: `((u + v)/2, v)`, not `(u + v)/2`.
    fn at_list(&self) -> bool {
        if !self.at(Symbol::OpenParen) {
            return false;
        }
        let mut depth = 0_usize;
        for (at, token) in self.tokens.iter().enumerate().skip(self.position) {
            match token.kind {
                TokenKind::Symbol(Symbol::Semicolon) => return false,
                TokenKind::Name(_) if self.starts_item(at) => return false,
                TokenKind::Symbol(Symbol::OpenParen | Symbol::OpenBracket | Symbol::OpenBrace) => depth += 1,
                TokenKind::Symbol(Symbol::CloseParen | Symbol::CloseBracket | Symbol::CloseBrace) => {
                    depth -= 1;
                }
                TokenKind::Symbol(Symbol::Comma) if depth == 1 => return true,
                _ => {}
            }
            if depth == 0 {
                return false;
            }
        }
        false
    }

    /// `{ absorption: sigma_a = 0; … }`
    fn effects(&mut self, effects: &mut Vec<Effect>) -> Parsed<()> {
        let open = self.expect(Symbol::OpenBrace)?;
        let mut expected = "the effect's name or `}`";
        while matches!(self.peek(), Some(TokenKind::Name(_))) && !self.starts_item(self.position) {
            let name = self.label("the effect's name")?;
            self.expect(Symbol::Colon)?;
            let variable = self.name("the variable that switches the effect off")?;
            self.assign()?;
            let value = self.expression()?;
            effects.push(Effect { name, variable, value });
            if self.eat(Symbol::Semicolon).is_none() {
                expected = "an operator, `;` or `}`";
                break;
            }
        }
        self.close(open, Symbol::CloseBrace, expected)?;
        Ok(())
    }
}
