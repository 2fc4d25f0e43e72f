//! Output files: each is written completely or not at all, and by one run at a time.
//!
//! ```text
//! content ─▶ FILE.new ─▶ FILE        on failure the old file remains, and no new one
//! FILE.lock                          held while a run works with FILE
//! ```

use std::ffi::OsString;
use std::fs::{self, File, TryLockError};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Replaces a file atomically: at any moment either the old or the new file exists, complete. A
/// device or a pipe is written to directly.
pub(crate) fn replace(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> io::Result<()> {
    // A symbolic link remains a link.
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    if fs::metadata(&path).is_ok_and(|known| !known.is_file() && !known.is_dir()) {
        return written(File::options().write(true).open(&path)?, content);
    }
    let new = beside(&path, ".new");
    let result = File::create(&new)
        .and_then(|file| {
            written(file.try_clone()?, content)?;
            file.sync_all()
        })
        .and_then(|()| fs::rename(&new, &path));
    if result.is_err() {
        let _ = fs::remove_file(&new);
    }
    result
}

fn written(file: File, content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>) -> io::Result<()> {
    let mut output = BufWriter::new(file);
    content(&mut output)?;
    output.flush()
}

/// Checks that a file can be written here, before hours of work.
pub(crate) fn check_writable(path: &Path) -> io::Result<()> {
    if path.is_dir() {
        return Err(io::Error::other("it is a folder"));
    }
    let new = beside(path, ".new");
    File::create(&new)?;
    fs::remove_file(new)
}

/// Describes why a file cannot be read or written.
pub(crate) fn reason(error: &io::Error) -> String {
    match error.kind() {
        ErrorKind::StorageFull => "the disk is full".to_owned(),
        ErrorKind::QuotaExceeded => "the quota of disk space is used up".to_owned(),
        _ => error.to_string(),
    }
}

fn beside(path: &Path, ending: &str) -> PathBuf {
    let mut name: OsString = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

/// Lock that excludes other runs from a file while this one works with it. It ends with the
/// process, even if that is killed.
pub(crate) struct Lock {
    /// Locked file; `None` if the file system has no locks.
    file: Option<File>,
    path: PathBuf,
}

impl Lock {
    /// Takes the lock of a file; returns `None` if another run holds it.
    pub(crate) fn of(path: &Path) -> io::Result<Option<Lock>> {
        let lock = beside(&fs::canonicalize(path).unwrap_or_else(|_| path.to_owned()), ".lock");
        loop {
            let file = File::options().create(true).append(true).open(&lock)?;
            match file.try_lock() {
                // The previous holder can have removed the file in the meantime.
                Ok(()) if is_at(&file, &lock) => return Ok(Some(Lock { file: Some(file), path: lock })),
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Ok(None),
                Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => {
                    return Ok(Some(Lock { file: None, path: lock }));
                }
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // The file is removed before the lock is released, so that no other run holds the lock by
        // then.
        let _ = fs::remove_file(&self.path);
        drop(self.file.take());
    }
}

/// Whether an open file is still the file of this name.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let identity = |known: fs::Metadata| (known.dev(), known.ino());
    match (file.metadata(), fs::metadata(path)) {
        (Ok(open), Ok(named)) => identity(open) == identity(named),
        _ => false,
    }
}

/// Always true: open files cannot be removed on this system.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_cannot_be_written_whole_stays_as_it_was() {
        let folder = std::env::temp_dir().join(format!("forms-files-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let path = folder.join("a.txt");
        replace(&path, |output| output.write_all(b"old")).expect("written");
        let full = replace(&path, |output| {
            output.write_all(b"half of the new")?;
            Err(ErrorKind::StorageFull.into())
        });
        assert_eq!(reason(&full.expect_err("refused")), "the disk is full");
        assert_eq!(fs::read(&path).expect("it is there"), b"old");
        assert_eq!(fs::read_dir(&folder).expect("the folder").count(), 1);
        fs::remove_dir_all(folder).expect("removed");
    }

    #[test]
    fn a_lock_is_had_once_and_leaves_nothing() {
        let folder = std::env::temp_dir().join(format!("forms-locks-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let path = folder.join("state");
        let lock = Lock::of(&path).expect("a lock").expect("it is free");
        assert!(Lock::of(&path).expect("a lock").is_none());
        drop(lock);
        assert!(Lock::of(&path).expect("a lock").is_some());
        assert_eq!(fs::read_dir(&folder).expect("the folder").count(), 0);
        // The lock file of a killed run excludes no one.
        fs::write(folder.join("state.lock"), "").expect("a file");
        assert!(Lock::of(&path).expect("a lock").is_some());
        fs::remove_dir_all(folder).expect("removed");
    }
}
