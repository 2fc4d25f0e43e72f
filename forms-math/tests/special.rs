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
fn definitions<T: Scalar>(x: T) -> [(&'static str, T, T); 6] {
    let (zero, one) = (number::<T>(0.0), number::<T>(1.0));
    let decay = |order: i64| T::quadrature(zero, one, |t| (-(x / t)).exp() * t.power(order - 2, 1));
    [
        ("erf", x.erf(), number::<T>(2.0) / T::pi().sqrt() * T::quadrature(zero, x, |t| (-(t * t)).exp())),
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
            let words = Wide::from_f64(double_double.high()) + Wide::from_f64(double_double.low());
            let most = if name == "erf" { 2.0 } else { 1.01 };
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
