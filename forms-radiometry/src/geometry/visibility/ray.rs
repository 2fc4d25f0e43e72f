//! Rays: an origin and a direction become the first screen that is met, or whether there is one.

use super::branches::Way;
use super::{Screen, Screens, Vector};
use crate::geometry::sides::sides;
use std::ops::ControlFlow;

/// What a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Hit {
    /// The index of the face, front or back, among those that the screens are made of.
    pub(crate) face: usize,
    /// The distance from the ray's origin, in lengths of its direction.
    pub(crate) distance: f64,
}

/// A ray on its way through the tree: what it has met first so far, up to a farthest distance.
struct Ray<'s> {
    screens: &'s Screens,
    origin: Vector,
    direction: Vector,
    /// How far the ray goes.
    reach: f64,
    /// The least distance of the end of the ray from the plane of what it meets.
    beyond: f64,
    /// Whether anything that is met will do.
    any: bool,
    first: Option<Hit>,
    /// Whether it is met from its front.
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
    /// Where the ray meets a screen, and whether from its front, if it is farther than `resolution` from the screen's plane and gets through
    /// it within its reach. Of two screens that lie upon each other the one that turns its front to the ray is met.
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
    /// The first screen that a ray meets, beyond the resolution of the scene.
    pub(crate) fn first(&self, origin: Vector, direction: Vector) -> Option<Hit> {
        self.along(origin, direction, [f64::INFINITY, 0.0], false)
    }

    /// Whether something stands between two points: a screen that has them on different sides.
    pub(crate) fn hides(&self, from: Vector, to: Vector) -> bool {
        self.along(from, to - from, [1.0, self.resolution], true).is_some()
    }

    /// Whether something is met in a direction from a point.
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
