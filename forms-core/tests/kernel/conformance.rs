//! Conformance of the back ends: all of them run one table of functions and hard arguments, and the
//! errors of each stay within its declared tolerances.
//!
//! ```text
//! table: functions, kernels ─┬─ wide numbers, limits ──────────────▶ true values ─┐
//!                            ├─ interpreter: f32, f64, two words, four words ─────┤
//!                            ├─ guarded numbers · lanes ──────────────────────────┼─▶ errors ≤ tolerances
//!                            └─ Rust, C, CUDA as C++: emitted, compiled, run ─────┘
//! ```
//! WGSL is validated with the table here, and run with kernels by an interpreter and where there is a
//! device.

mod back_end;
mod compiled;
mod table;
mod truth;

use crate::targets::{accepted, compiles, folder, has_functions, sources, validated};
use back_end::{BackEnd, DOUBLE_DOUBLE, WIDE};
use compiled::{Values, of_c, of_rust, text};
use forms_core::emission::{Precision, Target, emit};
use forms_core::expression::Operation;
use forms_math::{DoubleDouble, Guarded, Lane32, Lane64, Real, Scalar, Wide};
use std::collections::BTreeMap;
use std::sync::OnceLock;
use table::{Entry, Function, entries};
use truth::{Exact, Format, Truth, truth, ulps};

/// Returns the row as the back end gets it.
fn arguments(row: &[f64], format: Format) -> Vec<f64> {
    match format {
        Format::F32 => row.iter().map(|&x| f64::from(x as f32)).collect(),
        Format::F64 => row.to_vec(),
    }
}

/// Returns the entries that a target can express.
fn of_target(entries: &[Entry], target: Target) -> Vec<&Entry> {
    let precision = target.usual_precision();
    let has =
        |entry: &&Entry| emit(&sources(std::slice::from_ref(&entry.program)), target, precision).is_ok();
    entries.iter().filter(has).collect()
}

/// Computes all entries in a number type.
fn interpreted<T: Real>(entries: &[&Entry], from: fn(f64) -> T, to: fn(T) -> f64) -> Values {
    let of_entry = |entry: &&Entry| {
        let interpreter = entry.program.interpreter::<T>();
        let value = |row: &Vec<f64>| {
            let row: Vec<T> = row.iter().map(|&x| from(x)).collect();
            interpreter.values(&row).into_iter().map(to).collect::<Vec<_>>()
        };
        entry.rows.iter().flat_map(value).collect()
    };
    entries.iter().map(of_entry).collect()
}

/// True values of the rows of each function, by the name of its program.
type Truths = BTreeMap<String, Vec<Truth>>;

/// Returns the true values at the rows of a format; all tests share them.
fn truths(format: Format) -> &'static Truths {
    static TRUTHS: [OnceLock<Truths>; 2] = [const { OnceLock::new() }; 2];
    TRUTHS[usize::from(format == Format::F32)].get_or_init(|| {
        let of_entry = |entry: &Entry| {
            let values = entry.rows.iter().map(|row| truth(entry, &arguments(row, format)));
            (entry.program.name().to_owned(), values.collect())
        };
        functions(&entries()).into_iter().map(of_entry).collect()
    })
}

/// Errors that exceed their tolerances, and the largest error of each function.
#[derive(Default)]
struct Judgement {
    wrong: Vec<String>,
    largest: BTreeMap<String, f64>,
}

impl Judgement {
    /// Compares the values of a back end with the truth, and those of kernels with the interpreter.
    fn judge(&mut self, back_end: BackEnd, entries: &[&Entry], values: &Values) {
        let format = back_end.format();
        let reference = match format {
            Format::F32 => interpreted::<f32>(entries, |x| x as f32, f64::from),
            Format::F64 => interpreted::<f64>(entries, |x| x, |x| x),
        };
        for ((entry, values), reference) in entries.iter().zip(values).zip(&reference) {
            let outputs = entry.program.outputs().len();
            let places = entry.rows.iter().flat_map(|row| std::iter::repeat_n(row, outputs));
            let truths = truths(format).get(entry.program.name());
            for (place, ((row, &value), &reference)) in places.zip(values).zip(reference).enumerate() {
                let row = arguments(row, format);
                match entry.function.zip(truths) {
                    Some((function, truths)) => {
                        self.function((back_end, function), &row, value, truths[place], reference);
                    }
                    None => self.kernel(back_end, entry, &row, value, reference),
                }
            }
        }
    }

