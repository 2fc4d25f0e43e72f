//! Questions: what a receiver asks for, of which every sample takes a part.

use super::world::World;
use crate::camera::Camera;
use crate::geometry::{Start, Vector};
use crate::sampling::Samples;
use std::f64::consts::PI;

/// The parts along each side of a pixel between which rays tell what is seen.
const PARTS: usize = 4;

/// What is asked for.
#[derive(Clone, Debug)]
pub(crate) enum Question {
    /// The irradiance at a point whose unit normal is this.
    Plane { position: Vector, normal: Vector },
    /// The fluence rate at a point, and the three components of vector irradiance.
    Sphere { position: Vector },
    /// The mean irradiance of the front of a surface.
    Surface { surface: usize },
    /// The radiance that arrives from a direction.
    Sight { origin: Vector, direction: Vector },
    /// The mean radiance over a pixel of a camera, in column and row from the upper left.
    Pixel { camera: Camera, pixel: [usize; 2] },
}

/// What rays meet first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Seen {
    /// Whether any of it emits light.
    pub(crate) is_emitter: bool,
    /// The surface that all of them meet, or that they meet none; of rays that meet several there is no one.
    pub(crate) surface: Result<Option<usize>, Several>,
}

/// Rays that meet several surfaces, or one and none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Several;

impl Seen {
    /// What no ray meets.
    pub(crate) const NOTHING: Self = Self { is_emitter: false, surface: Ok(None) };

    /// What is seen by rays that see one and rays that see the other.
    fn with(self, other: Self) -> Self {
        let surface = if self.surface == other.surface { self.surface } else { Err(Several) };
        Self { is_emitter: self.is_emitter || other.is_emitter, surface }
    }
}

/// The begin of a path.
pub(super) enum Begin {
    /// At a receiver with this unit normal, or with none.
    Receiver { start: Start, normal: Option<Vector> },
    /// Along a ray.
    Sight { start: Start, direction: Vector },
}

impl Question {
    /// How many numbers answer it.
    pub(crate) fn numbers(&self) -> usize {
        if matches!(self, Self::Sphere { .. }) { 4 } else { 1 }
    }

    /// The largest number that light brings of which no radiance, or value of a sample, is above this.
    pub(crate) fn largest(&self, radiance: f64) -> f64 {
        match self {
            Self::Plane { .. } | Self::Surface { .. } => PI * radiance,
            Self::Sight { .. } | Self::Pixel { .. } => radiance,
            Self::Sphere { .. } => 4.0 * PI * radiance,
        }
    }

    /// Whether all samples begin at one place, along a ray in one direction.
    pub(super) fn is_of_one_place(&self) -> bool {
        matches!(self, Self::Plane { .. } | Self::Sphere { .. } | Self::Sight { .. })
    }

    /// What is seen directly along a ray, or in a pixel by rays through the corners of parts of it.
    pub(crate) fn seen(&self, world: &World) -> Seen {
        let seen = |origin: Vector, direction: Vector| world.seen(world.walls.start_at(origin), direction);
        match self {
            Self::Sight { origin, direction } => seen(*origin, *direction),
            Self::Pixel { camera, pixel } => {
                let along = |axis: usize, part: usize| pixel[axis] as f64 + part as f64 / PARTS as f64;
                let direction = |corner: usize| {
                    let [x, y] = [corner % (PARTS + 1), corner / (PARTS + 1)];
                    camera.direction(along(0, x), along(1, y)).unit()
                };
                let all = (0..(PARTS + 1) * (PARTS + 1)).filter_map(direction);
                all.map(|direction| seen(camera.origin, direction))
                    .reduce(Seen::with)
                    .unwrap_or(Seen::NOTHING)
            }
            Self::Plane { .. } | Self::Sphere { .. } | Self::Surface { .. } => Seen::NOTHING,
        }
    }

    /// What the numbers are multiplied by, for light that comes from a direction: a receiver integrates over a law of density one.
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

    /// A part of what is asked for.
    pub(super) fn begin(&self, world: &World, samples: &mut Samples) -> Option<Begin> {
        let walls = &world.walls;
        match self {
            Self::Plane { position, normal } => {
                Some(Begin::Receiver { start: walls.start_at(*position), normal: Some(*normal) })
            }
            Self::Sphere { position } => {
                Some(Begin::Receiver { start: walls.start_at(*position), normal: None })
            }
            Self::Surface { surface } => {
                let (wall, position, normal) = world.fronts[*surface].point(samples)?;
                Some(Begin::Receiver { start: walls.start_before(wall, position), normal: Some(normal) })
            }
            Self::Sight { origin, direction } => {
                Some(Begin::Sight { start: walls.start_at(*origin), direction: *direction })
            }
            Self::Pixel { camera, pixel: [column, row] } => {
                let [u, v] = samples.pair();
                let direction = camera.direction(*column as f64 + u, *row as f64 + v).unit()?;
                Some(Begin::Sight { start: walls.start_at(camera.origin), direction })
            }
        }
    }
}
