//! Checks a whole source: its declarations, the verdicts on its statements, and all diagnostics for
//! its author.
//!
//! ```text
//! tokens ─ parse ─ resolve ─ units ─▶ Theory ─ decide ─▶ verdicts
//!             └───────┴────────┴───────────────────┴────▶ diagnostics, in the order of the source
//! ```
//! A false claim is an error of the source like a missing bracket, so it is a [`Diagnostic`] too.

use crate::decide::{Verdict, Witness, decide};
use crate::diagnostic::{Diagnostic, Kind, Span, limited};
use crate::generation::faults;
use crate::resolve::{resolve, resolve_traced};
use crate::syntax::ast::{Claim, File, Item, ItemKind};
use crate::syntax::token::{Token, TokenKind};
use crate::syntax::{Source, end_of, lex, parse_text};
use crate::theory::{Statement, Theory};
use crate::units;
use rustc_hash::{FxHashMap, FxHashSet};

/// Resolves a file that was parsed from `tokens`. A name that an unreadable item could have
/// declared is not reported as unknown, since the unreadable item has been reported.
pub fn resolve_parsed(tokens: &[Token], file: &File) -> (Theory, Vec<Diagnostic>) {
    let (theory, mut diagnostics) = resolve_with_units(file);
    let unread = unread_names(tokens, file);
    if !unread.is_empty() && !diagnostics.is_empty() {
        let names: FxHashMap<Span, &str> =
            tokens.iter().filter_map(|token| Some((token.span, name(token)?))).collect();
        let is_consequence = |diagnostic: &Diagnostic| {
            let may_be_unread = |name: &&str| {
                unread.contains(name) || name.strip_prefix('d').is_some_and(|x| unread.contains(x))
            };
            diagnostic.kind == Kind::UnknownName && names.get(&diagnostic.span).is_some_and(may_be_unread)
        };
        diagnostics.retain(|diagnostic| !is_consequence(diagnostic));
    }
    if diagnostics.is_empty() && unread.is_empty() {
        diagnostics.extend(lost_item(file, &theory));
    }
    (theory, diagnostics)
}

/// Returns an error for the first claim that is missing from the theory. Only a defect of
/// resolution can cause one; the check ensures that a claim that was never decided cannot pass for
/// one that holds.
fn lost_item(file: &File, theory: &Theory) -> Option<Diagnostic> {
    let statements: FxHashSet<&str> =
        theory.statements.iter().map(|statement| statement.name.as_str()).collect();
    let kernels: FxHashSet<&str> = theory.kernels.iter().map(|kernel| kernel.name.as_str()).collect();
    let is_kept = |item: &Item| match &item.kind {
        ItemKind::Statement { name, .. } => statements.contains(name.text.as_str()),
        ItemKind::Kernel { name, .. } | ItemKind::Derivatives { name, .. } => {
            kernels.contains(name.text.as_str())
        }
        ItemKind::Warp(warp) => {
            warp.claims(item, false).iter().all(|claim| match &claim.kind {
                ItemKind::Statement { name, .. } => statements.contains(name.text.as_str()),
                _ => true,
            }) && theory.warps.iter().any(|known| known.name == warp.name.text)
        }
        _ => true,
    };
    let lost = file.items.iter().find(|item| !is_kept(item))?;
    let message = "this item was parsed but not resolved, which is a bug in Forms";
    Some(Diagnostic::new(lost.span, message).with_help("please report the file"))
}

/// Resolves a file and, if it states units, checks them.
fn resolve_with_units(file: &File) -> (Theory, Vec<Diagnostic>) {
    if !units::are_stated(file) {
        return resolve(file);
    }
    let (mut theory, trace, mut diagnostics) = resolve_traced(file);
    diagnostics.extend(units::check(file, &mut theory, &trace));
    (theory, diagnostics)
}

fn name(token: &Token) -> Option<&str> {
    match &token.kind {
        TokenKind::Name(text) => Some(text),
        _ => None,
    }
}

/// Returns the names that occur outside the items that could be parsed.
fn unread_names<'a>(tokens: &'a [Token], file: &File) -> FxHashSet<&'a str> {
    let mut items = file.items.iter().map(|item| item.span).peekable();
    let mut unread = FxHashSet::default();
    for token in tokens {
        while items.next_if(|item| item.end <= token.span.start).is_some() {}
        if items.peek().is_none_or(|item| token.span.start < item.start) {
            unread.extend(name(token));
        }
    }
    unread
}

/// Parses and resolves a text; returns its syntax tree, its theory and the diagnostics. Of two
/// errors at one place only the first is reported, which is the parser's.
pub fn read_file(text: &str) -> (File, Theory, Vec<Diagnostic>) {
    let (tokens, mut diagnostics) = lex(text);
    let (file, found) = parse_text(&tokens, end_of(text));
    diagnostics.extend(found);
    let (theory, found) = resolve_parsed(&tokens, &file);
    diagnostics.extend(found);
    diagnostics.sort_by_key(|diagnostic| diagnostic.span);
    diagnostics.dedup_by_key(|diagnostic| diagnostic.span);
    if diagnostics.is_empty() {
        diagnostics.extend(unread_claim(&tokens, &file));
    }
    (file, theory, limited(diagnostics))
}

