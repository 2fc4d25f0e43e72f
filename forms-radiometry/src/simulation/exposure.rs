//! Exposure: what arrives in a time under light that does not change.
//!
//! ```text
//! H = ∫ E dt = E t        radiant exposure of a surface, J/m², of its irradiance
//! Ψ = ∫ φ dt = φ t        radiant fluence at a point, J/m², of its fluence rate
//! ```
//! A factor that is exact: the error grows with the value, and by the rounding of one product.

use super::answer::{Answer, Quantity, Simulation};
use crate::scene::{Scene, SceneError};
use std::fmt;

/// A time of exposure, above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    seconds: f64,
}

/// The shortest and the longest time in seconds: far beyond what anybody waits for, and not so far that a rate times it is
/// beyond all numbers.
const TIMES: [f64; 2] = [1e-30, 1e30];

/// A number that is no time of exposure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoTime(pub f64);

impl fmt::Display for NoTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [least, most] = TIMES;
        write!(
            f,
            "{:?} is no time of exposure: expected a number of seconds from {least:e} to {most:e}",
            self.0
        )
    }
}

impl std::error::Error for NoTime {}

impl Exposure {
    /// The exposure over so many seconds.
    pub fn new(seconds: f64) -> Result<Self, NoTime> {
        if (TIMES[0]..=TIMES[1]).contains(&seconds) { Ok(Self { seconds }) } else { Err(NoTime(seconds)) }
    }

    /// How many seconds it lasts.
    pub fn seconds(self) -> f64 {
        self.seconds
    }

    /// Whether the light of a scene is steady: receivers that are resolved in time ask for that of a pulse.
    ///
    /// # Errors
    /// Each of these receivers.
    pub fn check(self, scene: &Scene) -> Result<(), Vec<SceneError>> {
        let error = |receiver: &crate::scene::Receiver| {
            let time = receiver.time.as_ref()?;
            let message = format!(
                "the receiver `{}` is resolved in time: what lights send then is a pulse, which has no exposure over {} s",
                receiver.name, self.seconds
            );
            Some(SceneError::new(&time.place, message, "a receiver without `time`, or no exposure"))
        };
        let errors: Vec<SceneError> = scene.receivers.iter().filter_map(error).collect();
        if errors.is_empty() { Ok(()) } else { Err(errors) }
    }

    /// Adds to a simulation the exposure behind every irradiance, and the fluence behind every fluence rate.
    pub fn add_to(self, simulation: &mut Simulation) {
        let is_together = |a: &Answer, b: &Answer| a.receiver == b.receiver && a.quantity == b.quantity;
        let mut answers = Vec::with_capacity(2 * simulation.answers.len());
        for bands in simulation.answers.chunk_by(is_together) {
            answers.extend_from_slice(bands);
            answers.extend(bands.iter().filter_map(|answer| self.of(answer)));
        }
        simulation.answers = answers;
    }

    /// What a rate adds up to, if that has a name.
    fn of(self, rate: &Answer) -> Option<Answer> {
        let quantity = match rate.quantity {
            Quantity::Irradiance => Quantity::Exposure,
            Quantity::FluenceRate => Quantity::Fluence,
            _ => return None,
        };
        // a product takes no time
        let mut sum = Answer { quantity, seconds: 0.0, ..rate.clone() };
        sum.multiply(self.seconds);
        Some(sum)
    }
}
