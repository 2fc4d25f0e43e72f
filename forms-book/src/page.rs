//! A page of Markdown and its marked items: fenced blocks, links and headings, each with its line.
//!
//! ```text
//! text ─ pulldown-cmark ─▶ Block (kind, text) · Link (target) · anchors of headings
//! ```

use pulldown_cmark::{CodeBlockKind, Event, OffsetIter, Options, Parser, Tag, TagEnd};
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::Path;

/// Markdown extensions allowed in addition to CommonMark: tables, formulas between dollars,
/// footnotes and strikethrough.
pub(crate) const MARKDOWN: Options = Options::ENABLE_TABLES
    .union(Options::ENABLE_MATH)
    .union(Options::ENABLE_FOOTNOTES)
    .union(Options::ENABLE_STRIKETHROUGH);

/// A page of Markdown.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Page {
    /// Path below the root of the repository, with slashes.
    pub path: String,
    /// Text of the page.
    pub text: String,
}

/// A fenced block.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Block {
    /// Info string: the text after the opening fence.
    pub kind: String,
    /// Lines up to the closing fence.
    pub text: String,
    /// Line of the opening fence, from 1.
    pub line: usize,
    /// Byte range in the page, from fence to fence.
    pub place: Range<usize>,
    /// Whether the block has a closing fence.
    pub is_closed: bool,
}

/// Target of a link or of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    /// Target as written, `page.md#anchor`.
    pub target: String,
    /// Line of the link, from 1.
    pub line: usize,
}

/// Reads the pages of a folder below a root, recursively, sorted by path.
///
/// # Errors
/// If a folder or a page cannot be read.
pub fn pages(root: &Path, folder: &str) -> io::Result<Vec<Page>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(root.join(folder))? {
        let entry = entry?;
        let path = format!("{folder}/{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(pages(root, &path)?);
        } else if path.ends_with(".md") {
            let text = fs::read_to_string(entry.path())?;
            found.push(Page::new(path, text));
        }
    }
    found.sort_by(|a, b| a.path.cmp(&b.path));
    Ok(found)
}

impl Page {
    /// Creates a page from its path below the root of the repository and its text.
    pub fn new(path: impl Into<String>, text: impl Into<String>) -> Self {
        Page { path: path.into(), text: text.into() }
    }

    pub(crate) fn events(&self) -> OffsetIter<'_> {
        Parser::new_ext(&self.text, MARKDOWN).into_offset_iter()
    }

    /// Returns the line number of a byte offset, from 1.
    pub fn line(&self, offset: usize) -> usize {
        self.text.as_bytes()[..offset].iter().filter(|&&byte| byte == b'\n').count() + 1
    }

    /// Returns the fenced blocks, in order.
    pub fn blocks(&self) -> Vec<Block> {
        let mut blocks: Vec<Block> = Vec::new();
        let mut is_inside = false;
        for (event, place) in self.events() {
            match event {
                Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(kind))) => {
                    is_inside = true;
                    let (kind, line) = (kind.trim().to_owned(), self.line(place.start));
                    let fenced = self.text[place.clone()].trim_end();
                    let is_closed = fenced.len() > 3 && fenced.ends_with("```");
                    blocks.push(Block { kind, text: String::new(), line, place, is_closed });
                }
                Event::End(TagEnd::CodeBlock) => is_inside = false,
                Event::Text(text) if is_inside => {
                    blocks.iter_mut().next_back().expect("it has begun").text.push_str(&text);
                }
                _ => {}
            }
        }
        blocks
    }

    /// Returns the links and pictures, in order, including those in HTML. Links inside code are
    /// ignored.
    pub fn links(&self) -> Vec<Link> {
        let mut links = Vec::new();
        for (event, place) in self.events() {
            let line = self.line(place.start);
            match event {
                Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                    links.push(Link { target: dest_url.to_string(), line });
                }
                Event::Html(_) | Event::InlineHtml(_) => {
                    let targets = targets_in_html(&self.text[place.clone()]).into_iter();
                    let target =
                        |at: Range<usize>| self.text[place.start + at.start..place.start + at.end].to_owned();
                    links.extend(targets.map(|at| Link { target: target(at), line }));
                }
                _ => {}
            }
        }
        links
    }

    /// Returns the anchors that links to this page can name: its headings.
    pub fn anchors(&self) -> BTreeSet<String> {
        let mut anchors = Anchors::default();
        let mut heading: Option<String> = None;
        for (event, _) in self.events() {
            match event {
                Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
                Event::End(TagEnd::Heading(_)) => {
                    anchors.next(&heading.take().unwrap_or_default());
                }
                event => {
                    if let (Some(heading), Some(text)) = (&mut heading, words(&event)) {
                        heading.push_str(text);
                    }
                }
            }
        }
        anchors.given
    }

    /// Returns the title: the first heading.
    pub fn title(&self) -> String {
        let of_first_heading = self
            .events()
            .map(|(event, _)| event)
            .skip_while(|event| !matches!(event, Event::Start(Tag::Heading { .. })))
            .take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
        of_first_heading.filter_map(|event| words(&event).map(str::to_owned)).collect()
    }
}

