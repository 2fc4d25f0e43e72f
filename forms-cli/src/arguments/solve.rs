//! Options that replace what a scene says of its solution, and the number of threads. Their values
//! are those of `[solve]` of a scene file.

use clap::Args;
use forms_radiometry::scene::{EffectList, Overrides};

/// The most threads: more than any processor has.
const MOST_THREADS: usize = 4096;

/// The options of a simulation.
#[derive(Clone, Debug, Args)]
pub(crate) struct SolveArguments {
    /// Work to this error, relative to each answer, whatever the scene says
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = Overrides::tolerance)]
    tolerance: Option<f64>,
    /// Begin random numbers with this seed, whatever the scene says
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = Overrides::seed)]
    seed: Option<u64>,
    /// Turn effects on or off, or limit them to a number of orders, whatever the scene says:
    /// interreflection=2,occlusion=off
    #[arg(long, value_name = "EFFECT=on|off|ORDERS,…")]
    effects: Option<EffectList>,
}

/// The option of the number of threads.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct ThreadArguments {
    /// Compute with this many threads instead of one for each processor; answers are the same with
    /// any number
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<usize>,
}

impl SolveArguments {
    /// What replaces the settings of a scene.
    pub(crate) fn overrides(&self) -> Overrides {
        Overrides { tolerance: self.tolerance, seed: self.seed, effects: self.effects.clone() }
    }
}

impl ThreadArguments {
    /// Makes that many threads, if a number was given. The message says why that is not possible.
    pub(crate) fn make(self) -> Result<(), String> {
        let Some(threads) = self.threads else { return Ok(()) };
        let made = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        made.map_err(|error| format!("{threads} threads cannot be made: {error}"))
    }
}

/// A number of threads.
fn threads(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| (1..=MOST_THREADS).contains(count));
    count.ok_or_else(|| format!("expected a whole number from 1 to {MOST_THREADS}"))
}
