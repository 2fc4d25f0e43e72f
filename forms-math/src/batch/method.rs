//! Evaluation of the rows of a batch: in lanes, and again as single numbers where lanes give NaN.

use crate::escalate::{beyond_lane, in_guarded_double};
use crate::lane::values_within;
use crate::{Formula, Lane32, Lane64, Real};
use core::marker::PhantomData;
use core::ops::BitOr;

/// Largest number of rows that are computed at once: the cost of starting a block is negligible
/// compared with theirs.
pub(super) const BLOCK: usize = 256;

/// Number of a column.
pub(super) trait Element: Copy + Default + Send + Sync + 'static {
    /// Block of zeros.
    const ZEROS: &'static [Self; BLOCK];
    /// Unsigned integer of the same width, so that a vector holds the same number of them.
    type Bits: Copy + Default + Eq + BitOr<Output = Self::Bits>;
    /// Whether this is NaN.
    fn is_nan(self) -> bool;
    /// Returns all bits set if this is NaN, else zero.
    fn nan_bits(self) -> Self::Bits;
}

/// Method that evaluates the rows of a batch.
pub(super) trait Method<E, const A: usize, const O: usize>: Copy + Send + Sync {
    /// Whether a NaN in lanes can be a number when computed as a single number.
    const MAY_GIVE_UP: bool;
    /// Evaluates a row in lanes.
    fn in_lanes<const FMA: bool>(self, arguments: [E; A]) -> [E; O];
    /// Evaluates a row as single numbers.
    fn in_one_number(self, arguments: [E; A]) -> [E; O];
}

/// Formula without error bounds.
pub(super) struct Plain<F>(PhantomData<fn() -> F>);

/// Formula within a relative error of this number of units of 2⁻⁵³.
pub(super) struct Within<F> {
    units: f64,
    formula: PhantomData<fn() -> F>,
}

impl<F> Plain<F> {
    /// Creates the method.
    pub(super) fn new() -> Self {
        Self(PhantomData)
    }
}

impl<F> Within<F> {
    /// Creates the method with these units.
    pub(super) fn new(units: f64) -> Self {
        Self { units, formula: PhantomData }
    }
}

// Not derived: a derived implementation would require the formula to be copyable.
impl<F> Clone for Plain<F> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<F> Copy for Plain<F> {}
impl<F> Clone for Within<F> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<F> Copy for Within<F> {}

macro_rules! element {
    ($raw:ident, $lane:ident, $bits:ident) => {
        impl Element for $raw {
            const ZEROS: &'static [Self; BLOCK] = &[0.0; BLOCK];
            type Bits = $bits;
            #[inline(always)]
            fn is_nan(self) -> bool {
                $raw::is_nan(self)
            }
            #[inline(always)]
            fn nan_bits(self) -> $bits {
                $bits::from(self.is_nan()).wrapping_neg()
            }
        }

        impl<F: Formula<A, O>, const A: usize, const O: usize> Method<$raw, A, O> for Plain<F> {
            const MAY_GIVE_UP: bool = F::MAY_GIVE_UP;
            #[inline(always)]
            fn in_lanes<const FMA: bool>(self, arguments: [$raw; A]) -> [$raw; O] {
                let mut lanes = [$lane::<FMA>::nan(); A];
                for (lane, argument) in lanes.iter_mut().zip(arguments) {
                    *lane = $lane(argument);
                }
                let mut values = [0.0; O];
                for (value, lane) in values.iter_mut().zip(F::value(lanes)) {
                    *value = lane.0;
                }
                values
            }
            fn in_one_number(self, arguments: [$raw; A]) -> [$raw; O] {
                F::value(arguments)
            }
        }
    };
}

element!(f64, Lane64, u64);
element!(f32, Lane32, u32);

impl<F: Formula<A, O>, const A: usize, const O: usize> Method<f64, A, O> for Within<F> {
    const MAY_GIVE_UP: bool = true;
    #[inline(always)]
    fn in_lanes<const FMA: bool>(self, arguments: [f64; A]) -> [f64; O] {
        values_within::<F, FMA, A, O>(arguments, self.units)
    }
    fn in_one_number(self, arguments: [f64; A]) -> [f64; O] {
        beyond_lane::<F, A, O>(arguments, self.units).map(|(value, _)| value)
    }
}

/// The same without more precision than that of `f64`: NaN where it does not bound the error sufficiently.
pub(super) struct WithinDouble<F>(pub(super) Within<F>);

impl<F> Clone for WithinDouble<F> {
    #[inline(always)]
    fn clone(&self) -> Self {
        *self
    }
}
impl<F> Copy for WithinDouble<F> {}

impl<F: Formula<A, O>, const A: usize, const O: usize> Method<f64, A, O> for WithinDouble<F> {
    const MAY_GIVE_UP: bool = true;
    #[inline(always)]
    fn in_lanes<const FMA: bool>(self, arguments: [f64; A]) -> [f64; O] {
        self.0.in_lanes::<FMA>(arguments)
    }
    fn in_one_number(self, arguments: [f64; A]) -> [f64; O] {
        in_guarded_double::<F, A, O>(arguments, self.0.units)
    }
}