/// Returns an error for the first `prove` or `refute` that is in no item. Only a defect of the
/// parser can cause one.
fn unread_claim(tokens: &[Token], file: &File) -> Option<Diagnostic> {
    let is_claim = |token: &&Token| matches!(name(token), Some("prove" | "refute"));
    let is_read = |token: &Token| {
        let place = file.items.partition_point(|item| item.span.end <= token.span.start);
        file.items.get(place).is_some_and(|item| {
            item.span.start <= token.span.start && matches!(item.kind, ItemKind::Statement { .. })
        })
    };
    let lost = tokens.iter().filter(is_claim).find(|token| !is_read(token))?;
    let message = "this statement was not parsed, which is a bug in Forms";
    Some(Diagnostic::new(lost.span, message).with_help("please report the file"))
}

/// Parses and resolves a text.
pub fn read_theory(text: &str) -> (Theory, Vec<Diagnostic>) {
    let (_, theory, diagnostics) = read_file(text);
    (theory, diagnostics)
}

/// Decides every statement, in order.
pub fn decide_all(theory: &mut Theory) -> Vec<Verdict> {
    let statements = theory.statements.clone();
    statements.iter().map(|statement| decide(theory, statement)).collect()
}

/// Returns the diagnostic for a statement whose verdict does not match its claim.
pub fn objection(statement: &Statement, verdict: &Verdict) -> Option<Diagnostic> {
    if verdict.bears_out(statement.claim) {
        return None;
    }
    let name = subject(&statement.name);
    let diagnostic = |message: String| Some(Diagnostic::new(statement.span, message));
    match verdict {
        Verdict::Refuted(witness) => diagnostic(format!("{name} is false: {}", contradiction(witness))),
        Verdict::Unknown { reason } => diagnostic(format!("{name} is undecided: {reason}")),
        Verdict::Empty { reason } => diagnostic(format!("{name} is vacuous: {reason}")),
        Verdict::Proved(theorem) => {
            let mut message = format!("{name} is claimed to be false and was proved");
            if !theorem.conditions.is_empty() {
                message = format!("{message}\nwhere {}", theorem.conditions.join(", "));
            }
            let help = match statement.claim {
                Claim::Refute => "claim it with `prove`",
                Claim::Prove => "claim it with `refute`",
            };
            diagnostic(message).map(|diagnostic| diagnostic.with_help(help))
        }
    }
}

/// Formats a statement's name: in quotes, unless it contains a space and is therefore a
/// description.
fn subject(name: &str) -> String {
    if name.contains(' ') { name.to_owned() } else { format!("`{name}`") }
}

/// Formats a witness: left − right on one line, then the point and both values there.
fn contradiction(witness: &Witness) -> String {
    let component = match witness.component.as_str() {
        "" => String::new(),
        component => format!(" in the coefficient of {component}"),
    };
    let point: Vec<String> = witness.point.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let place = if point.is_empty() { "everywhere".to_owned() } else { format!("at {}", point.join(", ")) };
    let ratio = witness.ratio.as_ref().map_or(String::new(), |ratio| format!("\n{ratio}"));
    format!(
        "left - right = {}{component}\n{place}: left = {}, right = {}{ratio}",
        witness.difference, witness.left, witness.right
    )
}

/// Decides the claims of one kernel of a source, by the kernel's name; the error is a message for
/// the user.
///
/// # Errors
/// If the source has an error or no such kernel, or if a claim is false or was not proved.
pub fn check_kernel(source: &Source, name: &str) -> Result<(), String> {
    let (mut theory, diagnostics) = read_theory(&source.text);
    if !diagnostics.is_empty() {
        return Err(diagnostics.iter().map(|diagnostic| source.render(diagnostic)).collect());
    }
    let Some(kernel) = theory.kernels.iter().find(|kernel| kernel.name == name).cloned() else {
        return Err(format!("`{}` has no kernel named `{name}`", source.name));
    };
    let faults = faults(&mut theory.pool, &kernel);
    if faults.is_empty() {
        return Ok(());
    }
    Err(faults.iter().map(|fault| source.render(&fault.diagnostic)).collect())
}

/// Decides one statement of a source by its name; the error is a message for the user.
///
/// # Errors
/// If the source has an error or no such statement, or if the verdict does not match the
/// statement's claim.
pub fn check_statement(source: &Source, name: &str) -> Result<Verdict, String> {
    let (mut theory, diagnostics) = read_theory(&source.text);
    if !diagnostics.is_empty() {
        return Err(diagnostics.iter().map(|diagnostic| source.render(diagnostic)).collect());
    }
    let Some(statement) = theory.statements.iter().find(|statement| statement.name == name).cloned() else {
        return Err(format!("`{}` has no statement named `{name}`", source.name));
    };
    let verdict = decide(&mut theory, &statement);
    match objection(&statement, &verdict) {
        None => Ok(verdict),
        Some(diagnostic) => Err(source.render(&diagnostic)),
    }
}
