//! What the documents say is so.
//!
//! ```text
//! README.md, docs/**/*.md ─ forms_book ─┬─ statements, kernels, exercises
//!                                       ├─ quoted errors, and kinds of blocks
//!                                       └─ links, anchors and figures
//! ```
//! Rust blocks are doctests of the crate `forms`, and blocks of calls are run by the tests of `forms-cli`. With
//! `FORMS_WRITE=1` quoted messages are written anew.

use forms_book::{Page, Report, check_kinds, check_links, check_theories, with_errors_quoted};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use std::path::Path;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every page.
fn pages() -> Vec<Page> {
    let readme = Page::new("README.md", std::fs::read_to_string(root().join("README.md")).unwrap());
    std::iter::once(readme).chain(forms_book::pages(root(), "docs").unwrap()).collect()
}

/// What a check says of all pages together.
fn checked(check: impl Fn(&Page) -> Report + Send + Sync) -> Report {
    let pages = pages();
    // Trees as deep as the parser admits are walked by recursion.
    let workers = ThreadPoolBuilder::new().stack_size(64 << 20).build().unwrap();
    let reports: Vec<Report> = workers.install(|| pages.par_iter().map(check).collect());
    let mut all = Report::default();
    reports.into_iter().for_each(|report| all.add(report));
    let problems: Vec<String> = all.problems.iter().map(ToString::to_string).collect();
    assert!(problems.is_empty(), "{} problems\n{}", problems.len(), problems.join("\n"));
    all
}

#[test]
fn every_statement_of_every_page_is_as_claimed_and_every_exercise_has_its_answer() {
    let counted = checked(check_theories).counted;
    println!(
        "{} statements, {} kernels and {} exercises were checked",
        counted.statements, counted.kernels, counted.exercises
    );
    assert!(counted.statements > 50, "only {} statements were found", counted.statements);
}

#[test]
fn every_error_is_quoted_as_it_is_shown() {
    if std::env::var_os("FORMS_WRITE").is_some() {
        for page in pages() {
            let (mended, _) = with_errors_quoted(&page);
            if mended != page {
                std::fs::write(root().join(&page.path), &mended.text).unwrap();
            }
        }
    }
    // FORMS_WRITE=1 cargo test --test docs
    let counted = checked(|page| with_errors_quoted(page).1).counted;
    println!("{} quoted errors were checked", counted.errors);
    assert!(counted.errors > 0, "no page shows an error");
}

#[test]
fn blocks_are_closed_and_of_a_known_kind() {
    // These are run by the tests of forms-radiometry.
    let scenes = ["toml,error", "toml,refused", "xml", "xml,error", "obj,error", "ply,error"];
    checked(|page| {
        let more: &[&str] = if page.path == "docs/scenes.md" { &scenes } else { &[] };
        Report { problems: check_kinds(page, more), ..Report::default() }
    });
}

#[test]
fn links_anchors_and_figures_are_there() {
    let counted = checked(|page| check_links(page, root())).counted;
    println!("{} links were followed", counted.links);
    assert!(counted.links > 10, "only {} links were found", counted.links);
}

#[test]
fn a_page_that_is_wrong_is_told_with_the_line() {
    let text = "# Title\n\n```forms\nchart P(x, y);\nprove wrong: dx^dy == dy^dx;\n```\n\n[other](missing.md)\n\
                [here](#nothing) ![picture](figures/missing.svg) [conventions](../../conventions.md#none)\n";
    let page = Page::new("docs/book/src/page.md", text);
    let mut report = check_theories(&page);
    report.add(check_links(&page, root()));
    let found: Vec<String> = report.problems.iter().map(ToString::to_string).collect();
    let expected = [
        "page.md:5: error: `wrong` is false",
        "page.md:8: the link missing.md leads to docs/book/src/missing.md, which does not exist",
        "page.md:9: the link #nothing names a heading that docs/book/src/page.md does not have",
        "page.md:9: the link figures/missing.svg leads to",
        "page.md:9: the link ../../conventions.md#none names a heading that docs/conventions.md does not have",
    ];
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.contains(expected), "{found}");
    }
}
