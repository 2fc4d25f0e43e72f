//! Kernels and warps, and bodies that can have several values.
//!
//! ```text
//! kernel  = "kernel" name "(" { argument } ")" [ ":" values ] "=" values
//!           { form | "for" name "{" form "}" | where | "within" sum | effects }
//! form    = "by" values [ "approx" sum ]
//!         | "kernel" name "=" ( "grad" | "jacobian" | "value_and_jacobian" ) "(" name ";" name "," … ")"
//! warp    = "warp" name "(" [ { declared } ";" ] { declared } ")" "=" values "onto" name
//!           "density" sum "of" sum { "inverse" values | "by" values | where | "within" sum }
//! values  = "(" sum "," … ")" | sum
//! effects = "effects" "{" name ":" name "=" sum { ";" … } "}"
//! ```

use super::cursor::{Parsed, Parser};
use crate::diagnostic::Diagnostic;
use crate::syntax::ast::{Declared, Derivatives, Effect, Expr, ItemKind, Name, TargetForm, Warp};
use crate::syntax::token::{Symbol, TokenKind};

impl Parser<'_> {
    pub(super) fn kernel(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the kernel's name")?;
        if let Some(which) = self.derivatives_of() {
            return self.derivatives(name, which);
        }
        let arguments = self.kernel_arguments()?;
        let mut units = Vec::new();
        if self.at_annotation() {
            self.expect(Symbol::Colon)?;
            units = self.values()?;
        }
        self.assign()?;
        let outputs = self.values()?;
        let (mut computed, mut conditions) = (Vec::new(), Vec::new());
        let (mut approximation, mut within, mut effects) = (None, None, Vec::new());
        let mut target_forms = Vec::new();
        loop {
            let place = self.span();
            let repeated = if self.eat_word("by") {
                let repeated = !computed.is_empty();
                (computed, approximation) = self.form_of_kernel()?;
                repeated.then_some("`by`")
            } else if self.eat_word("for") {
                target_forms.push(self.target_form()?);
                None
            } else if self.eat_word("within") {
                within.replace(self.expression()?).map(|_| "`within`")
            } else if self.eat_word("where") {
                let repeated = !conditions.is_empty();
                self.more_conditions(&mut conditions)?;
                repeated.then_some("`where`")
            } else if self.eat_word("effects") {
                let repeated = !effects.is_empty();
                self.effects(&mut effects)?;
                repeated.then_some("`effects`")
            } else {
                return Ok(ItemKind::Kernel {
                    name,
                    arguments,
                    units,
                    outputs,
                    computed,
                    approximation,
                    target_forms,
                    conditions,
                    within,
                    effects,
                });
            };
            if let Some(word) = repeated {
                self.report(Diagnostic::new(place, format!("a kernel has at most one {word}")));
            }
        }
    }

    /// Parses the form after `by`, with its tolerance.
    fn form_of_kernel(&mut self) -> Parsed<(Vec<Expr>, Option<Expr>)> {
        let computed = self.values()?;
        let approximation = if self.eat_word("approx") { Some(self.expression()?) } else { None };
        Ok((computed, approximation))
    }

    /// Parses `f32 { by … }` after `for`.
    fn target_form(&mut self) -> Parsed<TargetForm> {
        let target = self.name("a precision or a target language")?;
        let open = self.expect(Symbol::OpenBrace)?;
        self.expect_word("by", "a form for one precision is written `for f32 { by x/2 }`")?;
        let (computed, approximation) = self.form_of_kernel()?;
        self.close_expression(open, Symbol::CloseBrace, "an operator, `approx` or `}`")?;
        Ok(TargetForm { target, computed, approximation })
    }

    /// Returns the kind of derivatives if `= grad`, `= jacobian` or the like follows.
    fn derivatives_of(&self) -> Option<Derivatives> {
        let Some(TokenKind::Name(word)) = self.peek_at(1) else { return None };
        Derivatives::ALL.into_iter().find(|which| self.at(Symbol::Assign) && which.word() == word)
    }

    /// Parses `= grad(f; u, v)`.
    fn derivatives(&mut self, name: Name, which: Derivatives) -> Parsed<ItemKind> {
        self.assign()?;
        self.eat_word(which.word());
        let open = self.expect(Symbol::OpenParen)?;
        let of = self.name("the kernel to differentiate")?;
        if self.eat(Symbol::Semicolon).is_none() {
            let help =
                format!("name the arguments to differentiate by: `{}({}; x, y)`", which.word(), of.text);
            return Err(self.unexpected("`;`", Some(&help)));
        }
        let mut by = vec![self.quantity("an argument of the kernel")?];
        while self.eat(Symbol::Comma).is_some() {
            by.push(self.quantity("an argument of the kernel")?);
        }
        self.close(open, Symbol::CloseParen, "`,` or `)`")?;
        Ok(ItemKind::Derivatives { name, which, of, by })
    }

    /// Parses `name(p; u, v) = (x, y, z) onto C density E of w inverse (…) by (…) where … within N`
    pub(super) fn warp(&mut self) -> Parsed<ItemKind> {
        let name = self.name("the warp's name")?;
        let (parameters, uniforms) = self.warp_arguments()?;
        self.assign()?;
        let components = self.values()?;
        self.expect_word("onto", "a warp says which chart it goes to: `onto Sphere`")?;
        let target = self.name("the chart the warp goes to")?;
        self.expect_word("density", "a warp says what density it has: `density z/pi of omega`")?;
        let density = self.expression()?;
        self.expect_word("of", "a density is one with respect to a form: `density z/pi of omega`")?;
        let form = self.expression()?;
        let (mut inverse, mut computed, mut conditions) = (Vec::new(), Vec::new(), Vec::new());
        let mut within = None;
        loop {
            let place = self.span();
            let repeated = if self.eat_word("inverse") {
                let repeated = !inverse.is_empty();
                inverse = self.values()?;
                repeated.then_some("`inverse`")
            } else if self.eat_word("by") {
                let repeated = !computed.is_empty();
                computed = self.values()?;
                repeated.then_some("`by`")
            } else if self.eat_word("within") {
                within.replace(self.expression()?).map(|_| "`within`")
            } else if self.eat_word("where") {
                let repeated = !conditions.is_empty();
                self.more_conditions(&mut conditions)?;
                repeated.then_some("`where`")
            } else {
                let warp = Warp {
                    name,
                    parameters,
                    uniforms,
                    components,
                    target,
                    density,
                    form,
                    inverse,
                    computed,
                    conditions,
                    within,
                };
                return Ok(ItemKind::Warp(Box::new(warp)));
            };
            if let Some(word) = repeated {
                self.report(Diagnostic::new(place, format!("a warp has at most one {word}")));
            }
        }
    }

    /// Parses `(p, q; u, v)`: the parameters of the map, then the uniform random numbers; without
    /// `;` there are no parameters.
    fn warp_arguments(&mut self) -> Parsed<(Vec<Declared>, Vec<Declared>)> {
        let open = self.expect(Symbol::OpenParen)?;
        let (mut before, mut list) = (None, Vec::new());
        while !self.at(Symbol::CloseParen) {
            if before.is_none() && self.eat(Symbol::Semicolon).is_some() {
                before = Some(std::mem::take(&mut list));
                continue;
            }
            list.push(self.declared("an argument")?);
            if self.eat(Symbol::Comma).is_none() && !self.at(Symbol::Semicolon) {
                break;
            }
        }
        self.close(open, Symbol::CloseParen, "`,`, `;` or `)`")?;
        Ok((before.unwrap_or_default(), list))
    }

    fn expect_word(&mut self, word: &str, help: &str) -> Parsed<()> {
        if self.eat_word(word) {
            return Ok(());
        }
        Err(self.unexpected(&format!("`{word}`"), Some(help)))
    }

    /// Parses one value, or several in round brackets.
    pub(super) fn values(&mut self) -> Parsed<Vec<Expr>> {
        if !self.at_list() {
            return Ok(vec![self.expression()?]);
        }
        let open = self.expect(Symbol::OpenParen)?;
        let mut values = vec![self.expression()?];
        while self.eat(Symbol::Comma).is_some() && !self.at(Symbol::CloseParen) {
            values.push(self.expression()?);
        }
        self.close_expression(open, Symbol::CloseParen, "an operator, `,` or `)`")?;
        Ok(values)
    }

    /// Whether the next token opens a bracket that directly contains a comma: `((u + v)/2, v)`, not
    /// `(u + v)/2`.
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

    /// Parses `{ absorption: sigma_a = 0; … }`.
    fn effects(&mut self, effects: &mut Vec<Effect>) -> Parsed<()> {
        let open = self.expect(Symbol::OpenBrace)?;
        while matches!(self.peek(), Some(TokenKind::Name(_))) && !self.starts_item(self.position) {
            let name = self.label("the effect's name")?;
            self.expect(Symbol::Colon)?;
            let variable = self.name("the variable that switches the effect off")?;
            self.assign()?;
            let value = self.expression()?;
            effects.push(Effect { name, variable, value });
            if self.eat(Symbol::Semicolon).is_none() {
                self.close_expression(open, Symbol::CloseBrace, "an operator, `;` or `}`")?;
                return Ok(());
            }
        }
        self.close(open, Symbol::CloseBrace, "the effect's name or `}`")?;
        Ok(())
    }
}
