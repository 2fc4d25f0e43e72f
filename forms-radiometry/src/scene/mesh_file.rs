//! Mesh files: the bytes of an OBJ or PLY file become a [`Mesh`], or what is wrong with them, with its place in
//! that file.

mod obj;
mod ply;
mod ply_header;
mod ply_rows;
mod words;

use super::SceneError;
use super::error::Report;
use super::place::{Place, Source};
use crate::geometry::{FaceError, Mesh, MeshError, PolygonError, Vector};
use std::collections::HashMap;
use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How many errors of one file are told.
const TOLD: usize = 20;

/// The mesh files of a scene. Each is read once, however many surfaces name it.
pub(super) struct MeshFiles<'f> {
    /// The folder of the scene, for messages.
    folder: PathBuf,
    open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>,
    read: HashMap<String, Option<Arc<Mesh>>>,
}

impl<'f> MeshFiles<'f> {
    pub(super) fn new(scene_file: &str, open: &'f dyn Fn(&str) -> io::Result<Vec<u8>>) -> Self {
        let folder = Path::new(scene_file).parent().unwrap_or(Path::new("")).to_owned();
        Self { folder, open, read: HashMap::new() }
    }

    /// The mesh in a file that the scene names at this place.
    pub(super) fn mesh(&mut self, report: &mut Report, place: Range<usize>, name: &str) -> Option<Arc<Mesh>> {
        if let Some(known) = self.read.get(name) {
            return known.clone();
        }
        let mesh = self.first(report, place, name).map(Arc::new);
        self.read.insert(name.to_owned(), mesh.clone());
        mesh
    }

    fn first(&self, report: &mut Report, place: Range<usize>, name: &str) -> Option<Mesh> {
        let ending = Path::new(name).extension().map(|ending| ending.to_string_lossy().to_lowercase());
        let read: fn(&str, &[u8]) -> Result<Mesh, Vec<SceneError>> = match ending.as_deref() {
            Some("obj") => obj::read,
            Some("ply") => ply::read,
            _ => {
                let message = format!("`{name}` is not known to be a mesh");
                report.error(place, message, "a file whose name ends in .obj or .ply");
                return None;
            }
        };
        let bytes = match (self.open)(name) {
            Ok(bytes) => bytes,
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                report.error(
                    place,
                    format!("there is no file `{name}`"),
                    "a path from the folder of the scene",
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

/// What is wrong at a range of bytes of a mesh file.
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

/// What was read of a mesh file.
#[derive(Default)]
struct Parts {
    vertices: Vec<Vector>,
    faces: Vec<Vec<u32>>,
    /// Where each face is told.
    face_places: Vec<Range<usize>>,
    faults: Vec<Fault>,
}

impl Parts {
    /// The mesh, if nothing was wrong so far and its faces are polygons.
    fn mesh(mut self, source: &Arc<Source>) -> Result<Mesh, Vec<SceneError>> {
        if self.faults.is_empty() && self.faces.is_empty() {
            self.faults.push(Fault::new(
                0..0,
                "the mesh has no faces",
                "faces, each of three vertices or more",
            ));
        }
        if self.faults.is_empty() {
            let vertices = self.vertices.len();
            match Mesh::new(self.vertices, &self.faces) {
                Ok(mesh) => return Ok(mesh),
                Err(errors) => {
                    let fault = |error: MeshError| {
                        let place = self.face_places[error.face].clone();
                        Fault::new(place, error.to_string(), expected(&error.reason, vertices))
                    };
                    self.faults.extend(errors.into_iter().map(fault));
                }
            }
        }
        Err(told(source, self.faults))
    }
}

/// What a face should have been.
fn expected(reason: &FaceError, vertices: usize) -> String {
    match reason {
        FaceError::NoVertex(_) => format!("one of the {vertices} vertices"),
        FaceError::Polygon(PolygonError::NotPlanar { .. }) => {
            "a planar polygon, or the triangles it is made of".to_owned()
        }
        FaceError::Polygon(_) => "a simple planar polygon".to_owned(),
    }
}

/// Faults as errors, the first of them if there are many.
fn told(source: &Arc<Source>, faults: Vec<Fault>) -> Vec<SceneError> {
    let rest = faults.len().saturating_sub(TOLD);
    let error =
        |fault: Fault| SceneError::new(&Place::new(source, fault.range), fault.message, fault.expected);
    let mut errors: Vec<SceneError> = faults.into_iter().take(TOLD).map(error).collect();
    if rest > 0 {
        errors.push(SceneError::of_file(&source.file, format!("{rest} more errors")));
    }
    errors
}
