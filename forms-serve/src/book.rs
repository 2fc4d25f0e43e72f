//! The book: its pages by name.
//!
//! This is the one place where the book is plugged in: [`html`] gives a page by its name, and [`file`] the figures that pages
//! show. Pages may bring their own styles, and no scripts. Here the Markdown of the book is shown as it is written.

use crate::markdown::markdown;
use crate::reply::{kind, nothing, page_with_styles, reply};
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
        Some(html) => page_with_styles(html),
        None => file(path).map_or_else(nothing, |contents| reply(kind(path), contents)),
    }
}

/// A whole page.
fn html(name: &str) -> Option<String> {
    let text = BOOK.get_file(format!("{name}.md"))?.contents_utf8()?;
    let body = markdown(text, |link| {
        let is_here = BOOK.get_file(link).is_some() || link.starts_with('#');
        is_here.then(|| link.strip_suffix(".md").map_or(link.to_owned(), |name| format!("{name}.html")))
    });
    Some(shell("The book", "book", &body))
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
        let links = contents.split("href=\"").skip(1).filter_map(|part| part.split('"').next());
        let pages: Vec<&str> = links.filter(|link| !link.starts_with('/')).collect();
        assert!(pages.len() >= 2, "{contents}");
        pages.iter().for_each(|page| assert_eq!(book(page).status(), 200, "{page}"));
    }
}
