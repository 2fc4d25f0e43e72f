//! Arguments and results of generated functions in their declared shapes.
//!
//! The functions of `forms_math` take all numbers in one array, and return all numbers in one. A
//! wrapper takes arrays apart by `let [p_0, p_1] = p;` and puts results together.

use forms_core::expression::{Parameter, Shape, Signature};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// Returns the type of nested arrays with elements of one type.
pub(crate) fn nested_type(shape: Shape, number: &TokenStream) -> TokenStream {
    shape.extents().into_iter().rev().fold(number.clone(), |element, extent| quote!([#element; #extent]))
}

/// Puts parts together in the shape: `a`, `[a, b]`, `[[a, b], [c, d]]`.
fn nested(shape: Shape, parts: &[Ident]) -> TokenStream {
    match shape {
        Shape::Number => quote!(#(#parts)*),
        Shape::Vector(_) => quote!([#(#parts),*]),
        Shape::Matrix(_, columns) => {
            let rows = parts.chunks(columns).map(|row| quote!([#(#row),*]));
            quote!([#(#rows),*])
        }
    }
}

/// Puts the parts of several results together: one as it is, several numbers in an array, results
/// with arrays among them in a tuple.
fn assembled(results: &[Shape], parts: &[Ident]) -> TokenStream {
    let mut rest = parts;
    let mut next = |shape: &Shape| {
        let (own, others) = rest.split_at(shape.entries());
        rest = others;
        nested(*shape, own)
    };
    let values: Vec<TokenStream> = results.iter().map(&mut next).collect();
    match results {
        [_] => quote!(#(#values)*),
        several if are_numbers(several) => quote!([#(#values),*]),
        _ => quote!((#(#values),*)),
    }
}

fn are_numbers(results: &[Shape]) -> bool {
    results.iter().all(|&shape| shape == Shape::Number)
}

/// Returns the type of several results.
pub(crate) fn result_type(results: &[Shape], number: &TokenStream) -> TokenStream {
    let types = results.iter().map(|&shape| nested_type(shape, number));
    match results {
        [_] => quote!(#(#types)*),
        several if are_numbers(several) => {
            let count = several.len();
            quote!([#number; #count])
        }
        _ => quote!((#(#types),*)),
    }
}

/// Emits the results from an expression for the array of all numbers in them.
pub(crate) fn results_of_array(results: &[Shape], array: TokenStream) -> TokenStream {
    match results {
        [Shape::Number] => quote!(let [value] = #array; value),
        [Shape::Vector(_)] => array,
        several if are_numbers(several) => array,
        shapes => {
            let (numbers, value) = taken_apart(shapes);
            quote!(let [#(#numbers),*] = #array; #value)
        }
    }
}

/// Returns names for all numbers in the results, and the results made of them.
pub(crate) fn taken_apart(results: &[Shape]) -> (Vec<Ident>, TokenStream) {
    let count: usize = results.iter().map(|shape| shape.entries()).sum();
    let numbers: Vec<Ident> = (0..count).map(|place| format_ident!("value{place}")).collect();
    let value = assembled(results, &numbers);
    (numbers, value)
}

/// Emits the declarations of the parameters with elements of one type.
pub(crate) fn parameters(signature: &Signature, number: &TokenStream) -> Vec<TokenStream> {
    let declared = |Parameter { name, shape }: &Parameter| {
        let (name, number) = (Ident::new(name, Span::call_site()), nested_type(*shape, number));
        quote!(#name: #number)
    };
    signature.parameters.iter().map(declared).collect()
}

/// Emits the statements that take arrays among the arguments apart.
pub(crate) fn unpacked(signature: &Signature) -> TokenStream {
    let unpack = |Parameter { name, shape }: &Parameter| {
        let entries: Vec<Ident> =
            shape.names(name).iter().map(|entry| Ident::new(entry, Span::call_site())).collect();
        let (name, pattern) = (Ident::new(name, Span::call_site()), nested(*shape, &entries));
        (*shape != Shape::Number).then(|| quote!(let #pattern = #name;))
    };
    signature.parameters.iter().filter_map(unpack).collect()
}
