//! Reads every mesh and scene below a folder, such as a checkout of another program's tests, and
//! reports the refused ones, each with its first error in one line. A table of the errors follows, with
//! the number of files in which each occurs, the most frequent one first. Refused scenes that other
//! scenes include are counted apart: they can lack files and ids that those have.
//!
//! ```sh
//! cargo run --release -p forms-radiometry --example foreign -- FOLDER…
//! ```

use forms_radiometry::scene::{self, SceneError, read_file, read_with_files};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

const MESHES: [&str; 9] = ["obj", "ply", "stl", "msh", "vtk", "vtu", "vtp", "gltf", "glb"];
const SCENES: [&str; 2] = ["xml", "vs3"];

fn main() {
    let mut counts: BTreeMap<String, [usize; 2]> = BTreeMap::new();
    let mut reasons: BTreeMap<String, usize> = BTreeMap::new();
    let mut files = Vec::new();
    std::env::args().skip(1).for_each(|folder| collect(Path::new(&folder), &mut files));
    files.sort();
    let included: BTreeSet<String> = files.iter().flat_map(|file| includes(file)).collect();
    let mut parts = 0;
    for file in files {
        let ending = file.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        let refused = if MESHES.contains(&&*ending) {
            mesh(&file)
        } else if SCENES.contains(&&*ending) {
            scene::open(&file).err()
        } else {
            continue;
        };
        if refused.is_some() && included.iter().any(|name| file.ends_with(name)) {
            parts += 1;
            continue;
        }
        let [read, all] = counts.entry(ending).or_default();
        *all += 1;
        match refused {
            None => *read += 1,
            Some(errors) => {
                let SceneError { line, column, message, .. } = &errors[0];
                println!("{}:{line}:{column}: {message}", file.display());
                let kinds: BTreeSet<String> = errors.iter().map(|error| kind(&error.message)).collect();
                kinds.into_iter().for_each(|kind| *reasons.entry(kind).or_default() += 1);
            }
        }
    }
    let mut reasons: Vec<(String, usize)> = reasons.into_iter().collect();
    reasons.sort_by(|a, b| b.1.cmp(&a.1).then_with(|| a.0.cmp(&b.0)));
    for (reason, count) in reasons {
        println!("{count:5} {reason}");
    }
    for (ending, [read, all]) in counts {
        println!("{ending}: {read} of {all} are read");
    }
    println!("{parts} other files are parts of scenes that include them");
}

/// Returns the names of the files that a scene includes.
fn includes(file: &Path) -> Vec<String> {
    let is_scene = file.extension().is_some_and(|ending| ending == "xml");
    let text = if is_scene { std::fs::read_to_string(file).unwrap_or_default() } else { String::new() };
    let name = |rest: &str| Some(rest.split_once("filename=\"")?.1.split_once('"')?.0.to_owned());
    text.split("<include").skip(1).filter_map(name).collect()
}

/// Returns a message without the names of a file's own objects. Types of objects are kept.
fn kind(message: &str) -> String {
    let parts: Vec<&str> = message.split('`').collect();
    let part = |(index, part): (usize, &&str)| match index % 2 {
        1 if parts[index - 1].ends_with("of type ") => format!("`{part}`"),
        1 => "`…`".to_owned(),
        _ => (*part).to_owned(),
    };
    parts.iter().enumerate().map(part).collect()
}

/// Lists the files below a folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for path in entries.map(|entry| entry.path()) {
        if path.is_dir() { collect(&path, files) } else { files.push(path) }
    }
}

/// Reads a mesh as the only surface of a scene.
fn mesh(file: &Path) -> Option<Vec<SceneError>> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let text = format!(
        "material = [{{ name = \"m\", kind = \"diffuse\", reflectance = 0 }}]\n\
         surface = [{{ name = \"s\", material = \"m\", mesh = {name:?} }}]\n"
    );
    let folder = file.parent().unwrap_or(Path::new(""));
    let name = folder.join("scene.toml");
    let read = |file: &str| read_file(&folder.join(file), 1 << 30);
    match read_with_files(&text, &name.to_string_lossy(), &read) {
        Ok(scene) => {
            scene.notes.iter().for_each(|note| println!("note: {note}"));
            None
        }
        Err(errors) => Some(errors),
    }
}
