//! Certificates written by the prover.

use forms_check::{Checked, Outcome, check};
use forms_core::certificate::{HEADER, antiderivatives, entry, file_lines};
use forms_core::check::read_theory;
use forms_core::decide::decide;

/// Returns the certificate of a text.
pub(crate) fn certificate(source: &str) -> String {
    let (mut theory, errors) = read_theory(source);
    assert!(errors.is_empty(), "{errors:?}");
    let mut lines = HEADER.to_string() + &file_lines("it.forms", source);
    lines += &antiderivatives(&mut theory);
    for statement in theory.statements.clone() {
        let verdict = decide(&mut theory, &statement);
        lines += &entry(&mut theory, &statement, &verdict).to_string();
    }
    lines
}

/// Checks a certificate of a text.
pub(crate) fn checked(certificate: &str, source: &str) -> Result<Vec<Checked>, String> {
    check(certificate, |_| Ok(source.to_string()))
}

/// Whether all entries of a certificate are accepted.
pub(crate) fn is_accepted(certificate: &str, source: &str) -> bool {
    checked(certificate, source).is_ok_and(|all| all.iter().all(|one| one.outcome == Outcome::Accepted))
}

/// Reads a case file of the repository.
pub(crate) fn case_file(name: &str) -> String {
    let path = format!("{}/../tests/cases/{name}.forms", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}
