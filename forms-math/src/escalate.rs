//! Evaluation of a kernel in the precision that its arguments need for the promised accuracy.
//!
//! ```text
//! one lane ─▶ Guarded<f64> ─▶ Guarded<DoubleDouble> ─▶ tape ─▶ Guarded<Wide<4>> ─▶ <8> ─▶ … ─▶ <256>
//!    └─ each output from the first that bounds its error sufficiently
//! ```
//! Results of two words start with the second type ([`double_double`]). Numbers of words have
//! exponents of 60 bits, so that nothing underflows or overflows on the way to a result that `f64`
//! can hold. A result that 16 376 bits do not decide is NaN, and a [`NotWithin`] where that is
//! requested.

mod double_double;
mod lane;
#[cfg(not(feature = "std"))]
mod repetition;
mod rounding;
#[cfg(feature = "std")]
mod tape;

pub use double_double::{escalate_double_double, escalate_double_double_computation};

use alloc::vec;
use alloc::vec::Vec;
use core::fmt;
use core::marker::PhantomData;

use crate::guarded::{Guardable, Guarded};
use crate::scalar::Scalar;
use crate::{Computation, DoubleDouble, Formula, Real, Wide};
#[cfg(not(feature = "std"))]
use repetition::in_any_precision;
use rounding::{Outcome, Rounding, ToDouble, ToSingle};
#[cfg(feature = "std")]
use tape::in_any_precision;

/// Precision from which an output was taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tier {
    /// `f64`
    Double,
    /// 106 bits
    DoubleDouble,
    /// This number of words of 64 bits.
    Words(u16),
    /// No precision bounded the error sufficiently.
    Undecided,
}

/// Number of words of the widest numbers.
const MOST_WORDS: usize = 256;

/// Error of a kernel for whose value no available precision reaches the bound promised by its
/// `within`. The value is then NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotWithin {
    /// Index of the result.
    pub output: usize,
    /// Promised error bound, in units of 2⁻⁵³.
    pub within: f64,
}

impl fmt::Display for NotWithin {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (place, within) = (self.output, self.within);
        let bits = 64 * MOST_WORDS - 8;
        write!(
            formatter,
            "result {place} could not be computed within a relative error of {within}·2⁻⁵³ with {bits} bits"
        )
    }
}

impl core::error::Error for NotWithin {}

/// Computes the outputs within a relative error of `within` · 2⁻⁵³. Below 2⁻¹⁰²² the error is at
/// most half an ulp, and beyond the largest `f64` the output is infinite.
///
/// Rounding to `f64` uses up to 2⁻⁵³ of this bound: with `within` below 1, some values have no
/// sufficiently near `f64`. On the boundary of two roundings, where no precision decides which one
/// is nearer, the error can be 2⁻²⁸ of a unit larger. The output is NaN where a formula is
/// undefined, and where no precision bounds the error sufficiently: [`escalate_checked`]
/// distinguishes these cases.
///
/// ```
/// use forms_math::{Formula, Real, escalate};
/// struct VersineOverSquare;
/// impl Formula<1, 1> for VersineOverSquare {
///     fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
///         [(T::from_f64(1.0) - x.cos()) / (x * x)]
///     }
/// }
/// assert_eq!(escalate::<VersineOverSquare, 1, 1>([1e-30], 1.0), [0.5]);
/// assert_eq!(escalate::<VersineOverSquare, 1, 1>([1e-300], 1.0), [0.5]);
/// ```
pub fn escalate<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [f64; O] {
    escalate_with_tier::<F, A, O>(arguments, within).map(|(value, _)| value)
}

/// Computes [`escalate`], with an error if a value is not known to this accuracy.
///
/// # Errors
/// The first result that no precision bounds sufficiently.
///
/// ```
/// use forms_math::{Formula, NotWithin, Real, escalate_checked};
/// /// 1 below √2 · √2, 2 from there on.
/// struct Step;
/// impl Formula<1, 1> for Step {
///     fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
///         let [one, two] = [1.0, 2.0].map(T::from_f64);
///         [T::if_less(x, two.sqrt() * two.sqrt(), one, two)]
///     }
/// }
/// assert_eq!(escalate_checked::<Step, 1, 1>([1.5], 1.0), Ok([1.0]));
/// assert_eq!(escalate_checked::<Step, 1, 1>([2.0], 1.0), Err(NotWithin { output: 0, within: 1.0 }));
/// ```
pub fn escalate_checked<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> Result<[f64; O], NotWithin> {
    let values = escalate_with_tier::<F, A, O>(arguments, within);
    match values.iter().position(|(_, tier)| *tier == Tier::Undecided) {
        Some(output) => Err(NotWithin { output, within }),
        None => Ok(values.map(|(value, _)| value)),
    }
}

