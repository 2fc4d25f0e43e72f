//! Common denominators: the parts into which angles and exponents are divided.

use super::generator::Quantity;
use super::power::FactorPower;
use rustc_hash::FxHashMap;

/// Numbers of parts into which the quantities of angles and exponents are divided.
#[derive(Clone, Debug, Default)]
pub(super) struct Denominators {
    /// Number of parts of each angle.
    pub(super) of_angles: FxHashMap<Quantity, u32>,
    /// Number of parts of each exponent.
    pub(super) of_exponents: FxHashMap<Quantity, u32>,
    /// Common denominator of all exponents.
    pub(super) of_all_exponents: Vec<FactorPower>,
}
