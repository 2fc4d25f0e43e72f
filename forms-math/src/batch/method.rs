//! How the rows of a batch are computed: in lanes, and again in one number where lanes give NaN.

use super::block::BLOCK;
use crate::lane::Bounded;
use crate::{Formula, Lane32, Lane64, Real, escalate};
use std::marker::PhantomData;
use std::ops::BitOr;

/// A number of a column.
pub(super) trait Element: Copy + Default + Send + Sync + 'static {
    /// A block of zeros.
    const ZEROS: &'static [Self; BLOCK];
    /// A whole number as wide as this, so that as many go into a vector.
    type Bits: Copy + Default + Eq + BitOr<Output = Self::Bits>;
    /// Whether this is NaN.
    fn is_nan(self) -> bool;
    /// All bits where this is NaN, none elsewhere.
    fn nan_bits(self) -> Self::Bits;
}

/// The rows of a batch.
pub(super) trait Method<E, const A: usize, const O: usize>: Copy + Send + Sync {
    /// Whether a NaN of lanes may be a number by the method in one number.
    const MAY_GIVE_UP: bool;
    /// A row in lanes.
    fn in_lanes<const FMA: bool>(self, arguments: [E; A]) -> [E; O];
    /// A row in one number.
    fn in_one_number(self, arguments: [E; A]) -> [E; O];
}

/// A formula as it is.
pub(super) struct Plain<F>(PhantomData<fn() -> F>);

/// A formula within so many units of 2⁻⁵³ of the exact value, relative to it.
pub(super) struct Within<F> {
    units: f64,
    formula: PhantomData<fn() -> F>,
}

impl<F> Plain<F> {
    /// The method.
    pub(super) fn new() -> Self {
        Self(PhantomData)
    }
}

impl<F> Within<F> {
    /// The method, with the units.
    pub(super) fn new(units: f64) -> Self {
        Self { units, formula: PhantomData }
    }
}

// Not derived: a derived copy asks for a copy of the formula.
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
        let mut lanes = [Bounded::<Lane64<FMA>>::nan(); A];
        for (lane, argument) in lanes.iter_mut().zip(arguments) {
            *lane = Bounded::lane(argument);
        }
        let mut values = [0.0; O];
        for (value, lane) in values.iter_mut().zip(F::value(lanes)) {
            *value = lane.value_within(self.units);
        }
        values
    }
    fn in_one_number(self, arguments: [f64; A]) -> [f64; O] {
        escalate::<F, A, O>(arguments, self.units)
    }
}
