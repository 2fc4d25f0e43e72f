//! Conversion of Markdown to the HTML body of a page.

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

/// Converts a text to HTML. `place` returns the target of a link, or `None` to keep only its text.
pub(crate) fn markdown(text: &str, place: impl Fn(&str) -> Option<String>) -> String {
    let mut kept = Vec::new();
    let options = Options::ENABLE_TABLES | Options::ENABLE_HEADING_ATTRIBUTES;
    let events = Parser::new_ext(text, options).filter_map(|event| match event {
        Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
            let found = place(&dest_url);
            kept.push(found.is_some());
            let link = |found: String| Tag::Link { link_type, dest_url: CowStr::from(found), title, id };
            found.map(|found| Event::Start(link(found)))
        }
        Event::End(TagEnd::Link) => kept.pop().unwrap_or(false).then_some(Event::End(TagEnd::Link)),
        event => Some(event),
    });
    let mut page = String::new();
    html::push_html(&mut page, in_sections(events));
    page
}

/// Wraps the text in sections; each heading of the second level begins one.
fn in_sections<'a>(events: impl Iterator<Item = Event<'a>>) -> impl Iterator<Item = Event<'a>> {
    let (first, last) = (Event::Html("<section>\n".into()), Event::Html("</section>\n".into()));
    std::iter::once(first).chain(events.flat_map(after_a_wall)).chain([last])
}

/// Puts a section break before a heading of the second level; other events pass unchanged.
fn after_a_wall(event: Event) -> impl Iterator<Item = Event> {
    let is_heading = matches!(event, Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }));
    is_heading.then(|| Event::Html("</section>\n<section>\n".into())).into_iter().chain([event])
}
