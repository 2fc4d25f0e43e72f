//! A kernel in as much precision as its arguments need for the accuracy promised.
//!
//! ```text
//! Guarded<f64> ─▶ Guarded<DoubleDouble> ─▶ Guarded<Wide<4>> ─▶ <8> ─▶ <16>
//!       └─ each output from the first that bounds its error well enough
//! ```
//! Results of two words begin with the second ([`double_double`]).

mod double_double;

pub use double_double::{escalate_double_double, escalate_double_double_computation};

use crate::guarded::{Bound, Guardable, Guarded};
use crate::{DoubleDouble, Formula, Real, Wide};

/// The precision that an output was taken from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Tier {
    /// `f64`
    Double,
    /// 106 bits
    DoubleDouble,
    /// 256 bits
    Words4,
    /// 512 bits
    Words8,
    /// 1024 bits
    Words16,
    /// 1024 bits, which did not bound its error well enough.
    Undecided,
}

/// The outputs within `within` · 2⁻⁵³ of their exact values, relative to them; below 2⁻¹⁰²² within as much of 2⁻¹⁰²².
///
/// Rounding to `f64` takes 2⁻⁵³ of that, so that `within` is at least 1. NaN where a formula is not defined. An output
/// whose error no precision bounds well enough is that of the widest, and zero where that may as well be zero.
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
/// ```
pub fn escalate<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [f64; O] {
    escalate_with_tier::<F, A, O>(arguments, within).map(|(value, _)| value)
}

/// The same, with the precision that each output was taken from.
pub fn escalate_with_tier<F: Formula<A, O>, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
) -> [(f64, Tier); O] {
    let mut outputs = [(f64::NAN, Tier::Undecided); O];
    let _ = take::<F, f64, A, O>(arguments, within, Tier::Double, &mut outputs)
        || take::<F, DoubleDouble, A, O>(arguments, within, Tier::DoubleDouble, &mut outputs)
        || take::<F, Wide<4>, A, O>(arguments, within, Tier::Words4, &mut outputs)
        || take::<F, Wide<8>, A, O>(arguments, within, Tier::Words8, &mut outputs)
        || take::<F, Wide<16>, A, O>(arguments, within, Tier::Words16, &mut outputs);
    outputs
}

/// Computes in guarded `T` what is still open; true where nothing is left.
fn take<F: Formula<A, O>, T: Guardable, const A: usize, const O: usize>(
    arguments: [f64; A],
    within: f64,
    tier: Tier,
    outputs: &mut [(f64, Tier); O],
) -> bool {
    settle(&F::value(arguments.map(Guarded::<T>::from_f64)), within, tier, outputs)
}

/// What can be computed in numbers of every kind: a formula known when the program runs.
pub trait Computation {
    /// The outputs in one kind of number.
    fn values<T: Real>(&self, arguments: &[T]) -> Vec<T>;
}

/// [`escalate`] of a computation with so many outputs.
pub fn escalate_computation(
    computation: &impl Computation,
    arguments: &[f64],
    outputs: usize,
    within: f64,
) -> Vec<f64> {
    fn take<T: Guardable>(
        computation: &impl Computation,
        arguments: &[f64],
        (within, tier): (f64, Tier),
        outputs: &mut [(f64, Tier)],
    ) -> bool {
        let arguments: Vec<Guarded<T>> = arguments.iter().map(|&value| Guarded::from_f64(value)).collect();
        settle(&computation.values(&arguments), within, tier, outputs)
    }
    let mut found = vec![(f64::NAN, Tier::Undecided); outputs];
    let _ = take::<f64>(computation, arguments, (within, Tier::Double), &mut found)
        || take::<DoubleDouble>(computation, arguments, (within, Tier::DoubleDouble), &mut found)
        || take::<Wide<4>>(computation, arguments, (within, Tier::Words4), &mut found)
        || take::<Wide<8>>(computation, arguments, (within, Tier::Words8), &mut found)
        || take::<Wide<16>>(computation, arguments, (within, Tier::Words16), &mut found);
    found.into_iter().map(|(value, _)| value).collect()
}

/// Takes of the values what is good enough of the outputs that are still open; true where none is left.
fn settle<T: Guardable>(values: &[Guarded<T>], within: f64, tier: Tier, outputs: &mut [(f64, Tier)]) -> bool {
    let units = if tier == Tier::Double { within } else { (within - 1.0).max(LEAST_SLACK) };
    for (output, &value) in outputs.iter_mut().zip(values) {
        if output.1 != Tier::Undecided {
            continue;
        }
        output.0 = if value.may_vanish() { 0.0 } else { value.to_f64() };
        if is_within(value, units) {
            output.1 = tier;
        }
    }
    outputs.iter().all(|(_, tier)| *tier != Tier::Undecided)
}

/// What is left for the error of a value in more precision where rounding it to `f64` takes all that is allowed.
const LEAST_SLACK: f64 = 1.0 / (1_u64 << 30) as f64;

fn is_within<T: Guardable>(value: Guarded<T>, units: f64) -> bool {
    if value.is_undefined() {
        return true;
    }
    let (number, error) = (value.value(), value.error());
    if number.is_nan() || !error.is_finite() {
        return false;
    }
    let scale = number.size_down().most(T::Bound::of(f64::MIN_POSITIVE));
    error <= T::Bound::of(units).shifted(-53).times_down(scale)
        || (error.is_zero() && number == T::from_f64(0.0))
}
