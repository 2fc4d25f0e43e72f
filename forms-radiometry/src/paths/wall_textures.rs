//! Textures of walls: the place on a wall becomes texture coordinates, and these the factor of the
//! reflectance of its material.
//!
//! ```text
//! parallelogram, triangle   a + p (b − a) + q (c − a)      (u, v) is linear in p and q
//! sphere                    azimuth φ, angle θ to the axis  (φ/2π, θ/π)
//! disk                      distance r, azimuth φ           (r/R, φ/2π)
//! ```

use super::interface::Interface;
use crate::geometry::Vector;
use crate::scene::{Pattern, Scene, Shape, Texture, TextureCoordinates};
use crate::visibility::{Met, Wall};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// The textures of walls; a wall has none if its surface has none.
pub(super) struct WallTextures(Vec<Option<Box<WallTexture>>>);

struct WallTexture {
    pattern: Arc<Pattern>,
    chart: Chart,
}

/// Texture coordinates of a wall by the place.
enum Chart {
    Linear {
        corner: Vector,
        /// Vectors whose products with the offset from the corner are p and q.
        coordinates: [Vector; 2],
        uv: [[f64; 2]; 3],
    },
    Sphere {
        center: Vector,
        axes: [Vector; 3],
    },
    Disk {
        center: Vector,
        radius: f64,
        axes: [Vector; 3],
    },
}

impl WallTextures {
    pub(super) fn of(scene: &Scene, walls: &[Wall], interfaces: &[Interface]) -> Self {
        if scene.surfaces.iter().all(|surface| surface.texture.is_none()) {
            return Self(Vec::new());
        }
        let of_wall = |(wall, interface): (&Wall, &Interface)| {
            let surface = &scene.surfaces[interface.surface];
            let Texture { pattern, coordinates } = surface.texture.as_ref()?;
            let chart = chart(coordinates, &surface.shape, wall, interface.part)?;
            Some(Box::new(WallTexture { pattern: Arc::clone(pattern), chart }))
        };
        Self(walls.iter().zip(interfaces).map(of_wall).collect())
    }

    /// Returns the factor of the reflectance at a place on a wall in these bands, if it has a texture.
    pub(super) fn factor<const N: usize>(&self, met: &Met, bands: [usize; 2]) -> Option<[f64; N]> {
        let texture = self.0.get(met.wall)?.as_ref()?;
        Some(texture.pattern.factor(texture.chart.at(met.position), bands))
    }
}

/// Returns the texture coordinates of a wall.
fn chart(coordinates: &TextureCoordinates, shape: &Shape, wall: &Wall, face: usize) -> Option<Chart> {
    match (coordinates, shape, wall) {
        (TextureCoordinates::Corners(uv), Shape::Polygon(polygon), _) => {
            let corners = polygon.vertices();
            Chart::linear([corners[0], corners[1], corners[2]], uv.get(..3)?.try_into().ok()?)
        }
        (TextureCoordinates::Mesh, Shape::Mesh(mesh), _) => {
            let corners: Vec<Vector> = mesh.corners(face).collect();
            Chart::linear(corners.try_into().ok()?, mesh.texture_coordinates(face)?)
        }
        (TextureCoordinates::Polar(axes), _, Wall::Sphere(sphere)) => {
            Some(Chart::Sphere { center: sphere.center, axes: *axes })
        }
        (TextureCoordinates::Polar(axes), _, Wall::Disk(disk)) => {
            Some(Chart::Disk { center: disk.center, radius: disk.radius, axes: *axes })
        }
        _ => None,
    }
}

impl Chart {
    fn linear([a, b, c]: [Vector; 3], uv: [[f64; 2]; 3]) -> Option<Self> {
        let (along, across) = (b - a, c - a);
        let normal = along.cross(across);
        let scale = 1.0 / normal.dot(normal);
        let coordinates = [scale * across.cross(normal), scale * normal.cross(along)];
        scale.is_finite().then_some(Self::Linear { corner: a, coordinates, uv })
    }

    fn at(&self, position: Vector) -> [f64; 2] {
        let turns = |[x, y]: [f64; 2]| (y.atan2(x) / TAU).rem_euclid(1.0);
        match self {
            Self::Linear { corner, coordinates, uv: [a, b, c] } => {
                let [p, q] = coordinates.map(|along| along.dot(position - *corner));
                [0, 1].map(|axis| a[axis] + p * (b[axis] - a[axis]) + q * (c[axis] - a[axis]))
            }
            Self::Sphere { center, axes } => {
                let offset = position - *center;
                let [x, y, z] = axes.map(|axis| axis.dot(offset));
                [turns([x, y]), x.hypot(y).atan2(z) / PI]
            }
            Self::Disk { center, radius, axes } => {
                let offset = position - *center;
                let [x, y, _] = axes.map(|axis| axis.dot(offset));
                [x.hypot(y) / radius, turns([x, y])]
            }
        }
    }
}
