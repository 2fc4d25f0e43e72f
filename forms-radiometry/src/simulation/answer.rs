//! Results of a simulation: the plan, and values with their errors.

use super::parts::ErrorParts;
use crate::radiosity::UsedKernel;
use crate::scene::Effect;
use serde::{Deserialize, Serialize};

/// Decision about the effects that are simulated.
#[derive(Clone, Debug)]
pub struct Plan {
    /// All effects, in the order of [`Effect::ALL`].
    pub effects: Vec<PlannedEffect>,
    /// Kernels that the simulation runs with these effects.
    pub kernels: Vec<UsedKernel>,
    /// Error budget spent on omitted effects: the largest change of an answer, relative to it, by
    /// all effects that were omitted because they matter less than the tolerance.
    pub dropped: f64,
}

/// Decision of a plan about one effect.
#[derive(Clone, Debug)]
pub struct PlannedEffect {
    /// The effect.
    pub effect: Effect,
    /// Whether it is simulated.
    pub on: bool,
    /// Number of orders that are simulated; all orders if `None`.
    pub orders: Option<u32>,
    /// Reason: the trigger in the scene, or that there is no trigger.
    pub why: String,
    /// Largest change of an answer, in the answer's unit, by omitting the effect or its higher
    /// orders; `None` where no bound is known.
    pub bound: Option<f64>,
}

/// Measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Quantity {
    /// Power per area, W/m²; for a surface, its mean.
    Irradiance,
    /// Power that arrives at a surface, W.
    Flux,
    /// Power per area and solid angle, W/(m² sr).
    Radiance,
    /// The integral of radiance over all directions, W/m².
    FluenceRate,
    /// A component of the integral of radiance times direction of travel, W/m²: 0, 1 or 2 for x, y
    /// or z.
    VectorIrradiance(usize),
    /// Energy per area that arrives during an exposure, J/m²; for a surface, its mean.
    Exposure,
    /// Fluence rate integrated over an exposure, J/m².
    Fluence,
}

/// Meaning of an error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ErrorKind {
    /// Rigorous bound. Closed forms leave only rounding.
    Bound,
    /// Extrapolated from the convergence of the values: hardly ever exceeded, and not by much.
    Estimate,
    /// Half width of the Student interval of the samples, which contains the value with the
    /// probability [`ErrorKind::LEVEL`].
    Confidence,
    /// One standard error.
    Sigma,
}

/// One requested number.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The receiver's name.
    pub receiver: String,
    /// Measured quantity.
    pub quantity: Quantity,
    /// The band, counted from 0; `None` where the scene has a single band.
    pub band: Option<usize>,
    /// The time bin, counted from 0; `None` where the receiver is not resolved in time.
    pub bin: Option<usize>,
    /// The value.
    pub value: f64,
    /// Its error, in the same unit.
    pub error: f64,
    /// Error budget: its parts combine to the error by [`ErrorParts::error`].
    pub parts: ErrorParts,
    /// Meaning of the error.
    pub kind: ErrorKind,
    /// Time spent on this answer, in seconds: the time of its receiver, divided evenly among the
    /// receiver's answers. Work shared by all receivers is not included
    /// ([`Simulation::shared_seconds`]).
    pub seconds: f64,
}

