//! Functions of a kernel with arrays whose arguments and results are types of other crates.
//!
//! ```text
//! k::at(p: impl IntoArray<[f64; 3]>, t: f64) -> impl FromArray<[[f64; 3]; 3]>
//! ```
//! The traits are those of `forms::arrays`; the caller chooses the type of each result.

use crate::shapes::{nested_type, taken_apart, unpacked};
use forms_core::expression::{Parameter, Shape, Signature};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// Emits `at` and `at_f32` of a kernel, given the names of all numbers among its arguments and the
/// formula computed in `f32`; nothing for a kernel without arrays.
pub(crate) fn functions(
    kernel: &Ident,
    signature: &Signature,
    arguments: &[Ident],
    within: Option<f64>,
    single: &TokenStream,
) -> TokenStream {
    let shapes = signature.parameters.iter().map(|parameter| &parameter.shape);
    if shapes.chain(&signature.results).all(|&shape| shape == Shape::Number) {
        return TokenStream::new();
    }
    let outputs: usize = signature.results.iter().map(|shape| shape.entries()).sum();
    let count = arguments.len();
    let trait_of_formula = quote!(::forms::math::Formula<#count, #outputs>);
    let value = |formula: &TokenStream| quote!(<#formula as #trait_of_formula>::value([#(#arguments),*]));
    let (stable, of_single) = (value(&quote!(Stable)), value(single));
    let promised = within.map(
        |within| quote!(::forms::math::escalate::<Stable, #count, #outputs>([#(#arguments),*], #within)),
    );
    let double = function(kernel, signature, "at", &quote!(f64), promised.as_ref().unwrap_or(&stable));
    let single = function(kernel, signature, "at_f32", &quote!(f32), &of_single);
    quote!(#double #single)
}

/// Emits one function, given an expression for the array of all numbers in its results.
fn function(
    kernel: &Ident,
    signature: &Signature,
    name: &str,
    number: &TokenStream,
    values: &TokenStream,
) -> TokenStream {
    let docs = format!(" `{kernel}` in `{number}`, with vectors and matrices of any crate as arrays.");
    let name = format_ident!("{name}");
    let declared = |Parameter { name, shape }: &Parameter| {
        let (name, array) = (Ident::new(name, Span::call_site()), nested_type(*shape, number));
        match shape {
            Shape::Number => quote!(#name: #array),
            _ => quote!(#name: impl ::forms::arrays::IntoArray<#array>),
        }
    };
    let parameters = signature.parameters.iter().map(declared);
    let arrays = signature.parameters.iter().filter(|parameter| parameter.shape != Shape::Number);
    let arrays = arrays.map(|parameter| Ident::new(&parameter.name, Span::call_site()));
    let results = Results::of(signature, number);
    let (types, bounds, value) = (&results.types, &results.bounds, &results.value);
    let (numbers, unpacked) = (&results.numbers, unpacked(signature));
    quote! {
        #[doc = #docs]
        ///
        /// A matrix is converted by its rows and columns, not by its order in memory.
        #[inline]
        pub fn #name<#bounds>(#(#parameters),*) -> #types {
            #(let #arrays = ::forms::arrays::IntoArray::into_array(#arrays);)*
            #unpacked
            let [#(#numbers),*] = #values;
            #value
        }
    }
}

/// Results of a function: several numbers are one array, and every array is of a type that the
/// caller chooses.
struct Results {
    /// Type parameters with their bounds.
    bounds: TokenStream,
    types: TokenStream,
    /// Names of all numbers in the results.
    numbers: Vec<Ident>,
    /// The results, made of these.
    value: TokenStream,
}

impl Results {
    fn of(signature: &Signature, number: &TokenStream) -> Self {
        let results = &signature.results;
        let (numbers, assembled) = taken_apart(results);
        let is_one_array = results.len() > 1 && signature.has_numbers_only();
        let shapes = if is_one_array { vec![Shape::Vector(results.len())] } else { results.clone() };
        let (mut bounds, mut types, mut parts, mut values) = (vec![], vec![], vec![], vec![]);
        for (place, shape) in shapes.iter().enumerate() {
            let part = format_ident!("part{place}");
            if *shape == Shape::Number {
                types.push(number.clone());
                values.push(quote!(#part));
            } else {
                let (name, array) = (format_ident!("Value{place}"), nested_type(*shape, number));
                bounds.push(quote!(#name: ::forms::arrays::FromArray<#array>));
                types.push(quote!(#name));
                values.push(quote!(::forms::arrays::FromArray::from_array(#part)));
            }
            parts.push(quote!(#part));
        }
        let [pattern, values, types] = [&parts, &values, &types].map(|parts| one_or_tuple(parts));
        Results {
            bounds: quote!(#(#bounds),*),
            types,
            numbers,
            value: quote!(let #pattern = #assembled; #values),
        }
    }
}

fn one_or_tuple(parts: &[TokenStream]) -> TokenStream {
    match parts {
        [one] => one.clone(),
        several => quote!((#(#several),*)),
    }
}
