//! Results of a simulation: values with their errors.

use super::error_budget::ErrorParts;
use super::error_kind::ErrorKind;
use super::quantity::Quantity;
use serde::{Deserialize, Serialize};

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

/// Irradiance of a surface, cell by cell, radiance seen by a camera, pixel by pixel, or numbers at
/// points or on faces, one by one. A cell that was not reached before the work was stopped holds
/// NaN.
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
    /// Arrangement of the cells.
    pub layout: Layout,
}

/// Arrangement of the cells of a map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Layout {
    /// Cells of a rectangle, whose first row is the lowest. On a surface it is the bounding
    /// rectangle of the polygon in its plane: columns follow each other along the polygon's first
    /// edge, and rows away from it. A cell outside the polygon holds NaN.
    Grid,
    /// Pixels of a camera, row by row from the upper left.
    Image,
    /// Points or faces, in a single row.
    List,
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
    /// The maps and images, in the order of the receivers. A receiver has one for each quantity of
    /// its cells.
    pub maps: Vec<Map>,
    /// Convergence: the error as a function of time.
    pub history: Vec<Moment>,
    /// Time of the work in seconds, including earlier runs that it was continued from; for merged
    /// shards, the sum.
    pub seconds: f64,
    /// The brightest light that the sources of the scene send to a receiver: an irradiance. Numbers
    /// far below it are dark, and their errors are not judged by their own size.
    pub brightest: f64,
    /// Whether the work was stopped before it was done. Receivers may then be missing, or be less
    /// accurate than requested.
    pub stopped: bool,
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
