//! Sources: the input files of a scene, by which it can be identified and read again elsewhere.

use super::SceneError;
use super::file::{LARGEST_MESH, read_file};
use super::model::Scene;
use super::read::{read_with_files, text_of};
use serde::{Deserialize, Serialize};
use std::cell::RefCell;
use std::io;
use std::path::Path;

/// The text of a scene file, and the bytes of the files that it names.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Sources {
    name: String,
    text: String,
    files: Vec<(String, Vec<u8>)>,
}

impl Sources {
    /// Opens a scene like [`open`](super::open), and keeps its input files.
    pub fn open(path: &Path) -> Result<(Scene, Self), Vec<SceneError>> {
        let text = text_of(path)?;
        let name = path.to_string_lossy().into_owned();
        let folder = path.parent().unwrap_or(Path::new(""));
        let files = RefCell::new(Vec::new());
        let scene = read_with_files(&text, &name, &|file| {
            let bytes = read_file(&folder.join(file), LARGEST_MESH)?;
            files.borrow_mut().push((file.to_owned(), bytes.clone()));
            Ok(bytes)
        })?;
        Ok((scene, Self { name, text, files: files.into_inner() }))
    }

    /// Parses the scene again; nothing is opened.
    pub fn read(&self) -> Result<Scene, Vec<SceneError>> {
        read_with_files(&self.text, &self.name, &|file| {
            let found = self.files.iter().find(|(name, _)| name == file);
            found.map(|(_, bytes)| bytes.clone()).ok_or_else(|| io::ErrorKind::NotFound.into())
        })
    }

    /// Returns the path with which the scene was opened.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns a digest that differs for different texts or files, and does not depend on the
    /// location of the scene.
    pub fn digest(&self) -> [u8; 32] {
        let mut hash = blake3::Hasher::new();
        let mut add = |bytes: &[u8]| {
            hash.update(&(bytes.len() as u64).to_le_bytes()).update(bytes);
        };
        let ending = Path::new(&self.name).extension().unwrap_or_default();
        add(ending.to_string_lossy().to_lowercase().as_bytes());
        add(self.text.as_bytes());
        for (name, bytes) in &self.files {
            add(name.as_bytes());
            add(bytes);
        }
        *hash.finalize().as_bytes()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sources(name: &str, text: &str, files: &[(&str, &str)]) -> Sources {
        let files = files.iter().map(|(name, text)| (name.to_string(), text.as_bytes().to_vec()));
        Sources { name: name.to_owned(), text: text.to_owned(), files: files.collect() }
    }

    #[test]
    fn the_digest_is_of_what_is_read_and_not_of_where_it_lies() {
        let one = sources("a/scene.toml", "x", &[("b.obj", "c")]);
        assert_eq!(one.digest(), sources("elsewhere/other.toml", "x", &[("b.obj", "c")]).digest());
        for other in [
            sources("a/scene.xml", "x", &[("b.obj", "c")]),
            sources("a/scene.toml", "y", &[("b.obj", "c")]),
            sources("a/scene.toml", "x", &[("b.obj", "d")]),
            sources("a/scene.toml", "x", &[("b.ob", "jc")]),
            sources("a/scene.toml", "x", &[]),
        ] {
            assert_ne!(one.digest(), other.digest(), "{other:?}");
        }
    }
}
