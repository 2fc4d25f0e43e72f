//! Meshes: vertices and indexed faces are checked face by face and become a surface of planar
//! polygons.

use super::flat_parts::flat_parts;
use super::scale::{lengths, of_all};
use super::{Corners, FaceList, Polygon, PolygonError, Vector};
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, OnceLock};

/// A surface of planar polygons that share their vertices.
///
/// A face can have any number of vertices, but it must be a [`Polygon`]: planar, with non-zero
/// area, without self-intersections.
#[derive(Clone, Debug)]
pub struct Mesh {
    vertices: Arc<Vec<Vector>>,
    faces: Arc<FaceList>,
    /// Scale factor of the coordinates: a power of two.
    factor: f64,
    /// The outlines of its flat parts, once they are needed.
    parts: Arc<OnceLock<FaceList>>,
    /// Named groups of its faces.
    groups: Arc<Vec<MeshGroup>>,
    /// The normals at the corners of its faces, all triangles, if normals are interpolated.
    normals: Option<Arc<Corners<Vector>>>,
    /// The texture coordinates at the corners of its faces, all triangles, if it has a texture.
    texture: Option<Arc<Corners<[f64; 2]>>>,
}

/// The name of a group of faces, and their indices.
pub(crate) type MeshGroup = (String, Vec<u32>);

impl PartialEq for Mesh {
    fn eq(&self, other: &Self) -> bool {
        self.vertices == other.vertices
            && self.faces == other.faces
            && self.factor == other.factor
            && self.normals == other.normals
            && self.texture == other.texture
    }
}

/// An invalid face.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshError {
    /// The index of the face, from zero.
    pub face: usize,
    /// The reason.
    pub reason: FaceError,
}

/// Reason why a list of indices is not a valid face.
#[derive(Clone, Debug, PartialEq)]
pub enum FaceError {
    /// This vertex index, which counts from zero, is out of range.
    NoVertex(u32),
    /// The vertices do not form a valid polygon.
    Polygon(PolygonError),
}

