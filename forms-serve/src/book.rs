//! The book: its pages and figures by name, with a link back to the editor.
//!
//! Pages contain their own styles, and no scripts. A page is decided and typeset at its first
//! request, which can take a second.

use crate::reply::{kind, nothing, page_with_styles, reply};
use axum::response::Response;

/// First page of the book.
const FIRST: &str = "index.html";
/// Start of the table of contents; the link back to the editor is inserted after it.
const CONTENTS: &str = "<nav id=\"contents\" aria-label=\"Contents\">";
const ICON: &str = "<link rel=\"icon\" href=\"/page/icon.svg\">";
const BACK: &str = "<p class=\"back\"><a href=\"/\">Editor</a></p>";

/// Replies with a page or figure of the book, given its path below the book.
pub(crate) async fn book(path: String) -> Response {
    // Proofs take time; other requests are served meanwhile.
    tokio::task::spawn_blocking(move || found(&path)).await.unwrap_or_else(|_| nothing())
}

fn found(path: &str) -> Response {
    let name = if path.is_empty() { FIRST } else { path };
    match html(name) {
        Some(html) => page_with_styles(html),
        None => figure(name).map_or_else(nothing, |contents| reply(kind(name), contents)),
    }
}

/// Returns a complete page. A page with formulas that cannot be parsed counts as missing: the tests
/// of the book let none pass.
fn html(name: &str) -> Option<String> {
    let html = forms_book::book().html(name)?.ok()?;
    let html = html.replacen(CONTENTS, &format!("{CONTENTS}{BACK}"), 1);
    Some(html.replacen("</head>", &format!("{ICON}</head>"), 1))
}

fn figure(name: &str) -> Option<&'static [u8]> {
    let mut figures = forms_book::book().figures();
    figures.find(|(figure, _)| figure.as_str() == name).map(|(_, contents)| contents)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chapter_and_figure_is_there_and_leads_back() {
        let book = forms_book::book();
        assert!(book.chapters().len() > 17);
        for name in [FIRST, "04-solid-angle.html"] {
            assert!(html(name).is_some_and(|html| html.contains(BACK)), "{name}");
            assert_eq!(found(name).status(), 200, "{name}");
        }
        assert!(book.figures().count() > 10);
        for (name, _) in book.figures() {
            assert_eq!(found(&name).status(), 200, "{name}");
        }
        assert_eq!(found("nothing.html").status(), 404);
    }
}
