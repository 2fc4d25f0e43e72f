//! Files named in macros: where they are, what is in them, and how the compiler learns that they changed.

use crate::expand::theory_checked;
use crate::report::{Origin, compile_error};
use forms_core::check::read_theory;
use forms_core::syntax::Source;
use proc_macro2::TokenStream;
use quote::quote;
use std::path::{Path, PathBuf};
use syn::LitStr;

/// A `.forms` file as a macro names it.
pub(crate) struct Included {
    /// Its text, under the name the user wrote.
    pub(crate) source: Source,
    /// The literal that names it.
    pub(crate) place: proc_macro2::Span,
    /// Where it was found.
    path: PathBuf,
}

impl Included {
    /// Reads the file a macro's argument names.
    ///
    /// # Errors
    /// A `compile_error!`, if the argument is no path or the file cannot be read.
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

    /// An expression of the file's text, which also makes the compiler look at the file again when it changes.
    pub(crate) fn text(&self) -> TokenStream {
        let path = self.path.to_string_lossy();
        quote! { ::core::include_str!(#path) }
    }
}

/// The folder of the Cargo.toml of the crate that uses the macro.
fn folder() -> PathBuf {
    std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(PathBuf::new, |folder| Path::new(&folder).to_owned())
}

/// `include_forms!("file.forms")`
pub(crate) fn items(argument: TokenStream) -> TokenStream {
    let included = match Included::read(argument) {
        Ok(included) => included,
        Err(error) => return error,
    };
    let text = included.text();
    let (theory, diagnostics) = read_theory(&included.source.text);
    let items = theory_checked(theory, diagnostics, &Origin::File(included.source, included.place));
    quote! {
        const _: &str = #text;
        #items
    }
}
