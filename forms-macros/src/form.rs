//! `form! { items; expression }`: evaluates and simplifies a scalar or form; the result is a
//! constant of strings.
//!
//! ```text
//! value ─ coefficients, simplified, zeros omitted ─▶ degree · (basis form, coefficient) … · the whole text
//! ```

use crate::expand::{Resolved, resolved, theory_checked};
use crate::tokens::Body;
use forms_core::decide::simplified_where;
use forms_core::diagnostic::{Diagnostic, Span};
use forms_core::expression::{Expr, Node, Pool};
use forms_core::syntax::ast::{self, Item, ItemKind, Name};
use forms_core::syntax::parse_expression;
use forms_core::theory::Blade;
use forms_core::theory::{Named, Theory, Value};
use proc_macro2::TokenStream;
use quote::quote;

/// Internal name of the expression. It contains a space, so that no declared name can equal it.
const NAME: &str = "the expression";

/// Expands to the constant, or to the errors of the body, as one expression.
pub(crate) fn value(body: Body) -> TokenStream {
    let mut span = body.end();
    let Resolved { mut theory, mut diagnostics, origin } = resolved(body, "an expression", |last, end| {
        let expression = parse_expression(last, end)?;
        span = expression.span;
        Ok(named(expression))
    });
    let constant = written(&mut theory, span).unwrap_or_else(|diagnostic| {
        diagnostics.extend(diagnostic);
        quote! { ::forms::Form { degree: 0, terms: &[], text: "" } }
    });
    let errors = theory_checked(theory, diagnostics, &origin, None);
    quote! { { #errors #constant } }
}

/// Builds the item `let name = expression;`.
fn named(value: ast::Expr) -> Item {
    let span = value.span;
    let name = Name { text: NAME.to_owned(), span };
    Item { docs: Vec::new(), public: false, span, kind: ItemKind::Let { name, unit: None, value } }
}

/// Emits the expression's value as a constant. The error is `None` if the reason for the missing
/// value was already reported.
fn written(theory: &mut Theory, span: Span) -> Result<TokenStream, Option<Diagnostic>> {
    let Some(Named::Object(number)) = theory.named(NAME) else { return Err(None) };
    let (degree, terms) = match &theory.objects[*number].value {
        Value::Zero => (0, Vec::new()),
        Value::Scalar(value) => (0, vec![(Blade::SCALAR, *value)]),
        Value::Form(form) => (form.degree(), form.terms().to_vec()),
        Value::Field(_) => {
            let diagnostic = Diagnostic::new(span, "expected a scalar or form, found a vector field");
            return Err(Some(diagnostic.with_help("`X[x]` is a component of a field")));
        }
        Value::Array(array) => {
            let message = format!("expected a scalar or form, found {}", array.shape);
            return Err(Some(Diagnostic::new(span, message).with_help("`p[0]` is an entry of an array")));
        }
    };
    let pool = &mut theory.pool;
    let mut terms: Vec<(Blade, Expr)> =
        terms.into_iter().map(|(blade, value)| (blade, simplified_where(pool, &[], value))).collect();
    terms.retain(|(_, value)| !pool.is_zero(*value));
    let text = text(theory, &terms);
    let pairs = terms.iter().map(|(blade, value)| {
        let (basis, coefficient) = (basis(theory, *blade), theory.pool.text(*value));
        quote! { (#basis, #coefficient) }
    });
    Ok(quote! { ::forms::Form { degree: #degree, terms: &[#(#pairs),*], text: #text } })
}

/// Returns the basis form, for example `dx^dy`; `1` for scalars.
fn basis(theory: &Theory, blade: Blade) -> String {
    let names: Vec<String> =
        blade.coordinates().map(|coordinate| format!("d{}", theory.coordinate_name(coordinate))).collect();
    if names.is_empty() { "1".to_owned() } else { names.join("^") }
}

/// Writes the sum of the terms in the notation of the language.
fn text(theory: &Theory, terms: &[(Blade, Expr)]) -> String {
    let mut text = String::new();
    for (blade, value) in terms {
        let term = term(&theory.pool, *value, &basis(theory, *blade));
        match term.strip_prefix('-') {
            Some(rest) if !text.is_empty() => text = text + " - " + rest,
            _ if !text.is_empty() => text = text + " + " + &term,
            _ => text = term,
        }
    }
    if text.is_empty() { "0".to_owned() } else { text }
}

/// Writes one coefficient times one basis form.
fn term(pool: &Pool, value: Expr, basis: &str) -> String {
    let coefficient = pool.text(value);
    match (pool.node(value), coefficient.as_str()) {
        (_, _) if basis == "1" => coefficient,
        (_, "1") => basis.to_owned(),
        (_, "-1") => format!("-{basis}"),
        (Node::Add(..) | Node::Select { .. }, _) => format!("({coefficient})*{basis}"),
        _ => format!("{coefficient}*{basis}"),
    }
}
