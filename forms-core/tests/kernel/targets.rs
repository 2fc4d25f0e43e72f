//! Emitted text of kernels: it is stored in the folder `targets`, which `FORMS_WRITE=1` rewrites,
//! and what a target cannot express is an error. The values are compared by `conformance`.

use crate::emitted::kernels;
use crate::formula::Formulas;
use forms_core::emission::{
    EmitError, FileNames, KernelDocs, Precision, Source, Target, emit, emit_possible,
};
use forms_core::expression::{Expr, Operation};
use forms_core::kernel::{Instruction, Program};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Returns a kernel without documentation, promise and other forms.
pub(crate) fn undocumented(program: &Program) -> Source {
    Source {
        program: program.clone(),
        docs: KernelDocs::default(),
        within: None,
        approximated: None,
        target_forms: Vec::new(),
    }
}

pub(crate) fn sources(programs: &[Program]) -> Vec<Source> {
    let source = |program: &Program| Source {
        docs: KernelDocs { formula: program.name().to_string(), ..KernelDocs::default() },
        ..undocumented(program)
    };
    programs.iter().map(source).collect()
}

pub(crate) fn emitted(target: Target, precision: Precision) -> String {
    emit(&sources(&kernels()), target, precision).expect("every kernel can be said")
}

pub(crate) fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR"))
}

/// What a compiler of CUDA defines before a source, for C++ with one thread.
pub(crate) const CUDA_AS_CPP: &str = "\
#include <math.h>
#include <string.h>
#define __device__
#define __global__
struct dim3 { unsigned x, y, z; };
static dim3 gridDim = {1, 1, 1}, blockDim = {1, 1, 1}, blockIdx = {0, 0, 0}, threadIdx = {0, 0, 0};
static inline double __longlong_as_double(long long bits) {
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
static inline float __int_as_float(int bits) {
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}
";

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

/// Compilers of the headers: the strictest modes of both languages.
const STRICT: [(&str, &[&str]); 2] = [
    ("gcc", &["-x", "c", "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic"]),
    ("g++", &["-x", "c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-pedantic"]),
];

#[test]
fn headers_can_be_included_twice_and_together_in_c99_and_in_cpp17() {
    let header = |prefix: &str, precision| {
        let names = FileNames { prefix, file: "two.forms" };
        let emitted = emit_possible(&sources(&kernels()), Target::C, precision, names).expect("C has both");
        assert_eq!(emitted.omitted, []);
        let name = format!("header_{}.h", precision.name());
        std::fs::write(folder().join(&name), emitted.text).expect("a file in the build's folder");
        format!("#include \"{name}\"\n#include \"{name}\"\n")
    };
    let file = folder().join("headers.c");
    let includes = header("single_", Precision::F32) + &header("", Precision::F64);
    std::fs::write(&file, includes).expect("a file in the build's folder");
    for (compiler, arguments) in STRICT {
        let test = "kernel::targets::headers_can_be_included_twice_and_together_in_c99_and_in_cpp17";
        if compiles(compiler, test) {
            accepted(compiler, &[arguments, &["-fsyntax-only"]].concat(), &file, &[]);
        }
    }
}

/// Returns a program in C that compares the batch function of each kernel with its function, bit by
/// bit.
fn comparison(programs: &[Program]) -> String {
    let mut source = String::from("#include <string.h>\nint main(void) {\n    int wrong = 0;\n");
    for program in programs {
        let (name, outputs) = (program.name(), program.outputs().len());
        let columns = (0..program.arguments().len()).map(|place| format!("a[{place}]"));
        let results = (0..outputs).map(|place| format!("o[{place}]"));
        let batch: Vec<String> = columns.chain(results).chain(["37".to_owned()]).collect();
        let row: Vec<String> = (0..program.arguments().len()).map(|place| format!("a[{place}][i]")).collect();
        let call = match outputs {
            1 => format!("y[0] = {name}({})", row.join(", ")),
            _ => format!("{name}({}, y)", row.join(", ")),
        };
        source += &format!(
            "    {{\n        static double a[8][37], o[8][38];\n        \
             for (int i = 0; i < 37; i++) for (int j = 0; j < 8; j++) a[j][i] = 0.37 * i - j;\n        \
             {name}_batch({});\n        \
             for (int i = 0; i < 37; i++) {{\n            double y[8];\n            {call};\n            \
             for (int j = 0; j < {outputs}; j++) wrong += memcmp(&y[j], &o[j][i], sizeof y[j]) != 0;\n        \
             }}\n        \
             for (int j = 0; j < 8; j++) wrong += o[j][37] != 0;\n    }}\n",
            batch.join(", ")
        );
    }
    source + "    return wrong != 0;\n}\n"
}

#[test]
fn batch_functions_compute_their_kernels_at_every_row() {
    let test = "kernel::targets::batch_functions_compute_their_kernels_at_every_row";
    let programs = kernels();
    for (compiler, target, prelude) in [("gcc", Target::C, ""), ("g++", Target::Cuda, CUDA_AS_CPP)] {
        if !compiles(compiler, test) {
            continue;
        }
        let text = emit(&sources(&programs), target, Precision::F64).expect("every kernel can be said");
        let name = format!("batch_{}", target.name());
        let (file, program) = (folder().join(format!("{name}.c")), folder().join(&name));
        std::fs::write(&file, format!("{prelude}{text}{}", comparison(&programs))).expect("a file");
        let language = if target == Target::C { "c" } else { "c++" };
        accepted(compiler, &["-x", language, "-o", &program.to_string_lossy()], &file, &["-lm"]);
        let run = Command::new(&program).status().expect("the compiled program runs");
        assert!(run.success(), "{name}");
    }
}

#[test]
fn cuda_has_no_header_and_no_macro_of_one() {
    for precision in [Precision::F64, Precision::F32] {
        let text = emitted(Target::Cuda, precision);
        for word in ["#", "NAN", "INFINITY", "__host__", "static"] {
            assert!(!text.contains(word), "{word} in {text}");
        }
    }
}

#[test]
fn kernels_that_a_target_cannot_express_are_omitted_and_the_others_are_written() {
    let mut formulas = Formulas::over("x");
    let x = formulas.parse("x");
    let integral = formulas.pool.apply(Operation::Expint3, &[x]);
    let [optical, identity] =
        [("optical", integral), ("identity", x)].map(|(name, value)| formulas.named(name).program(&[value]));
    let of = |programs: &[Program], target: Target| {
        let names = FileNames { prefix: "beam_", file: "" };
        emit_possible(&sources(programs), target, target.usual_precision(), names).expect("the precision")
    };
    for target in [Target::C, Target::Wgsl, Target::Cuda] {
        let emitted = of(&[optical.clone(), identity.clone()], target);
        let function = EmitError::Function { kernel: "optical".into(), function: "expint3", target };
        assert_eq!(emitted.omitted, [function]);
        let text = emitted.text;
        assert!(text.contains("beam_identity(") && text.contains("beam_identity_batch("), "{text}");
        assert!(!text.contains("optical"), "{text}");
        assert_eq!(of(std::slice::from_ref(&optical), target).text, "");
    }
    assert!(of(&[optical, identity], Target::Rust).omitted.is_empty());
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
