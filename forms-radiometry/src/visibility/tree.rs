//! BVH: boxes are split by the surface-area heuristic, so that a query skips distant boxes.
//!
//! The crate `bvh` splits them, in coordinates from 0 to 1, so that it works at any scale. Queries
//! are compared with the original boxes, exact to the last bit. Nodes lie in the order of a
//! depth-first traversal, each with the index at which the traversal continues if the node is
//! skipped: a traversal needs no stack.

use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use nalgebra::Point3;
use std::ops::ControlFlow;

/// Value of `leaf` that marks an inner node.
const INNER: u32 = u32::MAX;

/// A BVH.
#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    nodes: Vec<Node>,
}

#[derive(Clone, Debug)]
struct Node {
    bounds: Bounds,
    /// The node at which the traversal continues if this one is skipped.
    next: u32,
    /// The index of the box in a leaf.
    leaf: u32,
}

/// A query to the tree.
pub(super) trait Query {
    /// Whether these bounds can contain a result.
    fn may_be_in(&self, bounds: &Bounds) -> bool;
    /// Handles a leaf that was not skipped.
    fn at(&mut self, leaf: usize) -> ControlFlow<()>;
}

/// A box in the form that `bvh` requires.
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
    /// Builds the tree of these boxes.
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

    /// Returns the bounds of all boxes.
    pub(super) fn bounds(&self) -> Bounds {
        self.siblings([0, self.nodes.len()])
            .fold(Bounds::NOTHING, |all, place| all.with(self.nodes[place].bounds))
    }

    /// Returns the indices of the root nodes, of which there are at most two.
    pub(super) fn roots(&self) -> [Option<usize>; 2] {
        let mut siblings = self.siblings([0, self.nodes.len()]);
        [siblings.next(), siblings.next()]
    }

    /// Returns the indices of a node's children.
    pub(super) fn below(&self, place: usize) -> [Option<usize>; 2] {
        let mut siblings = self.siblings([place + 1, self.nodes[place].next as usize]);
        [siblings.next(), siblings.next()]
    }

    pub(super) fn bounds_of(&self, place: usize) -> &Bounds {
        &self.nodes[place].bounds
    }

    /// Returns the index of a node's box if the node is a leaf.
    pub(super) fn leaf(&self, place: usize) -> Option<usize> {
        Some(self.nodes[place].leaf).filter(|&leaf| leaf != INNER).map(|leaf| leaf as usize)
    }

    fn siblings(&self, [first, end]: [usize; 2]) -> impl Iterator<Item = usize> {
        let next = move |&place: &usize| Some(self.nodes[place].next as usize).filter(|&next| next < end);
        std::iter::successors(Some(first).filter(|&first| first < end), next)
    }

    /// Visits the leaves that can contain a result of a query, until the query breaks.
    pub(super) fn walk(&self, query: &mut impl Query) -> ControlFlow<()> {
        let mut place = 0;
        while let Some(node) = self.nodes.get(place) {
            // the parent of a leaf has the same bounds, so the leaf is not tested again
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
}

/// Returns the bounds of a node's children.
fn children(nodes: &[Node], place: usize) -> impl Iterator<Item = Bounds> {
    let end = nodes[place].next as usize;
    let mut child = place + 1;
    std::iter::from_fn(move || {
        let node = nodes.get(child).filter(|_| child < end)?;
        child = node.next as usize;
        Some(node.bounds)
    })
}
