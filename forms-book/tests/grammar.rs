//! The editor grammar contains exactly the words of the language.

use forms_core::syntax::words::{ARRAY_FUNCTIONS, COMMON_FUNCTIONS, CONTEXTUAL, FUNCTIONS, INSIDE, ITEMS};
use serde_json::Value;

const GRAMMAR: &str = include_str!("../../editors/forms.tmLanguage.json");

/// Returns the words of `\b(one|two)\b`.
fn words<'a>(grammar: &'a Value, rule: &str) -> Vec<&'a str> {
    let pattern = grammar["repository"][rule]["match"].as_str().expect("a pattern");
    let list =
        pattern.strip_prefix("\\b(").and_then(|rest| rest.strip_suffix(")\\b")).expect("a list of words");
    list.split('|').collect()
}

#[test]
fn the_words_of_the_grammar_are_those_of_the_language() {
    let grammar: Value = serde_json::from_str(GRAMMAR).expect("JSON");
    let lists = [
        ("items", ITEMS),
        ("inside", INSIDE),
        ("contextual", CONTEXTUAL),
        ("functions", FUNCTIONS),
        ("array_functions", ARRAY_FUNCTIONS),
        ("common_functions", COMMON_FUNCTIONS),
    ];
    for (rule, known) in lists {
        assert_eq!(words(&grammar, rule), known, "{rule} of editors/forms.tmLanguage.json");
    }
}

#[test]
fn every_rule_is_used_and_every_rule_that_is_used_is_there() {
    let grammar: Value = serde_json::from_str(GRAMMAR).expect("JSON");
    let patterns = grammar["patterns"].as_array().expect("patterns");
    let mut used: Vec<&str> =
        patterns.iter().filter_map(|pattern| pattern["include"].as_str()?.strip_prefix('#')).collect();
    used.sort_unstable();
    let mut rules: Vec<&str> =
        grammar["repository"].as_object().expect("rules").keys().map(String::as_str).collect();
    rules.sort_unstable();
    assert_eq!(used, rules);
}
