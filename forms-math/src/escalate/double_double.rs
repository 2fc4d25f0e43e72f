//! Double-double results whose digits are bounded: where the bound is not good enough, or numbers leave the range of
//! exponents in which double-double holds its digits, the formula is computed in more words and rounded to two.

use super::rounding::ToTwoWords;
use super::{Computation, Of, Slot, Tier, from_two_words};
use crate::{DoubleDouble, Formula};

/// The outputs within 2⁻⁹⁸ of their exact values, relative to them, as far as the exponents of `f64` go: from 2⁻⁹⁰⁰ to the
/// overflow; below, the second word has fewer bits. NaN where a formula is not defined, and where no precision bounds the
/// error well enough.
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
    let values = escalate_double_double_computation(&Of::<F, A, O>::new(), &arguments, O);
    std::array::from_fn(|output| values[output].0)
}

/// [`escalate_double_double`] of a computation with so many outputs, with the precision that each was taken from.
pub fn escalate_double_double_computation(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    outputs: usize,
) -> Vec<(DoubleDouble, Tier)> {
    let mut slots = vec![Slot::open(DoubleDouble::NAN); outputs];
    from_two_words(computation, arguments, ToTwoWords, &mut slots);
    slots.into_iter().map(|slot| (slot.number, slot.tier)).collect()
}
