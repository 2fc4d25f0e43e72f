//! Exposure: irradiance and fluence rate of constant light become their integrals over a time.
//!
//! ```text
//! H = ∫ E dt = E t        radiant exposure of a surface, J/m², of its irradiance
//! Ψ = ∫ φ dt = φ t        radiant fluence at a point, J/m², of its fluence rate
//! ```
//! The factor is exact. The error grows with the value, and by the rounding of one product.

use super::quantity::Quantity;
use super::results::{Answer, Simulation};
use crate::scene::{Scene, SceneError};
use std::fmt;

/// Exposure time, above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    seconds: f64,
}

/// Shortest and longest exposure time in seconds: far beyond any practical time, but a rate times
/// it stays in the range of numbers.
const TIMES: [f64; 2] = [1e-30, 1e30];

/// Number that is not an exposure time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NoTime(pub f64);

impl fmt::Display for NoTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [least, most] = TIMES;
        write!(
            f,
            "{:?} is not an exposure time: expected a number of seconds from {least:e} to {most:e}",
            self.0
        )
    }
}

impl std::error::Error for NoTime {}

impl Exposure {
    /// Creates an exposure of this many seconds.
    pub fn new(seconds: f64) -> Result<Self, NoTime> {
        if (TIMES[0]..=TIMES[1]).contains(&seconds) { Ok(Self { seconds }) } else { Err(NoTime(seconds)) }
    }

    /// Returns its duration in seconds.
    pub fn seconds(self) -> f64 {
        self.seconds
    }

    /// Checks that the light of a scene is steady: receivers that are resolved in time measure the
    /// light of a pulse.
    ///
    /// # Errors
    /// One error for each of these receivers.
    pub fn check(self, scene: &Scene) -> Result<(), Vec<SceneError>> {
        let error = |receiver: &crate::scene::Receiver| {
            let time = receiver.time.as_ref()?;
            let message = format!(
                "the receiver `{}` is time-resolved: lights then emit a pulse, whose exposure \
                 over {} s is undefined",
                receiver.name, self.seconds
            );
            Some(SceneError::new(&time.place, message, "a receiver without `time`, or no exposure"))
        };
        let errors: Vec<SceneError> = scene.receivers.iter().filter_map(error).collect();
        if errors.is_empty() { Ok(()) } else { Err(errors) }
    }

    /// Adds to a simulation the exposure after every irradiance, and the fluence after every
    /// fluence rate.
    pub fn add_to(self, simulation: &mut Simulation) {
        let is_together = |a: &Answer, b: &Answer| a.receiver == b.receiver && a.quantity == b.quantity;
        let mut answers = Vec::with_capacity(2 * simulation.answers.len());
        for bands in simulation.answers.chunk_by(is_together) {
            answers.extend_from_slice(bands);
            answers.extend(bands.iter().filter_map(|answer| self.of(answer)));
        }
        simulation.answers = answers;
    }

    /// Returns the time integral of a rate, if that integral has a name.
    fn of(self, rate: &Answer) -> Option<Answer> {
        let quantity = match rate.quantity {
            Quantity::Irradiance => Quantity::Exposure,
            Quantity::FluenceRate => Quantity::Fluence,
            _ => return None,
        };
        // the product costs no time
        let mut sum = Answer { quantity, seconds: 0.0, ..rate.clone() };
        sum.multiply(self.seconds);
        Some(sum)
    }
}
