//! Specialisations of a kernel with effects: variants of the kernel without some of its effects,
//! selected at run time.
//!
//! ```text
//! kernel ─ specialisations ─ rules ─ generate ─▶ With<false, true>, … ─▶ Effects::of, with, batch_with
//! ```
//! Each member is compiled separately: its code does not contain the absent effects.

use crate::formulas::MATH;
use crate::shapes::nested_type;
use crate::tiers::{Tiers, operations};
use forms_core::compile::compile_kernel;
use forms_core::diagnostic::Diagnostic;
use forms_core::emission::emit_formula;
use forms_core::expression::{Pool, Signature};
use forms_core::generation::{Generated, specialisations};
use forms_core::kernel::{KernelSource, Program, lower};
use forms_core::notation::results;
use forms_core::theory::Kernel;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

/// Member of the lattice of specialisations.
struct Member {
    /// Whether each effect is present.
    present: Vec<bool>,
    formula: String,
    generated: Generated,
}

/// Emits the items for a kernel's module; none for a kernel without effects.
///
/// # Errors
/// If a specialisation cannot be generated, or is not a kernel.
pub(crate) fn items(
    pool: &mut Pool,
    kernel: &Kernel,
    full: &Generated,
) -> Result<TokenStream, Vec<Diagnostic>> {
    if kernel.effects.is_empty() {
        return Ok(TokenStream::new());
    }
    let all = vec![true; kernel.effects.len()];
    let mut members = vec![Member { present: all, formula: formula(kernel), generated: full.clone() }];
    for specialisation in specialisations(pool, kernel)? {
        let special = &specialisation.kernel;
        let generated = compile_kernel(pool, special)?;
        members.push(Member { present: specialisation.present, formula: formula(special), generated });
    }
    let unreadable = |error: proc_macro2::LexError| {
        let message =
            format!("the kernels generated for the effects of `{}` cannot be read: {error}", kernel.name);
        vec![Diagnostic::new(kernel.span, message)]
    };
    let conditions = conditions(pool, kernel).map_err(|diagnostic| vec![diagnostic])?;
    let conditions = emit_formula(&conditions, "Conditions", MATH).parse().map_err(unreadable)?;
    let lattice = Lattice { kernel, tiers: Tiers::of(&full.optimised), members };
    Ok(lattice.items(conditions, lattice.formulas().map_err(unreadable)?))
}

fn formula(kernel: &Kernel) -> String {
    results(&kernel.formula, &kernel.signature.results)
}

/// Builds one output per effect that is zero where the effect is inactive: the controlling argument
/// minus the value that switches the effect off.
fn conditions(pool: &mut Pool, kernel: &Kernel) -> Result<Program, Diagnostic> {
    let difference = |effect: &forms_core::theory::Effect| {
        let variable = pool.symbol(effect.variable);
        pool.subtract(variable, effect.value)
    };
    let outputs = kernel.effects.iter().map(difference).collect();
    let source = KernelSource {
        name: kernel.name.clone(),
        arguments: kernel.arguments.clone(),
        outputs,
        ..KernelSource::default()
    };
    lower(pool, &source).map_err(|error| Diagnostic::new(kernel.span, error.to_string()))
}

struct Lattice<'a> {
    kernel: &'a Kernel,
    tiers: Tiers,
    members: Vec<Member>,
}

