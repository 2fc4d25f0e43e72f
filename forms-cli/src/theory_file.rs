//! Theory files: reads a file as a theory, or returns all of its errors.

use crate::streams::tell;
use forms::core::check::read_theory;
use forms::core::diagnostic::{Diagnostic, Span};
use forms::core::stability::{Choices, EXTENSION};
use forms::core::syntax::Source;
use forms::core::theory::Theory;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Limit of the file size, in bytes.
const LARGEST_FILE: u64 = 16 << 20;

/// File without errors.
#[derive(Clone)]
pub(crate) struct TheoryFile {
    pub(crate) source: Source,
    pub(crate) theory: Theory,
    /// Warning about the forms chosen for its kernels.
    pub(crate) warning: Option<String>,
}

/// Error with its place and its rendered message.
pub(crate) struct FileError {
    pub(crate) file: String,
    pub(crate) line: usize,
    pub(crate) column: usize,
    /// Number of characters at the place of the error.
    pub(crate) length: usize,
    pub(crate) message: String,
    pub(crate) help: Option<String>,
    pub(crate) shown: String,
}

impl FileError {
    /// Creates an error at a place of a text.
    pub(crate) fn at(source: &Source, diagnostic: &Diagnostic) -> Self {
        let position = source.position(diagnostic.span.start);
        FileError {
            file: source.name.clone(),
            line: position.line,
            column: position.column,
            length: characters(source, diagnostic.span),
            message: diagnostic.message.clone(),
            help: diagnostic.help.clone(),
            shown: source.render(diagnostic),
        }
    }

    /// Creates an error of a whole file, reported at its first character.
    fn of_file(file: &str, message: String) -> Self {
        let shown = format!("error: {message}\n --> {file}\n");
        FileError { file: file.to_string(), line: 1, column: 1, length: 0, message, help: None, shown }
    }
}

/// Returns the number of characters in a range of a text.
pub(crate) fn characters(source: &Source, span: Span) -> usize {
    source.text.get(span.start as usize..span.end as usize).map_or(0, |text| text.chars().count())
}

/// Reads a file from disk.
pub(crate) fn read(path: &str) -> Result<TheoryFile, Vec<FileError>> {
    let bytes = bytes(path).map_err(|message| vec![FileError::of_file(path, message)])?;
    match String::from_utf8(bytes) {
        Ok(text) => {
            let mut file = from_text(path, text)?;
            let beside = choices_beside(path);
            if beside.is_file() {
                let name = beside.to_string_lossy().into_owned();
                let text = text_of_choices(&name)?;
                file.choose(&name, text)?;
            }
            Ok(file)
        }
        Err(error) => {
            let valid = error.utf8_error().valid_up_to();
            let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
            let place = u32::try_from(valid).unwrap_or(u32::MAX);
            let message = "the file is not UTF-8 text: this byte is invalid";
            let diagnostic = Diagnostic::new(Span::new(place, place + 1), message);
            Err(vec![FileError::at(&Source::new(path, text), &diagnostic)])
        }
    }
}

/// Returns the path of the file with the chosen forms of a file's kernels.
pub(crate) fn choices_beside(path: &str) -> PathBuf {
    Path::new(path).with_extension(EXTENSION)
}

fn text_of_choices(path: &str) -> Result<String, Vec<FileError>> {
    text(path).map_err(|message| vec![FileError::of_file(path, message)])
}

impl TheoryFile {
    /// Replaces the forms of the kernels by those in a file of choices.
    pub(crate) fn choose(&mut self, name: &str, text: impl Into<String>) -> Result<(), Vec<FileError>> {
        let source = Source::new(name, text);
        match Choices::read(&source.text) {
            Ok(choices) => {
                self.warning =
                    choices.objection(&self.theory).map(|text| format!("warning: {text}\n --> {name}\n"));
                choices.apply(&mut self.theory);
                Ok(())
            }
            Err(errors) => Err(errors.iter().map(|error| FileError::at(&source, error)).collect()),
        }
    }
}

/// Reads the text of a file, unless the file is too large.
pub(crate) fn text(path: &str) -> Result<String, String> {
    let text = String::from_utf8(bytes(path)?);
    text.map_err(|_| "the file is not UTF-8 text".to_string())
}

fn bytes(path: &str) -> Result<Vec<u8>, String> {
    let cannot = |error: std::io::Error| format!("cannot read the file: {error}");
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(cannot)?;
    file.take(LARGEST_FILE + 1).read_to_end(&mut bytes).map_err(cannot)?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(format!("the file is larger than the limit of {} MiB", LARGEST_FILE >> 20));
    }
    Ok(bytes)
}

/// Parses and resolves a text; the errors are in the order of the text.
pub(crate) fn from_text(name: &str, text: impl Into<String>) -> Result<TheoryFile, Vec<FileError>> {
    let source = Source::new(name, text);
    let (theory, diagnostics) = read_theory(&source.text);
    if diagnostics.is_empty() {
        return Ok(TheoryFile { source, theory, warning: None });
    }
    Err(diagnostics.iter().map(|diagnostic| FileError::at(&source, diagnostic)).collect())
}

/// Prints errors to standard error.
pub(crate) fn complain(errors: &[FileError]) {
    for error in errors {
        tell!("{}", error.shown);
    }
}
