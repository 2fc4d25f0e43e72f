//! Benchmarks of batches: each function in lanes, with every set of instructions, compared with the
//! function of single numbers; and batches within an accuracy for which lanes compute the error
//! bounds. The throughput is in values.

use criterion::{
    BenchmarkGroup, Criterion, Throughput, criterion_group, criterion_main, measurement::WallTime,
};
use forms_math::{Formula, Instructions, Real, batch_by, batch_f32_by, batch_within_by};
use std::hint::black_box;

/// Number of values of a batch: two columns of this length fit in the L1 cache.
const COUNT: usize = 2048;

/// Returns uniformly distributed numbers in no particular order.
fn column(from: f64, to: f64) -> Vec<f64> {
    (0..COUNT).map(|index| from + (to - from) * ((index * 797 % COUNT) as f64 + 0.5) / COUNT as f64).collect()
}

fn function<F: Formula<1, 1>>(criterion: &mut Criterion, name: &str, from: f64, to: f64) {
    let mut group = criterion.benchmark_group(name);
    group.throughput(Throughput::Elements(COUNT as u64));
    let (x, mut values) = (column(from, to), vec![0.0; COUNT]);
    let (x_single, mut values_single): (Vec<f32>, _) =
        (x.iter().map(|&x| x as f32).collect(), vec![0.0; COUNT]);
    for instructions in Instructions::available() {
        group.bench_function(format!("f64 {}", instructions.name()), |bencher| {
            bencher.iter(|| batch_by::<F, 1, 1>(instructions, [black_box(&x)], [black_box(&mut values)]));
        });
        group.bench_function(format!("f32 {}", instructions.name()), |bencher| {
            bencher.iter(|| {
                batch_f32_by::<F, 1, 1>(instructions, [black_box(&x_single)], [black_box(&mut values_single)])
            });
        });
    }
    group.bench_function("f64 within 8 units", |bencher| {
        let best = Instructions::best();
        bencher.iter(|| batch_within_by::<F, 1, 1>(best, [black_box(&x)], [black_box(&mut values)], 8.0));
    });
    one_number::<F>(&mut group, &x, &mut values);
}

fn one_number<F: Formula<1, 1>>(group: &mut BenchmarkGroup<WallTime>, x: &[f64], values: &mut [f64]) {
    group.bench_function("f64 one number", |bencher| {
        bencher.iter(|| {
            for (value, x) in black_box(&mut *values).iter_mut().zip(black_box(x)) {
                [*value] = F::value([*x]);
            }
        });
    });
}

macro_rules! functions {
    ($($name:ident: |$x:ident| $body:expr, $from:expr, $to:expr;)*) => {
        $(
            struct $name;
            impl Formula<1, 1> for $name {
                #[inline(always)]
                fn value<T: Real>([$x]: [T; 1]) -> [T; 1] {
                    [$body]
                }
            }
        )*
        fn functions(criterion: &mut Criterion) {
            $(function::<$name>(criterion, stringify!($name), $from, $to);)*
        }
    };
}

functions! {
    Exp: |x| x.exp(), -5.0, 5.0;
    ExpM1: |x| x.exp_m1(), -5.0, 5.0;
    Ln: |x| x.ln(), 0.1, 50.0;
    Ln1p: |x| x.ln_1p(), -0.9, 50.0;
    Sin: |x| x.sin(), -50.0, 50.0;
    Cos: |x| x.cos(), -50.0, 50.0;
    Tan: |x| x.tan(), -50.0, 50.0;
    Asin: |x| x.asin(), -1.0, 1.0;
    Acos: |x| x.acos(), -1.0, 1.0;
    Atan: |x| x.atan(), -5.0, 5.0;
    Sinh: |x| x.sinh(), -5.0, 5.0;
    Cosh: |x| x.cosh(), -5.0, 5.0;
    Tanh: |x| x.tanh(), -5.0, 5.0;
    Erf: |x| x.erf(), -4.0, 4.0;
    Sqrt: |x| x.sqrt(), 0.0, 4.0;
    CubeRoot: |x| x.power(1, 3), 0.1, 4.0;
    ThreeHalvesDown: |x| x.power(-3, 2), 0.1, 4.0;
    Rational: |x| x.power(-11, 5), 0.1, 4.0;
}

criterion_group!(benches, functions);
criterion_main!(benches);
