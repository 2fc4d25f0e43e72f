//! Signed zeros, infinities, NaN and the ends of the range: a lane returns the value of the
//! standard library, or NaN where it gives up.

use forms_math::{Lane32, Lane64, Real};

const PLACES: [f64; 22] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    -0.5,
    2.0,
    -2.0,
    5e-324,
    -5e-324,
    1e-310,
    -1e-310,
    1e-200,
    -1e-200,
    710.0,
    -750.0,
    1e300,
    -1e300,
    f64::MAX,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
];

fn agrees(found: f64, expected: f64, close: f64) -> bool {
    let near = (found - expected).abs() <= close * expected.abs().max(f64::MIN_POSITIVE);
    let same = found == expected && found.is_sign_negative() == expected.is_sign_negative();
    same || found.is_nan() && expected.is_nan() || (near && found != 0.0 && expected != 0.0)
}

macro_rules! assert_agreement {
    ($($name:ident $reach:expr, $reach_single:expr;)*) => { $(
        for x in PLACES {
            for found in [Lane64::<false>(x).$name().0, Lane64::<true>(x).$name().0] {
                let gives_up = found.is_nan() && x.abs() > $reach;
                let expected = f64::$name(x);
                assert!(gives_up || agrees(found, expected, 1e-15), "{} of {x:e}: {found:e}", stringify!($name));
            }
            let x = x as f32;
            for found in [Lane32::<false>(x).$name().0, Lane32::<true>(x).$name().0] {
                let gives_up = found.is_nan() && x.abs() > $reach_single;
                let expected = f32::$name(x);
                let near = agrees(found.into(), expected.into(), 1e-6);
                assert!(gives_up || near, "{} of {x:e} in f32: {found:e}", stringify!($name));
            }
        }
    )* };
}

#[test]
fn functions_have_their_special_values() {
    assert_agreement! {
        exp 700.0, 80.0;
        exp_m1 700.0, 80.0;
        ln f64::INFINITY, f32::INFINITY;
        ln_1p f64::INFINITY, f32::INFINITY;
        sin 1e6, 6e3;
        cos 1e6, 6e3;
        tan 1e6, 6e3;
        asin f64::INFINITY, f32::INFINITY;
        acos f64::INFINITY, f32::INFINITY;
        atan 1e300, 1e36;
        sinh 700.0, 80.0;
        cosh 700.0, 80.0;
        tanh f64::INFINITY, f32::INFINITY;
        sqrt f64::INFINITY, f32::INFINITY;
    }
}

#[test]
fn angles_of_points_have_their_special_values() {
    for y in PLACES {
        for x in PLACES {
            let expected = f64::atan2(y, x);
            for found in [Lane64::<false>(y).atan2(Lane64(x)).0, Lane64::<true>(y).atan2(Lane64(x)).0] {
                let gives_up = found.is_nan() && (x.abs().max(y.abs()) >= 1e300 || (x == 0.0 && y == 0.0));
                assert!(
                    gives_up || agrees(found, expected, 1e-15),
                    "atan2 of {y:e} and {x:e}: {found:e}, not {expected:e}"
                );
            }
        }
    }
}

#[test]
fn powers_have_their_special_values() {
    for (numerator, denominator) in [(2, 1), (3, 1), (5, 1), (1, 2), (3, 2), (5, 2), (1, 3), (2, 3), (3, 7)] {
        let of = |x: f64| Lane64::<true>(x).power(numerator, denominator).0;
        assert_eq!(of(0.0), 0.0, "0^({numerator}/{denominator})");
        assert_eq!(of(1.0), 1.0, "1^({numerator}/{denominator})");
        assert!(of(f64::NAN).is_nan());
        assert!(denominator == 1 || of(-2.0).is_nan(), "(−2)^({numerator}/{denominator})");
    }
    assert_eq!(Lane64::<false>(-2.0).power(5, 1).0, -32.0);
    assert_eq!(Lane64::<false>(8.0).power(-2, -3).0, 4.0);
    assert_eq!(Lane64::<false>(3.0).power(0, 5).0, 1.0);
    assert!(Lane64::<false>(3.0).power(1, 0).0.is_nan());
}

#[test]
fn choices_between_what_cannot_be_compared_are_nan() {
    let (one, two, nan) = (Lane64::<false>(1.0), Lane64(2.0), Lane64(f64::NAN));
    assert_eq!(Lane64::if_less(one, two, one, two).0, 1.0);
    assert_eq!(Lane64::if_less(one, one, one, two).0, 2.0);
    assert_eq!(Lane64::if_less_equal(one, one, one, two).0, 1.0);
    assert_eq!(Lane64::if_equal(one, two, one, two).0, 2.0);
    for choice in [Lane64::if_less, Lane64::if_less_equal, Lane64::if_equal] {
        assert!(choice(one, nan, one, two).0.is_nan());
        assert!(choice(nan, nan, one, two).0.is_nan());
    }
}

/// Choice by a comparison of its first two operands.
type Choice = fn(Lane64<false>, Lane64<false>, Lane64<false>, Lane64<false>) -> Lane64<false>;

#[test]
fn choices_that_are_followed_by_nan_in_any_case_compare_once() {
    let (one, two, nan) = (Lane64::<false>(1.0), Lane64(2.0), Lane64(f64::NAN));
    let choices: [[Choice; 2]; 3] = [
        [Lane64::if_less, Lane64::either_if_less],
        [Lane64::if_less_equal, Lane64::either_if_less_equal],
        [Lane64::if_equal, Lane64::either_if_equal],
    ];
    for [strict, either] in choices {
        for (left, right) in [(one, two), (two, one), (one, one)] {
            assert_eq!(strict(left, right, one, two).0, either(left, right, one, two).0);
        }
        assert_eq!(either(one, nan, one, two).0, 2.0);
    }
}
