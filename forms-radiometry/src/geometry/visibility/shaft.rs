//! Shafts: two convex outlines become the planes around all segments from one to the other.
//!
//! A plane that bounds the convex hull of two convex outlines in space holds one of them, or an edge of one and a vertex of the other.
//! Each edge a, b has two such vertices at most, those that are seen first from its outline in turning about the edge.
//!
//! Source: E. Haines, J. Wallace, Shaft culling for efficient ray-traced radiosity (1991), with the hull instead of boxes.

use super::bounds::Bounds;
use super::{Plane, Vector};
use smallvec::SmallVec;

/// The planes of the shaft between two quadrilaterals, two about each edge at most, and two cuts: only more than these need memory of their own,
/// for which threads would wait for each other.
const PLANES: usize = 18;

/// The space in which the segments from the points of one outline to those of another lie.
pub(super) struct Shaft<'o> {
    /// The corners of both outlines.
    pub(super) outlines: [&'o [Vector]; 2],
    bounds: Bounds,
    /// Planes with normals to the outside.
    planes: SmallVec<[Plane; PLANES]>,
    /// Whether the planes about the edges of the outlines are among them.
    is_complete: bool,
    /// A point that is nearer to a plane counts as outside of it.
    rounding: f64,
}

impl<'o> Shaft<'o> {
    /// The shaft between two outlines, as far as their box and cuts say.
    pub(super) fn new(outlines: [&'o [Vector]; 2], rounding: f64) -> Self {
        let [here, there] = outlines;
        let bounds = Bounds::of(here.iter().chain(there).copied()).wider(rounding);
        Self { outlines, bounds, planes: SmallVec::new(), is_complete: false, rounding }
    }

    /// Adds the planes about the edges of the outlines, which only some searches need.
    pub(super) fn complete(&mut self) {
        if !std::mem::replace(&mut self.is_complete, true) {
            let [here, there] = self.outlines;
            self.add_planes_about_edges(here, there);
            self.add_planes_about_edges(there, here);
        }
    }

    /// Cuts off what is behind a plane, or nearer to it than this.
    pub(super) fn cut(&mut self, plane: Plane, resolution: f64) {
        let normal = -plane.normal;
        self.planes.push(Plane { point: plane.point + (resolution - self.rounding) * plane.normal, normal });
    }

    /// The planes through each edge of one outline and a vertex of the other, with both outlines on one side.
    fn add_planes_about_edges(&mut self, edges: &[Vector], vertices: &[Vector]) {
        // one point has no edges, and two points have one edge
        let count = if edges.len() < 3 { edges.len() - 1 } else { edges.len() };
        for place in 0..count {
            let (a, b) = (edges[place], edges[(place + 1) % edges.len()]);
            for normal in outermost(a, b - a, vertices).into_iter().flatten() {
                let plane = Plane { point: a, normal };
                let is_behind =
                    |outline: &[Vector]| outline.iter().all(|&v| plane.distance(v) <= self.rounding);
                if is_behind(edges) && is_behind(vertices) {
                    self.planes.push(plane);
                }
            }
        }
    }

    /// Whether a part of what is in a box may lie in the shaft.
    pub(super) fn may_meet(&self, bounds: &Bounds) -> bool {
        let is_inside = |plane: &Plane| plane.distance(bounds.farthest(-plane.normal)) < -self.rounding;
        self.bounds.meets(bounds) && self.planes.iter().all(is_inside)
    }

    /// Whether a part of a convex outline may lie in the shaft: no plane of the shaft parts them.
    pub(super) fn may_hold(&self, outline: &[Vector]) -> bool {
        let is_inside = |plane: &Plane| outline.iter().any(|&v| plane.distance(v) < -self.rounding);
        self.planes.iter().all(is_inside)
    }
}

/// The unit normals of the planes through the line from a in a direction and the vertices that a half plane about this line meets first
/// and last, as it turns with the right hand along the direction through all vertices, which span less than half a turn.
fn outermost(a: Vector, direction: Vector, vertices: &[Vector]) -> [Option<Vector>; 2] {
    let mut ends: Option<[Vector; 2]> = None;
    for &vertex in vertices {
        let to_vertex = vertex - a;
        let ahead = direction.cross(to_vertex);
        if ahead == Vector::default() {
            continue;
        }
        let [first, last] = ends.get_or_insert([to_vertex; 2]);
        if ahead.dot(*first) > 0.0 {
            *first = to_vertex;
        }
        if ahead.dot(*last) < 0.0 {
            *last = to_vertex;
        }
    }
    // what comes later lies on the left of direction × first, and what comes before on the right of direction × last
    let Some([first, last]) = ends else { return [None; 2] };
    [unit(first.cross(direction)), unit(direction.cross(last))]
}

/// A vector's direction to rounding; none for one that is too short or too long for its square, without which a shaft is but wider.
fn unit(v: Vector) -> Option<Vector> {
    let squared = v.dot(v);
    squared.is_normal().then(|| (1.0 / squared.sqrt()) * v)
}
