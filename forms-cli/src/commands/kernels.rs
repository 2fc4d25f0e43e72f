//! `forms kernels`: what the library computes, with arguments, units and formulas.

use crate::kernel::library;
use crate::layout::wrap;
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{TheoryFile, complain};
use forms::core::notation::{simplify_expression, text};
use forms::core::resolve::{Kernel, Value};
use forms::core::syntax::ast::{Declared, ItemKind};
use std::io::{self, Write};

/// Where descriptions begin.
const INDENT: usize = 4;
/// Longer formulas are left to `forms show`.
const LONGEST_FORMULA: usize = 160;

/// Prints the library's kernels.
pub(crate) fn kernels(output: &mut dyn Write) -> io::Result<Status> {
    let palette = Palette::of_output();
    let mut files = match library() {
        Ok(files) => files,
        Err(errors) => {
            complain(&errors);
            return Ok(Status::Error);
        }
    };
    for file in &mut files {
        for kernel in file.theory.kernels.clone() {
            describe(file, &kernel, palette, output)?;
        }
    }
    writeln!(output, "{}", palette.quiet("forms eval - NAME reads CSV with these arguments."))?;
    Ok(Status::AsStated)
}

fn describe(
    file: &mut TheoryFile,
    kernel: &Kernel,
    palette: Palette,
    output: &mut dyn Write,
) -> io::Result<()> {
    writeln!(output, "{}", palette.heading(&kernel.name))?;
    for line in wrap(&kernel.docs.join(" "), INDENT) {
        writeln!(output, "{line}")?;
    }
    for line in wrap(&signature(file, kernel), INDENT) {
        writeln!(output, "{}", palette.quiet(&line))?;
    }
    for &formula in &kernel.outputs {
        let simplified = simplify_expression(&mut file.theory.pool, &[], formula);
        let formula = text(&file.theory, &Value::Scalar(simplified));
        let formula = if formula.len() <= LONGEST_FORMULA {
            format!("= {formula}")
        } else {
            format!("= … (forms show - {})", kernel.name)
        };
        for line in wrap(&formula, INDENT) {
            writeln!(output, "{line}")?;
        }
    }
    writeln!(output)
}

/// The arguments with their units as they were written: `r2 [m**2], cos_theta [1]`.
fn signature(file: &TheoryFile, kernel: &Kernel) -> String {
    let arguments = file.tree.items.iter().find_map(|item| match &item.kind {
        ItemKind::Kernel { name, arguments, .. } if name.text == kernel.name => Some(arguments),
        _ => None,
    });
    let argument = |declared: &Declared| match &declared.unit {
        Some(unit) => {
            let span = unit.span;
            let unit = file.source.text.get(span.start as usize..span.end as usize).unwrap_or_default();
            format!("{}\u{a0}[{unit}]", declared.name.text)
        }
        None => declared.name.text.clone(),
    };
    let arguments: Vec<String> = arguments.into_iter().flatten().map(argument).collect();
    format!("of {}", arguments.join(", ")).replace('\u{a0}', " ")
}
