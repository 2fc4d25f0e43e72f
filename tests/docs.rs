//! What the documents print is what happens.
//!
//! ```text
//! README.md, docs/**/*.md ─ fenced blocks ─┬─ forms         one theory a page, every statement as claimed, every kernel generated
//!                                          ├─ forms,alone   the same, a theory of its own
//!                                          └─ forms,error   exactly the message quoted in the next block
//! ```
//! Rust blocks are doctests of the crate `forms`. With `FORMS_WRITE=1` quoted messages are written anew.

use forms::core::check::{decide_all, objection, read_theory};
use forms::core::generation::generate;
use forms::core::syntax::Source;
use std::path::{Path, PathBuf};

/// A fenced block: what stands behind the fence, and the lines up to the closing one.
#[derive(Debug, PartialEq, Eq)]
struct Block {
    kind: String,
    text: String,
}

/// The fenced blocks of a page, in order.
fn blocks(page: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for line in page.lines() {
        match (line.strip_prefix("```"), &mut open) {
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (Some(kind), None) => open = Some(Block { kind: kind.trim().to_string(), text: String::new() }),
            (None, Some(block)) => block.text = format!("{}{line}\n", block.text),
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block is not closed: {open:?}");
    blocks
}

/// Everything the library says about a text: errors, or statements that are not as claimed and kernels that cannot be
/// generated.
fn complaints(name: &str, text: &str) -> String {
    let source = Source::new(name, text);
    let (mut theory, mut diagnostics) = read_theory(text);
    if diagnostics.is_empty() {
        let verdicts = decide_all(&mut theory);
        let pairs = theory.statements.iter().zip(&verdicts);
        diagnostics.extend(pairs.filter_map(|(statement, verdict)| objection(statement, verdict)));
        for kernel in theory.kernels.clone() {
            diagnostics.extend(generate(&mut theory.pool, &kernel).err().into_iter().flatten());
        }
    }
    let shown: Vec<String> = diagnostics.iter().map(|diagnostic| source.render(diagnostic)).collect();
    shown.join("\n")
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The files below a folder with an ending, in alphabetical order.
fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    let mut found: Vec<PathBuf> = entries
        .flat_map(|path| if path.is_dir() { files(&path, ending) } else { vec![path] })
        .filter(|path| path.extension().is_some_and(|found| found == ending))
        .collect();
    found.sort();
    found
}

/// Path below the root, and text, of every page.
fn pages() -> Vec<(String, String)> {
    let mut paths = vec![root().join("README.md")];
    paths.extend(files(&root().join("docs"), "md"));
    let page = |path: PathBuf| {
        let name = path.strip_prefix(root()).unwrap().to_string_lossy().into_owned();
        (name, std::fs::read_to_string(path).unwrap())
    };
    paths.into_iter().map(page).collect()
}

#[test]
fn every_statement_of_every_page_is_as_claimed() {
    let mut wrong = Vec::new();
    let mut statements = 0;
    for (name, page) in pages() {
        let mut theories = vec![String::new()];
        for block in blocks(&page) {
            match block.kind.as_str() {
                "forms" => theories[0].push_str(&block.text),
                "forms,alone" => theories.push(block.text),
                _ => {}
            }
        }
        for theory in &theories {
            statements += theory.matches("prove ").count() + theory.matches("refute ").count();
            wrong.push(complaints(&name, theory));
        }
    }
    wrong.retain(|complaint| !complaint.is_empty());
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(statements > 50, "only {statements} statements were found");
}

/// A source with an error, and the message quoted beneath it.
fn quotation(source: &str, message: &str) -> String {
    format!("```forms,error\n{source}```\n\n```text\n{message}```\n")
}

#[test]
fn every_error_is_quoted_as_it_is_shown() {
    let mut quoted = 0;
    for (name, page) in pages() {
        let mut mended = page.clone();
        let blocks = blocks(&page);
        for (place, block) in blocks.iter().enumerate().filter(|(_, block)| block.kind == "forms,error") {
            let shown = complaints("example.forms", &block.text);
            let shown: String = shown.lines().map(|line| format!("{}\n", line.trim_end())).collect();
            let found = blocks.get(place + 1).map_or("", |next| next.text.as_str());
            mended = mended.replace(&quotation(&block.text, found), &quotation(&block.text, &shown));
            assert!(!shown.is_empty(), "{name}: no error in\n{}", block.text);
            assert!(
                mended.contains(&quotation(&block.text, &shown)),
                "{name}: no message below\n{}",
                block.text
            );
            quoted += 1;
        }
        if std::env::var_os("FORMS_WRITE").is_some() {
            std::fs::write(root().join(&name), &mended).unwrap();
        } else {
            assert_eq!(page, mended, "{name}: FORMS_WRITE=1 cargo test --test docs");
        }
    }
    assert!(quoted > 0, "no page shows an error");
}

#[test]
fn blocks_are_of_a_known_kind() {
    let known = ["forms", "forms,alone", "forms,error", "rust", "text", "sh", "toml"];
    // These are run by the tests of forms-radiometry.
    let scenes = ["toml,error", "toml,refused", "xml", "xml,error", "obj,error", "ply,error"];
    for (name, page) in pages() {
        for block in blocks(&page) {
            let is_known =
                |kind| known.contains(&kind) || (name == "docs/scenes.md" && scenes.contains(&kind));
            assert!(is_known(block.kind.as_str()), "{name}: ```{}\n{}", block.kind, block.text);
        }
    }
}

/// The targets of the links of a page; code is no link.
fn links(page: &str) -> Vec<String> {
    let outside_blocks: String = page.split("```").step_by(2).collect();
    let outside_code: String = outside_blocks.split('`').step_by(2).collect();
    let targets = outside_code.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    targets.map(str::to_string).collect()
}

#[test]
fn links_between_pages_lead_somewhere() {
    let mut followed = 0;
    for (name, page) in pages() {
        let page_path = root().join(&name);
        for target in links(&page) {
            let file = target.split('#').next().unwrap_or_default();
            if !file.starts_with("http") && !file.is_empty() {
                assert!(page_path.with_file_name(file).exists(), "{name} links to {target}");
                followed += 1;
            }
        }
    }
    assert!(followed > 10, "only {followed} links were found");
}

#[test]
fn a_false_line_on_a_page_is_noticed() {
    let page = "# Title\n```forms\nchart P(x, y);\n```\ntext\n```forms\nprove wrong: dx^dy == dy^dx;\n```\n";
    let theory: String = blocks(page).into_iter().map(|block| block.text).collect();
    let complaint = complaints("page.md", &theory);
    assert!(complaint.contains("`wrong` is false"), "{complaint}");
}
