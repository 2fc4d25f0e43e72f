//! Ray queries: find the first screen along a ray, or test whether there is any.

use super::branches::Way;
use super::{Screen, Screens};
use crate::geometry::Vector;
use crate::geometry::sides::sides;
use std::ops::ControlFlow;

/// An intersection of a ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    /// The index of the face, front or back, among the faces that the screens were built from.
    pub(crate) face: usize,
    /// The distance from the ray's origin, in lengths of its direction.
    pub(crate) distance: f64,
}

/// State of a ray during traversal: the nearest intersection so far, up to a farthest distance.
struct Ray<'s> {
    screens: &'s Screens,
    origin: Vector,
    direction: Vector,
    /// The farthest distance of the ray.
    reach: f64,
    /// The least distance of the ray's end point from the plane of a screen that it intersects.
    beyond: f64,
    /// Whether any intersection is enough.
    any: bool,
    first: Option<Hit>,
    /// Whether the screen is hit from its front.
    is_front: bool,
}

impl Way for Ray<'_> {
    fn ray(&self) -> [Vector; 2] {
        [self.origin, self.direction]
    }

    fn end(&self) -> f64 {
        self.reach
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        let screen = &self.screens.screens[leaf];
        if let Some((hit, from_front)) = self.met(screen) {
            self.reach = hit.distance;
            self.first = Some(hit);
            self.is_front = from_front;
            if self.any {
                return ControlFlow::Break(());
            }
        }
        ControlFlow::Continue(())
    }
}

impl Ray<'_> {
    /// Returns the intersection with a screen, and whether it is from the front. The origin must be
    /// farther than `resolution` from the screen's plane, and the intersection within the ray's
    /// reach. Of two coincident screens, the ray hits the one whose front faces it.
    fn met(&self, screen: &Screen) -> Option<(Hit, bool)> {
        let height = screen.plane.distance(self.origin);
        let along = screen.plane.normal.dot(self.direction);
        let comes_nearer = if height > 0.0 { along < 0.0 } else { along > 0.0 };
        if height.abs() <= self.screens.resolution || !comes_nearer {
            return None;
        }
        let distance = -height / along;
        let from_front = height > 0.0;
        let ahead = (self.reach - distance) * along.abs();
        let lies_upon = self.first.is_some() && ahead.abs() <= self.screens.resolution;
        let gets_through = if lies_upon { from_front && !self.is_front } else { ahead > self.beyond };
        let hit = Hit { face: screen.sides[usize::from(height < 0.0)], distance };
        (gets_through && self.is_inside(screen, from_front)).then_some((hit, from_front))
    }

    /// Whether the ray's direction lies in the cone over the screen or on its boundary.
    fn is_inside(&self, screen: &Screen, from_front: bool) -> bool {
        let relative = screen.vertices.iter().map(|&v| v - self.origin);
        sides(relative, from_front).all(|side| side.dot(self.direction) >= 0.0)
    }
}

impl Screens {
    /// Returns the first screen that a ray hits, beyond the resolution of the scene.
    pub(crate) fn first(&self, origin: Vector, direction: Vector) -> Option<Hit> {
        self.along(origin, direction, [f64::INFINITY, 0.0], false)
    }

    /// Whether an occluder lies between two points: a screen that has them on different sides.
    pub(crate) fn hides(&self, from: Vector, to: Vector) -> bool {
        self.along(from, to - from, [1.0, self.resolution], true).is_some()
    }

    /// Whether a ray from a point in a direction hits anything.
    pub(crate) fn hides_direction(&self, from: Vector, direction: Vector) -> bool {
        self.along(from, direction, [f64::INFINITY, 0.0], true).is_some()
    }

    fn along(&self, origin: Vector, direction: Vector, [reach, beyond]: [f64; 2], any: bool) -> Option<Hit> {
        let mut ray =
            Ray { screens: self, origin, direction, reach, beyond, any, first: None, is_front: false };
        if let Some(branches) = &self.branches {
            branches.walk(&mut ray);
        }
        ray.first
    }
}
