//! Special functions and integrals, compared with their definitions as integrals and with
//! identities.

use forms_math::{DoubleDouble, Guarded, Real, Scalar, Wide};
use proptest::prelude::*;

/// Returns |a − b| in units of 2^−bits of b.
fn units<T: Scalar>(value: T, exact: T, bits: i64) -> f64 {
    if value == exact { 0.0 } else { ((value - exact) / exact).abs().scaled(bits).to_f64() }
}

fn number<T: Real>(value: f64) -> T {
    T::from_f64(value)
}

/// Returns every special function with its defining integral, for 0.1 < x < 1; e^(−x/t) needs no
/// special treatment at 0.
fn definitions<T: Scalar>(x: T) -> [(&'static str, T, T); 7] {
    let (zero, one) = (number::<T>(0.0), number::<T>(1.0));
    let decay = |order: i64| T::quadrature(zero, one, |t| (-(x / t)).exp() * t.power(order - 2, 1));
    [
        ("erf", x.erf(), number::<T>(2.0) / T::pi().sqrt() * T::quadrature(zero, x, |t| (-(t * t)).exp())),
        (
            "erfc",
            x.erfc(),
            one - number::<T>(2.0) / T::pi().sqrt() * T::quadrature(zero, x, |t| (-(t * t)).exp()),
        ),
        ("E1", x.expint1(), decay(1)),
        ("E2", x.expint2(), decay(2)),
        ("E3", x.expint3(), decay(3)),
        ("Li2", x.dilog(), -T::quadrature(zero, x, |t| (-t).ln_1p() / t)),
        ("Cl2", x.clausen(), -T::quadrature(zero, x, |t| (number::<T>(2.0) * (t.scaled(-1)).sin()).ln())),
    ]
}

#[test]
fn special_functions_are_their_integrals() {
    for x in [0.125, 0.4, 0.7, 0.99] {
        for (name, value, integral) in definitions(DoubleDouble::from_f64(x)) {
            assert!(units(value, integral, 106) < 512.0, "{name} {x}: {value} is not {integral}");
        }
    }
    for (name, value, integral) in definitions(Wide::<4>::from_f64(0.4)) {
        assert!(units(value, integral, 248) < 64.0, "{name}: {value} is not {integral}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn precisions_agree(exponent in -60.0..7.0_f64, negative in prop::bool::ANY) {
        let x = if negative { -exponent.exp2() } else { exponent.exp2() };
        for (name, double, double_double, four, eight) in [
            ("erf", Real::erf(x), DoubleDouble::from_f64(x).erf(), Wide::<4>::from_f64(x).erf(), Wide::<8>::from_f64(x).erf()),
            ("erfc", Real::erfc(x), DoubleDouble::from_f64(x).erfc(), Wide::<4>::from_f64(x).erfc(), Wide::<8>::from_f64(x).erfc()),
            ("E1", x.expint1(), DoubleDouble::from_f64(x).expint1(), Wide::<4>::from_f64(x).expint1(), Wide::<8>::from_f64(x).expint1()),
            ("E2", x.expint2(), DoubleDouble::from_f64(x).expint2(), Wide::<4>::from_f64(x).expint2(), Wide::<8>::from_f64(x).expint2()),
            ("E3", x.expint3(), DoubleDouble::from_f64(x).expint3(), Wide::<4>::from_f64(x).expint3(), Wide::<8>::from_f64(x).expint3()),
            ("Li2", x.dilog(), DoubleDouble::from_f64(x).dilog(), Wide::<4>::from_f64(x).dilog(), Wide::<8>::from_f64(x).dilog()),
            ("Cl2", x.clausen(), DoubleDouble::from_f64(x).clausen(), Wide::<4>::from_f64(x).clausen(), Wide::<8>::from_f64(x).clausen()),
        ] {
            if eight.to_f64().is_nan() {
                prop_assert!(double.is_nan() && double_double.to_f64().is_nan() && four.to_f64().is_nan(), "{name} {x:e}");
                continue;
            }
            // beyond, the value underflows in f64
            if name == "erfc" && eight.to_f64() < 1e-260 {
                continue;
            }
            let words = Wide::from_f64(double_double.high()) + Wide::from_f64(double_double.low());
            let most = match name {
                "erf" => 2.0,
                "erfc" => 5.0,
                _ => 1.01,
            };
            prop_assert!(units(Wide::from_f64(double), eight, 53) <= most, "{name} {x:e}: {double:e}");
            prop_assert!(units(words, eight, 106) <= 128.0, "{name} {x:e}: {double_double}");
            prop_assert!(units(four.to_limbs(), eight, 248) <= 4.0, "{name} {x:e}: {four}");
        }
    }

    #[test]
    fn what_the_special_functions_satisfy(x in 0.01..0.99_f64) {
        let wide = Wide::<4>::from_f64;
        let (x, one, pi) = (wide(x), wide(1.0), Wide::<4>::pi());
        let close = |left: Wide<4>, right: Wide<4>| (left - right).abs().to_f64() < 1e-70;
        // Li₂(x) + Li₂(−x) = ½ Li₂(x²)
        prop_assert!(close(x.dilog() + (-x).dilog(), (x * x).dilog().scaled(-1)));
        // Li₂(x) + Li₂(x/(x − 1)) = −½ ln²(1 − x)
        prop_assert!(close(x.dilog() + (x / (x - one)).dilog(), -(-x).ln_1p().power(2, 1).scaled(-1)));
        // Cl₂(2x) = 2 Cl₂(x) − 2 Cl₂(π − x)
        prop_assert!(close(x.scaled(1).clausen(), (x.clausen() - (pi - x).clausen()).scaled(1)));
        // Cl₂(x + 2π) = Cl₂(x) = −Cl₂(−x)
        prop_assert!(close((x + pi.scaled(1)).clausen(), x.clausen()));
        prop_assert!(close((-x).clausen(), -x.clausen()));
    }
}

/// erfc x to 60 digits.
#[rustfmt::skip]
const ERFC: [(f64, &str); 6] = [
    (0.25, "7.23673609831763067014931732235184287934646022107688745917528e-1"),
    (1.0, "1.57299207050285130658779364917390740703933002033697091540062e-1"),
    (3.5, "7.43098372341412745523683756095635720660092172797462591109570e-7"),
    (10.0, "2.08848758376254475700078629495778861156081811932116372701221e-45"),
    (26.0, "5.66319240885614284647572789692609258032877756092580736864625e-296"),
    (-2.0, "1.99532226501895273416206925636725292861089179704006007673835e0"),
];

/// Returns the number with these digits, such as `1.25e-3`.
fn of_digits(text: &str) -> Wide<8> {
    let (digits, exponent) = text.split_once('e').expect("an exponent");
    let ten = Wide::from_f64(10.0);
    let digits: Vec<f64> = digits.chars().filter_map(|c| c.to_digit(10)).map(f64::from).collect();
    let exponent: i64 = exponent.parse().expect("an exponent");
    let integer =
        digits.iter().fold(Wide::from_f64(0.0), |number, &digit| number * ten + Wide::from_f64(digit));
    integer * ten.power(exponent - digits.len() as i64 + 1, 1)
}

#[test]
fn erf_and_erfc_of_two_words_are_accurate_everywhere() {
    let inside = (-130..520).map(|step| f64::from(step) / 20.0 + 1e-3);
    let sizes = (-140..0).map(|half| (f64::from(half) / 2.0).exp2());
    for x in inside.chain(sizes).chain([0.5, -0.5, 9.0]) {
        let (narrow, wide) = (DoubleDouble::from_f64(x), Wide::<4>::from_f64(x));
        for (name, value, exact) in [("erf", narrow.erf(), wide.erf()), ("erfc", narrow.erfc(), wide.erfc())]
        {
            let words = Wide::<4>::from_f64(value.high()) + Wide::from_f64(value.low());
            let relative = ((words - exact) / exact).to_f64().abs();
            // below 2⁻⁹⁰⁰ the second word loses digits
            let is_small = exact.to_f64() < 2.0_f64.powi(-900);
            assert!(is_small || relative <= 128.0 * 2.0_f64.powi(-106), "{name} {x:e}: {relative:e}");
        }
    }
    let [infinity, nan] = [f64::INFINITY, f64::NAN].map(DoubleDouble::from_f64);
    assert!(nan.erf().high().is_nan() && nan.erfc().high().is_nan());
    let values = [infinity.erf(), -infinity.erf(), infinity.erfc(), (-infinity).erfc()];
    assert_eq!(values.map(DoubleDouble::high), [1.0, -1.0, 0.0, 2.0]);
}

#[test]
fn erfc_has_its_digits_where_one_minus_erf_has_none() {
    for (x, digits) in ERFC {
        let exact = of_digits(digits);
        let double_double = DoubleDouble::from_f64(x).erfc();
        let words = Wide::from_f64(double_double.high()) + Wide::from_f64(double_double.low());
        assert!(units(Wide::<4>::from_f64(x).erfc().to_limbs(), exact, 196) <= 1.0, "Wide {x}");
        assert!(exact.to_f64() < 1e-290 || units(words, exact, 106) <= 128.0, "DoubleDouble {x}");
        assert!(units(Wide::from_f64(Real::erfc(x)), exact, 53) <= 5.0 || exact.to_f64() < 1e-290, "f64 {x}");
    }
    assert!(Real::erfc(f64::NAN).is_nan() && Real::erfc(f32::NAN).is_nan());
    assert_eq!([f64::INFINITY, f64::NEG_INFINITY, 0.0, 30.0].map(Real::erfc), [0.0, 2.0, 1.0, 0.0]);
}

#[test]
fn lengths_neither_overflow_nor_underflow() {
    for exponent in [-1060, -1022, -600, -537, -400, 0, 400, 500, 512, 600, 1020] {
        let scale = if exponent < -1000 {
            2.0_f64.powi(exponent + 60) * 2.0_f64.powi(-60)
        } else {
            2.0_f64.powi(exponent)
        };
        let (x, y) = (3.0 * scale, 4.0 * scale);
        let largest = f64::MAX / 4.0 < scale;
        assert!(largest || Real::hypot(x, y) == 5.0 * scale, "2^{exponent}: {:e}", Real::hypot(x, y));
        let length = DoubleDouble::from_f64(x).hypot(DoubleDouble::from_f64(-y));
        assert!(largest || exponent < -900 || length.to_f64() == 5.0 * scale, "2^{exponent}: {length}");
    }
    let infinity = f64::INFINITY;
    assert_eq!(
        [Real::hypot(infinity, 1.0), Real::hypot(-0.0, 0.0), Real::hypot(0.0, -5e-324)],
        [infinity, 0.0, 5e-324]
    );
    assert!(Real::hypot(f64::NAN, infinity).is_nan() && Real::hypot(f64::NAN, 0.0).is_nan());
}

#[test]
fn cube_roots_of_all_signs() {
    for (x, root) in [(27.0, 3.0), (-27.0, -3.0), (0.0, 0.0), (-0.125, -0.5), (1e-300, 1e-100)] {
        let values = [
            Real::cbrt(x),
            DoubleDouble::from_f64(x).cbrt().to_f64(),
            Wide::<4>::from_f64(x).cbrt().to_f64(),
        ];
        assert!(values.iter().all(|value| (value - root).abs() <= 2e-16 * root.abs()), "{x}: {values:?}");
    }
    assert!(Real::cbrt(f64::NAN).is_nan() && DoubleDouble::from_f64(f64::NAN).cbrt().to_f64().is_nan());
}

#[test]
fn integrals_in_more_precision() {
    let double = DoubleDouble::from_f64;
    for (value, exact) in [
        (DoubleDouble::quadrature(double(0.0), double(1.0), |t| t.sqrt()), double(2.0) / double(3.0)),
        (DoubleDouble::quadrature(double(0.0), double(1.0), |t| double(1.0) / t.sqrt()), double(2.0)),
        (DoubleDouble::quadrature(double(0.0), double(4.0), |t| t.exp()), double(4.0).exp_m1()),
        (
            DoubleDouble::quadrature(double(-1.0), double(1.0), |t| {
                double(1.0) / (t * t + double(1.0 / 4096.0))
            }),
            double(128.0) * double(64.0).atan(),
        ),
        // The series and the continued fraction of E₂ meet at 1.
        (
            DoubleDouble::quadrature(double(0.75), double(1.25), |t| t.expint2()),
            double(0.75).expint3() - double(1.25).expint3(),
        ),
    ] {
        assert!(units(value, exact, 106) < 4096.0, "{value} is not {exact}");
    }
    let wide = Wide::<4>::from_f64;
    let quarter_disk =
        Wide::<4>::quadrature(wide(0.0), wide(1.0), |t| ((wide(1.0) - t) * (wide(1.0) + t)).sqrt());
    assert!(units(quarter_disk, Wide::pi().scaled(-2), 248) < 64.0);
}

#[test]
fn a_guarded_integral_bounds_its_sum() {
    let number = Guarded::<f64>::from_f64;
    let integral = Guarded::quadrature(number(0.0), number(1.0), |t| (-(t * t)).exp());
    let exact = Wide::<4>::quadrature(Wide::from_f64(0.0), Wide::from_f64(1.0), |t| (-(t * t)).exp());
    let distance = (Wide::from_f64(integral.value()) - exact).abs().to_f64();
    assert!(distance <= integral.error() && integral.error() < 1e-13, "{integral:?}");
    assert!(Guarded::quadrature(number(-1.0), number(1.0), |t| t.sqrt()).is_undefined());
}
