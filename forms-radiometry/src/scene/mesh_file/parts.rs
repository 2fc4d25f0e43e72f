//! Parts: the vertices, faces and groups of a mesh file are collected, and become a mesh whose faces
//! are planar polygons, with notes on the faces that had to be changed.

use super::{Fault, Group, MeshFile, Read};
use crate::geometry::{Corners, FaceList, Mesh, PolygonError, Repaired, Vector, repaired};
use crate::scene::SceneError;
use crate::scene::place::{Place, Source};
use forms::core::diagnostic::counted;
use rustc_hash::FxHasher;
use std::collections::HashMap;
use std::hash::{Hash, Hasher};
use std::ops::Range;
use std::sync::Arc;

/// The largest number of errors that are reported for one file.
const TOLD: usize = 20;

/// The contents of a mesh file.
#[derive(Default)]
pub(super) struct Parts {
    pub(super) vertices: Vec<Vector>,
    faces: FaceList,
    /// The first and the last byte of each face in the file: files are below 4 GiB.
    places: Vec<[u32; 2]>,
    groups: Vec<String>,
    group_numbers: HashMap<String, u32>,
    /// The group of the faces that follow, and the group of each face.
    current: Option<u32>,
    group_of: Vec<Option<u32>>,
    /// The normals at the corners of the faces, which need not have length one.
    pub(super) normals: Corners<Vector>,
    pub(super) texture: Corners<[f64; 2]>,
    faults: Vec<Fault>,
    /// The number of further faults, which are only counted.
    more: usize,
    notes: Vec<String>,
}

/// The elements of a file that are not flat faces.
#[derive(Default)]
pub(super) struct Elements {
    /// Faces that are read as flat.
    pub(super) curved: usize,
    /// Points, lines and volumes.
    pub(super) skipped: usize,
}

impl Elements {
    /// Adds a note on curved faces, and a fault if there are only elements that are no faces.
    pub(super) fn note(&self, parts: &mut Parts, element: &str, expected: &str) {
        if parts.faces.is_empty() && self.skipped > 0 {
            let skipped = counted(self.skipped, element);
            let message = format!("the mesh has no faces: its {skipped} are points, lines or volumes");
            parts.fault(Fault::new(0..0, message, expected));
        }
        if self.curved > 0 {
            let curved = counted(self.curved, "curved face");
            parts.note(format!("{curved} read as flat between the corners"));
        }
    }
}

/// The number of faces that were read in another way than they are written.
#[derive(Default)]
struct Changed {
    dropped: usize,
    repeated: usize,
    shortened: usize,
    triangulated: usize,
}

impl Parts {
    /// Adds a face with these vertices, which count from zero, and its place in the file.
    pub(super) fn face(&mut self, corners: impl IntoIterator<Item = u32>, place: Range<usize>) {
        self.faces.push(corners);
        self.places.push([place.start as u32, place.end as u32]);
        self.group_of.push(self.current);
    }

    /// Returns the number of faces so far.
    pub(super) fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// Keeps the normals and the texture coordinates of the vertices, which belong to the corners of
    /// the faces there, if the file has them.
    pub(super) fn keep_attributes(&mut self, has_normals: bool, has_texture: bool) {
        if has_normals {
            self.normals.indices = self.faces.clone();
        } else {
            self.normals = Corners::default();
        }
        if has_texture {
            self.texture.indices = self.faces.clone();
        } else {
            self.texture = Corners::default();
        }
    }

    /// Adds a note on what was read in another way than it is written.
    pub(super) fn note(&mut self, note: String) {
        self.notes.push(note);
    }

    /// Begins a group: the faces that follow belong to it. An empty name ends the last group.
    pub(super) fn group(&mut self, name: &str) {
        self.current = (!name.is_empty()).then(|| {
            *self.group_numbers.entry(name.to_owned()).or_insert_with(|| {
                self.groups.push(name.to_owned());
                self.groups.len() as u32 - 1
            })
        });
    }

