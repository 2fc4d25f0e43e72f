//! Verdicts on statements after a preamble.

use forms_core::decide::{Verdict, decide};
use forms_core::resolve::resolve;
use forms_core::syntax::read;

/// Returns the verdicts on the statements of a table, in order.
pub(crate) fn verdicts(preamble: &str, statements: &[&str]) -> Vec<Verdict> {
    let mut text = preamble.to_string();
    for (number, statement) in statements.iter().enumerate() {
        text.push_str(&format!("prove statement_{number}: {statement};\n"));
    }
    let (file, errors) = read(&text);
    assert_eq!(errors, [], "{text}");
    let (mut theory, errors) = resolve(&file);
    assert_eq!(errors, [], "{text}");
    theory.statements.clone().iter().map(|statement| decide(&mut theory, statement)).collect()
}

/// Asserts the verdict of every statement of a table.
pub(crate) fn assert_verdicts(preamble: &str, expected: &str, statements: &[&str]) {
    let found = verdicts(preamble, statements).into_iter().zip(statements);
    let wrong: Vec<String> = found
        .filter(|(verdict, _)| verdict.name() != expected)
        .map(|(verdict, written)| format!("{written}\n    {verdict:?}"))
        .collect();
    assert!(wrong.is_empty(), "not {expected}:\n{}", wrong.join("\n"));
}
