//! Double-double results whose digits are bounded: where the bound is not good enough, or numbers leave the range of
//! exponents in which double-double holds its digits, the formula is computed in more words and rounded to two.

use std::marker::PhantomData;

use super::Computation;
use crate::guarded::{Bound, Guardable, Guarded};
use crate::{DoubleDouble, Formula, Real, Wide};

/// A result is within 2^(this) of its exact value, relative to it: 29 decimal digits.
const PLACES: i64 = -98;

/// The outputs within 2⁻⁹⁸ of their exact values, relative to them, as far as the exponents of `f64` go: from 2⁻⁹⁰⁰ to the
/// overflow; below, the second word has fewer bits. NaN where a formula is not defined.
///
/// ```
/// use forms_math::{DoubleDouble, Formula, Real, escalate_double_double};
/// struct Length;
/// impl Formula<2, 1> for Length {
///     fn value<T: Real>([x, y]: [T; 2]) -> [T; 1] {
///         [(x * x + y * y).sqrt()]
///     }
/// }
/// let [x, y] = [3e300, 4e300].map(DoubleDouble::from_f64);
/// assert!(!Length::value([x, y])[0].high().is_finite());
/// assert_eq!(escalate_double_double::<Length, 2, 1>([x, y])[0].high(), 5e300);
/// ```
pub fn escalate_double_double<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [DoubleDouble; A],
) -> [DoubleDouble; O] {
    let values = escalate_double_double_computation(&Of::<F, A, O>(PhantomData), &arguments, O);
    std::array::from_fn(|output| values[output])
}

/// A formula as a computation.
struct Of<F, const A: usize, const O: usize>(PhantomData<F>);

impl<F: Formula<A, O>, const A: usize, const O: usize> Computation for Of<F, A, O> {
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        F::value(std::array::from_fn(|place| arguments[place])).to_vec()
    }
}

/// [`escalate_double_double`] of a computation with so many outputs.
pub fn escalate_double_double_computation(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    outputs: usize,
) -> Vec<DoubleDouble> {
    let mut found = vec![None; outputs];
    let _ = take::<DoubleDouble>(computation, arguments, false, &mut found)
        || take::<Wide<4>>(computation, arguments, false, &mut found)
        || take::<Wide<8>>(computation, arguments, false, &mut found)
        || take::<Wide<16>>(computation, arguments, true, &mut found);
    found.into_iter().map(|value| value.unwrap_or(DoubleDouble::NAN)).collect()
}

/// Computes in guarded `T` what is still open; true where nothing is left. The last precision is taken as it is.
fn take<T: Guardable>(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    is_last: bool,
    outputs: &mut [Option<DoubleDouble>],
) -> bool {
    // a number of two words is the sum of two exact ones
    let exact = |value: &DoubleDouble| match value.low() {
        0.0 => Guarded::<T>::from_f64(value.high()),
        low => Guarded::from_f64(value.high()) + Guarded::from_f64(low),
    };
    let values = computation.values(&arguments.iter().map(exact).collect::<Vec<_>>());
    for (output, value) in outputs.iter_mut().zip(values).filter(|(output, _)| output.is_none()) {
        if is_within(value) {
            *output = Some(in_two_words(value.value()));
        } else if is_last {
            *output = Some(if value.may_vanish() { DoubleDouble::ZERO } else { in_two_words(value.value()) });
        }
    }
    outputs.iter().all(Option::is_some)
}

fn is_within<T: Guardable>(value: Guarded<T>) -> bool {
    if value.is_undefined() {
        return true;
    }
    let (number, error) = (value.value(), value.error());
    if number.is_nan() || !error.is_finite() {
        return false;
    }
    let allowed = number.size_down().shifted(PLACES);
    (error <= allowed && !allowed.is_zero()) || (error.is_zero() && number == T::from_f64(0.0))
}

/// The nearest `f64` and the nearest of what that leaves.
fn in_two_words<T: Guardable>(value: T) -> DoubleDouble {
    let high = value.to_f64();
    if !high.is_finite() {
        return DoubleDouble::from_f64(high);
    }
    DoubleDouble::new(high, (value - T::from_f64(high)).to_f64())
}
