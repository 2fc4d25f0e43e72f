//! States: what is done of a simulation, which the same work goes on from, and shares are put together from.
//!
//! ```text
//! light along paths   sums and numbers of samples
//! solved as a whole   what was found, or nothing, in a share that has none of it
//! ```

use super::answer::Simulation;
use super::followed::{OfPaths, Work, WrittenOfPaths};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Write};

/// The state of a simulation at some time, to be written down.
pub struct Snapshot<'w>(pub(super) Of<'w>);

/// What a snapshot is of.
pub(super) enum Of<'w> {
    Paths(&'w Work<'w>),
    /// At its end.
    Whole(Option<&'w Simulation>),
}

/// A state that was written down.
#[derive(Clone, Debug, Deserialize)]
pub struct State(Kept);

#[derive(Clone, Debug, Deserialize)]
enum Kept {
    Paths(OfPaths),
    Whole(Option<Simulation>),
}

/// What a [`Kept`] is read from.
#[derive(Serialize)]
enum Written<'w> {
    Paths(WrittenOfPaths<'w>),
    Whole(Option<&'w Simulation>),
}

/// A state that is of another simulation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Misfit;

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "what was kept is of another simulation")
    }
}

impl std::error::Error for Misfit {}

impl Snapshot<'_> {
    /// Whether nothing is left to do.
    pub fn is_done(&self) -> bool {
        match &self.0 {
            Of::Paths(work) => work.is_done(),
            Of::Whole(_) => true,
        }
    }

    /// How many units of work the share has, and how many there are in all shares: numbers, cells and pixels, with a budget their
    /// replicates; of work as a whole a single one.
    pub fn units(&self) -> [usize; 2] {
        match &self.0 {
            Of::Paths(work) => work.units(),
            Of::Whole(found) => [usize::from(found.is_some()), 1],
        }
    }

    /// Writes the state down, every number with all its bits.
    pub fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        let written = match &self.0 {
            Of::Paths(work) => Written::Paths(work.written()),
            Of::Whole(found) => Written::Whole(*found),
        };
        postcard::to_io(&written, output).map(|_| ()).map_err(io::Error::other)
    }
}

impl State {
    /// The state that was written down; none if it cannot be understood.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        postcard::take_from_bytes(bytes).ok().filter(|(_, rest)| rest.is_empty()).map(|(kept, _)| Self(kept))
    }

    /// Whether nothing is left to do.
    pub fn is_done(&self) -> bool {
        match &self.0 {
            Kept::Paths(state) => state.is_done(),
            Kept::Whole(_) => true,
        }
    }

    /// Whether two states say the same, except for the time that it took.
    pub fn is_same_as(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Kept::Paths(own), Kept::Paths(other)) => own.is_same_as(other),
            (Kept::Whole(own), Kept::Whole(other)) => timeless(own) == timeless(other),
            _ => false,
        }
    }

    /// That of work by paths, if it is one.
    pub(super) fn of_paths(self) -> Option<OfPaths> {
        match self.0 {
            Kept::Paths(state) => Some(state),
            Kept::Whole(_) => None,
        }
    }

    /// What was found by work as a whole, if it is of that.
    pub(super) fn of_whole(self) -> Option<Option<Simulation>> {
        match self.0 {
            Kept::Paths(_) => None,
            Kept::Whole(found) => Some(found),
        }
    }
}

/// The bytes of what was found, without the time that it took: of cells outside of their surface the values are no numbers, which
/// equal nothing.
fn timeless(found: &Option<Simulation>) -> Option<Vec<u8>> {
    let mut found = found.clone()?;
    found.history.clear();
    found.seconds = 0.0;
    found.answers.iter_mut().for_each(|answer| answer.seconds = 0.0);
    postcard::to_stdvec(&found).ok()
}
