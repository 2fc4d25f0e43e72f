//! The gallery: the scenes of the folder `scenes`, in the order of their names.

use forms_radiometry::scene::{Scene, SceneError, read_with_files};
use std::path::{Path, PathBuf};

/// What can go wrong.
pub(crate) type Problem = Box<dyn std::error::Error>;

/// The folder of the scenes.
pub(crate) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// Their files.
pub(crate) fn files() -> Result<Vec<PathBuf>, Problem> {
    let mut files: Vec<_> =
        std::fs::read_dir(folder())?.map(|entry| Ok(entry?.path())).collect::<Result<_, Problem>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    Ok(files)
}

/// The name of a file, without what is behind the point.
pub(crate) fn name(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// A scene by its text; meshes are those of the folder.
pub(crate) fn scene(text: &str, name: &str) -> Result<Scene, Problem> {
    read_with_files(text, name, &|file| std::fs::read(folder().join(file))).map_err(said)
}

/// What is wrong with a scene.
pub(crate) fn said(errors: Vec<SceneError>) -> Problem {
    errors.into_iter().map(|error| error.to_string()).collect::<Vec<_>>().join("\n").into()
}