impl fmt::Display for MeshError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "face {}: ", self.face + 1)?;
        match &self.reason {
            FaceError::NoVertex(index) => write!(f, "there is no vertex {}", u64::from(*index) + 1),
            FaceError::Polygon(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for MeshError {}

impl Mesh {
    /// Creates the mesh of these faces, each a list of vertex indices, counter-clockwise seen from
    /// its front. Returns all invalid faces if there are any.
    pub fn new(vertices: Vec<Vector>, faces: &[Vec<u32>]) -> Result<Self, Vec<MeshError>> {
        let mut list = FaceList::default();
        faces.iter().for_each(|face| list.push(face.iter().copied()));
        Self::of(vertices, list)
    }

    /// Creates the mesh of a list of faces.
    pub(crate) fn of(vertices: Vec<Vector>, faces: FaceList) -> Result<Self, Vec<MeshError>> {
        let error =
            |(face, indices)| polygon(&vertices, indices).err().map(|reason| MeshError { face, reason });
        let errors: Vec<MeshError> = faces.iter().enumerate().filter_map(error).collect();
        if errors.is_empty() { Ok(Self::of_polygons(vertices, faces)) } else { Err(errors) }
    }

    /// Creates the mesh with these outlines as faces, which share no vertices.
    pub(crate) fn of_outlines<'o>(
        outlines: impl IntoIterator<Item = &'o [Vector]>,
    ) -> Result<Self, Vec<MeshError>> {
        let (mut vertices, mut faces) = (Vec::new(), FaceList::default());
        for outline in outlines {
            let start = vertices.len() as u32;
            vertices.extend_from_slice(outline);
            faces.push(start..vertices.len() as u32);
        }
        Self::of(vertices, faces)
    }

    /// Creates the mesh of faces that are known to be polygons.
    pub(crate) fn of_polygons(vertices: Vec<Vector>, faces: FaceList) -> Self {
        let (vertices, faces) = (Arc::new(vertices), Arc::new(faces));
        let (parts, groups) = (Arc::default(), Arc::default());
        Self { vertices, faces, factor: 1.0, parts, groups, normals: None, texture: None }
    }

    /// Returns the mesh with named groups of its faces.
    pub(crate) fn grouped(&self, groups: Vec<MeshGroup>) -> Self {
        Self { groups: Arc::new(groups), ..self.clone() }
    }

    /// Returns the mesh with interpolated normals in place of those of its faces: the normals at the
    /// corners, which need not have length one. Faces become triangles that share their first
    /// corner; triangles without an area are dropped.
    pub(crate) fn smooth(&self, normals: &Corners<Vector>) -> Self {
        let mut list = FaceList::default();
        let mut of_corners = Corners { values: normals.values.clone(), indices: FaceList::default() };
        for (face, corners) in self.faces().enumerate() {
            let own = normals.indices_of(face);
            for last in 2..corners.len() {
                let triangle = [0, last - 1, last];
                if polygon(&self.vertices, &triangle.map(|corner| corners[corner])).is_err() {
                    continue;
                }
                of_corners.push(list.len(), triangle.iter().filter_map(|&corner| own.get(corner).copied()));
                list.push(triangle.map(|corner| corners[corner]));
            }
        }
        let triangles = Self::of_polygons(self.vertices.to_vec(), list);
        let (normals, texture) = (Some(Arc::new(of_corners)), self.texture.clone());
        Self { factor: self.factor, normals, texture, ..triangles }
    }

    /// Returns the mesh, whose faces are triangles, with texture coordinates at their corners.
    pub(crate) fn textured(self, texture: Corners<[f64; 2]>) -> Self {
        Self { texture: Some(Arc::new(texture)), ..self }
    }

    /// Whether the normals are interpolated between the corners of the faces.
    pub(crate) fn is_smooth(&self) -> bool {
        self.normals.is_some()
    }

    /// Returns the normals at the corners of a triangle, if they are interpolated there.
    pub(crate) fn vertex_normals(&self, face: usize) -> Option<[Vector; 3]> {
        self.normals.as_ref()?.of(face)?.try_into().ok()
    }

    /// Returns the texture coordinates at the corners of a triangle, if it has any.
    pub(crate) fn texture_coordinates(&self, face: usize) -> Option<[[f64; 2]; 3]> {
        self.texture.as_ref()?.of(face)?.try_into().ok()
    }

    /// Returns the named groups of its faces.
    pub(crate) fn groups(&self) -> &[MeshGroup] {
        &self.groups
    }

    /// Returns the vertices, to which faces refer by index.
    pub fn vertices(&self) -> &[Vector] {
        &self.vertices
    }

    /// Returns the vertex indices of each face, counter-clockwise seen from its front.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> {
        self.faces.iter()
    }

    /// Returns the vertices of a face.
    pub(crate) fn corners(&self, face: usize) -> impl Iterator<Item = Vector> {
        self.faces.get(face).iter().map(|&index| self.factor * self.vertices[index as usize])
    }

    /// Returns the faces as polygons.
    pub fn polygons(&self) -> impl Iterator<Item = Polygon> {
        (0..self.faces.len()).map(|face| self.polygon(face))
    }

    /// Returns a face as a polygon.
    pub(crate) fn polygon(&self, face: usize) -> Polygon {
        self.polygon_of(self.faces.get(face))
    }

    fn polygon_of(&self, indices: &[u32]) -> Polygon {
        let polygon = polygon(&self.vertices, indices);
        polygon.expect("every face was a polygon when the mesh was made").scaled(self.factor)
    }

    /// Returns polygons that cover the faces: neighbouring faces in one plane are one polygon, unless
    /// normals or texture coordinates are interpolated on them.
    pub(crate) fn flat_parts(&self) -> impl Iterator<Item = Polygon> {
        let parts = self.parts.get_or_init(|| match self.normals.is_some() || self.texture.is_some() {
            true => FaceList::clone(&self.faces),
            false => flat_parts(&self.vertices, &self.faces),
        });
        parts.iter().map(|indices| self.polygon_of(indices))
    }

    /// Returns the mesh with all coordinates multiplied by a power of two, which rounds nothing.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self { factor: factor * self.factor, ..self.clone() }
    }

    /// Returns the largest coordinate, and the smallest extent of the faces.
    pub(crate) fn lengths(&self) -> [f64; 2] {
        let vertex = |&index: &u32| self.vertices[index as usize];
        let of_face = |face: &[u32]| lengths(&face.iter().map(vertex).collect::<Vec<_>>());
        of_all(self.faces().map(of_face)).map(|length| self.factor * length)
    }

    /// Returns the mesh with its vertices mapped by `image`; faces that are no longer valid
    /// polygons after that are errors. With `reversed`, front and back of every face are swapped.
    pub fn moved(&self, reversed: bool, image: impl Fn(Vector) -> Vector) -> Result<Self, Vec<MeshError>> {
        let vertices = self.vertices.iter().map(|&v| image(v)).collect();
        let mut faces = FaceList::default();
        for face in self.faces() {
            let corners = face.iter().copied();
            if reversed { faces.push(corners.rev()) } else { faces.push(corners) }
        }
        Self::of(vertices, faces)
    }

    /// Returns the mesh of some of the faces, with the vertices that they use.
    pub(crate) fn part(&self, faces: &[u32]) -> Self {
        let (mut vertices, mut numbers) = (Vec::new(), HashMap::new());
        let mut list = FaceList::default();
        for &face in faces {
            list.push(self.faces.get(face as usize).iter().map(|&old| {
                *numbers.entry(old).or_insert_with(|| {
                    vertices.push(self.vertices[old as usize]);
                    vertices.len() as u32 - 1
                })
            }));
        }
        Self { factor: self.factor, ..Self::of_polygons(vertices, list) }
    }
}

