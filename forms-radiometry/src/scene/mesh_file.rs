//! Mesh files: parses the bytes of a file into a [`Mesh`], or a list of errors with their places in
//! that file.
//!
//! ```text
//! OBJ, PLY, STL, gmsh, VTK, glTF, serialized ─ parts: vertices, faces, groups ─ faces repaired ─▶ mesh, notes
//! ```

mod gltf;
mod gmsh;
mod numbers;
mod obj;
mod parts;
mod ply;
mod ply_header;
mod ply_rows;
mod search;
mod serialized;
mod stl;
mod vtk;

use super::SceneError;
use super::error::Report;
use super::words::{self, Fault};
use crate::geometry::{Corners, Mesh, Vector};
use search::SearchPath;
use std::collections::HashMap;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Endings of mesh files.
const ENDINGS: &str = "a file with the extension .obj, .ply, .stl, .msh, .vtk, .vtu, .vtp, .gltf or .glb";

/// A parsed mesh file.
#[derive(Clone)]
pub(super) struct MeshFile {
    pub(super) mesh: Arc<Mesh>,
    /// The groups of its faces that the file names, in the order of their first faces; empty if it
    /// names none.
    pub(super) groups: Vec<Group>,
    /// The normals and the texture coordinates at the corners of the faces, of formats that scenes of
    /// Mitsuba use. Other readers ignore them.
    pub(super) normals: Arc<Corners<Vector>>,
    pub(super) texture: Arc<Corners<[f64; 2]>>,
}

/// Largest sine of the angle between normals that differ only by rounding.
const SAME_NORMAL: f64 = 1e-6;

/// Whether two unit vectors differ only by rounding.
pub(super) fn is_same_normal(a: Vector, b: Vector) -> bool {
    a.dot(b) > 0.0 && a.cross(b).length() <= SAME_NORMAL
}

/// A group of faces.
#[derive(Clone)]
pub(super) struct Group {
    pub(super) name: String,
    pub(super) faces: Vec<u32>,
}

/// The mesh files of a scene. Each is read once, regardless of how many surfaces name it.
pub(super) struct MeshFiles<'f> {
    /// The folder of the scene, for messages.
    folder: PathBuf,
    open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>,
    search: SearchPath,
    /// The files that were read, by their names and the numbers of their meshes.
    read: HashMap<(String, Option<usize>), Option<MeshFile>>,
}

/// A file that was found: its path relative to the folder of the scene, and its contents.
pub(super) struct Found {
    pub(super) path: String,
    pub(super) bytes: Vec<u8>,
}

impl<'f> MeshFiles<'f> {
    pub(super) fn new(scene_file: &str, open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>) -> Self {
        let folder = Path::new(scene_file).parent().unwrap_or(Path::new("")).to_owned();
        Self { folder, open, search: SearchPath::default(), read: HashMap::new() }
    }

    /// Adds a folder in which files are looked up, as a file in the folder `base` names it.
    pub(super) fn add_folder(&mut self, base: &Path, folder: &str) {
        self.search.add(self.open, base, folder);
    }

    /// Looks a file up. The error is a message and what was expected.
    pub(super) fn find(&self, what: &str, name: &str) -> Result<Found, (String, String)> {
        self.search.find(self.open, what, name)
    }

    /// Returns a path relative to the folder of the scene as messages show it.
    pub(super) fn shown(&self, path: &str) -> String {
        self.folder.join(path).to_string_lossy().into_owned()
    }

    /// Returns the contents of a mesh file that the scene names at this place.
    pub(super) fn file(&mut self, report: &mut Report, place: Range<usize>, name: &str) -> Option<MeshFile> {
        self.known((name, None), |files| files.first(report, place, name))
    }

    /// Returns one mesh of a file of serialized meshes, counted from zero.
    pub(super) fn serialized(
        &mut self,
        report: &mut Report,
        place: Range<usize>,
        name: &str,
        mesh: usize,
    ) -> Option<MeshFile> {
        let read = |file: &str, bytes: &[u8]| serialized::read(file, bytes, mesh);
        self.known((name, Some(mesh)), |files| files.read_by(report, place, name, &read))
    }

    /// Returns a file that was read before, or else reads it.
    fn known(
        &mut self,
        (name, mesh): (&str, Option<usize>),
        read: impl FnOnce(&Self) -> Option<MeshFile>,
    ) -> Option<MeshFile> {
        let key = (name.to_owned(), mesh);
        if let Some(known) = self.read.get(&key) {
            return known.clone();
        }
        let file = read(self);
        self.read.insert(key, file.clone());
        file
    }

    fn first(&self, report: &mut Report, place: Range<usize>, name: &str) -> Option<MeshFile> {
        let ending = Path::new(name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let read: &ReadMesh = match ending.as_deref() {
            Some("obj") => &obj::read,
            Some("ply") => &ply::read,
            Some("stl") => &stl::read,
            Some("msh") => &gmsh::read,
            Some("vtk") => &vtk::read_legacy,
            Some("vtu" | "vtp") => &vtk::read_xml,
            Some("gltf" | "glb") => {
                let folder = Path::new(name).parent().unwrap_or(Path::new(""));
                let open = |uri: &str| (self.open)(&folder.join(uri).to_string_lossy());
                &move |file: &str, bytes: &[u8]| gltf::read(file, bytes, &open)
            }
            _ => {
                let message = format!("`{name}` is not a supported mesh file");
                report.error(place, message, ENDINGS);
                return None;
            }
        };
        self.read_by(report, place, name, read)
    }

    /// Reads a mesh file in this way.
    fn read_by(
        &self,
        report: &mut Report,
        place: Range<usize>,
        name: &str,
        read: &ReadMesh,
    ) -> Option<MeshFile> {
        let Found { path, bytes } = match self.find("mesh", name) {
            Ok(found) => found,
            Err((message, expected)) => {
                report.error(place, message, expected);
                return None;
            }
        };
        let shown = self.shown(&path);
        match read(&shown, &bytes) {
            Ok((file, notes)) => {
                notes.into_iter().for_each(|note| report.note(format!("{shown}: {note}")));
                Some(file)
            }
            Err(errors) => {
                report.include(place.start, errors);
                None
            }
        }
    }
}

/// Parses the bytes of a file with this name.
type ReadMesh<'r> = dyn Fn(&str, &[u8]) -> Result<Read, Vec<SceneError>> + 'r;

/// A file, and notes on parts of it that are read in another way than they are written.
type Read = (MeshFile, Vec<String>);
