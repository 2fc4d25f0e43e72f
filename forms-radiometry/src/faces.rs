//! Faces: the surfaces of a scene become the convex planar pieces of their sides.
//!
//! ```text
//! polygon ─▶ its convex pieces          mesh ─▶ those of its polygons
//! ```

use crate::geometry::Face;
use crate::scene::{Scene, Shape};

/// The faces of all surfaces, each front followed by its back. A surface with one side has a back too: it is black, and stops light.
pub(crate) fn faces(scene: &Scene, _fineness: usize) -> Vec<Face> {
    let mut faces = Vec::new();
    for (index, surface) in scene.surfaces.iter().enumerate() {
        match &surface.shape {
            Shape::Polygon(polygon) => faces.extend(Face::of(index, polygon)),
            Shape::Mesh(mesh) => mesh.polygons().for_each(|polygon| faces.extend(Face::of(index, &polygon))),
            Shape::Sphere(_) | Shape::Disk(_) => {}
        }
    }
    faces
}
