//! The module that accompanies a kernel's function: the same kernel in other precisions, and as
//! written.
//!
//! ```text
//! written ─ emit_formula ─▶ Plain ──┬─▶ plain
//! for f32 ─ emit_formula ─▶ Single ─┼─▶ f32, batch_f32, at_f32, where there is such a form
//! optimised ─ emit_formula ▶ Stable ┴─▶ f32, dd, batch, batch_f32, batch_parallel, batch_rows
//!                                        ├─ with a promise: checked, no_escalation, unguarded, and batches of the last two
//!                                        └─ with arrays: at, at_f32
//! ```
//! If a kernel promises an accuracy, its batch keeps the promise; the `unguarded` functions omit
//! it.
//!
//! Each function is a thin wrapper, compiled only where it is called. Paths are absolute and types
//! have no values of their name, so that neither the user's names nor the kernel's arguments
//! collide with them.

use crate::formulas::Formulas;
use crate::{conversions, shapes};
use forms_core::emission::MANY_ARGUMENTS;
use forms_core::expression::{Shape, Signature};
use forms_core::generation::Generated;
use forms_core::kernel::Program;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

/// Emits `mod NAME { … }` with the tiers and `more` items of the kernel. The error says why Rust
/// cannot parse the generated code.
pub(crate) fn module(
    generated: &Generated,
    more: &TokenStream,
) -> Result<TokenStream, proc_macro2::LexError> {
    let (program, within, promise) = (&generated.optimised, generated.within(), generated.promise);
    let formulas = Formulas::of(generated)?;
    let tiers = Tiers::of(program);
    // more precision brings an approximation no closer to the formula
    let exact = if generated.approximation > 0.0 { quote!(Plain) } else { quote!(Stable) };
    let mut functions = vec![
        tiers.plain(),
        tiers.f32(promise.is_some(), &formulas.single),
        tiers.dd(promise.is_some(), &exact),
    ];
    if let Some(promise) = promise {
        let unescalated = tiers.no_escalation(promise, &exact);
        functions.extend([tiers.checked(promise, &exact), unescalated, tiers.unguarded()]);
    }
    let batches = batches(within, promise, &formulas.single);
    functions.extend(batches.into_iter().map(|batch| tiers.batch(batch)));
    if cfg!(feature = "ndarray") {
        functions.push(tiers.batch_rows(within));
    }
    functions.push(conversions::functions(
        &tiers.name,
        &tiers.signature,
        &tiers.arguments,
        within,
        &formulas.single,
    ));
    let (name, attributes) = (&tiers.name, attributes(program));
    let public = program.is_public().then(|| quote!(pub));
    let about = format!(" `{name}` in every precision.");
    let count = Literal::usize_unsuffixed(operations(program));
    let Formulas { types, .. } = &formulas;
    let module = quote! {
        #[doc = #about]
        #attributes
        #public mod #name {
            #types
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
    let parameters = &program.signature().parameters;
    let names = std::iter::once(program.name()).chain(parameters.iter().map(|parameter| &*parameter.name));
    let case = names
        .flat_map(str::chars)
        .any(char::is_uppercase)
        .then(|| quote!(#[allow(non_snake_case, reason = "the names of the formula")]));
    // A batch has one more argument, its output.
    let many = (parameters.len() + 1 > MANY_ARGUMENTS)
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
    /// Formula that it computes.
    formula: TokenStream,
    /// Promised error bound, in units of 2⁻⁵³.
    within: Option<f64>,
}

/// Lists the batches of a kernel with this promised error bound, if it takes precision to keep it.
fn batches(within: Option<f64>, promise: Option<f64>, single: &TokenStream) -> Vec<Batch<'static>> {
    let batch =
        |name, function, within| Batch { name, function, number: "f64", formula: quote!(Stable), within };
    let [one, all] = match within {
        Some(_) => ["batch_within", "batch_within_parallel"],
        None => ["batch", "batch_parallel"],
    };
    let mut batches = vec![
        batch("batch", one, within),
        Batch {
            name: "batch_f32",
            function: "batch_f32",
            number: "f32",
            formula: single.clone(),
            within: None,
        },
    ];
    if cfg!(feature = "rayon") {
        batches.push(batch("batch_parallel", all, within));
    }
    if let Some(promise) = promise {
        batches.push(batch("batch_no_escalation", "batch_without_escalation", Some(promise)));
        batches.push(batch("batch_unguarded", "batch", None));
    }
    batches
}

/// Common data of the wrappers of one kernel.
pub(crate) struct Tiers {
    pub(crate) name: Ident,
    /// Arguments and results as declared.
    pub(crate) signature: Signature,
    /// Names of all numbers among the arguments.
    pub(crate) arguments: Vec<Ident>,
    /// Number of numbers in the results.
    pub(crate) outputs: usize,
}

impl Tiers {
    pub(crate) fn of(program: &Program) -> Self {
        let identifier = |name: &String| Ident::new(name, Span::call_site());
        Tiers {
            name: format_ident!("{}", program.name()),
            signature: program.signature().clone(),
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
    fn f32(&self, promised: bool, form: &TokenStream) -> TokenStream {
        let promise = if promised {
            ", by its form alone: the accuracy promised by `within` is not ensured"
        } else {
            ""
        };
        let docs = format!(" `{}` in `f32`{promise}.", self.name);
        self.scalar(&docs, &format_ident!("f32"), &quote!(f32), form)
    }

    /// Emits the stable form, or the formula if this form is an approximation, in double-double
    /// arithmetic. For a kernel with a promise, at least 29
    /// digits are correct.
    fn dd(&self, promised: bool, exact: &TokenStream) -> TokenStream {
        let (count, outputs, arguments) = (self.arguments.len(), self.outputs, &self.arguments);
        let number = quote!(::forms::math::DoubleDouble);
        let name = format_ident!("dd");
        if !promised {
            let docs = format!(" `{}` in double-double arithmetic, of about 31 digits.", self.name);
            return self.scalar(&docs, &name, &number, exact);
        }
        let docs =
            format!(" `{}` in double-double arithmetic, with at least 29 correct digits, or NaN.", self.name);
        let escalate = quote!(::forms::math::escalate_double_double);
        let value = quote!(#escalate::<#exact, #count, #outputs>([#(#arguments),*]));
        self.function(&docs, &name, &number, value)
    }

    /// Emits the function that returns values within the promise, or an error where the promised
    /// accuracy cannot be ensured.
    fn checked(&self, within: f64, exact: &TokenStream) -> TokenStream {
        let (count, outputs, arguments) = (self.arguments.len(), self.outputs, &self.arguments);
        let docs = format!(
            " `{}` in `f64`, with an error where the promised accuracy cannot be ensured.",
            self.name
        );
        let result = self.result(&quote!(f64));
        let values = quote! {
            ::forms::math::escalate_checked::<#exact, #count, #outputs>([#(#arguments),*], #within)
        };
        let body = match self.signature.results.as_slice() {
            [Shape::Number] => quote!(::core::result::Result::map(#values, |[value]| value)),
            [Shape::Vector(_)] => values,
            _ if self.signature.has_numbers_only() => values,
            results => {
                let (numbers, value) = shapes::taken_apart(results);
                quote!(::core::result::Result::map(#values, |[#(#numbers),*]| #value))
            }
        };
        let (parameters, unpacked) = self.parameters(&quote!(f64));
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
                #(#parameters),*
            ) -> ::core::result::Result<#result, ::forms::math::NotWithin> {
                #unpacked
                #body
            }
        }
    }

    /// Emits the function that returns the values within the promise that `f64` decides.
    fn no_escalation(&self, within: f64, exact: &TokenStream) -> TokenStream {
        let (count, outputs, arguments) = (self.arguments.len(), self.outputs, &self.arguments);
        let docs = format!(
            " `{}` within its promised error where `f64` shows that bound, and NaN where more precision is needed.",
            self.name
        );
        let one = quote!(::forms::math::without_escalation);
        let value = quote!(#one::<#exact, #count, #outputs>([#(#arguments),*], #within));
        self.function(&docs, &format_ident!("no_escalation"), &quote!(f64), value)
    }

    /// Emits the stable form of a kernel with a promise, in `f64` and without the promise.
    fn unguarded(&self) -> TokenStream {
        let docs = format!(" `{}` in `f64` by its form alone, without a bound of the error.", self.name);
        self.scalar(&docs, &format_ident!("unguarded"), &quote!(f64), &quote!(Stable))
    }

    /// Emits a function of columns that calls a function of `forms_math`.
    fn batch(&self, Batch { name, function, number, formula, within }: Batch) -> TokenStream {
        let (arguments, count, outputs) = (&self.arguments, self.arguments.len(), self.outputs);
        let how = match name {
            "batch_parallel" => ", on all processors",
            "batch_no_escalation" => ", NaN where `f64` does not show the promised bound",
            "batch_unguarded" => ", by its form alone, without a bound of the error",
            _ => "",
        };
        let docs = format!(" `{}` of each row of columns of `{number}`s{how}.", self.name);
        let [name, function, number] = [name, function, number].map(|name| format_ident!("{name}"));
        let within = within.map(|within| quote!(, #within));
        // An argument can have this name.
        let output = format_ident!("{}", self.unused("output"));
        let (column, columns) = self.output_columns(&output, &quote!(#number));
        let (parameters, unpacked) = self.parameters(&quote!(&[#number]));
        quote! {
            #[doc = #docs]
            ///
            /// # Errors
            /// If the length of a column differs from the first.
            #[inline]
            pub fn #name(
                #(#parameters,)*
                #output: #column,
            ) -> ::core::result::Result<(), ::forms::math::LengthMismatch> {
                #unpacked
                ::forms::math::#function::<#formula, #count, #outputs>([#(#arguments),*], #columns #within)
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
        let column = quote!(&mut [#number]);
        let results = &self.signature.results;
        let columns = match results.as_slice() {
            [Shape::Number] => quote!([#output]),
            [Shape::Vector(_)] => quote!(#output),
            _ if self.signature.has_numbers_only() => quote!(#output),
            results => {
                let (numbers, pattern) = shapes::taken_apart(results);
                quote!({ let #pattern = #output; [#(#numbers),*] })
            }
        };
        (shapes::result_type(results, &column), columns)
    }

    /// Returns the declarations of the parameters with elements of one type, and the statements
    /// that take arrays apart.
    pub(crate) fn parameters(&self, number: &TokenStream) -> (Vec<TokenStream>, TokenStream) {
        (shapes::parameters(&self.signature, number), shapes::unpacked(&self.signature))
    }

    /// Returns a name that differs from all arguments.
    pub(crate) fn unused(&self, name: &str) -> String {
        let mut name = name.to_owned();
        let parameters = &self.signature.parameters;
        while self.arguments.iter().any(|argument| argument == &name)
            || parameters.iter().any(|parameter| parameter.name == name)
        {
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
        let (result, body) = (self.result(number), self.body(value));
        let (parameters, unpacked) = self.parameters(number);
        quote! {
            #[doc = #docs]
            #[inline]
            pub fn #name(#(#parameters),*) -> #result {
                #unpacked
                #body
            }
        }
    }

    /// Returns the result type of a function: a number, an array, or a tuple of both.
    pub(crate) fn result(&self, number: &TokenStream) -> TokenStream {
        shapes::result_type(&self.signature.results, number)
    }

    /// Emits the result of a function from an expression for the array of its outputs.
    pub(crate) fn body(&self, value: TokenStream) -> TokenStream {
        shapes::results_of_array(&self.signature.results, value)
    }
}
