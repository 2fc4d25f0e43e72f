//! Walls: intersection of rays with convex polygons and round shapes, for rays that continue from
//! one wall to the next.
//!
//! ```text
//! walls in a BVH ─ a ray from a start ─▶ the first wall it meets: position, normal and side
//! ```
//! A ray never intersects the wall that it leaves, and needs no offset for that. A straight line
//! that leaves a plane does not return to it: that wall is skipped, and with it all walls whose
//! planes contain the start up to rounding, such as the pieces of a subdivided surface. A line that
//! leaves a sphere at o and enters its interior returns at −2 o·d, and at no other distance,
//! whatever the rounding. Hence nothing depends on how far the scene is from the origin, or how
//! large it is.

use super::branches::{Branches, Way};
use super::tree::Tree;
use crate::geometry::bounds::Bounds;
use crate::geometry::plane::{ROUNDING, flatness};
use crate::geometry::sides::sides;
use crate::geometry::{Crossing, Disk, Outline, Plane, Quadric, Sphere, Vector};
use std::ops::ControlFlow;

/// A piece of a surface that rays intersect.
#[derive(Clone, Debug)]
pub(crate) enum Wall {
    /// A convex polygon; its vertices are counter-clockwise seen from the side to which the unit
    /// normal points.
    Polygon {
        vertices: Outline,
        normal: Vector,
    },
    Disk(Disk),
    Sphere(Sphere),
    Quadric(Quadric),
}

/// The walls of a scene.
pub(crate) struct Walls {
    walls: Vec<Wall>,
    branches: Option<Branches>,
    bounds: Bounds,
    /// Rounding error of a distance in the scene.
    rounding: f64,
    /// A given start point counts as lying in a plane that is nearer than this.
    resolution: f64,
}

/// Start of a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Start {
    pub(crate) position: Vector,
    /// The wall that the ray leaves, if any.
    wall: Option<usize>,
    /// Planes that are nearer to the start than this are not intersected.
    clearance: f64,
    /// Whether the ray continues on the front of the wall that it leaves.
    is_front: bool,
}

/// An intersection of a ray with a wall.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Met {
    pub(crate) wall: usize,
    /// The distance from the start, in lengths of the direction.
    pub(crate) distance: f64,
    pub(crate) position: Vector,
    /// The unit normal of the wall's front.
    pub(crate) normal: Vector,
    /// Whether the ray arrives at the front.
    pub(crate) is_front: bool,
}

/// State of a ray during traversal.
struct Ray<'w> {
    walls: &'w Walls,
    start: Start,
    direction: Vector,
    reach: f64,
    /// The nearest wall so far, and whether the ray hits its front.
    first: Option<(usize, bool)>,
}

/// State of a ray that ends at any wall within its reach, near or far.
struct Segment<'w> {
    ray: Ray<'w>,
    /// A wall that it may hit.
    but: Option<usize>,
    is_free: bool,
}

impl Wall {
    /// Returns points whose convex hull contains the wall: its own vertices, those of polygons around
    /// a disk or a quadric, or those of a cube around a sphere.
    pub(crate) fn corners(&self) -> Vec<Vector> {
        match self {
            Self::Polygon { vertices, .. } => vertices.to_vec(),
            Self::Disk(disk) => {
                let wider = |v: Vector| disk.center + 1.02 * (v - disk.center);
                disk.polygon(0).into_iter().map(wider).collect()
            }
            Self::Sphere(Sphere { center, radius, .. }) => {
                let side =
                    |corner: usize, axis: usize| if corner >> axis & 1 == 1 { *radius } else { -radius };
                let corner = |n: usize| *center + Vector::new(side(n, 0), side(n, 1), side(n, 2));
                (0..8).map(corner).collect()
            }
            Self::Quadric(quadric) => quadric.hull().collect(),
        }
    }

    fn bounds(&self) -> Bounds {
        match self {
            Self::Polygon { vertices, .. } => Bounds::of(vertices.iter().copied()),
            Self::Disk(Disk { center, radius, .. }) | Self::Sphere(Sphere { center, radius, .. }) => {
                Bounds::of([*center].into_iter()).wider(*radius)
            }
            Self::Quadric(quadric) => Bounds::of(quadric.hull()),
        }
    }

    /// Returns the largest distance of the vertices from the wall's plane.
    fn flatness(&self) -> f64 {
        if let Self::Polygon { vertices, normal } = self { flatness(vertices, *normal) } else { 0.0 }
    }

    /// Returns the plane of the wall, if it is flat.
    pub(crate) fn plane(&self) -> Option<Plane> {
        match self {
            Self::Polygon { vertices, normal } => Some(Plane { point: vertices[0], normal: *normal }),
            Self::Disk(disk) => Some(Plane { point: disk.center, normal: disk.normal }),
            Self::Sphere(_) | Self::Quadric(_) => None,
        }
    }

