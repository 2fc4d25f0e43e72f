//! The whole book: its chapters in order, their pages, and the name of each page.
//!
//! ```text
//! embedded sources ─ SUMMARY.md ─▶ chapters ─┐
//!                  ─ docs/*.md ───▶ reference ┼─ expand, html ─▶ pages by name · figures by name
//!                  ─ .forms, .toml ▶ listings ┘
//! ```
//! A page is rendered at its first request and cached.

use crate::check::Problem;
use crate::links::{is_relative, resolved};
use crate::page::{Page, words};
use pulldown_cmark::{Event, Tag, TagEnd};
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// Sources of the book: paths below the root of the repository, with their bytes.
const SOURCES: &[(&str, &[u8])] = include!(concat!(env!("OUT_DIR"), "/sources.rs"));

/// Folder of the chapters.
pub(crate) const CHAPTERS: &str = "docs/book/src/";

/// Page of the rendered book.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Chapter {
    /// File name of the page, `03-pullback-and-the-cosine.html`.
    pub name: String,
    /// Title in the table of contents.
    pub title: String,
    /// Part of the book that contains the page; `None` for a page before the first part.
    pub part: Option<String>,
    /// Path of its source below the root of the repository.
    pub path: String,
}

pub(crate) type Html = Result<String, Vec<Problem>>;

/// The book: pages of HTML and figures, by name.
#[derive(Debug)]
pub struct Book {
    sources: BTreeMap<String, Vec<u8>>,
    /// Pages in the table of contents, in order.
    chapters: Vec<Chapter>,
    /// Name of the page for each source path.
    names: BTreeMap<String, String>,
    made: BTreeMap<String, OnceLock<Html>>,
}

/// Returns the book embedded in the program. Its pages are found by name; `index.html` is the
/// first.
pub fn book() -> &'static Book {
    static BOOK: OnceLock<Book> = OnceLock::new();
    BOOK.get_or_init(|| Book::new(SOURCES.iter().map(|(path, bytes)| ((*path).to_owned(), bytes.to_vec()))))
}

impl Book {
    /// Creates a book from files, given by their paths below the root of the repository. They
    /// include `docs/book/src/SUMMARY.md`.
    pub fn new(sources: impl IntoIterator<Item = (String, Vec<u8>)>) -> Self {
        let sources: BTreeMap<String, Vec<u8>> = sources.into_iter().collect();
        let mut book = Book { sources, chapters: vec![], names: BTreeMap::new(), made: BTreeMap::new() };
        book.chapters = book.listed();
        book.names =
            book.chapters.iter().map(|chapter| (chapter.path.clone(), chapter.name.clone())).collect();
        let unlisted = book.sources.keys().filter(|path| !path.starts_with(CHAPTERS) && !is_picture(path));
        let unlisted: Vec<String> =
            unlisted.filter(|path| !book.names.contains_key(*path)).cloned().collect();
        book.names.extend(unlisted.into_iter().map(|path| (path.clone(), flat(&path))));
        book.made = book.names.values().map(|name| (name.clone(), OnceLock::new())).collect();
        book
    }

    /// Lists the chapters of the summary, then the reference pages.
    fn listed(&self) -> Vec<Chapter> {
        let mut chapters = self.page(&format!("{CHAPTERS}SUMMARY.md")).map_or(vec![], |page| summary(&page));
        if let Some(first) = chapters.first_mut() {
            first.name = "index.html".to_owned();
        }
        let is_reference = |path: &&String| {
            path.strip_prefix("docs/").is_some_and(|rest| !rest.contains('/') && rest.ends_with(".md"))
        };
        let references = self.sources.keys().filter(is_reference).filter_map(|path| {
            let title = self.page(path)?.title();
            Some(Chapter { name: flat(path), title, part: Some("Reference".to_owned()), path: path.clone() })
        });
        chapters.extend(references);
        chapters
    }

    /// Returns the source of a page.
    pub(crate) fn page(&self, path: &str) -> Option<Page> {
        let text = String::from_utf8(self.sources.get(path)?.clone()).ok()?;
        Some(Page::new(path, text))
    }

    /// Returns the pages in the table of contents, in order.
    pub fn chapters(&self) -> &[Chapter] {
        &self.chapters
    }

    /// Returns the names of all pages; files that pages link to are pages as well.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.made.keys().map(String::as_str)
    }

    /// Returns the rendered page of that name, which is rendered once; `None` if no page has that
    /// name.
    pub(crate) fn rendered(&self, name: &str, render: impl FnOnce(&Page) -> Html) -> Option<&Html> {
        let made = self.made.get(name)?;
        Some(made.get_or_init(|| {
            let path = self.names.iter().find(|(_, known)| *known == name).map(|(path, _)| path);
            path.and_then(|path| self.page(path)).map_or_else(|| Ok(String::new()), |page| render(&page))
        }))
    }

    /// Returns the figures with the names by which pages refer to them.
    pub fn figures(&self) -> impl Iterator<Item = (String, &[u8])> {
        let pictures = self.sources.iter().filter(|(path, _)| is_picture(path));
        pictures.map(|(path, bytes)| (figure(path), bytes.as_slice()))
    }

    /// Returns the target in the rendered book of a link on the page with this path, or `None` if
    /// the link leads out of the book.
    pub(crate) fn target(&self, path: &str, target: &str) -> Option<String> {
        if !is_relative(target) {
            return Some(target.to_owned());
        }
        let (path, anchor) = resolved(path, target)?;
        if is_picture(&path) {
            return self.sources.contains_key(&path).then(|| figure(&path));
        }
        let name = self.names.get(&path)?;
        Some(anchor.map_or_else(|| name.clone(), |anchor| format!("{name}#{anchor}")))
    }
}

fn is_picture(path: &str) -> bool {
    path.ends_with(".svg") || path.ends_with(".png")
}

/// Flattens a path into one HTML file name: `docs/theory.md` becomes `docs-theory.html`.
fn flat(path: &str) -> String {
    format!("{}.html", path.strip_suffix(".md").unwrap_or(path).replace('/', "-"))
}

/// Returns the place of a figure: chapter figures by file name, others by their whole path.
fn figure(path: &str) -> String {
    let name = path.strip_prefix(CHAPTERS).map(|rest| rest.strip_prefix("figures/").unwrap_or(rest));
    format!("figures/{}", name.unwrap_or(path).replace('/', "-"))
}

/// Parses the chapters of a summary: headings are parts, links are chapters.
fn summary(page: &Page) -> Vec<Chapter> {
    let mut chapters: Vec<Chapter> = Vec::new();
    let (mut part, mut heading, mut title) = (None, None, None::<(String, String)>);
    for (event, _) in page.events() {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => part = heading.take().filter(|text| text != "Summary"),
            Event::Start(Tag::Link { dest_url, .. }) => title = Some((dest_url.to_string(), String::new())),
            Event::End(TagEnd::Link) => {
                let Some((target, title)) = title.take() else { continue };
                let Some((path, _)) = resolved(&page.path, &target) else { continue };
                let name = target.replace(".md", ".html");
                chapters.push(Chapter { name, title, part: part.clone(), path });
            }
            event => {
                let text = heading.as_mut().or(title.as_mut().map(|(_, title)| title));
                if let (Some(text), Some(more)) = (text, words(&event)) {
                    text.push_str(more);
                }
            }
        }
    }
    chapters
}
