//! Files of states: what a state belongs to and the state itself become bytes, which are understood only where nothing of them changed.
//!
//! ```text
//! "forms checkpoint" or "forms part" | version of the program | what it belongs to | state | BLAKE3 of all before
//! ```
//! What it belongs to and the state are written in the format of postcard, in which an `f64` keeps its bits.

use super::answer::{Plan, PlannedEffect};
use super::arithmetic::Arithmetic;
use super::job::{Budget, Share};
use super::state::{Snapshot, State};
use crate::scene::{Scene, Sources};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::fmt;
use std::io::{self, Write};

/// What only the same version understands, and goes on to the same bits with.
const VERSION: &str = env!("CARGO_PKG_VERSION");
/// The bytes of the number that all others are checked by.
const CHECK: usize = blake3::OUT_LEN;

/// What a file of a state is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StateFile {
    /// The same work goes on from it.
    Checkpoint,
    /// It is put together with those of other shares.
    Part,
}

/// The work that a state belongs to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Identity {
    scene: [u8; 32],
    plan: [u8; 32],
    /// The bits of the tolerance that is worked to, whoever asked for it.
    tolerance: u64,
    /// The seed that the work has, likewise.
    seed: u64,
    arithmetic: Arithmetic,
    budget: Option<Budget>,
    share: Share,
}

/// Why bytes are no state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoState {
    /// They are something else.
    Foreign,
    /// They are not what was written.
    Damaged,
    /// Another version of the program wrote them.
    Version(String),
}

impl fmt::Display for NoState {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Foreign => write!(f, "was not written by this program as such"),
            Self::Damaged => write!(f, "is damaged: its check sum is not that of its content"),
            Self::Version(version) => write!(f, "was written by version {version}, and this is {VERSION}"),
        }
    }
}

impl std::error::Error for NoState {}

impl Identity {
    /// That of work on this machine. The scene is the one that is simulated, with the settings that replace those of its sources.
    pub fn new(sources: &Sources, scene: &Scene, plan: &Plan, budget: Option<Budget>, share: Share) -> Self {
        Self {
            scene: sources.digest(),
            plan: digest(plan),
            tolerance: scene.solve.tolerance.to_bits(),
            seed: scene.solve.seed,
            arithmetic: Arithmetic::here(),
            budget,
            share,
        }
    }

    /// The share that it is.
    pub fn share(&self) -> Share {
        self.share
    }

    /// The samples that there are to be, if that was said.
    pub fn budget(&self) -> Option<Budget> {
        self.budget
    }

    /// The first thing in which another identity differs, as what the other is and what this one is.
    pub fn difference(&self, other: &Self) -> Option<String> {
        let samples = |budget: Option<Budget>| {
            budget.map_or("as many samples as the tolerance asks for".to_owned(), |budget| {
                format!("{} samples of each number, cell and pixel", budget.samples())
            })
        };
        if self.scene != other.scene {
            return Some(
                "it is of another scene, or the scene or a file that it names was changed".to_owned(),
            );
        }
        if self.tolerance != other.tolerance {
            let [found, wanted] = [other, self].map(|identity| f64::from_bits(identity.tolerance));
            return Some(format!("it is of the tolerance {found:?}, not of {wanted:?}"));
        }
        if self.seed != other.seed {
            return Some(format!("it is of the seed {}, not of {}", other.seed, self.seed));
        }
        if self.plan != other.plan {
            return Some("it is of the same scene with other effects".to_owned());
        }
        if self.budget != other.budget {
            return Some(format!("it is of {}, not of {}", samples(other.budget), samples(self.budget)));
        }
        if self.arithmetic != other.arithmetic {
            let (found, here) = (&other.arithmetic, &self.arithmetic);
            return Some(format!("it was computed with other instructions: {found}; not {here}"));
        }
        let (found, wanted) = (other.share, self.share);
        (found != wanted).then(|| format!("it is of share {found}, not of {wanted}"))
    }

    /// The same for another share.
    pub fn with_share(&self, share: Share) -> Self {
        Self { share, ..self.clone() }
    }
}

/// A number that plans of other effects do not have; their reasons are no matter.
fn digest(plan: &Plan) -> [u8; 32] {
    let of_effect = |planned: &PlannedEffect| (planned.effect, planned.on, planned.orders, planned.bound);
    let effects: Vec<_> = plan.effects.iter().map(of_effect).collect();
    *blake3::hash(format!("{effects:?}").as_bytes()).as_bytes()
}

impl StateFile {
    fn title(self) -> &'static str {
        match self {
            Self::Checkpoint => "forms checkpoint\n",
            Self::Part => "forms part\n",
        }
    }

    /// Writes a state and what it belongs to.
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

    /// Reads what a state belongs to, and the state.
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

/// What is written goes into a number as well.
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
