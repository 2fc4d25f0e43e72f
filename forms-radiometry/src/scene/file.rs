//! File input: reads regular files up to a size limit, so that reading always ends.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

/// The largest scene file, in bytes.
pub(super) const LARGEST_SCENE: u64 = 64 << 20;

/// The largest mesh file, in bytes.
pub(super) const LARGEST_MESH: u64 = 1 << 30;

/// Reads a file of at most `largest` bytes. Folders, devices, pipes and sockets are rejected, also
/// behind links: reading them can block or never end.
///
/// # Errors
/// If the file cannot be read, is larger, or is not a regular file.
pub fn read_file(path: &Path, largest: u64) -> io::Result<Vec<u8>> {
    // checked before opening, because opening a pipe waits for its other end
    check(&std::fs::metadata(path)?)?;
    let file = File::open(path)?;
    let metadata = file.metadata()?;
    check(&metadata)?;
    if metadata.len() > largest {
        return Err(too_large(largest));
    }
    let mut bytes = Vec::new();
    file.take(largest + 1).read_to_end(&mut bytes)?;
    // a file can grow while it is read, and some system files report no length
    if bytes.len() as u64 > largest { Err(too_large(largest)) } else { Ok(bytes) }
}

fn check(metadata: &std::fs::Metadata) -> io::Result<()> {
    if metadata.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "it is a folder"));
    }
    if metadata.is_file() {
        Ok(())
    } else {
        Err(io::Error::other("it is a device, pipe or socket, not a regular file"))
    }
}

fn too_large(largest: u64) -> io::Error {
    io::Error::new(
        io::ErrorKind::FileTooLarge,
        format!("it is larger than the limit of {} MiB", largest >> 20),
    )
}
