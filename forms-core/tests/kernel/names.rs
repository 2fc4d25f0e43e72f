//! Every name that the language accepts can name a kernel and an argument on every target. The
//! reserved words and standard names of all targets, names in generated code, and random names are
//! emitted together, and compilers check the result.

use crate::formula::Formulas;
use crate::targets::{CUDA_AS_CPP, accepted, compiles, folder, undocumented, validated};
use forms_core::emission::{Precision, Source, Target, emit};
use forms_core::expression::{Expr, Relation};
use forms_core::kernel::Program;
use forms_core::syntax::words::{Word, reserved};
use forms_testing::SplitMix;
use std::collections::BTreeSet;

/// Lists used by the emitter, and further names that it does not have.
const LISTS: [&str; 6] = [
    include_str!("../../src/emission/names/c.txt"),
    include_str!("../../src/emission/names/c_library.txt"),
    include_str!("../../src/emission/names/cuda.txt"),
    include_str!("../../src/emission/names/rust.txt"),
    include_str!("../../src/emission/names/wgsl.txt"),
    "as break const continue crate dyn else enum extern false for impl in loop match mod move mut ref return static struct trait \
     true type unsafe use while async await abstract become box do final gen macro override priv try typeof unsized virtual \
     yield union auto raw safe macro_rules self Self super _ __ ___ _x __x x_ x__ x__y _X _Bool _Complex __FILE__ __LINE__ \
     __cplusplus __linux__ __host__ __device__ __global__ __restrict__ __int128 forms_multiply_add forms_power forms_nan \
     forms_difference_of_products forms_ forms k_ k_forms_power k__x t t0 t1 t2 tt0 x0 x1 k0 k1 s value values result inside \
     from to outputs outputs_ Formula T MATH PI E I J NaN nan inf Inf INFINITY f f32 f64 f128 i32 u8 usize str String Vec Box \
     Option Some None Ok Err Result std core alloc forms_math math main Main printf isnan fmaf fma double float int half \
     float4 threadIdx NULL M_PI M_PI_2 M_SQRT2 fn_ let_ type_ printf_ double_ Some_ self_ match_ r r_match raw_match",
];

/// Returns every name once, in random order.
fn names() -> Vec<String> {
    let lines = LISTS.iter().flat_map(|list| list.lines()).filter(|line| !line.starts_with('#'));
    let mut names: BTreeSet<String> = lines.flat_map(str::split_whitespace).map(str::to_string).collect();
    let mut random = SplitMix(1);
    let known: Vec<String> = names.iter().cloned().collect();
    for _ in 0..500 {
        let mut name = known[random.below(known.len())].clone();
        match random.below(4) {
            0 => name.push('_'),
            1 => name.insert(0, '_'),
            2 => name = name.to_uppercase(),
            _ => name.push((b'0' + random.below(10) as u8) as char),
        }
        names.insert(name);
    }
    let is_free = |name: &String| matches!(reserved(name), None | Some(Word::Rust));
    let mut names: Vec<String> = names.into_iter().filter(is_free).collect();
    for place in (1..names.len()).rev() {
        names.swap(place, random.below(place + 1));
    }
    names
}

/// Returns kernels with these names, which are also the names of their arguments: functions,
/// powers, branches, domains, one result or several.
fn programs(names: &[String]) -> Vec<Program> {
    let at = |place: usize| names[place % names.len()].as_str();
    let program = |place: usize| {
        let mut formulas =
            Formulas::over(&[at(place), at(place + 1), at(place + 2), at(place + 3)].join(" "));
        for (number, part) in ["q0", "q1", "q2"].into_iter().enumerate() {
            let symbol = formulas.arguments[number];
            let value = formulas.pool.symbol(symbol);
            formulas.name(part, value);
        }
        let mut parse = |text: &str| formulas.parse(text);
        let first = parse("if q0 < q1 { sin(q0)*q2 + q1 } else { exp(q1)*cos(q2) + q0**(1/3) }");
        let second = parse("q0*q1 - q2*(q1 + 3) + sqrt(q1)/(q0 + atan2(q1, q2)**2)");
        let (zero, q1): (Expr, Expr) = (parse("0"), parse("q1"));
        let outputs = if place.is_multiple_of(3) { vec![first, second] } else { vec![first] };
        let domain = if place.is_multiple_of(2) { vec![(q1, Relation::Greater, zero)] } else { Vec::new() };
        let written = formulas.named(at(place)).program_where(&outputs, &domain);
        if place.is_multiple_of(5) { written.optimise().compensate() } else { written.optimise() }
    };
    (0..names.len()).map(program).collect()
}

