//! Diagnostics for each kind of error: the message, its place, the related place and the hint.
//!
//! Each file under `diagnostics` is a table of blocks: a text, followed by all its diagnostics.

use forms_core::check::read_file;
use forms_core::diagnostic::Diagnostic;
use forms_core::resolve::resolve;
use forms_core::syntax::{Source, end_of, lex, parse, read, words};
use std::fmt::Write;
use std::path::Path;

/// Returns the diagnostics of the parser.
fn said_about(text: &str) -> String {
    table_of(text, read(text).1)
}

/// Returns the diagnostics of resolution for a text without syntax errors.
fn said_about_the_meaning(text: &str) -> String {
    let (file, mistakes) = read(text);
    assert_eq!(mistakes, [], "{text}");
    table_of(text, resolve(&file).1)
}

/// Returns the diagnostics of the parser, and of resolution for the items that can be read.
fn said_about_all(text: &str) -> String {
    table_of(text, read_file(text).2)
}

/// Formats diagnostics as in the tables.
fn table_of(text: &str, diagnostics: Vec<Diagnostic>) -> String {
    let source = Source::new("table", text);
    let mut said = String::new();
    let position = |place: u32| {
        let position = source.position(place);
        format!("{}:{}", position.line, position.column)
    };
    for diagnostic in diagnostics {
        writeln!(said, "{} {}", position(diagnostic.span.start), diagnostic.message).unwrap();
        if let Some((span, name)) = diagnostic.related {
            writeln!(said, "    note: {name} is at {}", position(span.start)).unwrap();
        }
        if let Some(help) = diagnostic.help {
            writeln!(said, "    help: {help}").unwrap();
        }
    }
    said
}

/// Whether a line of a table begins a diagnostic: `3:14 expected …`.
fn is_diagnostic(line: &str) -> bool {
    line.split_once(' ')
        .and_then(|(place, _)| place.split_once(':'))
        .is_some_and(|(line, column)| line.parse::<usize>().is_ok() && column.parse::<usize>().is_ok())
}

/// Checks every block of one table.
fn check(table: &str, said_about: fn(&str) -> String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/syntax/diagnostics/{table}.txt"));
    let blocks = std::fs::read_to_string(path).expect("the table is there");
    let mut count = 0;
    for block in blocks.split("\n\n") {
        let lines: Vec<&str> = block.lines().collect();
        let split = lines.iter().position(|line| is_diagnostic(line)).expect("a block says something");
        let text = lines[..split].join("\n");
        assert_eq!(said_about(&text).trim_end(), lines[split..].join("\n"), "\nabout: {text}");
        count += 1;
    }
    assert!(count >= 5, "{table} has only {count} blocks");
}

macro_rules! tables {
    ($said_about:ident: $($claim:ident $table:literal,)*) => {
        $(#[test] fn $claim() { check($table, $said_about); })*
    };
}

tables! {
    said_about:
    what_is_no_number_is_explained "numbers",
    each_foreign_character_is_named "characters",
    the_end_of_a_statement_is_explained "statement_ends",
    an_open_bracket_is_pointed_at "brackets",
    a_broken_expression_is_explained "expressions",
    a_broken_equation_is_explained "equations",
    a_broken_definition_is_explained "definitions",
    a_broken_declaration_is_explained "declarations",
    a_broken_kernel_is_explained "kernels",
    several_mistakes_are_each_reported_once "recovery",
}

tables! {
    said_about_the_meaning:
    an_operation_says_what_it_takes "operations",
    a_declaration_that_means_nothing_is_explained "items",
    an_integral_that_is_not_found_is_explained "integrals",
    a_shape_that_does_not_fit_is_explained "arrays",
    a_call_that_means_nothing_is_explained "calls",
}

tables! {
    said_about_all:
    what_only_follows_from_an_error_is_not_reported_and_all_else_is "consequences",
    what_other_languages_write_leads_to_what_is_written_here "other_languages",
}

#[test]
fn an_invisible_character_is_named_by_its_number() {
    let cases = [
        ("let a = x\u{a0}+ y;", "1:10 unexpected character U+00A0\n    help: write an ordinary space\n"),
        ("let a = x\u{200b}+ y;", "1:10 unexpected character U+200B\n"),
        ("let a = 1 \0;", "1:11 unexpected character U+0000\n"),
    ];
    for (text, expected) in cases {
        assert_eq!(said_about(text), expected, "{text:?}");
    }
}

#[test]
fn a_mark_at_the_start_of_a_file_is_no_character() {
    assert_eq!(said_about("\u{feff}let a = 1;\r\nlet b = a;\r\n"), "");
}

#[test]
fn no_word_of_the_language_is_a_name() {
    let inside = ["where", "jump", "effects", "if", "else", "on", "pub"];
    for word in words::ITEMS.iter().chain(words::FUNCTIONS).chain(&inside) {
        let said = said_about(&format!("let {word} = 1;"));
        let reason = format!("1:5 `{word}` is ");
        assert!(said.starts_with(&reason) && said.contains(" and cannot be a name\n"), "{said}");
        assert_eq!(said.lines().count(), 2, "{said}");
    }
}

#[test]
fn keywords_of_rust_are_names_in_files_and_not_in_macros() {
    for word in ["gen", "type", "Self", "self", "async", "try", "_", "match", "in", "crate", "true"] {
        let text = format!(
            "chart C({word}, y); let a = {word} + y; prove {word}: d({word}*y) == y*d{word} + {word}*dy;"
        );
        assert_eq!(said_about(&text), "", "{text}");
        let tokens = lex(&text).0;
        let (_, diagnostics) = parse(&tokens, end_of(&text));
        assert_eq!(diagnostics[0].message, format!("`{word}` is a Rust keyword and cannot be a name"));
    }
}

#[test]
fn a_statement_may_be_named_like_a_function_and_like_nothing_else_reserved() {
    for word in words::FUNCTIONS {
        assert_eq!(said_about(&format!("prove {word}: x == x;")), "");
    }
    for word in words::ITEMS {
        assert_eq!(said_about(&format!("prove {word}: x == x;")).lines().count(), 2);
    }
}
