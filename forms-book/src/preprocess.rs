//! mdBook preprocessor: inserts formulas and verdicts, so that mdBook renders the same book.
//!
//! ```text
//! [context, book] as JSON ─ the text of each chapter ─ expand ─▶ book as JSON
//! ```
//! Protocol: <https://rust-lang.github.io/mdBook/for_developers/preprocessors.html>.

use crate::book::CHAPTERS;
use crate::check::Problem;
use crate::expand::expanded;
use crate::links::{is_relative, resolved};
use crate::page::Page;
use serde_json::Value;
use std::fmt;

/// Reason why a book cannot be preprocessed.
#[derive(Debug)]
pub enum PreprocessError {
    /// The input does not have the format of mdBook.
    Input(String),
    /// Pages contain formulas that cannot be parsed.
    Pages(Vec<Problem>),
}

impl fmt::Display for PreprocessError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PreprocessError::Input(message) => {
                write!(f, "the input is not a book in the format of mdBook: {message}")
            }
            PreprocessError::Pages(problems) => {
                let lines: Vec<String> = problems.iter().map(ToString::to_string).collect();
                write!(f, "{}", lines.join("\n"))
            }
        }
    }
}

impl std::error::Error for PreprocessError {}

/// Returns the preprocessed book as the JSON that mdBook expects.
///
/// # Errors
/// If the input is not a pair of context and book, or if a formula cannot be parsed.
pub fn preprocess(input: &str) -> Result<String, PreprocessError> {
    let wrong = |error: serde_json::Error| PreprocessError::Input(error.to_string());
    let (_, mut book): (Value, Value) = serde_json::from_str(input).map_err(wrong)?;
    let mut problems = Vec::new();
    chapters(&mut book, &mut |page| match expanded(page, &|target| target_in(page, target)) {
        Ok(text) => Some(text),
        Err(found) => {
            problems.extend(found);
            None
        }
    });
    if problems.is_empty() {
        serde_json::to_string(&book).map_err(wrong)
    } else {
        Err(PreprocessError::Pages(problems))
    }
}

/// Replaces the texts of all chapters, at any depth of the book.
fn chapters(value: &mut Value, replace: &mut dyn FnMut(&Page) -> Option<String>) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| chapters(item, replace)),
        Value::Object(fields) => {
            if let (Some(Value::String(path)), Some(Value::String(text))) =
                (fields.get("path"), fields.get("content"))
            {
                let page = Page::new(format!("{CHAPTERS}{path}"), text.as_str());
                if let Some(text) = replace(&page) {
                    fields.insert("content".to_owned(), Value::String(text));
                }
            }
            fields.values_mut().for_each(|field| chapters(field, replace));
        }
        _ => {}
    }
}

/// Returns the target of a link, or `None` outside the chapters: mdBook has only the files below
/// its source folder.
fn target_in(page: &Page, target: &str) -> Option<String> {
    let stays = !is_relative(target)
        || resolved(&page.path, target).is_some_and(|(path, _)| path.starts_with(CHAPTERS));
    stays.then(|| target.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn chapters_are_expanded_in_the_shapes_of_old_and_new_mdbook() {
        for items in ["sections", "items"] {
            let chapter = r##"{"Chapter":{"name":"One","content":"# One $x$ [c](../../conventions.md)","path":"one.md","sub_items":[
                {"Chapter":{"name":"Two","content":"$y$","path":"two.md","sub_items":[]}}]}}"##;
            let input = format!("[{{\"renderer\":\"html\"}},{{\"{items}\":[{chapter},\"Separator\"]}}]");
            let output: Value = serde_json::from_str(&preprocess(&input).expect("a book")).expect("JSON");
            let first = &output[items][0]["Chapter"];
            let text = first["content"].as_str().expect("text");
            assert!(text.starts_with("# One <math") && text.ends_with(" c"), "{text}");
            let second = first["sub_items"][0]["Chapter"]["content"].as_str().expect("text");
            assert!(second.starts_with("<math"), "{second}");
            assert_eq!(output[items][1], "Separator");
        }
    }

    #[test]
    fn input_that_is_no_book_and_formulas_that_cannot_be_read_are_errors() {
        assert!(matches!(preprocess("{}"), Err(PreprocessError::Input(_))));
        let input = r#"[{}, {"items":[{"Chapter":{"content":"\n$\\nosuch$","path":"one.md"}}]}]"#;
        let error = preprocess(input).expect_err("a formula").to_string();
        assert!(error.starts_with("docs/book/src/one.md:2: this formula cannot be read"), "{error}");
    }
}
