//! Files named in macros: finds and reads them, and makes the compiler track their changes.

use crate::expand::source_checked;
use crate::parts::Parts;
use crate::report::{Origin, compile_error, warned};
use forms_core::check::read_file;
use forms_core::stability::{Choices, EXTENSION};
use forms_core::syntax::{Source, lex};
use forms_core::theory::Theory;
use proc_macro2::TokenStream;
use quote::quote;
use std::path::{Path, PathBuf};
use syn::LitStr;

/// `.forms` file named in a macro.
pub(crate) struct Included {
    /// Text of the file, under the name written by the user.
    pub(crate) source: Source,
    /// Span of the literal that names the file.
    pub(crate) place: proc_macro2::Span,
    /// Path of the file.
    path: PathBuf,
}

impl Included {
    /// Reads the file named by a macro's argument.
    ///
    /// # Errors
    /// A `compile_error!`, if the argument is not a path or the file cannot be read.
    pub(crate) fn read(argument: TokenStream) -> Result<Self, TokenStream> {
        let name: LitStr = syn::parse2(argument).map_err(|error| {
            let message =
                "expected the path of a `.forms` file in quotes, relative to the folder of Cargo.toml";
            let place = error.span();
            compile_error(place, place, message)
        })?;
        let path = folder().join(name.value());
        match std::fs::read_to_string(&path) {
            Ok(text) => Ok(Included { source: Source::new(name.value(), text), place: name.span(), path }),
            Err(error) => {
                let message = format!(
                    "cannot read `{}`: {error}\nhelp: the path is relative to the folder of Cargo.toml",
                    path.display()
                );
                Err(compile_error(name.span(), name.span(), &message))
            }
        }
    }

    /// Returns the text of the accompanying stability file, if it exists.
    fn choices(&self) -> Option<String> {
        std::fs::read_to_string(self.path.with_extension(EXTENSION)).ok()
    }

    /// Replaces the forms of kernels by those chosen in the text of the stability file. Returns
    /// tokens that make the compiler track that file.
    fn choose(&self, theory: &mut Theory, choices: &str) -> Result<TokenStream, TokenStream> {
        let path = self.path.with_extension(EXTENSION);
        let path = path.to_string_lossy();
        let source = Source::new(path.clone(), choices);
        match Choices::read(&source.text) {
            Ok(choices) => {
                let warning = choices.objection(theory).map(|message| warned(&message));
                choices.apply(theory);
                Ok(quote! {
                    const _: &str = ::core::include_str!(#path);
                    #warning
                })
            }
            Err(errors) => {
                // the compiler writes "error: " before the first message
                let messages: Vec<String> = errors.iter().map(|error| source.explain(error)).collect();
                Err(compile_error(self.place, self.place, &messages.join("error: ")))
            }
        }
    }

    /// Returns an expression for the file's text; the expression also makes the compiler track the
    /// file.
    pub(crate) fn text(&self) -> TokenStream {
        let path = self.path.to_string_lossy();
        quote! { ::core::include_str!(#path) }
    }
}

/// Returns the folder with the Cargo.toml of the crate that uses the macro.
fn folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(PathBuf::new, |folder| Path::new(&folder).to_owned())
}

/// Expands `include_forms!("file.forms")`.
pub(crate) fn items(argument: TokenStream) -> TokenStream {
    let included = match Included::read(argument) {
        Ok(included) => included,
        Err(error) => return error,
    };
    let text = included.text();
    let (file, mut theory, diagnostics) = read_file(&included.source.text);
    let choices = included.choices();
    let chosen = match choices.as_deref().map(|choices| included.choose(&mut theory, choices)).transpose() {
        Ok(chosen) => chosen,
        Err(error) => return error,
    };
    let (tokens, _) = lex(&included.source.text);
    let read = choices.as_deref().and_then(|text| Some((Choices::read(text).ok()?, text)));
    let parts = Parts::new(&tokens, &file, read.as_ref().map(|(choices, text)| (choices, *text)));
    let origin = Origin::File(included.source, included.place);
    let items = source_checked(theory, diagnostics, &origin, &parts);
    quote! {
        const _: &str = #text;
        #chosen
        #items
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the messages of the `compile_error!`s in an expansion.
    fn messages(expansion: &TokenStream) -> Vec<String> {
        let text = expansion.to_string();
        let literals =
            text.split("compile_error ! {").skip(1).map(|rest| rest.split(" }").next().unwrap_or(rest));
        literals
            .map(|literal| syn::parse_str::<LitStr>(literal).expect("a message is a string").value())
            .collect()
    }

    #[test]
    fn a_file_that_is_not_there_is_named_in_full() {
        let messages = messages(&items(quote! { "src/not_there.forms" }));
        let path = folder().join("src/not_there.forms");
        assert_eq!(messages.len(), 1);
        assert!(messages[0].starts_with(&format!("cannot read `{}`: ", path.display())), "{messages:?}");
    }

    #[test]
    fn every_mistake_of_a_file_is_quoted_with_its_place() {
        let messages = messages(&items(quote! { "../tests/files/mistakes.forms" }));
        let file = "../tests/files/mistakes.forms";
        let heads: Vec<&str> = messages.iter().filter_map(|message| message.lines().next()).collect();
        assert_eq!(
            heads,
            [
                "expected `;` after the statement, found `x`",
                "`unknown` is not declared",
                "`wrong` is false: left - right = 1 in the coefficient of dx^dy",
                "`y` is not an argument of the kernel",
            ]
        );
        for (message, place) in messages.iter().zip(["3:10", "5:9", "6:1", "8:20"]) {
            assert!(message.contains(&format!("--> {file}:{place}\n")), "{message}");
        }
        assert!(messages[1].contains(" 5 | let r = unknown + x;\n   |         ^^^^^^^\n"), "{}", messages[1]);
    }

    #[test]
    fn a_file_with_mistakes_still_gives_the_kernels_that_have_none() {
        let expansion = items(quote! { "../tests/files/mistakes.forms" }).to_string();
        assert!(expansion.contains("fn double") && !expansion.contains("fn broken"), "{expansion}");
    }

    #[test]
    fn an_included_file_is_watched_for_changes() {
        let expansion = items(quote! { "../tests/files/theorems.forms" }).to_string();
        assert!(
            expansion.contains("include_str ! (") && messages(&items(quote! { 5 })).len() == 1,
            "{expansion}"
        );
    }
}
