//! The embedded book: every page is rendered, and every file that a page refers to exists.

use forms_book::{Book, book};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Returns all texts between two marks.
fn between<'a>(text: &'a str, start: &str, end: char) -> Vec<&'a str> {
    text.split(start).skip(1).filter_map(|rest| rest.split(end).next()).collect()
}

#[test]
fn every_page_is_made_and_needs_nothing_beside_it_but_figures() {
    let book = book();
    let names: Vec<&str> = book.names().collect();
    assert!(names.contains(&"index.html"));
    let figures: BTreeSet<String> = book.figures().map(|(name, _)| name).collect();
    let workers = rayon::ThreadPoolBuilder::new().stack_size(64 << 20).build().expect("threads");
    let pages: Vec<(&str, &str)> = workers.install(|| {
        names
            .par_iter()
            .map(|&name| (name, book.html(name).expect("a page").expect("without problems")))
            .collect()
    });
    for (name, html) in pages {
        assert!(!html.contains("<script") && !html.contains("<merror") && !html.contains("<link"), "{name}");
        for source in between(html, "src=\"", '"') {
            assert!(figures.contains(source), "{name} shows {source}");
        }
        let is_page = |target: &&str| !target.starts_with("http") && !figures.contains(*target);
        for target in between(html, "href=\"", '"').into_iter().filter(is_page) {
            let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
            let page = if file.is_empty() { Some(html) } else { book.html(file).and_then(Result::ok) };
            let page = page.unwrap_or_else(|| panic!("{name} links to {target}"));
            assert!(
                anchor.is_empty() || page.contains(&format!("id=\"{anchor}\"")),
                "{name} links to {target}"
            );
        }
    }
}

#[test]
fn the_chapters_are_those_of_the_summary_in_order() {
    let listed = book().chapters().iter().filter(|chapter| chapter.path.starts_with("docs/book/src/"));
    let listed: Vec<&str> = listed.map(|chapter| chapter.path.rsplit('/').next().expect("a name")).collect();
    assert_eq!(listed[0], "preface.md");
    assert!(listed[1..].is_sorted() && listed.len() > 1, "{listed:?}");
}

#[test]
fn a_formula_that_cannot_be_read_is_told_with_page_and_line() {
    let files = [("SUMMARY.md", "- [One](one.md)\n"), ("one.md", "# One\n\n$\\nosuch$\n")];
    let book = Book::new(files.map(|(name, text)| (format!("docs/book/src/{name}"), text.into())));
    let problems = book.html("index.html").expect("a page").expect_err("a problem");
    assert_eq!((problems[0].page.as_str(), problems[0].line), ("docs/book/src/one.md", 3));
}

#[test]
fn a_page_has_its_neighbours_and_the_contents() {
    let files = [
        ("SUMMARY.md", "[Start](preface.md)\n\n# Part\n\n- [One](01-one.md)\n- [Two](02-two.md)\n"),
        ("preface.md", "# Start\n"),
        ("01-one.md", "# One\n\n## The `d` again\n\n[back](preface.md#start) [on](02-two.md)\n"),
        ("02-two.md", "# Two\n"),
    ];
    let book = Book::new(files.map(|(name, text)| (format!("docs/book/src/{name}"), text.into())));
    let html = book.html("01-one.html").expect("a page").expect("without problems");
    for part in [
        "<h2 id=\"the-d-again\">",
        "<a href=\"index.html#start\">back</a>",
        "<a rel=\"prev\" href=\"index.html\">← Start</a><a rel=\"next\" href=\"02-two.html\">Two →</a>",
        "<p>Part</p>",
        "<a href=\"01-one.html\" aria-current=\"page\"><b>1</b> One</a>",
    ] {
        assert!(html.contains(part), "{part}: {html}");
    }
}
