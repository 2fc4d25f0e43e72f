//! Checks of a page: its statements hold, its quoted messages are current, and its exercises have
//! the given answers.
//!
//! ```text
//! Page ─┬─ forms, forms,alone            every statement as claimed, every kernel generated
//!       ├─ forms,error + text            exactly the message quoted in the next block
//!       └─ forms,exercise + forms,answer decided with the answer, not accepted with the hole
//! ```

use crate::page::{Block, Page};
use crate::theory::{Counted, common_text, findings, message, sources};
use forms_core::syntax::Source;
use rayon::prelude::*;
use std::fmt;

/// Placeholder in an exercise for the answer.
const HOLE: &str = "___";

/// Kinds of blocks allowed on a page.
const KINDS: [&str; 10] = [
    "forms",
    "forms,alone",
    "forms,error",
    "forms,exercise",
    "forms,answer",
    "console",
    "rust",
    "text",
    "sh",
    "toml",
];

/// Problem on a page.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Problem {
    /// Path of the page.
    pub page: String,
    /// Line, from 1.
    pub line: usize,
    /// Description of the problem.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}: {}", self.page, self.line, self.message)
    }
}

/// Result of checking pages.
#[derive(Clone, Debug, Default)]
pub struct Report {
    /// Problems, in the order of the pages.
    pub problems: Vec<Problem>,
    /// Numbers of checked items.
    pub counted: Counted,
}

impl Report {
    /// Adds the problems and counts of another report.
    pub fn add(&mut self, other: Report) {
        self.problems.extend(other.problems);
        self.counted += other.counted;
    }
}

impl Page {
    pub(crate) fn problem(&self, line: usize, message: impl Into<String>) -> Problem {
        Problem { page: self.path.clone(), line, message: message.into() }
    }
}

/// Checks the theories and exercises of a page.
pub fn check_theories(page: &Page) -> Report {
    let blocks = page.blocks();
    let mut report = Report::default();
    for source in sources(page, &blocks) {
        let found = findings(&source, 0);
        report.counted += found.counted;
        report.problems.extend(found.complaints.into_iter().map(|(line, shown)| page.problem(line, shown)));
    }
    // No exercise can be decided on a theory with errors.
    if report.problems.is_empty() {
        let common = common_text(&blocks);
        let exercises: Vec<Report> = (0..blocks.len())
            .into_par_iter()
            .filter_map(|place| {
                exercise(page, &common, &blocks[place..], place.checked_sub(1).map(|p| &blocks[p]))
            })
            .collect();
        exercises.into_iter().for_each(|found| report.add(found));
    }
    report
}

/// Checks the exercise in the first of these blocks, or returns `None` if that block is not part of
/// one.
fn exercise(page: &Page, common: &str, blocks: &[Block], before: Option<&Block>) -> Option<Report> {
    let (block, next) = (blocks.first()?, blocks.get(1));
    let is = |block: Option<&Block>, kind: &str| block.is_some_and(|block| block.kind == kind);
    let mut report = Report::default();
    match (block.kind.as_str(), next) {
        ("forms,answer", _) if !is(before, "forms,exercise") => {
            report.problems.push(page.problem(block.line, "an answer without an exercise right before it"));
        }
        ("forms,exercise", Some(answer)) if is(next, "forms,answer") => {
            report.counted.exercises += 1;
            report.add(answered(page, common, block, answer));
            report.problems.extend(unanswered(page, common, block));
        }
        ("forms,exercise", _) => {
            report
                .problems
                .push(page.problem(block.line, "an exercise without a `forms,answer` right after it"));
        }
        _ => return None,
    }
    Some(report)
}