    /// Projects an intersection point onto the wall, as exactly as rounding permits, and returns it
    /// with the unit normal there.
    fn foot(&self, position: Vector) -> (Vector, Vector) {
        match self {
            Self::Polygon { .. } | Self::Disk(_) => {
                let plane = self.plane().expect("a flat wall has a plane");
                (position - plane.distance(position) * plane.normal, plane.normal)
            }
            Self::Sphere(Sphere { center, radius, inward }) => {
                let outward = (position - *center).unit().unwrap_or(Vector::new(0.0, 0.0, 1.0));
                (*center + *radius * outward, if *inward { -outward } else { outward })
            }
            Self::Quadric(quadric) => quadric.foot(position),
        }
    }
}

impl Walls {
    pub(crate) fn of(mut walls: Vec<Wall>) -> Self {
        walls.shrink_to_fit();
        let boxes: Vec<Bounds> = walls.iter().map(Wall::bounds).collect();
        let all = boxes.iter().fold(Bounds::NOTHING, |all, &one| all.with(one));
        let rounding = if walls.is_empty() { 0.0 } else { ROUNDING * all.extent().max(all.largest()) };
        let resolution = rounding + walls.iter().map(Wall::flatness).fold(0.0, f64::max);
        let boxes: Vec<Bounds> = boxes.into_iter().map(|one| one.wider(resolution)).collect();
        let branches = (!walls.is_empty()).then(|| Branches::of(&Tree::of(&boxes)));
        Self { walls, branches, bounds: all.wider(resolution), rounding, resolution }
    }

    pub(crate) fn get(&self, wall: usize) -> &Wall {
        &self.walls[wall]
    }

    /// Whether a point is in the bounding box of all walls, up to rounding.
    pub(crate) fn surround(&self, position: Vector) -> bool {
        self.bounds.holds(position)
    }

    /// Returns a start at a position from the scene file, which can lie on a wall.
    pub(crate) fn start_at(&self, position: Vector) -> Start {
        Start { position, wall: None, clearance: self.resolution, is_front: false }
    }

    /// Returns a start on the wall that a ray has hit, on one of its sides.
    pub(crate) fn start_on(&self, met: &Met, is_front: bool) -> Start {
        Start { position: met.position, wall: Some(met.wall), clearance: self.rounding, is_front }
    }

    /// Returns a start at a point of a wall, on its front.
    pub(crate) fn start_before(&self, wall: usize, position: Vector) -> Start {
        self.start_beside(wall, position, true)
    }

    /// Returns a start at a point of a wall, on one of its sides.
    pub(crate) fn start_beside(&self, wall: usize, position: Vector, is_front: bool) -> Start {
        Start { position, wall: Some(wall), clearance: self.resolution, is_front }
    }

    /// Returns a start in free space.
    pub(crate) fn start_free(&self, position: Vector) -> Start {
        Start { position, wall: None, clearance: 0.0, is_front: false }
    }

    /// Returns the first wall that a ray hits within a reach, in lengths of its direction, which is
    /// a unit vector.
    pub(crate) fn first(&self, start: Start, direction: Vector, reach: f64) -> Option<Met> {
        let branches = self.branches.as_ref()?;
        let mut ray = Ray { walls: self, start, direction, reach, first: None };
        branches.walk(&mut ray);
        let (wall, is_front) = ray.first?;
        let (position, normal) = self.walls[wall].foot(start.position + ray.reach * direction);
        Some(Met { wall, distance: ray.reach, position, normal, is_front })
    }

    /// Returns the distance at which a ray hits a wall, whatever lies before it, and whether it hits
    /// the front.
    pub(crate) fn at(&self, wall: usize, start: Start, direction: Vector) -> Option<(f64, bool)> {
        Ray { walls: self, start, direction, reach: f64::INFINITY, first: None }.met(wall)
    }

    /// Whether a ray hits any wall but this one within a reach.
    pub(crate) fn are_between(
        &self,
        start: Start,
        direction: Vector,
        reach: f64,
        but: Option<usize>,
    ) -> bool {
        let ray = Ray { walls: self, start, direction, reach, first: None };
        let mut segment = Segment { ray, but, is_free: true };
        self.branches.iter().for_each(|branches| branches.walk(&mut segment));
        !segment.is_free
    }
}

impl Way for Ray<'_> {
    fn ray(&self) -> [Vector; 2] {
        [self.start.position, self.direction]
    }

    fn end(&self) -> f64 {
        self.reach
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        if let Some((distance, is_front)) = self.met(leaf) {
            (self.reach, self.first) = (distance, Some((leaf, is_front)));
        }
        ControlFlow::Continue(())
    }
}

