//! The rules of figures: one crate writes them, each says what it shows, and each has a caption.

use std::fs;
use std::path::PathBuf;

use fancy_regex::Regex;
use forms_tidy::workspace::{files, root, shown};

/// Crate that writes SVG.
const WRITER: &str = "forms-figures/";

/// Returns the lines of a text that match a pattern, as `path:line`.
fn lines(path: &str, text: &str, pattern: &Regex) -> Vec<String> {
    let matches = |line: &str| pattern.is_match(line).expect("a simple pattern");
    let found = (1..).zip(text.lines()).filter(|(_, line)| matches(line));
    found.map(|(number, _)| format!("{path}:{number}")).collect()
}

fn texts(extension: &str, folder: &str) -> Vec<(String, String)> {
    let root = root();
    let read = |path: PathBuf| (shown(&path, &root), fs::read_to_string(&path).expect("text"));
    files(&root.join(folder), extension).into_iter().map(read).collect()
}

#[test]
fn one_crate_writes_svg() {
    // `<path value=` is an element of Mitsuba scenes
    let element = "<(svg|path|line|rect|text|circle|polyline|polygon|g) (?!value=)[a-z]";
    let element = Regex::new(element).expect("a pattern");
    let others = texts("rs", "").into_iter().filter(|(path, _)| !path.starts_with(WRITER));
    let found: Vec<String> = others.flat_map(|(path, text)| lines(&path, &text, &element)).collect();
    assert!(found.is_empty(), "figures are drawn by {WRITER}: {found:#?}");
    let drawn = format!("let a = 1;\nput(\"<{} class=…\");", "rect");
    assert_eq!(lines("a.rs", &drawn, &element), ["a.rs:2"]);
}

#[test]
fn a_figure_has_a_name_a_description_and_two_themes() {
    let figures = texts("svg", "docs");
    assert!(figures.len() > 100, "only {} figures were found", figures.len());
    for (path, text) in figures {
        for part in ["<title>", "<desc>", "role=\"img\"", "prefers-color-scheme:dark"] {
            assert!(text.contains(part), "{path} has no {part}");
        }
    }
}

#[test]
fn a_figure_has_a_caption_below_it() {
    let mut count = 0;
    for (path, text) in texts("md", "docs") {
        let shown: Vec<&str> = text.lines().filter(|line| !line.is_empty()).collect();
        for pair in shown.windows(2).filter(|pair| pair[0].starts_with("![") && pair[0].ends_with(".svg)")) {
            assert!(pair[1].starts_with("*Figure "), "{path}: {} has no caption", pair[0]);
            count += 1;
        }
    }
    assert!(count > 100, "only {count} figures were found");
}
