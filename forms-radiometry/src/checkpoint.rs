//! Checkpoints of running simulations: what they can tell and write, and who keeps them.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Write};

/// Content of a checkpoint.
pub(crate) trait Content {
    /// Whether all work is done.
    fn is_done(&self) -> bool;

    /// Returns the number of units of work in the shard, and in all shards.
    fn units(&self) -> [usize; 2];

    /// Writes the content, every number with all its bits.
    fn write(&self, output: &mut dyn Write) -> io::Result<()>;
}

/// State of a simulation at some time, to be written.
pub struct Snapshot<'w>(pub(crate) &'w dyn Content);

impl Snapshot<'_> {
    /// Whether all work is done.
    pub fn is_done(&self) -> bool {
        self.0.is_done()
    }

    /// Returns the number of units of work in the shard, and in all shards. Units are numbers,
    /// cells and pixels, or with a budget their replicates. Work as a whole is a single unit.
    pub fn units(&self) -> [usize; 2] {
        self.0.units()
    }

    /// Writes the state, every number with all its bits.
    pub fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        self.0.write(output)
    }
}

/// Keeper of the checkpoints of a running simulation. Called from several threads.
pub trait Keeper: Sync {
    /// Whether it is time to keep a checkpoint.
    fn is_due(&self) -> bool;

    /// Keeps a checkpoint. Called before the work, whenever one is due, and at the end.
    fn keep(&self, snapshot: &Snapshot<'_>);
}

/// Content of a checkpoint by its kind, as it is written and read.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(crate) enum Kind<P, W> {
    /// Path tracing: sums and numbers of samples.
    Paths(P),
    /// Solved as a whole: the result, or nothing in a shard without it.
    Whole(W),
}

impl<P: Serialize, W: Serialize> Kind<P, W> {
    /// Writes a checkpoint.
    pub(crate) fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        postcard::to_io(self, output).map(|_| ()).map_err(io::Error::other)
    }
}

/// Error: the state belongs to another simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misfit;

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the checkpoint belongs to another simulation")
    }
}

impl std::error::Error for Misfit {}