/// Returns the byte ranges of the values of `src` and `href` in a piece of HTML.
pub(crate) fn targets_in_html(html: &str) -> Vec<Range<usize>> {
    let starts = [" src=\"", " href=\""]
        .into_iter()
        .flat_map(|name| html.match_indices(name).map(|(at, name)| at + name.len()).collect::<Vec<_>>());
    let mut places: Vec<Range<usize>> =
        starts.filter_map(|start| Some(start..start + html[start..].find('"')?)).collect();
    places.sort_by_key(|place| place.start);
    places
}

/// Returns the characters of text, code and inline formulas; a line break counts as a space.
pub(crate) fn words<'a>(event: &'a Event<'_>) -> Option<&'a str> {
    match event {
        Event::Text(text) | Event::Code(text) | Event::InlineMath(text) => Some(text),
        Event::SoftBreak | Event::HardBreak => Some(" "),
        _ => None,
    }
}

/// Anchors of the headings of a page, all distinct.
#[derive(Default)]
pub(crate) struct Anchors {
    given: BTreeSet<String>,
}

impl Anchors {
    /// Returns the anchor of a heading: letters and digits in lower case, hyphens for spaces, and a
    /// numeric suffix if the anchor is taken.
    pub(crate) fn next(&mut self, heading: &str) -> String {
        let keep = |c: char| match c {
            c if c.is_alphanumeric() || c == '_' || c == '-' => Some(c),
            c if c.is_whitespace() => Some('-'),
            _ => None,
        };
        let plain = heading.to_lowercase().chars().filter_map(keep).collect::<String>();
        let numbered = (1..).map(|number| format!("{plain}-{number}"));
        let free = std::iter::once(plain.clone()).chain(numbered).find(|anchor| !self.given.contains(anchor));
        let anchor = free.expect("numbers do not end");
        self.given.insert(anchor.clone());
        anchor
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "# The `d` of a form\n\n```forms\nchart P(x);\n```\n\n## Again\n\ntext [a](b.md#c)\n`[no](link)`\n\n\
        <details>\n\n```forms,answer\nlet a = 1;\n```\n\n</details>\n\n## Again\n";

    #[test]
    fn blocks_have_their_kind_text_and_line() {
        let blocks = Page::new("page.md", PAGE).blocks();
        let found: Vec<(&str, &str, usize)> =
            blocks.iter().map(|block| (block.kind.as_str(), block.text.as_str(), block.line)).collect();
        assert_eq!(found, [("forms", "chart P(x);\n", 3), ("forms,answer", "let a = 1;\n", 14)]);
        assert!(blocks.iter().all(|block| block.is_closed));
        assert!(!Page::new("open.md", "```forms\nchart P(x);\n").blocks()[0].is_closed);
    }

    #[test]
    fn links_are_found_outside_code() {
        let links = Page::new("page.md", PAGE).links();
        assert_eq!(links, [Link { target: "b.md#c".into(), line: 9 }]);
        let links =
            Page::new("page.md", "text\n<img src=\"a.svg\" width=\"5\"> <a href=\"b.md\">b</a>\n").links();
        assert_eq!(links.iter().map(|link| link.target.as_str()).collect::<Vec<_>>(), ["a.svg", "b.md"]);
    }

    #[test]
    fn anchors_are_given_once() {
        let anchors: Vec<String> = Page::new("page.md", PAGE).anchors().into_iter().collect();
        assert_eq!(anchors, ["again", "again-1", "the-d-of-a-form"]);
        assert_eq!(Page::new("page.md", PAGE).title(), "The d of a form");
    }
}