/// Irradiance of a surface, cell by cell, or radiance seen by a camera, pixel by pixel.
///
/// The cells divide the bounding rectangle of the polygon in its plane. The first axis of the
/// rectangle is the polygon's first edge: columns follow each other along that edge, and rows away
/// from it. A cell outside the polygon holds NaN, and so does a cell that was not reached before
/// the work was stopped. Pixels follow each other row by row from the upper left of the picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Map {
    /// The receiver's name.
    pub receiver: String,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Number of cells along each side, [columns, rows].
    pub size: [usize; 2],
    /// Value of each cell for each band, row by row.
    pub values: Vec<Vec<f64>>,
    /// Error of each cell for each band, row by row.
    pub errors: Vec<Vec<f64>>,
    /// Scale of the tolerance for each band. The error of a cell is relative to the larger of this
    /// scale and the cell's own value. The scale is the mean over all cells that have a value; for
    /// an image, it is the mean over the pixels that see no emitter directly. Where those pixels
    /// are dark, or there are none, it is the mean over all pixels. The path tracer uses a lower
    /// estimate of that mean from pilot samples: within a tenth of it once the pilot has settled,
    /// and never below half of it. Where the pilot finds no light, the scale is the brightest
    /// light.
    pub scales: Vec<f64>,
    /// Meaning of these errors.
    pub kind: ErrorKind,
    /// Whether it is the view of a camera, whose first row is the upper one.
    pub is_image: bool,
}

/// Accuracy of the answers at one time of the work.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moment {
    /// Seconds since the work began.
    pub seconds: f64,
    /// Largest error of an answer, a cell or a pixel, relative to its scale (for cells and pixels
    /// see [`Map::scales`]).
    pub error: f64,
}

/// Results of a simulation.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Simulation {
    /// The numbers, in the order of the receivers, then of the quantities, then of the bands. The
    /// mean of a map is one of them.
    pub answers: Vec<Answer>,
    /// The maps and images, in the order of the receivers.
    pub maps: Vec<Map>,
    /// Convergence: the error as a function of time.
    pub history: Vec<Moment>,
    /// Time of the work in seconds, including earlier runs that it was continued from; for merged
    /// shards, the sum.
    pub seconds: f64,
    /// Whether the work was stopped before it was done. Receivers may then be missing, or be less
    /// accurate than requested.
    pub stopped: bool,
}

impl Quantity {
    /// Returns its name, as in the program's output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Irradiance => "irradiance",
            Self::Flux => "flux",
            Self::Radiance => "radiance",
            Self::FluenceRate => "fluence_rate",
            Self::VectorIrradiance(0) => "vector_irradiance_x",
            Self::VectorIrradiance(1) => "vector_irradiance_y",
            Self::VectorIrradiance(_) => "vector_irradiance_z",
            Self::Exposure => "exposure",
            Self::Fluence => "fluence",
        }
    }

    /// Returns its unit.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Irradiance | Self::FluenceRate | Self::VectorIrradiance(_) => "W/m²",
            Self::Flux => "W",
            Self::Radiance => "W/(m² sr)",
            Self::Exposure | Self::Fluence => "J/m²",
        }
    }
}

impl Simulation {
    /// Returns the time of the work shared by all receivers, in seconds. Together with the times of
    /// all answers it is the time of the whole work.
    pub fn shared_seconds(&self) -> f64 {
        let of_answers: f64 = self.answers.iter().map(|answer| answer.seconds).sum();
        (self.seconds - of_answers).max(0.0)
    }
}

impl Answer {
    /// Returns the unit of the value. For a receiver that is resolved in time, lights send a pulse,
    /// and energy replaces power.
    pub fn unit(&self) -> &'static str {
        match (self.bin, self.quantity.unit()) {
            (Some(_), "W") => "J",
            (Some(_), "W/m²") => "J/m²",
            (Some(_), "W/(m² sr)") => "J/(m² sr)",
            (_, unit) => unit,
        }
    }
}

impl ErrorKind {
    /// Returns its name, as in the program's output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Confidence => "confidence",
            Self::Sigma => "sigma",
        }
    }

    /// Confidence level: the probability that the value lies within an error of the kind
    /// [`ErrorKind::Confidence`].
    pub const LEVEL: f64 = 0.9999;

    /// Returns its label, printed next to an error.
    pub fn words(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Confidence => "99.99 %",
            Self::Sigma => "1 σ",
        }
    }

    /// Returns the kind of the sum of an error of this kind and an estimate.
    pub(super) fn with_estimate(self) -> Self {
        if self == Self::Bound { Self::Estimate } else { self }
    }
}
