//! Box intersection: builds a BVH of boxes around points and finds the boxes that intersect another
//! box.

use super::tree::{Query, Tree};
use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use std::ops::ControlFlow;

/// A BVH of boxes, each around a few points.
pub(crate) struct Boxes {
    tree: Tree,
}

impl Boxes {
    /// Builds the bounding box of each of these sets of points, extended by a margin on every side.
    pub(crate) fn around<P: IntoIterator<Item = Vector>>(sets: impl Iterator<Item = (P, f64)>) -> Self {
        let boxes: Vec<Bounds> =
            sets.map(|(points, margin)| Bounds::of(points.into_iter()).wider(margin)).collect();
        Self { tree: Tree::of(&boxes) }
    }

    /// Calls `visit` with the index of each box that intersects the bounding box of these points,
    /// extended by a margin, until `visit` breaks.
    pub(crate) fn meeting(
        &self,
        points: impl IntoIterator<Item = Vector>,
        margin: f64,
        visit: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let sought = Bounds::of(points.into_iter()).wider(margin);
        self.tree.walk(&mut Meeting { sought, visit })
    }
}

/// Returns the distance of the bounding boxes of two sets of points: a lower bound on the distance
/// of the points.
pub(crate) fn distance_of_boxes(points: &[Vector], others: &[Vector]) -> f64 {
    let [own, other] = [points, others].map(|points| Bounds::of(points.iter().copied()));
    own.distance(&other)
}

/// A search for the boxes that intersect a box.
struct Meeting<V> {
    sought: Bounds,
    visit: V,
}

impl<V: FnMut(usize) -> ControlFlow<()>> Query for Meeting<V> {
    fn may_be_in(&self, bounds: &Bounds) -> bool {
        bounds.meets(&self.sought)
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        (self.visit)(leaf)
    }
}
