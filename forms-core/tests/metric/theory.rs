//! Verdicts on single statements.

use forms_core::decide::{Verdict, decide};
use forms_core::resolve::resolve;
use forms_core::syntax::read;

/// Returns the verdict on `left == right` after a preamble.
pub(crate) fn verdict(preamble: &str, left: &str, right: &str) -> Verdict {
    let text = format!("{preamble} prove it: {left} == {right};");
    let (file, errors) = read(&text);
    assert_eq!(errors, [], "{text}");
    let (mut theory, errors) = resolve(&file);
    assert_eq!(errors, [], "{text}");
    let statement = theory.statements[0].clone();
    decide(&mut theory, &statement)
}

/// Asserts that a statement is proved.
pub(crate) fn assert_proved(preamble: &str, left: &str, right: &str) {
    let verdict = verdict(preamble, left, right);
    assert!(matches!(verdict, Verdict::Proved(_)), "{preamble}\n{left} == {right}\n{verdict:?}");
}

/// Whether a statement is refuted; it must not be proved where `never_proved` says so.
pub(crate) fn is_refuted(preamble: &str, left: &str, right: &str) -> bool {
    matches!(verdict(preamble, left, right), Verdict::Refuted(_))
}

/// Returns the messages of the errors of a text.
pub(crate) fn errors(text: &str) -> Vec<String> {
    let (file, errors) = read(text);
    let (_, found) = resolve(&file);
    errors.into_iter().chain(found).map(|error| error.message).collect()
}
