//! Arithmetic: the properties of a machine that determine the last bits of its answers.
//!
//! ```text
//! vector instructions ─ kernel loops over rows are compiled for several sets; the best is chosen
//! functions           ─ sin, exp, … round differently between libraries and between processors
//! ```
//! Sums, products, quotients and square roots are rounded identically everywhere. Implementations
//! of the functions are distinguished by their values at many points.

use crate::sampling::Random;
use forms::math::Instructions;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::hint::black_box;

/// Number of points at which each function is evaluated.
const PLACES: usize = 1 << 12;

/// Instructions and functions that a simulation runs with.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Arithmetic {
    processor: String,
    instructions: String,
    functions: u64,
}

impl Arithmetic {
    /// Returns the arithmetic of this machine, with the chosen instructions.
    pub fn here() -> Self {
        Self {
            processor: std::env::consts::ARCH.to_owned(),
            instructions: Instructions::best().name().to_owned(),
            functions: functions(),
        }
    }
}

impl fmt::Display for Arithmetic {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}, functions {:08x}", self.processor, self.instructions, self.functions as u32)
    }
}

/// Returns a hash of the bits of all functions at all points.
fn functions() -> u64 {
    let mut random = Random::new(0);
    let mut hash = blake3::Hasher::new();
    for _ in 0..PLACES {
        let (u, v) = (black_box(random.next()), black_box(random.next()));
        let (x, y) = (20.0 * u - 10.0, v);
        let values = [
            x.sin(),
            x.cos(),
            x.tan(),
            x.exp(),
            x.exp_m1(),
            x.sinh(),
            x.cosh(),
            x.tanh(),
            u.ln(),
            u.ln_1p(),
            u.asin(),
            u.acos(),
            x.atan(),
            x.atan2(y),
            u.powf(x),
            x.hypot(y),
        ];
        values.iter().for_each(|value| {
            hash.update(&value.to_bits().to_le_bytes());
        });
    }
    let digest = hash.finalize();
    digest.as_bytes().iter().take(8).fold(0, |number, &byte| number << 8 | u64::from(byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_arithmetic_of_a_machine_is_the_same_each_time() {
        assert_eq!(Arithmetic::here(), Arithmetic::here());
    }
}
