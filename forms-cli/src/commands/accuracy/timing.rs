//! Timing: the generated source of a kernel is compiled and run on typical arguments.
//!
//! ```text
//! the crate of the arithmetic ─ rustc, once ─▶ library ─┐
//! program ─ formula, harness ─ rustc ─▶ executable ─────┴─ run ─▶ nanoseconds per value, for each variant
//! ```
//! Compiled like a release build, for no particular processor: batches select their instructions at
//! run time.

use forms::core::accuracy::{Arithmetic, Regime, Variant, Width, sample};
use forms::core::emission::emit_formula;
use forms::core::expression::Pool;
use forms::core::generation::Generated;
use forms::core::theory::Kernel;
use std::collections::HashMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Number of rows of the timed columns: their arguments and results fit in the L1 cache.
pub(super) const ROWS: usize = 1024;

/// Number of different rows among them.
const DIFFERENT: usize = 128;

/// Smallest and largest number of runs, of which the median is taken. Each run takes some tenths of
/// a millisecond; within these limits, the number of runs is chosen to fill half a second.
pub(super) const RUNS: [usize; 2] = [11, 101];

/// Temporary folder with the compiled library of the arithmetic.
pub(super) struct Workshop {
    folder: PathBuf,
}

impl Workshop {
    /// Creates a workshop, or returns `None` if rustc is not available.
    pub(super) fn open() -> Option<Self> {
        let folder = std::env::temp_dir().join(format!("forms-accuracy-{}", std::process::id()));
        let workshop = Workshop { folder };
        let source = workshop.folder.join("forms_math");
        for (path, text) in forms::math::crate_files() {
            let path = source.join(path);
            std::fs::create_dir_all(path.parent()?).ok()?;
            std::fs::write(path, text).ok()?;
        }
        let compiled =
            workshop.compile(&source.join("lib.rs"), &["--crate-type", "rlib", "--crate-name", "forms_math"]);
        compiled.then_some(workshop)
    }

    fn compile(&self, source: &Path, options: &[&str]) -> bool {
        let rustc = Command::new("rustc")
            .args(["--edition", "2024", "-C", "opt-level=3", "-C", "codegen-units=1", "--cap-lints", "allow"])
            .args(options)
            .arg("--out-dir")
            .arg(&self.folder)
            .arg("-L")
            .arg(&self.folder)
            .arg(source)
            .output();
        rustc.is_ok_and(|output| output.status.success())
    }

    /// Measures the nanoseconds of one value in each variant, by its name; `None` if the source
    /// does not compile or run.
    pub(super) fn times(
        &self,
        pool: &Pool,
        kernel: &Kernel,
        programs: &Generated,
    ) -> Option<HashMap<String, f64>> {
        let typical = sample(pool, kernel, Width::Single, &[Regime::Typical], DIFFERENT, 0);
        let rows: Vec<&[f64]> = typical.first()?.samples.iter().map(|sample| &sample.arguments[..]).collect();
        let source = self.folder.join("kernel.rs");
        std::fs::write(&source, harness(kernel, programs, &rows)).ok()?;
        let math = format!("forms_math={}", self.folder.join("libforms_math.rlib").display());
        if !self.compile(&source, &["--crate-name", "kernel", "--extern", &math]) {
            return None;
        }
        let output = Command::new(self.folder.join("kernel")).output().ok()?;
        let text = String::from_utf8(output.stdout).ok()?;
        let line = |line: &str| {
            let (name, time) = line.rsplit_once(' ')?;
            Some((name.to_string(), time.parse().ok()?))
        };
        text.lines().map(line).collect()
    }
}

impl Drop for Workshop {
    fn drop(&mut self) {
        // Files that cannot be removed are harmless in a temporary folder.
        let _ = std::fs::remove_dir_all(&self.folder);
    }
}