impl Lattice<'_> {
    fn items(&self, conditions: TokenStream, formulas: TokenStream) -> TokenStream {
        let effects = self.effects();
        let (with, choice) = (self.with(), [self.choice(), self.batch_choice()]);
        quote! {
            #effects
            enum Conditions {}
            #conditions
            #with
            #formulas
            #(#choice)*
        }
    }

    /// Returns the effects as field names.
    fn fields(&self) -> Vec<Ident> {
        self.kernel.effects.iter().map(|effect| identifier(&effect.name)).collect()
    }

    /// Returns the effects as names of const parameters.
    fn parameters(&self) -> Vec<Ident> {
        self.kernel.effects.iter().map(|effect| format_ident!("{}", effect.name.to_uppercase())).collect()
    }

    /// Emits `struct Effects`.
    fn effects(&self) -> TokenStream {
        let (fields, arguments) = (self.fields(), &self.tiers.arguments);
        let (declared, unpacked) = self.tiers.parameters(&quote!(f64));
        let (count, kinds) = (arguments.len(), fields.len());
        let docs = format!(" The effects of `{}`, each on or off.", self.kernel.name);
        let field_docs =
            self.kernel.effects.iter().map(|effect| format!(" Whether `{}` is on.", effect.name));
        let patterns = self.members.iter().map(|member| &member.present);
        let operations = self
            .members
            .iter()
            .map(|member| Literal::usize_unsuffixed(operations(&member.generated.optimised)));
        let patterns: Vec<TokenStream> = patterns.map(|present| quote!((#(#present,)*))).collect();
        let differences: Vec<Ident> = (0..kinds).map(|place| format_ident!("difference{place}")).collect();
        quote! {
            #[doc = #docs]
            #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
            pub struct Effects {
                #(#[doc = #field_docs] pub #fields: bool,)*
            }
            impl Effects {
                /// All effects on.
                pub const ALL: Self = Self { #(#fields: true,)* };
                /// All effects off.
                pub const NONE: Self = Self { #(#fields: false,)* };
                /// Returns the effects that these arguments need: an effect is off where the kernel
                /// has the same value without it.
                #[inline]
                pub fn of(#(#declared),*) -> Self {
                    #unpacked
                    let [#(#differences),*] =
                        <Conditions as ::forms::math::Formula<#count, #kinds>>::value([#(#arguments),*]);
                    Self { #(#fields: #differences != 0.0,)* }
                }
                /// Returns the number of operations per value with these effects.
                pub const fn operations(self) -> usize {
                    match (#(self.#fields,)*) {
                        #(#patterns => #operations,)*
                    }
                }
            }
        }
    }

    /// Emits the type `With` of the members.
    fn with(&self) -> TokenStream {
        let parameters = self.parameters();
        let docs = self.members.iter().map(|member| format!(" - {}", self.account(member)));
        let head = format!(" `{}` with some of its effects, for any number type:", self.kernel.name);
        quote! {
            #[doc = #head]
            #[doc = ""]
            #(#[doc = #docs])*
            pub enum With<#(const #parameters: bool),*> {}
        }
    }

    /// Describes a member in one line.
    fn account(&self, member: &Member) -> String {
        let absent: Vec<String> = self
            .kernel
            .effects
            .iter()
            .zip(&member.present)
            .filter(|(_, present)| !**present)
            .map(|(effect, _)| format!("`{}`", effect.name))
            .collect();
        let what = if absent.is_empty() {
            "with all effects".to_string()
        } else {
            format!("without {}", absent.join(" and "))
        };
        let (formula, count) = (&member.formula, member.generated.optimised.operations());
        format!("{what}: `{formula}`; {count}. {}", member.generated.account())
    }

    /// Emits the formulas of the members.
    fn formulas(&self) -> Result<TokenStream, proc_macro2::LexError> {
        let mut formulas = TokenStream::new();
        for member in &self.members {
            let present: Vec<String> = member.present.iter().map(bool::to_string).collect();
            let name = format!("With<{}>", present.join(", "));
            formulas.extend(emit_formula(&member.generated.optimised, &name, MATH).parse::<TokenStream>()?);
        }
        Ok(formulas)
    }

    /// Emits `fn with`, which selects the function of single values.
    fn choice(&self) -> TokenStream {
        let Tiers { name, signature, arguments, outputs } = &self.tiers;
        let (count, result) = (arguments.len(), self.tiers.result(&quote!(f64)));
        let docs =
            format!(" `{name}` with these effects; effects that are off are not in the function's code.");
        let parameters = self.parameters();
        let number = quote!(f64);
        let types = argument_types(signature, &number);
        let (declared, unpacked) = self.tiers.parameters(&number);
        let value = match self.members[0].generated.within() {
            Some(within) => {
                quote!(::forms::math::escalate::<With<#(#parameters),*>, #count, #outputs>([#(#arguments),*], #within))
            }
            None => {
                quote!(<With<#(#parameters),*> as ::forms::math::Formula<#count, #outputs>>::value([#(#arguments),*]))
            }
        };
        let body = self.tiers.body(value);
        let (fields, choices) = (self.fields(), self.choices("value"));
        quote! {
            #[doc = #docs]
            #[inline]
            pub fn with(effects: Effects) -> fn(#(#types),*) -> #result {
                fn value<#(const #parameters: bool),*>(#(#declared),*) -> #result
                where
                    With<#(#parameters),*>: ::forms::math::Formula<#count, #outputs>,
                {
                    #unpacked
                    #body
                }
                match (#(effects.#fields,)*) { #choices }
            }
        }
    }

    /// Emits `fn batch_with`, which selects the function of columns.
    fn batch_choice(&self) -> TokenStream {
        let Tiers { name, signature, arguments, outputs } = &self.tiers;
        let count = arguments.len();
        let docs = format!(" `{name}` of each row of columns with these effects.");
        let parameters = self.parameters();
        let output = format_ident!("{}", self.tiers.unused("output"));
        let (column, columns) = self.tiers.output_columns(&output, &quote!(f64));
        let error = quote!(::core::result::Result<(), ::forms::math::LengthMismatch>);
        let inputs = argument_types(signature, &quote!(&[f64]));
        let (declared, unpacked) = self.tiers.parameters(&quote!(&[f64]));
        let (function, within) = match self.members[0].generated.within() {
            Some(within) => (quote!(batch_within), quote!(, #within)),
            None => (quote!(batch), quote!()),
        };
        let (fields, choices) = (self.fields(), self.choices("values"));
        quote! {
            #[doc = #docs]
            #[inline]
            pub fn batch_with(effects: Effects) -> fn(#(#inputs,)* #column) -> #error {
                fn values<#(const #parameters: bool),*>(#(#declared,)* #output: #column) -> #error
                where
                    With<#(#parameters),*>: ::forms::math::Formula<#count, #outputs>,
                {
                    #unpacked
                    ::forms::math::#function::<With<#(#parameters),*>, #count, #outputs>(
                        [#(#arguments),*], #columns #within
                    )
                }
                match (#(effects.#fields,)*) { #choices }
            }
        }
    }

    /// Emits the match arms that select a function by its effects.
    fn choices(&self, function: &str) -> TokenStream {
        let function = format_ident!("{function}");
        let arms = self.members.iter().map(|member| {
            let present = &member.present;
            quote!((#(#present,)*) => #function::<#(#present),*>,)
        });
        quote!(#(#arms)*)
    }
}

/// Returns the types of the arguments with elements of one type.
fn argument_types(signature: &Signature, number: &TokenStream) -> Vec<TokenStream> {
    signature.parameters.iter().map(|parameter| nested_type(parameter.shape, number)).collect()
}

/// Converts a name of the language to a Rust identifier; a Rust keyword becomes a raw identifier.
fn identifier(name: &str) -> Ident {
    syn::parse_str::<Ident>(name).unwrap_or_else(|_| Ident::new_raw(name, Span::call_site()))
}
