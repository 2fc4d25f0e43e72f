//! The functions of `Lane64` against values of 60 digits: at most 2 units in the last place, with fused multiply-add and
//! without. `FORMS_MATH_CASES` sets how many arguments each function gets.

use crate::arguments::{Draw, arguments};
use crate::reference::{Reference, units};
use astro_float::BigFloat;
use forms_math::{Lane64, Real};

/// What is allowed.
const LIMIT: f64 = 2.0;

pub fn cases() -> usize {
    std::env::var("FORMS_MATH_CASES").ok().and_then(|count| count.parse().ok()).unwrap_or(2000)
}

fn error(computed: f64, exact: &BigFloat) -> f64 {
    units(computed, exact, 53, -1021)
}

/// A function of one argument, as lanes without and with fused multiply-add compute it, and its exact value.
struct Function {
    name: &'static str,
    from: f64,
    to: f64,
    lanes: [fn(f64) -> f64; 2],
    exact: fn(&mut Reference, f64) -> BigFloat,
}

impl Function {
    /// The largest errors, and where they are.
    fn worst(&self, reference: &mut Reference) -> [(f64, f64); 2] {
        let mut worst = [(0.0, f64::NAN); 2];
        for x in arguments(self.from, self.to, cases(), 1) {
            let exact = (self.exact)(reference, x);
            for (worst, lane) in worst.iter_mut().zip(self.lanes) {
                let error = error(lane(x), &exact);
                if error > worst.0 {
                    *worst = (error, x);
                }
            }
        }
        worst
    }
}

macro_rules! functions {
    ($($name:ident $from:expr, $to:expr;)*) => { [$(
        Function {
            name: stringify!($name),
            from: $from,
            to: $to,
            lanes: [|x| Lane64::<false>(x).$name().to_f64(), |x| Lane64::<true>(x).$name().to_f64()],
            exact: Reference::$name,
        },
    )*] };
}

macro_rules! powers {
    ($($numerator:literal / $denominator:literal $from:expr, $to:expr;)*) => { [$(
        Function {
            name: concat!("power ", stringify!($numerator / $denominator)),
            from: $from,
            to: $to,
            lanes: [
                |x| Lane64::<false>(x).power($numerator, $denominator).to_f64(),
                |x| Lane64::<true>(x).power($numerator, $denominator).to_f64(),
            ],
            exact: |reference, x| reference.power(x, $numerator, $denominator),
        },
    )*] };
}

fn assert_accurate(functions: &[Function]) {
    let mut reference = Reference::new();
    let mut failures = Vec::new();
    for function in functions {
        let worst = function.worst(&mut reference);
        for ((error, place), how) in worst.into_iter().zip(["separate", "fused"]) {
            println!("{:14} {how:9} {error:.3} at {place:e}", function.name);
            if error > LIMIT {
                failures.push(format!("{} ({how}): {error:.3} at {place:e}", function.name));
            }
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

/// The largest angle that lanes reach.
const REACH: f64 = 1_647_000.0;

#[test]
fn elementary_functions_are_accurate() {
    assert_accurate(&functions! {
        exp -745.1, 709.78;
        exp_m1 -745.0, 709.78;
        ln 5e-324, 1.7e308;
        ln_1p -0.999_999_999_999_999_9, 1.7e308;
        sin -REACH, REACH;
        cos -REACH, REACH;
        tan -REACH, REACH;
        asin -1.0, 1.0;
        acos -1.0, 1.0;
        atan -1.7e308, 1.7e308;
        sinh -710.4, 710.4;
        cosh -710.4, 710.4;
        tanh -400.0, 400.0;
        erf -7.0, 7.0;
    });
}

#[test]
fn powers_are_accurate() {
    assert_accurate(&powers! {
        2 / 1 1e-150, 1e150;
        3 / 1 1e-100, 1e100;
        4 / 1 1e-60, 1e60;
        7 / 1 1e-30, 1e30;
        -2 / 1 1e-100, 1e100;
        -3 / 1 1e-80, 1e80;
        -5 / 1 1e-50, 1e50;
        1 / 2 1e-300, 1e300;
        -1 / 2 1e-300, 1e300;
        3 / 2 1e-150, 1e150;
        -3 / 2 1e-150, 1e150;
        5 / 2 1e-100, 1e100;
        1 / 3 1e-250, 1e250;
        -2 / 3 1e-250, 1e250;
        4 / 3 1e-200, 1e200;
        1 / 4 1e-250, 1e250;
        5 / 12 1e-250, 1e250;
        -22 / 10 1e-100, 1e100;
        31 / 5 1e-40, 1e40;
    });
}

#[test]
fn the_angle_of_a_point_is_accurate() {
    let mut reference = Reference::new();
    let mut draw = Draw(2);
    let mut worst = [(0.0, 0.0, 0.0); 2];
    let places = arguments(-1.7e308, 1.7e308, cases(), 3);
    for x in places {
        let close = x * draw.between(-3.0, 3.0);
        let any = draw.of_any_binade(-1.7e308, 1.7e308);
        for y in [close, any].into_iter().filter(|y| y.is_finite() && *y != 0.0 && x != 0.0) {
            let exact = reference.atan2(y, x);
            let lanes = [Lane64::<false>(y).atan2(Lane64(x)).0, Lane64::<true>(y).atan2(Lane64(x)).0];
            for (worst, lane) in worst.iter_mut().zip(lanes) {
                let error = error(lane, &exact);
                if error > worst.0 {
                    *worst = (error, y, x);
                }
            }
        }
    }
    println!("atan2 (error, y, x) separate and fused: {worst:?}");
    assert!(worst.iter().all(|(error, _, _)| *error <= LIMIT), "{worst:?}");
}