fn polygon(vertices: &[Vector], face: &[u32]) -> Result<Polygon, FaceError> {
    let vertex = |&index: &u32| vertices.get(index as usize).copied().ok_or(FaceError::NoVertex(index));
    let corners: Vec<Vector> = face.iter().map(vertex).collect::<Result<_, _>>()?;
    Polygon::new(corners).map_err(FaceError::Polygon)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners() -> Vec<Vector> {
        let bit = |i: u32, axis: u32| f64::from(i >> axis & 1);
        (0..8).map(|i| Vector::new(bit(i, 0), bit(i, 1), bit(i, 2))).collect()
    }

    const FACES: [[u32; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

    fn cube() -> Mesh {
        Mesh::new(corners(), &FACES.map(|face| face.to_vec())).unwrap()
    }

    /// The volume by the divergence theorem: ⅓ Σ A n·x over the faces.
    fn volume(mesh: &Mesh) -> f64 {
        let pieces = mesh.polygons().flat_map(|polygon| polygon.convex_pieces().to_vec());
        let tetrahedron = |a: Vector, b: Vector, c: Vector| a.dot(b.cross(c)) / 6.0;
        let piece = |p: Vec<Vector>| (1..p.len() - 1).map(|i| tetrahedron(p[0], p[i], p[i + 1])).sum::<f64>();
        pieces.map(piece).sum()
    }

    #[test]
    fn the_faces_of_a_cube_enclose_its_volume_and_reversed_the_outside() {
        assert_eq!(volume(&cube()), 1.0);
        assert_eq!(volume(&cube().moved(false, |v| 2.0 * v).unwrap()), 8.0);
        assert_eq!(volume(&cube().moved(true, |v| v).unwrap()), -1.0);
    }

    #[test]
    fn each_face_that_is_none_is_named_with_its_reason() {
        let mut vertices = corners();
        vertices[7].z = 2.0;
        let faces = [vec![0, 1, 8], vec![0, 2, 3, 1], vec![4, 5, 7, 6], vec![0, 1], vec![0, 1, 1]];
        let errors = Mesh::new(vertices, &faces).unwrap_err();
        let shown: Vec<String> = errors.iter().map(ToString::to_string).collect();
        assert_eq!(shown.len(), 4);
        assert_eq!(shown[0], "face 1: there is no vertex 9");
        assert!(shown[1].starts_with("face 3: the polygon is not planar: vertex "), "{}", shown[1]);
        assert_eq!(shown[2], "face 4: a polygon needs at least three vertices, found 2");
        assert_eq!(shown[3], "face 5: vertex 2 and the next vertex coincide");
    }
}