    fn function(
        &mut self,
        (back_end, function): (BackEnd, Function),
        row: &[f64],
        value: f64,
        truth: Truth,
        reference: f64,
    ) {
        if function.skips(row) || value.is_nan() && back_end.gives_up(function, row) {
            return;
        }
        let error = ulps(value, truth, back_end.format());
        // zeros have the sign that the standard library gives them, except sums and powers
        let is_unsigned = matches!(function, Function::MultiplyAdd | Function::Power(..));
        let has_sign = is_unsigned
            || value != 0.0
            || reference != 0.0
            || value.is_sign_negative() == reference.is_sign_negative();
        let largest = self.largest.entry(format!("{back_end:?} {function:?}")).or_default();
        *largest = largest.max(error);
        if error > back_end.tolerance(function, row) || !has_sign {
            self.wrong
                .push(format!("{back_end:?} {function:?} at {row:?}: {value:e}, not {truth:?}: {error} ulp"));
        }
    }

    fn kernel(&mut self, back_end: BackEnd, entry: &Entry, row: &[f64], value: f64, reference: f64) {
        let expected = if reference.is_nan() {
            Truth::Undefined
        } else if reference.is_infinite() {
            Truth::Infinite(reference)
        } else {
            Truth::Finite(Exact::from_f64(reference))
        };
        let error = ulps(value, expected, back_end.format());
        if error > back_end.tolerance_of_kernel(has_functions(&entry.program)) {
            let name = entry.program.name();
            self.wrong.push(format!("{back_end:?} {name} at {row:?}: {value:e}, interpreted {reference:e}"));
        }
    }

    /// Fails if an error exceeds its tolerance; `--nocapture` shows the largest errors.
    #[track_caller]
    fn assert(self) {
        self.largest.iter().for_each(|(name, error)| println!("{name}: {error:.3}"));
        assert!(self.wrong.is_empty(), "{} errors:\n{}", self.wrong.len(), self.wrong.join("\n"));
    }
}

/// Returns the entries of functions: kernels are compared with the interpreter, which computes them.
fn functions(entries: &[Entry]) -> Vec<&Entry> {
    entries.iter().filter(|entry| entry.function.is_some()).collect()
}

/// Compares a number type in which the interpreter computes.
fn judge_numbers<T: Real>(back_end: BackEnd, from: fn(f64) -> T, to: fn(T) -> f64) {
    let entries = entries();
    let entries = functions(&entries);
    let mut judgement = Judgement::default();
    judgement.judge(back_end, &entries, &interpreted(&entries, from, to));
    judgement.assert();
}

#[test]
fn interpreters_conform() {
    judge_numbers::<f64>(BackEnd::Interpreter(Precision::F64), |x| x, |x| x);
    judge_numbers::<f32>(BackEnd::Interpreter(Precision::F32), |x| x as f32, f64::from);
}

#[test]
fn lanes_conform() {
    judge_numbers::<Lane64<false>>(BackEnd::Lane(Format::F64, false), Lane64, |x| x.0);
    judge_numbers::<Lane64<true>>(BackEnd::Lane(Format::F64, true), Lane64, |x| x.0);
    judge_numbers::<Lane32<false>>(BackEnd::Lane(Format::F32, false), |x| Lane32(x as f32), |x| x.0.into());
    judge_numbers::<Lane32<true>>(BackEnd::Lane(Format::F32, true), |x| Lane32(x as f32), |x| x.0.into());
}

/// Judges the compiled text of C, or of CUDA as C++, by every compiler that is installed.
fn judge_compiled(target: Target, compilers: &[&str], back_end: fn(Format) -> BackEnd, test: &str) {
    let entries = entries();
    let entries = of_target(&entries, target);
    let mut judgement = Judgement::default();
    for compiler in compilers.iter().filter(|compiler| compiles(compiler, test)) {
        for format in [Format::F64, Format::F32] {
            judgement.judge(back_end(format), &entries, &of_c(compiler, &entries, target, format));
        }
    }
    judgement.assert();
}

#[test]
fn c_conforms() {
    // `cc` links every Rust program, and on most machines it is one of the other two
    judge_compiled(Target::C, &["cc", "gcc", "clang"], BackEnd::C, "kernel::conformance::c_conforms");
}

#[test]
fn cuda_conforms_as_cpp() {
    judge_compiled(Target::Cuda, &["g++"], BackEnd::Cuda, "kernel::conformance::cuda_conforms_as_cpp");
}

#[test]
fn cuda_is_sound_for_its_compiler() {
    if !forms_testing::is_installed("nvcc") {
        let test = "kernel::conformance::cuda_is_sound_for_its_compiler";
        forms_testing::skipped(test, "nvcc", "it is not in PATH");
        return;
    }
    let entries = entries();
    for precision in [Precision::F64, Precision::F32] {
        let file = folder().join(format!("conformance_{}.cu", precision.name()));
        let text = text(&of_target(&entries, Target::Cuda), Target::Cuda, precision);
        std::fs::write(&file, text).expect("a file in the build's folder");
        accepted("nvcc", &["-c", "-o", "/dev/null"], &file, &[]);
    }
}

