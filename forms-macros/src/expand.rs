//! Expansion of a macro body.
//!
//! ```text
//! Body ─ parse ─ resolve ─▶ Theory ─┬─ statements ─ decide ─▶ errors, or nothing
//!                                   └─ kernels ─ generate, emit ─▶ errors, or documented functions
//! ```
//! A source without errors is divided into parts. A part that was compiled before is not compiled
//! again: its functions are in the cache.

use crate::cache::{Emitted, Key};
use crate::parts::Parts;
use crate::report::{Origin, warned};
use crate::tokens::Body;
use crate::{formulas, lattice, tiers};
use forms_core::accuracy::removable_singularities;
use forms_core::check::resolve_parsed;
use forms_core::compile::{Compiled, CompiledKernel, Options, compile_theory};
use forms_core::decide::Verdict;
use forms_core::diagnostic::{Diagnostic, Span};
use forms_core::emission::{KernelDocs, comment, emit_rust, emit_rust_within, promised_by_bound};
use forms_core::generation::Generated;
use forms_core::notation::results;
use forms_core::syntax::ast::{Claim, Equation, Item, ItemKind, Name};
use forms_core::syntax::token::{Symbol, Token, TokenKind};
use forms_core::syntax::words::ITEMS;
use forms_core::syntax::{parse, parse_equation};
use forms_core::theory::{Kernel, Statement, Theory};
use proc_macro2::{Group, TokenStream, TokenTree};

/// Placeholder for the lines that the author of a kernel wrote above it.
const DOCS: &str = "(documentation)";

/// Expands `forms! { items }`.
pub(crate) fn file(body: Body) -> TokenStream {
    let end = body.end();
    let (file, found) = parse(&body.tokens, end);
    let mut diagnostics = body.diagnostics;
    diagnostics.extend(found);
    let (theory, found) = resolve_parsed(&body.tokens, &file);
    diagnostics.extend(found);
    let parts = Parts::new(&body.tokens, &file, None);
    source_checked(theory, diagnostics, &Origin::Body(body.places), &parts)
}

/// Expands `prove! { items; left == right where … }`.
pub(crate) fn equation(body: Body) -> TokenStream {
    let expected = "an equation `left == right`";
    let key = Key::of(&body.tokens, "equation");
    let Resolved { theory, diagnostics, origin } =
        resolved(body, expected, |last, end| parse_equation(last, end).map(claim));
    theory_checked(theory, diagnostics, &origin, key.as_ref())
}

/// Resolved body, together with its errors.
pub(crate) struct Resolved {
    pub(crate) theory: Theory,
    pub(crate) diagnostics: Vec<Diagnostic>,
    pub(crate) origin: Origin,
}

/// Resolves the items of a body and the item that `read_last` parses from the remaining tokens.
/// `expected` describes that item in the error message.
pub(crate) fn resolved(
    body: Body,
    expected: &str,
    read_last: impl FnOnce(&[Token], Span) -> Result<Item, Vec<Diagnostic>>,
) -> Resolved {
    let end = body.end();
    let (items, last) = split_last(&body.tokens);
    let (mut file, found) = parse(items, last.first().map_or(end, |token| token.span));
    let mut diagnostics = body.diagnostics;
    diagnostics.extend(found);
    let read = if last.is_empty() { Err(vec![missing(expected, end)]) } else { read_last(last, end) };
    match read {
        Ok(item) => file.items.push(item),
        Err(found) => diagnostics.extend(found),
    }
    let (theory, found) = resolve_parsed(&body.tokens, &file);
    diagnostics.extend(found);
    Resolved { theory, diagnostics, origin: Origin::Body(body.places) }
}

/// Builds the item `prove equation: left == right where …;`.
fn claim(Equation { left, right, conditions }: Equation) -> Item {
    let span = conditions.iter().fold(left.span.to(right.span), |span, condition| span.to(condition.span));
    let name = Name { text: "the equation".to_owned(), span };
    let kind = ItemKind::Statement { claim: Claim::Prove, name, left, right, conditions };
    Item { docs: Vec::new(), public: false, span, kind }
}

fn missing(expected: &str, end: Span) -> Diagnostic {
    Diagnostic::new(end, format!("expected {expected} after the declarations"))
}

/// Expands `kernel! { items; name(…) = … where … }`.
pub(crate) fn kernel(mut body: Body) -> TokenStream {
    let (items, last) = split_last(&body.tokens);
    let is_before_name =
        |token: &Token| matches!(&token.kind, TokenKind::Doc(_)) || token.kind == word("pub");
    let name = items.len() + last.iter().take_while(|token| is_before_name(token)).count();
    if let Some(span) = body.tokens.get(name).filter(|token| token.kind != word("kernel")).map(|t| t.span) {
        body.tokens.insert(name, Token { kind: word("kernel"), span });
    }
    let semicolon = TokenKind::Symbol(Symbol::Semicolon);
    let end = body.end();
    if body.tokens.last().is_some_and(|token| token.kind != semicolon) {
        body.tokens.push(Token { kind: semicolon, span: end });
    }
    if !body.tokens.iter().any(|token| token.kind == word("kernel")) {
        body.diagnostics.push(missing("a kernel `name(x) = …`", end));
    }
    file(body)
}

