//! Compares every diagnostic of the macros, as shown by rustc, with the stored one, and checks that
//! valid sources compile without output.
//!
//! ```text
//! tests/ui/*.rs ──── rustc, with the library of these tests ─▶ diagnostics = tests/ui/*.stderr
//! tests/ui/pass/*.rs ─ rustc ─▶ program ─▶ success
//! ```
//! The library is the one that cargo has built for these tests, so that nothing is built twice.
//! With `FORMS_WRITE=1` the stored diagnostics are rewritten.

use rayon::prelude::*;
use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::time::SystemTime;

/// Program that uses the functions that each feature adds to a kernel, so that it compiles only
/// against the library of these tests.
const PROBE: &str = "forms::kernel! { double(x) = 2*x; }
    fn main() {
        double::batch_parallel(&[1.0], &mut [0.0]).expect(\"one length\");
        let _ = double::batch_rows;
    }";

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// Compiles a program against a library, with paths relative to the root of the package.
fn compile(source: &Path, library: &Path, kind: &str) -> Output {
    let name = source.file_stem().and_then(OsStr::to_str).expect("the name of a source").replace('-', "_");
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let dependencies = library.parent().expect("the library is in a folder");
    Command::new(rustc)
        .current_dir(root())
        .args([
            "--edition",
            "2024",
            "--crate-type",
            "bin",
            "--emit",
            kind,
            "--color",
            "never",
            "--diagnostic-width",
            "140",
        ])
        .args(["--crate-name", &name])
        .arg("-o")
        .arg(folder().join(format!("ui_{name}_{kind}")))
        .arg("-L")
        .arg(
            [OsStr::new("dependency="), dependencies.as_os_str()]
                .iter()
                .copied()
                .collect::<std::ffi::OsString>(),
        )
        .arg("--extern")
        .arg([OsStr::new("forms="), library.as_os_str()].iter().copied().collect::<std::ffi::OsString>())
        .arg(source)
        .output()
        .expect("rustc runs")
}

/// Finds the library with which these tests were built: the newest one in the folder of this
/// program that has every feature.
fn library() -> &'static Path {
    static LIBRARY: OnceLock<PathBuf> = OnceLock::new();
    LIBRARY.get_or_init(|| {
        let program = std::env::current_exe().expect("this program");
        let beside = program.parent().expect("this program is in a folder");
        let probe = folder().join("ui_probe.rs");
        std::fs::write(&probe, PROBE).expect("a file in the build's folder");
        let mut candidates: Vec<(SystemTime, PathBuf)> = std::fs::read_dir(beside)
            .expect("the folder of this program")
            .filter_map(|entry| entry.ok())
            .filter(|entry| is_library(&entry.file_name().to_string_lossy()))
            .filter_map(|entry| Some((entry.metadata().ok()?.modified().ok()?, entry.path())))
            .collect();
        candidates.sort();
        let mut refused = String::new();
        for (_, library) in candidates.into_iter().rev() {
            let output = compile(&probe, &library, "metadata");
            if output.status.success() {
                return library;
            }
            refused += &format!("{}\n{}", library.display(), String::from_utf8_lossy(&output.stderr));
        }
        panic!("no library `forms` of these tests is in {}\n{refused}", beside.display())
    })
}

fn is_library(file: &str) -> bool {
    file.starts_with("libforms-") && file.ends_with(".rlib")
}

/// Lists the sources of a folder, by paths relative to the root of the package.
fn sources(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).expect("the folder of the sources");
    let names = entries.map(|entry| entry.expect("an entry").file_name());
    let mut paths: Vec<PathBuf> = names.map(|name| Path::new(folder).join(name)).collect();
    paths.retain(|path| path.extension().is_some_and(|ending| ending == "rs"));
    paths.sort();
    assert!(!paths.is_empty(), "{folder} has no sources");
    paths
}

/// Returns the diagnostics of a source, without the summary lines of rustc.
fn diagnostics(source: &Path) -> Result<String, String> {
    let output = compile(source, library(), "metadata");
    if output.status.success() {
        return Err(format!("{} compiles", source.display()));
    }
    let text = String::from_utf8_lossy(&output.stderr);
    let is_kept = |part: &&str| {
        let first = part.trim_start();
        !first.is_empty()
            && !first.starts_with("error: aborting due to")
            && !first.starts_with("For more information")
    };
    let parts: Vec<&str> = text.split("\n\n").map(|part| part.trim_matches('\n')).filter(is_kept).collect();
    Ok(parts.join("\n\n") + "\n")
}

#[test]
fn mistakes_are_reported_on_the_users_own_text() {
    let differs = |source: &PathBuf| {
        let found = match diagnostics(source) {
            Ok(found) => found,
            Err(error) => return Some(error),
        };
        let kept = root().join(source).with_extension("stderr");
        if std::env::var_os("FORMS_WRITE").is_some() {
            std::fs::write(&kept, &found).expect("the folder of the sources");
        }
        let expected = std::fs::read_to_string(&kept).unwrap_or_default();
        let message = || format!("{}: expected\n{expected}and found\n{found}", source.display());
        (found != expected).then(message)
    };
    let differences: Vec<String> = sources("tests/ui").par_iter().filter_map(differs).collect();
    // FORMS_WRITE=1 cargo test --test ui
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}

#[test]
fn what_is_right_compiles_and_runs() {
    sources("tests/ui/pass").par_iter().for_each(|source| {
        let output = compile(source, library(), "link");
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success() && said.is_empty(), "{}: {said}", source.display());
        let name = source.file_stem().and_then(OsStr::to_str).expect("the name of a source");
        let run = Command::new(folder().join(format!("ui_{name}_link"))).output().expect("the program runs");
        assert!(run.status.success(), "{}: {}", source.display(), String::from_utf8_lossy(&run.stderr));
    });
}
