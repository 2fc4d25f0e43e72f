//! Shared utilities of tests, benches and examples: random numbers, clocks, texts of scenes, pages
//! of measurements, detection of optional tools, and reports of checks that are skipped because a
//! tool is missing.
//!
//! ```text
//! test ─ is_installed(tool) ─┬─ yes ─▶ the check
//!                            └─ no ──▶ skipped(test, tool, why) ─▶ a line on standard error ─ .ci/run ─▶ the list at its end
//! ```
//! A test that skips a check passes, and the test runner prints nothing about a test that passes.
//! Therefore the line is written directly to standard error, which the runner does not capture.

pub mod alternation;
mod exact;
pub mod formula;
mod nvrtc;
pub mod page;
pub mod processor_clock;
mod random;
pub mod scene_text;
pub mod wall_clock;

pub use exact::exact;
pub use nvrtc::accepted_by_nvrtc;
pub use random::SplitMix;

use std::io::Write;
use std::path::Path;

/// Whether a program of this name is in one of the folders of `PATH`.
pub fn is_installed(program: &str) -> bool {
    let paths = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&paths).any(|folder| is_executable(&folder.join(program)))
}

#[cfg(unix)]
fn is_executable(file: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    file.metadata().is_ok_and(|metadata| metadata.is_file() && metadata.permissions().mode() & 0o111 != 0)
}

#[cfg(not(unix))]
fn is_executable(file: &Path) -> bool {
    file.is_file() || file.with_extension("exe").is_file()
}

/// Reports that a test skips a check because it needs a tool: `skipped: TEST: needs TOOL: WHY`.
pub fn skipped(test: &str, tool: &str, why: &str) {
    let line = line(test, tool, why);
    // If standard error is closed, the report is lost and the test still passes.
    let _ = std::io::stderr().lock().write_all(line.as_bytes());
}

fn line(test: &str, tool: &str, why: &str) -> String {
    let why = why.split_whitespace().collect::<Vec<_>>().join(" ");
    format!("skipped: {test}: needs {tool}: {why}\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_report_is_one_line() {
        assert_eq!(
            line("kernel::c", "clang", "it is not in\n  PATH"),
            "skipped: kernel::c: needs clang: it is not in PATH\n"
        );
    }

    #[test]
    fn programs_are_found_by_the_folders_of_path_and_nothing_else_is() {
        // Cargo starts the tests and puts the folder of the compiler into PATH.
        assert!(is_installed("cargo") || std::env::var_os("CARGO").is_none());
        assert!(!is_installed("a program that nobody has"));
        assert!(!is_executable(Path::new(env!("CARGO_MANIFEST_DIR"))), "a folder is no program");
    }
}
