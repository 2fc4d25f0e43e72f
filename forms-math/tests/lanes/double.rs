//! Batches in `f64` compared with 256-bit values, with every set of instructions of the processor:
//! at most 2 units in the last place, and 5 for erfc. `FORMS_MATH_CASES` sets the number of arguments of each
//! function.

use crate::arguments::{Draw, arguments};
use crate::formulas::*;
use forms_math::{Formula, Instructions, Real, Wide, batch_by};

/// Returns the allowed error of a function: those that bounded lanes rely on.
fn limit(name: &str) -> f64 {
    match name {
        "exp" | "ln" | "ln_1p" | "sin" | "cos" | "asin" | "acos" | "sinh" | "cosh" | "tanh" => 1.0,
        "atan" | "atan2" | "exp_m1" => 1.5,
        "erfc" => 5.0,
        _ => 2.0,
    }
}

/// Largest angle that lanes compute.
const REACH: f64 = 1_647_000.0;

fn cases() -> usize {
    std::env::var("FORMS_MATH_CASES").ok().and_then(|count| count.parse().ok()).unwrap_or(400)
}

/// Returns the error in units in the last place of `f64` at the exact value.
fn units(computed: f64, exact: Wide<4>) -> f64 {
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    let nearest = exact.to_f64();
    let exponent = (((nearest.to_bits() >> 52) & 0x7ff) as i64 - 1023).max(-1022);
    let difference = Wide::from_f64(computed) - exact;
    // Scaled twice by half of the power, which itself can be out of range.
    let half = (52 - exponent) / 2;
    let power = |exponent: i64| Wide::from_f64(f64::from_bits(((1023 + exponent) as u64) << 52));
    (difference * power(half) * power(52 - exponent - half)).to_f64().abs()
}

/// Returns the largest error of each set of instructions, and its arguments.
fn worst<F: Formula<A, 1>, const A: usize>(columns: &[Vec<f64>; A]) -> Vec<(&'static str, f64, [f64; A])> {
    let rows = columns[0].len();
    let at = |row: usize| columns.each_ref().map(|column| column[row]);
    let exact: Vec<Wide<4>> = (0..rows).map(|row| F::value(at(row).map(Wide::from_f64))[0]).collect();
    let of = |instructions: Instructions| {
        let mut computed = vec![0.0; rows];
        batch_by::<F, A, 1>(instructions, columns.each_ref().map(|column| &column[..]), [&mut computed])
            .expect("columns have one length");
        let errors = computed.iter().zip(&exact).map(|(&computed, &exact)| units(computed, exact));
        let (row, error) = errors.enumerate().max_by(|a, b| a.1.total_cmp(&b.1)).expect("there are rows");
        (instructions.name(), error, at(row))
    };
    Instructions::available().into_iter().map(of).collect()
}

fn report<F: Formula<A, 1>, const A: usize>(name: &str, columns: &[Vec<f64>; A]) -> bool {
    let worst = worst::<F, A>(columns);
    for (instructions, error, place) in &worst {
        println!("{name:10} {instructions:9} {error:.3} at {place:?}");
    }
    worst.iter().all(|(_, error, _)| *error <= limit(name))
}

fn between<F: Formula<1, 1>>(name: &str, low: f64, high: f64) -> bool {
    report::<F, 1>(name, &[arguments(low, high, cases(), 1)])
}

#[test]
fn elementary_functions_are_accurate() {
    let results = [
        between::<Exp>("exp", -746.0, 708.0),
        between::<ExpM1>("exp_m1", -745.0, 708.0),
        between::<Ln>("ln", 5e-324, 1.7e308),
        between::<Ln1p>("ln_1p", -0.999_999_999_999_999_9, 1.7e308),
        between::<Sin>("sin", -REACH, REACH),
        between::<Cos>("cos", -REACH, REACH),
        between::<Tan>("tan", -REACH, REACH),
        between::<Asin>("asin", -1.0, 1.0),
        between::<Acos>("acos", -1.0, 1.0),
        between::<Atan>("atan", -1.7e308, 1.7e308),
        between::<Sinh>("sinh", -710.4, 710.4),
        between::<Cosh>("cosh", -710.4, 710.4),
        between::<Tanh>("tanh", -400.0, 400.0),
        between::<Erf>("erf", -7.0, 7.0),
        between::<Erfc>("erfc", -7.0, 26.0),
    ];
    assert!(results.iter().all(|within| *within), "a function is not accurate; see the output");
}

#[test]
fn powers_are_accurate() {
    let results = [
        between::<Power<2, 1>>("2", 1e-150, 1e150),
        between::<Power<3, 1>>("3", 1e-100, 1e100),
        between::<Power<7, 1>>("7", 1e-30, 1e30),
        between::<Power<-2, 1>>("-2", 1e-150, 1e150),
        between::<Power<-5, 1>>("-5", 1e-50, 1e50),
        between::<Power<-1, 2>>("-1/2", 1e-300, 1e300),
        between::<Power<3, 2>>("3/2", 1e-200, 1e200),
        between::<Power<-3, 2>>("-3/2", 1e-200, 1e200),
        between::<Power<1, 3>>("1/3", 1e-300, 1e300),
        between::<Power<-2, 3>>("-2/3", 1e-300, 1e300),
        between::<Cbrt>("cbrt", -1e300, 1e300),
        between::<Power<5, 12>>("5/12", 1e-300, 1e300),
        between::<Power<-11, 5>>("-11/5", 1e-100, 1e100),
    ];
    assert!(results.iter().all(|within| *within), "a power is not accurate; see the output");
}

/// Angle of the point (x, y).
struct Angle;
impl Formula<2, 1> for Angle {
    #[inline(always)]
    fn value<T: Real>([y, x]: [T; 2]) -> [T; 1] {
        [y.atan2(x)]
    }
}

#[test]
fn the_angle_of_a_point_is_accurate() {
    let mut draw = Draw(2);
    let (mut heights, mut widths) = (Vec::new(), Vec::new());
    for x in arguments(-1e300, 1e300, 2 * cases(), 3) {
        let near = x * draw.between(-3.0, 3.0);
        let far = draw.of_any_binade(-1e300, 1e300);
        for y in [near, far].into_iter().filter(|y| y.is_finite() && *y != 0.0 && x != 0.0) {
            heights.push(y);
            widths.push(x);
        }
    }
    assert!(report::<Angle, 2>("atan2", &[heights, widths]));
}
