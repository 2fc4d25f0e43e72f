//! Double-double results with bounded digits: if the bound is insufficient, or numbers leave the
//! range of exponents in which double-double keeps its digits, the formula is computed with more
//! words and rounded to two.

use alloc::vec;
use alloc::vec::Vec;

use super::rounding::ToTwoWords;
use super::{Computation, Of, Slot, Tier, from_two_words};
use crate::{DoubleDouble, Formula};

/// Computes the outputs within a relative error of 2⁻⁹⁸, as far as the exponents of `f64` permit:
/// from 2⁻⁹⁰⁰ to overflow; below 2⁻⁹⁰⁰ the second word has fewer bits. The result is NaN where a
/// formula is undefined, and where no precision bounds the error sufficiently.
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
    core::array::from_fn(|output| values[output].0)
}

/// Computes [`escalate_double_double`] for a computation with this number of outputs, and returns
/// the precision of each output.
pub fn escalate_double_double_computation(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    outputs: usize,
) -> Vec<(DoubleDouble, Tier)> {
    let mut slots = vec![Slot::open(DoubleDouble::NAN); outputs];
    from_two_words(computation, arguments, ToTwoWords, &mut slots);
    slots.into_iter().map(|slot| (slot.number, slot.tier)).collect()
}
