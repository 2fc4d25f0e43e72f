//! BVH layout for rays: each branch holds the boxes of its four children side by side, so that one
//! instruction tests all of them, and the nearest child is visited first.
//!
//! Coordinates are relative to the scene, from 0 to 1, and have 24 bits. A ray from outside starts
//! where it enters the scene. So every rounding displaces a ray or a side of a box by at most a few
//! 2⁻²⁴, and boxes are wider by more than that. Intersections are computed from the screens alone;
//! boxes only decide which screens are skipped.

use super::tree::Tree;
use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Number of children of a branch.
const WIDTH: usize = 4;
/// Bit that marks a leaf.
const LEAF: u32 = 1 << 31;
/// Margin of boxes for the rounding of a ray, in relative coordinates: of its origin, of the
/// inverse of its direction, of the difference from a side, of their product and of its end, 2⁻²⁴
/// each over a way of at most √3; twice as much.
const WIDER: f64 = 16.0 * (f32::EPSILON as f64) / 2.0;

/// A ray query.
pub(super) trait Way {
    /// Returns the origin and the direction.
    fn ray(&self) -> [Vector; 2];
    /// Returns the farthest distance still of interest, in lengths of the direction.
    fn end(&self) -> f64;
    /// Handles a leaf whose box the ray enters.
    fn at(&mut self, leaf: usize) -> ControlFlow<()>;
}

/// An inner node: boxes and their contents.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
struct Branch {
    /// For each axis, the low and the high sides of all boxes.
    sides: [[[f32; WIDTH]; 2]; 3],
    /// For each box, a branch or a leaf.
    below: [u32; WIDTH],
}

impl Branch {
    /// A branch whose boxes are empty: no ray enters them.
    const EMPTY: Self =
        Self { sides: [[[f32::INFINITY; WIDTH], [f32::NEG_INFINITY; WIDTH]]; 3], below: [LEAF; WIDTH] };
}

/// The inner nodes of a tree.
#[derive(Clone, Debug)]
pub(super) struct Branches {
    branches: Vec<Branch>,
    origin: Vector,
    scale: f64,
    /// The bounds of everything with their margin, in relative coordinates.
    all: [[f64; 3]; 2],
}

/// A ray in coordinates relative to the scene.
struct Slopes {
    origin: [f32; 3],
    inverse: [f32; 3],
    /// For each axis, the side, low or high, that the ray meets first.
    first: [usize; 3],
    /// The distance from the origin of the query to this origin.
    start: f64,
}

impl Branches {
    pub(super) fn of(tree: &Tree) -> Self {
        let all = tree.bounds();
        let extent = all.extent();
        let scale = if extent > 0.0 && extent.is_finite() { 1.0 / extent } else { 1.0 };
        let mut branches = Self { branches: Vec::new(), origin: all.low, scale, all: [[0.0; 3]; 2] };
        branches.all =
            [branches.relative(all.low).map(|x| x - WIDER), branches.relative(all.high).map(|x| x + WIDER)];
        if let Some(root) = tree.root() {
            branches.add(tree, root);
        }
        branches.branches.shrink_to_fit();
        branches
    }

    /// Adds the branch of a node, and returns its place.
    fn add(&mut self, tree: &Tree, node: usize) -> u32 {
        let nodes = opened(tree, node);
        let place = self.branches.len();
        self.branches.push(self.branch(tree, &nodes));
        for (child, &node) in nodes.iter().enumerate() {
            self.branches[place].below[child] = match tree.leaf(node) {
                Some(leaf) => leaf as u32 | LEAF,
                None => self.add(tree, node),
            };
        }
        place as u32
    }

    fn branch(&self, tree: &Tree, nodes: &[usize]) -> Branch {
        let down = |x: f64| ((x - WIDER) as f32).next_down();
        let up = |x: f64| ((x + WIDER) as f32).next_up();
        let mut branch = Branch::EMPTY;
        for (child, &node) in nodes.iter().enumerate() {
            let Bounds { low, high } = *tree.bounds_of(node);
            let [low, high] = [self.relative(low), self.relative(high)];
            for axis in 0..3 {
                branch.sides[axis][0][child] = down(low[axis]);
                branch.sides[axis][1][child] = up(high[axis]);
            }
        }
        branch
    }

