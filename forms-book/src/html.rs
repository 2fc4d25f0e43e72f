//! Self-contained HTML pages: no network, no scripts, no other files except their figures.
//!
//! ```text
//! Page ─ expand ─▶ Markdown with MathML ─ pulldown-cmark ─ headings, code ─▶ body ─ navigation, style ─▶ page
//! ```

use crate::book::{Book, Chapter};
use crate::check::Problem;
use crate::escape::escaped;
use crate::expand::expanded;
use crate::highlight::highlighted;
use crate::page::{Anchors, MARKDOWN, Page, words};
use pulldown_cmark::html::push_html;
use pulldown_cmark::{CodeBlockKind, CowStr, Event, Options, Parser, Tag, TagEnd};

/// Title of the book.
const TITLE: &str = "Light as a differential form";

/// Style sheet of the pages: light and dark, wide and narrow.
const STYLE: &str = include_str!("style.css");

impl Book {
    /// Returns a page of HTML by its name, or `None` if no page has that name.
    ///
    /// # Errors
    /// If the page contains formulas that cannot be parsed.
    pub fn html(&self, name: &str) -> Option<Result<&str, &[Problem]>> {
        let html = self.rendered(name, |page| of_page(self, name, page))?;
        Some(html.as_ref().map(String::as_str).map_err(Vec::as_slice))
    }
}

/// Renders the page of that name. A source that is not Markdown is shown verbatim.
fn of_page(book: &Book, name: &str, page: &Page) -> Result<String, Vec<Problem>> {
    let (title, body) = if page.path.ends_with(".md") {
        let markdown = expanded(page, &|target| book.target(&page.path, target))?;
        (page.title(), body(&markdown))
    } else {
        let code = if page.path.ends_with(".forms") { highlighted(&page.text) } else { escaped(&page.text) };
        let title = page.path.clone();
        let body = format!("<h1><code>{}</code></h1>\n<pre><code>{code}</code></pre>\n", escaped(&title));
        (title, body)
    };
    let full_title = if title == TITLE { title } else { format!("{title} · {TITLE}") };
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<a class=\"to-contents\" href=\"#contents\">Contents</a>\n\
         <main>\n{body}{}</main>\n{}</body>\n</html>\n",
        escaped(&full_title),
        neighbours(book.chapters(), name),
        contents(book.chapters(), name),
    ))
}

/// Returns links to the previous and the next chapter.
fn neighbours(chapters: &[Chapter], name: &str) -> String {
    let Some(place) = chapters.iter().position(|chapter| chapter.name == name) else { return String::new() };
    let link = |place: Option<usize>, rel: &str, arrow: [&str; 2]| {
        let chapter = place.and_then(|place| chapters.get(place));
        chapter.map_or(String::from("<span></span>"), |chapter| {
            let [before, behind] = arrow;
            format!(
                "<a rel=\"{rel}\" href=\"{}\">{before}{}{behind}</a>",
                chapter.name,
                escaped(&chapter.title)
            )
        })
    };
    let previous = link(place.checked_sub(1), "prev", ["← ", ""]);
    let next = link(Some(place + 1), "next", ["", " →"]);
    format!("<nav class=\"neighbours\">{previous}{next}</nav>\n")
}

/// Returns the table of contents by parts. Chapters are numbered; reference pages are not.
fn contents(chapters: &[Chapter], name: &str) -> String {
    let mut list = format!("<nav id=\"contents\" aria-label=\"Contents\">\n<p class=\"title\">{TITLE}</p>\n");
    for chapters in chapters.chunk_by(|one, other| one.part == other.part) {
        if let Some(part) = &chapters[0].part {
            list.push_str(&format!("<p>{}</p>\n", escaped(part)));
        }
        list.push_str("<ul>\n");
        for chapter in chapters {
            let current = if chapter.name == name { " aria-current=\"page\"" } else { "" };
            let number: String = chapter.name.chars().take_while(char::is_ascii_digit).collect();
            let number = number.trim_start_matches('0');
            let number = if number.is_empty() { String::new() } else { format!("<b>{number}</b> ") };
            let title = escaped(&chapter.title);
            list.push_str(&format!("<li><a href=\"{}\"{current}>{number}{title}</a></li>\n", chapter.name));
        }
        list.push_str("</ul>\n");
    }
    list + "</nav>\n"
}

/// Converts Markdown to HTML, with anchors on headings and highlighted code.
fn body(markdown: &str) -> String {
    // Formulas are already MathML, so a dollar has no special meaning.
    let events: Vec<Event<'_>> =
        Parser::new_ext(markdown, MARKDOWN.difference(Options::ENABLE_MATH)).collect();
    let mut html = String::new();
    push_html(&mut html, with_code(with_anchors(events)).into_iter());
    html
}

fn with_anchors(mut events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let mut anchors = Anchors::default();
    for place in 0..events.len() {
        if !matches!(events[place], Event::Start(Tag::Heading { .. })) {
            continue;
        }
        let inside =
            events[place..].iter().take_while(|event| !matches!(event, Event::End(TagEnd::Heading(_))));
        let text: String = inside.filter_map(words).collect();
        if let Event::Start(Tag::Heading { id, .. }) = &mut events[place] {
            *id = Some(CowStr::from(anchors.next(&text)));
        }
    }
    events
}

fn with_code(events: Vec<Event<'_>>) -> Vec<Event<'_>> {
    let mut result = Vec::with_capacity(events.len());
    let mut open: Option<(String, String)> = None;
    for event in events {
        match (event, &mut open) {
            (Event::Start(Tag::CodeBlock(kind)), _) => {
                let kind = match kind {
                    CodeBlockKind::Fenced(kind) => kind.to_string(),
                    CodeBlockKind::Indented => String::new(),
                };
                open = Some((kind, String::new()));
            }
            (Event::End(TagEnd::CodeBlock), Some((kind, text))) => {
                let html = code(kind, text);
                result.push(Event::Html(CowStr::from(html)));
                open = None;
            }
            (Event::Text(text), Some((_, code))) => code.push_str(&text),
            (event, _) => result.push(event),
        }
    }
    result
}

fn code(kind: &str, text: &str) -> String {
    let language = kind.split(',').next().unwrap_or_default();
    let shown = match language {
        "forms" => highlighted(text),
        "console" => text.split_inclusive('\n').map(command).collect(),
        _ => escaped(text),
    };
    let class = escaped(&kind.replace(',', " "));
    format!("<pre class=\"{class}\"><code>{shown}</code></pre>\n")
}

/// Formats a line of a terminal; commands are emphasised.
fn command(line: &str) -> String {
    match line.strip_prefix("$ ") {
        Some(command) => format!("<b>$ {}</b>\n", escaped(command.trim_end())),
        None => escaped(line),
    }
}
