//! Declared variables: `(x: m, y: m)`, and the arguments of a kernel, which can be arrays:
//! `(p[3]: m, R[3, 3])`.
//!
//! ```text
//! declared = name [ ":" sum ]
//! argument = name [ "[" number [ "," number ] "]" ] [ ":" sum ]
//! ```

use super::cursor::{Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::syntax::ast::Declared;
use crate::syntax::number;
use crate::syntax::token::{Symbol, TokenKind};
use num_traits::ToPrimitive;

/// Largest number of entries of an array.
const MOST_ENTRIES: usize = 256;

impl Parser<'_> {
    /// Parses `(x: m, y: m)`.
    pub(super) fn declared_list(&mut self, role: &str) -> Parsed<Vec<Declared>> {
        self.list_of(|parser| parser.declared(role))
    }

    /// Parses `(p[3]: m, R[3, 3], t: s)`.
    pub(super) fn kernel_arguments(&mut self) -> Parsed<Vec<Declared>> {
        self.list_of(|parser| {
            let name = parser.quantity("an argument")?;
            let extents = if parser.at(Symbol::OpenBracket) { parser.extents()? } else { Vec::new() };
            let unit = parser.unit()?;
            Ok(Declared { name, extents, unit })
        })
    }

    fn list_of(&mut self, one: impl Fn(&mut Self) -> Parsed<Declared>) -> Parsed<Vec<Declared>> {
        let open = self.expect(Symbol::OpenParen)?;
        let mut list = Vec::new();
        while !self.at(Symbol::CloseParen) {
            list.push(one(self)?);
            if self.eat(Symbol::Comma).is_none() {
                break;
            }
        }
        self.close(open, Symbol::CloseParen, "`,` or `)`")?;
        Ok(list)
    }

    /// Parses `x` or `x: m`.
    pub(super) fn declared(&mut self, role: &str) -> Parsed<Declared> {
        let name = self.quantity(role)?;
        if self.at(Symbol::OpenBracket) {
            let message = "only an argument of a kernel can be an array";
            return Err(self.report(Diagnostic::new(self.span(), message)));
        }
        let unit = self.unit()?;
        Ok(Declared { name, extents: Vec::new(), unit })
    }

    /// Parses `[3]` or `[3, 3]`.
    fn extents(&mut self) -> Parsed<Vec<usize>> {
        let open = self.expect(Symbol::OpenBracket)?;
        let mut extents = vec![self.extent()?];
        if self.eat(Symbol::Comma).is_some() {
            extents.push(self.extent()?);
        }
        let close = self.close(open, Symbol::CloseBracket, "`]`")?;
        if extents.iter().product::<usize>() > MOST_ENTRIES {
            let message = format!("an array has at most {MOST_ENTRIES} entries");
            return Err(self.report(Diagnostic::new(open.to(close), message)));
        }
        Ok(extents)
    }

    fn extent(&mut self) -> Parsed<usize> {
        let known = match self.peek() {
            Some(TokenKind::Number(text)) => number::value(text).ok().filter(|value| value.is_integer()),
            _ => None,
        };
        // a larger number is reported with the array
        let extent = known.and_then(|value| value.to_usize()).filter(|&extent| extent > 0);
        let Some(extent) = extent else {
            return Err(
                self.unexpected("the number of entries", Some("an array is written `p[3]` or `R[3, 3]`"))
            );
        };
        self.position += 1;
        Ok(extent.min(MOST_ENTRIES + 1))
    }
}
