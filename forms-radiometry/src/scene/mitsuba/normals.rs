//! Normals: Mitsuba interpolates the normals of a mesh between its vertices, and so does the path
//! tracer here. Emission and irradiance refer to flat faces: a mesh whose interpolated normals would
//! matter to them is an error.
//!
//! Source of the normals of vertices without any: G. Thürmer, C. A. Wüthrich, Computing vertex
//! normals from polygonal facets (1998).

use super::Reader;
use crate::geometry::{Affine, Corners, Mesh, Vector};
use crate::scene::mesh_file::{MeshFile, is_same_normal};
use crate::scene::model::{MaterialKind, ReceiverKind, Shape};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// The largest angle in degrees between normals that are interpolated on a diffuse surface and
/// those of its faces. The two triangles of a quad that is not planar differ by about as much.
const SMALL_ANGLE: f64 = 0.5;

/// A mesh with normals other than those of its faces.
pub(super) struct SmoothMesh {
    pub(super) file: String,
    pub(super) place: Range<usize>,
    pub(super) surface: usize,
    pub(super) normals: Corners<Vector>,
    /// The largest angle in degrees between its normals and those of its faces.
    pub(super) angle: f64,
}

/// Returns the normals at the corners of a mesh that was read from a file and moved by this map. They
/// are those of the file or, where it has none, the means of the normals of the faces around each
/// vertex. `mesh` is the moved mesh, whose faces are reversed if it is flipped.
pub(super) fn of_corners(file: &MeshFile, mesh: &Mesh, to_world: &Affine, flipped: bool) -> Corners<Vector> {
    if file.normals.values.is_empty() {
        return of_vertices(file, mesh, flipped);
    }
    let sign = if flipped { -1.0 } else { 1.0 };
    let unit = |&normal: &Vector| sign * to_world.normal(normal).unit().unwrap_or_default();
    let mut normals =
        Corners { values: file.normals.values.iter().map(unit).collect(), ..Corners::default() };
    for face in 0..mesh.faces().len() {
        normals.push(face, in_order(file.normals.indices_of(face), flipped));
    }
    normals
}

/// Returns the corners of a face, which are reversed if the mesh is flipped.
pub(super) fn in_order<T: Copy>(corners: &[T], flipped: bool) -> Vec<T> {
    if flipped { corners.iter().rev().copied().collect() } else { corners.to_vec() }
}

/// Returns the mean normal of the faces around each vertex, weighted by their angles there. Like
/// Mitsuba, it treats corners with different texture coordinates as different vertices.
fn of_vertices(file: &MeshFile, mesh: &Mesh, flipped: bool) -> Corners<Vector> {
    let mut numbers: HashMap<(u32, Option<u32>), u32> = HashMap::new();
    let mut normals = Corners::default();
    for (face, (corners, polygon)) in mesh.faces().zip(mesh.polygons()).enumerate() {
        let texture = in_order(file.texture.indices_of(face), flipped);
        let vertices = polygon.vertices();
        let count = vertices.len();
        let own = (0..count).map(|i| {
            let next = numbers.len() as u32;
            let number = *numbers.entry((corners[i], texture.get(i).copied())).or_insert(next);
            if number == next {
                normals.values.push(Vector::default());
            }
            let to = |j: usize| (vertices[j % count] - vertices[i]).unit().unwrap_or_default();
            let (next, last) = (to(i + 1), to(i + count - 1));
            let angle = next.cross(last).length().atan2(next.dot(last));
            let sum = &mut normals.values[number as usize];
            *sum = *sum + angle * polygon.normal();
            number
        });
        let own: Vec<u32> = own.collect();
        normals.push(face, own);
    }
    normals.values.iter_mut().for_each(|sum| *sum = sum.unit().unwrap_or_default());
    normals
}

/// Returns the largest angle in degrees between the normals at the corners of a mesh and those of its
/// faces. Normals that differ only by rounding have an angle of zero.
pub(super) fn largest_angle(mesh: &Mesh, normals: &Corners<Vector>) -> f64 {
    let angle = |(face, polygon): (usize, crate::geometry::Polygon)| {
        let own = polygon.normal();
        let of_corner = |normal: Vector| match is_same_normal(normal, own) || normal == Vector::default() {
            true => 0.0,
            false => normal.cross(own).length().atan2(normal.dot(own)).to_degrees(),
        };
        normals.of(face).into_iter().flatten().map(of_corner).fold(0.0, f64::max)
    };
    mesh.polygons().enumerate().map(angle).fold(0.0, f64::max)
}

impl Reader<'_, '_, '_> {
    /// Gives meshes their interpolated normals, and reports those where they are not supported.
    /// Normals do not matter where nothing is reflected, emitted or measured. On diffuse surfaces
    /// small angles are noted.
    pub(super) fn check_normals(&mut self) {
        let mut known: Vec<Range<usize>> = Vec::new();
        let mut noted = HashSet::new();
        for mesh in std::mem::take(&mut self.smooth_meshes) {
            if !self.depends_on_normals(mesh.surface) {
                continue;
            }
            let SmoothMesh { file, place, surface, normals, angle } = mesh;
            let has_flat_quantity = self.surfaces[surface].emits() || self.is_measured(surface);
            if angle <= SMALL_ANGLE && self.is_diffuse_surface(surface) {
                let note = format!(
                    "{file}: the normals of the faces are used, from which interpolated normals differ by \
                     up to {angle:.2}°"
                );
                if noted.insert(note.clone()) {
                    self.report.note(note);
                }
            } else if has_flat_quantity {
                if !known.contains(&place) {
                    known.push(place.clone());
                    let message = format!(
                        "emission and irradiance of `{file}` by interpolated normals are not supported"
                    );
                    self.report.error(place, message, "<boolean name=\"face_normals\" value=\"true\"/>");
                }
            } else if let Shape::Mesh(mesh) = &mut self.surfaces[surface].shape {
                *mesh = Arc::new(mesh.smooth(&normals));
            }
        }
    }

    fn depends_on_normals(&self, index: usize) -> bool {
        let Some(surface) = self.surfaces.get(index) else { return false };
        let is_black = match self.materials.get(surface.material).map(|material| &material.kind) {
            Some(MaterialKind::Diffuse { reflectance }) => reflectance.iter().all(|&part| part == 0.0),
            _ => false,
        };
        !self.receivers.is_empty() && (self.is_measured(index) || !is_black || surface.emits())
    }

    fn is_measured(&self, index: usize) -> bool {
        let measures =
            |kind: &ReceiverKind| matches!(kind, ReceiverKind::Surface { surface, .. } if *surface == index);
        self.receivers.iter().any(|receiver| measures(&receiver.kind))
    }

    fn is_diffuse_surface(&self, index: usize) -> bool {
        let material = self.surfaces.get(index).and_then(|surface| self.materials.get(surface.material));
        material.is_some_and(|material| matches!(material.kind, MaterialKind::Diffuse { .. }))
    }
}
