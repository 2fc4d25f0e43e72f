//! Batches in `f32` against batches in `f64`, over all bit patterns or evenly chosen ones, with every set of instructions
//! that the processor has: at most 2 units in the last place, and NaN, ∞ and the sign of zero where they belong.

use crate::formulas::*;
use forms_math::{Formula, Instructions, batch_by, batch_f32_by};

/// What is allowed.
const LIMIT: f64 = 2.0;

/// The values that are compared at once.
const CHUNK: usize = 1 << 14;

/// The distance in units that `f32` has in the last place at the exact value.
fn units(computed: f32, exact: f64) -> f64 {
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

/// The largest error over every `stride`th bit pattern, for each set of instructions.
fn worst<F: Formula<1, 1>>(stride: usize) -> Vec<(f64, f32)> {
    let best = Instructions::best();
    let mut worst = vec![(0.0, f32::NAN); Instructions::available().len()];
    let (mut computed, mut exact) = (vec![0.0_f32; CHUNK], vec![0.0_f64; CHUNK]);
    let patterns = (1_usize << 32).div_ceil(stride);
    for start in (0..patterns).step_by(CHUNK) {
        let x: Vec<f32> = (start..patterns.min(start + CHUNK))
            .map(|index| f32::from_bits((index * stride) as u32))
            .collect();
        let wide: Vec<f64> = x.iter().map(|&x| f64::from(x)).collect();
        let (computed, exact) = (&mut computed[..x.len()], &mut exact[..x.len()]);
        batch_by::<F, 1, 1>(best, [&wide], [exact]).expect("columns have one length");
        for (worst, instructions) in worst.iter_mut().zip(Instructions::available()) {
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

/// The errors of one function, and whether they are allowed.
fn report<F: Formula<1, 1>>(name: &str, stride: usize) -> bool {
    let worst = worst::<F>(stride);
    for ((error, place), instructions) in worst.iter().zip(Instructions::available()) {
        println!("{name:10} {:9} {error:.3} at {place:e}", instructions.name());
    }
    worst.iter().all(|(error, _)| *error <= LIMIT)
}

fn assert_accurate(stride: usize) {
    let results = [
        report::<Exp>("exp", stride),
        report::<ExpM1>("exp_m1", stride),
        report::<Ln>("ln", stride),
        report::<Ln1p>("ln_1p", stride),
        report::<Sin>("sin", stride),
        report::<Cos>("cos", stride),
        report::<Tan>("tan", stride),
        report::<Asin>("asin", stride),
        report::<Acos>("acos", stride),
        report::<Atan>("atan", stride),
        report::<Sinh>("sinh", stride),
        report::<Cosh>("cosh", stride),
        report::<Tanh>("tanh", stride),
        report::<Erf>("erf", stride),
        report::<Power<1, 3>>("power 1/3", stride),
        report::<Power<-3, 2>>("power -3/2", stride),
        report::<Power<4, 1>>("power 4", stride),
        report::<Power<-2, 1>>("power -2", stride),
        report::<Power<5, 12>>("power 5/12", stride),
    ];
    assert!(results.iter().all(|within| *within), "a function is not within {LIMIT} units; see the output");
}

#[test]
fn functions_of_f32_are_accurate_at_evenly_chosen_places() {
    assert_accurate(99_991);
}

/// All 2³² arguments: minutes where the code is optimised, hours where it is not.
#[test]
#[ignore = "takes all arguments: run it with --release"]
fn functions_of_f32_are_accurate_everywhere() {
    assert_accurate(1);
}
