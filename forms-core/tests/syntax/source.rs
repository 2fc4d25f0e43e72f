//! Rendering of diagnostics on a terminal.

use forms_core::diagnostic::{Diagnostic, Span};
use forms_core::syntax::Position;
use forms_core::syntax::{Source, read};

/// Returns all diagnostics of a text, rendered.
fn rendered(text: &str) -> String {
    let source = Source::new("box.forms", text);
    read(text).1.iter().map(|diagnostic| source.render(diagnostic)).collect()
}

#[test]
fn a_missing_semicolon_is_marked_behind_the_line() {
    let expected = "\
error: expected `;` after the statement, found `prove`
  --> box.forms:3:14
   |
 3 | let r = x + y
   |              ^
";
    assert_eq!(rendered("chart R2(x, y);\n\nlet r = x + y\nprove p: r == r;"), expected);
}

#[test]
fn the_open_bracket_and_the_hint_follow_the_line() {
    let expected = "\
error: expected an operator or `)`, found `y`
  --> box.forms:10:12
    |
 10 | let a = (x y);
    |            ^
    = note: the `(` to close is at 10:9
    = help: write `*` between factors
"
    .replace("  --> ", "   --> ");
    assert_eq!(rendered(&format!("{}let a = (x y);", "\n".repeat(9))), expected);
}

#[test]
fn a_tab_is_one_column_and_a_carriage_return_none() {
    let expected = "\
error: `2x` is not a number
  --> box.forms:1:10
   |
 1 |  let a = 2x;
   |          ^^
   = help: write `2*x` for a product
";
    assert_eq!(rendered("\tlet a = 2x;\r\n"), expected);
}

#[test]
fn a_span_over_several_lines_is_marked_to_the_end_of_the_first() {
    let source = Source::new("two", "let a =\r\n  1;\n");
    let marked = source.render(&Diagnostic::new(Span::new(4, 12), "here"));
    assert_eq!(marked, "error: here\n  --> two:1:5\n   |\n 1 | let a =\n   |     ^^^\n");
}

#[test]
fn a_long_line_is_cut_about_its_mark() {
    for place in [0_u32, 1, 60, 250, 439, 440, 441, 499] {
        let source = Source::new("long", format!("{}{}", "ab".repeat(250), "\nnext"));
        for length in [0, 1, 3, 499 - place] {
            let text = source.render(&Diagnostic::new(Span::new(place, place + length), "here"));
            let lines: Vec<&str> = text.lines().collect();
            let [quote, marks] = [lines[3], lines[4]].map(|line| line.chars().skip(5).collect::<Vec<_>>());
            assert!(quote.len() <= 102 && marks.len() <= quote.len(), "{text}");
            let mark = marks.iter().position(|&c| c == '^').expect("there is a mark");
            let expected = if place % 2 == 0 { 'a' } else { 'b' };
            assert_eq!(quote[mark], expected, "{place} {length}\n{text}");
        }
    }
}

#[test]
fn columns_count_characters_and_lines_begin_at_one() {
    let source = Source::new("text", "αβ\nγ");
    let cases = [(0, 1, 1), (1, 1, 1), (2, 1, 2), (4, 1, 3), (5, 2, 1), (7, 2, 2), (99, 2, 2)];
    for (offset, line, column) in cases {
        assert_eq!(source.position(offset), Position { line, column }, "{offset}");
    }
}

#[test]
fn an_empty_text_can_be_pointed_at() {
    let source = Source::new("empty", "");
    let text = source.render(&Diagnostic::new(Span::default(), "nothing here"));
    assert_eq!(text, "error: nothing here\n  --> empty:1:1\n   |\n 1 | \n   | ^\n");
}
