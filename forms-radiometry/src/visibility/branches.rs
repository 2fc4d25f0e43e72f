//! BVH layout for rays: each branch holds the boxes of both of its children in one cache line,
//! rounded outwards, and the nearer child is visited first.
//!
//! Coordinates are relative to the scene, from 0 to 1, so that rounding them to 24 bits widens
//! every box by at most 10⁻⁷ of the scene. Intersections are computed from the screens alone; boxes
//! only decide which screens are skipped.

use super::tree::Tree;
use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Bit that marks a leaf.
const LEAF: u32 = 1 << 31;
/// Margin added to boxes before they are rounded, for the rounding of relative coordinates.
const WIDER: f64 = 1e-12;
/// Relative rounding error of a distance.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// A ray query.
pub(super) trait Way {
    /// Returns the origin and the direction.
    fn ray(&self) -> [Vector; 2];
    /// Returns the farthest distance still of interest, in lengths of the direction.
    fn end(&self) -> f64;
    /// Handles a leaf whose box the ray enters.
    fn at(&mut self, leaf: usize) -> ControlFlow<()>;
}

/// An inner node: two boxes and their contents.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Branch {
    /// For each axis, the low and the high sides of both boxes.
    sides: [[[f32; 2]; 2]; 3],
    /// For each box, a branch or a leaf.
    below: [u32; 2],
}

/// The inner nodes of a tree.
#[derive(Clone, Debug)]
pub(super) struct Branches {
    branches: Vec<Branch>,
    root: Option<u32>,
    origin: Vector,
    scale: f64,
}

/// A ray in coordinates relative to the scene.
struct Slopes {
    origin: [f64; 3],
    inverse: [f64; 3],
    /// For each axis, the side, low or high, that the ray meets first.
    first: [usize; 3],
}

impl Branches {
    pub(super) fn of(tree: &Tree) -> Self {
        let all = tree.bounds();
        let extent = all.extent();
        let scale = if extent > 0.0 && extent.is_finite() { 1.0 / extent } else { 1.0 };
        let mut branches = Self { branches: Vec::new(), root: None, origin: all.low, scale };
        branches.root = branches.add(tree, tree.roots());
        branches
    }

    /// Adds the subtree of one or two siblings, and returns its root.
    fn add(&mut self, tree: &Tree, siblings: [Option<usize>; 2]) -> Option<u32> {
        match siblings {
            [Some(one), Some(other)] => {
                let place = self.branches.len();
                self.branches.push(self.branch([tree.bounds_of(one), tree.bounds_of(other)]));
                for (child, sibling) in [one, other].into_iter().enumerate() {
                    let below = self.add(tree, [Some(sibling), None]);
                    self.branches[place].below[child] = below.expect("a node has something below it");
                }
                Some(place as u32)
            }
            [Some(only), None] => match tree.leaf(only) {
                Some(leaf) => Some(leaf as u32 | LEAF),
                None => self.add(tree, tree.below(only)),
            },
            _ => None,
        }
    }

    fn branch(&self, boxes: [&Bounds; 2]) -> Branch {
        let [low, high] =
            [boxes.map(|bounds| self.relative(bounds.low)), boxes.map(|bounds| self.relative(bounds.high))];
        let down = |x: f64| ((x - WIDER) as f32).next_down();
        let up = |x: f64| ((x + WIDER) as f32).next_up();
        let of_axis =
            |axis: usize| [low.map(|corner| down(corner[axis])), high.map(|corner| up(corner[axis]))];
        Branch { sides: [of_axis(0), of_axis(1), of_axis(2)], below: [0; 2] }
    }

    fn relative(&self, point: Vector) -> [f64; 3] {
        let Vector { x, y, z } = self.scale * (point - self.origin);
        [x, y, z]
    }

    /// Visits the leaves whose boxes a ray enters, the nearer of two siblings first, until the
    /// query breaks.
    pub(super) fn walk(&self, way: &mut impl Way) {
        let [origin, direction] = way.ray();
        let direction = self.scale * direction;
        let inverse = [1.0 / direction.x, 1.0 / direction.y, 1.0 / direction.z];
        let first = inverse.map(|inverse| usize::from(inverse < 0.0));
        let slopes = Slopes { origin: self.relative(origin), inverse, first };
        // inline stack: traversing a ray is cheaper than an allocation
        let mut waiting: SmallVec<[(f64, u32); 64]> = SmallVec::new();
        waiting.extend(self.root.map(|root| (0.0, root)));
        while let Some((entered, mut below)) = waiting.pop() {
            if entered > way.end() {
                continue;
            }
            while below & LEAF == 0 {
                let branch = &self.branches[below as usize];
                let ([enter, enter_other], [is_met, is_other_met]) = slopes.entered(branch, way.end());
                let [one, other] = branch.below;
                (below, _) = match (is_met, is_other_met) {
                    (true, true) if enter <= enter_other => (one, waiting.push((enter_other, other))),
                    (true, true) => (other, waiting.push((enter, one))),
                    (true, false) => (one, ()),
                    (false, true) => (other, ()),
                    (false, false) => break,
                };
            }
            if below & LEAF != 0 && way.at((below & !LEAF) as usize).is_break() {
                return;
            }
        }
    }
}

impl Slopes {
    /// Returns where the ray enters both boxes of a branch, and whether it passes through them
    /// between its origin and its end. The inverse is infinite for a ray parallel to a side, where
    /// 0 · ∞ constrains nothing: every comparison with it is false.
    #[inline]
    fn entered(&self, branch: &Branch, end: f64) -> ([f64; 2], [bool; 2]) {
        let (mut enter, mut leave) = ([0.0_f64; 2], [end; 2]);
        for axis in 0..3 {
            let near = branch.sides[axis][self.first[axis]];
            let far = branch.sides[axis][1 - self.first[axis]];
            for child in 0..2 {
                let near = (f64::from(near[child]) - self.origin[axis]) * self.inverse[axis];
                let far = (f64::from(far[child]) - self.origin[axis]) * self.inverse[axis];
                enter[child] = if near > enter[child] { near } else { enter[child] };
                leave[child] = if far < leave[child] { far } else { leave[child] };
            }
        }
        let is_met = |child: usize| enter[child] * (1.0 - ROUNDING) <= leave[child] * (1.0 + ROUNDING);
        (enter.map(|enter| enter * (1.0 - ROUNDING)), [is_met(0), is_met(1)])
    }
}
