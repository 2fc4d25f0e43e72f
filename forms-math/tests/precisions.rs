//! `f64`, `DoubleDouble` and `Wide` compared with astro-float, on arguments from all binades.

use astro_float::{BigFloat, Consts, RoundingMode};
use forms_math::{DoubleDouble, Real, Scalar, Wide};
use proptest::prelude::*;

const ROUNDING: RoundingMode = RoundingMode::ToEven;
/// Precision of the reference values, in bits.
const PRECISION: usize = 896;

/// Type of the comparison: more than 512 bits, and fewer than the reference.
type Truth = Wide<16>;

fn exactly(x: f64) -> BigFloat {
    BigFloat::from_f64(x, PRECISION)
}

/// Converts a reference value from its words.
fn truth(value: &BigFloat) -> Truth {
    let Some((words, _, sign, exponent, _)) = value.as_raw_parts() else { return Truth::nan() };
    let mut sum = Truth::from_f64(0.0);
    for (place, &word) in words.iter().rev().enumerate() {
        for (half, part) in [word >> 32, word & 0xffff_ffff].into_iter().enumerate() {
            let position = i64::from(exponent) - 64 * place as i64 - 32 * (half as i64 + 1);
            sum = sum + Truth::from_f64(part as f64).scaled(position);
        }
    }
    if sign == astro_float::Sign::Neg { -sum } else { sum }
}

/// Returns the relative error in units of 2^−bits.
fn units(value: Truth, exact: Truth, bits: i64) -> f64 {
    if value == exact { 0.0 } else { ((value - exact) / exact).abs().scaled(bits).to_f64() }
}

/// Function of the reference, the same function of this crate for all number types, and its range
/// of arguments.
struct Function {
    name: &'static str,
    reference: fn(&BigFloat, &mut Consts) -> BigFloat,
    numbers: [fn(f64) -> Truth; 4],
    /// Range of the arguments' exponents of 2.
    exponents: (i32, i32),
    negative: bool,
}

const NUMBERS: [(&str, i64, f64); 4] =
    [("f64", 53, 4.0), ("DoubleDouble", 106, 16.0), ("Wide<4>", 248, 2.0), ("Wide<8>", 504, 2.0)];

fn of_double_double(value: DoubleDouble) -> Truth {
    Truth::from_f64(value.high()) + Truth::from_f64(value.low())
}

macro_rules! function {
    ($name:ident, $exponents:expr, $negative:expr) => {
        function!($name, $exponents, $negative, |x, constants| x.$name(PRECISION, ROUNDING, constants))
    };
    ($name:ident, $exponents:expr, $negative:expr, |$x:ident, $constants:ident| $reference:expr) => {
        Function {
            name: stringify!($name),
            reference: |$x: &BigFloat, $constants: &mut Consts| {
                let _ = &$constants;
                $reference
            },
            numbers: [
                |x| Truth::from_f64(Real::$name(x)),
                |x| of_double_double(DoubleDouble::from_f64(x).$name()),
                |x| Wide::<4>::from_f64(x).$name().to_limbs(),
                |x| Wide::<8>::from_f64(x).$name().to_limbs(),
            ],
            exponents: $exponents,
            negative: $negative,
        }
    };
}

fn functions() -> Vec<Function> {
    vec![
        function!(sqrt, (-1022, 1023), false, |x, constants| x.sqrt(PRECISION, ROUNDING)),
        function!(exp, (-200, 8), true),
        function!(ln, (-1022, 1023), false),
        function!(sin, (-200, 1023), true),
        function!(cos, (-200, 1023), true),
        function!(tan, (-200, 1023), true),
        function!(asin, (-200, -1), true),
        function!(acos, (-200, -1), true),
        function!(atan, (-200, 1023), true),
        function!(sinh, (-200, 8), true),
        function!(cosh, (-200, 8), true),
        function!(tanh, (-200, 5), true),
        function!(exp_m1, (-200, 8), true, |x, constants| {
            let bits = PRECISION + 256;
            x.exp(bits, ROUNDING, constants).sub(&exactly(1.0), bits, ROUNDING)
        }),
        function!(ln_1p, (-200, 1023), false, |x, constants| {
            let bits = PRECISION + 256;
            exactly(1.0).add(x, 2048, ROUNDING).ln(bits, ROUNDING, constants)
        }),
    ]
}

