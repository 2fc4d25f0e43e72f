//! XML: the documents of scenes and meshes, with the place of what is not valid in them.

use roxmltree::{Document, Error, TextPos};

/// Returns the document, or the byte at which its text is not valid and a message.
pub(super) fn parsed(text: &str) -> Result<Document<'_>, (usize, String)> {
    Document::parse(text).map_err(|error| {
        let position = error.pos();
        let message = error.to_string();
        let message = message.strip_suffix(&format!(" at {position}")).unwrap_or(&message).to_owned();
        match error {
            // elements that are open where the text ends
            Error::UnclosedRootNode | Error::UnexpectedEndOfStream => (text.trim_end().len(), message),
            _ => (byte_at(text, position), message),
        }
    })
}

/// Returns the byte of a row and a column, both counted from one.
fn byte_at(text: &str, position: TextPos) -> usize {
    let line = text.split_inclusive('\n').take((position.row as usize).saturating_sub(1));
    let start: usize = line.map(str::len).sum();
    let columns = text[start.min(text.len())..].chars().take((position.col as usize).saturating_sub(1));
    start + columns.map(char::len_utf8).sum::<usize>()
}
