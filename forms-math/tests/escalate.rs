//! Escalation: promises are kept, with the least sufficient precision.

use forms_math::{
    Formula, Guarded, NotWithin, Number, Real, Tier, Wide, escalate, escalate_checked, escalate_f32,
    escalate_with_tier,
};
use proptest::prelude::*;

/// (1 − cos x)/x², √(1 + x²) − 1, and the product of the two.
struct Cancelling;

impl Formula<1, 3> for Cancelling {
    fn value<T: Real>([x]: [T; 1]) -> [T; 3] {
        let one = T::from_f64(1.0);
        let versine = (one - x.cos()) / (x * x);
        let excess = (one + x * x).sqrt() - one;
        [versine, excess, versine * excess]
    }
}

/// Area of a triangle with the sides a, b, c by Heron's formula as written; NaN if there is no such
/// triangle.
struct Heron;

impl Formula<3, 1> for Heron {
    fn value<T: Real>([a, b, c]: [T; 3]) -> [T; 1] {
        let half = (a + b + c) * T::from_f64(0.5);
        [(half * (half - a) * (half - b) * (half - c)).sqrt()]
    }
}

/// Step from 2 to 3 at 2, as a function of the square of the root of x.
struct Piecewise;

impl Formula<1, 1> for Piecewise {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        let root = x.sqrt();
        [T::if_less(root * root, T::from_f64(2.0), T::from_f64(2.0), T::from_f64(3.0))]
    }
}

fn exact<F: Formula<A, O>, const A: usize, const O: usize>(arguments: [f64; A]) -> [Wide<16>; O] {
    F::value(arguments.map(Guarded::<Wide<16>>::from_f64)).map(Guarded::value)
}

fn units(value: f64, exact: Wide<16>) -> f64 {
    let scale = exact.abs().to_f64().max(f64::MIN_POSITIVE);
    ((Wide::from_f64(value) - exact).abs() / Wide::from_f64(scale)).to_f64() * 2.0_f64.powi(53)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn promises_are_kept(exponent in -600.0..300.0_f64, within in 1.0..64.0_f64) {
        let x = exponent.exp2();
        let values = escalate::<Cancelling, 1, 3>([x], within);
        for (value, exact) in values.into_iter().zip(exact::<Cancelling, 1, 3>([x])) {
            // Wide<16> has the digits for x² > 2⁻⁹⁰⁰.
            if exponent > -450.0 {
                prop_assert!(units(value, exact) <= within * 1.000_001, "{x:e}: {value:e} is not {exact}");
            }
        }
    }

    #[test]
    fn needles_have_areas(a in 1.0..2.0_f64, exponent in -50..0_i32) {
        let c = a * 2.0_f64.powi(exponent);
        let sides = [a, a + 0.75 * c, c];
        let [value] = escalate::<Heron, 3, 1>(sides, 2.0);
        prop_assert!(units(value, exact::<Heron, 3, 1>(sides)[0]) <= 2.000_001);
    }

    #[test]
    fn arguments_are_never_a_panic(a in prop::num::f64::ANY, b in prop::num::f64::ANY, c in prop::num::f64::ANY) {
        let [value] = escalate::<Heron, 3, 1>([a, b, c], 4.0);
        if a.is_nan() || b.is_nan() || c.is_nan() {
            prop_assert!(value.is_nan());
        }
    }
}

#[test]
fn as_little_precision_as_it_takes() {
    let tiers = |x: f64| escalate_with_tier::<Cancelling, 1, 3>([x], 8.0).map(|(_, tier)| tier);
    assert_eq!(tiers(1.0), [Tier::Double; 3]);
    assert_eq!(tiers(1e-5)[0], Tier::DoubleDouble);
    assert_eq!(tiers(1e-12)[0], Tier::Words(4));
    assert_eq!(tiers(1e-40)[0], Tier::Words(8));
    assert_eq!(tiers(1e-100)[0], Tier::Words(16));
    assert_eq!(escalate::<Heron, 3, 1>([3.0, 4.0, 5.0], 1.0), [6.0]);
    assert_eq!(escalate_with_tier::<Heron, 3, 1>([3.0, 4.0, 5.0], 1.0)[0].1, Tier::Double);
}

/// Every precision runs out of digits for some of these arguments.
#[test]
fn promises_are_kept_where_digits_run_out() {
    for quarter in 0..400 {
        let x = 2.0_f64.powf(-0.25 * f64::from(quarter));
        let values = escalate::<Cancelling, 1, 3>([x], 1.5);
        for (value, exact) in values.into_iter().zip(exact::<Cancelling, 1, 3>([x])) {
            assert!(units(value, exact) <= 1.500_001, "{x:e}: {value:e} is not {exact}");
        }
    }
}

#[test]
fn outside_of_the_domain_at_once() {
    for arguments in [[1.0, 1.0, 3.0], [f64::NAN, 1.0, 1.0]] {
        let [(value, tier)] = escalate_with_tier::<Heron, 3, 1>(arguments, 8.0);
        assert!(value.is_nan());
        assert_eq!(tier, Tier::Double);
    }
}

