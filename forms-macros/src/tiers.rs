//! The module that accompanies a kernel's function: the same kernel in other precisions, and as
//! written.
//!
//! ```text
//! written ─ emit_formula ─▶ Plain ──┬─▶ plain
//! optimised ─ emit_formula ▶ Stable ┴─▶ f32, dd, batch, batch_f32, batch_parallel, batch_rows
//!                                        └─ with a promise: checked, unguarded, batch_unguarded
//! ```
//! If a kernel promises an accuracy, its batch keeps the promise; the `unguarded` functions omit
//! it.
//!
//! Each function is a thin wrapper, compiled only where it is called. Paths are absolute and types
//! have no values of their name, so that neither the user's names nor the kernel's arguments
//! collide with them.

use forms_core::emission::{MANY_ARGUMENTS, emit_formula};
use forms_core::generation::Generated;
use forms_core::kernel::Program;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

/// Absolute path of the arithmetic, valid at every use of a macro.
pub(crate) const MATH: &str = "::forms::math";

/// Emits `mod NAME { … }` with the tiers and `more` items of the kernel. The error says why Rust
/// cannot parse the generated code.
pub(crate) fn module(
    generated: &Generated,
    more: &TokenStream,
) -> Result<TokenStream, proc_macro2::LexError> {
    let (program, within) = (&generated.optimised, generated.within);
    let formula = |program: &Program, name: &str| emit_formula(program, name, MATH).parse::<TokenStream>();
    let plain = formula(&generated.written, "Plain")?;
    let stable = if generated.written == *program {
        quote!(
            pub type Stable = Plain;
        )
    } else {
        let stable = formula(program, "Stable")?;
        quote!(pub enum Stable {} #stable)
    };
    let tiers = Tiers::of(program);
    let mut functions = vec![tiers.plain(), tiers.f32(within.is_some()), tiers.dd(within.is_some())];
    if let Some(within) = within {
        functions.extend([tiers.checked(within), tiers.unguarded()]);
    }
    functions.extend(batches(within).into_iter().map(|batch| tiers.batch(batch)));
    if cfg!(feature = "ndarray") {
        functions.push(tiers.batch_rows(within));
    }
    let (name, attributes) = (&tiers.name, attributes(program));
    let public = program.is_public().then(|| quote!(pub));
    let about = format!(" `{name}` in every precision.");
    let count = Literal::usize_unsuffixed(operations(program));
    let module = quote! {
        #[doc = #about]
        #attributes
        #public mod #name {
            #[doc = " The formula as written, for any number type."]
            pub enum Plain {}
            #plain
            #[doc = " The stable form, by which the kernel is computed, for any number type."]
            #stable
            #[doc = " Number of operations per value: arithmetic, function calls and selections."]
            pub const OPERATIONS: usize = #count;
            #(#functions)*
            #more
        }
    };
    Ok(module)
}

/// Returns the total number of operations of a program.
pub(crate) fn operations(program: &Program) -> usize {
    let count = program.operations();
    count.arithmetic() + count.function_calls + count.selects
}