/// Generates a program that prints the median time of a value in each variant.
fn harness(kernel: &Kernel, programs: &Generated, rows: &[&[f64]]) -> String {
    let (arguments, outputs) = (kernel.arguments.len(), kernel.outputs.len());
    let mut text = String::from("use forms_math::*;\n");
    for (name, program) in [("Written", &programs.written), ("Stable", &programs.optimised)] {
        let _ = writeln!(text, "enum {name} {{}}\n{}", emit_formula(program, name, "forms_math"));
    }
    let bits: Vec<String> = (0..arguments)
        .map(|column| {
            let numbers: Vec<String> =
                rows.iter().map(|row| format!("{:#x}", row[column].to_bits())).collect();
            format!("[{}]", numbers.join(", "))
        })
        .collect();
    let _ = writeln!(text, "const BITS: [[u64; {}]; {arguments}] = [{}];", rows.len(), bits.join(",\n"));
    text.push_str(
        &MEASURE
            .replace("ARGUMENTS", &arguments.to_string())
            .replace("OUTPUTS", &outputs.to_string())
            .replace("ROWS", &ROWS.to_string())
            .replace("LEAST", &RUNS[0].to_string())
            .replace("MOST", &RUNS[1].to_string()),
    );
    text.push_str("fn main() {\n");
    for variant in Variant::ALL {
        let call =
            call(variant, &format!("{arguments}, {outputs}"), programs.within().filter(|_| variant.stable));
        let _ = writeln!(text, "    println!(\"{} {{}}\", {call});", variant.name());
    }
    text.push_str("}\n");
    text
}

/// Generates the timed call: the function that a user would call.
fn call(variant: Variant, counts: &str, within: Option<f64>) -> String {
    let form = if variant.stable { "Stable" } else { "Written" };
    match (variant.batch, variant.arithmetic, within) {
        (false, Arithmetic::Single, _) => format!("each(<{form} as Formula<{counts}>>::value::<f32>)"),
        (false, Arithmetic::Double, None) => format!("each(<{form} as Formula<{counts}>>::value::<f64>)"),
        (false, Arithmetic::Double, Some(within)) => {
            format!("each(|row| escalate::<{form}, {counts}>(row, {within:?}))")
        }
        (_, Arithmetic::DoubleDouble, None) => {
            format!("each(<{form} as Formula<{counts}>>::value::<DoubleDouble>)")
        }
        (_, Arithmetic::DoubleDouble, Some(_)) => {
            format!("each(escalate_double_double::<{form}, {counts}>)")
        }
        (true, Arithmetic::Single, _) => format!("column(batch_f32::<{form}, {counts}>)"),
        (true, Arithmetic::Double, None) => format!("column(batch::<{form}, {counts}>)"),
        (true, Arithmetic::Double, Some(within)) => {
            format!("column(|rows, values| batch_within::<{form}, {counts}>(rows, values, {within:?}))")
        }
    }
}

/// Part of the harness that is the same for every kernel.
const MEASURE: &str = "
fn columns<T: Real>() -> [Vec<T>; ARGUMENTS] {
    BITS.map(|column| column.iter().cycle().take(ROWS).map(|&bits| T::from_f64(f64::from_bits(bits))).collect())
}
fn median(mut run: impl FnMut()) -> f64 {
    run();
    let once = { let start = std::time::Instant::now(); run(); start.elapsed().as_secs_f64() };
    let repeats = (2e-4 / once.max(1e-9)).ceil().clamp(1.0, 1e4) as usize;
    let time = |_| {
        let start = std::time::Instant::now();
        (0..repeats).for_each(|_| run());
        start.elapsed().as_secs_f64() / repeats as f64
    };
    let runs = ((0.5 / (once * repeats as f64)) as usize).clamp(LEAST, MOST);
    let mut times: Vec<f64> = (0..runs).map(time).collect();
    times.sort_by(f64::total_cmp);
    times[runs / 2] * 1e9 / ROWS as f64
}
#[inline(never)]
fn one<T: Real>(value: &impl Fn([T; ARGUMENTS]) -> [T; OUTPUTS], arguments: [T; ARGUMENTS]) -> [T; OUTPUTS] {
    value(arguments)
}
fn each<T: Real>(value: impl Fn([T; ARGUMENTS]) -> [T; OUTPUTS]) -> f64 {
    let columns = columns::<T>();
    median(|| {
        for row in 0..ROWS {
            std::hint::black_box(one(&value, std::array::from_fn(|column| columns[column][row])));
        }
    })
}
fn column<T: Real, E: std::fmt::Debug>(batch: impl Fn([&[T]; ARGUMENTS], [&mut [T]; OUTPUTS]) -> Result<(), E>) -> f64 {
    let columns = columns::<T>();
    let mut outputs: [Vec<T>; OUTPUTS] = std::array::from_fn(|_| vec![T::from_f64(0.0); ROWS]);
    median(|| {
        let outputs = outputs.each_mut().map(|output| &mut output[..]);
        batch(columns.each_ref().map(|column| &column[..]), outputs).expect(\"columns of one length\");
        std::hint::black_box(&columns);
    })
}
";