/// Checks that the answer fills the holes of the exercise, changes nothing else, and is decided as
/// stated.
fn answered(page: &Page, common: &str, exercise: &Block, answer: &Block) -> Report {
    let mut report = Report::default();
    if !exercise.text.contains(HOLE) {
        report.problems.push(page.problem(exercise.line, format!("an exercise without a hole {HOLE}")));
    } else if !fills(&exercise.text, &answer.text) {
        report
            .problems
            .push(page.problem(answer.line, "the answer differs from the exercise outside its holes"));
    }
    let source = Source::new("page.forms", format!("{common}{}", answer.text));
    let found = findings(&source, common.len());
    report.counted += found.counted;
    if found.complaints.is_empty() && found.counted.statements + found.counted.kernels == 0 {
        report.problems.push(page.problem(answer.line, "the answer contains no statement and no kernel"));
    }
    let complaints = found.complaints.into_iter();
    report
        .problems
        .extend(complaints.map(|(_, shown)| page.problem(answer.line, format!("the answer:\n{shown}"))));
    report
}

/// Checks that the exercise with its hole is rejected, and that the hole is the reason.
fn unanswered(page: &Page, common: &str, exercise: &Block) -> Option<Problem> {
    let source = Source::new("page.forms", format!("{common}{}", exercise.text));
    let complaints = findings(&source, common.len()).complaints;
    let is_about_hole = complaints.iter().any(|(_, shown)| shown.contains(&format!("`{HOLE}`")));
    (!is_about_hole).then(|| page.problem(exercise.line, "the exercise is accepted with its hole"))
}

/// Whether the answer equals the exercise with a non-empty text in place of each hole. White space
/// is ignored.
fn fills(exercise: &str, answer: &str) -> bool {
    let joined = |text: &str| text.split_whitespace().collect::<String>();
    let (exercise, answer) = (joined(exercise), joined(answer));
    let mut pieces = exercise.split(HOLE);
    let Some(mut rest) = pieces.next().and_then(|first| answer.strip_prefix(first)) else { return false };
    let mut pieces: Vec<&str> = pieces.collect();
    let last = pieces.pop();
    for piece in pieces {
        let filled = rest.split_once(piece).filter(|(filled, _)| !filled.is_empty());
        let Some((_, behind)) = filled else { return false };
        rest = behind;
    }
    last.map_or(rest.is_empty(), |last| rest.ends_with(last) && rest.len() > last.len())
}

/// Checks that every block is closed and of a known kind. Some pages allow additional kinds.
pub fn check_kinds(page: &Page, more: &[&str]) -> Vec<Problem> {
    let mut problems = Vec::new();
    for block in page.blocks() {
        if !block.is_closed {
            problems.push(page.problem(block.line, "this block is not closed"));
        }
        let kind = block.kind.as_str();
        if !KINDS.contains(&kind) && !more.contains(&kind) {
            problems.push(page.problem(block.line, format!("a block of the unknown kind `{kind}`")));
        }
    }
    problems
}

/// Returns the page with every quoted error replaced by the current message, and reports the
/// outdated quotations.
pub fn with_errors_quoted(page: &Page) -> (Page, Report) {
    let mut report = Report::default();
    let blocks = page.blocks();
    let mut mended = page.text.clone();
    for (place, block) in blocks.iter().enumerate().rev().filter(|(_, block)| block.kind == "forms,error") {
        let said = message(&block.text);
        let Some(quoted) = blocks.get(place + 1).filter(|next| next.kind == "text") else {
            let message = "expected a `text` block with the message after this block";
            report.problems.push(page.problem(block.line, message));
            continue;
        };
        report.counted.errors += 1;
        if said.is_empty() {
            report.problems.push(page.problem(block.line, "this block gives no error"));
        } else if said != quoted.text {
            report.problems.push(page.problem(quoted.line, format!("the current message is\n{said}")));
            mended.replace_range(inside(page, quoted), &said);
        }
    }
    report.problems.reverse();
    (Page::new(&page.path, mended), report)
}

