//! Boxes that meet: boxes around points become a tree, in which those that meet another box are found.

use super::bounds::Bounds;
use super::tree::{Query, Tree};
use crate::geometry::Vector;
use std::ops::ControlFlow;

/// Boxes, each around a few points, in a tree.
pub(crate) struct Boxes {
    boxes: Vec<Bounds>,
    tree: Tree,
}

impl Boxes {
    /// The least box around each of these sets of points, wider by a margin on every side.
    pub(crate) fn around<P: IntoIterator<Item = Vector>>(sets: impl Iterator<Item = (P, f64)>) -> Self {
        let boxes: Vec<Bounds> =
            sets.map(|(points, margin)| Bounds::of(points.into_iter()).wider(margin)).collect();
        let tree = Tree::of(&boxes);
        Self { boxes, tree }
    }

    /// Shows the index of each box that the box around these points meets, wider by a margin, until it breaks off.
    pub(crate) fn meeting(
        &self,
        points: impl IntoIterator<Item = Vector>,
        margin: f64,
        visit: impl FnMut(usize) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let sought = Bounds::of(points.into_iter()).wider(margin);
        self.tree.walk(&mut Meeting { boxes: &self.boxes, sought, visit })
    }
}

/// The distance of the boxes around points: these are no closer.
pub(crate) fn distance_of_boxes(points: &[Vector], others: &[Vector]) -> f64 {
    let [own, other] = [points, others].map(|points| Bounds::of(points.iter().copied()));
    own.distance(&other)
}

/// A search for boxes that meet one.
struct Meeting<'b, V> {
    boxes: &'b [Bounds],
    sought: Bounds,
    visit: V,
}

impl<V: FnMut(usize) -> ControlFlow<()>> Query for Meeting<'_, V> {
    fn may_be_in(&self, bounds: &Bounds) -> bool {
        bounds.meets(&self.sought)
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        if self.boxes[leaf].meets(&self.sought) { (self.visit)(leaf) } else { ControlFlow::Continue(()) }
    }
}
