//! Places and formulas of a text, in the format of the page.

use super::{Diagnostics, Told};
use crate::json::write_record;
use crate::theory_file::{FileError, TheoryFile, characters};
use forms::core::check::read_file;
use forms::core::diagnostic::Span;
use forms::core::syntax::Source;
use forms::core::syntax::ast::File;
use forms_book::{LONGEST_FORMULA, display};
use serde::Serialize;
use std::io::{self, Write};

/// Place in a text: line and column from 1; column and length are in characters.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(super) struct Place {
    line: usize,
    column: usize,
    length: usize,
}

impl Place {
    pub(super) fn of(source: &Source, span: Span) -> Self {
        let start = source.position(span.start);
        Place { line: start.line, column: start.column, length: characters(source, span) }
    }
}

/// Reads a text. If it has errors, they are written and the result is `None`.
pub(super) fn read(text: &str, output: &mut dyn Write) -> io::Result<Option<(File, TheoryFile)>> {
    let source = Source::new("the editor", text);
    let (file, theory, diagnostics) = read_file(text);
    if diagnostics.is_empty() {
        return Ok(Some((file, TheoryFile { source, theory, warning: None })));
    }
    let errors: Vec<FileError> = diagnostics.iter().map(|error| FileError::at(&source, error)).collect();
    tell(&errors, output)?;
    Ok(None)
}

/// Writes errors.
pub(super) fn tell(errors: &[FileError], output: &mut dyn Write) -> io::Result<()> {
    let told = |error: &FileError| Told {
        place: Place { line: error.line, column: error.column, length: error.length },
        message: error.message.clone(),
        help: error.help.clone(),
    };
    write_record(output, &Diagnostics { diagnostics: errors.iter().map(told).collect() })
}

/// Converts a formula to a `<math>` element, unless it is too long or cannot be written in MathML.
pub(super) fn mathml(latex: &str) -> Option<String> {
    (latex.len() <= LONGEST_FORMULA).then(|| display(latex).ok()).flatten()
}
