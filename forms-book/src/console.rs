//! Blocks of the kind `console`: commands and the expected output of the program.
//!
//! ```text
//! $ forms eval page.forms k << END   a command, and the input up to END
//! 1,2
//! END
//! …                                  any lines
//! 3                                  this line; durations in it are not compared
//! ```

use crate::check::inside;
use crate::page::{Block, Page};
use crate::theory::common_text;
use std::ops::Range;

/// Wildcard for any number of lines.
const ANY: &str = "…";

/// Call of the program on a page, with the output quoted there.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// Line of the command, from 1.
    pub line: usize,
    /// The command as written.
    pub command: String,
    /// Arguments after the name of the program.
    pub arguments: Vec<String>,
    /// Standard input.
    pub input: String,
    /// Expected output; a line `…` matches any lines.
    pub output: String,
    /// Text of the file `page.forms`: all blocks of the page's common theory before this call.
    pub theory: String,
    place: Range<usize>,
}

/// Returns the calls of a page, in order. An error is a line that is not part of a call, with a
/// message.
///
/// # Errors
/// If a block does not begin with `$ forms`, or if the end of an input is missing.
pub fn calls(page: &Page) -> Result<Vec<Call>, (usize, String)> {
    let blocks = page.blocks();
    let mut calls = Vec::new();
    for (place, block) in blocks.iter().enumerate().filter(|(_, block)| block.kind == "console") {
        calls.extend(calls_of(page, block, &common_text(&blocks[..place]))?);
    }
    Ok(calls)
}

fn calls_of(page: &Page, block: &Block, theory: &str) -> Result<Vec<Call>, (usize, String)> {
    let (mut calls, mut end_of_input): (Vec<Call>, Option<String>) = (Vec::new(), None);
    let mut offset = inside(page, block).start;
    for (number, line) in block.text.split_inclusive('\n').enumerate() {
        let at = block.line + 1 + number;
        offset += line.len();
        match (line.strip_prefix("$ "), calls.last_mut(), &end_of_input) {
            (_, Some(call), Some(end)) => {
                call.place = offset..offset;
                if line.trim_end() == end {
                    end_of_input = None;
                } else {
                    call.input.push_str(line);
                }
            }
            (Some(command), ..) => {
                let (command, arguments, end) = words(command).ok_or((at, "expected `$ forms …`".into()))?;
                end_of_input = end;
                let (input, output, theory) = (String::new(), String::new(), theory.to_owned());
                calls.push(Call {
                    line: at,
                    command,
                    arguments,
                    input,
                    output,
                    theory,
                    place: offset..offset,
                });
            }
            (None, Some(call), None) => {
                call.output.push_str(line);
                call.place.end = offset;
            }
            (None, None, _) => {
                return Err((at, "expected `$ forms …` in the first line of the block".into()));
            }
        }
    }
    match end_of_input {
        Some(end) => Err((block.line, format!("the input is not terminated: the line `{end}` is missing"))),
        None => Ok(calls),
    }
}

/// Splits a command line into the command, its arguments, and the word that ends its input.
fn words(command: &str) -> Option<(String, Vec<String>, Option<String>)> {
    let command = command.trim_end();
    let (call, end) = match command.split_once("<<") {
        Some((call, end)) => (call, Some(end.trim().to_owned())),
        None => (command, None),
    };
    let mut words = call.split_whitespace().map(str::to_owned);
    (words.next().as_deref() == Some("forms")).then(|| (command.to_owned(), words.collect(), end))
}

impl Call {
    /// Whether the output matches the quotation on the page.
    pub fn expects(&self, printed: &str) -> bool {
        agrees(&self.output, printed)
    }

