//! Shafts: computes the planes around all segments between two convex outlines.
//!
//! A plane that bounds the convex hull of two convex outlines in space contains one of them, or an
//! edge of one and a vertex of the other. Each edge a, b has at most two such vertices: the first
//! ones that a half-plane meets as it turns about the edge from its outline.
//!
//! Source: E. Haines, J. Wallace, Shaft culling for efficient ray-traced radiosity (1991), with the
//! hull instead of boxes.

use crate::geometry::bounds::Bounds;
use crate::geometry::{Plane, Vector};
use smallvec::SmallVec;

/// Inline capacity: the planes of the shaft between two quadrilaterals, at most two about each
/// edge, and two cuts. Only larger shafts allocate memory, for which threads would wait for each
/// other.
const PLANES: usize = 18;

/// The union of all segments from a point of one outline to a point of another.
pub(super) struct Shaft<'o> {
    /// The corners of both outlines.
    pub(super) outlines: [&'o [Vector]; 2],
    bounds: Bounds,
    /// Planes with outward normals.
    planes: SmallVec<[Plane; PLANES]>,
    /// Whether `planes` contains the planes about the edges of the outlines.
    is_complete: bool,
    /// A point that is nearer to a plane than this counts as outside it.
    rounding: f64,
}

impl<'o> Shaft<'o> {
    /// Creates the shaft between two outlines, bounded at first only by their box.
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

    /// Cuts off the part behind a plane, or nearer to it than `resolution`.
    pub(super) fn cut(&mut self, plane: Plane, resolution: f64) {
        let normal = -plane.normal;
        self.planes.push(Plane { point: plane.point + (resolution - self.rounding) * plane.normal, normal });
    }

    /// Adds the planes through each edge of one outline and a vertex of the other that have both
    /// outlines on one side.
    fn add_planes_about_edges(&mut self, edges: &[Vector], vertices: &[Vector]) {
        // a single point has no edges, and two points have one edge
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

    /// Whether the shaft can contain a part of a box.
    pub(super) fn may_meet(&self, bounds: &Bounds) -> bool {
        let is_inside = |plane: &Plane| plane.distance(bounds.farthest(-plane.normal)) < -self.rounding;
        self.bounds.meets(bounds) && self.planes.iter().all(is_inside)
    }

    /// Whether the shaft can contain a part of a convex outline: no plane of the shaft separates
    /// them.
    pub(super) fn may_hold(&self, outline: &[Vector]) -> bool {
        let is_inside = |plane: &Plane| outline.iter().any(|&v| plane.distance(v) < -self.rounding);
        self.planes.iter().all(is_inside)
    }
}

/// Returns the unit normals of the planes through the line from a in a direction and two of the
/// vertices: the first and the last that a half-plane meets as it turns about the line, by the
/// right-hand rule along the direction, through all vertices. The vertices span less than half a
/// turn.
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
    // later vertices lie on the left of direction × first, earlier ones on the right of direction ×
    // last
    let Some([first, last]) = ends else { return [None; 2] };
    [unit(first.cross(direction)), unit(direction.cross(last))]
}

/// Normalizes a vector up to rounding; `None` if its square overflows or underflows. Without that
/// plane the shaft is only wider.
fn unit(v: Vector) -> Option<Vector> {
    let squared = v.dot(v);
    squared.is_normal().then(|| (1.0 / squared.sqrt()) * v)
}
