//! Formulas of a kernel as types: as written, in its stable form, and in the form for `f32`.

use forms_core::emission::emit_formula;
use forms_core::generation::Generated;
use forms_core::kernel::Program;
use proc_macro2::TokenStream;
use quote::quote;

/// Absolute path of the arithmetic, valid at every use of a macro.
pub(crate) const MATH: &str = "::forms::math";

/// Formulas of a kernel as types.
pub(crate) struct Formulas {
    /// Declarations of the types.
    pub(crate) types: TokenStream,
    /// Name of the formula that is computed in `f32`.
    pub(crate) single: TokenStream,
}

impl Formulas {
    /// Returns the types; the error says why Rust cannot parse the generated code.
    pub(crate) fn of(generated: &Generated) -> Result<Formulas, proc_macro2::LexError> {
        let formula =
            |program: &Program, name: &str| emit_formula(program, name, MATH).parse::<TokenStream>();
        let (written, stable) = (&generated.written, &generated.optimised);
        let plain = formula(written, "Plain")?;
        let of_stable = if written == stable {
            quote!(
                pub type Stable = Plain;
            )
        } else {
            let stable = formula(stable, "Stable")?;
            quote!(pub enum Stable {} #stable)
        };
        let (single, of_single) = match generated.single() {
            own if own == stable => (quote!(Stable), TokenStream::new()),
            own => {
                let own = formula(own, "Single")?;
                let about = quote!(#[doc = " The form for `f32`, for any number type."]);
                (quote!(Single), quote!(#about pub enum Single {} #own))
            }
        };
        let types = quote! {
            #[doc = " The formula as written, for any number type."]
            pub enum Plain {}
            #plain
            #[doc = " The stable form, by which the kernel is computed, for any number type."]
            #of_stable
            #of_single
        };
        Ok(Formulas { types, single })
    }
}
