//! Checkpoints: the state of a simulation, from which the same work continues, and from which
//! shards are merged.
//!
//! ```text
//! path tracing        sums and numbers of samples
//! solved as a whole   the result, or nothing in a shard without it
//! ```

use crate::answer::Simulation;
use crate::checkpoint::{Content, Kind};
use crate::paths::driver::OfPaths;
use serde::Deserialize;
use std::io::{self, Write};

/// State that was written before.
#[derive(Clone, Debug, Deserialize)]
pub struct State(Kind<OfPaths, Option<Simulation>>);

/// Result of a scene that is solved as a whole, or nothing in a shard without it, at the end.
pub(super) struct Whole<'w>(pub(super) Option<&'w Simulation>);

impl Content for Whole<'_> {
    fn is_done(&self) -> bool {
        true
    }

    fn units(&self) -> [usize; 2] {
        [usize::from(self.0.is_some()), 1]
    }

    fn write(&self, output: &mut dyn Write) -> io::Result<()> {
        Kind::<(), _>::Whole(self.0).write(output)
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
            Kind::Paths(state) => state.is_done(),
            Kind::Whole(_) => true,
        }
    }

    /// Whether two states are equal, except for times.
    pub fn is_same_as(&self, other: &Self) -> bool {
        match (&self.0, &other.0) {
            (Kind::Paths(own), Kind::Paths(other)) => own.is_same_as(other),
            (Kind::Whole(own), Kind::Whole(other)) => timeless(own) == timeless(other),
            _ => false,
        }
    }

    /// Returns the state of the path driver, if it is one.
    pub(super) fn of_paths(self) -> Option<OfPaths> {
        match self.0 {
            Kind::Paths(state) => Some(state),
            Kind::Whole(_) => None,
        }
    }

    /// Returns the result of a scene that is solved as a whole, if it is the state of one.
    pub(super) fn of_whole(self) -> Option<Option<Simulation>> {
        match self.0 {
            Kind::Paths(_) => None,
            Kind::Whole(found) => Some(found),
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