/// Returns the range of the text of a block, between its fences.
pub(crate) fn inside(page: &Page, block: &Block) -> std::ops::Range<usize> {
    let fenced = page.text[block.place.clone()].trim_end();
    let start = fenced.find('\n').map_or(fenced.len(), |end| end + 1);
    let end = fenced.rfind("```").unwrap_or(fenced.len()).max(start);
    block.place.start + start..block.place.start + end
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problems(text: &str) -> Vec<String> {
        let page = Page::new("page.md", text);
        let (_, quoted) = with_errors_quoted(&page);
        let found = [check_theories(&page).problems, check_kinds(&page, &[]), quoted.problems].concat();
        found.iter().map(ToString::to_string).collect()
    }

    /// Builds a page with these blocks (kind, text) after the chart P(x, y).
    fn with(blocks: &[(&str, &str)]) -> String {
        let fenced = |(kind, text): &(&str, &str)| format!("```{kind}\n{text}\n```\n\n");
        let blocks: String = blocks.iter().map(fenced).collect();
        format!("# Title\n\n```forms\nchart P(x, y);\n```\n\n{blocks}")
    }

    const EXERCISE: &str = "prove swapped: dy^dx == ___;";

    #[test]
    fn a_right_page_has_no_problems() {
        let exercise =
            with(&[("forms,exercise", EXERCISE), ("forms,answer", "prove swapped: dy^dx == -dx^dy;")]);
        assert_eq!(problems(&exercise), Vec::<String>::new());
        let counted = check_theories(&Page::new("page.md", exercise)).counted;
        assert_eq!((counted.statements, counted.exercises), (1, 1));
    }

    #[test]
    fn each_mistake_on_a_page_is_found_with_its_line() {
        let answer = "prove swapped: dy^dx == -dx^dy;";
        let cases: [(&[(&str, &str)], &str); 13] = [
            (&[("forms", "prove wrong: dx^dy == dy^dx;")], "page.md:8: error: `wrong` is false"),
            (&[("forms", "prove wrong: dx^dz == 0;")], "page.md:8: error: `dz` is not declared"),
            (&[("forms,alone", "prove wrong: dx == 0;")], "page.md:8: error: `dx` is not declared"),
            (&[("forms", "kernel k(a) = if a > 0 { 1 } else { 0 };")], "page.md:8: error: the branches"),
            (&[("forms,exercise", EXERCISE)], "page.md:7: an exercise without a `forms,answer`"),
            (&[("forms,answer", answer)], "page.md:7: an answer without an exercise"),
            (
                &[("forms,exercise", EXERCISE), ("forms,answer", "prove swapped: dy^dx == dx^dy;")],
                "`swapped` is false",
            ),
            (
                &[("forms,exercise", EXERCISE), ("forms,answer", "prove other: dy^dx == -dx^dy;")],
                "outside its holes",
            ),
            (&[("forms,exercise", answer), ("forms,answer", answer)], "an exercise without a hole"),
            (&[("forms,exercise", "// ___"), ("forms,answer", "// this")], "accepted with its hole"),
            (&[("forms,error", "chart Q(x);"), ("text", "error")], "gives no error"),
            (
                &[("forms,error", "chart Q(x)"), ("text", "error: no")],
                "page.md:11: the current message is\nerror: expected",
            ),
            (&[("form", "chart Q(x);")], "page.md:7: a block of the unknown kind `form`"),
        ];
        for (blocks, expected) in cases {
            let found = problems(&with(blocks));
            assert!(found.iter().any(|problem| problem.contains(expected)), "{expected}: {found:?}");
        }
    }

    #[test]
    fn an_answer_fills_every_hole() {
        assert!(fills("a ___ b ___;", "a 1 b c d;") && fills("___", "x"));
        for (exercise, answer) in
            [("a ___;", "a ;"), ("a ___ b ___;", "a 1 c 2;"), ("___ a", "1 b"), ("a", "b")]
        {
            assert!(!fills(exercise, answer), "{exercise} {answer}");
        }
    }

    #[test]
    fn quoted_errors_are_written_anew() {
        let page = Page::new("page.md", with(&[("forms,error", "chart Q(x)"), ("text", "old")]));
        let (mended, _) = with_errors_quoted(&page);
        let (again, report) = with_errors_quoted(&mended);
        assert_eq!((again, report.problems), (mended.clone(), vec![]));
        assert!(mended.text.contains("expected `;`") && !mended.text.contains("old"));
    }
}
