//! The crate without the standard library.
//!
//! ```text
//! program.rs ─ a crate of its own ─┬─ feature `libm` ─▶ it links and runs
//!                                  ├─ feature `std` ──▶ an error: a panic handler is defined twice
//!                                  └─ neither ────────▶ the error that names both features
//! ```
//! The program defines the panic handler and the allocator, of which a program has only one: it would
//! not compile if any crate that it contains used the standard library.

// The program starts and takes its memory from the C library.
#![cfg(target_os = "linux")]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PROGRAM: &str = include_str!("program.rs");

/// Writes the package of the program into a folder of this name, and returns the folder. Its
/// dependencies are those of the workspace, so that no network is needed.
fn package(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let math = Path::new(env!("CARGO_MANIFEST_DIR"));
    let manifest = format!(
        r#"
[package]
name = "program"
version = "0.0.0"
edition = "2024"

[workspace]

[features]
std = ["forms-math/std"]
libm = ["forms-math/libm"]

[dependencies]
forms-math = {{ path = {math:?}, default-features = false }}

[profile.dev]
panic = "abort"
opt-level = 1
debug = false
"#
    );
    fs::create_dir_all(folder.join("src")).expect("the folder for temporary files is writable");
    fs::write(folder.join("Cargo.toml"), manifest).expect("the folder is writable");
    fs::write(folder.join("src/main.rs"), PROGRAM).expect("the folder is writable");
    fs::copy(math.join("../Cargo.lock"), folder.join("Cargo.lock")).expect("the workspace has a lock file");
    folder
}

/// Runs cargo in the folder of a package.
fn cargo(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO"));
    command
        .current_dir(folder)
        .arg("--offline")
        .args(arguments)
        .env("CARGO_TARGET_DIR", folder.join("target"));
    command.output().expect("cargo runs")
}

fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

#[test]
fn a_program_without_the_standard_library_computes_kernels() {
    let folder = package("no_std_libm");
    let built = cargo(&folder, &["build", "--features", "libm"]);
    assert!(built.status.success(), "{}", errors(&built));
    let run = Command::new(folder.join("target/debug/program")).status().expect("the program runs");
    assert_eq!(run.code(), Some(0), "the exit code is the number of the first check that fails");
}

#[test]
fn the_program_does_not_compile_with_the_standard_library() {
    let checked = cargo(&package("no_std_std"), &["check", "--features", "std"]);
    assert!(errors(&checked).contains("duplicate lang item `panic_impl`"), "{}", errors(&checked));
}

#[test]
fn without_a_library_of_functions_the_error_names_the_features() {
    let checked = cargo(&package("no_std_neither"), &["check"]);
    let errors = errors(&checked);
    assert!(errors.contains("enable its feature `std` (the default), or its feature `libm`"), "{errors}");
}
