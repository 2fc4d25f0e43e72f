//! Bounds of a process that works on what somebody typed, set by itself before it reads any of it.
//!
//! The operating system keeps them: a process that goes beyond its processor time is ended, and one that asks for more memory
//! than it may have gets none, which ends it too. Whoever started the process bounds the time on the clock.

use std::io;

/// Bounds processor time and memory, the room for stacks included.
#[cfg(unix)]
pub(super) fn bound(seconds: u64, mebibytes: u64) -> io::Result<()> {
    use rlimit::Resource;
    let bytes = mebibytes.saturating_mul(1 << 20);
    for (resource, most) in [(Resource::CPU, seconds), (Resource::CORE, 0)] {
        resource.set(most, most)?;
    }
    // not every system bounds address space: macOS knows the limit and refuses to set it
    if Resource::AS.set(bytes, bytes).is_err() && cfg!(target_os = "linux") {
        return Err(io::Error::other("the memory of this process cannot be bounded"));
    }
    Ok(())
}

/// Elsewhere only the time on the clock is bounded.
#[cfg(not(unix))]
pub(super) fn bound(_seconds: u64, _mebibytes: u64) -> io::Result<()> {
    Ok(())
}