    /// Records a fault. Faults beyond the limit are only counted.
    pub(super) fn fault(&mut self, fault: Fault) {
        if self.faults.len() < TOLD {
            self.faults.push(fault);
        } else {
            self.more += 1;
        }
    }

    /// Returns the mesh with notes on its faces, if there were no faults. The mesh can be empty.
    pub(super) fn mesh(mut self, source: &Arc<Source>) -> Result<Read, Vec<SceneError>> {
        let mut groups = Vec::new();
        let mut list = FaceList::default();
        if self.faults.is_empty() {
            let (repaired, group_of, changed) = self.repaired();
            (list, groups) = (repaired, self.grouped(&group_of));
            self.notes.extend(changed.notes());
        }
        if !self.faults.is_empty() {
            return Err(told(source, self.faults, self.more));
        }
        let mesh = Arc::new(Mesh::of_polygons(self.vertices, list));
        let (normals, texture) = (Arc::new(self.normals), Arc::new(self.texture));
        Ok((MeshFile { mesh, groups, normals, texture }, self.notes))
    }

    /// Returns the polygons that the faces stand for, each with its group. Faces that stand for
    /// none are faults.
    fn repaired(&mut self) -> (FaceList, Vec<Option<u32>>, Changed) {
        let (mut list, mut group_of, mut changed) = (FaceList::default(), Vec::new(), Changed::default());
        let mut faults = Vec::new();
        let (mut normals, mut texture) = (FaceList::default(), FaceList::default());
        let repeated = self.repeated();
        changed.repeated = repeated.len();
        let mut repeated = repeated.into_iter().peekable();
        for index in 0..self.faces.len() {
            if repeated.next_if_eq(&(index as u32)).is_some() {
                continue;
            }
            let face = self.faces.get(index);
            let polygons = match self.polygons_of(face) {
                Ok(polygons) => polygons,
                Err((message, expected)) => {
                    let [start, end] = self.places[index].map(|byte| byte as usize);
                    let message = format!("face {}: {message}", index + 1);
                    faults.push(Fault::new(start..end, message, expected));
                    continue;
                }
            };
            let before = list.len();
            for corners in changed.corners(polygons, face.len()) {
                let pick =
                    |from: &[u32]| corners.iter().filter_map(|&i| from.get(i).copied()).collect::<Vec<_>>();
                list.push(corners.iter().map(|&corner| face[corner]));
                normals.push(pick(self.normals.indices_of(index)));
                texture.push(pick(self.texture.indices_of(index)));
            }
            group_of.extend((before..list.len()).map(|_| self.group_of[index]));
        }
        faults.into_iter().for_each(|fault| self.fault(fault));
        (self.normals.indices, self.texture.indices) = (normals, texture);
        (list, group_of, changed)
    }

    /// Returns the faces, in order, that have the same vertices in the same order as an earlier one,
    /// wherever they begin: they would emit and reflect twice. A face and its reverse are two sides.
    fn repeated(&self) -> Vec<u32> {
        let bits = |index: u32| {
            let vertex = self.vertices.get(index as usize);
            vertex.map_or([u64::from(index); 3], |v| v.coordinates().map(|x| (x + 0.0).to_bits()))
        };
        let cycle = |face: usize| {
            let corners = self.faces.get(face);
            let first = (0..corners.len()).min_by_key(|&place| bits(corners[place])).unwrap_or(0);
            corners[first..].iter().chain(&corners[..first]).map(|&corner| bits(corner))
        };
        let hash = |face: u32| {
            let mut hasher = FxHasher::default();
            cycle(face as usize).for_each(|bits| bits.hash(&mut hasher));
            (hasher.finish(), face)
        };
        let mut all: Vec<(u64, u32)> = (0..self.faces.len() as u32).map(hash).collect();
        all.sort_unstable();
        let same = all.chunk_by(|a, b| a.0 == b.0).filter(|same| same.len() > 1);
        let mut repeated: Vec<u32> = same
            .flat_map(|same| {
                let is_again = |place: usize| {
                    same[..place]
                        .iter()
                        .any(|&(_, other)| cycle(other as usize).eq(cycle(same[place].1 as usize)))
                };
                (1..same.len())
                    .filter(|&place| is_again(place))
                    .map(|place| same[place].1)
                    .collect::<Vec<_>>()
            })
            .collect();
        repeated.sort_unstable();
        repeated
    }

