//! Error bounds are never exceeded: random formulas in guarded arithmetic are compared with higher
//! precision.

use forms_math::{Bound, DoubleDouble, Guardable, Guarded, Magnitude, Real, Scalar, Wide};
use proptest::prelude::*;

/// Step of a formula: an operation on earlier values.
#[derive(Clone, Copy, Debug)]
struct Step {
    operation: usize,
    operands: [usize; 4],
}

type Function<T> = fn(T) -> T;

fn functions<T: Real>() -> [Function<T>; 26] {
    [
        T::sqrt,
        T::abs,
        T::sin,
        T::cos,
        T::tan,
        T::asin,
        T::acos,
        T::atan,
        T::exp,
        T::exp_m1,
        T::ln,
        T::ln_1p,
        T::sinh,
        T::cosh,
        T::tanh,
        T::erf,
        T::expint1,
        T::expint2,
        T::expint3,
        T::dilog,
        T::clausen,
        T::erfc,
        T::cbrt,
        |x| x.power(-3, 2),
        |x| x.power(3, 1),
        |x| x.power(1, 3),
    ]
}

const OPERATIONS: usize = 26 + 4 * 4 + 6;

impl Step {
    fn value<T: Real>(self, values: &[T]) -> T {
        let [a, b, c, d] = self.operands.map(|operand| values[operand % values.len()]);
        match self.operation {
            index if index < 26 => functions::<T>()[index](a),
            index if index < 42 => match index % 4 {
                0 => a + b,
                1 => a - b,
                2 => a * b,
                _ => a / b,
            },
            42 => T::difference_of_products(a, b, c, d),
            43 => a.atan2(b),
            44 => T::if_less(a, b, c, d),
            45 => T::if_less_equal(a, b, c, d),
            46 => T::if_equal(a, b, c, d),
            _ => a.hypot(b),
        }
    }
}

fn run<T: Real>(steps: &[Step], arguments: &[f64]) -> Vec<T> {
    let mut values: Vec<T> = arguments.iter().map(|&argument| T::from_f64(argument)).collect();
    for step in steps {
        values.push(step.value(&values));
    }
    values
}

type Truth = Guarded<Wide<8>>;

/// Whether |value − truth| is at most the sum of the two errors; the words of a value are exact
/// summands.
fn within<T: Guardable>(
    value: Guarded<T>,
    truth: Truth,
    words: fn(T) -> Wide<8>,
    error: fn(T::Bound) -> Wide<8>,
) -> bool {
    if !value.error().is_finite() || !truth.error().is_finite() {
        return true;
    }
    if value.is_undefined() || truth.is_undefined() {
        return value.is_undefined() && truth.is_undefined();
    }
    let distance = (words(value.value()) - truth.value()).abs();
    let beyond = distance - error(value.error());
    beyond.to_f64() <= 0.0
        || Guarded::exact(beyond).value().size_down() <= truth.error().times(Bound::of(1.0 + 1e-9))
}

fn argument() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -4.0..4.0_f64,
        1 => prop::num::f64::NORMAL,
        1 => prop::num::f64::SUBNORMAL,
        1 => (-40..40_i32).prop_map(|k| f64::from(k) * 0.25),
        1 => (-60..-10_i32, prop::bool::ANY)
            .prop_map(|(e, sign)| if sign { 1.0 - 2.0_f64.powi(e) } else { 2.0_f64.powi(e) - 1.0 }),
        1 => (-30.0..30.0_f64).prop_map(f64::exp),
    ]
}

fn steps(most: usize) -> impl Strategy<Value = Vec<Step>> {
    let step = (0..OPERATIONS, prop::array::uniform4(0..64_usize))
        .prop_map(|(operation, operands)| Step { operation, operands });
    prop::collection::vec(step, 1..most)
}

fn check<T: Guardable + std::fmt::Debug>(
    steps: &[Step],
    arguments: &[f64],
    words: fn(T) -> Wide<8>,
    error: fn(T::Bound) -> Wide<8>,
) -> Result<(), TestCaseError> {
    let values = run::<Guarded<T>>(steps, arguments);
    let truths = run::<Truth>(steps, arguments);
    for (index, (value, truth)) in values.into_iter().zip(truths).enumerate() {
        prop_assert!(within(value, truth, words, error), "value {index}: {value:?} is not {truth:?}");
    }
    Ok(())
}