fn word(text: &str) -> TokenKind {
    TokenKind::Name(text.to_owned())
}

/// Splits a body into its items with their `;` and the remaining tokens. The remainder is empty if
/// it begins an item.
fn split_last(tokens: &[Token]) -> (&[Token], &[Token]) {
    let semicolon = TokenKind::Symbol(Symbol::Semicolon);
    let mut depth = 0_usize;
    let mut start = 0;
    for (at, token) in tokens.iter().enumerate().take(tokens.len().saturating_sub(1)) {
        match &token.kind {
            TokenKind::Symbol(Symbol::OpenParen | Symbol::OpenBracket | Symbol::OpenBrace) => depth += 1,
            TokenKind::Symbol(Symbol::CloseParen | Symbol::CloseBracket | Symbol::CloseBrace) => {
                depth = depth.saturating_sub(1);
            }
            kind if depth == 0 && *kind == semicolon => start = at + 1,
            _ => {}
        }
    }
    let is_item = ITEMS.iter().any(|item| tokens.get(start).is_some_and(|token| token.kind == word(item)));
    tokens.split_at(if is_item { tokens.len() } else { start })
}

/// Decides every statement and emits every kernel of a source. A source without errors is expanded
/// by its parts.
pub(crate) fn source_checked(
    theory: Theory,
    diagnostics: Vec<Diagnostic>,
    origin: &Origin,
    parts: &Parts<'_>,
) -> TokenStream {
    let items = if diagnostics.is_empty() { by_parts(&theory, origin, parts) } else { None };
    items.unwrap_or_else(|| theory_checked(theory, diagnostics, origin, None))
}

/// Expands a source by its parts; nothing if a statement or a warp has an error.
fn by_parts(theory: &Theory, origin: &Origin, parts: &Parts<'_>) -> Option<TokenStream> {
    let of_warps = part(parts, None)?.ok()?;
    let (mut of_warps, mut output, mut diagnostics) = (of_warps.iter(), TokenStream::new(), Vec::new());
    for kernel in &theory.kernels {
        let items = if parts.has_kernel(&kernel.name) {
            let emitted = part(parts, Some(&kernel.name))?;
            emitted.and_then(|emitted| emitted.iter().map(|one| tokens(kernel, one, origin)).collect())
        } else {
            tokens(kernel, of_warps.next()?, origin)
        };
        match items {
            Ok(items) => output.extend(items),
            Err(found) => diagnostics.extend(found),
        }
    }
    output.extend(origin.errors(&diagnostics));
    Some(output)
}

/// Emits the kernels of a part, or takes what was emitted before from the cache. Nothing if the
/// part has no meaning alone. The part of a kernel is emitted after all statements have been decided and
/// are what they are claimed to be.
fn part(parts: &Parts<'_>, kernel: Option<&str>) -> Option<Result<Vec<Emitted>, Vec<Diagnostic>>> {
    let key = parts.key(kernel);
    if let Some(emitted) = key.as_ref().and_then(Key::read) {
        return Some(Ok(emitted));
    }
    let mut compiled = parts.compiled(kernel)?;
    let mut all = Vec::new();
    for compiled_kernel in &std::mem::take(&mut compiled.kernels) {
        match emitted(&mut compiled, compiled_kernel, kernel.is_some()) {
            Ok(emitted) => all.push(emitted),
            Err(found) => compiled.diagnostics.extend(found),
        }
    }
    if !compiled.diagnostics.is_empty() {
        return Some(Err(compiled.diagnostics));
    }
    if let Some(key) = key {
        key.write(&all);
    }
    Some(Ok(all))
}

/// Decides every statement and emits every kernel, or takes what was emitted before from the cache.
/// Kernels are emitted even if there are errors, so that calls of them cause no further errors.
pub(crate) fn theory_checked(
    theory: Theory,
    diagnostics: Vec<Diagnostic>,
    origin: &Origin,
    key: Option<&Key>,
) -> TokenStream {
    let key = key.filter(|_| diagnostics.is_empty());
    if let Some(items) = key.and_then(|key| known(&theory, key, origin)) {
        return items;
    }
    let mut compiled = compile_theory(theory, diagnostics, &Options::default());
    let kernels = std::mem::take(&mut compiled.kernels);
    let (mut output, mut all) = (TokenStream::new(), Vec::new());
    for kernel in &kernels {
        let emitted = emitted(&mut compiled, kernel, false);
        match emitted.and_then(|emitted| Ok((tokens(kernel.kernel(), &emitted, origin)?, emitted))) {
            Ok((items, emitted)) => {
                output.extend(items);
                all.push(emitted);
            }
            Err(found) => compiled.diagnostics.extend(found),
        }
    }
    if let Some(key) = key.filter(|_| compiled.diagnostics.is_empty()) {
        key.write(&all);
    }
    output.extend(origin.errors(&compiled.diagnostics));
    output
}