impl Way for Segment<'_> {
    fn ray(&self) -> [Vector; 2] {
        self.ray.ray()
    }

    fn end(&self) -> f64 {
        self.ray.reach
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        if self.but == Some(leaf) || self.ray.met(leaf).is_none() {
            return ControlFlow::Continue(());
        }
        self.is_free = false;
        ControlFlow::Break(())
    }
}

impl Ray<'_> {
    /// Returns the distance to a wall if the ray hits it within its reach, and whether it hits the
    /// front.
    fn met(&self, wall: usize) -> Option<(f64, bool)> {
        match &self.walls.walls[wall] {
            Wall::Sphere(sphere) => self.sphere(wall, sphere),
            Wall::Quadric(quadric) => self.quadric(wall, quadric),
            flat => self.flat(wall, flat),
        }
    }

    /// Returns the same for a flat wall.
    fn flat(&self, index: usize, wall: &Wall) -> Option<(f64, bool)> {
        let Start { position, wall: left, clearance, .. } = self.start;
        let plane = wall.plane()?;
        let height = plane.distance(position);
        let along = plane.normal.dot(self.direction);
        let comes_nearer = if height > 0.0 { along < 0.0 } else { along > 0.0 };
        if left == Some(index) || height.abs() <= clearance || !comes_nearer {
            return None;
        }
        let (distance, is_front) = (-height / along, height > 0.0);
        if distance >= self.reach {
            return None;
        }
        let is_inside = match wall {
            Wall::Polygon { vertices, .. } => {
                let relative = vertices.iter().map(|&v| v - position);
                sides(relative, is_front).all(|side| side.dot(self.direction) >= 0.0)
            }
            Wall::Disk(disk) => disk.reaches(position + distance * self.direction),
            Wall::Sphere(_) | Wall::Quadric(_) => false,
        };
        is_inside.then_some((distance, is_front))
    }

    /// Returns the same for a sphere: |o + t d|² = R². The root computed as a sum, and the product
    /// of both roots, avoid cancellation.
    fn sphere(&self, index: usize, sphere: &Sphere) -> Option<(f64, bool)> {
        let Start { position, wall: left, is_front, clearance } = self.start;
        let o = position - sphere.center;
        let (b, squared) = (o.dot(self.direction), sphere.radius * sphere.radius);
        let found = |distance: f64, is_outside: bool| {
            (distance >= 0.0 && distance < self.reach).then_some((distance, is_outside != sphere.inward))
        };
        if left == Some(index) {
            let goes_inside = is_front == sphere.inward;
            return goes_inside.then(|| found((-2.0 * b).max(0.0), false)).flatten();
        }
        // vector from the centre to the nearest point of the line
        let beside = o - b * self.direction;
        let root = squared - beside.dot(beside);
        if root <= 0.0 {
            return None;
        }
        let half = root.sqrt();
        let length = o.length();
        let product = (length - sphere.radius) * (length + sphere.radius);
        let (near, far) = if b < 0.0 {
            let far = half - b;
            (product / far, far)
        } else {
            let near = -b - half;
            (near, product / near)
        };
        // a given start on the sphere counts as on it, not in front of it
        let is_on = (length - sphere.radius).abs() <= clearance;
        if product > 0.0 && !is_on {
            return found(near, true).filter(|_| b < 0.0);
        }
        if is_on && b >= 0.0 {
            return None;
        }
        found(if is_on { -2.0 * b } else { far }, false)
    }

    /// Returns the same for a quadric. A ray that starts on it meets it again only where it leaves
    /// the inside.
    fn quadric(&self, index: usize, quadric: &Quadric) -> Option<(f64, bool)> {
        let Start { position, wall: left, is_front, clearance } = self.start;
        let within = |distance: f64| (distance >= 0.0 && distance < self.reach).then_some(distance);
        if left == Some(index) {
            let goes_inside = is_front == quadric.inward;
            let beyond = goes_inside.then(|| quadric.beyond(position, self.direction)).flatten();
            return Some((within(beyond?)?, quadric.inward));
        }
        // a given start on the shape counts as on it, not in front of it
        if quadric.height(position).is_some_and(|height| height.abs() <= clearance) {
            return Some((within(quadric.beyond(position, self.direction)?)?, quadric.inward));
        }
        let crossings = quadric.crossings(position, self.direction).into_iter().flatten();
        let mut found =
            crossings.filter_map(|Crossing { distance, enters }| Some((within(distance)?, enters)));
        found.next().map(|(distance, enters)| (distance, enters != quadric.inward))
    }
}

#[cfg(test)]
mod tests;
