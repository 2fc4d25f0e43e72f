//! Units: the unit of every expression of a source, and errors where different units meet.
//!
//! ```text
//! ast::File ─ reading ─▶ Unit of each declared name
//!    │                        │
//!    └─ inference ─▶ Quantity of each expression ─ agreement ─▶ diagnostics, units of kernels
//! ```
//! The pass runs after resolution, over the syntax tree, and only if a source states a unit. A name
//! without a unit is unchecked; a number has the unit 1. The conventions, including those for
//! angles, are in docs/conventions.md.

mod agreement;
mod calls;
mod declarations;
mod inference;
mod kernels;
mod metric;
mod quantity;
mod reading;
mod table;
mod unit;

use crate::diagnostic::{Diagnostic, Span};
use crate::expression::Parameter;
use crate::resolve::Trace;
use crate::syntax::ast::{Declared, File, ItemKind};
use crate::theory::{Kernel, KernelUnits, Theory};

/// Whether a source states any unit.
pub(crate) fn are_stated(file: &File) -> bool {
    let any = |declared: &[Declared]| declared.iter().any(|declared| declared.unit.is_some());
    file.items.iter().any(|item| match &item.kind {
        ItemKind::Chart { coordinates, .. } => any(coordinates),
        ItemKind::Param { names, .. } => any(names),
        ItemKind::Function { unit, .. } | ItemKind::Let { unit, .. } | ItemKind::Form { unit, .. } => {
            unit.is_some()
        }
        ItemKind::Kernel { arguments, units, .. } => any(arguments) || !units.is_empty(),
        ItemKind::Warp(warp) => any(&warp.parameters) || any(&warp.uniforms),
        _ => false,
    })
}

/// Units inferred for a source.
struct Inferred {
    errors: Vec<Diagnostic>,
    /// Units of named values, by their indices.
    objects: Vec<(usize, String)>,
    /// Units of kernels, by their names.
    kernels: Vec<(String, KernelUnits)>,
    /// Places of the statements that contain unit errors: these statements are not decided.
    meaningless: Vec<Span>,
}

/// Checks the units of a source that was resolved to this theory and trace, and writes the units
/// into the theory.
pub(crate) fn check(file: &File, theory: &mut Theory, trace: &Trace) -> Vec<Diagnostic> {
    let mut inference = inference::Inference::new(theory, trace);
    for item in &file.items {
        inference.item(item);
    }
    let Inferred { errors, objects, kernels, meaningless } = inference.finish();
    theory.statements.retain(|statement| !meaningless.contains(&statement.span));
    for (number, unit) in objects {
        theory.objects[number].unit = Some(unit);
    }
    for (name, units) in kernels {
        if let Some(kernel) = theory.kernels.iter_mut().find(|kernel| kernel.name == name) {
            kernel.units = units;
        }
    }
    errors
}

/// Returns the units of the results of a kernel: one for an array whose entries have the same.
fn units_of_results(kernel: &Kernel) -> Vec<Option<String>> {
    let (mut rest, mut units) = (kernel.units.outputs.as_slice(), Vec::new());
    for shape in &kernel.signature.results {
        let (own, others) = rest.split_at(shape.entries().min(rest.len()));
        rest = others;
        match own {
            [first, others @ ..] if others.iter().all(|unit| unit == first) => units.push(first.clone()),
            several => units.extend_from_slice(several),
        }
    }
    units
}

/// Describes the units of a kernel in a sentence: "Units: `r2` in `m**2`, `cos_theta` in `1`;
/// result in `sr/m**2`."; `None` if no unit is known.
pub fn sentence(kernel: &Kernel) -> Option<String> {
    let mut first = 0;
    let known = |parameter: &Parameter| {
        let unit = kernel.units.arguments.get(first).and_then(Option::as_ref);
        first += parameter.shape.entries();
        Some(format!("`{}` in `{}`", parameter.name, unit?))
    };
    let arguments: Vec<String> = kernel.signature.parameters.iter().filter_map(known).collect();
    let quoted = |unit: &Option<String>| Some(format!("`{}`", unit.as_ref()?));
    let outputs: Option<Vec<String>> = units_of_results(kernel).iter().map(quoted).collect();
    let results = match outputs.as_deref() {
        None | Some([]) => None,
        Some([unit]) => Some(format!("result in {unit}")),
        Some(several) => Some(format!("results in {}", several.join(", "))),
    };
    let given = (!arguments.is_empty()).then(|| arguments.join(", "));
    let parts: Vec<String> = given.into_iter().chain(results).collect();
    (!parts.is_empty()).then(|| format!("Units: {}.", parts.join("; ")))
}
