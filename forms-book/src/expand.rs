//! Expands a page for its readers: formulas become MathML, and blocks are followed by their
//! verdicts.
//!
//! ```text
//! Markdown ─┬─ $…$, $$…$$ ─▶ <math> ────────────────────┐
//!           ├─ forms ─▶ block, <details> below it ──────┼─▶ Markdown
//!           └─ links ─▶ targets in the rendered book ───┘
//! ```

use crate::check::Problem;
use crate::mathml::{display, inline};
use crate::page::{Page, targets_in_html};
use crate::theory::common_text;
use crate::verdicts::Shown;
use forms_core::syntax::Source;
use pulldown_cmark::{Event, LinkType, Tag, TagEnd};
use std::ops::Range;

/// Resolves a link or picture of the page to its target, or to `None` if it has no target.
pub(crate) type Targets<'a> = &'a (dyn Fn(&str) -> Option<String> + Sync);

/// Returns the page with formulas as MathML, verdicts below its blocks, and links to the given
/// targets.
pub(crate) fn expanded(page: &Page, targets: Targets<'_>) -> Result<String, Vec<Problem>> {
    let (mut edits, mut problems) = (Vec::new(), Vec::new());
    let mut is_code = false;
    for (event, place) in page.events() {
        match &event {
            Event::Start(Tag::CodeBlock(_)) => is_code = true,
            Event::End(TagEnd::CodeBlock) => is_code = false,
            Event::Text(text) if !is_code && text.contains('$') => {
                problems.push(page.problem(
                    page.line(place.start),
                    "`$` without a formula: unbalanced brackets, or a space after the opening or \
                    before the closing `$`",
                ));
            }
            _ => {}
        }
        match formula(page, &event, place.clone()) {
            Ok(edit) => edits.extend(edit),
            Err(problem) => problems.push(problem),
        }
        edits.extend(link(page, &event, place, targets));
    }
    let (below, found) = verdicts(page);
    edits.extend(below);
    problems.extend(found);
    if !problems.is_empty() {
        problems.sort();
        problems.dedup();
        return Err(problems);
    }
    edits.sort_by_key(|(place, _)| (place.start, place.end));
    let mut text = page.text.clone();
    for (place, replacement) in edits.into_iter().rev() {
        text.replace_range(place, &replacement);
    }
    Ok(text)
}

type Edit = (Range<usize>, String);

/// Converts a formula to MathML.
fn formula(page: &Page, event: &Event<'_>, place: Range<usize>) -> Result<Option<Edit>, Problem> {
    let mathml = match event {
        Event::InlineMath(latex) => inline(latex).map(|mathml| kept(&mathml)),
        Event::DisplayMath(latex) => {
            display(latex).map(|mathml| format!("<span class=\"formula\">{}</span>", kept(&mathml)))
        }
        _ => return Ok(None),
    };
    let unreadable =
        |error| page.problem(page.line(place.start), format!("this formula cannot be read: {error}"));
    mathml.map(|mathml| Some((place.clone(), mathml))).map_err(unreadable)
}

/// Replaces the target of a link or picture. A link without a target is replaced by its text.
fn link(page: &Page, event: &Event<'_>, place: Range<usize>, targets: Targets<'_>) -> Vec<Edit> {
    if let Event::Html(_) | Event::InlineHtml(_) = event {
        let found = targets_in_html(&page.text[place.clone()]).into_iter();
        let found = found.map(|at| place.start + at.start..place.start + at.end);
        return found.filter_map(|at| Some((at.clone(), targets(&page.text[at])?))).collect();
    }
    let Event::Start(
        Tag::Link { link_type: LinkType::Inline, dest_url: target, .. } | Tag::Image { dest_url: target, .. },
    ) = event
    else {
        return vec![];
    };
    let Some(end_of_text) = page.text[place.clone()].rfind(&format!("]({target}")) else { return vec![] };
    let end_of_text = place.start + end_of_text;
    match targets(target) {
        Some(new) => vec![(end_of_text + 2..end_of_text + 2 + target.len(), new)],
        None => vec![(place.start..place.start + 1, String::new()), (end_of_text..place.end, String::new())],
    }
}

