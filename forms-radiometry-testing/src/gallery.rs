//! The gallery: the scenes of the directory `scenes`, in the order of their names.

use forms_radiometry::scene::{Scene, SceneError, read_with_files};
use std::path::{Path, PathBuf};

/// Any error of an example.
pub type Problem = Box<dyn std::error::Error>;

/// Returns the directory of the scenes.
pub fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes")
}

/// Returns the files of the scenes.
pub fn files() -> Result<Vec<PathBuf>, Problem> {
    let mut files: Vec<_> =
        std::fs::read_dir(folder())?.map(|entry| Ok(entry?.path())).collect::<Result<_, Problem>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    Ok(files)
}

/// Returns the name of a file without its extension.
pub fn name(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
}

/// Reads a scene from its text; meshes are files of the directory.
pub fn scene(text: &str, name: &str) -> Result<Scene, Problem> {
    read_with_files(text, name, &|file| std::fs::read(folder().join(file))).map_err(said)
}

/// Joins the errors of a scene.
pub fn said(errors: Vec<SceneError>) -> Problem {
    errors.into_iter().map(|error| error.to_string()).collect::<Vec<_>>().join("\n").into()
}
