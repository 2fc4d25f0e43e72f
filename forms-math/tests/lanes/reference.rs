//! Functions to about 60 digits, by astro-float, and how far a number is from such a value.

use astro_float::{BigFloat, Consts, RoundingMode};

const PRECISION: usize = 256;
const ROUNDING: RoundingMode = RoundingMode::ToEven;

/// Evaluates functions; holds the constants that they need.
pub struct Reference {
    constants: Consts,
}

/// Below this magnitude functions near zero are computed by the first terms of their series: 2⁻⁸⁰.
const TINY: f64 = 8.3e-25;

/// The number as a reference value.
pub fn exactly(x: f64) -> BigFloat {
    BigFloat::from_f64(x, PRECISION)
}

fn sum(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.add(b, PRECISION, ROUNDING)
}

fn product(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.mul(b, PRECISION, ROUNDING)
}

fn ratio(a: &BigFloat, b: &BigFloat) -> BigFloat {
    a.div(b, PRECISION, ROUNDING)
}

/// Functions that astro-float has.
macro_rules! functions {
    ($($name:ident),*) => { $(
        pub fn $name(&mut self, x: f64) -> BigFloat {
            exactly(x).$name(PRECISION, ROUNDING, &mut self.constants)
        }
    )* };
}

impl Reference {
    pub fn new() -> Self {
        Self { constants: Consts::new().expect("the constants of the reference are allocated") }
    }

    functions!(exp, ln, sin, cos, tan, asin, acos, atan, sinh, cosh, tanh);

    /// x + c₂ x² + c₃ x³
    fn series(x: f64, second: f64, third: BigFloat) -> BigFloat {
        let x = exactly(x);
        let inner = sum(&exactly(second), &product(&third, &x));
        product(&x, &sum(&exactly(1.0), &product(&inner, &x)))
    }

    pub fn exp_m1(&mut self, x: f64) -> BigFloat {
        if x.abs() < TINY {
            return Self::series(x, 0.5, ratio(&exactly(1.0), &exactly(6.0)));
        }
        self.exp(x).sub(&exactly(1.0), PRECISION, ROUNDING)
    }

    pub fn ln_1p(&mut self, x: f64) -> BigFloat {
        if x.abs() < TINY {
            return Self::series(x, -0.5, ratio(&exactly(1.0), &exactly(3.0)));
        }
        sum(&exactly(1.0), &exactly(x)).ln(PRECISION, ROUNDING, &mut self.constants)
    }

    pub fn atan2(&mut self, y: f64, x: f64) -> BigFloat {
        let pi = self.constants.pi(PRECISION, ROUNDING);
        let of = |numerator: f64, denominator: f64, constants: &mut Consts| {
            ratio(&exactly(numerator), &exactly(denominator)).atan(PRECISION, ROUNDING, constants)
        };
        let straight = if y.is_sign_negative() { pi.neg() } else { pi };
        if y.abs() > x.abs() {
            let right = ratio(&straight, &exactly(2.0));
            return right.sub(&of(x, y, &mut self.constants), PRECISION, ROUNDING);
        }
        let angle = of(y, x, &mut self.constants);
        if x < 0.0 { sum(&angle, &straight) } else { angle }
    }

    /// x^(numerator/denominator)
    pub fn power(&mut self, x: f64, numerator: i64, denominator: i64) -> BigFloat {
        let exponent = ratio(&exactly(numerator as f64), &exactly(denominator as f64));
        exactly(x).pow(&exponent, PRECISION, ROUNDING, &mut self.constants)
    }

    /// 2/√π e^(−x²) Σ 2ⁿ x^(2n+1)/(2n+1)!!, all of whose terms have the sign of x.
    pub fn erf(&mut self, x: f64) -> BigFloat {
        let square = product(&exactly(x), &exactly(x));
        let (mut term, mut total) = (exactly(x), exactly(x));
        for n in 1..400 {
            term = product(&term, &ratio(&product(&exactly(2.0), &square), &exactly(f64::from(2 * n + 1))));
            total = sum(&total, &term);
        }
        let pi = self.constants.pi(PRECISION, ROUNDING);
        let slope = ratio(&exactly(2.0), &pi.sqrt(PRECISION, ROUNDING));
        let decay = square.neg().exp(PRECISION, ROUNDING, &mut self.constants);
        product(&product(&slope, &decay), &total)
    }
}

/// The number to within 2⁻⁵² of itself.
fn leading(x: &BigFloat) -> f64 {
    let Some((words, _, _, exponent, _)) = x.as_raw_parts() else { return f64::NAN };
    let top = *words.last().expect("a number has words") as f64 / 18_446_744_073_709_551_616.0;
    let magnitude =
        top * 2f64.powi(exponent.clamp(-1000, 1000) / 2) * 2f64.powi((exponent + 1).clamp(-1000, 1000) / 2);
    if x.is_negative() { -magnitude } else { magnitude }
}

/// The distance of `computed` from `exact`, in units of the last place that a format of so many bits, with the
/// exponents from `least` on, has at the exact value.
pub fn units(computed: f64, exact: &BigFloat, bits: i32, least: i32) -> f64 {
    if exact.is_zero() || exact.is_nan() {
        return if exact.is_zero() && computed == 0.0 { 0.0 } else { f64::INFINITY };
    }
    if !computed.is_finite() {
        return f64::INFINITY;
    }
    let exponent = exact.exponent().expect("the value is finite").max(least);
    let mut difference = exactly(computed).sub(exact, PRECISION, ROUNDING);
    if difference.is_zero() {
        return 0.0;
    }
    let own = difference.exponent().expect("the difference is finite");
    difference.set_exponent(own - exponent + bits);
    leading(&difference).abs()
}
