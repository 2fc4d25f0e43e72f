//! Quantities of receivers, their names and units.

use serde::{Deserialize, Serialize};

/// Measured quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Quantity {
    /// Power per area, W/m²; for a surface, its mean.
    Irradiance,
    /// Power that arrives at a surface, W.
    Flux,
    /// Power that a surface absorbs less the power that it emits, W: A ((1 − ρ) E − M).
    NetFlux,
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

impl Quantity {
    /// The quantities of a receiver without a normal, in the order of its answers.
    pub(crate) const ALL_AROUND: [Self; 4] =
        [Self::FluenceRate, Self::VectorIrradiance(0), Self::VectorIrradiance(1), Self::VectorIrradiance(2)];

    /// Returns its name, as in the program's output.
    pub fn name(self) -> &'static str {
        match self {
            Self::Irradiance => "irradiance",
            Self::Flux => "flux",
            Self::NetFlux => "net_flux",
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
            Self::Flux | Self::NetFlux => "W",
            Self::Radiance => "W/(m² sr)",
            Self::Exposure | Self::Fluence => "J/m²",
        }
    }
}
