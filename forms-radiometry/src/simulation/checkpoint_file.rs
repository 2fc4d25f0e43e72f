//! State files: the identity of the work and its state become bytes. These are accepted only where
//! nothing in them has changed.
//!
//! ```text
//! "forms checkpoint" or "forms part" | program version | identity | state | BLAKE3 of all before
//! ```
//! Identity and state are written in the postcard format, in which an `f64` keeps its bits.

use super::arithmetic::Arithmetic;
use super::state::State;
use crate::checkpoint::Snapshot;
use crate::effects::PlannedEffect;
use crate::job::{Budget, Share};
use crate::plan::Plan;
use crate::scene::Sources;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Write};

/// Version of the program. Only the same version can read a file and continue from it to the same
/// bits.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// Length of the checksum of all other bytes.
const CHECK: usize = blake3::OUT_LEN;

/// Purpose of a state file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateFile {
    /// The same work continues from it.
    Checkpoint,
    /// It is merged with the files of the other shards.
    Part,
}

/// Identity of the work that a state belongs to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    scene: [u8; 32],
    plan: [u8; 32],
    /// Bits of the tolerance in use, regardless of who requested it.
    tolerance: u64,
    /// Seed in use, regardless of who requested it.
    seed: u64,
    arithmetic: Arithmetic,
    budget: Option<Budget>,
    share: Share,
}

/// Reason why bytes are not a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoState {
    /// The bytes are not a file of this kind.
    Foreign,
    /// The bytes differ from those that were written.
    Damaged,
    /// Another version of the program wrote the file.
    Version(String),
}

impl fmt::Display for NoState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign => write!(f, "was written by another program or for another purpose"),
            Self::Damaged => write!(f, "is damaged: its checksum does not match its content"),
            Self::Version(version) => {
                write!(f, "was written by version {version}; this program is version {VERSION}")
            }
        }
    }
}

impl std::error::Error for NoState {}

impl Identity {
    /// Returns the identity of work on this machine. The plan is that of the scene of `sources`, with
    /// the settings that replace its own.
    pub fn new(sources: &Sources, plan: &Plan, budget: Option<Budget>, share: Share) -> Self {
        Self {
            scene: sources.digest(),
            plan: digest(plan),
            tolerance: plan.simulated.tolerance.to_bits(),
            seed: plan.simulated.scene().solve.seed,
            arithmetic: Arithmetic::here(),
            budget,
            share,
        }
    }

    /// Returns the shard.
    pub fn share(&self) -> Share {
        self.share
    }

    /// Returns the fixed number of samples, if one was requested.
    pub fn budget(&self) -> Option<Budget> {
        self.budget
    }

    /// Describes the first property in which another identity differs: the other's value, then this
    /// one's.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let samples = |budget: Option<Budget>| {
            budget.map_or("the number of samples that the tolerance requires".to_owned(), |budget| {
                format!("{} samples per value, cell and pixel", budget.samples())
            })
        };
        if self.scene != other.scene {
            return Some(
                "it belongs to another scene, or the scene or a file it refers to has changed".to_owned(),
            );
        }
        if self.tolerance != other.tolerance {
            let [found, wanted] = [other, self].map(|identity| f64::from_bits(identity.tolerance));
            return Some(format!("it was computed with tolerance {found:?}, not {wanted:?}"));
        }
        if self.seed != other.seed {
            return Some(format!("it was computed with seed {}, not {}", other.seed, self.seed));
        }
        if self.plan != other.plan {
            return Some("it belongs to the same scene with other effects".to_owned());
        }
        if self.budget != other.budget {
            return Some(format!(
                "it was computed with {}, not with {}",
                samples(other.budget),
                samples(self.budget)
            ));
        }
        if self.arithmetic != other.arithmetic {
            let (found, here) = (&other.arithmetic, &self.arithmetic);
            return Some(format!(
                "it was computed with other instructions or math functions: {found}; not {here}"
            ));
        }
        let (found, wanted) = (other.share, self.share);
        (found != wanted).then(|| format!("it is shard {found}, not {wanted}"))
    }

    /// Returns the same identity for another shard.
    pub fn with_share(&self, share: Share) -> Self {
        Self { share, ..self.clone() }
    }
}

/// Returns a hash that differs between plans of different effects. The reasons in a plan do not
/// enter.
fn digest(plan: &Plan) -> [u8; 32] {
    let of_effect = |planned: &PlannedEffect| (planned.effect, planned.on, planned.orders, planned.bound);
    let effects: Vec<_> = plan.effects().iter().map(of_effect).collect();
    *blake3::hash(format!("{effects:?}").as_bytes()).as_bytes()
}

impl StateFile {
    fn title(self) -> &'static str {
        match self {
            Self::Checkpoint => "forms checkpoint\n",
            Self::Part => "forms part\n",
        }
    }

    /// Writes a state and the identity that it belongs to.
    pub fn write(
        self,
        belongs_to: &impl Serialize,
        snapshot: &Snapshot<'_>,
        output: &mut dyn Write,
    ) -> io::Result<()> {
        let mut output = Checked { output, hash: blake3::Hasher::new() };
        writeln!(output, "{}{VERSION}", self.title())?;
        postcard::to_io(belongs_to, &mut output).map_err(io::Error::other)?;
        snapshot.write(&mut output)?;
        let check = output.hash.finalize();
        output.output.write_all(check.as_bytes())
    }

    /// Reads the identity that a state belongs to, and the state.
    pub fn read<T: DeserializeOwned>(self, bytes: &[u8]) -> Result<(T, State), NoState> {
        let content = bytes.strip_prefix(self.title().as_bytes()).ok_or(NoState::Foreign)?;
        let (before, check) = bytes.split_at(bytes.len().saturating_sub(CHECK));
        if content.len() < CHECK || blake3::hash(before).as_bytes() != check {
            return Err(NoState::Damaged);
        }
        let content = &content[..content.len() - CHECK];
        let end = content.iter().position(|&byte| byte == b'\n').ok_or(NoState::Damaged)?;
        let (version, content) = (&content[..end], &content[end + 1..]);
        if version != VERSION.as_bytes() {
            return Err(NoState::Version(String::from_utf8_lossy(version).into_owned()));
        }
        let (belongs_to, state) = postcard::take_from_bytes(content).map_err(|_| NoState::Damaged)?;
        Ok((belongs_to, State::read(state).ok_or(NoState::Damaged)?))
    }
}

/// Writer that also hashes the bytes it writes.
struct Checked<'o> {
    output: &'o mut dyn Write,
    hash: blake3::Hasher,
}

impl Write for Checked<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.output.write(bytes)?;
        self.hash.update(&bytes[..written]);
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.output.flush()
    }
}
