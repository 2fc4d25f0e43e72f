//! The book: its pages by name.
//!
//! This is the one place where the book is plugged in: [`html`] gives the inside of a page by its name, and [`file`] what pages
//! show. Here the Markdown of the book is shown as it is written.

use crate::markdown::markdown;
use crate::reply::{kind, nothing, page, reply};
use crate::site::shell;
use axum::response::Response;
use include_dir::{Dir, include_dir};

static BOOK: Dir = include_dir!("$CARGO_MANIFEST_DIR/../docs/book/src");

/// The page that a reader sees first.
const CONTENTS: &str = "SUMMARY";

/// A page or file of the book, by its path below it.
pub(crate) fn book(path: &str) -> Response {
    let name = path.strip_suffix(".html").unwrap_or(path);
    match html(if name.is_empty() { CONTENTS } else { name }) {
        Some(html) => page(shell("The book", "book", &html)),
        None => file(path).map_or_else(nothing, |contents| reply(kind(path), contents)),
    }
}

/// The inside of a page.
fn html(name: &str) -> Option<String> {
    let text = BOOK.get_file(format!("{name}.md"))?.contents_utf8()?;
    Some(markdown(text, |link| {
        let is_here = BOOK.get_file(link).is_some() || link.starts_with('#');
        is_here.then(|| link.strip_suffix(".md").map_or(link.to_owned(), |name| format!("{name}.html")))
    }))
}

/// A figure.
fn file(path: &str) -> Option<&'static [u8]> {
    path.starts_with("figures/").then(|| BOOK.get_file(path)).flatten().map(include_dir::File::contents)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_page_of_the_contents_is_there() {
        let contents = html(CONTENTS).expect("the contents");
        let pages: Vec<&str> =
            contents.split("href=\"").skip(1).filter_map(|part| part.split('"').next()).collect();
        assert!(pages.len() >= 2, "{contents}");
        pages.iter().for_each(|page| assert_eq!(book(page).status(), 200, "{page}"));
    }
}
