//! What a simulation says: the plan, and values with their errors.

use super::parts::ErrorParts;
use crate::radiosity::UsedKernel;
use crate::scene::Effect;
use serde::{Deserialize, Serialize};

/// Which effects are simulated.
#[derive(Clone, Debug)]
pub struct Plan {
    /// Every effect, in the order of [`Effect::ALL`].
    pub effects: Vec<PlannedEffect>,
    /// The kernels that the simulation runs with these effects.
    pub kernels: Vec<UsedKernel>,
    /// What all that was left out because it matters less than the tolerance can change in an answer, relative to it.
    pub dropped: f64,
}

/// What a plan decides about one effect.
#[derive(Clone, Debug)]
pub struct PlannedEffect {
    /// The effect.
    pub effect: Effect,
    /// Whether it is simulated.
    pub on: bool,
    /// How many orders of it are simulated; all, if none is said.
    pub orders: Option<u32>,
    /// Why: what in the scene triggers it, or that nothing does.
    pub why: String,
    /// What leaving it out, or its higher orders, can change in an answer, in the answer's unit; none where no bound is known.
    pub bound: Option<f64>,
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Quantity {
    /// Power per area, W/m²; of a surface its mean.
    Irradiance,
    /// Power that arrives at a surface, W.
    Flux,
    /// Power per area and solid angle, W/(m² sr).
    Radiance,
    /// The integral of radiance over all directions, W/m².
    FluenceRate,
    /// A component of the integral of radiance times direction of travel, W/m²: 0, 1 or 2 for x, y or z.
    VectorIrradiance(usize),
    /// Energy per area that arrives in a time, J/m²; of a surface its mean.
    Exposure,
    /// The fluence rate, over a time, J/m².
    Fluence,
}

/// What an error means.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum ErrorKind {
    /// A rigorous bound: closed forms leave only rounding.
    Bound,
    /// Extrapolated from how values settle: hardly ever exceeded, and not by much.
    Estimate,
    /// The half width of Student's interval of samples that holds the value with the probability [`ErrorKind::LEVEL`].
    Confidence,
    /// One standard error.
    Sigma,
}

/// One number that was asked for.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// The receiver's name.
    pub receiver: String,
    /// What was measured.
    pub quantity: Quantity,
    /// The band, from 0; none where the scene has a single one.
    pub band: Option<usize>,
    /// The bin of time, from 0; none where the receiver is not resolved in time.
    pub bin: Option<usize>,
    /// The value.
    pub value: f64,
    /// Its error, in the same unit.
    pub error: f64,
    /// What the error is made of: together these are the error, as [`ErrorParts::error`] says.
    pub parts: ErrorParts,
    /// What the error means.
    pub kind: ErrorKind,
    /// The part of the time of the work that it took, in seconds: that of its receiver, divided evenly among the answers of this.
    /// What all receivers share is not part of it ([`Simulation::shared_seconds`]).
    pub seconds: f64,
}

/// The irradiance of a surface, cell by cell, or the radiance that a camera sees, pixel by pixel.
///
/// The cells divide the bounding rectangle of the polygon in its plane, whose first axis is the polygon's first edge: columns
/// follow each other along that edge, and rows away from it. A cell outside of the polygon holds NaN, and so does one that was
/// not reached before the work was stopped. Pixels follow each other row by row from the upper left of the picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Map {
    /// The receiver's name.
    pub receiver: String,
    /// What was measured.
    pub quantity: Quantity,
    /// How many cells there are along each side, [columns, rows].
    pub size: [usize; 2],
    /// For each band the value of each cell, row by row.
    pub values: Vec<Vec<f64>>,
    /// For each band the error of each cell, row by row.
    pub errors: Vec<Vec<f64>>,
    /// For each band what the tolerance is relative to, of each cell at least its own value: the mean over all cells that have a value, of an
    /// image over the pixels in which no emitter is seen directly. Where these are dark, or there are none, the mean over all pixels. Work by
    /// paths takes a mean that its first samples tell, from below and within a tenth, and where these find no light the brightest one.
    pub scales: Vec<f64>,
    /// What these errors mean.
    pub kind: ErrorKind,
    /// Whether it is what a camera sees, so that the first row is the upper one.
    pub is_image: bool,
}

/// How exact the answers were at some time of the work.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moment {
    /// Seconds since the work began.
    pub seconds: f64,
    /// The largest error of an answer, a cell or a pixel, relative to it; of a cell or a pixel as [`Map::scales`] says.
    pub error: f64,
}

/// What was found.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct Simulation {
    /// The numbers, in the order of the receivers, then of quantities, then of bands. A map has its mean among them.
    pub answers: Vec<Answer>,
    /// The maps, in the order of the receivers.
    pub maps: Vec<Map>,
    /// How the error fell in time.
    pub history: Vec<Moment>,
    /// The time of the work, in seconds, with that of earlier runs that it was continued from; of shares that were merged the sum.
    pub seconds: f64,
    /// Whether the work was stopped before it was done: then receivers may be missing, or be less exact than was asked for.
    pub stopped: bool,
}

impl Quantity {
    /// Its name, as in the program's output.
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

    /// Its unit.
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
    /// The time of what all receivers share, in seconds: with the times of all answers it is that of the work.
    pub fn shared_seconds(&self) -> f64 {
        let of_answers: f64 = self.answers.iter().map(|answer| answer.seconds).sum();
        (self.seconds - of_answers).max(0.0)
    }
}

impl Answer {
    /// The unit of the value. Lights of receivers that are resolved in time send a pulse, whose energy takes the place of power.
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
    /// Its name, as in the program's output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Confidence => "confidence",
            Self::Sigma => "sigma",
        }
    }

    /// The probability that the value lies within an error of the kind [`ErrorKind::Confidence`].
    pub const LEVEL: f64 = 0.9999;

    /// What it means, beside an error.
    pub fn words(self) -> &'static str {
        match self {
            Self::Bound => "bound",
            Self::Estimate => "estimate",
            Self::Confidence => "99.99 %",
            Self::Sigma => "1 σ",
        }
    }

    /// The kind of an error of this kind and one that is an estimate together.
    pub(super) fn with_estimate(self) -> Self {
        if self == Self::Bound { Self::Estimate } else { self }
    }
}
