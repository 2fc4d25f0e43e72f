//! Items: a keyword, a declaration or claim, and a `;`.

use super::cursor::{Parsed, Parser, Reported};
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::ast::{Claim, Equation, Expr, File, Item, ItemKind, Name};
use crate::syntax::number;
use crate::syntax::token::{Symbol, TokenKind};
use num_traits::ToPrimitive;

impl Parser<'_> {
    /// Parses all items up to the end.
    pub(super) fn file(&mut self) -> File {
        let mut items = Vec::new();
        while !self.at_end() {
            self.nesting = 0;
            let docs = self.docs();
            let start = self.position;
            match self.item(docs) {
                Ok(item) => items.push(item),
                Err(Reported) => self.recover(start),
            }
        }
        File { items }
    }

    /// Takes the lines of a doc comment, without the one space after the slashes.
    fn docs(&mut self) -> Vec<String> {
        let mut docs = Vec::new();
        while let Some(TokenKind::Doc(line)) = self.peek() {
            docs.push(line.strip_prefix(' ').unwrap_or(line).trim_end().to_owned());
            self.position += 1;
        }
        docs
    }

    fn item(&mut self, docs: Vec<String>) -> Parsed<Item> {
        let start = self.span();
        let public = self.eat_word("pub");
        let kind = self.item_kind()?;
        if public
            && !matches!(kind, ItemKind::Kernel { .. } | ItemKind::Derivatives { .. } | ItemKind::Warp(_))
        {
            let message = "only a `kernel` or a `warp` can be `pub`";
            self.report(Diagnostic::new(start, message).with_help("remove `pub`"));
        }
        self.end_item()?;
        Ok(Item { docs, public, span: self.since(start), kind })
    }

    fn item_kind(&mut self) -> Parsed<ItemKind> {
        let word = match self.peek() {
            Some(TokenKind::Name(text)) => text.as_str(),
            _ => "",
        };
        let rule = match word {
            "chart" => Self::chart,
            "param" => Self::param,
            "fn" => Self::function,
            "let" => Self::definition,
            "form" => Self::form,
            "field" => Self::field,
            "map" => Self::map,
            "metric" => Self::metric,
            "prove" => |parser: &mut Self| parser.statement(Claim::Prove),
            "refute" => |parser: &mut Self| parser.statement(Claim::Refute),
            "kernel" => Self::kernel,
            "warp" => Self::warp,
            _ => return Err(self.no_item()),
        };
        self.position += 1;
        rule(self)
    }

    fn no_item(&mut self) -> Reported {
        let help = match self.peek() {
            Some(TokenKind::Symbol(Symbol::Semicolon)) => "remove this `;`",
            None => "a `///` comment must precede an item; use `//` for other comments",
            _ => {
                "an item begins with `chart`, `param`, `fn`, `let`, `form`, `field`, `map`, `metric`, `prove`, \
                 `refute`, `kernel` or `warp`"
            }
        };
        self.unexpected("an item", Some(help))
    }

    /// Parses `chart R3(x, y, z) where …` or `chart Ray = R3 * S2 where …`.
    fn chart(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the chart's name")?;
        if self.at(Symbol::OpenParen) {
            let place = self.span();
            let coordinates = self.declared_list("a coordinate")?;
            if coordinates.is_empty() {
                let message = "a chart needs at least one coordinate";
                return Err(self.report(Diagnostic::new(self.since(place), message)));
            }
            return Ok(ItemKind::Chart { name, coordinates, conditions: self.conditions()? });
        }
        if !self.at(Symbol::Assign) && !self.at(Symbol::Equal) {
            return Err(self.unexpected("`(` or `=` after the chart's name", None));
        }
        self.assign()?;
        let mut factors = vec![self.name("a chart")?];
        while factors.len() < 2 || self.at(Symbol::Star) {
            self.expect(Symbol::Star)?;
            factors.push(self.name("a chart")?);
        }
        Ok(ItemKind::ProductChart { name, factors, conditions: self.conditions()? })
    }

    /// Parses `param n, sigma: 1/m where …`.
    fn param(&mut self) -> Parsed<ItemKind> {
        let mut names = vec![self.declared("the parameter's name")?];
        while self.eat(Symbol::Comma).is_some() {
            names.push(self.declared("the parameter's name")?);
        }
        Ok(ItemKind::Param { names, conditions: self.conditions()? })
    }

    /// Parses `fn L(x, y): W/m**2 where …`.
    fn function(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the function's name")?;
        let declared = self.declared_list("an argument")?;
        if let Some(unit) = declared.iter().find_map(|argument| argument.unit.as_ref()) {
            let message = "an argument of a `fn` has the unit of the coordinate or parameter it names";
            self.report(Diagnostic::new(unit.span, message).with_help("remove the unit"));
        }
        let unit = self.unit()?;
        if self.at(Symbol::Assign) {
            let help = "a `fn` is unknown; a known function is a `let` or a `kernel`";
            return Err(self.unexpected("`;` after the statement", Some(help)));
        }
        let arguments = declared.into_iter().map(|argument| argument.name).collect();
        Ok(ItemKind::Function { name, arguments, unit, conditions: self.conditions()? })
    }

    /// Parses `let r: m = …` or `let ease(t) = …`.
    fn definition(&mut self) -> Parsed<ItemKind> {
        let name = self.name("a name")?;
        if self.at(Symbol::OpenParen) {
            return self.definition_with_arguments(name);
        }
        let unit = if self.at_annotation() { self.unit()? } else { None };
        self.assign()?;
        Ok(ItemKind::Let { name, unit, value: self.expression()? })
    }

    /// Parses `(t) = …`.
    fn definition_with_arguments(&mut self, name: Name) -> Parsed<ItemKind> {
        let place = self.span();
        let declared = self.declared_list("an argument")?;
        if declared.is_empty() {
            let message = "a definition with brackets has at least one argument";
            let diagnostic = Diagnostic::new(self.since(place), message);
            self.report(diagnostic.with_help(format!("remove the brackets: `let {} = …`", name.text)));
        }
        if let Some(unit) = declared.iter().find_map(|argument| argument.unit.as_ref()) {
            let message = "an argument of a definition has the unit of the value in its place";
            self.report(Diagnostic::new(unit.span, message).with_help("remove the unit"));
        }
        self.assign()?;
        let arguments = declared.into_iter().map(|argument| argument.name).collect();
        Ok(ItemKind::Definition { name, arguments, value: self.expression()? })
    }

    /// Parses `form beta: 2, sr on R3 = …`.
    fn form(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the form's name")?;
        let degree = if self.at_annotation() { Some(self.degree()?) } else { None };
        let has_unit = degree.is_some() && self.eat(Symbol::Comma).is_some();
        let unit = if has_unit { Some(self.expression()?) } else { None };
        let chart = self.chart_reference()?;
        self.assign()?;
        Ok(ItemKind::Form { name, degree, unit, chart, value: self.expression()? })
    }

    /// Parses `: m`; `None` if there is no unit.
    pub(super) fn unit(&mut self) -> Parsed<Option<Expr>> {
        if self.eat(Symbol::Colon).is_some() { Ok(Some(self.expression()?)) } else { Ok(None) }
    }

    /// Whether an annotation with `:` follows, rather than the `:=` of other languages.
    pub(super) fn at_annotation(&self) -> bool {
        self.at(Symbol::Colon) && self.peek_at(1) != Some(&TokenKind::Symbol(Symbol::Assign))
    }

    fn degree(&mut self) -> Parsed<(u32, Span)> {
        self.expect(Symbol::Colon)?;
        let span = self.span();
        let Some(TokenKind::Number(text)) = self.peek() else {
            return Err(self.unexpected("the form's degree", Some("a degree is an integer: `: 2`")));
        };
        match number::value(text).ok().filter(|value| value.is_integer()).and_then(|value| value.to_u32()) {
            Some(degree) => {
                self.position += 1;
                Ok((degree, span))
            }
            None => Err(self.unexpected("the form's degree", Some("a degree is an integer: `: 2`"))),
        }
    }

    /// Parses `field X on R3 = …`.
    fn field(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the field's name")?;
        let chart = self.chart_reference()?;
        self.assign()?;
        Ok(ItemKind::Field { name, chart, value: self.expression()? })
    }

    /// Parses `map patch: UV -> R3 = (…)`.
    fn map(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the map's name")?;
        self.expect(Symbol::Colon)?;
        let source = self.name("the chart the map comes from")?;
        self.expect(Symbol::Arrow)?;
        let target = self.name("the chart the map goes to")?;
        self.assign()?;
        Ok(ItemKind::Map { name, source, target, components: self.values()? })
    }

    /// Parses `metric g on R3 = …`.
    fn metric(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the metric's name")?;
        let chart = self.chart_reference()?;
        self.assign()?;
        Ok(ItemKind::Metric { name, chart, value: self.expression()? })
    }

    /// Parses `name: … == … where …`.
    fn statement(&mut self, claim: Claim) -> Parsed<ItemKind> {
        let name = self.label("the statement's name")?;
        if self.eat(Symbol::Colon).is_none() {
            let help = "a statement is written `prove name: left == right;`";
            return Err(self.unexpected("`:` after the statement's name", Some(help)));
        }
        let Equation { left, right, conditions } = self.equation()?;
        Ok(ItemKind::Statement { claim, name, left, right, conditions })
    }

    /// Parses `left == right where …`.
    pub(super) fn equation(&mut self) -> Parsed<Equation> {
        let left = self.expression()?;
        if self.at(Symbol::Assign) {
            self.unexpected("`==`", Some("an equation is written `==`; `=` defines a name"));
            self.position += 1;
        } else if self.eat(Symbol::Equal).is_none() {
            return Err(self.no_equation());
        }
        let right = self.expression()?;
        if self.at(Symbol::Equal) {
            let help = "a statement is one equation; write `a == b` and `b == c` as two";
            return Err(self.unexpected("`;` after the statement", Some(help)));
        }
        Ok(Equation { left, right, conditions: self.conditions()? })
    }

    fn no_equation(&mut self) -> Reported {
        let help = match self.peek() {
            Some(TokenKind::Symbol(
                Symbol::Less | Symbol::LessEqual | Symbol::Greater | Symbol::GreaterEqual | Symbol::NotEqual,
            )) => Some("a statement is an equation; an inequality is allowed only after `where`"),
            _ if self.looks_like_factor() => Some("write `*` between factors"),
            _ => None,
        };
        self.unexpected("an operator or `==`", help)
    }

    /// Parses an optional `on R3`.
    fn chart_reference(&mut self) -> Parsed<Option<Name>> {
        if self.eat_word("on") { Ok(Some(self.name("a chart after `on`")?)) } else { Ok(None) }
    }

    /// Takes the `=` of a definition, also where `==` or `:=` is written instead.
    pub(super) fn assign(&mut self) -> Parsed<()> {
        if self.eat(Symbol::Assign).is_some() {
            return Ok(());
        }
        if self.at(Symbol::Equal) {
            self.unexpected("`=`", Some("a definition is written with `=`"));
            self.position += 1;
            return Ok(());
        }
        if self.at(Symbol::Colon) && self.peek_at(1) == Some(&TokenKind::Symbol(Symbol::Assign)) {
            let diagnostic = Diagnostic::new(self.span(), "expected `=`, found `:=`");
            self.report(diagnostic.with_help("a definition is written with `=`"));
            self.position += 2;
            return Ok(());
        }
        let help = match self.peek() {
            Some(TokenKind::Symbol(Symbol::Arrow)) => Some("the results of a kernel have no declared type"),
            Some(TokenKind::Symbol(Symbol::OpenBrace)) => {
                Some("what it stands for follows `=`, without braces")
            }
            _ => None,
        };
        Err(self.unexpected("`=`", help))
    }
}
