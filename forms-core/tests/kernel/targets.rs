//! Emitted text of kernels: it is stored in the folder `targets`, which `FORMS_WRITE=1` rewrites,
//! and what a target cannot express is an error. The values are compared by `conformance`.

use crate::emitted::kernels;
use crate::formula::Formulas;
use forms_core::emission::{EmitError, KernelDocs, Precision, Source, Target, emit};
use forms_core::expression::{Expr, Operation};
use forms_core::kernel::{Instruction, Program};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use std::path::{Path, PathBuf};
use std::process::Command;

pub(crate) fn sources(programs: &[Program]) -> Vec<Source> {
    let source = |program: &Program| Source {
        program: program.clone(),
        docs: KernelDocs { formula: program.name().to_string(), ..KernelDocs::default() },
        within: None,
    };
    programs.iter().map(source).collect()
}

pub(crate) fn emitted(target: Target, precision: Precision) -> String {
    emit(&sources(&kernels()), target, precision).expect("every kernel can be said")
}

pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// Whether a compiler can compile a minimal source; if not, the test is reported as skipped. A
/// linker can have the name of a compiler but no assembler or headers.
pub(crate) fn compiles(compiler: &str, test: &str) -> bool {
    if !forms_testing::is_installed(compiler) {
        forms_testing::skipped(test, compiler, "it is not in PATH");
        return false;
    }
    let (file, program) =
        (folder().join(format!("least_{compiler}.c")), folder().join(format!("least_{compiler}")));
    let source = "#include <math.h>\n#include <stdio.h>\nint main(void) { return 0; }\n";
    std::fs::write(&file, source).expect("a file in the build's folder");
    match Command::new(compiler).arg("-o").arg(program).arg(file).arg("-lm").output() {
        Ok(output) if output.status.success() => true,
        Ok(output) => {
            forms_testing::skipped(test, compiler, &String::from_utf8_lossy(&output.stderr));
            false
        }
        Err(error) => {
            forms_testing::skipped(test, compiler, &error.to_string());
            false
        }
    }
}

/// Runs a tool on a file, and panics if the tool reports failure.
#[track_caller]
pub(crate) fn accepted(tool: &str, arguments: &[&str], file: &Path, libraries: &[&str]) {
    let output =
        Command::new(tool).args(arguments).arg(file).args(libraries).output().expect("the tool runs");
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert!(
        output.status.success(),
        "{tool}: {complaints}\n{}",
        std::fs::read_to_string(file).unwrap_or_default().lines().take(400).collect::<Vec<_>>().join("\n")
    );
}

/// Compares a text with the stored file.
#[track_caller]
fn is_kept(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/kernel/targets").join(name);
    if std::env::var_os("FORMS_WRITE").is_some() {
        std::fs::write(&path, text).expect("the folder of the tests");
    }
    let kept = std::fs::read_to_string(&path).unwrap_or_default();
    assert_eq!(kept, text, "{name}: FORMS_WRITE=1 cargo test -p forms-core --test kernel targets");
}

/// Stored files: each target in its usual precision, and in another one if it has one.
const KEPT: [(&str, Target, Precision); 6] = [
    ("kernels.c", Target::C, Precision::F64),
    ("kernels_f32.c", Target::C, Precision::F32),
    ("kernels.cu", Target::Cuda, Precision::F64),
    ("kernels_f32.cu", Target::Cuda, Precision::F32),
    ("kernels.wgsl", Target::Wgsl, Precision::F32),
    ("kernels_f32.rs", Target::Rust, Precision::F32),
];

#[test]
fn what_is_emitted_is_kept() {
    for (name, target, precision) in KEPT {
        let text = emitted(target, precision);
        // the included arithmetic is tested elsewhere
        let own = text.split("\n#[allow(dead_code, unused_imports").next().unwrap_or_default();
        is_kept(name, own);
    }
}

pub(crate) fn has_functions(program: &Program) -> bool {
    let is_function = |i: &Instruction| {
        use Instruction::{Call, DifferenceOfProducts, Power, SumOfProducts};
        matches!(i, Call(..) | Power(..) | DifferenceOfProducts(_) | SumOfProducts(_))
    };
    program.instructions().iter().any(is_function)
}

/// Validates a text in WGSL.
#[track_caller]
pub(crate) fn validated(text: &str) {
    let module =
        naga::front::wgsl::parse_str(text).unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
    if let Err(error) = validator.validate(&module) {
        panic!("{}", error.emit_to_string(text));
    }
}

#[test]
fn rust_in_f32_and_in_double_double_compiles_as_it_stands() {
    for precision in [Precision::F32, Precision::DoubleDouble] {
        let text = emitted(Target::Rust, precision);
        let file = folder().join(format!("emitted_{}.rs", precision.name()));
        std::fs::write(&file, text).expect("a file in the build's folder");
        let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
        let metadata = folder().join(format!("emitted_{}.rmeta", precision.name()));
        let metadata = metadata.to_string_lossy();
        let strict = [
            "--edition",
            "2024",
            "--crate-type",
            "lib",
            "-D",
            "warnings",
            "--emit",
            "metadata",
            "-o",
            &metadata,
        ];
        accepted(&rustc, &strict, &file, &[]);
    }
}

#[test]
fn what_a_target_cannot_say_is_an_error_that_names_it() {
    let mut formulas = Formulas::over("x");
    let x = formulas.parse("x");
    let integral = formulas.pool.apply(Operation::Expint3, &[x]);
    let [huge, double]: [Expr; 2] =
        ["x*1000000000000000000000000000000000000000000", "2*x"].map(|text| formulas.parse(text));
    let single = |program: Program| sources(&[program]);
    let special = single(formulas.named("optical").program(&[integral]));
    for target in [Target::C, Target::Wgsl, Target::Cuda] {
        let error = emit(&special, target, target.usual_precision()).expect_err("no such function");
        let text = format!(
            "the kernel `optical` calls `expint3`, which the target `{}` does not have",
            target.name()
        );
        assert_eq!(error.to_string(), text);
    }
    assert!(emit(&special, Target::Rust, Precision::F64).is_ok());
    let huge = single(formulas.named("huge").program(&[huge]));
    assert!(matches!(emit(&huge, Target::C, Precision::F32), Err(EmitError::Number { .. })));
    assert!(emit(&huge, Target::C, Precision::F64).is_ok());
    let double = single(formulas.named("double").program(&[double]));
    let source = emit(&double, Target::C, Precision::F64).expect("it has another name");
    assert!(
        source.contains("// `double` is renamed to `double_`, because the name is reserved in C."),
        "{source}"
    );
    assert!(source.contains("double double_(double x) {"), "{source}");
    assert_eq!(
        emit(&double, Target::Wgsl, Precision::F64),
        Err(EmitError::Precision(Target::Wgsl, Precision::F64))
    );
}

#[test]
fn arguments_get_names_that_the_target_does_not_have() {
    let mut formulas = Formulas::over("double double_ fn");
    let sum = formulas.parse("double + 2*double_ + fn");
    let source = sources(&[formulas.named("sum").program(&[sum])]);
    let c = emit(&source, Target::C, Precision::F64).expect("C");
    assert!(c.contains("double sum(double double__, double double_, double fn) {"), "{c}");
    let wgsl = emit(&source, Target::Wgsl, Precision::F32).expect("WGSL");
    assert!(wgsl.contains("fn sum(double: f32, double_: f32, fn_: f32) -> f32 {"), "{wgsl}");
}
