//! Faces: tessellates the surfaces of a scene into convex planar polygons, one for each side.
//!
//! ```text
//! polygon ─▶ its convex pieces          mesh ─▶ the convex pieces of its flat parts
//!                                       or its faces, where receivers measure them one by one
//! disk ─▶ a regular polygon             sphere ─▶ the triangles of a closed polyhedron
//! annulus, cylinder, cone, paraboloid ─▶ rings of trapezoids
//! ```
//! The pieces of disks and spheres have their areas.

use crate::geometry::Round;
use crate::scene::{Scene, Shape};
use crate::visibility::Face;

/// Returns the faces of all surfaces, each front followed by its back. A one-sided surface has a
/// back too: it is black, and blocks light. Each step of `fineness` doubles the number of edges
/// around a round shape, and around the hole for a disk that lies on a polygon.
pub(crate) fn faces(scene: &Scene, fineness: usize) -> Vec<Face> {
    let mut faces = Vec::new();
    let are_measured = scene.are_faces_measured();
    for (index, surface) in scene.surfaces.iter().enumerate() {
        match &surface.shape {
            Shape::Polygon(polygon) => {
                let pieces = polygon.pieces_at(fineness).into_owned().into_iter();
                faces.extend(pieces.flat_map(|piece| Face::sides(index, &piece, polygon.normal())));
            }
            Shape::Mesh(mesh) if are_measured[index] => {
                for (part, polygon) in mesh.polygons().enumerate() {
                    faces.extend(Face::of(index, &polygon).map(|face| Face { part, ..face }));
                }
            }
            Shape::Mesh(mesh) => {
                mesh.flat_parts().for_each(|polygon| faces.extend(Face::of(index, &polygon)));
            }
            Shape::Disk(disk) => {
                let pieces = disk.pieces(fineness).into_iter();
                faces.extend(pieces.flat_map(|piece| Face::sides(index, &piece, disk.normal)));
            }
            Shape::Quadric(quadric) => {
                let pieces = quadric.pieces(fineness).into_iter();
                faces.extend(pieces.flat_map(|piece| Face::of_outline(index, &piece)));
            }
            Shape::Sphere(sphere) => {
                let triangles = sphere.triangles(fineness).into_iter();
                faces.extend(triangles.flat_map(|triangle| Face::of_outline(index, &triangle)));
            }
        }
    }
    // a mesh can have millions
    faces.shrink_to_fit();
    faces
}

/// Whether a face emits or reflects light: it is a front, or the back of a two-sided surface.
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

/// Returns the radiance that a face emits in each band; an empty slice if it does not emit.
pub(crate) fn emitted<'s>(scene: &'s Scene, face: &Face) -> &'s [f64] {
    if emits(scene, face) { &scene.surfaces[face.surface].radiance } else { &[] }
}

/// Whether a side of a surface emits light.
pub(crate) fn emits_from(scene: &Scene, surface: usize, is_back: bool) -> bool {
    scene.surfaces[surface].emits() && is_side_bright(scene, surface, is_back)
}

/// Whether a scene has round shapes, so that its faces depend on the tessellation level.
pub(crate) fn is_round(scene: &Scene) -> bool {
    round_surfaces(scene).next().is_some()
}

/// Whether disks lie on a surface, so that its faces depend on the tessellation level.
pub(crate) fn has_round_holes(scene: &Scene, surface: usize) -> bool {
    let polygon = scene.surfaces[surface].shape.as_polygon();
    polygon.is_some_and(|polygon| !polygon.round_holes().is_empty())
}

/// Returns the round shapes of a scene, each with the index of its surface.
pub(crate) fn round_surfaces(scene: &Scene) -> impl Iterator<Item = (usize, &dyn Round)> {
    let surfaces = scene.surfaces.iter().enumerate();
    surfaces.filter_map(|(index, surface)| Some((index, surface.shape.as_round()?)))
}
