//! `proof_tests!("file.forms")`: one `#[test]` that decides each statement of a file, and one for
//! each kernel with claims.

use crate::include::Included;
use crate::report::Origin;
use forms_core::check::read_theory;
use forms_core::diagnostic::Diagnostic;
use forms_core::generation::makes_claims;
use forms_core::theory::Statement;
use proc_macro2::TokenStream;
use quote::quote;

/// Expands to the tests, or to the errors of the file.
pub(crate) fn tests(argument: TokenStream) -> TokenStream {
    let included = match Included::read(argument) {
        Ok(included) => included,
        Err(error) => return error,
    };
    let (theory, mut diagnostics) = read_theory(&included.source.text);
    let text = included.text();
    let name = &included.source.name;
    let mut output = TokenStream::new();
    for statement in &theory.statements {
        match test(statement, name, &text) {
            Ok(test) => output.extend(test),
            Err(diagnostic) => diagnostics.push(diagnostic),
        }
    }
    for kernel in theory.kernels.iter().filter(|kernel| makes_claims(&theory.pool, kernel)) {
        output.extend(test_of_kernel(&kernel.name, name, &text));
    }
    output.extend(quote! { const _: &str = #text; });
    output.extend(Origin::File(included.source, included.place).errors(&diagnostics));
    output
}

/// Emits the test `kernel_NAME` of a kernel's claims.
fn test_of_kernel(name: &str, file: &str, text: &TokenStream) -> TokenStream {
    let function = quote::format_ident!("kernel_{name}");
    quote! {
        #[::core::prelude::v1::test]
        #[allow(non_snake_case, reason = "the name of the kernel")]
        fn #function() {
            let source = ::forms::core::syntax::Source::new(#file, #text);
            if let ::core::result::Result::Err(message) = ::forms::core::check::check_kernel(&source, #name) {
                ::core::panic!("{message}");
            }
        }
    }
}

fn test(statement: &Statement, file: &str, text: &TokenStream) -> Result<TokenStream, Diagnostic> {
    let name = &statement.name;
    let function = syn::parse_str::<syn::Ident>(name).map_err(|_| {
        Diagnostic::new(statement.name_span, format!("`{name}` cannot be the name of a test"))
    })?;
    // Names of statements follow mathematical notation and can contain capitals.
    let spelling = name.chars().any(char::is_uppercase).then(|| {
        quote! { #[allow(non_snake_case, reason = "the name of the statement")] }
    });
    Ok(quote! {
        #[::core::prelude::v1::test]
        #spelling
        fn #function() {
            let source = ::forms::core::syntax::Source::new(#file, #text);
            if let ::core::result::Result::Err(message) = ::forms::core::check::check_statement(&source, #name) {
                ::core::panic!("{message}");
            }
        }
    })
}
