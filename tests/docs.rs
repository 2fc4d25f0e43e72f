//! Checks the claims of the documents.
//!
//! ```text
//! README.md, docs/**/*.md ─ forms_book ─┬─ statements, kernels, exercises
//!                                       ├─ quoted errors, rows of errors, and kinds of blocks
//!                                       └─ links, anchors and figures
//! ```
//! Rust blocks are doctests of the crate `forms`, and blocks of calls are run by the tests of
//! `forms-cli`. With `FORMS_WRITE=1` quoted messages are rewritten.

use forms::core::check::read_file;
use forms_book::{Page, Report, check_kinds, check_links, check_theories, with_errors_quoted};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Reads all pages.
fn pages() -> Vec<Page> {
    let readme = Page::new("README.md", std::fs::read_to_string(root().join("README.md")).unwrap());
    std::iter::once(readme).chain(forms_book::pages(root(), "docs").unwrap()).collect()
}

/// Runs a check on all pages, asserts that there are no problems, and returns the combined report.
fn checked(check: impl Fn(&Page) -> Report + Send + Sync) -> Report {
    let pages = pages();
    // Recursion walks trees as deep as the parser admits.
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

/// Checks the tables `text | said | help`: each text, appended to the block above the table, gives
/// exactly this error and help.
#[test]
fn every_row_of_the_page_of_errors_is_what_is_said_of_its_text() {
    let page = pages().into_iter().find(|page| page.path == "docs/errors.md").expect("the page of errors");
    let blocks = page.blocks();
    let alone: Vec<_> = blocks.iter().filter(|block| block.kind == "forms,alone").collect();
    let (mut rows, mut wrong) = (0, vec![]);
    for (line, text) in (1..).zip(page.text.lines()) {
        let above = alone.iter().take_while(|block| block.line < line).last();
        let cells = cells(text);
        let (Some(block), [text, said, help]) = (above, cells.as_slice()) else { continue };
        let Some(text) = text.strip_prefix('`').and_then(|text| text.strip_suffix('`')) else { continue };
        rows += 1;
        let (.., found) = read_file(&format!("{}\n{text}\n", block.text));
        let found: Vec<_> =
            found.iter().map(|error| (error.message.as_str(), error.help.as_deref().unwrap_or(""))).collect();
        if found != [(said.as_str(), help.as_str())] {
            wrong.push(format!("docs/errors.md:{line}: `{text}` is told {found:?}"));
        }
    }
    println!("{rows} rows of errors were checked");
    assert!(rows > 100, "only {rows} rows were found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Splits a row of a table into its cells, and unescapes bars and brackets.
fn cells(row: &str) -> Vec<String> {
    let Some(inner) = row.strip_prefix('|').and_then(|row| row.strip_suffix('|')) else { return vec![] };
    let (bar, kept) = ("\\|", "\u{0}");
    let plain =
        |cell: &str| cell.replace(kept, "|").replace("\\[", "[").replace("\\]", "]").trim().to_owned();
    inner.replace(bar, kept).split('|').map(plain).collect()
}

#[test]
fn blocks_are_closed_and_of_a_known_kind() {
    // These kinds are tested by forms-radiometry.
    let scenes = ["toml,error", "toml,refused", "xml", "xml,error", "obj,error", "ply,error", "csv,error"];
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

/// Returns the targets of the workspace, as `(package, kind, name)`, from cargo.
fn targets() -> BTreeSet<(String, String, String)> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let arguments = ["metadata", "--no-deps", "--offline", "--format-version", "1"];
    let output = Command::new(cargo).current_dir(root()).args(arguments).output().expect("cargo runs");
    let metadata: Value = serde_json::from_slice(&output.stdout).expect("JSON of cargo");
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let text = |value: &Value| value.as_str().unwrap_or_default().to_owned();
    let mut targets = BTreeSet::new();
    for package in list(&metadata["packages"]) {
        for target in list(&package["targets"]) {
            let (package, name) = (text(&package["name"]), text(&target["name"]));
            targets
                .extend(list(&target["kind"]).iter().map(|kind| (package.clone(), text(kind), name.clone())));
        }
    }
    targets
}

/// Returns the cargo commands on a page, each with its line: those of shell blocks, and those
/// between backquotes.
fn cargo_commands(text: &str) -> Vec<(usize, String)> {
    let mut found = vec![];
    for (number, line) in (1..).zip(text.lines()) {
        let quoted = line.split('`').skip(1).step_by(2);
        for command in std::iter::once(line).chain(quoted) {
            let command = command.trim_start_matches("FORMS_WRITE=1 ");
            if let Some(words) = command.strip_prefix("cargo ") {
                found.push((number, words.split(" #").next().unwrap_or_default().to_owned()));
            }
        }
    }
    found
}

/// Returns the target or package named by a cargo command, if it does not exist.
fn missing_target(command: &str, targets: &BTreeSet<(String, String, String)>) -> Option<String> {
    let words: Vec<&str> = command.split_whitespace().take_while(|word| *word != "--").collect();
    let named = |option: &str| {
        let place = words.iter().position(|word| *word == option)?;
        words.get(place + 1).copied().filter(|name| !name.starts_with('-'))
    };
    let package = named("-p");
    let is_of_package = |of: &str| package.is_none_or(|package| package == of);
    if let Some(package) = package.filter(|_| !targets.iter().any(|(of, ..)| is_of_package(of))) {
        return Some(format!("the package {package}"));
    }
    ["bench", "example", "test", "bin"].into_iter().find_map(|kind| {
        let name = named(&format!("--{kind}"))?;
        let exists = targets.iter().any(|(of, is, has)| is_of_package(of) && is == kind && has == name);
        (!exists).then(|| format!("the {kind} {name}"))
    })
}

#[test]
fn commands_of_cargo_name_packages_and_targets_that_exist() {
    let targets = targets();
    let more = ["CONTRIBUTING.md", "scenes/README.md"];
    let more = more.map(|path| Page::new(path, std::fs::read_to_string(root().join(path)).expect("a page")));
    let (mut commands, mut wrong) = (0, vec![]);
    for page in pages().into_iter().chain(more) {
        for (line, command) in cargo_commands(&page.text) {
            commands += 1;
            let missing = missing_target(&command, &targets);
            wrong.extend(
                missing.map(|missing| format!("{}:{line}: `cargo {command}`: no {missing}", page.path)),
            );
        }
    }
    assert!(commands > 20, "only {commands} commands were found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    let missing = |command| missing_target(command, &targets);
    assert_eq!(
        missing("bench -p forms-math --bench nothing -- --write"),
        Some("the bench nothing".to_owned())
    );
    assert_eq!(missing("test -p forms-nothing"), Some("the package forms-nothing".to_owned()));
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
