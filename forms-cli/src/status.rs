//! Exit status of the program.

use std::process::ExitCode;

/// Outcome of a command, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Status {
    /// Every statement is as stated, or the work was done as requested.
    AsStated,
    /// A statement is not as stated.
    NotAsStated,
    /// A number is less accurate than requested.
    Missed,
    /// A file has errors, or the call cannot be carried out.
    Error,
    /// The user stopped the work with Ctrl-C.
    Stopped,
}

impl Status {
    /// Returns the exit code; for stopped work 128 plus the number of the signal, as in shells.
    pub(crate) fn code(self) -> u8 {
        match self {
            Status::AsStated => 0,
            Status::NotAsStated => 1,
            Status::Error => 2,
            Status::Missed => 3,
            Status::Stopped => 130,
        }
    }
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> ExitCode {
        ExitCode::from(status.code())
    }
}
