//! Bases of radicands, their signs, and signs of products of them.

use crate::polynomial::Polynomial;

/// Factor of radicands: primitive, coprime to the others, not a constant unless a prime.
#[derive(Clone, Debug)]
pub struct Base {
    /// The factor.
    pub polynomial: Polynomial,
    /// The order of its root: the least common multiple of the orders that were needed.
    pub(super) order: u32,
    /// Whether finer factors have replaced it.
    pub(super) retired: bool,
    /// Its sign in the region considered, once the sign is known or assumed.
    pub sign: Option<Sign>,
    /// Whether its sign was needed.
    pub sign_needed: bool,
}

impl Base {
    /// Whether finer factors have replaced it.
    pub fn is_retired(&self) -> bool {
        self.retired
    }
}

/// Sign of a factor in a region, zero allowed: σ with σ g ≥ 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// g ≥ 0
    Positive,
    /// g ≤ 0
    Negative,
}

/// Sign of a product of a number and basis factors, with the factors that occur to an odd power.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SignConstraint {
    /// Whether the number is negative.
    pub negative: bool,
    /// The bases with an odd power.
    pub odd: Vec<usize>,
    /// The bases with any other power: they matter only where they vanish.
    pub other: Vec<usize>,
}
