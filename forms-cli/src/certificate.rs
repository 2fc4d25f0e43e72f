//! Certificates on disk. They name each file by its path relative to the certificate's folder.

use crate::files::{reason, replace};
use forms::core::certificate::{HEADER, Uncovered, antiderivatives, entry, file_lines};
use forms::core::decide::Verdict;
use forms::core::syntax::Source;
use forms::core::theory::{Statement, Theory};
use forms_check::Outcome;
use std::io::Write;
use std::path::{Component, Path, PathBuf};

/// Certificate under construction.
pub(crate) struct Certificate {
    path: String,
    lines: String,
    /// Text of the file of the current entries.
    source: String,
    /// Antiderivatives of the integrals in this file.
    integrals: String,
}

impl Certificate {
    pub(crate) fn new(path: &str) -> Self {
        Certificate {
            path: path.to_string(),
            lines: HEADER.to_string(),
            source: String::new(),
            integrals: String::new(),
        }
    }

    /// Starts the entries of a file.
    pub(crate) fn begin(&mut self, source: &Source, theory: &mut Theory) {
        self.source.clone_from(&source.text);
        self.integrals = antiderivatives(theory);
        self.lines += &file_lines(&name_from(&self.path, &source.name), &source.text);
        self.lines += &self.integrals;
    }

    /// Adds the entry that proves a verdict. An entry that the checker does not accept is written
    /// as uncovered, with the checker's reason.
    pub(crate) fn add(&mut self, theory: &mut Theory, statement: &Statement, verdict: &Verdict) {
        let mut entry = entry(theory, statement, verdict);
        let alone = format!("{HEADER}{}{}{entry}", file_lines("itself", &self.source), self.integrals);
        let checked = forms_check::check(&alone, |_| Ok(self.source.clone()));
        let refused = match checked.map(|mut all| all.swap_remove(0).outcome) {
            Ok(Outcome::Rejected(why) | Outcome::NotCovered(why)) => Some(why),
            Ok(Outcome::Accepted) => None,
            Err(why) => Some(why),
        };
        if let (Some(why), Ok(_)) = (refused, &entry.lines) {
            entry.lines = Err(Uncovered::Refused(why));
        }
        self.lines += &entry.to_string();
    }

    /// Writes the certificate to its file.
    pub(crate) fn write(self) -> Result<(), String> {
        replace(Path::new(&self.path), |output| output.write_all(self.lines.as_bytes()))
            .map_err(|error| format!("cannot write {}: {}", self.path, reason(&error)))
    }
}

/// Returns the path of a file named by a certificate.
pub(crate) fn place_of(certificate: &str, name: &str) -> String {
    let folder = Path::new(certificate).parent().unwrap_or(Path::new(""));
    folder.join(name).to_string_lossy().into_owned()
}

/// Returns a file's path relative to the certificate's folder, or an unchanged or absolute path if
/// no relative path is known.
fn name_from(certificate: &str, file: &str) -> String {
    let absolute = |path: &Path| std::path::absolute(path).ok();
    let folder = absolute(Path::new(certificate)).and_then(|path| path.parent().map(Path::to_path_buf));
    let (Some(folder), Some(file_path)) = (folder, absolute(Path::new(file))) else {
        return file.to_string();
    };
    let (from, to): (Vec<Component>, Vec<Component>) =
        (folder.components().collect(), file_path.components().collect());
    if from.iter().chain(&to).any(|part| *part == Component::ParentDir) {
        return file_path.to_string_lossy().into_owned();
    }
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = from[shared..].iter().map(|_| Component::ParentDir);
    let relative: PathBuf = up.chain(to[shared..].iter().copied()).collect();
    relative.to_string_lossy().replace('\\', "/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_leads_from_the_certificate_to_the_file() {
        assert_eq!(name_from("out/a.certificate", "cases/b.forms"), "../cases/b.forms");
        assert_eq!(name_from("a.certificate", "cases/b.forms"), "cases/b.forms");
        assert_eq!(place_of("out/a.certificate", "../cases/b.forms"), "out/../cases/b.forms");
    }
}