fn of_two_words(value: DoubleDouble) -> Wide<8> {
    Wide::from_f64(value.high()) + Wide::from_f64(value.low())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bounds_of_f64_hold(steps in steps(8), arguments in prop::collection::vec(argument(), 4)) {
        check::<f64>(&steps, &arguments, Wide::from_f64, Wide::from_f64)?;
    }

    #[test]
    fn bounds_of_double_double_hold(steps in steps(6), arguments in prop::collection::vec(argument(), 4)) {
        check::<DoubleDouble>(&steps, &arguments, of_two_words, Wide::from_f64)?;
    }
}

/// A number of any size.
fn of_any_binade() -> impl Strategy<Value = f64> {
    (-1074..1023_i32, 1.0..2.0_f64).prop_map(|(exponent, significand)| significand * 2.0_f64.powi(exponent))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    /// Products of tiny numbers are zero, and those of large ones infinite; their roots and functions
    /// are not.
    #[test]
    fn bounds_of_products_hold_in_all_binades(
        operation in 42..OPERATIONS,
        after in 0..OPERATIONS,
        arguments in prop::collection::vec(of_any_binade(), 4),
    ) {
        let product = Step { operation, operands: [0, 1, 2, 3] };
        let root = Step { operation: 0, operands: [4; 4] };
        let steps = [product, root, Step { operation: after, operands: [5, 4, 4, 5] }];
        check::<f64>(&steps, &arguments, Wide::from_f64, Wide::from_f64)?;
        check::<DoubleDouble>(&steps, &arguments, of_two_words, Wide::from_f64)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bounds_of_four_words_hold(steps in steps(6), arguments in prop::collection::vec(argument(), 4)) {
        let error = |error: Magnitude| {
            let (mantissa, exponent) = error.parts();
            Wide::from_f64(mantissa).scaled(exponent)
        };
        check::<Wide<4>>(&steps, &arguments, Wide::to_limbs, error)?;
    }
}

/// Returns functions of two numbers.
fn functions_of_two<T: Real>() -> [fn(T, T) -> T; 9] {
    [
        |a, b| a + b,
        |a, b| a - b,
        |a, b| a * b,
        |a, b| a / b,
        T::atan2,
        |a, b| T::difference_of_products(a, b, b, b),
        |a, b| T::sum_of_products(a, a, b, b),
        |a, b| T::if_less(a, b, a * b, b),
        |a, b| T::if_equal(a, b, a, a + b),
    ]
}

fn in_words(value: f64) -> Truth {
    Guarded::exact(Wide::from_f64(value))
}

/// Doubles next to multiples of π/2, by the continued fractions of 2ᵉ · 2/π: at the first, the
/// cosine of glibc 2.36 is wrong by 26,191 ulps.
const NEAR_RIGHT_ANGLES: [f64; 10] = [
    7.324786709818491e289,
    1.2094912707964283e23,
    2.099706071112433e183,
    8.457122029796849e94,
    1.6914244059593698e95,
    4.047992870684553e37,
    7.1883611082658065e261,
    2.029612024573252e87,
    1126833495400.4492,
    5.319372648326541e255,
];

#[test]
fn bounds_hold_at_large_angles_next_to_multiples_of_a_right_angle() {
    for angle in NEAR_RIGHT_ANGLES {
        let values =
            [Guarded::<f64>::sin, Guarded::cos, Guarded::tan].map(|function| function(Guarded::exact(angle)));
        let truths = [Truth::sin, Truth::cos, Truth::tan].map(|function| function(in_words(angle)));
        for (value, truth) in values.into_iter().zip(truths) {
            assert!(truth.error().is_finite(), "{angle:e}");
            assert!(
                within(value, truth, Wide::from_f64, Wide::from_f64),
                "{angle:e}: {value:?} is not {truth:?}"
            );
        }
    }
}

/// The angle of this point is wrong by 1.5 ulp, or 2.26 units, with the functions of `libm`: y/x, its
/// arctangent and the difference from π are rounded.
#[test]
fn bounds_hold_for_angles_that_are_rounded_three_times() {
    let (y, x) = (0.769_773_134_006_030_2, -0.365_843_605_513_250_57);
    let value: Guarded<f64> = Guarded::exact(y).atan2(Guarded::exact(x));
    let truth = in_words(y).atan2(in_words(x));
    assert!(within(value, truth, Wide::from_f64, Wide::from_f64), "{value:?} is not {truth:?}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    /// The bound for x with an error of ε holds for every number between x − ε and x + ε.
    #[test]
    fn errors_of_arguments_are_carried(
        places in prop::array::uniform2(argument()),
        digits in prop::array::uniform2(0..60_i32),
        parts in prop::array::uniform2(-1.0..1.0_f64),
    ) {
        let errors = [0, 1].map(|k| places[k].abs().min(1e300) * 2.0_f64.powi(-digits[k]));
        let guarded = [0, 1].map(|k| Guarded::<f64>::new(places[k], errors[k]));
        let truths = [0, 1].map(|k| in_words(places[k]) + in_words(errors[k]) * in_words(parts[k]));
        for (index, (of_guarded, of_truth)) in functions().into_iter().zip(functions()).enumerate() {
            let (value, truth): (Guarded<f64>, Truth) = (of_guarded(guarded[0]), of_truth(truths[0]));
            prop_assert!(within(value, truth, Wide::from_f64, Wide::from_f64), "{index}: {value:?} is not {truth:?}");
        }
        for (index, (of_guarded, of_truth)) in functions_of_two().into_iter().zip(functions_of_two()).enumerate() {
            let value: Guarded<f64> = of_guarded(guarded[0], guarded[1]);
            let truth: Truth = of_truth(truths[0], truths[1]);
            prop_assert!(within(value, truth, Wide::from_f64, Wide::from_f64), "{index}: {value:?} is not {truth:?}");
        }
    }

    /// A wide operation that is reported as exact is exact.
    #[test]
    fn what_is_exact_is_known(a in any::<i64>(), b in any::<i64>(), shift in -260..260_i64) {
        let number = |value: i64, shift: i64| Wide::<4>::from_integer(value).scaled(shift);
        let (x, y) = (number(a, shift), number(b, 0) + number(a, -190));
        // All bits are in use, so that a carry shifts the last one out.
        let (full, other) = (number(a, 0) + number(b, -193), number(b, 0) + number(a, -193));
        let exactly = |value: Wide<4>| value.to_limbs::<16>();
        for (value, exact) in [
            (Guarded::exact(x) + Guarded::exact(y), exactly(x) + exactly(y)),
            (Guarded::exact(full) + Guarded::exact(other), exactly(full) + exactly(other)),
            (Guarded::exact(x) - Guarded::exact(y), exactly(x) - exactly(y)),
            (Guarded::exact(x) * Guarded::exact(y), exactly(x) * exactly(y)),
        ] {
            prop_assert_eq!(value.error().parts().0 == 0.0, exactly(value.value()) == exact);
        }
    }
}

/// Bounds are not far above the actual errors.
#[test]
fn bounds_are_sharp() {
    let x = Guarded::<f64>::from_f64;
    let third = x(1.0) / x(3.0);
    assert!(third.error() < 2.0_f64.powi(-54));
    for exact in
        [x(0.75) - x(0.5), x(3.0) * x(0.125), x(1e200) / x(1024.0), x(6.25).sqrt(), x(1e16) - x(1e16 - 2.0)]
    {
        assert_eq!(exact.error(), 0.0, "{exact:?}");
    }
    for tight in
        [third.sin(), third.exp(), third.ln(), third.atan2(third * third), third.power(1, 3), third.dilog()]
    {
        assert!(tight.error() <= 8.0 * f64::EPSILON * tight.value().abs(), "{tight:?}");
    }
}

#[test]
fn what_is_not_known_has_no_bound() {
    let x = Guarded::<f64>::from_f64;
    // Zero with an error of an ulp of a third.
    let nothing = x(1.0) / x(3.0) - x(1.0 / 3.0);
    assert_eq!(nothing.value(), 0.0);
    assert!(nothing.error() > 0.0);
    for unknown in [
        nothing.sqrt(),
        nothing.ln(),
        x(1.0) / nothing,
        nothing.atan2(x(-1.0)),
        nothing.power(1, 3),
        (nothing + x(1.0)).acos(),
    ] {
        assert_eq!(unknown.error(), f64::INFINITY, "{unknown:?}");
    }
    assert!(nothing.atan2(x(1.0)).error() < 1e-15);
    let open = Guarded::if_less(nothing, x(0.0), x(1.0), x(1.5));
    assert!((open.value() - 1.5).abs() <= open.error() && (open.value() - 1.0).abs() <= open.error());
    for undefined in [
        x(-1.0).sqrt(),
        x(-1.0).ln(),
        x(2.0).acos(),
        x(f64::NAN) + x(1.0),
        x(1.5).dilog(),
        (x(-1.0) / x(3.0)).sqrt(),
    ] {
        assert!(undefined.is_undefined(), "{undefined:?}");
    }
}
