//! The gallery: scenes, their pictures and their reference results, read from the folder `scenes`.

use crate::markdown::markdown;
use crate::reply::{kind, nothing, page, reply};
use crate::site::shell;
use axum::response::Response;
use include_dir::{Dir, include_dir};

static SCENES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../scenes");
static FIGURES: Dir = include_dir!("$CARGO_MANIFEST_DIR/../docs/figures/scenes");
/// Folders of the figures as seen from the gallery: in the Markdown text, and on the served page.
const FIGURES_IN_THE_TEXT: &str = "../docs/figures/scenes/";
const FIGURES_ON_THE_PAGE: &str = "figures/";

/// Replies with a page or file of the gallery, given its path below the gallery.
pub(crate) fn gallery(path: &str) -> Response {
    if path.is_empty() {
        return page(gallery_page());
    }
    let file = match path.strip_prefix(FIGURES_ON_THE_PAGE) {
        Some(name) => FIGURES.get_file(name),
        None => SCENES.get_file(path),
    };
    file.map_or_else(nothing, |file| reply(kind(path), file.contents()))
}

fn gallery_page() -> String {
    let text = SCENES.get_file("README.md").and_then(|file| file.contents_utf8()).unwrap_or_default();
    shell("Gallery", "gallery", &markdown(text, place))
}

/// Returns the target of a link, or `None` if the file is not part of the gallery.
fn place(link: &str) -> Option<String> {
    if let Some(name) = link.strip_prefix(FIGURES_IN_THE_TEXT) {
        return Some(format!("{FIGURES_ON_THE_PAGE}{name}"));
    }
    SCENES.get_file(link).map(|_| link.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_picture_and_link_of_the_gallery_is_there() {
        let page = gallery_page();
        let of = |attribute: &str| -> Vec<String> {
            let parts = page.split(attribute).skip(1);
            parts.filter_map(|part| part.split('"').next()).map(str::to_owned).collect()
        };
        let links: Vec<String> =
            of("src=\"").into_iter().chain(of("href=\"")).filter(|link| !link.starts_with('/')).collect();
        assert!(links.len() > 20, "{links:?}");
        for link in links {
            assert_eq!(gallery(&link).status(), 200, "{link}");
        }
    }
}