fn source(programs: &[Program], target: Target, precision: Precision) -> String {
    let sources: Vec<Source> = programs.iter().map(undocumented).collect();
    emit(&sources, target, precision).expect("every kernel can be said")
}

/// Returns a part of the names, so that each compilation is short; all of them with `FORMS_FUZZ`.
fn some_names(divisor: usize) -> Vec<String> {
    let names = names();
    assert!(names.len() > 3_000, "{} names", names.len());
    let is_long = std::env::var_os("FORMS_FUZZ").is_some();
    // likely names of quantities, and names that have caused errors before, are always included
    let fixed = LISTS[0].lines().chain(LISTS[2].lines()).chain(LISTS[3].lines()).chain(LISTS[5].lines());
    let fixed: BTreeSet<&str> = fixed.flat_map(str::split_whitespace).collect();
    let kept =
        |(place, name): &(usize, &String)| is_long || place % divisor == 0 || fixed.contains(name.as_str());
    names.iter().enumerate().filter(kept).map(|(_, name)| name.clone()).collect()
}

#[test]
fn every_name_compiles_in_c() {
    if !compiles("gcc", "kernel::names::every_name_compiles_in_c") {
        return;
    }
    let programs = programs(&some_names(3));
    for precision in [Precision::F64, Precision::F32] {
        let file = folder().join(format!("names_{}.c", precision.name()));
        std::fs::write(&file, source(&programs, Target::C, precision)).expect("a file in the build's folder");
        accepted("gcc", &["-std=c11", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"], &file, &[]);
        accepted("gcc", &["-std=gnu17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"], &file, &[]);
    }
}

#[test]
fn every_name_compiles_in_cuda_as_cpp() {
    if !compiles("g++", "kernel::names::every_name_compiles_in_cuda_as_cpp") {
        return;
    }
    let programs = programs(&some_names(6));
    let text = source(&programs, Target::Cuda, Precision::F64);
    let file = folder().join("names.cu");
    let types = "struct float4 { float x, y, z, w; };\nstruct half { unsigned short bits; };\n";
    let text = format!("#include <cstdio>\n{CUDA_AS_CPP}{types}{text}");
    std::fs::write(&file, text).expect("a file in the build's folder");
    accepted("g++", &["-x", "c++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-fsyntax-only"], &file, &[]);
}

#[test]
fn every_name_of_cuda_compiles_in_cuda() {
    let file = folder().join("names_nvrtc.cu");
    let names: Vec<String> = LISTS[2]
        .lines()
        .filter(|line| !line.starts_with('#'))
        .flat_map(str::split_whitespace)
        .filter(|name| matches!(reserved(name), None | Some(Word::Rust)))
        .map(str::to_string)
        .collect();
    let text = source(&programs(&names), Target::Cuda, Precision::F64);
    std::fs::write(&file, text).expect("a file in the build's folder");
    forms_testing::accepted_by_nvrtc("kernel::names::every_name_of_cuda_compiles_in_cuda", &file);
}

#[test]
fn every_name_is_valid_in_wgsl() {
    for part in programs(&some_names(3)).chunks(400) {
        validated(&source(part, Target::Wgsl, Precision::F32));
    }
}

#[test]
fn every_name_compiles_in_rust() {
    let programs = programs(&some_names(6));
    let text = source(&programs, Target::Rust, Precision::F64);
    let file = folder().join("names.rs");
    std::fs::write(&file, text).expect("a file in the build's folder");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
    let metadata = folder().join("names.rmeta").to_string_lossy().into_owned();
    let strict = ["--edition", "2024", "--crate-type", "lib", "-D", "warnings", "--emit", "metadata", "-o"];
    accepted(&rustc, &[&strict[..], &[&metadata]].concat(), &file, &[]);
}

#[test]
fn what_is_renamed_is_said_and_the_rest_keeps_its_name() {
    let names = ["printf", "forms_multiply_add", "length", "radius"].map(str::to_string);
    let programs = programs(&names);
    let text = source(&programs[..1], Target::C, Precision::F64);
    let said = "// `printf` is renamed to `printf_`, `forms_multiply_add` is renamed to `k_forms_multiply_add`, \
                because the names are reserved in C.";
    assert!(text.contains(said), "{text}");
    assert!(text.contains("double radius"), "{text}");
}
