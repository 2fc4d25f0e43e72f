//! Saved state of a path-tracing run: a checkpoint from which the same run resumes, and the part
//! that results from a share.
//!
//! ```text
//! snapshot ─┬─ every few seconds ─▶ FILE.new ─▶ FILE        a checkpoint, complete at any moment
//!           └─ at the end        ─▶ PART.new ─▶ PART
//! ```

use crate::files::{Lock, check_writable, reason, replace};
use forms_radiometry::scene::{Overrides, Sources, read_file};
use forms_radiometry::simulation::{Exposure, Identity, Keeper, Snapshot, State, StateFile};
use serde::{Deserialize, Serialize};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Smallest ratio between the interval of two checkpoints and the time to write one.
const RARELY: u32 = 20;

/// Limit of the size of a state file, in bytes.
pub(super) const LARGEST_STATE: u64 = 4 << 30;

/// Identity of the work of a part, with all data needed to continue it on another machine.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct PartOf {
    pub(super) identity: Identity,
    pub(super) sources: Sources,
    /// Values that override the settings of the scene.
    pub(super) overrides: Overrides,
    /// Exposure time in seconds.
    pub(super) exposure: Option<f64>,
    /// Chosen vector instructions, if any.
    pub(super) instructions: Option<String>,
}

impl PartOf {
    pub(super) fn exposure(&self) -> Option<Exposure> {
        self.exposure.and_then(|seconds| Exposure::new(seconds).ok())
    }
}

/// Saves the requested files.
#[derive(Default)]
pub(super) struct Kept {
    pub(super) checkpoint: Option<Checkpoint>,
    pub(super) part: Option<Part>,
}

/// Checkpoint file from which work resumes.
pub(super) struct Checkpoint {
    path: PathBuf,
    identity: Identity,
    every: Duration,
    last: Mutex<Last>,
    _lock: Lock,
}

/// Time of the next write, if there is one, and the error of the last write.
struct Last {
    next: Option<Instant>,
    failed: Option<String>,
}

/// File of a share.
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
    /// Opens the checkpoint, with its state if the file exists. The error is a message why the work
    /// cannot resume from it.
    pub(super) fn open(
        path: &str,
        identity: Identity,
        every: Duration,
    ) -> Result<(Self, Option<State>), String> {
        let remedy = "remove it to start from the beginning, or name another file";
        let lock = Lock::of(Path::new(path))
            .map_err(|error| format!("the checkpoint `{path}` cannot be written: {}", reason(&error)))?;
        let Some(lock) = lock else {
            let remedy = "wait for its end, or name another file";
            return Err(format!("the checkpoint `{path}` is in use by another run: {remedy}"));
        };
        let state = match read_file(Path::new(path), LARGEST_STATE) {
            Err(error) if error.kind() == ErrorKind::NotFound => None,
            Err(error) => return Err(format!("the checkpoint `{path}` cannot be read: {}", reason(&error))),
            Ok(bytes) => {
                let read = StateFile::Checkpoint.read::<Identity>(&bytes);
                let (found, state) =
                    read.map_err(|error| format!("the checkpoint `{path}` {error}: {remedy}"))?;
                if let Some(difference) = identity.difference(&found) {
                    return Err(format!(
                        "the checkpoint `{path}` does not match this run: {difference}; {remedy}"
                    ));
                }
                Some(state)
            }
        };
        let path = PathBuf::from(path);
        check_writable(&path).map_err(|error| {
            format!("the checkpoint `{}` cannot be written: {}", path.display(), reason(&error))
        })?;
        let last = Mutex::new(Last { next: Instant::now().checked_add(every), failed: None });
        Ok((Self { path, identity, every, last, _lock: lock }, state))
    }

    fn is_due(&self) -> bool {
        self.last.lock().is_ok_and(|last| last.next.is_some_and(|next| Instant::now() >= next))
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        let begin = Instant::now();
        let written =
            replace(&self.path, |output| StateFile::Checkpoint.write(&self.identity, snapshot, output));
        let Ok(mut last) = self.last.lock() else { return };
        let wait = self.every.max(RARELY * begin.elapsed());
        let failed = written.err().map(|error| reason(&error));
        *last = Last { next: Instant::now().checked_add(wait), failed };
    }

    /// Returns a message if the last write of the state failed.
    pub(super) fn failure(&self) -> Option<String> {
        let failed = self.last.lock().ok()?.failed.take()?;
        Some(format!("the checkpoint `{}` cannot be written: {failed}", self.path.display()))
    }
}

impl Part {
    pub(super) fn new(path: &str, belongs_to: PartOf) -> Result<Self, String> {
        let path = PathBuf::from(path);
        check_writable(&path).map_err(|error| {
            format!("the part `{}` cannot be written: {}", path.display(), reason(&error))
        })?;
        Ok(Self { path, belongs_to, written: Mutex::new(None) })
    }

    fn keep(&self, snapshot: &Snapshot<'_>) {
        let written = replace(&self.path, |output| StateFile::Part.write(&self.belongs_to, snapshot, output));
        let result = written.map(|()| snapshot.units());
        let result = result.map_err(|error| {
            format!("the part `{}` cannot be written: {}", self.path.display(), reason(&error))
        });
        if let Ok(mut written) = self.written.lock() {
            *written = Some(result);
        }
    }

    /// Returns the number of units of the work in this part and the number of all units; `None` if
    /// the work was stopped before its end.
    pub(super) fn written(&self) -> Option<Result<[usize; 2], String>> {
        self.written.lock().ok()?.take()
    }
}
