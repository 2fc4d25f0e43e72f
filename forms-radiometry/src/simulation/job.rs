//! Jobs: which part of the work on a scene is done, from where it goes on, and who keeps what is done.
//!
//! ```text
//! tolerance   unit u of the work is a number, a cell or a pixel, with as many samples as it needs
//! budget      unit u is one replicate of one of these, with a number of samples that is given
//! share i/n   the units with u mod n = i − 1
//! ```
//! A scene that is solved as a whole, without paths, is a single unit.
//!
//! How many samples a unit gets depends on nothing but itself and a pilot that every share repeats, so that shares come to what one run
//! gives, bit for bit.

use super::state::{Snapshot, State};
use crate::monte_carlo::REPLICATES;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// One of the shares that the work on a scene is divided into.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Share {
    part: u32,
    of: u32,
}

/// A text that is no share.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoShare(String);

impl fmt::Display for NoShare {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "`{}` is no share: expected i/n with i from 1 to n, or from 0 to n - 1, for example 2/7; n is at most {}",
            self.0,
            u32::MAX
        )
    }
}

impl std::error::Error for NoShare {}

impl Share {
    /// All of the work.
    pub const WHOLE: Self = Self { part: 1, of: 1 };

    /// The first of them all.
    pub fn first(self) -> Self {
        Self { part: 1, ..self }
    }

    /// The others that it makes all of the work with, and itself.
    pub fn all(self) -> impl Iterator<Item = Self> {
        (1..=self.of).map(move |part| Self { part, of: self.of })
    }

    /// How many shares there are.
    pub fn count(self) -> u32 {
        self.of
    }

    /// Whether it is all of the work.
    pub fn is_whole(self) -> bool {
        self.of == 1
    }

    /// Whether a unit of the work belongs to it.
    pub(super) fn has(self, unit: usize) -> bool {
        unit % self.of as usize == self.part as usize - 1
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.part, self.of)
    }
}

impl FromStr for Share {
    type Err = NoShare;

    fn from_str(text: &str) -> Result<Self, NoShare> {
        let parts = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
        match parts {
            // whoever counts from 0 to n − 1 has the same shares, the last of them first
            Some((0, of)) if of > 0 => Ok(Self { part: of, of }),
            Some((part, of)) if (1..=of).contains(&part) => Ok(Self { part, of }),
            _ => Err(NoShare(text.to_owned())),
        }
    }
}

/// How many samples every number, cell and pixel gets instead of as many as the tolerance asks for: a multiple of the replicates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Budget {
    of_replicate: u32,
}

/// A number of samples that cannot be had.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoBudget(pub u64);

impl fmt::Display for NoBudget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = Budget::most();
        write!(
            f,
            "{} samples cannot be had: expected a multiple of {REPLICATES} from {REPLICATES} to {most}",
            self.0
        )
    }
}

impl std::error::Error for NoBudget {}

impl Budget {
    /// So many samples, a multiple of the replicates.
    pub fn new(samples: u64) -> Result<Self, NoBudget> {
        if (1..=Self::most()).contains(&samples) && samples.is_multiple_of(REPLICATES as u64) {
            Ok(Self { of_replicate: (samples / REPLICATES as u64) as u32 })
        } else {
            Err(NoBudget(samples))
        }
    }

    /// How many samples there are.
    pub fn samples(self) -> u64 {
        u64::from(self.of_replicate) * REPLICATES as u64
    }

    pub(super) fn of_replicate(self) -> u32 {
        self.of_replicate
    }

    fn most() -> u64 {
        u64::from(super::followed::MOST) * REPLICATES as u64
    }
}

/// Who keeps the state of a simulation while it goes on. Called from several threads.
pub trait Keeper: Sync {
    /// Whether it is time to keep what is done.
    fn is_due(&self) -> bool;

    /// Keeps it: called before the work, whenever it is time, and at the end.
    fn keep(&self, snapshot: &Snapshot<'_>);
}

/// What is to be done of a simulation.
pub struct Job<'k> {
    /// How many samples there are to be; as many as the tolerance asks for, if that is not said. What is solved as a whole has none.
    pub budget: Option<Budget>,
    /// Which part of the work is done.
    pub share: Share,
    /// The state from which it goes on; from the beginning, if there is none.
    pub state: Option<State>,
    /// Who keeps the state.
    pub keeper: Option<&'k dyn Keeper>,
}

impl Default for Job<'_> {
    fn default() -> Self {
        Self { budget: None, share: Share::WHOLE, state: None, keeper: None }
    }
}
