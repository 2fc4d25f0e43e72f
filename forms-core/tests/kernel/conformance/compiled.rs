//! Emitted text, compiled with a `main` that prints every kernel at its rows as bits.

use super::table::Entry;
use super::truth::Format;
use crate::targets::{CUDA_AS_CPP, accepted, folder, sources};
use forms_core::emission::{KernelDocs, Precision, Target, emit, emit_formula, emit_rust};
use std::fmt::Write as _;
use std::process::Command;

/// Values of one back end: for each entry, its rows one after the other, each with its outputs.
pub(crate) type Values = Vec<Vec<f64>>;

/// Returns the rows of an entry as the items of an array.
fn items(entry: &Entry, number: impl Fn(f64) -> String) -> String {
    entry.rows.iter().flatten().map(|&x| number(x)).collect::<Vec<_>>().join(", ")
}

/// Returns the numbers that a program printed, distributed to the entries.
fn distributed(printed: &str, entries: &[&Entry]) -> Values {
    let mut numbers = printed.lines().map(|line| f64::from_bits(line.parse().expect("bits")));
    let of_entry = |entry: &&Entry| {
        let count = entry.rows.len() * entry.program.outputs().len();
        let values: Vec<f64> = numbers.by_ref().take(count).collect();
        assert_eq!(values.len(), count, "{} has a value for every output", entry.program.name());
        values
    };
    let values = entries.iter().map(of_entry).collect();
    assert_eq!(numbers.next(), None);
    values
}

fn run(program: &std::path::Path) -> String {
    let output = Command::new(program).output().expect("the compiled program runs");
    assert!(output.status.success(), "{}", program.display());
    String::from_utf8(output.stdout).expect("numbers")
}

/// Returns the emitted text of a target, without the entries that the target cannot express.
pub(crate) fn text(entries: &[&Entry], target: Target, precision: Precision) -> String {
    let programs: Vec<_> = entries.iter().map(|entry| entry.program.clone()).collect();
    emit(&sources(&programs), target, precision).expect("every kernel can be said")
}

/// Returns the values of C, or of CUDA as C++.
pub(crate) fn of_c(compiler: &str, entries: &[&Entry], target: Target, format: Format) -> Values {
    let (number, precision) = match format {
        Format::F32 => ("float", Precision::F32),
        Format::F64 => ("double", Precision::F64),
    };
    let prelude = if target == Target::Cuda { CUDA_AS_CPP } else { "" };
    let mut source = format!("{prelude}{}", text(entries, target, precision));
    source += "\n#include <inttypes.h>\n#include <stdio.h>\n#include <string.h>\n\
               static void print(double value) { uint64_t bits; memcpy(&bits, &value, sizeof bits); \
               printf(\"%\" PRIu64 \"\\n\", bits); }\n\
               static double number(uint64_t bits) { double value; memcpy(&value, &bits, sizeof value); return value; }\n";
    let mut main = String::new();
    for entry in entries {
        let (name, arguments) = (entry.program.name(), entry.program.arguments().len());
        let (count, rows) = (entry.program.outputs().len(), entry.rows.len());
        let bits = items(entry, |x| format!("{}u", x.to_bits()));
        let _ = writeln!(source, "static const uint64_t rows_of_{name}[] = {{{bits}}};");
        let mut call: Vec<String> = (0..arguments)
            .map(|place| format!("({number})number(rows_of_{name}[{arguments} * i + {place}])"))
            .collect();
        let value = if count == 1 { "outputs[0] = " } else { "" };
        if count > 1 {
            call.push("outputs".to_owned());
        }
        let _ = writeln!(
            main,
            "    for (int i = 0; i < {rows}; i++) {{\n        {value}{name}({});\n        \
             for (int j = 0; j < {count}; j++) print((double)outputs[j]);\n    }}",
            call.join(", ")
        );
    }
    let _ = writeln!(source, "int main(void) {{\n    {number} outputs[8];\n{main}}}");
    let (extension, standard) =
        if target == Target::Cuda { ("cu.cpp", "-std=c++14") } else { ("c", "-std=c99") };
    let name = format!("conformance_{compiler}_{}", precision.name());
    let (file, program) = (folder().join(format!("{name}.{extension}")), folder().join(&name));
    std::fs::write(&file, source).expect("a file in the build's folder");
    let path = program.to_string_lossy();
    accepted(compiler, &[standard, "-Wall", "-Wextra", "-Werror", "-o", &path], &file, &["-lm"]);
    distributed(&run(&program), entries)
}

/// Returns the values of Rust in three forms: functions of `f64`, formulas in `f64` and in `f32`.
pub(crate) fn of_rust(entries: &[&Entry]) -> [Values; 3] {
    let docs = KernelDocs { formula: "f".into(), ..KernelDocs::default() };
    let mut source =
        "#![deny(warnings)]\n#![allow(non_camel_case_types)]\n".to_owned() + &forms_math::source();
    let mut calls = [String::new(), String::new(), String::new()];
    for entry in entries {
        let (name, arguments) = (entry.program.name(), entry.program.arguments().len());
        let (outputs, rows) = (entry.program.outputs().len(), entry.rows.len());
        source += &emit_rust(&entry.program, &docs, "forms_math");
        let formula = emit_formula(&entry.program, &format!("K_{name}"), "forms_math");
        let bits = items(entry, |x| x.to_bits().to_string());
        let _ = writeln!(
            source,
            "enum K_{name} {{}}\n{formula}const ROWS_{name}: [u64; {}] = [{bits}];",
            rows * arguments
        );
        let list = (0..arguments).map(|place| format!("x[{place}]")).collect::<Vec<_>>().join(", ");
        let function = if outputs == 1 { format!("[{name}({list})]") } else { format!("{name}({list})") };
        let formula = format!("<K_{name} as forms_math::Formula<{arguments}, {outputs}>>::value");
        let single = format!("{formula}(x.map(|x| x as f32)).map(f64::from)");
        for (calls, value) in calls.iter_mut().zip([function, format!("{formula}(x)"), single]) {
            let _ = writeln!(
                calls,
                "    for row in ROWS_{name}.chunks_exact({arguments}) {{\n        \
                 let x: [f64; {arguments}] = std::array::from_fn(|place| f64::from_bits(row[place]));\n        \
                 print(&{value});\n    }}"
            );
        }
    }
    source += "fn print(values: &[f64]) {\n    values.iter().for_each(|value| println!(\"{}\", value.to_bits()));\n}\n";
    let _ = writeln!(source, "#[allow(non_upper_case_globals)]\nfn main() {{\n{}}}", calls.concat());
    let source = source.replace("const ROWS_", "#[allow(non_upper_case_globals)]\nconst ROWS_");
    let (file, program) = (folder().join("conformance.rs"), folder().join("conformance_rust"));
    std::fs::write(&file, source).expect("a file in the build's folder");
    let rustc = std::env::var("RUSTC").unwrap_or_else(|_| "rustc".to_string());
    accepted(&rustc, &["--edition", "2024", "-o", &program.to_string_lossy()], &file, &[]);
    let thrice: Vec<&Entry> = [entries, entries, entries].concat();
    let values = distributed(&run(&program), &thrice);
    let mut parts = values.chunks(entries.len()).map(<[_]>::to_vec);
    std::array::from_fn(|_| parts.next().expect("three forms"))
}
