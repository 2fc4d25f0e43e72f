//! Arguments of every size, including the neighbours of powers of two, where the spacing of
//! floating-point numbers changes.

use proptest::prelude::Rng;
use proptest::test_runner::{RngAlgorithm, TestRng};

/// Reproducible random choices: the same number gives the same choices.
pub(crate) struct Dice(TestRng);

impl Dice {
    pub(crate) fn of(number: u64) -> Self {
        let mut seed = [0; 32];
        seed[..8].copy_from_slice(&number.to_le_bytes());
        Dice(TestRng::from_seed(RngAlgorithm::ChaCha, &seed))
    }

    /// Returns a number below the limit.
    pub(crate) fn below(&mut self, limit: u64) -> u64 {
        self.0.next_u64() % limit
    }

    /// Returns 0, ±1/4, ±1/2, ±1, ±2, ± a power of ten from 1e-320 to 1e308, or a neighbour of one
    /// of these.
    pub(crate) fn argument(&mut self) -> f64 {
        let size = match self.below(8) {
            0 => 0.0,
            1 => 0.25,
            2 => 0.5,
            3 => 1.0,
            4 => 2.0,
            _ => format!("1e{}", self.below(629) as i64 - 320).parse().expect("a number"),
        };
        let size: f64 = match self.below(6) {
            0 => f64::next_up(size),
            1 => f64::next_down(size),
            _ => size,
        };
        if self.below(2) == 0 { size } else { -size }
    }
}
