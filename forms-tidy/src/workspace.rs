//! The workspace on disk: its crates and their source files.

use std::fs;
use std::path::{Path, PathBuf};

use walkdir::WalkDir;

/// The root folder of the workspace.
pub fn root() -> PathBuf {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("a crate of the workspace lies in its root folder").to_path_buf()
}

/// A package of the workspace.
#[derive(Clone, Debug)]
pub struct Package {
    /// Name in `Cargo.toml`.
    pub name: String,
    /// Folder that holds `Cargo.toml`.
    pub folder: PathBuf,
}

/// Returns the packages of the workspace, sorted by name.
pub fn packages(root: &Path) -> Vec<Package> {
    let mut packages: Vec<Package> = fs::read_dir(root)
        .expect("the root folder is readable")
        .filter_map(|entry| Some(entry.ok()?.path()))
        .chain([root.to_path_buf()])
        .filter_map(|folder| Some(Package { name: package_name(&folder.join("Cargo.toml"))?, folder }))
        .collect();
    packages.sort_by(|a, b| a.name.cmp(&b.name));
    packages
}

fn package_name(manifest: &Path) -> Option<String> {
    let text = fs::read_to_string(manifest).ok()?;
    let (_, package) = text.split_once("[package]")?;
    let line = package.lines().find(|line| line.starts_with("name ="))?;
    Some(line.split('"').nth(1)?.to_owned())
}

/// Returns the files below a folder with an extension, in order of their paths; build outputs and hidden folders are skipped.
pub fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let hidden = |name: &str| name == "target" || name.starts_with('.') && name.len() > 1;
    WalkDir::new(folder)
        .sort_by_file_name()
        .into_iter()
        .filter_entry(|entry| entry.depth() == 0 || !hidden(&entry.file_name().to_string_lossy()))
        .filter_map(Result::ok)
        .map(walkdir::DirEntry::into_path)
        .filter(|path| path.extension().is_some_and(|found| found == extension))
        .collect()
}

/// Returns a path relative to the root folder, as messages show it.
pub fn shown(path: &Path, root: &Path) -> String {
    path.strip_prefix(root).unwrap_or(path).display().to_string()
}
