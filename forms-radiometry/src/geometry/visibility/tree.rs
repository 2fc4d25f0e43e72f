//! The tree of boxes: boxes are parted by the surface-area heuristic, so that a query passes by what is far away from it.
//!
//! The crate `bvh` parts them, in coordinates from 0 to 1, so that it works at any scale; the boxes that queries are compared with are those
//! that were given, to the last bit. Nodes lie in the order of a depth-first walk, each with the place to go on from where it is
//! passed by: a walk needs no stack.

use super::Vector;
use super::bounds::Bounds;
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use nalgebra::Point3;
use std::ops::ControlFlow;

/// What marks a node that is no leaf.
const INNER: u32 = u32::MAX;

/// Boxes in a tree.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    /// The node to go on with where this one is passed by.
    next: u32,
    /// The index of the box in a leaf.
    leaf: u32,
}

/// What is looked for in a tree.
pub(super) trait Query {
    /// Whether what is in these bounds may be looked for.
    fn may_be_in(&self, bounds: &Bounds) -> bool;
    /// A box that was not passed by.
    fn at(&mut self, leaf: usize) -> ControlFlow<()>;
}

/// What is looked for along a way.
pub(super) trait Way {
    /// Where the way enters these bounds, if it does before its end.
    fn entered(&self, bounds: &Bounds) -> Option<f64>;
    /// Where the way ends, as far as is known.
    fn end(&self) -> f64;
    /// A box that was not passed by.
    fn at(&mut self, leaf: usize) -> ControlFlow<()>;
}

/// A box as it is seen by `bvh`.
struct Leaf {
    bounds: Aabb<f64, 3>,
    node: usize,
}

impl Bounded<f64, 3> for Leaf {
    fn aabb(&self) -> Aabb<f64, 3> {
        self.bounds
    }
}

impl BHShape<f64, 3> for Leaf {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }

    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Tree {
    /// The tree of these boxes.
    pub(super) fn of(boxes: &[Bounds]) -> Self {
        let all = boxes.iter().fold(Bounds::NOTHING, |all, &bounds| all.with(bounds));
        let extent = all.extent();
        let place = |point: Vector| {
            let Vector { x, y, z } = point - all.low;
            Point3::new(x / extent, y / extent, z / extent)
        };
        let leaf = |bounds: &Bounds| {
            let bounds = Aabb::with_bounds(place(bounds.low), place(bounds.high));
            Leaf { bounds, node: 0 }
        };
        let mut leaves: Vec<Leaf> = boxes.iter().map(leaf).collect();
        let tree = Bvh::build(&mut leaves);
        let mut nodes = tree.flatten_custom(&|_, _, next, leaf| Node { bounds: Bounds::NOTHING, next, leaf });
        for place in (0..nodes.len()).rev() {
            nodes[place].bounds = match nodes[place].leaf {
                INNER => children(&nodes, place).fold(Bounds::NOTHING, Bounds::with),
                leaf => boxes[leaf as usize],
            };
        }
        Self { nodes }
    }

    /// Shows a query the boxes that it may be in, until it breaks off.
    pub(super) fn walk(&self, query: &mut impl Query) -> ControlFlow<()> {
        let mut place = 0;
        while let Some(node) = self.nodes.get(place) {
            // the node above a leaf has the same bounds
            if node.leaf != INNER {
                query.at(node.leaf as usize)?;
            } else if query.may_be_in(&node.bounds) {
                place += 1;
                continue;
            }
            place = node.next as usize;
        }
        ControlFlow::Continue(())
    }

    /// Shows a way the boxes that it enters, the nearer branch of two first, until it breaks off: what is met early shortens the way, so that
    /// most of what lies behind is passed by.
    pub(super) fn walk_along(&self, way: &mut impl Way) -> ControlFlow<()> {
        let mut waiting: Vec<(f64, usize)> = Vec::with_capacity(64);
        let mut begin = Some((0, self.nodes.len()));
        loop {
            if let Some((first, end)) = begin.take() {
                // the nodes from `first` on are siblings, of which there are two at most
                let second = self.nodes.get(first).map_or(end, |node| node.next as usize);
                let entered =
                    |place: usize| (place < end).then(|| way.entered(&self.nodes[place].bounds)).flatten();
                let [near, far] =
                    [first, second].map(|place| entered(place).map(|distance| (distance, place)));
                let (near, far) = if far.is_some_and(|far| near.is_none_or(|near| far.0 < near.0)) {
                    (far, near)
                } else {
                    (near, far)
                };
                waiting.extend(far);
                waiting.extend(near);
            }
            let Some((distance, place)) = waiting.pop() else { return ControlFlow::Continue(()) };
            if distance > way.end() {
                continue;
            }
            match self.nodes[place].leaf {
                INNER => begin = Some((place + 1, self.nodes[place].next as usize)),
                leaf => way.at(leaf as usize)?,
            }
        }
    }
}

/// The bounds of the nodes right below one.
fn children(nodes: &[Node], place: usize) -> impl Iterator<Item = Bounds> {
    let end = nodes[place].next as usize;
    let mut child = place + 1;
    std::iter::from_fn(move || {
        let node = nodes.get(child).filter(|_| child < end)?;
        child = node.next as usize;
        Some(node.bounds)
    })
}
