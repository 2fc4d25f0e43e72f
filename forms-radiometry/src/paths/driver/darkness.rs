//! Darkness: receivers that no light can reach, since nothing lies above their horizon. Their light is
//! exactly zero, which no number of samples tells.
//!
//! ```text
//! faces, spheres and lights of a vacuum that is dark outside ─ all below a plane ─▶ zero
//! ```

use super::analytic::Computed;
use crate::geometry::{Disk, Sphere, Vector};
use crate::paths::Estimand;
use crate::radiosity::Transport;
use crate::scene::{LightKind, Medium, Scene, Shape};

/// Distance above a plane, in units of the largest coordinate, within which the rounding of
/// coordinates decides on which side of it a point lies: the point counts as lying in the plane.
const OF_PLANE: f64 = 8.0 * f64::EPSILON;
/// Maximum number of points that are compared with planes.
const MOST_COMPARED: usize = 10_000_000;

/// What lies in a scene, as seen from a plane.
pub(super) struct Darkness<'s> {
    scene: &'s Scene,
    transport: &'s Transport,
    shapes: Vec<Extent>,
}

/// Extent of a shape.
#[derive(Clone, Copy)]
enum Extent {
    /// The corner of a flat face.
    Corner(Vector),
    Sphere(Sphere),
    Disk(Disk),
}

impl Extent {
    /// Returns a point, and the largest distance along a unit vector from there to a point of the shape.
    fn along(self, normal: Vector) -> (Vector, f64) {
        match self {
            Self::Corner(corner) => (corner, 0.0),
            Self::Sphere(Sphere { center, radius, .. }) => (center, radius),
            Self::Disk(Disk { center, normal: own, radius, .. }) => {
                (center, radius * own.cross(normal).length())
            }
        }
    }
}

impl<'s> Darkness<'s> {
    /// Returns the darkness of a scene for this number of questions, given its faces without any
    /// occlusion; `None` if light may come from everywhere.
    pub(super) fn of(scene: &'s Scene, transport: &'s Transport, questions: usize) -> Option<Self> {
        let is_dark_outside = scene.ambient.radiance.iter().all(|&radiance| radiance == 0.0);
        let is_vacuum = scene.media.iter().all(Medium::is_vacuum);
        if !is_dark_outside || !is_vacuum || questions * transport.faces.len() > MOST_COMPARED {
            return None;
        }
        let mut shapes = Vec::new();
        for surface in &scene.surfaces {
            match &surface.shape {
                Shape::Sphere(sphere) => shapes.push(Extent::Sphere(*sphere)),
                Shape::Disk(disk) => shapes.push(Extent::Disk(*disk)),
                Shape::Polygon(_) | Shape::Mesh(_) => {}
                Shape::Quadric(_) => return None,
            }
        }
        let is_flat =
            |surface: usize| matches!(scene.surfaces[surface].shape, Shape::Polygon(_) | Shape::Mesh(_));
        let flat = transport.faces.iter().filter(|face| is_flat(face.surface));
        shapes.extend(flat.flat_map(|face| &face.vertices).copied().map(Extent::Corner));
        Some(Self { scene, transport, shapes })
    }

    /// Answers a question to whose place no light can come: with zero, number by number and band by
    /// band.
    pub(super) fn answer(&self, estimand: &Estimand) -> Option<Vec<Computed>> {
        let count = estimand.numbers() * self.scene.band_count();
        self.has(estimand).then(|| vec![Computed::default(); count])
    }

    /// Whether no light can come to the place of a question.
    fn has(&self, estimand: &Estimand) -> bool {
        match estimand {
            Estimand::Plane { position, normal } => self.is_above_all(*position, *normal),
            Estimand::Surface { area } => {
                !self.scene.surfaces[area.surface].shape.is_round()
                    && self
                        .transport
                        .faces_in(*area)
                        .all(|face| self.is_above_all(face.vertices[0], face.normal))
            }
            Estimand::Sphere { .. } => self.shapes.is_empty() && self.scene.lights.is_empty(),
            Estimand::Sight { .. } | Estimand::Pixel { .. } => false,
        }
    }

    /// Whether everything lies below the plane through a point with this normal, or in it.
    fn is_above_all(&self, point: Vector, normal: Vector) -> bool {
        let is_below = |extent: Extent| {
            let (from, above) = extent.along(normal);
            normal.dot(from - point) + above <= OF_PLANE * point.largest().max(from.largest())
        };
        let sends_nothing = |kind: &LightKind| match kind {
            LightKind::Point { position, .. } => is_below(Extent::Corner(*position)),
            LightKind::Distant { direction, .. } => normal.dot(*direction) >= 0.0,
        };
        self.shapes.iter().all(|&extent| is_below(extent))
            && self.scene.lights.iter().all(|light| sends_nothing(&light.kind))
    }
}
