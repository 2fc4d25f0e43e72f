//! Functions of one number: by the system's library (or the crate `libm`, where Rust's standard library has no such
//! function), one value at a time by this crate, and in a batch; with the largest error of each.
//!
//! `cargo bench -p forms-math --bench functions -- [--write]` prints the table; with `--write`, the table of
//! `docs/benchmarks.md` is written anew.

use forms_math::{Formula, Instructions, Real, Wide, batch, batch_within, escalate};
use forms_testing::alternation::seconds_per_call;
use forms_testing::page::{processor, replaced};
use std::fmt::Write;
use std::hint::black_box;
use std::path::Path;

/// Number of values of a call, and of those whose error is measured.
const COUNT: usize = 1024;

/// Promise, in units of 2⁻⁵³, of the values that are computed with a bound of their error.
const WITHIN: f64 = 16.0;

/// Function with its range and its ways to be computed.
struct Row {
    name: &'static str,
    range: [f64; 2],
    system: fn(f64) -> f64,
    one: fn(f64) -> f64,
    bounded: fn(f64) -> f64,
    batch: fn(&[f64], &mut [f64]),
    bounded_batch: fn(&[f64], &mut [f64]),
    exact: fn(f64) -> Wide<4>,
}

macro_rules! rows {
    ($($name:literal, $formula:ident, |$x:ident| $body:expr, $system:expr, $range:expr;)*) => {
        $(
            struct $formula;
            impl Formula<1, 1> for $formula {
                #[inline(always)]
                fn value<T: Real>([$x]: [T; 1]) -> [T; 1] {
                    [$body]
                }
            }
        )*
        const ROWS: &[Row] = &[$(Row {
            name: $name,
            range: $range,
            system: $system,
            one: |x| $formula::value([x])[0],
            bounded: |x| escalate::<$formula, 1, 1>([x], WITHIN)[0],
            batch: |x, values| batch::<$formula, 1, 1>([x], [values]).expect("columns of one length"),
            bounded_batch: |x, values| {
                batch_within::<$formula, 1, 1>([x], [values], WITHIN).expect("columns of one length");
            },
            exact: |x| $formula::value([Wide::from_f64(x)])[0],
        }),*];
    };
}

rows! {
    "exp", Exp, |x| x.exp(), f64::exp, [-5.0, 5.0];
    "expm1", ExpM1, |x| x.exp_m1(), f64::exp_m1, [-5.0, 5.0];
    "log", Ln, |x| x.ln(), f64::ln, [0.1, 50.0];
    "log1p", Ln1p, |x| x.ln_1p(), f64::ln_1p, [-0.9, 50.0];
    "sin", Sin, |x| x.sin(), f64::sin, [-50.0, 50.0];
    "cos", Cos, |x| x.cos(), f64::cos, [-50.0, 50.0];
    "tan", Tan, |x| x.tan(), f64::tan, [-50.0, 50.0];
    "asin", Asin, |x| x.asin(), f64::asin, [-1.0, 1.0];
    "acos", Acos, |x| x.acos(), f64::acos, [-1.0, 1.0];
    "atan", Atan, |x| x.atan(), f64::atan, [-5.0, 5.0];
    "sinh", Sinh, |x| x.sinh(), f64::sinh, [-5.0, 5.0];
    "cosh", Cosh, |x| x.cosh(), f64::cosh, [-5.0, 5.0];
    "tanh", Tanh, |x| x.tanh(), f64::tanh, [-5.0, 5.0];
    "erf", Erf, |x| x.erf(), libm::erf, [-3.0, 3.0];
    "erfc", Erfc, |x| x.erfc(), libm::erfc, [-2.0, 6.0];
    "cbrt", Cbrt, |x| x.cbrt(), f64::cbrt, [-50.0, 50.0];
    "hypot(x, 1)", Hypot, |x| x.hypot(T::from_f64(1.0)), |x| x.hypot(1.0), [-5.0, 5.0];
    "atan2(x, 1 - x)", Angle, |x| x.atan2(T::from_f64(1.0) - x), |x| x.atan2(1.0 - x), [-5.0, 5.0];
    "x**(-3/2)", Power, |x| x.power(-3, 2), |x| x.powf(-1.5), [0.1, 50.0];
}

fn main() -> std::io::Result<()> {
    let table = table();
    print!("{table}");
    if std::env::args().any(|argument| argument == "--write") {
        let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/benchmarks.md");
        let text = std::fs::read_to_string(&page)?;
        std::fs::write(&page, replaced(&text, "functions", &table))?;
    }
    Ok(())
}

const HEAD: &str = "\
| function | system, ns | one value, ns | one value within 16, ns | batch, ns | batch within 16, ns | largest error: system | one value | batch |
|---|---|---|---|---|---|---|---|---|
";

fn table() -> String {
    let mut table = format!("Processor: {}; {}.\n\n{HEAD}", processor(), Instructions::best().name());
    for row in ROWS {
        let times = seconds(row).map(|seconds| format!("{:.2}", seconds * 1e9));
        let errors = errors(row).map(|units| format!("{units:.2}"));
        let cells = [&times[..], &errors].concat();
        writeln!(table, "| `{}` | {} |", row.name, cells.join(" | ")).expect("a String takes all text");
    }
    table
}

/// Returns arguments of the range in no particular order.
fn arguments([from, to]: [f64; 2]) -> Vec<f64> {
    (0..COUNT).map(|place| from + (to - from) * ((place * 797 % COUNT) as f64 + 0.5) / COUNT as f64).collect()
}

/// Returns the seconds per value of each way.
fn seconds(row: &Row) -> [f64; 5] {
    let x = &arguments(row.range);
    let one_by_one = |function: fn(f64) -> f64| -> Box<dyn FnMut()> {
        let (x, mut values) = (x.clone(), vec![0.0; COUNT]);
        Box::new(move || {
            for (value, &x) in black_box(&mut values).iter_mut().zip(black_box(&x)) {
                *value = function(x);
            }
        })
    };
    let over_columns = |function: fn(&[f64], &mut [f64])| -> Box<dyn FnMut()> {
        let (x, mut values) = (x.clone(), vec![0.0; COUNT]);
        Box::new(move || function(black_box(&x), black_box(&mut values)))
    };
    let ways = [
        one_by_one(row.system),
        one_by_one(row.one),
        one_by_one(row.bounded),
        over_columns(row.batch),
        over_columns(row.bounded_batch),
    ];
    let seconds = seconds_per_call(ways);
    std::array::from_fn(|place| seconds[place] / COUNT as f64)
}

/// Returns the largest errors of the system, of one value and of a batch, in units of 2⁻⁵³ of the value.
fn errors(row: &Row) -> [f64; 3] {
    let x = arguments(row.range);
    let mut values = vec![0.0; COUNT];
    (row.batch)(&x, &mut values);
    let exact: Vec<Wide<4>> = x.iter().map(|&x| (row.exact)(x)).collect();
    let largest = |value: &dyn Fn(usize) -> f64| {
        let units = |place: usize| {
            let exact = exact[place];
            ((Wide::from_f64(value(place)) - exact) / exact).to_f64().abs() * 2f64.powi(53)
        };
        (0..COUNT).map(units).fold(0.0, f64::max)
    };
    [
        largest(&|place| (row.system)(x[place])),
        largest(&|place| (row.one)(x[place])),
        largest(&|place| values[place]),
    ]
}
