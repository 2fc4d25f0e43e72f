//! Scan of kernels: at points from simple numbers and powers of ten, where strata lie, no kernel
//! lacks a value that its formula has. Each kernel is computed by its stable form, chosen
//! beforehand where a file of forms lies next to it.
//!
//! The reference is exact: enclosures of the formula at the given arguments. It is computed only
//! where a program gives NaN. `FORMS_SCAN` sets the number of points for each kernel.

mod extremes;

use forms_core::accuracy::{Format, Truth, Value};
use forms_core::check::read_theory;
use forms_core::compile::compile_kernel;
use forms_core::expression::{Expr, Node, Pool, Rational, Symbol};
use forms_core::stability::{Choices, EXTENSION};
use forms_core::theory::Kernel;
use std::path::{Path, PathBuf};

/// Returns the number of points for each kernel.
fn count() -> usize {
    std::env::var("FORMS_SCAN").ok().and_then(|text| text.parse().ok()).unwrap_or(24)
}

/// Largest exponent n of the powers of ten, which reach from −n to n: beyond, squares and products
/// of a few arguments leave the range of `f64`.
const LARGEST_POWER: i32 = 12;

const SIMPLE: [f64; 9] = [0.0, 0.25, -0.25, 0.5, -0.5, 1.0, -1.0, 2.0, -2.0];

/// xorshift64* (G. Marsaglia, S. Vigna).
struct Random(u64);

impl Random {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        (self.0.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11) % bound
    }

    fn number(&mut self) -> f64 {
        if self.below(3) > 0 {
            return SIMPLE[self.below(SIMPLE.len() as u64) as usize];
        }
        let exponent = self.below(2 * LARGEST_POWER as u64 + 1) as i32 - LARGEST_POWER;
        let sign = if self.below(2) == 0 { 1.0 } else { -1.0 };
        sign * 10f64.powi(exponent)
    }
}

/// Results of a scan.
#[derive(Default)]
struct Scan {
    kernels: usize,
    points: usize,
    /// Number of points at which the `f64` program gives numbers, and at which it gives NaN where
    /// the formula is undefined.
    numbers: usize,
    undefined: usize,
    /// NaN where the formula has a value, and values lost at the ends of the range.
    lost: Vec<String>,
}

/// Returns the values of the formula in `f64`, where it is defined.
fn truth(pool: &Pool, kernel: &Kernel, arguments: &[f64], format: Format) -> Vec<Value> {
    let numbers = arguments.iter().map(|&value| Rational::from_float(value).expect("finite"));
    let point: Vec<(Symbol, Rational)> = kernel.arguments.iter().copied().zip(numbers).collect();
    let conditions = Truth::new(pool, &[], &kernel.domain);
    if conditions.admits(&point) != Some(true) {
        return vec![Value::Undefined; kernel.outputs.len()];
    }
    Truth::new(pool, &kernel.outputs, &[]).up_to(2500).at(&point, format)
}

impl Scan {
    fn file(&mut self, path: &Path, count: usize) {
        let text = std::fs::read_to_string(path).expect("a text");
        if !["kernel ", "warp "].iter().any(|word| text.contains(word)) {
            return;
        }
        let (mut theory, _) = read_theory(&text);
        if let Ok(chosen) = std::fs::read_to_string(path.with_extension(EXTENSION)) {
            Choices::read(&chosen).expect("a file of chosen forms").apply(&mut theory);
        }
        for kernel in theory.kernels.clone() {
            // an integral in hundreds of bits takes seconds
            let is_integral = |part: &Expr| matches!(theory.pool.node(*part), Node::Jet { .. });
            let has_integrals = theory.pool.reachable(&kernel.outputs).iter().any(is_integral);
            let is_deep = std::env::var_os("FORMS_SCAN").is_some();
            let count = match (has_integrals, is_deep) {
                (true, false) => continue,
                (true, true) => count.div_ceil(20),
                (false, false) if kernel.within.is_some() => count.div_ceil(4),
                (false, _) => count,
            };
            let Ok(generated) = compile_kernel(&mut theory.pool, &kernel) else { continue };
            self.kernels += 1;
            if kernel.has_form() || !generated.rewritten.is_empty() {
                let lost = extremes::lost(&theory, &kernel, &generated, count, &mut extremes::Random::new(7));
                // products that underflow in another order are not a fault of the form
                let lost = lost.into_iter().filter(|lost| lost.exact != 0.0);
                self.lost.extend(lost.map(|lost| format!("{}: {}", kernel.name, lost.text)));
            }
            let mut random = Random(0x9e37_79b9_7f4a_7c15 ^ (kernel.name.len() as u64) << 7);
            for _ in 0..count {
                let point: Vec<f64> = kernel.arguments.iter().map(|_| random.number()).collect();
                self.points += 1;
                self.look(&theory.pool, &kernel, &point, &generated.values(&point), path);
            }
        }
    }

    fn look(&mut self, pool: &Pool, kernel: &Kernel, point: &[f64], values: &[f64], path: &Path) {
        if !values.iter().any(|value| value.is_nan()) {
            self.numbers += 1;
            return;
        }
        let exact = truth(pool, kernel, point, Format::Double);
        let mut lost = false;
        for (place, (value, exact)) in values.iter().zip(&exact).enumerate() {
            if value.is_nan() && matches!(exact, Value::Known(_)) {
                lost = true;
                let file = path.file_name().unwrap_or_default().to_string_lossy();
                self.lost.push(format!("{file} {}[{place}] {point:?}: {exact:?}", kernel.name));
            }
        }
        self.undefined += usize::from(!lost);
    }

    fn finish(self, name: &str) {
        println!(
            "{name}: {} kernels, {} points: {} with numbers, {} where the formula has none, {} values lost",
            self.kernels,
            self.points,
            self.numbers,
            self.undefined,
            self.lost.len()
        );
        assert!(self.kernels > 0 && self.numbers > self.points / 20, "the scan looks at something");
        assert!(self.lost.is_empty(), "{} values lost:\n{}", self.lost.len(), self.lost.join("\n"));
    }
}

fn files(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let mut files: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "forms")).collect();
    files.sort();
    files
}

#[test]
fn kernels_of_the_repository_have_every_value_of_their_formulas() {
    let mut scan = Scan::default();
    for folder in [
        "../forms-kernels/kernels",
        "../forms-radiometry/benches/kernels/forms",
        "../forms-serve/page/examples",
        "../tests/stability",
    ] {
        files(folder).iter().for_each(|path| scan.file(path, count()));
    }
    scan.finish("repository");
}

#[test]
fn formulas_as_people_write_them_keep_their_values() {
    let mut scan = Scan::default();
    scan.file(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/formulas.forms"), count());
    // files next to the repository, if there are any
    files("../../shared/faults").iter().for_each(|path| scan.file(path, count()));
    scan.finish("formulas");
}
