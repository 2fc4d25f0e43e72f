//! Mesh files: parses the bytes of an OBJ or PLY file into a [`Mesh`], or a list of errors with
//! their places in that file.

mod obj;
mod ply;
mod ply_header;
mod ply_rows;
mod words;

use super::SceneError;
use super::error::Report;
use super::place::{Place, Source};
use crate::geometry::{FaceError, Mesh, MeshError, PolygonError, Vector};
use forms::core::diagnostic::counted;
use std::collections::HashMap;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The largest number of errors that are reported for one file.
const TOLD: usize = 20;

/// A parsed mesh file.
#[derive(Clone)]
pub(super) struct MeshFile {
    pub(super) mesh: Arc<Mesh>,
    /// Whether the file has vertex normals, which are discarded.
    pub(super) has_normals: bool,
}

/// The mesh files of a scene. Each is read once, regardless of how many surfaces name it.
pub(super) struct MeshFiles<'f> {
    /// The folder of the scene, for messages.
    folder: PathBuf,
    open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>,
    read: HashMap<String, Option<MeshFile>>,
}

impl<'f> MeshFiles<'f> {
    pub(super) fn new(scene_file: &str, open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>) -> Self {
        let folder = Path::new(scene_file).parent().unwrap_or(Path::new("")).to_owned();
        Self { folder, open, read: HashMap::new() }
    }

    /// Returns the mesh in a file that the scene names at this place.
    pub(super) fn mesh(&mut self, report: &mut Report, place: Range<usize>, name: &str) -> Option<Arc<Mesh>> {
        self.file(report, place, name).map(|file| file.mesh)
    }

    /// Returns the mesh, and whether the file has vertex normals.
    pub(super) fn file(&mut self, report: &mut Report, place: Range<usize>, name: &str) -> Option<MeshFile> {
        if let Some(known) = self.read.get(name) {
            return known.clone();
        }
        let file = self.first(report, place, name);
        self.read.insert(name.to_owned(), file.clone());
        file
    }

    fn first(&self, report: &mut Report, place: Range<usize>, name: &str) -> Option<MeshFile> {
        let ending = Path::new(name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let read: fn(&str, &[u8]) -> Result<MeshFile, Vec<SceneError>> = match ending.as_deref() {
            Some("obj") => obj::read,
            Some("ply") => ply::read,
            _ => {
                let message = format!("`{name}` is not a supported mesh file");
                report.error(place, message, "a file with the extension .obj or .ply");
                return None;
            }
        };
        let bytes = match (self.open)(name) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                report.error(
                    place,
                    format!("there is no file `{name}`"),
                    "a path relative to the folder of the scene file",
                );
                return None;
            }
            Err(error) => {
                report.error(place, format!("the mesh `{name}` cannot be read: {error}"), "");
                return None;
            }
        };
        let shown = self.folder.join(name).to_string_lossy().into_owned();
        read(&shown, &bytes).map_err(|errors| report.include(place.start, errors)).ok()
    }
}

/// An error at a range of bytes of a mesh file.
struct Fault {
    range: Range<usize>,
    message: String,
    expected: String,
}

impl Fault {
    fn new(range: Range<usize>, message: impl Into<String>, expected: impl Into<String>) -> Self {
        Self { range, message: message.into(), expected: expected.into() }
    }
}

/// The contents of a mesh file.
#[derive(Default)]
struct Parts {
    vertices: Vec<Vector>,
    faces: Vec<Vec<u32>>,
    /// The place of each face in the file.
    face_places: Vec<Range<usize>>,
    has_normals: bool,
    faults: Vec<Fault>,
    /// The number of further faults, which are only counted.
    more: usize,
}

impl Parts {
    /// Returns the mesh, if there were no faults so far and its faces are valid polygons.
    fn mesh(mut self, source: &Arc<Source>) -> Result<MeshFile, Vec<SceneError>> {
        if self.faults.is_empty() && self.faces.is_empty() {
            let expected = "faces with at least three vertices each";
            self.fault(Fault::new(0..0, "the mesh has no faces", expected));
        }
        if self.faults.is_empty() {
            let vertices = self.vertices.len();
            match Mesh::new(std::mem::take(&mut self.vertices), &self.faces) {
                Ok(mesh) => return Ok(MeshFile { mesh: Arc::new(mesh), has_normals: self.has_normals }),
                Err(errors) => {
                    for MeshError { face, reason } in errors {
                        let place = self.face_places[face].clone();
                        let expected = expected(&reason, vertices);
                        self.fault(Fault::new(place, MeshError { face, reason }.to_string(), expected));
                    }
                }
            }
        }
        Err(told(source, self.faults, self.more))
    }

    /// Records a fault. Faults beyond the limit are only counted.
    fn fault(&mut self, fault: Fault) {
        if self.faults.len() < TOLD {
            self.faults.push(fault);
        } else {
            self.more += 1;
        }
    }
}

/// Describes the face that was expected.
fn expected(reason: &FaceError, vertices: usize) -> String {
    match reason {
        FaceError::NoVertex(_) => format!("one of the {vertices} vertices"),
        FaceError::Polygon(PolygonError::NotPlanar { .. }) => {
            "a planar polygon, or triangles in its place".to_owned()
        }
        FaceError::Polygon(_) => "a simple planar polygon".to_owned(),
    }
}

/// Converts faults to errors, with the number of further ones.
fn told(source: &Arc<Source>, faults: Vec<Fault>, more: usize) -> Vec<SceneError> {
    let error =
        |fault: Fault| SceneError::new(&Place::new(source, fault.range), fault.message, fault.expected);
    let mut errors: Vec<SceneError> = faults.into_iter().map(error).collect();
    if more > 0 {
        let rest = counted(more, "more error");
        errors.push(SceneError::of_file(&source.file, rest));
    }
    errors
}
