//! `forms kernels`: lists the kernels of the library with arguments, units and formulas.

use crate::kernel::library;
use crate::layout::wrap;
use crate::palette::Palette;
use crate::status::Status;
use crate::theory_file::{TheoryFile, complain};
use forms::core::expression::Parameter;
use forms::core::notation::{simplify_expression, text};
use forms::core::theory::{Kernel, KernelUnits, Value};
use std::io::{self, Write};

/// Indent of descriptions.
const INDENT: usize = 4;
/// Longest formula in the list; for longer ones the list refers to `forms show`.
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
    for line in wrap(&signature(kernel), INDENT) {
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

/// Formats the arguments and the results with their units: `of r2 [m**2], cos_theta [1], in
/// sr/m**2`.
fn signature(kernel: &Kernel) -> String {
    let KernelUnits { arguments: units, outputs } = &kernel.units;
    let mut place = 0;
    let mut argument = |parameter: &Parameter| {
        let unit = units.get(place).and_then(Option::as_deref);
        place += parameter.shape.entries();
        match unit {
            Some(unit) => format!("{parameter} [{unit}]"),
            None => parameter.to_string(),
        }
    };
    let arguments: Vec<String> = kernel.signature.parameters.iter().map(&mut argument).collect();
    let outputs: Option<Vec<&str>> = outputs.iter().map(Option::as_deref).collect();
    let results = match outputs.as_deref() {
        None | Some([]) => String::new(),
        Some(units) => format!(", in {}", units.join(", ")),
    };
    format!("of {}{results}", arguments.join(", "))
}