/// Computes the outputs that `f64` decides: each is within a relative error of `within` · 2⁻⁵³, or NaN where
/// more precision is needed, and where the formula is undefined.
///
/// ```
/// use forms_math::{Formula, Real, without_escalation};
/// /// √(1 + x) − 1
/// struct Excess;
/// impl Formula<1, 1> for Excess {
///     fn value<T: Real>([x]: [T; 1]) -> [T; 1] {
///         let one = T::from_f64(1.0);
///         [(one + x).sqrt() - one]
///     }
/// }
/// assert_eq!(without_escalation::<Excess, 1, 1>([3.0], 2.0), [1.0]);
/// assert!(without_escalation::<Excess, 1, 1>([1e-9], 2.0)[0].is_nan());
/// ```
pub fn without_escalation<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [f64; O] {
    lane::in_one_lane::<F, A, O>(arguments, within)
        .unwrap_or_else(|| in_guarded_double::<F, A, O>(arguments, within))
}

/// Computes [`without_escalation`] where a lane has not bounded the error sufficiently.
pub(crate) fn in_guarded_double<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [f64; O] {
    let mut slots = [Slot::open(f64::NAN); O];
    let values = F::value(arguments.map(Guarded::<f64>::from_f64));
    take(&values, Tier::Double, (ToDouble { units: within }, 0.0), &mut slots);
    slots.map(|slot| slot.number)
}

/// Computes [`escalate`], and returns the precision of each output.
pub fn escalate_with_tier<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [(f64, Tier); O] {
    match lane::in_one_lane::<F, A, O>(arguments, within) {
        Some(values) => values.map(|value| (value, Tier::Double)),
        None => beyond_lane::<F, A, O>(arguments, within),
    }
}

/// Computes [`escalate_with_tier`] where a lane has not bounded the error sufficiently.
#[inline(never)]
pub(crate) fn beyond_lane<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [(f64, Tier); O] {
    rounded::<F, A, O, _>(arguments, ToDouble { units: within })
}

/// Computes [`escalate`] for `f32`: within a relative error of `within` · 2⁻²⁴, and within half an
/// ulp below 2⁻¹²⁶.
pub fn escalate_f32<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f32; A],
    within: f64,
) -> [f32; O] {
    let arguments = arguments.map(f64::from);
    match lane::in_one_lane_for_f32::<F, A, O>(arguments, within) {
        Some(values) => values,
        None => rounded::<F, A, O, _>(arguments, ToSingle { units: within }).map(|(value, _)| value),
    }
}

#[inline]
fn rounded<F: Formula<A, O>, const A: usize, const O: usize, R: Rounding>(
    arguments: [f64; A],
    rounding: R,
) -> [(R::Number, Tier); O] {
    let mut slots = [Slot::open(R::NAN); O];
    let values = F::value(arguments.map(Guarded::<f64>::from_f64));
    if !take(&values, Tier::Double, (rounding, 0.0), &mut slots) {
        beyond_double::<F, A, O, R>(arguments, rounding, &mut slots);
    }
    slots.map(|slot| (slot.number, slot.tier))
}

#[cold]
#[inline(never)]
fn beyond_double<F: Formula<A, O>, const A: usize, const O: usize, R: Rounding>(
    arguments: [f64; A],
    rounding: R,
    slots: &mut [Slot<R::Number>],
) {
    let arguments = arguments.map(DoubleDouble::from_f64);
    if !take(&F::value(arguments.map(argument)), Tier::DoubleDouble, (rounding, 0.0), slots) {
        climb(&Of::<F, A, O>::new(), &arguments, rounding, slots);
    }
}

/// Converts an argument of two words exactly.
fn argument(value: DoubleDouble) -> Guarded<DoubleDouble> {
    if value.is_nan() { Guarded::undefined() } else { Guarded::exact(value) }
}

/// Formula as a computation.
struct Of<F, const A: usize, const O: usize>(PhantomData<F>);

impl<F, const A: usize, const O: usize> Of<F, A, O> {
    fn new() -> Self {
        Self(PhantomData)
    }
}

impl<F: Formula<A, O>, const A: usize, const O: usize> Computation for Of<F, A, O> {
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T> {
        F::value(core::array::from_fn(|place| arguments[place])).to_vec()
    }
}

/// Computes [`escalate_with_tier`] for a computation with this number of outputs.
pub fn escalate_computation(
    computation: &impl Computation,
    arguments: &[f64],
    outputs: usize,
    within: f64,
) -> Vec<(f64, Tier)> {
    if let Some(values) = lane::in_one_lane_computed(computation, arguments, within) {
        return values.into_iter().map(|value| (value, Tier::Double)).collect();
    }
    beyond_lane_computed(computation, arguments, outputs, within)
}

