//! The words of comments and pages: phrases that a reader has to read twice.
//!
//! A phrase is a smoke detector: a hit can be right, and a sentence without a hit can be bad.

use std::sync::LazyLock;

use fancy_regex::Regex;

/// Whether capitals matter to a phrase.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Case {
    Ignored,
    Kept,
}

/// Phrases to reword: free relative clauses, pronouns without a noun, calques.
#[rustfmt::skip]
const PHRASES: [(Case, &str); 34] = [
    (Case::Ignored, r"\b(of|than|by|for|with|from|to|in|on|and|as|is|are|at|beside|behind|after|before) what\b(?! (is|it|are) (this|that)\b)(?!\?)"),
    (Case::Kept, r"(^|[.:;] )What (?!is |are |does |do |if |happens|to )\w+[^?.]*\."),
    (Case::Kept, r"(^|[.:;] )(That|Those) of\b"),
    (Case::Kept, r"(^|[.] )Of (what|the|every|a|these|those|light|such)\b[^.]*\b(is|are|has|have)\b"),
    (Case::Ignored, r"\bso many\b"),
    (Case::Ignored, r"\bso much of\b"),
    (Case::Ignored, r"\blikewise\b"),
    (Case::Ignored, r"\bwhoever\b"),
    (Case::Ignored, r"\bwhat(ever)? (is|are) left of\b"),
    (Case::Ignored, r"\bbeside (it|them|the|that|this|other|each)\b"),
    (Case::Ignored, r"\btold apart\b|\btells? apart\b"),
    (Case::Ignored, r"\b(is|are) told\b"),
    (Case::Ignored, r"\bgo(es)? on\b"),
    (Case::Ignored, r"\bwithout end\b"),
    (Case::Ignored, r"\bread over\b"),
    (Case::Ignored, r"\bspeaks? of\b"),
    (Case::Ignored, r"\b(is|are) taken for\b"),
    (Case::Ignored, r"\bby itself\b"),
    (Case::Ignored, r"\bat most so\b"),
    (Case::Ignored, r"\bno (chance|use) \b"),
    (Case::Ignored, r"\bin the place of\b"),
    (Case::Ignored, r"\bas it takes\b"),
    (Case::Ignored, r"\b(stands?|standing) (behind|before|beside|between|in)\b"),
    (Case::Ignored, r"\bbehind (a|the) (statement|block|kernel|word|colon|density|value|degree|path|layer)\b"),
    (Case::Ignored, r"\b(an?|each) \w+ a (line|pixel|sample|band|share|machine|call|value|second)\b"),
    (Case::Ignored, r"\bcomes? (straight|of it|to the)\b"),
    (Case::Ignored, r"\bmay (err|be told)\b"),
    (Case::Ignored, r"\bthat is (there|off|on)\b"),
    (Case::Ignored, r"\bnothing (goes|hides|else is)\b"),
    (Case::Ignored, r"\bin so far\b"),
    (Case::Ignored, r"\bof (it|them|these|those) (that|which|is|are)\b"),
    (Case::Ignored, r"\bhow far beside\b"),
    (Case::Ignored, r"\ball that (is|are|it|they)\b"),
    (Case::Ignored, r"\bwhat (a|the|an|each|all|no|both|one|two|every|its|their|follows|stands|shines|comes|goes|hides|lies|arrives|reaches|remains|may|has|had|must|can|cannot|was|were|is) "),
];

static PATTERNS: LazyLock<Vec<Regex>> = LazyLock::new(|| {
    let pattern = |&(case, phrase): &(Case, &str)| match case {
        Case::Ignored => format!("(?i){phrase}"),
        Case::Kept => phrase.to_owned(),
    };
    PHRASES.iter().map(|phrase| Regex::new(&pattern(phrase)).expect("a phrase is a pattern")).collect()
});

/// Code, formulas and targets of links, whose words do not count.
static VERBATIM: LazyLock<Regex> =
    LazyLock::new(|| Regex::new(r"`[^`]*`|\$[^$]*\$|\[([^\]]*)\]\([^)]*\)").expect("a pattern"));