#[test]
fn cuda_compiles_without_headers() {
    let entries = entries();
    for precision in [Precision::F64, Precision::F32] {
        let file = folder().join(format!("conformance_{}_nvrtc.cu", precision.name()));
        let text = text(&of_target(&entries, Target::Cuda), Target::Cuda, precision);
        std::fs::write(&file, text).expect("a file in the build's folder");
        forms_testing::accepted_by_nvrtc("kernel::conformance::cuda_compiles_without_headers", &file);
    }
}

#[test]
fn wgsl_is_valid() {
    let entries = entries();
    validated(&text(&of_target(&entries, Target::Wgsl), Target::Wgsl, Precision::F32));
}

#[test]
fn rust_conforms() {
    let entries = entries();
    let entries: Vec<&Entry> = entries.iter().collect();
    let mut judgement = Judgement::default();
    let back_ends =
        [BackEnd::Rust(Precision::F64), BackEnd::RustFormula(Format::F64), BackEnd::RustFormula(Format::F32)];
    for (back_end, values) in back_ends.into_iter().zip(of_rust(&entries)) {
        judgement.judge(back_end, &entries, &values);
    }
    judgement.assert();
}

/// Numbers whose words are exact summands, and the number of digits of which they lose at most
/// sixteen units.
trait Words: Real {
    const BITS: i64;
    fn exactly(self) -> Exact;
}

impl Words for DoubleDouble {
    const BITS: i64 = 106;
    fn exactly(self) -> Exact {
        Exact::from_f64(self.high()) + Exact::from_f64(self.low())
    }
}

impl Words for Wide<4> {
    const BITS: i64 = 248;
    fn exactly(self) -> Exact {
        self.to_limbs()
    }
}

/// Compares a number type of more digits where they have room between the ends of the range.
fn judge_words<T: Words>(most: f64) {
    let zero = Exact::from_f64(0.0);
    let has_room = |exact: Exact| exact.exponent().map_or(exact == zero, |exponent| exponent.abs() < 900);
    let mut wrong = Vec::new();
    for entry in functions(&entries()) {
        let rows = entry
            .rows
            .iter()
            .filter(|row| row.iter().all(|x| x.is_finite() && has_room(Exact::from_f64(*x))));
        let interpreter = entry.program.interpreter::<T>();
        for row in rows {
            let numbers: Vec<T> = row.iter().map(|&x| T::from_f64(x)).collect();
            let value = interpreter.values(&numbers)[0].exactly();
            let exact: Vec<Exact> = row.iter().map(|&x| Exact::from_f64(x)).collect();
            let exact = entry.program.interpret_as(&exact)[0];
            let is_undefined = exact.is_nan() || !has_room(exact);
            let error =
                if value == exact { 0.0 } else { ((value - exact) / exact).abs().scaled(T::BITS).to_f64() };
            if !is_undefined && (error > most || error.is_nan()) {
                wrong.push(format!("{:?} at {row:?}: {error} units", entry.function));
            }
        }
    }
    assert!(wrong.is_empty(), "{} errors:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn double_double_numbers_conform() {
    judge_words::<DoubleDouble>(DOUBLE_DOUBLE);
}

#[test]
fn wide_numbers_conform() {
    judge_words::<Wide<4>>(WIDE);
}

/// Whether bounds are not compared: they do not distinguish −0 from 0 on the branch cut.
fn is_beyond_guards(entry: &Entry, row: &[f64]) -> bool {
    match entry.function {
        Some(Function::Operation(Operation::Atan2)) => {
            row[0] == 0.0 && row.iter().any(|x| x.is_sign_negative())
        }
        _ => false,
    }
}

#[test]
fn bounds_of_guarded_numbers_contain_the_truth() {
    let mut wrong = Vec::new();
    for entry in functions(&entries()) {
        let interpreter = entry.program.interpreter::<Guarded<f64>>();
        let truths = &truths(Format::F64)[entry.program.name()];
        for (row, &truth) in entry.rows.iter().zip(truths).filter(|(row, _)| !is_beyond_guards(entry, row)) {
            let numbers: Vec<Guarded<f64>> = row.iter().map(|&x| Guarded::from_f64(x)).collect();
            let found = interpreter.values(&numbers)[0];
            let is_known = found.error().is_finite() && !found.is_undefined();
            let is_right = match truth {
                Truth::Finite(exact) if is_known => {
                    let distance = (Exact::from_f64(found.value()) - exact).abs();
                    (distance - Exact::from_f64(found.error())).to_f64() <= 0.0
                }
                Truth::Finite(_) => !found.error().is_finite() || row.iter().any(|x| x.is_infinite()),
                Truth::Undefined | Truth::Infinite(_) => !is_known || found.value().is_infinite(),
            };
            if !is_right {
                wrong.push(format!("{:?} at {row:?}: {found:?}", entry.function));
            }
        }
    }
    assert!(wrong.is_empty(), "{} errors:\n{}", wrong.len(), wrong.join("\n"));
}
