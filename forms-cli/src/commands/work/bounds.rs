//! Resource limits of a worker process, which the process sets for itself before it reads any user
//! input.
//!
//! The operating system enforces them: a process that exceeds its processor time is ended, and a
//! request for memory beyond the limit fails, which also ends the process. The parent process
//! limits the time on the clock.

use std::io;

/// Limits processor time and memory, including the space for stacks.
#[cfg(unix)]
pub(super) fn bound(seconds: u64, mebibytes: u64) -> io::Result<()> {
    use rlimit::Resource;
    let bytes = mebibytes.saturating_mul(1 << 20);
    for (resource, most) in [(Resource::CPU, seconds), (Resource::CORE, 0)] {
        resource.set(most, most)?;
    }
    // Not every system can limit the address space: macOS defines the limit and refuses to set it.
    if Resource::AS.set(bytes, bytes).is_err() && cfg!(target_os = "linux") {
        return Err(io::Error::other("the memory of this process cannot be bounded"));
    }
    Ok(())
}

/// Does nothing: on other systems only the time on the clock is limited.
#[cfg(not(unix))]
pub(super) fn bound(_seconds: u64, _mebibytes: u64) -> io::Result<()> {
    Ok(())
}