/// Reads the items of a theory from the cache.
fn known(theory: &Theory, key: &Key, origin: &Origin) -> Option<TokenStream> {
    let emitted = key.read().filter(|emitted| emitted.len() == theory.kernels.len())?;
    let kernels = theory.kernels.iter().zip(&emitted);
    kernels.map(|(kernel, emitted)| tokens(kernel, emitted, origin).ok()).collect()
}

/// Emits a kernel as a documented Rust function and the module of its tiers. `hold` states that all
/// statements were decided before, and are what they are claimed to be.
fn emitted(
    compiled: &mut Compiled,
    of_kernel: &CompiledKernel,
    hold: bool,
) -> Result<Emitted, Vec<Diagnostic>> {
    let (kernel, generated) = (of_kernel.kernel(), of_kernel.generated());
    let docs = documentation(compiled, kernel, generated, hold);
    let program = of_kernel.program();
    let function = match &kernel.within {
        Some(within) if generated.within().is_some() => {
            let formula = format!("{}::Stable", kernel.name);
            emit_rust_within(program, &docs, formulas::MATH, &formula, within)
        }
        _ => emit_rust(program, &docs, formulas::MATH),
    };
    let lattice = lattice::items(&mut compiled.theory.pool, kernel, generated)?;
    let mut items = tiers::module(generated, &lattice).map_err(|error| unreadable(kernel, &error))?;
    items.extend(warning(&compiled.theory, kernel));
    Ok(Emitted { function, items: items.to_string() })
}

/// Reads the text emitted for a kernel, with the lines of its author in the documentation. The
/// function name has the span of the user's own.
fn tokens(kernel: &Kernel, emitted: &Emitted, origin: &Origin) -> Result<TokenStream, Vec<Diagnostic>> {
    let docs = comment(&kernel.docs, "///");
    let text = emitted.function.replacen(&comment(&[DOCS.to_owned()], "///"), &docs, 1) + &emitted.items;
    let items = text.parse().map_err(|error| unreadable(kernel, &error))?;
    Ok(named_at(items, &kernel.name, origin.place(kernel.span).0))
}

fn unreadable(kernel: &Kernel, error: &proc_macro2::LexError) -> Vec<Diagnostic> {
    let message = format!("Rust cannot parse the function generated for `{}`: {error}", kernel.name);
    vec![Diagnostic::new(kernel.span, message)]
}

/// Emits a warning about removable singularities in the declared domain, if there are any.
fn warning(theory: &Theory, kernel: &Kernel) -> Option<TokenStream> {
    if kernel.domain.is_empty() {
        return None;
    }
    let places = removable_singularities(&theory.pool, kernel);
    (!places.is_empty()).then(|| {
        warned(&format!(
            "`{}` has no value at {}, where its formula has a limit: give an equal form that is defined there after \
             `by`, or exclude this place with `where`",
            kernel.name,
            places.join(" and at ")
        ))
    })
}

/// Collects the documentation: the formula, the proved statements that it rests on, the domain, the
/// units, whether the kernel is proved equal to its formula, and its rounding error.
fn documentation(compiled: &Compiled, kernel: &Kernel, generated: &Generated, hold: bool) -> KernelDocs {
    let theory = &compiled.theory;
    let is_proved = |name: &&String| {
        let mut decided = compiled.statements.iter();
        let is_it = |(statement, verdict): &(Statement, Verdict)| {
            statement.name == **name && matches!(verdict, Verdict::Proved(_))
        };
        // the statements that a kernel names are claimed by `prove`
        hold || decided.any(is_it)
    };
    KernelDocs {
        formula: format!(
            "{}({}) = {}",
            kernel.name,
            kernel.signature,
            results(&kernel.formula, &kernel.signature.results)
        ),
        statements: kernel.statements.iter().filter(is_proved).cloned().collect(),
        conditions: kernel.domain.iter().map(|condition| condition.text(&theory.pool)).collect(),
        units: forms_core::units::sentence(kernel).unwrap_or_default(),
        translation: generated.account(),
        rounding: match (&kernel.within, generated.bounded) {
            (Some(within), Some(units)) => promised_by_bound(within, units),
            _ => forms_core::rounding::sentence(&generated.optimised).unwrap_or_default(),
        },
        docs: if kernel.docs.is_empty() { Vec::new() } else { vec![DOCS.to_owned()] },
    }
}

/// Gives the function name the span of the user's own name. All other tokens have the same location
/// but are marked as generated: a span of the whole body would be several lines long, and layout
/// lints would apply that length to each line.
fn named_at(function: TokenStream, name: &str, place: proc_macro2::Span) -> TokenStream {
    let generated = proc_macro2::Span::call_site().located_at(place);
    let mut is_name = false;
    let locate = |mut token: TokenTree| {
        let names = is_name && matches!(&token, TokenTree::Ident(ident) if ident == name);
        is_name = matches!(&token, TokenTree::Ident(ident) if ident == "fn");
        if let TokenTree::Group(group) = token {
            token = Group::new(group.delimiter(), named_at(group.stream(), name, place)).into();
        }
        token.set_span(if names { place } else { generated });
        token
    };
    function.into_iter().map(locate).collect()
}
