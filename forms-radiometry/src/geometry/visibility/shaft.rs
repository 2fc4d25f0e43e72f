//! Shafts: two convex outlines become the planes around all segments from one to the other.
//!
//! A plane that bounds the convex hull of two convex outlines in space holds one of them, or an edge of one and a vertex of the other.
//! Each edge a, b has two such vertices at most, those that are seen first from its outline in turning about the edge.
//!
//! Source: E. Haines, J. Wallace, Shaft culling for efficient ray-traced radiosity (1991), with the hull instead of boxes.

use super::bounds::Bounds;
use super::{Plane, Vector};

/// The space in which the segments from the points of one outline to those of another lie.
pub(super) struct Shaft<'o> {
    /// The corners of both outlines.
    pub(super) outlines: [&'o [Vector]; 2],
    bounds: Bounds,
    /// Planes with normals to the outside.
    planes: Vec<Plane>,
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
        Self { outlines, bounds, planes: Vec::new(), is_complete: false, rounding }
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
            for turn in [1.0, -1.0] {
                let Some(normal) = first_met(a, turn * (b - a), vertices) else { continue };
                let is_around = |plane: &Plane| {
                    let outlines = self.outlines.into_iter().flatten();
                    outlines.into_iter().all(|&v| plane.distance(v) <= self.rounding)
                };
                self.planes.extend(Some(Plane { point: a, normal }).filter(is_around));
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

/// The unit normal of the plane through the line from a in a direction and the vertex that a half plane about this line meets first,
/// as it turns with the right hand along the direction through all vertices, which span less than half a turn.
fn first_met(a: Vector, direction: Vector, vertices: &[Vector]) -> Option<Vector> {
    let mut first: Option<Vector> = None;
    for &vertex in vertices {
        let to_vertex = vertex - a;
        let ahead = direction.cross(to_vertex);
        if ahead != Vector::default() && first.is_none_or(|first| ahead.dot(first) > 0.0) {
            first = Some(to_vertex);
        }
    }
    // what comes later lies on the left of direction × first
    first.and_then(|first| first.cross(direction).unit())
}