/// Escapes MathML for Markdown: no character has a meaning in Markdown, and the result is a single
/// line.
fn kept(mathml: &str) -> String {
    let mut kept = String::with_capacity(mathml.len());
    let mut is_tag = false;
    for character in mathml.chars() {
        match character {
            '<' => is_tag = true,
            '>' => is_tag = false,
            _ => {}
        }
        match character {
            '\n' | '\r' => kept.push(' '),
            '*' | '_' | '[' | ']' | '`' | '|' | '$' | '\\' | '~' | '!' if !is_tag => {
                kept.push_str(&format!("&#{};", u32::from(character)));
            }
            other => kept.push(other),
        }
    }
    kept
}

/// Generates the HTML below each block that states or declares something.
fn verdicts(page: &Page) -> (Vec<Edit>, Vec<Problem>) {
    let blocks = page.blocks();
    let (mut edits, mut problems) = (Vec::new(), Vec::new());
    let text = common_text(&blocks);
    let common = Shown::new(Source::new(&page.path, text.as_str()));
    let mut start = 0;
    for block in &blocks {
        let below = match block.kind.as_str() {
            "forms" => {
                let part = start..start + block.text.len();
                start = part.end;
                common.as_ref().map(|theory| theory.below(part))
            }
            "forms,alone" => Shown::new(Source::new(&page.path, block.text.as_str()))
                .map(|theory| theory.below(0..usize::MAX)),
            "forms,answer" => Shown::new(Source::new(&page.path, format!("{text}{}", block.text)))
                .map(|theory| theory.below(text.len()..usize::MAX)),
            _ => None,
        };
        match below {
            Some(Ok(html)) if !html.is_empty() => {
                let end = block.place.start + page.text[block.place.clone()].trim_end().len();
                edits.push((end..end, format!("\n\n<div class=\"below\">\n{html}</div>\n")));
            }
            Some(Err(message)) => problems.push(page.problem(block.line, message)),
            _ => {}
        }
    }
    (edits, problems)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(text: &str) -> Result<String, Vec<Problem>> {
        let targets = |target: &str| (!target.starts_with("..")).then(|| target.replace(".md", ".html"));
        expanded(&Page::new("page.md", text), &targets)
    }

    #[test]
    fn formulas_become_mathml_in_which_no_character_means_anything_to_markdown() {
        let text = of("| a | b |\n|---|---|\n| $\\lvert x_1 * y \\rvert$ | `$x$` |\n\n$$\nx^2\n$$\n")
            .expect("a page");
        assert!(!text.contains("$$") && text.contains("`$x$`"), "{text}");
        assert!(
            text.contains("<math") && text.contains("<span class=\"formula\"><math display=\"block\""),
            "{text}"
        );
        let row = text.lines().nth(2).expect("a row");
        assert_eq!(row.matches('|').count(), 3, "{row}");
        assert!(!row.contains('*') && !row.contains('\\'), "{row}");
    }

    #[test]
    fn a_formula_that_cannot_be_read_is_told_with_its_line() {
        for (formula, message) in
            [("$\\nosuch$", "cannot be read"), ("$\\frac{1$", "`$` without"), ("$$x^$$", "cannot")]
        {
            let problems = of(&format!("# Title\n\ntext {formula} text\n")).expect_err("a problem");
            assert_eq!((problems.len(), problems[0].line), (1, 3), "{formula}");
            assert!(problems[0].message.contains(message), "{}", problems[0]);
        }
    }

    #[test]
    fn each_statement_has_its_verdict_and_its_steps_below_its_block() {
        let text =
            of("```forms\nchart P(x, y);\nform w = x*dy;\nprove area: d(w) == dx^dy;\n```\n\nText.\n\n\
                       ```forms\nrefute flat: d(w) == 0;\n```\n")
            .expect("a page");
        let (first, second) = text.split_once("Text.").expect("both blocks");
        assert!(
            first.contains("<code>area</code> proved") && first.contains("in mathematical notation"),
            "{first}"
        );
        assert!(second.contains("<code>flat</code> refuted") && !second.contains("area"), "{second}");
        assert!(first.contains("<ol class=\"steps\">") && !first.contains("<details open"), "{first}");
        let below = &first[first.find("<div class=\"below\">").expect("details")..];
        assert!(!below.trim_end().contains("\n\n"), "an empty line ends the HTML: {below}");
    }

    #[test]
    fn links_lead_to_their_targets_and_those_without_become_text() {
        let text = of("[one](a.md#x) [two $x$](../b.md) ![three](c.svg)\n").expect("a page");
        assert!(
            text.starts_with("[one](a.html#x) two <math") && text.ends_with("![three](c.svg)\n"),
            "{text}"
        );
    }
}
