//! Files that are read: regular ones, up to a size, and nothing that never ends.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The largest scene, in bytes.
pub(super) const LARGEST_SCENE: u64 = 64 << 20;

/// The largest mesh, in bytes.
pub(super) const LARGEST_MESH: u64 = 1 << 30;

/// Reads a file of at most so many bytes. A folder, a device, a pipe and a socket are refused, by way of links too: reading
/// one may wait or go on forever.
///
/// # Errors
/// If the file cannot be read, is larger, or is none.
pub fn read_file(path: &Path, largest: u64) -> io::Result<Vec<u8>> {
    // before it is opened, as opening a pipe waits for its other end
    check(&std::fs::metadata(path)?)?;
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    check(&metadata)?;
    if metadata.len() > largest {
        return Err(too_large(largest));
    }
    let mut bytes = Vec::new();
    file.take(largest + 1).read_to_end(&mut bytes)?;
    // a file may grow, and some of the system's have no length
    if bytes.len() as u64 > largest { Err(too_large(largest)) } else { Ok(bytes) }
}

fn check(metadata: &std::fs::Metadata) -> io::Result<()> {
    if metadata.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    if metadata.is_file() {
        Ok(())
    } else {
        Err(io::Error::other("it is a device, pipe or socket, and no file"))
    }
}

fn too_large(largest: u64) -> io::Error {
    io::Error::new(
        io::ErrorKind::FileTooLarge,
        format!("it is larger than the limit of {} MiB", largest >> 20),
    )
}
