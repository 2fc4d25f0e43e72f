//! Options that override the solver settings of a scene, and the number of threads. Their values
//! have the format of `[solve]` in a scene file.

use clap::Args;
use forms_radiometry::scene::{EffectList, Overrides};
use std::time::{Duration, Instant};

/// Largest number of threads; no processor has more.
const MOST_THREADS: usize = 4096;

/// Options of a simulation.
#[derive(Clone, Debug, Args)]
pub(crate) struct SolveArguments {
    /// Error tolerance, relative to each answer; overrides the scene
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = Overrides::tolerance)]
    tolerance: Option<f64>,
    /// Seed of the random numbers; overrides the scene
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = Overrides::seed)]
    seed: Option<u64>,
    /// Turn effects on or off, or limit them to a number of orders, for example
    /// interreflection=2,occlusion=off; overrides the scene
    #[arg(long, value_name = "EFFECT=on|off|ORDERS,…")]
    effects: Option<EffectList>,
}

/// Option for the time of a run.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct TimeArguments {
    /// End after this time, from the start of the program, with the results so far and their errors
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = super::interval)]
    seconds: Option<Duration>,
}

/// Option for the number of threads.
#[derive(Clone, Copy, Debug, Args)]
pub(crate) struct ThreadArguments {
    /// Compute with this number of threads instead of one for each processor; answers do not depend
    /// on it
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = threads)]
    threads: Option<usize>,
}

impl SolveArguments {
    /// Returns the values that override the settings of a scene.
    pub(crate) fn overrides(&self) -> Overrides {
        Overrides { tolerance: self.tolerance, seed: self.seed, effects: self.effects.clone() }
    }
}

impl TimeArguments {
    /// Returns when a run that begins now ends, if its time is limited.
    pub(crate) fn deadline(self) -> Option<Instant> {
        self.seconds.and_then(|seconds| Instant::now().checked_add(seconds))
    }
}

impl ThreadArguments {
    /// Creates the threads, if a number was given. The error is a message with the reason.
    pub(crate) fn make(self) -> Result<(), String> {
        let Some(threads) = self.threads else { return Ok(()) };
        let made = rayon::ThreadPoolBuilder::new().num_threads(threads).build_global();
        made.map_err(|error| format!("cannot create {threads} threads: {error}"))
    }
}

/// Parses a number of threads.
fn threads(text: &str) -> Result<usize, String> {
    let count = text.parse().ok().filter(|count| (1..=MOST_THREADS).contains(count));
    count.ok_or_else(|| format!("expected an integer from 1 to {MOST_THREADS}"))
}
