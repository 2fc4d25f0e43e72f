//! BVH: boxes are split by the surface-area heuristic, so that a query skips distant boxes.
//!
//! The crate `bvh` splits them, in coordinates from 0 to 1 and of 24 bits, so that it works at any
//! scale. Queries are compared with the original boxes, exact to the last bit. Nodes lie in the
//! order of a depth-first traversal, each with the index at which the traversal continues if the
//! node is skipped: a traversal needs no stack.

use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::{Bvh, BvhNode, rayon_executor};
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
    bounds: Aabb<f32, 3>,
    node: usize,
}

impl Bounded<f32, 3> for Leaf {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Leaf {
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
        if boxes.is_empty() {
            return Self::default();
        }
        let split = split(boxes);
        let mut nodes = Vec::with_capacity(2 * boxes.len() - 1);
        let mut waiting = vec![0];
        while let Some(place) = waiting.pop() {
            nodes.push(match split[place] {
                BvhNode::Leaf { shape_index, .. } => {
                    let next = nodes.len() as u32 + 1;
                    Node { bounds: boxes[shape_index], next, leaf: shape_index as u32 }
                }
                BvhNode::Node { child_l_index, child_r_index, .. } => {
                    waiting.extend([child_r_index, child_l_index]);
                    Node { bounds: Bounds::NOTHING, next: 0, leaf: INNER }
                }
            });
        }
        let mut tree = Self { nodes };
        for place in (0..tree.nodes.len()).rev() {
            if let Some([one, other]) = tree.below(place) {
                let bounds = tree.nodes[one].bounds.with(tree.nodes[other].bounds);
                tree.nodes[place] = Node { bounds, next: tree.nodes[other].next, leaf: INNER };
            }
        }
        tree
    }

    /// Returns the bounds of all boxes.
    pub(super) fn bounds(&self) -> Bounds {
        self.nodes.first().map_or(Bounds::NOTHING, |root| root.bounds)
    }

    /// Returns the index of the root, if there are any boxes.
    pub(super) fn root(&self) -> Option<usize> {
        (!self.nodes.is_empty()).then_some(0)
    }

    /// Returns the indices of an inner node's children.
    pub(super) fn below(&self, place: usize) -> Option<[usize; 2]> {
        let first = place + 1;
        (self.nodes[place].leaf == INNER).then(|| [first, self.nodes[first].next as usize])
    }

    pub(super) fn bounds_of(&self, place: usize) -> &Bounds {
        &self.nodes[place].bounds
    }

    /// Returns the index of a node's box if the node is a leaf.
    pub(super) fn leaf(&self, place: usize) -> Option<usize> {
        Some(self.nodes[place].leaf).filter(|&leaf| leaf != INNER).map(|leaf| leaf as usize)
    }

    /// Visits the leaves that can contain a result of a query, until the query breaks.
    pub(super) fn walk(&self, query: &mut impl Query) -> ControlFlow<()> {
        let mut place = 0;
        while let Some(node) = self.nodes.get(place) {
            if !query.may_be_in(&node.bounds) {
                place = node.next as usize;
                continue;
            }
            if node.leaf != INNER {
                query.at(node.leaf as usize)?;
            }
            place += 1;
        }
        ControlFlow::Continue(())
    }
}

/// Splits boxes; the root is the first of the nodes.
fn split(boxes: &[Bounds]) -> Vec<BvhNode<f32, 3>> {
    let all = boxes.iter().fold(Bounds::NOTHING, |all, &bounds| all.with(bounds));
    let extent = all.extent();
    let place = |point: Vector| {
        let Vector { x, y, z } = point - all.low;
        Point3::from([x, y, z].map(|along| (along / extent) as f32))
    };
    let leaf = |bounds: &Bounds| {
        let bounds = Aabb::with_bounds(place(bounds.low), place(bounds.high));
        Leaf { bounds, node: 0 }
    };
    let mut leaves: Vec<Leaf> = boxes.iter().map(leaf).collect();
    Bvh::build_with_executor(&mut leaves, rayon_executor).nodes
}