    /// Returns the new quotation for an output: it keeps the number of lines that the old one has
    /// before and after `…`.
    fn rewritten(&self, printed: &str) -> String {
        let old: Vec<&str> = self.output.lines().collect();
        let new: Vec<&str> = printed.lines().map(str::trim_end).collect();
        let all = || new.iter().map(|line| format!("{line}\n")).collect();
        let mut elided = old.iter().enumerate().filter(|(_, line)| line.trim() == ANY);
        let (Some((before, _)), None) = (elided.next(), elided.next()) else { return all() };
        let behind = old.len() - before - 1;
        if before + behind >= new.len() {
            return all();
        }
        let kept = [&new[..before], &[ANY], &new[new.len() - behind..]].concat();
        kept.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// Whether an output matches a quotation line by line. Durations are ignored, and a line `…`
/// matches any lines.
pub fn agrees(quoted: &str, printed: &str) -> bool {
    let without_times = |text: &str| text.lines().map(without_times).collect::<Vec<_>>();
    let (quoted, printed) = (without_times(quoted), without_times(printed));
    let mut parts = quoted.split(|line| line.trim() == ANY);
    let Some(mut rest) = parts.next().and_then(|first| printed.strip_prefix(first)) else { return false };
    let mut parts: Vec<&[String]> = parts.collect();
    let Some(last) = parts.pop() else { return rest.is_empty() };
    for part in parts.into_iter().filter(|part| !part.is_empty()) {
        let Some(found) = rest.windows(part.len()).position(|lines| lines == part) else { return false };
        rest = &rest[found + part.len()..];
    }
    rest.ends_with(last)
}

/// Returns the page with the current outputs of its calls. Outputs that differ only in durations
/// stay unchanged.
pub fn with_outputs(page: &Page, outputs: &[(Call, String)]) -> Page {
    let mut text = page.text.clone();
    for (call, printed) in outputs.iter().rev().filter(|(call, printed)| !call.expects(printed)) {
        text.replace_range(call.place.clone(), &call.rewritten(printed));
    }
    Page::new(&page.path, text)
}

/// Replaces each duration in a line, with the spaces around it, by the same word.
fn without_times(line: &str) -> String {
    const UNITS: [&str; 6] = ["µs", "ms", "s", "ns", "min", "h"];
    let (mut kept, mut rest) = (String::new(), line.trim_end());
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let digits =
            rest[start..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(rest.len() - start);
        let (before, number, behind) =
            (&rest[..start], &rest[start..start + digits], &rest[start + digits..]);
        let stands_alone = before.is_empty() || before.ends_with([' ', '(']);
        let unit = behind
            .strip_prefix(' ')
            .map(|unit| unit.split([' ', ',', ')', ';', ':', '.']).next().unwrap_or(unit));
        match unit.filter(|unit| stands_alone && UNITS.contains(unit)) {
            Some(unit) => {
                kept.push_str(before.trim_end_matches(' '));
                kept.push_str(" TIME");
                rest = &behind[1 + unit.len()..];
                if rest.starts_with(' ') {
                    kept.push(' ');
                    rest = rest.trim_start_matches(' ');
                }
            }
            None => {
                kept.push_str(before);
                kept.push_str(number);
                rest = behind;
            }
        }
    }
    kept += rest;
    // A column of times is as wide as its longest entry.
    if let Some(heads) = kept.strip_suffix(" time") {
        kept = format!("{} time", heads.trim_end_matches(' '));
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: &str = "```forms\nchart P(x);\n```\n\n```console\n$ forms eval page.forms k << END\na\nEND\na,k\n…\n2,3\n\
        $ forms prove page.forms\n  ✓ one     proved    139 µs\n```\n\n```forms\nlet a = 1;\n```\n";

    fn page_calls(text: &str) -> Vec<Call> {
        calls(&Page::new("page.md", text)).expect("calls")
    }

    #[test]
    fn a_call_has_its_arguments_its_input_and_the_theory_up_to_it() {
        let calls = page_calls(PAGE);
        assert_eq!(calls.len(), 2);
        assert_eq!(calls[0].arguments, ["eval", "page.forms", "k"]);
        assert_eq!((calls[0].input.as_str(), calls[0].theory.as_str()), ("a\n", "chart P(x);\n"));
        assert_eq!((calls[0].line, calls[1].line), (6, 12));
    }

    #[test]
    fn only_times_and_elided_lines_may_differ() {
        let calls = page_calls(PAGE);
        for printed in ["a,k\n1,2\n2,3\n", "a,k\n2,3\n"] {
            assert!(calls[0].expects(printed), "{printed}");
        }
        for printed in ["a,k\n1,2\n2,4\n", "a,k\n", "b,k\n2,3\n", "a,k\n2,3\n\n4\n"] {
            assert!(!calls[0].expects(printed), "{printed}");
        }
        assert!(calls[1].expects("  ✓ one     proved     1.4 ms\n"));
        assert!(!calls[1].expects("  ✓ one     refuted    1.4 ms\n"));
        assert!(!calls[1].expects("  ✓ one     proved    139 m\n"));
    }

    #[test]
    fn a_quotation_that_differs_is_noticed() {
        let printed = "a   1.2 ms\nb 5 W\n\nc\nd in 3 s";
        for right in
            ["a 7 µs\n…", "…\nb 5 W\n\nc\n…", "…\nc\nd in 4.5 ms", "a 1 s\nb 5 W\n\nc\nd in 3 s", "…"]
        {
            assert!(agrees(right, printed), "{right}");
        }
        for wrong in
            ["a 7 µs", "b 5 W\n…", "…\nb 6 W\n…", "a 1 s\nc\n…", "…\nd in 3 s\ne", "…\nc\n…\nb 5 W\n…"]
        {
            assert!(!agrees(wrong, printed), "{wrong}");
        }
    }

    #[test]
    fn outputs_are_written_anew_where_they_differ() {
        let page = Page::new("page.md", PAGE);
        let outputs = |first: &str, second: &str| {
            let printed = [first, second].map(str::to_owned);
            page_calls(PAGE).into_iter().zip(printed).collect::<Vec<_>>()
        };
        let same = with_outputs(&page, &outputs("a,k\n2,3\n", "  ✓ one     proved      5 µs\n"));
        assert_eq!(same, page);
        let new = with_outputs(&page, &outputs("a,k\n1,2\n5,5\n5,6\n", "  ✗ one     unknown   5 µs\n"));
        assert!(new.text.contains("END\na,k\n…\n5,6\n$ forms"), "{}", new.text);
        assert!(new.text.contains("page.forms\n  ✗ one     unknown   5 µs\n```"), "{}", new.text);
    }

    #[test]
    fn what_is_no_call_is_an_error() {
        for (block, line) in [("$ ls\n", 2), ("output\n", 2), ("$ forms eval - k << END\n1\n", 1)] {
            let page = Page::new("page.md", format!("```console\n{block}```\n"));
            assert_eq!(calls(&page).map_err(|(line, _)| line), Err(line), "{block}");
        }
    }
}
