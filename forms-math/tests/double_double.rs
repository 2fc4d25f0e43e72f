//! Double-double numbers near the ends of the range of exponents, and where their own digits are
//! insufficient.

use forms_math::{DoubleDouble, Formula, Real, Wide, escalate_double_double};
use proptest::prelude::*;

type Truth = Wide<8>;

fn exactly(value: DoubleDouble) -> Truth {
    Truth::from_f64(value.high()) + Truth::from_f64(value.low())
}

/// Returns the relative error in units of 2⁻¹⁰⁶.
fn units(value: DoubleDouble, exact: Truth) -> f64 {
    let difference = exactly(value) - exact;
    if difference == Truth::from_f64(0.0) {
        0.0
    } else {
        (difference / exact).abs().to_f64() * 2.0_f64.powi(106)
    }
}

/// Generates m (1 + r 2⁻⁵⁴) 2ᵉ with a non-zero second word.
fn number() -> impl Strategy<Value = DoubleDouble> {
    (-960..1023_i32, 1.0..2.0_f64, 0.3..0.7_f64).prop_map(|(exponent, mantissa, rest)| {
        let scale = 2.0_f64.powi(exponent);
        DoubleDouble::new(mantissa * scale, rest * f64::EPSILON / 2.0 * scale)
    })
}

/// Whether both words of a result near the value are normal numbers.
fn has_room(exact: Truth) -> bool {
    let size = exact.abs();
    Truth::from_f64(2.0_f64.powi(-900)) < size && size < Truth::from_f64(f64::MAX * 0.999)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn products_quotients_and_roots_hold_their_bounds_up_to_the_ends(
        (a, b, c, d) in (number(), number(), number(), number())
    ) {
        let (x, y) = (exactly(a), exactly(b));
        for (value, exact, bound) in [(a * b, x * y, 7.0), (a / b, x / y, 15.0), (a.sqrt(), x.sqrt(), 4.0)] {
            if has_room(exact) {
                prop_assert!(units(value, exact) <= bound, "{a:?} {b:?}: {value:?}");
            }
        }
        let difference = DoubleDouble::difference_of_products(a, b, c, d);
        let products = (x * y, exactly(c) * exactly(d));
        let exact = products.0 - products.1;
        let larger = if products.0 < products.1 { products.1 } else { products.0 };
        if has_room(larger) && has_room(exact) && has_room(products.0) && has_room(products.1) {
            prop_assert!(units(difference, exact) <= 16.0, "{a:?} {b:?} {c:?} {d:?}: {difference:?}");
        }
    }

    #[test]
    fn digits_are_kept_at_every_scale(exponent in -1000..1000_i32, x in 1.0..2.0_f64, y in 1.0..2.0_f64) {
        let scale = 2.0_f64.powi(exponent);
        let arguments = [x * scale, y * scale].map(DoubleDouble::from_f64);
        let [length, angle] = escalate_double_double::<Polar, 2, 2>(arguments);
        let exact = Polar::value(arguments.map(exactly));
        prop_assert!(units(angle, exact[1]) <= 256.0);
        if has_room(exact[0]) {
            prop_assert!(units(length, exact[0]) <= 256.0);
        }
    }

    #[test]
    fn digits_are_kept_where_terms_cancel(exponent in -200.0..0.0_f64) {
        let x = DoubleDouble::from_f64(exponent.exp2());
        let [value] = escalate_double_double::<Excess, 1, 1>([x]);
        prop_assert!(units(value, Excess::value([exactly(x).to_limbs::<16>()])[0].to_limbs()) <= 256.0, "{x:?}");
    }
}

/// √(x² + y²), and (x² − y²)/(x² + y²)
struct Polar;

impl Formula<2, 2> for Polar {
    fn value<T: Real>([x, y]: [T; 2]) -> [T; 2] {
        let square = x * x + y * y;
        [square.sqrt(), (x * x - y * y) / square]
    }
}

/// √(1 + x²) − 1
struct Excess;

impl Formula<1, 1> for Excess {
    fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
        [(T::from_f64(1.0) + x * x).sqrt() - T::from_f64(1.0)]
    }
}

#[test]
fn what_is_not_defined_or_too_large_is_no_number_or_infinite() {
    let root = |x: f64| escalate_double_double::<Excess, 1, 1>([DoubleDouble::from_f64(x)])[0].high();
    assert!(root(f64::NAN).is_nan());
    assert_eq!(root(0.0), 0.0);
    let [length, _] = escalate_double_double::<Polar, 2, 2>([f64::MAX; 2].map(DoubleDouble::from_f64));
    assert_eq!((length.high(), length.low()), (f64::INFINITY, 0.0));
    let largest = DoubleDouble::from_f64(f64::MAX);
    assert_eq!((largest * DoubleDouble::from_f64(0.5)).high(), f64::MAX / 2.0);
    assert_eq!((largest / largest).high(), 1.0);
    assert!((largest * largest).high().is_infinite());
}