/// Returns ± (1 + fraction) 2^exponent, with the exponent at a relative place between the ends.
fn argument(function: &Function, place: f64, fraction: f64, negative: bool) -> f64 {
    let (least, most) = function.exponents;
    let exponent = least + (place * f64::from(most - least)) as i32;
    let size = (1.0 + fraction) * 2.0_f64.powi(exponent / 2) * 2.0_f64.powi(exponent - exponent / 2);
    if negative && function.negative { -size } else { size }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn functions_agree_with_another_implementation(
        place in 0.0..1.0_f64,
        fraction in 0.0..1.0_f64,
        negative in prop::bool::ANY,
    ) {
        let mut constants = Consts::new().expect("the constants of the reference are allocated");
        for function in functions() {
            let x = argument(&function, place, fraction, negative);
            let exact = truth(&(function.reference)(&exactly(x), &mut constants));
            let exponent = exact.exponent().unwrap_or(0);
            for ((name, bits, most), number) in NUMBERS.into_iter().zip(function.numbers) {
                // Near the ends of the range of f64, rounding is not relative.
                let out_of_range = match bits {
                    53 => exponent < -1021,
                    106 => exponent.abs() > 900 || x.abs().log2().abs() > 900.0,
                    _ => false,
                };
                if out_of_range {
                    continue;
                }
                let error = units(number(x), exact, bits);
                prop_assert!(error <= most, "{name}: {} {x:e} is off by {error} units", function.name);
            }
        }
    }

    #[test]
    fn arithmetic_rounds_to_nearest(
        a in prop::num::f64::NORMAL,
        b in prop::num::f64::NORMAL,
        c in prop::num::f64::NORMAL,
        shift in -300..300_i64,
    ) {
        // Operands with all of their bits in use: quotients.
        let operands = |value: f64| {
            (Wide::<4>::from_f64(value) / Wide::from_f64(c)).scaled(shift)
        };
        let (x, y) = (operands(a), Wide::<4>::from_f64(b) / Wide::from_f64(3.0));
        let big = |value: Wide<4>| value.to_limbs::<16>();
        for (name, value, exact) in [
            ("+", x + y, big(x) + big(y)),
            ("-", x - y, big(x) - big(y)),
            ("*", x * y, big(x) * big(y)),
            ("/", x / y, big(x) / big(y)),
            ("sqrt", x.abs().sqrt(), big(x.abs()).sqrt()),
        ] {
            let error = units(value.to_limbs(), exact, 256);
            prop_assert!(error <= if name == "sqrt" { 3.0 } else { 1.0 }, "{name}: {error}");
        }
        prop_assert_eq!(x.partial_cmp(&y), (big(x) - big(y)).partial_cmp(&Truth::from_f64(0.0)));
    }

    #[test]
    fn arithmetic_of_doubles_is_that_of_the_reference(a in prop::num::f64::NORMAL, b in prop::num::f64::NORMAL) {
        let (x, y) = (Wide::<8>::from_f64(a), Wide::<8>::from_f64(b));
        let (big_x, big_y) = (exactly(a), exactly(b));
        for (name, value, exact) in [
            ("+", x + y, big_x.add(&big_y, 2304, ROUNDING)),
            ("*", x * y, big_x.mul(&big_y, PRECISION, ROUNDING)),
            ("/", x / y, big_x.div(&big_y, PRECISION, ROUNDING)),
        ] {
            let error = units(value.to_limbs(), truth(&exact), 512);
            prop_assert!(error <= 1.0, "{name}: {a:e}, {b:e} is off by {error} units");
        }
        prop_assert_eq!((x * y / y).to_f64(), a);
    }

    #[test]
    fn powers_are_those_of_roots(
        a in (-22.0..22.0_f64).prop_map(f64::exp2),
        numerator in -40..40_i64,
        denominator in 1..12_i64,
    ) {
        let exact = Truth::from_f64(a).power(numerator, denominator);
        let back = exact.power(denominator, 1);
        prop_assert!(units(back, Truth::from_f64(a).power(numerator, 1), 1000) <= 1.0);
        let double = DoubleDouble::from_f64(a).power(numerator, denominator);
        prop_assert!(units(of_double_double(double), exact, 106) <= 16.0 * (numerator.abs() + 1) as f64);
        prop_assert!(units(Truth::from_f64(Real::power(a, numerator, denominator)), exact, 53) <= 3.0);
    }

    #[test]
    fn printed_digits_are_read_back(a in prop::num::f64::NORMAL, b in prop::num::f64::NORMAL) {
        prop_assert_eq!(Wide::<4>::from_f64(a).to_string().parse::<f64>(), Ok(a));
        prop_assert_eq!(DoubleDouble::new(a, 0.0).to_string().parse::<f64>(), Ok(a));
        let sum = DoubleDouble::new(a, b);
        let digits: f64 = sum.to_string().parse().expect("a decimal number");
        prop_assert!((digits - sum.high()).abs() <= sum.high().abs() * f64::EPSILON);
    }
}