/// Emits `allow` attributes for the lints that names of the formula and unused tiers would trigger.
fn attributes(program: &Program) -> TokenStream {
    let names = std::iter::once(program.name()).chain(program.arguments().iter().map(String::as_str));
    let case = names
        .flat_map(str::chars)
        .any(char::is_uppercase)
        .then(|| quote!(#[allow(non_snake_case, reason = "the names of the formula")]));
    // A batch has one more argument, its output.
    let many = (program.arguments().len() + 1 > MANY_ARGUMENTS)
        .then(|| quote!(#[allow(clippy::too_many_arguments, reason = "one for each variable")]));
    quote! {
        #[allow(dead_code, reason = "a crate may use only some of a kernel's tiers")]
        #case
        #many
    }
}

/// Function of columns.
struct Batch<'a> {
    /// Name in the module.
    name: &'a str,
    /// Function of `forms_math` that it calls.
    function: &'a str,
    /// Number type.
    number: &'a str,
    /// Promised error bound, in units of 2⁻⁵³.
    within: Option<f64>,
}

/// Lists the batches of a kernel with this promised error bound.
fn batches(within: Option<f64>) -> Vec<Batch<'static>> {
    let batch = |name, function, within| Batch { name, function, number: "f64", within };
    let [one, all] = match within {
        Some(_) => ["batch_within", "batch_within_parallel"],
        None => ["batch", "batch_parallel"],
    };
    let mut batches = vec![
        batch("batch", one, within),
        Batch { name: "batch_f32", function: "batch_f32", number: "f32", within: None },
    ];
    if cfg!(feature = "rayon") {
        batches.push(batch("batch_parallel", all, within));
    }
    if within.is_some() {
        batches.push(batch("batch_unguarded", "batch", None));
    }
    batches
}

/// Common data of the wrappers of one kernel.
pub(crate) struct Tiers {
    pub(crate) name: Ident,
    pub(crate) arguments: Vec<Ident>,
    pub(crate) outputs: usize,
}

impl Tiers {
    pub(crate) fn of(program: &Program) -> Self {
        let identifier = |name: &String| Ident::new(name, Span::call_site());
        Tiers {
            name: format_ident!("{}", program.name()),
            arguments: program.arguments().iter().map(identifier).collect(),
            outputs: program.outputs().len(),
        }
    }

    /// Emits the formula as written, in `f64`.
    fn plain(&self) -> TokenStream {
        let docs = format!(" `{}` in `f64`, by its formula as written.", self.name);
        self.scalar(&docs, &format_ident!("plain"), &quote!(f64), &quote!(Plain))
    }

    /// Emits the stable form in `f32`. A promise does not apply to it.
    fn f32(&self, promised: bool) -> TokenStream {
        let promise = if promised {
            ", by its form alone: the accuracy promised by `within` is not ensured"
        } else {
            ""
        };
        let docs = format!(" `{}` in `f32`{promise}.", self.name);
        self.scalar(&docs, &format_ident!("f32"), &quote!(f32), &quote!(Stable))
    }

    /// Emits the stable form in double-double arithmetic. For a kernel with a promise, at least 29
    /// digits are correct.
    fn dd(&self, promised: bool) -> TokenStream {
        let (count, outputs, arguments) = (self.arguments.len(), self.outputs, &self.arguments);
        let number = quote!(::forms::math::DoubleDouble);
        let name = format_ident!("dd");
        if !promised {
            let docs = format!(" `{}` in double-double arithmetic, of about 31 digits.", self.name);
            return self.scalar(&docs, &name, &number, &quote!(Stable));
        }
        let docs =
            format!(" `{}` in double-double arithmetic, with at least 29 correct digits, or NaN.", self.name);
        let escalate = quote!(::forms::math::escalate_double_double);
        let value = quote!(#escalate::<Stable, #count, #outputs>([#(#arguments),*]));
        self.function(&docs, &name, &number, value)
    }

    /// Emits the function that returns values within the promise, or an error where the promised
    /// accuracy cannot be ensured.
    fn checked(&self, within: f64) -> TokenStream {
        let (count, outputs, arguments) = (self.arguments.len(), self.outputs, &self.arguments);
        let docs = format!(
            " `{}` in `f64`, with an error where the promised accuracy cannot be ensured.",
            self.name
        );
        let result = self.result(&quote!(f64));
        let values = quote! {
            ::forms::math::escalate_checked::<Stable, #count, #outputs>([#(#arguments),*], #within)
        };
        let body = match self.outputs {
            1 => quote!(::core::result::Result::map(#values, |[value]| value)),
            _ => values,
        };
        quote! {
            #[doc = #docs]
            ///
            /// Outside the domain the value is NaN, without an error.
            ///
            /// # Errors
            /// If none of the available precisions bounds the error of a result within the promised
            /// limit (`within`).
            #[inline]
            pub fn checked(
                #(#arguments: f64),*
            ) -> ::core::result::Result<#result, ::forms::math::NotWithin> {
                #body
            }
        }
    }

    /// Emits the stable form of a kernel with a promise, in `f64` and without the promise.
    fn unguarded(&self) -> TokenStream {
        let docs = format!(" `{}` in `f64` by its form alone, without a bound of the error.", self.name);
        self.scalar(&docs, &format_ident!("unguarded"), &quote!(f64), &quote!(Stable))
    }

    /// Emits a function of columns that calls a function of `forms_math`.
    fn batch(&self, Batch { name, function, number, within }: Batch) -> TokenStream {
        let (arguments, count, outputs) = (&self.arguments, self.arguments.len(), self.outputs);
        let how = match name {
            "batch_parallel" => ", on all processors",
            "batch_unguarded" => ", by its form alone, without a bound of the error",
            _ => "",
        };
        let docs = format!(" `{}` of each row of columns of `{number}`s{how}.", self.name);
        let [name, function, number] = [name, function, number].map(|name| format_ident!("{name}"));
        let within = within.map(|within| quote!(, #within));
        // An argument can have this name.
        let output = format_ident!("{}", self.unused("output"));
        let (column, columns) = self.output_columns(&output, &quote!(#number));
        quote! {
            #[doc = #docs]
            ///
            /// # Errors
            /// If the length of a column differs from the first.
            #[inline]
            pub fn #name(
                #(#arguments: &[#number],)*
                #output: #column,
            ) -> ::core::result::Result<(), ::forms::math::LengthMismatch> {
                ::forms::math::#function::<Stable, #count, #outputs>([#(#arguments),*], #columns #within)
            }
        }
    }

    /// Emits a function of the rows of matrices.
    fn batch_rows(&self, within: Option<f64>) -> TokenStream {
        let (count, outputs) = (self.arguments.len(), self.outputs);
        let docs = format!(
            " `{}` of each row of a matrix with a column for each argument; the other matrix gets the values.",
            self.name
        );
        let function = if within.is_some() { "batch_rows_within" } else { "batch_rows" };
        let function = format_ident!("{function}");
        let within = within.map(|within| quote!(, #within));
        quote! {
            #[doc = #docs]
            ///
            /// # Errors
            /// If the matrices have the wrong numbers of columns, or different numbers of rows.
            #[inline]
            pub fn batch_rows(
                arguments: ::forms::rows::ndarray::ArrayView2<'_, f64>,
                outputs: ::forms::rows::ndarray::ArrayViewMut2<'_, f64>,
            ) -> ::core::result::Result<(), ::forms::rows::RowsMismatch> {
                ::forms::rows::#function::<Stable, #count, #outputs>(arguments, outputs #within)
            }
        }
    }

    /// Returns the type of the output columns, and an array of them.
    pub(crate) fn output_columns(&self, output: &Ident, number: &TokenStream) -> (TokenStream, TokenStream) {
        match self.outputs {
            1 => (quote!(&mut [#number]), quote!([#output])),
            outputs => (quote!([&mut [#number]; #outputs]), quote!(#output)),
        }
    }

    /// Returns a name that differs from all arguments.
    pub(crate) fn unused(&self, name: &str) -> String {
        let mut name = name.to_owned();
        while self.arguments.iter().any(|argument| argument == &name) {
            name.push('_');
        }
        name
    }

    /// Emits a function of numbers of one type that evaluates a formula.
    fn scalar(&self, docs: &str, name: &Ident, number: &TokenStream, formula: &TokenStream) -> TokenStream {
        let (arguments, outputs) = (&self.arguments, self.outputs);
        let (count, call) = (arguments.len(), quote!(::forms::math::Formula));
        let value = quote!(<#formula as #call<#count, #outputs>>::value([#(#arguments),*]));
        self.function(docs, name, number, value)
    }

    /// Emits a function of numbers of one type, given an expression for the array of its outputs.
    fn function(&self, docs: &str, name: &Ident, number: &TokenStream, value: TokenStream) -> TokenStream {
        let arguments = &self.arguments;
        let (result, body) = (self.result(number), self.body(value));
        quote! {
            #[doc = #docs]
            #[inline]
            pub fn #name(#(#arguments: #number),*) -> #result {
                #body
            }
        }
    }

    /// Returns the result type of a function: a number, or an array if there are several outputs.
    pub(crate) fn result(&self, number: &TokenStream) -> TokenStream {
        match self.outputs {
            1 => number.clone(),
            outputs => quote!([#number; #outputs]),
        }
    }

    /// Emits the result of a function from an expression for the array of its outputs.
    pub(crate) fn body(&self, value: TokenStream) -> TokenStream {
        match self.outputs {
            1 => quote!(let [value] = #value; value),
            _ => value,
        }
    }
}