/// Computes [`escalate_computation`] where a lane has not bounded the error sufficiently.
pub(crate) fn beyond_lane_computed(
    computation: &impl Computation,
    arguments: &[f64],
    outputs: usize,
    within: f64,
) -> Vec<(f64, Tier)> {
    let rounding = ToDouble { units: within };
    let mut slots = vec![Slot::open(f64::NAN); outputs];
    let doubles: Vec<Guarded<f64>> = arguments.iter().map(|&value| Guarded::from_f64(value)).collect();
    if !take(&computation.values(&doubles), Tier::Double, (rounding, 0.0), &mut slots) {
        let words: Vec<_> = arguments.iter().map(|&value| DoubleDouble::from_f64(value)).collect();
        from_two_words(computation, &words, rounding, &mut slots);
    }
    slots.into_iter().map(|slot| (slot.number, slot.tier)).collect()
}

/// Computes the open results, starting with double-double.
fn from_two_words<R: Rounding>(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    rounding: R,
    slots: &mut [Slot<R::Number>],
) {
    let words: Vec<_> = arguments.iter().map(|&value| argument(value)).collect();
    if !take(&computation.values(&words), Tier::DoubleDouble, (rounding, 0.0), slots) {
        climb(computation, arguments, rounding, slots);
    }
}

/// Result to be determined.
#[derive(Clone, Copy)]
struct Slot<N> {
    number: N,
    tier: Tier,
    /// Whether more precision can decide the result.
    is_open: bool,
}

impl<N> Slot<N> {
    fn open(nan: N) -> Self {
        Slot { number: nan, tier: Tier::Undecided, is_open: true }
    }
}

/// Stores the values that are accurate enough for the open results; returns true if none remains
/// open.
fn take<T: Guardable, R: Rounding>(
    values: &[Guarded<T>],
    tier: Tier,
    (rounding, slack): (R, f64),
    slots: &mut [Slot<R::Number>],
) -> bool {
    let mut is_open = false;
    for (slot, &value) in slots.iter_mut().zip(values) {
        if !slot.is_open {
            continue;
        }
        match rounding.round(value, slack) {
            Outcome::Known(number) => *slot = Slot { number, tier, is_open: false },
            Outcome::Open => is_open = true,
            Outcome::Never => slot.is_open = false,
        }
    }
    !is_open
}

/// Widest numbers for a formula with an integral: its rule needs many nodes, and its error is only
/// estimated.
const MOST_WORDS_OF_INTEGRALS: usize = 16;

/// Computes the open results with increasing numbers of words.
fn climb<R: Rounding>(
    computation: &impl Computation,
    arguments: &[DoubleDouble],
    rounding: R,
    slots: &mut [Slot<R::Number>],
) {
    let (computation, has_integral) = in_any_precision(computation, arguments.len());
    // Results that do not depend on the size of an infinite argument are known immediately.
    let is_finite = arguments.iter().all(|argument| argument.high().is_finite());
    let most = match (is_finite, has_integral) {
        (false, _) => 4,
        (true, true) => MOST_WORDS_OF_INTEGRALS,
        (true, false) => MOST_WORDS,
    };
    let climbing = Climbing { computation, arguments, rounding, most };
    let _ = climbing.is_done_in::<4>(slots)
        || climbing.is_done_in::<8>(slots)
        || climbing.is_done_in::<16>(slots)
        || climbing.is_done_in::<40>(slots)
        || climbing.is_done_in::<96>(slots)
        || climbing.is_done_in::<MOST_WORDS>(slots);
}

/// Formula with its arguments, to be computed in up to this number of words.
struct Climbing<'a, C, R> {
    computation: C,
    arguments: &'a [DoubleDouble],
    rounding: R,
    most: usize,
}

impl<C: Computation, R: Rounding> Climbing<'_, C, R> {
    /// Computes the open results in this number of words; returns true if none remains, or if no
    /// larger numbers are tried.
    #[inline(never)]
    fn is_done_in<const LIMBS: usize>(&self, slots: &mut [Slot<R::Number>]) -> bool {
        // A number of two words is the sum of two exact numbers.
        let exact = |value: &DoubleDouble| match value.low() {
            0.0 => Guarded::<Wide<LIMBS>>::from_f64(value.high()),
            low => Guarded::from_f64(value.high()) + Guarded::from_f64(low),
        };
        let arguments: Vec<_> = self.arguments.iter().map(exact).collect();
        let is_last = LIMBS >= self.most;
        let rounding = (self.rounding, if is_last { rounding::LEAST_SLACK } else { 0.0 });
        take(&self.computation.values(&arguments), Tier::Words(LIMBS as u16), rounding, slots) || is_last
    }
}
