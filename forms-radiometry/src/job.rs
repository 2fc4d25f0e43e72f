//! Shares and budgets: the part of the work on a scene that is done.
//!
//! ```text
//! tolerance   unit u of the work is a number, a cell or a pixel, with as many samples as it needs
//! budget      unit u is one replicate of one of these, with a given number of samples
//! share i/n   the units with u mod n = i − 1
//! ```
//! A scene that is solved as a whole, without paths, is a single unit.
//!
//! The number of samples of a unit depends only on the unit and on a pilot that every shard
//! repeats. Merged shards therefore equal one run, bit for bit.

use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;

/// Number of replicates of a single value, and of a pixel or a cell.
pub(crate) const REPLICATES: usize = 32;
/// Largest number of samples of a replicate.
pub(crate) const MOST_SAMPLES: u32 = 1 << 31;

/// One shard of the work on a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Share {
    part: u32,
    of: u32,
}

/// Text that is not a shard.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NoShare(String);

impl fmt::Display for NoShare {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "`{}` is not a shard: expected i/n with i from 1 to n, or from 0 to n - 1, \
             for example 2/7; n is at most {}",
            self.0,
            u32::MAX
        )
    }
}

impl std::error::Error for NoShare {}

impl Share {
    /// All of the work.
    pub const WHOLE: Self = Self { part: 1, of: 1 };

    /// Returns the first shard of the same division.
    pub fn first(self) -> Self {
        Self { part: 1, ..self }
    }

    /// Returns all shards of the same division, including this one.
    pub fn all(self) -> impl Iterator<Item = Self> {
        (1..=self.of).map(move |part| Self { part, of: self.of })
    }

    /// Returns the number of shards.
    pub fn count(self) -> u32 {
        self.of
    }

    /// Whether it is all of the work.
    pub fn is_whole(self) -> bool {
        self.of == 1
    }

    /// Whether a unit of the work belongs to it.
    pub fn has(self, unit: usize) -> bool {
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
            // shards counted from 0 to n − 1 are the same shards, with the last of them first
            Some((0, of)) if of > 0 => Ok(Self { part: of, of }),
            Some((part, of)) if (1..=of).contains(&part) => Ok(Self { part, of }),
            _ => Err(NoShare(text.to_owned())),
        }
    }
}

/// Fixed number of samples of every number, cell and pixel, instead of the number that the
/// tolerance requires: a multiple of the number of replicates.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Budget {
    of_replicate: u32,
}

/// Number of samples that is not possible.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NoBudget(pub u64);

impl fmt::Display for NoBudget {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let most = Budget::most();
        write!(
            f,
            "{} is not a valid number of samples: expected a multiple of {REPLICATES} \
             from {REPLICATES} to {most}",
            self.0
        )
    }
}

impl std::error::Error for NoBudget {}

impl Budget {
    /// Creates a budget of this many samples, a multiple of the number of replicates.
    pub fn new(samples: u64) -> Result<Self, NoBudget> {
        if (1..=Self::most()).contains(&samples) && samples.is_multiple_of(REPLICATES as u64) {
            Ok(Self { of_replicate: (samples / REPLICATES as u64) as u32 })
        } else {
            Err(NoBudget(samples))
        }
    }

    /// Returns the number of samples.
    pub fn samples(self) -> u64 {
        u64::from(self.of_replicate) * REPLICATES as u64
    }

    pub(crate) fn of_replicate(self) -> u32 {
        self.of_replicate
    }

    fn most() -> u64 {
        u64::from(MOST_SAMPLES) * REPLICATES as u64
    }
}