#[test]
fn what_is_printed() {
    assert_eq!(DoubleDouble::new(0.1, 0.0).to_string(), "1.00000000000000005551115123125782702e-1");
    assert_eq!(Wide::<2>::from_f64(-1024.0).to_string(), "-1.024e3");
    assert_eq!(Wide::<2>::from_f64(f64::NAN).to_string(), "NaN");
    assert_eq!(Wide::<4>::pi().to_string(), "3.14159265358979323846264338327950288e0");
    assert_eq!(Wide::<4>::euler_gamma().to_string(), "5.77215664901532860606512090082402431e-1");
    assert_eq!(Wide::<2>::from_f64(1.0).scaled(1 << 40).to_string(), "0.5 * 2^1099511627777");
}

#[test]
fn the_ends_of_the_range() {
    let wide = Wide::<4>::from_f64;
    assert_eq!(wide(1e300).exp().to_f64(), f64::INFINITY);
    assert_eq!(wide(-1e300).exp().to_f64(), 0.0);
    let far = wide(1e14).exp();
    assert!((far.ln() - wide(1e14)).abs().to_f64() < 1e-50);
    assert_eq!((far * far / far - far).to_f64(), 0.0);
    assert_eq!(wide(f64::MAX).to_f64(), f64::MAX);
    assert_eq!(wide(5e-324).to_f64(), 5e-324);
    assert_eq!((wide(5e-324) / wide(2.0)).to_f64(), 0.0);
    // Ties go to the even neighbour.
    let root = 5e-324_f64.sqrt();
    for (factor, rounded) in [(0.5, 0.0), (0.75, 5e-324), (1.25, 5e-324), (1.5, 1e-323), (2.5, 1e-323)] {
        assert_eq!((wide(factor * root) * wide(root)).to_f64(), rounded);
    }
    for undefined in
        [wide(-1.0).sqrt(), wide(-1.0).ln(), wide(2.0).asin(), wide(f64::INFINITY) - wide(f64::INFINITY)]
    {
        assert!(undefined.to_f64().is_nan());
    }
    // A double-double that is closer to a multiple of π than an f64 can be.
    let near = DoubleDouble::pi();
    let exact = Wide::<8>::from_f64(near.high()) + Wide::from_f64(near.low());
    let (sine, truth) = (near.sin(), exact.sin());
    assert!(((of_double_double(sine) - truth.to_limbs()) / truth.to_limbs()).abs().to_f64() < 1e-30);
}
