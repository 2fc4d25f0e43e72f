//! What the program's exit status says.

use std::process::ExitCode;

/// How a command ended, from good to bad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Status {
    /// Everything is as stated, or was done as asked.
    AsStated,
    /// Some statement is not as stated.
    NotAsStated,
    /// A number is less exact than was asked for.
    Missed,
    /// There is an error in a file, or the call cannot be carried out.
    Error,
    /// The user stopped the work with Ctrl-C.
    Stopped,
}

impl Status {
    /// The number; of work that was stopped 128 and the number of the signal, as shells have it.
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
