//! Faces: the surfaces of a scene become the convex planar pieces of their sides.
//!
//! ```text
//! polygon ─▶ its convex pieces          mesh ─▶ those of its polygons
//! disk ─▶ a regular polygon             sphere ─▶ the triangles of a closed polyhedron          both of the same area
//! ```

use crate::geometry::{Face, Round};
use crate::scene::{Scene, Shape};

/// The faces of all surfaces, each front followed by its back. A surface with one side has a back too: it is black, and stops light.
/// Each step of fineness doubles the number of edges round a disk, a sphere, or the hole for a disk that lies on a polygon.
pub(crate) fn faces(scene: &Scene, fineness: usize) -> Vec<Face> {
    let mut faces = Vec::new();
    for (index, surface) in scene.surfaces.iter().enumerate() {
        match &surface.shape {
            Shape::Polygon(polygon) => {
                let pieces = polygon.pieces_at(fineness).into_owned().into_iter();
                faces.extend(pieces.flat_map(|piece| Face::sides(index, piece, polygon.normal())));
            }
            Shape::Mesh(mesh) => mesh.polygons().for_each(|polygon| faces.extend(Face::of(index, &polygon))),
            Shape::Disk(disk) => faces.extend(Face::sides(index, disk.polygon(fineness), disk.normal)),
            Shape::Sphere(sphere) => {
                let triangles = sphere.triangles(fineness).into_iter();
                faces.extend(triangles.flat_map(|triangle| Face::of_triangle(index, triangle)));
            }
        }
    }
    faces
}

/// Whether a face sends or reflects light: it is a front, or the back of a surface with two sides.
pub(crate) fn is_bright(scene: &Scene, face: &Face) -> bool {
    is_side_bright(scene, face.surface, face.is_back)
}

fn is_side_bright(scene: &Scene, surface: usize, is_back: bool) -> bool {
    !is_back || scene.surfaces[surface].two_sided
}

/// Whether a face emits light.
pub(crate) fn emits(scene: &Scene, face: &Face) -> bool {
    emits_from(scene, face.surface, face.is_back)
}

/// The radiance that a face emits, for each band; nothing if it emits none.
pub(crate) fn emitted<'s>(scene: &'s Scene, face: &Face) -> &'s [f64] {
    if emits(scene, face) { &scene.surfaces[face.surface].radiance } else { &[] }
}

/// Whether a side of a surface emits light.
pub(crate) fn emits_from(scene: &Scene, surface: usize, is_back: bool) -> bool {
    scene.surfaces[surface].emits() && is_side_bright(scene, surface, is_back)
}

/// Whether the faces of a scene stand for round shapes, so that they depend on their fineness.
pub(crate) fn is_round(scene: &Scene) -> bool {
    round_surfaces(scene).next().is_some()
}

/// Whether disks lie on a surface, so that its faces depend on their fineness.
pub(crate) fn has_round_holes(scene: &Scene, surface: usize) -> bool {
    let polygon = scene.surfaces[surface].shape.as_polygon();
    polygon.is_some_and(|polygon| !polygon.round_holes().is_empty())
}

/// The round surfaces of a scene, each with its index.
pub(crate) fn round_surfaces(scene: &Scene) -> impl Iterator<Item = (usize, &dyn Round)> {
    let surfaces = scene.surfaces.iter().enumerate();
    surfaces.filter_map(|(index, surface)| Some((index, surface.shape.as_round()?)))
}
