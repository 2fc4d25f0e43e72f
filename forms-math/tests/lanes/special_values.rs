//! Powers at 0, 1 and NaN, and choices between numbers that cannot be compared. The special values
//! of functions are in the table of `forms-core/tests/kernel/conformance`.

use forms_math::{Lane64, Real};

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
