//! Batches in `f32` compared with batches in `f64`, over all bit patterns or evenly spaced ones,
//! with every set of instructions of the processor: at most 2 units in the last place (erfc: 5), and correct
//! NaN, ∞ and signs of zero.

use crate::formulas::*;
use forms_math::{Formula, Instructions, batch_by, batch_f32_by};

/// Returns the allowed error of a function.
fn limit(name: &str) -> f64 {
    if name == "erfc" { 5.0 } else { 2.0 }
}

/// Number of values compared at once.
const CHUNK: usize = 1 << 14;

/// Returns the error in units in the last place of `f32` at the exact value.
#[inline]
fn units(computed: f32, exact: f64) -> f64 {
    let size = exact.abs();
    if size >= f64::from(f32::MIN_POSITIVE) && size < 1e38 && computed.is_finite() {
        let unit = f64::from_bits((2 * 1023 + 23 - (exact.to_bits() >> 52 & 0x7ff)) << 52);
        return (f64::from(computed) - exact).abs() * unit;
    }
    units_at_the_ends(computed, exact)
}

/// Returns the error where numbers are subnormal or overflow.
fn units_at_the_ends(computed: f32, exact: f64) -> f64 {
    let nearest = exact as f32;
    let same_kind =
        computed.is_nan() && nearest.is_nan() || computed == nearest && computed.signum() == nearest.signum();
    if same_kind && (exact == 0.0 || !nearest.is_finite()) {
        return 0.0;
    }
    if nearest.is_infinite() && computed.abs() == f32::MAX && computed.signum() == nearest.signum() {
        return 1.0;
    }
    if !computed.is_finite() || !exact.is_finite() {
        return f64::INFINITY;
    }
    let exponent = (((exact.to_bits() >> 52) & 0x7ff) as i32 - 1023).max(-126);
    (f64::from(computed) - exact).abs() * f64::from_bits(((1023 + 23 - exponent) as u64) << 52)
}

/// Selection of bit patterns: every n-th between two numbers, with these instructions.
struct Choice {
    stride: usize,
    within: std::ops::RangeInclusive<f32>,
    instructions: Vec<Instructions>,
}

/// Returns the largest error for each set of instructions, and its argument.
fn worst<F: Formula<1, 1>>(choice: &Choice) -> Vec<(f64, f32)> {
    let mut worst = vec![(0.0, f32::NAN); choice.instructions.len()];
    let (mut computed, mut exact) = (vec![0.0_f32; CHUNK], vec![0.0_f64; CHUNK]);
    let patterns = (1_usize << 32).div_ceil(choice.stride);
    for start in (0..patterns).step_by(CHUNK) {
        let numbers =
            (start..patterns.min(start + CHUNK)).map(|index| f32::from_bits((index * choice.stride) as u32));
        let x: Vec<f32> = numbers.filter(|x| x.is_nan() || choice.within.contains(x)).collect();
        let wide: Vec<f64> = x.iter().map(|&x| f64::from(x)).collect();
        let (computed, exact) = (&mut computed[..x.len()], &mut exact[..x.len()]);
        batch_by::<F, 1, 1>(Instructions::best(), [&wide], [exact]).expect("columns have one length");
        for (worst, &instructions) in worst.iter_mut().zip(&choice.instructions) {
            batch_f32_by::<F, 1, 1>(instructions, [&x], [computed]).expect("columns have one length");
            for ((x, computed), exact) in x.iter().zip(&*computed).zip(&*exact) {
                let error = units(*computed, *exact);
                if error > worst.0 {
                    *worst = (error, *x);
                }
            }
        }
    }
    worst
}

/// Reports the errors of one function; returns whether they are allowed.
fn report<F: Formula<1, 1>>(name: &str, choice: &Choice) -> bool {
    let worst = worst::<F>(choice);
    for ((error, place), instructions) in worst.iter().zip(&choice.instructions) {
        println!("{name:10} {:9} {error:.3} at {place:e}", instructions.name());
    }
    worst.iter().all(|(error, _)| *error <= limit(name))
}

/// Tests every function, on the part of its range in lanes that `choice` selects.
fn assert_accurate(choice: impl Fn(f32, f32) -> Choice) {
    let all = || choice(f32::NEG_INFINITY, f32::INFINITY);
    let results = [
        report::<Exp>("exp", &choice(-110.0, 90.0)),
        report::<ExpM1>("exp_m1", &choice(-110.0, 90.0)),
        report::<Ln>("ln", &choice(0.0, f32::INFINITY)),
        report::<Ln1p>("ln_1p", &choice(-1.0, f32::INFINITY)),
        report::<Sin>("sin", &choice(-6400.0, 6400.0)),
        report::<Cos>("cos", &choice(-6400.0, 6400.0)),
        report::<Tan>("tan", &choice(-6400.0, 6400.0)),
        report::<Asin>("asin", &choice(-1.0, 1.0)),
        report::<Acos>("acos", &choice(-1.0, 1.0)),
        report::<Atan>("atan", &all()),
        report::<Sinh>("sinh", &choice(-91.0, 91.0)),
        report::<Cosh>("cosh", &choice(-91.0, 91.0)),
        report::<Tanh>("tanh", &choice(-20.0, 20.0)),
        report::<Erf>("erf", &choice(-5.0, 5.0)),
        report::<Erfc>("erfc", &choice(-5.0, 20.0)),
        report::<Power<1, 3>>("power 1/3", &choice(1e-28, 1e36)),
        report::<Power<-3, 2>>("power -3/2", &choice(1e-19, 1e19)),
        report::<Power<-2, 1>>("power -2", &choice(1e-14, 1e18)),
        report::<Power<5, 12>>("power 5/12", &choice(1e-28, 1e36)),
    ];
    assert!(results.iter().all(|within| *within), "a function is not accurate; see the output");
}

/// Returns the stride between bit patterns: from `FORMS_MATH_STRIDE`, or a default that unoptimised
/// code processes in seconds.
fn stride() -> usize {
    std::env::var("FORMS_MATH_STRIDE").ok().and_then(|stride| stride.parse().ok()).unwrap_or(99_991)
}

#[test]
fn functions_of_f32_are_accurate_at_evenly_chosen_places() {
    let everything = f32::NEG_INFINITY..=f32::INFINITY;
    assert_accurate(|_, _| Choice {
        stride: stride(),
        within: everything.clone(),
        instructions: Instructions::available(),
    });
}

/// Tests all arguments that lanes compute, with and without fused multiply-add.
#[test]
#[ignore = "takes all arguments: run it with --release"]
fn functions_of_f32_are_accurate_everywhere() {
    let all = Instructions::available();
    let ends: Vec<_> = if all.len() > 1 { vec![all[0], all[all.len() - 1]] } else { all };
    assert_accurate(|from, to| Choice { stride: 1, within: from..=to, instructions: ends.clone() });
}