    fn relative(&self, point: Vector) -> [f64; 3] {
        let Vector { x, y, z } = self.scale * (point - self.origin);
        [x, y, z]
    }

    /// Visits the leaves whose boxes a ray enters, the nearest of siblings first, until the query
    /// breaks.
    pub(super) fn walk(&self, way: &mut impl Way) {
        let Some(slopes) = self.slopes(way) else { return };
        // inline stack: traversing a ray is cheaper than an allocation
        let mut waiting: SmallVec<[(f32, u32); 64]> = SmallVec::new();
        if !self.branches.is_empty() {
            waiting.push((0.0, 0));
        }
        while let Some((entered, below)) = waiting.pop() {
            let end = slopes.end(way.end());
            if entered > end {
                continue;
            }
            if below & LEAF != 0 {
                if way.at((below & !LEAF) as usize).is_break() {
                    return;
                }
                continue;
            }
            let branch = &self.branches[below as usize];
            let (enter, leave) = slopes.entered(branch, end);
            let first = waiting.len();
            for child in 0..WIDTH {
                if enter[child] <= leave[child] {
                    // the farthest first, so that the nearest is on top
                    let mut place = waiting.len();
                    waiting.push((enter[child], branch.below[child]));
                    while place > first && waiting[place - 1].0 < waiting[place].0 {
                        waiting.swap(place - 1, place);
                        place -= 1;
                    }
                }
            }
        }
    }

    /// Returns the ray from where it enters the scene, if it does.
    fn slopes(&self, way: &impl Way) -> Option<Slopes> {
        let [origin, direction] = way.ray();
        let origin = self.relative(origin);
        let Vector { x, y, z } = self.scale * direction;
        let direction = [x, y, z];
        let inverse = direction.map(|along| 1.0 / along);
        let first = inverse.map(|inverse| usize::from(inverse < 0.0));
        let (mut start, mut end) = (0.0_f64, way.end());
        for axis in 0..3 {
            let to = |side: usize| (self.all[side][axis] - origin[axis]) * inverse[axis];
            let [near, far] = [to(first[axis]), to(1 - first[axis])];
            start = if near > start { near } else { start };
            end = if far < end { far } else { end };
        }
        let entry = |axis: usize| (origin[axis] + start * direction[axis]) as f32;
        let origin = [entry(0), entry(1), entry(2)];
        (start <= end).then(|| Slopes {
            origin,
            inverse: inverse.map(|inverse| inverse as f32),
            first,
            start,
        })
    }
}

/// Returns a node, of which the largest parts are replaced by their children while there is room.
fn opened(tree: &Tree, node: usize) -> SmallVec<[usize; WIDTH]> {
    let mut nodes = SmallVec::from_slice(&[node]);
    let size = |node: usize| tree.bounds_of(node).half_surface();
    while nodes.len() < WIDTH {
        let inner = nodes.iter().enumerate().filter_map(|(at, &node)| Some((at, node, tree.below(node)?)));
        let Some((at, _, children)) = inner.max_by(|a, b| size(a.1).total_cmp(&size(b.1))) else { break };
        nodes.remove(at);
        nodes.extend(children);
    }
    nodes
}

impl Slopes {
    /// Returns the end of a ray as a distance from its entry, rounded up.
    #[inline]
    fn end(&self, end: f64) -> f32 {
        (end - self.start) as f32 * (1.0 + f32::EPSILON)
    }

    /// Returns where the ray enters and leaves each box of a branch, between its entry and its end.
    /// The inverse is infinite for a ray parallel to a side, where 0 · ∞ constrains nothing: every
    /// comparison with it is false.
    #[inline]
    fn entered(&self, branch: &Branch, end: f32) -> ([f32; WIDTH], [f32; WIDTH]) {
        let (mut enter, mut leave) = ([0.0_f32; WIDTH], [end; WIDTH]);
        for axis in 0..3 {
            let near = &branch.sides[axis][self.first[axis]];
            let far = &branch.sides[axis][1 - self.first[axis]];
            for child in 0..WIDTH {
                let near = (near[child] - self.origin[axis]) * self.inverse[axis];
                let far = (far[child] - self.origin[axis]) * self.inverse[axis];
                enter[child] = if near > enter[child] { near } else { enter[child] };
                leave[child] = if far < leave[child] { far } else { leave[child] };
            }
        }
        (enter, leave)
    }
}
