//! What is kept of a simulation by paths: a checkpoint that the same work goes on from, and the part that a share of it comes to.
//!
//! ```text
//! snapshot ─┬─ every few seconds ─▶ FILE.new ─▶ FILE        a checkpoint, whole at any moment
//!           └─ at the end        ─▶ PART.new ─▶ PART
//! ```

use forms_radiometry::scene::Sources;
use forms_radiometry::simulation::{Exposure, Identity, Keeper, Snapshot, State, StateFile};
use serde::{Deserialize, Serialize};
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Keeping takes no more than one in so many seconds of the work.
const RARELY: u32 = 20;

/// What a part belongs to, and what it takes to go on with it elsewhere.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct PartOf {
    pub(super) identity: Identity,
    pub(super) sources: Sources,
    /// The seconds of exposure.
    pub(super) exposure: Option<f64>,
    /// The vector instructions, if they were chosen.
    pub(super) instructions: Option<String>,
}

impl PartOf {
    pub(super) fn exposure(&self) -> Option<Exposure> {
        self.exposure.and_then(|seconds| Exposure::new(seconds).ok())
    }
}

/// Keeps what is asked for in files.
#[derive(Default)]
pub(super) struct Kept {
    pub(super) checkpoint: Option<Checkpoint>,
    pub(super) part: Option<Part>,
}

/// The file that work goes on from.
pub(super) struct Checkpoint {
    path: PathBuf,
    identity: Identity,
    every: Duration,
    last: Mutex<Last>,
}

/// When the state was kept, when it is to be kept again, and what went wrong.
struct Last {
    next: Instant,
    failed: Option<String>,
}

/// The file of a share.
pub(super) struct Part {
    path: PathBuf,
    belongs_to: PartOf,
    written: Mutex<Option<Result<[usize; 2], String>>>,
}

impl Keeper for Kept {
    fn is_due(&self) -> bool {
        self.checkpoint.as_ref().is_some_and(Checkpoint::is_due)
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        if let Some(checkpoint) = &self.checkpoint {
            checkpoint.keep(snapshot);
        }
        if let Some(part) = self.part.as_ref().filter(|_| snapshot.is_done()) {
            part.keep(snapshot);
        }
    }
}

impl Checkpoint {
    /// The file, and the state that is in it, if it is there. The message says why work cannot go on from it.
    pub(super) fn open(
        path: &str,
        identity: Identity,
        every: Duration,
    ) -> Result<(Self, Option<State>), String> {
        let remedy = "remove it to start from the beginning, or name another file";
        let state = match fs::read(path) {
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(format!("the checkpoint `{path}` cannot be read: {error}")),
            Ok(bytes) => {
                let read = StateFile::Checkpoint.read::<Identity>(&bytes);
                let (found, state) =
                    read.map_err(|error| format!("the checkpoint `{path}` {error}: {remedy}"))?;
                if let Some(difference) = identity.difference(&found) {
                    return Err(format!(
                        "the checkpoint `{path}` is not of this work, {difference}: {remedy}"
                    ));
                }
                Some(state)
            }
        };
        let path = PathBuf::from(path);
        writable(&path)
            .map_err(|error| format!("the checkpoint `{}` cannot be written: {error}", path.display()))?;
        let last = Mutex::new(Last { next: Instant::now() + every, failed: None });
        Ok((Self { path, identity, every, last }, state))
    }

    fn is_due(&self) -> bool {
        self.last.lock().is_ok_and(|last| Instant::now() >= last.next)
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        let begin = Instant::now();
        let written =
            replace(&self.path, |output| StateFile::Checkpoint.write(&self.identity, snapshot, output));
        let Ok(mut last) = self.last.lock() else { return };
        let wait = self.every.max(RARELY * begin.elapsed());
        *last = Last { next: Instant::now() + wait, failed: written.err().map(|error| error.to_string()) };
    }

    /// Why the state was not kept when it last should have been, if it was not.
    pub(super) fn failure(&self) -> Option<String> {
        let failed = self.last.lock().ok()?.failed.take()?;
        Some(format!("the checkpoint `{}` cannot be written: {failed}", self.path.display()))
    }
}

impl Part {
    pub(super) fn new(path: &str, belongs_to: PartOf) -> Result<Self, String> {
        let path = PathBuf::from(path);
        writable(&path)
            .map_err(|error| format!("the part `{}` cannot be written: {error}", path.display()))?;
        Ok(Self { path, belongs_to, written: Mutex::new(None) })
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        let written = replace(&self.path, |output| StateFile::Part.write(&self.belongs_to, snapshot, output));
        let result = written.map(|()| snapshot.units());
        let result =
            result.map_err(|error| format!("the part `{}` cannot be written: {error}", self.path.display()));
        if let Ok(mut written) = self.written.lock() {
            *written = Some(result);
        }
    }

    /// How many units of the work it has of how many; nothing if the work was stopped before its end.
    pub(super) fn written(&self) -> Option<Result<[usize; 2], String>> {
        self.written.lock().ok()?.take()
    }
}

/// The name of what a file is written as before it takes its place.
fn beside(path: &Path) -> PathBuf {
    let mut name: OsString = path.as_os_str().to_owned();
    name.push(".new");
    PathBuf::from(name)
}

/// Whether there can be a file here, which is told before hours of work.
fn writable(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::Error::other("it is a folder"));
    }
    File::create(beside(path))?;
    fs::remove_file(beside(path))
}

/// Writes a file so that at any moment there is the old one or the new one, whole.
fn replace(path: &Path, content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let new = beside(path);
    let mut output = BufWriter::new(File::create(&new)?);
    content(&mut output)?;
    output.flush()?;
    output.get_ref().sync_all()?;
    fs::rename(&new, path)
}
