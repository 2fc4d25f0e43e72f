//! Arguments of `forms simulate`.

use super::{SolveArguments, ThreadArguments, TimeArguments, budget, exposure, instructions, interval};
use clap::Args;
use forms::math::Instructions;
use forms_radiometry::simulation::{Budget, Exposure, Share};
use std::time::Duration;

#[derive(Debug, Args)]
pub(crate) struct SimulateArguments {
    /// A scene, in TOML or in the format of Mitsuba 3 (.xml)
    pub(crate) scene: String,
    /// Write results.csv, error.svg, and for each map an EXR and a PNG file into this folder;
    /// with --shard, write the part to this file
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<String>,
    /// Also write into the folder --out a .vtu file for each receiver of points, faces or maps, with
    /// its results on its geometry, and scene.vtu with all surfaces, for ParaView
    #[arg(long, requires = "out", conflicts_with = "shard")]
    pub(crate) vtu: bool,
    /// Save the state of the work in this file, and resume from it if it exists
    #[arg(long, value_name = "FILE")]
    pub(crate) checkpoint: Option<String>,
    /// Seconds between two saved states
    #[arg(long, value_name = "SECONDS", default_value = "10", value_parser = interval, requires = "checkpoint")]
    pub(crate) every: Duration,
    /// Compute the i-th of n shards of the work, i from 1 to n or from 0 to n − 1, and write it
    /// to the file --out
    #[arg(long, value_name = "i/n", requires = "out")]
    pub(crate) shard: Option<Share>,
    /// Take this number of samples, a multiple of 32, for each number, cell and pixel, instead
    /// of the number that the tolerance requires
    #[arg(long, value_name = "COUNT", value_parser = budget)]
    pub(crate) samples: Option<Budget>,
    /// Use these vector instructions instead of the best available ones; baseline gives the
    /// same bits on all processors of one architecture
    #[arg(long, value_name = "NAME", value_parser = instructions)]
    pub(crate) isa: Option<Instructions>,
    /// Also report the exposure for each irradiance, and the fluence for each fluence rate,
    /// over this time, in J/m²
    #[arg(long, value_name = "SECONDS", value_parser = exposure, allow_negative_numbers = true)]
    pub(crate) exposure: Option<Exposure>,
    #[command(flatten)]
    pub(crate) solve: SolveArguments,
    #[command(flatten)]
    pub(crate) time: TimeArguments,
    #[command(flatten)]
    pub(crate) threads: ThreadArguments,
    /// Print one JSON object per line
    #[arg(long)]
    pub(crate) json: bool,
}