    /// Returns what a face stands for, or what is wrong with it and what was expected.
    fn polygons_of(&self, face: &[u32]) -> Result<Repaired, (String, String)> {
        let mut corners = Vec::with_capacity(face.len());
        for &index in face {
            let Some(&vertex) = self.vertices.get(index as usize) else {
                let message = format!("there is no vertex {}", u64::from(index) + 1);
                return Err((message, format!("one of the {} vertices", self.vertices.len())));
            };
            corners.push(vertex);
        }
        repaired(&corners)
            .map_err(|error: PolygonError| (error.to_string(), "a polygon without crossing edges".to_owned()))
    }

    /// Returns the groups that have faces, and the faces of each.
    fn grouped(&self, group_of: &[Option<u32>]) -> Vec<Group> {
        let mut groups: Vec<Group> =
            self.groups.iter().map(|name| Group { name: name.clone(), faces: Vec::new() }).collect();
        if groups.is_empty() {
            return groups;
        }
        let mut rest = Vec::new();
        for (face, group) in group_of.iter().enumerate() {
            let faces = group.map_or(&mut rest, |group| &mut groups[group as usize].faces);
            faces.push(face as u32);
        }
        groups.push(Group { name: REST.to_owned(), faces: rest });
        groups.retain(|group| !group.faces.is_empty());
        groups.sort_by_key(|group| group.faces[0]);
        groups
    }
}

/// The group of faces outside all groups of a file.
const REST: &str = "rest";

impl Changed {
    /// Returns the corners of the polygons that a face with this number of corners stands for, and
    /// counts a change.
    fn corners(&mut self, polygons: Repaired, count: usize) -> Vec<Vec<usize>> {
        match polygons {
            Repaired::Whole => vec![(0..count).collect()],
            Repaired::Shorter(kept) => {
                self.shortened += 1;
                vec![kept]
            }
            Repaired::Triangles(triangles) => {
                self.triangulated += 1;
                triangles.iter().map(|corners| corners.to_vec()).collect()
            }
            Repaired::Nothing => {
                self.dropped += 1;
                Vec::new()
            }
        }
    }

    /// Describes the changes, each kind once.
    fn notes(&self) -> Vec<String> {
        let &Self { dropped, repeated, shortened, triangulated } = self;
        let note = |count: usize, done: &str| {
            let was = if count == 1 { "was" } else { "were" };
            (count > 0).then(|| format!("{} {was} {done}", counted(count, "face")))
        };
        let notes = [
            note(dropped, "dropped for want of an area"),
            note(repeated, "dropped, being there twice"),
            note(shortened, "read without a repeated vertex"),
            note(triangulated, "divided into triangles, not being planar"),
        ];
        notes.into_iter().flatten().collect()
    }
}

/// Converts faults to errors, with the number of further ones. In a file without text their messages
/// say where they are.
pub(super) fn told(source: &Arc<Source>, faults: Vec<Fault>, more: usize) -> Vec<SceneError> {
    let error = |fault: Fault| match source.text.is_empty() {
        true => SceneError::of_file(&source.file, fault.message).expecting(fault.expected),
        false => SceneError::new(&Place::new(source, fault.range), fault.message, fault.expected),
    };
    let mut errors: Vec<SceneError> = faults.into_iter().map(error).collect();
    if more > 0 {
        let rest = counted(more, "more error");
        errors.push(SceneError::of_file(&source.file, rest));
    }
    errors
}
