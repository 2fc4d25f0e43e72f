//! Kernels as source: omitted kernels, prefixes, and the library in every language.

use super::THEORY;
use super::process::{Folder, forms};
use std::path::PathBuf;
use std::process::Command;

#[test]
fn a_kernel_that_a_target_lacks_is_omitted_with_a_line_and_the_others_are_written() {
    let text = "kernel thick(x) = expint3(x) where x > 0; kernel thin(x) = x; kernel large(x) = x + 1e200;";
    let folder = Folder::with(&[("some.forms", text)]);
    let run = forms(&folder, &["emit", "some.forms", "--target", "wgsl"]);
    assert_eq!(run.status, 2);
    assert!(
        run.output.contains("fn thin(x: f32) -> f32 {") && !run.output.contains("thick"),
        "{}",
        run.output
    );
    let lines: Vec<&str> = run.errors.lines().collect();
    let expected = [
        "error: the kernel `thick` calls `expint3`, which the target `wgsl` does not have; the target `rust` has it \
         (in some.forms, omitted)",
        "error: the kernel `large` contains the number 10^200, which overflows or underflows in `f32`; the targets \
         `rust`, `c` and `cuda` hold it in the precision `f64` (in some.forms, omitted)",
    ];
    assert_eq!(lines, expected);
    let run = forms(&folder, &["emit", "some.forms", "--target", "rust"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
}

#[test]
fn a_prefix_begins_every_name_and_the_include_guard() {
    let folder = Folder::with(&[("good.forms", THEORY)]);
    let run = forms(&folder, &["emit", "good.forms", "--target", "c", "--prefix", "acme_"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    for part in ["#ifndef FORMS_ACME_GOOD_F64_H", "double acme_ratio(double a", "void acme_ratio_batch("] {
        assert!(run.output.contains(part), "{}", run.output);
    }
    for prefix in ["2", "a-b", "_a", "a b"] {
        let run = forms(&folder, &["emit", "good.forms", "--target", "c", "--prefix", prefix]);
        assert_eq!(run.status, 2, "{prefix}");
        assert!(
            run.errors.contains("expected letters, digits and underscores, a letter first"),
            "{}",
            run.errors
        );
    }
}

/// Writes the source of the library into a file, and returns the file.
fn library(folder: &Folder, file: &str, arguments: &[&str]) -> PathBuf {
    let run = forms(folder, &[&["emit", "-", "--target"], arguments].concat());
    assert!(!run.output.is_empty(), "{}", run.errors);
    folder.write(file, run.output.as_bytes());
    folder.path(file)
}

#[test]
fn the_library_compiles_in_cuda() {
    let folder = Folder::with(&[]);
    for precision in ["f64", "f32"] {
        let file = library(&folder, "library.cu", &["cuda", "--precision", precision]);
        forms_testing::accepted_by_nvrtc("program::emission::the_library_compiles_in_cuda", &file);
    }
}

#[test]
fn the_library_compiles_in_c_and_in_cpp() {
    let folder = Folder::with(&[]);
    for precision in ["f64", "f32"] {
        let file = library(&folder, "library.h", &["c", "--precision", precision]);
        for (compiler, language, standard) in [("gcc", "c", "-std=c99"), ("g++", "c++", "-std=c++17")] {
            let test = "program::emission::the_library_compiles_in_c_and_in_cpp";
            if !forms_testing::is_installed(compiler) {
                forms_testing::skipped(test, compiler, "it is not in PATH");
                continue;
            }
            let strict = ["-Wall", "-Wextra", "-Werror", "-pedantic", "-fsyntax-only", "-x", language];
            let run = Command::new(compiler).arg(standard).args(strict).arg(&file).output();
            let run = run.expect("the compiler runs");
            assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        }
    }
}

#[test]
fn the_library_is_valid_in_wgsl() {
    let folder = Folder::with(&[]);
    let file = library(&folder, "library.wgsl", &["wgsl"]);
    if !forms_testing::is_installed("naga") {
        forms_testing::skipped(
            "program::emission::the_library_is_valid_in_wgsl",
            "naga",
            "it is not in PATH",
        );
        return;
    }
    let run = Command::new("naga").arg(&file).output().expect("naga runs");
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
}
