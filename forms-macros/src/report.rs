//! Converts diagnostics to `compile_error!`s: on the user's own tokens, or with the line of a file
//! quoted.

use forms_core::diagnostic::{Diagnostic, Span};
use forms_core::syntax::Source;
use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;
use std::fmt::Write;

/// Origin of the language's tokens.
pub(crate) enum Origin {
    /// Macro body: start and end of each token in the Rust source.
    Body(Vec<(proc_macro2::Span, proc_macro2::Span)>),
    /// File, and the span of the literal that names it.
    File(Source, proc_macro2::Span),
}

impl Origin {
    /// Emits all diagnostics, in order and without duplicates.
    pub(crate) fn errors(&self, diagnostics: &[Diagnostic]) -> TokenStream {
        let mut ordered: Vec<&Diagnostic> = diagnostics.iter().collect();
        ordered.sort_by_key(|diagnostic| diagnostic.span);
        ordered.dedup();
        ordered.into_iter().map(|diagnostic| self.error(diagnostic)).collect()
    }

    fn error(&self, diagnostic: &Diagnostic) -> TokenStream {
        let (first, last) = self.place(diagnostic.span);
        match self {
            Origin::Body(_) => compile_error(first, last, &self.text(diagnostic)),
            Origin::File(source, _) => compile_error(first, last, source.explain(diagnostic).trim_end()),
        }
    }

    /// Returns the message for a macro body, with its note and help. The compiler shows it at the
    /// marked tokens.
    fn text(&self, diagnostic: &Diagnostic) -> String {
        let mut text = diagnostic.message.clone();
        let mut put = |part: std::fmt::Arguments<'_>| text.write_fmt(part).expect("a String takes all text");
        if let Some((span, name)) = &diagnostic.related {
            let start = self.place(*span).0.start();
            put(format_args!("\nnote: {name} is at {}:{}", start.line, start.column + 1));
        }
        if let Some(help) = &diagnostic.help {
            put(format_args!("\nhelp: {help}"));
        }
        text
    }

    /// Returns the start and end of a span in the user's Rust source. For a missing token, both are
    /// the token before the gap.
    pub(crate) fn place(&self, span: Span) -> (proc_macro2::Span, proc_macro2::Span) {
        let places = match self {
            Origin::File(_, literal) => return (*literal, *literal),
            Origin::Body(places) => places,
        };
        let Some(last_place) = places.len().checked_sub(1) else {
            return (proc_macro2::Span::call_site(), proc_macro2::Span::call_site());
        };
        let at = |place: u32| places[(place as usize).min(last_place)];
        if span.start == span.end {
            let before = at(span.start.saturating_sub(1)).1;
            return (before, before);
        }
        (at(span.start).0, at(span.end - 1).1)
    }
}

/// Emits code that makes the compiler print this message as a warning. Macros cannot warn, but
/// their expansion can use a deprecated item.
pub(crate) fn warned(message: &str) -> TokenStream {
    quote! {
        const _: () = {
            #[deprecated(note = #message)]
            const WARNING: () = ();
            WARNING
        };
    }
}

/// Emits a `compile_error!` that marks everything from `first` to `last`.
pub(crate) fn compile_error(first: proc_macro2::Span, last: proc_macro2::Span, message: &str) -> TokenStream {
    let ends = [first, last].map(|place| TokenTree::Ident(Ident::new("_here", place)));
    syn::Error::new_spanned(TokenStream::from_iter(ends), message).into_compile_error()
}
