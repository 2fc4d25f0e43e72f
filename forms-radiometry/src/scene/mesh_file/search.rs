//! Search path: the folders in which the files of a scene are looked up. The folder of the scene
//! comes first, then the folders that the scene names, in the order of their addition.

use super::Found;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Opens a file by its path relative to the folder of the scene.
type Open<'o> = &'o dyn Fn(&str) -> io::Result<Vec<u8>>;

/// The folders besides the folder of the scene, relative to it.
#[derive(Default)]
pub(super) struct SearchPath {
    folders: Vec<PathBuf>,
}

impl SearchPath {
    /// Adds a folder. Its path is relative to the folder `base` or, where there is no such folder,
    /// to a folder of the search path, as in Mitsuba.
    pub(super) fn add(&mut self, open: Open, base: &Path, folder: &str) {
        let folder = Path::new(folder);
        let others = [Path::new("")].into_iter().chain(self.folders.iter().map(PathBuf::as_path));
        let candidates: Vec<PathBuf> =
            [base].into_iter().chain(others).map(|start| start.join(folder)).collect();
        // opening a folder fails, but not because there is nothing of this name
        let exists = |path: &PathBuf| {
            open(&path.to_string_lossy()).err().is_some_and(|error| error.kind() == ErrorKind::IsADirectory)
        };
        let added = candidates.into_iter().find(exists).unwrap_or_else(|| base.join(folder));
        if !added.as_os_str().is_empty() && !self.folders.contains(&added) {
            self.folders.push(added);
        }
    }

    /// Returns a file. It is an error if two folders have different files of this name: the order
    /// of folders is not the same in all versions of Mitsuba.
    pub(super) fn find(&self, open: Open, what: &str, name: &str) -> Result<Found, (String, String)> {
        let mut found: Option<Found> = None;
        for folder in [Path::new("")].into_iter().chain(self.folders.iter().map(PathBuf::as_path)) {
            let path = folder.join(name).to_string_lossy().into_owned();
            match (open(&path), &found) {
                (Ok(bytes), None) => found = Some(Found { path, bytes }),
                (Ok(bytes), Some(first)) if first.path != path && first.bytes != bytes => {
                    let message = format!("there are different files `{}` and `{path}`", first.path);
                    return Err((message, "one of them, or a path that names it".to_owned()));
                }
                (Err(error), None) if error.kind() != ErrorKind::NotFound => {
                    return Err((format!("the {what} `{name}` cannot be read: {error}"), String::new()));
                }
                _ => {}
            }
        }
        let expected = match self.folders.is_empty() {
            true => "a path relative to the folder of the scene file",
            false => "a path relative to the folder of the scene file, or to a folder that a `path` names",
        };
        found.ok_or_else(|| (format!("there is no file `{name}`"), expected.to_owned()))
    }
}