#[test]
fn a_choice_on_a_tie_is_left_open() {
    assert_eq!(escalate_with_tier::<Piecewise, 1, 1>([1.5], 1.0), [(2.0, Tier::Double)]);
    // √2 is irrational: no precision decides whether its square is below 2.
    assert_eq!(escalate_with_tier::<Piecewise, 1, 1>([2.0], 1.0)[0].1, Tier::Undecided);
}

/// ln(1 + eˣ), 1/(eˣ − 1), tanh x by its exponentials, e^(−x).
struct Exponentials;

impl Formula<1, 4> for Exponentials {
    fn value<T: Real>([x]: [T; 1]) -> [T; 4] {
        let one = T::from_f64(1.0);
        let (up, down) = (x.exp(), (-x).exp());
        [(one + up).ln(), one / (up - one), (up - down) / (up + down), down]
    }
}

#[test]
fn what_overflows_on_the_way_does_not_matter() {
    let [softplus, planck, tangent, _] = escalate::<Exponentials, 1, 4>([800.0], 2.0);
    assert_eq!((softplus, tangent), (800.0, 1.0));
    assert!(
        (planck / (-400.0_f64).exp() / (-400.0_f64).exp() - 1.0).abs() < 1e-12 || planck == 0.0,
        "{planck:e}"
    );
    // Added to 1, e^−700 vanishes even in a thousand bits.
    let [softplus, ..] = escalate::<Exponentials, 1, 4>([-700.0], 2.0);
    assert!((softplus / (-700.0_f64).exp() - 1.0).abs() < 4.0 * f64::EPSILON);
    // Below half the least number.
    assert_eq!(escalate::<Exponentials, 1, 4>([-800.0], 2.0)[0], 0.0);
}

#[test]
fn beyond_all_exponents_sign_and_least_size_are_known() {
    let found = escalate_with_tier::<Exponentials, 1, 4>([1e300], 2.0);
    assert_eq!([found[1].0, found[3].0], [0.0, 0.0]);
    assert_eq!([found[1].1, found[3].1], [Tier::Words(4); 2]);
    // No exponent holds e^1e300, so that results that depend on its magnitude are unknown.
    assert_eq!([found[0].1, found[2].1], [Tier::Undecided; 2]);
    assert!(found[0].0.is_nan());
    assert_eq!(
        escalate_checked::<Exponentials, 1, 4>([1e300], 2.0),
        Err(NotWithin { output: 0, within: 2.0 })
    );
    let of_infinity = escalate::<Exponentials, 1, 4>([f64::INFINITY], 2.0);
    assert_eq!([of_infinity[1], of_infinity[3]], [0.0, 0.0]);
}

/// x/π − x/3, with the numbers in the form of kernels.
struct Shares;

impl Formula<1, 1> for Shares {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        let pi = Number::new([std::f64::consts::FRAC_1_PI, -1.967_867_667_518_248_6e-17], &[1], &[1], -1);
        let third = Number::new([1.0 / 3.0, 1.850_371_707_708_594e-17], &[1], &[3], 0);
        let one = T::from_f64(1.0);
        // Difference of the remainders of 1 + x/π and 1 + x/3, for x far below the digits of 1.
        let left = |number: Number<'_>| (one + x * T::number(number)) - one;
        [left(pi) - left(third)]
    }
}

#[test]
fn numbers_of_a_formula_have_as_many_digits_as_it_takes() {
    for x in [1.0, 1e-20, 1e-80, 1e-100, 1e-300] {
        let [value] = escalate::<Shares, 1, 1>([x], 2.0);
        let expected = x * -0.015_023_447_149_542_59;
        assert!((value / expected - 1.0).abs() < 1e-14, "{x:e}: {value:e} is not {expected:e}");
    }
}

#[test]
fn results_below_the_normal_numbers_are_rounded_once() {
    /// x², and x²/3.
    struct Squares;
    impl Formula<1, 2> for Squares {
        fn value<T: Real>([x]: [T; 1]) -> [T; 2] {
            [x * x, x * x / T::from_f64(3.0)]
        }
    }
    let least = f64::from_bits(1);
    let squares = |x: f64| escalate::<Squares, 1, 2>([x], 1000.0);
    // 2^−1075 is half of the least number, and rounds to even.
    assert_eq!(squares(2.0_f64.powi(-537))[0], least);
    assert_eq!(squares(2.0_f64.powf(-537.5).next_up())[0], least);
    assert_eq!(squares(2.0_f64.powi(-538)), [0.0, 0.0]);
    assert_eq!(squares(3.0 * 2.0_f64.powi(-537))[1], 3.0 * least);
}

#[test]
fn single_precision_keeps_promises_in_its_own_units() {
    for quarter in 0..200 {
        let x = 2.0_f32.powf(-0.5 * quarter as f32);
        let [versine, excess, _] = escalate_f32::<Cancelling, 1, 3>([x], 2.0);
        let exact = exact::<Cancelling, 1, 3>([f64::from(x)]);
        let distance = |value: f32, exact: Wide<16>| {
            let scale = exact.to_f64().abs().max(f64::from(f32::MIN_POSITIVE));
            (f64::from(value) - exact.to_f64()).abs() / scale * 2.0_f64.powi(24)
        };
        assert!(distance(versine, exact[0]) <= 2.0, "{x:e}: {versine:e}");
        assert!(distance(excess, exact[1]) <= 2.0, "{x:e}: {excess:e}");
    }
}
