//! Shading normals: on a mesh whose normals are interpolated, the normal at a point of a triangle
//! follows from the normals at its corners.
//!
//! ```text
//! corners a, b, c, normals n_a, n_b, n_c; a point a + p (b − a) + q (c − a)
//! normal ∝ (1 − p − q) n_a + p n_b + q n_c
//! ```
//! Light is scattered as if the surface had this normal, but rays meet the triangle. A direction
//! above the interpolated horizon can therefore lie below the triangle, where its ray continues, as
//! in Mitsuba.
//!
//! Source: B. T. Phong, Illumination for computer generated pictures (1975).

use crate::geometry::Vector;
use crate::scene::{Scene, Shape};

/// The interpolated normals of walls; a wall has none if its surface is not a smooth mesh.
pub(super) struct ShadingNormals {
    /// The triangle of each wall; empty if no surface is smooth.
    triangles: Vec<Option<Box<Triangle>>>,
    /// The number of pieces of each surface so far.
    pieces: Vec<u32>,
}

/// A triangle with the normals at its corners.
struct Triangle {
    corner: Vector,
    /// Vectors whose products with the offset from the corner are p and q.
    coordinates: [Vector; 2],
    normals: [Vector; 3],
    /// The normal of the triangle, where the interpolated one has length zero.
    own: Vector,
}

impl ShadingNormals {
    /// Returns the normals of no walls yet.
    pub(super) fn of(scene: &Scene) -> Self {
        let has_smooth = scene.surfaces.iter().any(|surface| surface.shape.is_smooth());
        Self {
            triangles: Vec::new(),
            pieces: if has_smooth { vec![0; scene.surfaces.len()] } else { Vec::new() },
        }
    }

    /// Adds the next piece of a surface, which consists of this number of walls.
    pub(super) fn add_piece(&mut self, scene: &Scene, surface: usize, walls: usize) {
        let Some(face) = self.pieces.get_mut(surface) else { return };
        let triangle = |_| match &scene.surfaces[surface].shape {
            Shape::Mesh(mesh) => {
                Triangle::of(mesh.corners(*face as usize), mesh.vertex_normals(*face as usize))
            }
            _ => None,
        };
        self.triangles.extend((0..walls).map(triangle));
        *face += 1;
    }

    /// Returns the interpolated unit normal at a point of a wall, on its front.
    pub(super) fn normal(&self, wall: usize, position: Vector) -> Option<Vector> {
        self.triangles.get(wall)?.as_ref().map(|triangle| triangle.at(position))
    }
}

impl Triangle {
    fn of(corners: impl Iterator<Item = Vector>, normals: Option<[Vector; 3]>) -> Option<Box<Self>> {
        let (normals, corners) = (normals?, corners.collect::<Vec<_>>());
        let [a, b, c] = corners[..] else { return None };
        let (u, v) = (b - a, c - a);
        let normal = u.cross(v);
        let scale = 1.0 / normal.dot(normal);
        let coordinates = [scale * v.cross(normal), scale * normal.cross(u)];
        Some(Box::new(Self { corner: a, coordinates, normals, own: normal.unit()? }))
    }

    fn at(&self, position: Vector) -> Vector {
        let [p, q] = self.coordinates.map(|along| along.dot(position - self.corner));
        let [a, b, c] = self.normals;
        ((1.0 - p - q) * a + p * b + q * c).unit().unwrap_or(self.own)
    }
}
