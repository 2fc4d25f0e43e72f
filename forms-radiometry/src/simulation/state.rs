//! Checkpoints: the state of a simulation, from which the same work continues, and from which
//! shards are merged.
//!
//! ```text
//! path tracing        sums and numbers of samples
//! solved as a whole   the result, or nothing in a shard without it
//! ```

use super::followed::{OfPaths, Work, WrittenOfPaths};
use crate::answer::Simulation;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Write};

/// State of a simulation at some time, to be written.
pub struct Snapshot<'w>(pub(super) Of<'w>);

/// Content of a snapshot.
pub(super) enum Of<'w> {
    Paths(&'w Work<'w>),
    /// At the end of the work.
    Whole(Option<&'w Simulation>),
}

/// State that was written before.
#[derive(Clone, Debug, Deserialize)]
pub struct State(Kept);

#[derive(Clone, Debug, Deserialize)]
enum Kept {
    Paths(OfPaths),
    Whole(Option<Simulation>),
}

/// Serialised form of a [`Kept`].
#[derive(Serialize)]
enum Written<'w> {
    Paths(WrittenOfPaths<'w>),
    Whole(Option<&'w Simulation>),
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

impl Snapshot<'_> {
    /// Whether all work is done.
    pub fn is_done(&self) -> bool {
        match &self.0 {
            Of::Paths(work) => work.is_done(),
            Of::Whole(_) => true,
        }
    }

    /// Returns the number of units of work in the shard, and in all shards. Units are numbers,
    /// cells and pixels, or with a budget their replicates. Work as a whole is a single unit.
    pub fn units(&self) -> [usize; 2] {
        match &self.0 {
            Of::Paths(work) => work.units(),
            Of::Whole(found) => [usize::from(found.is_some()), 1],
        }
    }

    /// Writes the state, every number with all its bits.
    pub fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        let written = match &self.0 {
            Of::Paths(work) => Written::Paths(work.written()),
            Of::Whole(found) => Written::Whole(*found),
        };
        postcard::to_io(&written, output).map(|_| ()).map_err(io::Error::other)
    }
}

impl State {
    /// Reads a state that was written; `None` if the bytes are not a state.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        postcard::take_from_bytes(bytes).ok().filter(|(_, rest)| rest.is_empty()).map(|(kept, _)| Self(kept))
    }

    /// Whether all work is done.
    pub fn is_done(&self) -> bool {
        match &self.0 {
            Kept::Paths(state) => state.is_done(),
            Kept::Whole(_) => true,
        }
    }

    /// Whether two states are equal, except for times.
    pub fn is_same_as(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Kept::Paths(own), Kept::Paths(other)) => own.is_same_as(other),
            (Kept::Whole(own), Kept::Whole(other)) => timeless(own) == timeless(other),
            _ => false,
        }
    }

    /// Returns the state of the path driver, if it is one.
    pub(super) fn of_paths(self) -> Option<OfPaths> {
        match self.0 {
            Kept::Paths(state) => Some(state),
            Kept::Whole(_) => None,
        }
    }

    /// Returns the result of a scene that is solved as a whole, if it is the state of one.
    pub(super) fn of_whole(self) -> Option<Option<Simulation>> {
        match self.0 {
            Kept::Paths(_) => None,
            Kept::Whole(found) => Some(found),
        }
    }
}

/// Returns the bytes of a result without its times. Bytes are compared because cells outside their
/// surface hold NaN, which equals nothing.
fn timeless(found: &Option<Simulation>) -> Option<Vec<u8>> {
    let mut found = found.clone()?;
    found.history.clear();
    found.seconds = 0.0;
    found.answers.iter_mut().for_each(|answer| answer.seconds = 0.0);
    postcard::to_stdvec(&found).ok()
}
