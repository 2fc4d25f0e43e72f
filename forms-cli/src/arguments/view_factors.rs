//! Arguments of `forms view-factors`.

use super::{ThreadArguments, TimeArguments};
use clap::{Args, ValueEnum};
use forms_radiometry::scene::{Division, Overrides};
use forms_radiometry::simulation::Share;

#[derive(Debug, Args)]
pub(crate) struct ViewFactorArguments {
    /// A scene, in TOML or in the formats of Mitsuba 3 (.xml) and View3D (.vs3)
    pub(crate) scene: String,
    /// Error tolerance, relative to each factor, or to the mean of the surfaces that a surface sees
    /// where that is larger; overrides the scene
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = Overrides::tolerance)]
    pub(crate) tolerance: Option<f64>,
    /// Seed of the rays; overrides the scene
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = Overrides::seed)]
    pub(crate) seed: Option<u64>,
    /// Unit of a row: surfaces, the groups that mesh files name, or the faces of meshes
    #[arg(long, value_name = "WHAT", value_enum, default_value_t = By::Surface)]
    pub(crate) by: By,
    /// Print one line for each pair with a factor above zero: from, to, factor, error
    #[arg(long, conflicts_with = "json")]
    pub(crate) sparse: bool,
    /// Compute every n-th row, beginning with the i-th, i from 1 to n or from 0 to n − 1
    #[arg(long, value_name = "i/n")]
    pub(crate) shard: Option<Share>,
    /// Save each row in this file when it is complete, and resume from it if it exists
    #[arg(long, value_name = "FILE")]
    pub(crate) checkpoint: Option<String>,
    /// Change the factors of a closed scene so that each row sums to 1 and A1 F12 = A2 F21, and say
    /// by how much
    #[arg(long, conflicts_with = "shard")]
    pub(crate) enclose: bool,
    #[command(flatten)]
    pub(crate) time: TimeArguments,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    /// Print one JSON object per line, with the error of each factor
    #[arg(long)]
    pub(crate) json: bool,
}

/// Unit of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum By {
    Surface,
    Group,
    Face,
}

impl By {
    pub(crate) fn division(self) -> Division {
        match self {
            Self::Surface => Division::Surfaces,
            Self::Group => Division::Groups,
            Self::Face => Division::Faces,
        }
    }
}
