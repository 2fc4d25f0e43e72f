//! `f32` and `f64` as numbers of a kernel.

use forms_math::{DoubleDouble, Real};
use std::f64::consts::{LN_2, PI};

fn ulps(value: f64, truth: f64) -> f64 {
    ((value - truth) / (truth.abs() * f64::EPSILON)).abs()
}

#[test]
fn well_known_values_of_the_special_functions() {
    let catalan = 0.915_965_594_177_219;
    for (name, value, truth) in [
        ("erf 1", Real::erf(1.0_f64), 0.842_700_792_949_714_9),
        ("E1 1", 1.0_f64.expint1(), 0.219_383_934_395_520_27),
        ("E1 10", 10.0_f64.expint1(), 4.156_968_929_685_324e-6),
        ("E2 0", 0.0_f64.expint2(), 1.0),
        ("E3 0", 0.0_f64.expint3(), 0.5),
        ("Li2 1", 1.0_f64.dilog(), PI * PI / 6.0),
        ("Li2 -1", (-1.0_f64).dilog(), -PI * PI / 12.0),
        ("Li2 1/2", 0.5_f64.dilog(), PI * PI / 12.0 - LN_2 * LN_2 / 2.0),
        ("Cl2 pi/2", (PI / 2.0).clausen(), catalan),
        ("Cl2 pi/3", (PI / 3.0).clausen(), 1.014_941_606_409_653_6),
    ] {
        assert!(ulps(value, truth) < 4.0, "{name}: {value:e} is not {truth:e}");
    }
}

#[test]
fn integrals_with_closed_forms() {
    for (name, value, truth) in [
        ("exp", f64::quadrature(0.0, 1.0, |t| t.exp()), 1.0_f64.exp_m1()),
        ("root", f64::quadrature(0.0, 2.0, |t| t.sqrt()), 2.0 / 3.0 * 8.0_f64.sqrt()),
        ("pole of order 1/2", f64::quadrature(0.0, 1.0, |t| 1.0 / t.sqrt()), 2.0),
        ("log", f64::quadrature(0.0, 1.0, |t| -t.ln()), 1.0),
        ("Lorentz", f64::quadrature(-1.0, 1.0, |t| 1e-3 / (t * t + 1e-6)), 2.0 * 1e3_f64.atan()),
        ("backwards", f64::quadrature(1.0, 0.0, |t| t * t), -1.0 / 3.0),
        ("oscillating", f64::quadrature(0.0, 30.0, |t| t.cos()), 30.0_f64.sin()),
    ] {
        assert!((value - truth).abs() < 64.0 * f64::EPSILON, "{name}: {value:e} is not {truth:e}");
    }
    assert_eq!(f64::quadrature(0.5, 0.5, |t| t), 0.0);
    assert!(f64::quadrature(0.0, 1.0, |_| f64::NAN).is_nan());
    assert!((f32::quadrature(0.0, 1.0, |t: f32| t.exp()) - 1.0_f32.exp_m1()).abs() < 2e-7);
}

#[test]
fn differences_of_products_hold_at_the_ends_of_the_range() {
    let third = 1.0 / 3.0;
    for exponent in [0, -490, 490, -500, 510] {
        let scale = 2.0_f64.powi(exponent);
        let (a, b) = (third * scale, (1.0 + f64::EPSILON) * scale);
        // (s/3)(s + sε) − s (s/3) = s²ε/3
        let value = f64::difference_of_products(a, b, scale, a);
        assert!(
            ulps(value, third * scale * f64::EPSILON * scale) < 4.0 || value.abs() < f64::MIN_POSITIVE,
            "{exponent}: {value:e}"
        );
    }
    assert_eq!(f64::difference_of_products(1e300, 1e300, 1e300, 1e300), 0.0);
}

/// The largest error of erf in units of 2⁻⁵³: at numbers of all sizes, and densely where polynomials
/// meet and where it becomes 1.
#[test]
fn erf_is_accurate_to_two_units_everywhere() {
    let sizes = (-700..12).flat_map(|half| {
        (0..40).map(move |step| (f64::from(half) / 2.0).exp2() * (1.0 + f64::from(step) / 96.0))
    });
    let near = [0.999_999, 1.0, 1.000_001, 2.5, 5.86, 5.92, 6.0, 6.5];
    let close = near.iter().flat_map(|&x| (-20..20).map(move |step| x * (1.0 + f64::from(step) * 1e-7)));
    let inside = (1..20_000).map(|step| f64::from(step) / 3_000.0);
    let mut worst: f64 = 0.0;
    for x in sizes.chain(close).chain(inside) {
        let truth = DoubleDouble::from_f64(x).erf();
        let off = ((DoubleDouble::from_f64(Real::erf(x)) - truth) / truth).to_f64().abs() / 2.0_f64.powi(-53);
        worst = worst.max(off);
        assert!(off <= 2.0, "{x:e}: {off}");
        assert_eq!(Real::erf(-x), -Real::erf(x), "{x:e}");
        let x = x as f32;
        let far = (f64::from(Real::erf(x)) - Real::erf(f64::from(x))).abs();
        assert!(!x.is_normal() || far <= 1.13 * f64::from(x.min(1.0)) * 2.0_f64.powi(-24), "{x:e}: {far}");
    }
    println!("erf: {worst:.2} units");
    assert!(Real::erf(f64::NAN).is_nan());
    assert_eq!([Real::erf(f64::INFINITY), Real::erf(-0.0), Real::erf(5e-324)], [1.0, -0.0, 5e-324]);
}

/// The largest error of erfc in units of 2⁻⁵³, where its value is a normal number.
#[test]
fn erfc_is_accurate_to_six_units_everywhere() {
    let inside = (0..30_000).map(|step| f64::from(step) / 1_132.0);
    let near = (-40..40).map(|step| 0.5 + f64::from(step) * 1e-7);
    let sizes = (-120..0).map(|half| (f64::from(half) / 2.0).exp2());
    let mut worst: f64 = 0.0;
    for x in inside.chain(near).chain(sizes) {
        for x in [x, -x] {
            let truth = DoubleDouble::from_f64(x).erfc();
            let off =
                ((DoubleDouble::from_f64(Real::erfc(x)) - truth) / truth).to_f64().abs() / 2.0_f64.powi(-53);
            worst = worst.max(off);
            assert!(off <= 6.0, "{x:e}: {off}");
        }
    }
    println!("erfc: {worst:.2} units");
}