/// The ends of sentences and of cells of tables in a page.
static SENTENCE_ENDS: LazyLock<Regex> =
    LazyLock::new(|| Regex::new(r"(?<=[.:;])\s+(?=[A-Z*`|-])|\s\|\s").expect("a pattern"));

/// A comment or a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Passage {
    /// Line of a comment, from 1; of a sentence of a page 0.
    pub line: usize,
    /// The text without markers, code blocks and code.
    pub text: String,
}

/// Returns the phrase of a text that is to be reworded, if there is one.
pub fn flagged(text: &str) -> Option<String> {
    let hit = |pattern: &Regex| Some(pattern.find(text).ok()??.as_str().trim().to_owned());
    PATTERNS.iter().find_map(hit)
}

/// Returns the doc comments of a Rust source.
pub fn comments(source: &str) -> Vec<Passage> {
    let mut comments: Vec<(usize, Vec<&str>)> = Vec::new();
    let mut follows = false;
    for (at, line) in source.lines().enumerate() {
        let line = line.trim_start();
        let text = line.strip_prefix("///").or_else(|| line.strip_prefix("//!"));
        if let Some(text) = text {
            if !follows {
                comments.push((at + 1, Vec::new()));
            }
            comments.last_mut().expect("a comment has begun").1.push(text.strip_prefix(' ').unwrap_or(text));
        }
        follows = text.is_some();
    }
    comments.into_iter().map(|(line, lines)| Passage { line, text: prose(&lines) }).collect()
}

/// Returns the sentences of a Markdown page that have at least four words.
pub fn sentences(page: &str) -> Vec<Passage> {
    let text = prose(&page.lines().collect::<Vec<_>>());
    let sentences = SENTENCE_ENDS.split(&text).filter_map(Result::ok);
    sentences
        .filter(|sentence| sentence.split_whitespace().count() >= 4)
        .map(|sentence| Passage { line: 0, text: sentence.trim().to_owned() })
        .collect()
}

/// Joins lines without blocks of code, and without the code, formulas and targets of links in them.
fn prose(lines: &[&str]) -> String {
    let mut is_code = false;
    let mut text = Vec::new();
    for line in lines {
        if line.trim_start().starts_with("```") {
            is_code = !is_code;
        } else if !is_code {
            text.push(VERBATIM.replace_all(line, "$1").into_owned());
        }
    }
    text.join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn phrases_are_found_and_their_exceptions_are_not() {
        for (text, phrase) in [
            ("Returns so many samples.", Some("so many")),
            ("What is left of a path.", Some("What is")),
            ("The sum of what is known", Some("of what")),
            ("Those of a kernel.", Some("Those of")),
            ("a list of those of a kernel", None),
            ("Is this proof of what?", None),
            ("Returns the number of samples.", None),
        ] {
            assert_eq!(
                flagged(text).as_deref().map(|hit| hit
                    .split_whitespace()
                    .take(2)
                    .collect::<Vec<_>>()
                    .join(" ")),
                phrase.map(str::to_owned),
                "{text}"
            );
        }
    }

    #[test]
    fn a_comment_is_one_passage_without_its_code() {
        let source = "/// One `so many`.\n/// ```\n/// so many\n/// ```\n/// Two.\nfn f() {}\n    //! Three.";
        let found: Vec<_> =
            comments(source).into_iter().map(|comment| (comment.line, comment.text)).collect();
        assert_eq!(found, [(1, "One . Two.".to_owned()), (7, "Three.".to_owned())]);
    }

    #[test]
    fn a_page_is_its_sentences() {
        let page = "# Title\n\nThe first sentence has\nsix words. The second [has a link](x.md), too.\n```\nno code\n```\n";
        let found: Vec<_> = sentences(page).into_iter().map(|sentence| sentence.text).collect();
        assert_eq!(found, ["# Title  The first sentence has six words.", "The second has a link, too."]);
    }
}
