//! Estimands: the quantities that receivers request; each sample evaluates a part of one.

use super::first_hit::FirstHit;
use super::world::World;
use crate::camera::Camera;
use crate::geometry::Vector;
use crate::sampling::Samples;
use crate::visibility::{ReceivingArea, Start};
use std::f64::consts::PI;

/// Number of parts along each side of a pixel. Rays through their corners determine the visible
/// surfaces.
const PARTS: usize = 4;

/// An estimand.
#[derive(Clone, Debug)]
pub(crate) enum Estimand {
    /// Irradiance at a point with this unit normal.
    Plane { position: Vector, normal: Vector },
    /// Fluence rate at a point, and the three components of the vector irradiance.
    Sphere { position: Vector },
    /// Mean irradiance over an area.
    Surface { area: ReceivingArea },
    /// Radiance that arrives from a direction.
    Sight { origin: Vector, direction: Vector },
    /// Mean radiance over a pixel of a camera, in column and row from the upper left.
    Pixel { camera: Camera, pixel: [usize; 2] },
}

/// Start of a path.
pub(super) enum Begin {
    /// At a receiver with this unit normal, or with none.
    Receiver { start: Start, normal: Option<Vector> },
    /// Along a ray.
    Sight { start: Start, direction: Vector },
}

impl Estimand {
    /// Returns the number of values of the estimand.
    pub(crate) fn numbers(&self) -> usize {
        if matches!(self, Self::Sphere { .. }) { 4 } else { 1 }
    }

    /// Returns the largest value for light whose radiance, or value of a sample, is nowhere above
    /// this.
    pub(crate) fn largest(&self, radiance: f64) -> f64 {
        match self {
            Self::Plane { .. } | Self::Surface { .. } => PI * radiance,
            Self::Sight { .. } | Self::Pixel { .. } => radiance,
            Self::Sphere { .. } => 4.0 * PI * radiance,
        }
    }

    /// Whether all samples start at one place, and along a ray in one direction.
    pub(super) fn is_of_one_place(&self) -> bool {
        matches!(self, Self::Plane { .. } | Self::Sphere { .. } | Self::Sight { .. })
    }

    /// Returns the first hit along a ray, or in a pixel the first hits of rays through the corners
    /// of its parts.
    pub(crate) fn seen(&self, world: &World) -> FirstHit {
        let seen = |origin: Vector, direction: Vector| world.seen(world.walls.start_at(origin), direction);
        match self {
            Self::Sight { origin, direction } => seen(*origin, *direction),
            Self::Pixel { camera, pixel } => {
                let along = |axis: usize, part: usize| pixel[axis] as f64 + part as f64 / PARTS as f64;
                let ray = |corner: usize| {
                    let [x, y] = [corner % (PARTS + 1), corner / (PARTS + 1)];
                    let [origin, direction] = camera.ray(along(0, x), along(1, y));
                    Some((origin, direction.unit()?))
                };
                let all = (0..(PARTS + 1) * (PARTS + 1)).filter_map(ray);
                all.map(|(origin, direction)| seen(origin, direction))
                    .reduce(FirstHit::with)
                    .unwrap_or(FirstHit::NOTHING)
            }
            Self::Plane { .. } | Self::Sphere { .. } | Self::Surface { .. } => FirstHit::NOTHING,
        }
    }

    /// Calls `each` with the index and the factor of each value, for light that comes from a
    /// direction. A receiver integrates over a directional density that is normalised to one.
    pub(super) fn measure(&self, direction: Vector, each: &mut impl FnMut(usize, f64)) {
        match self {
            Self::Plane { .. } | Self::Surface { .. } => each(0, PI),
            Self::Sight { .. } | Self::Pixel { .. } => each(0, 1.0),
            Self::Sphere { .. } => {
                let travels = [-direction.x, -direction.y, -direction.z];
                each(0, 4.0 * PI);
                (0..3).for_each(|axis| each(axis + 1, 4.0 * PI * travels[axis]));
            }
        }
    }

    /// Samples the start of a path: a part of the estimand.
    pub(super) fn begin(&self, world: &World, samples: &mut Samples) -> Option<Begin> {
        let walls = &world.walls;
        match self {
            Self::Plane { position, normal } => {
                Some(Begin::Receiver { start: walls.start_at(*position), normal: Some(*normal) })
            }
            Self::Sphere { position } => {
                Some(Begin::Receiver { start: walls.start_at(*position), normal: None })
            }
            Self::Surface { area } => {
                let (wall, position, front) = world.walls_in(*area)?.point(samples)?;
                let normal = if area.is_back { -front } else { front };
                let start = walls.start_beside(wall, position, !area.is_back);
                Some(Begin::Receiver { start, normal: Some(normal) })
            }
            Self::Sight { origin, direction } => {
                Some(Begin::Sight { start: walls.start_at(*origin), direction: *direction })
            }
            Self::Pixel { camera, pixel: [column, row] } => {
                let [u, v] = samples.pair();
                let [origin, direction] = camera.ray(*column as f64 + u, *row as f64 + v);
                Some(Begin::Sight { start: walls.start_at(origin), direction: direction.unit()? })
            }
        }
    }
}
