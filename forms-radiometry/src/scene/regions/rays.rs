//! Rays: connects bodies that share no edge with their surroundings to them along a straight line.

use super::edges::Edge;
use super::interfaces::{Interface, Piece, Side};
use crate::geometry::{Crossing, Polygon, Quadric, Round, Vector};

/// A direction with which no model is aligned.
const DIRECTION: Vector = Vector::new(0.486_204_391_7, 0.293_518_640_3, 0.823_106_872_9);

/// Returns pairs of sides that see each other along a ray, one for each body with a sheet for which
/// `is_asked_for` holds: the first side of the body that the ray meets, and the side that the ray
/// leaves before it.
pub(super) fn seen(
    interfaces: &[Interface],
    edges: &[Edge],
    is_asked_for: impl Fn(&Interface) -> bool,
) -> Vec<(Side, Side)> {
    let bodies = bodies(interfaces, edges);
    let asked_for =
        |body: &&Body| body.interfaces.iter().any(|&interface| is_asked_for(&interfaces[interface]));
    bodies.iter().filter(asked_for).filter_map(|body| first_sight(interfaces, &bodies, body)).collect()
}

/// Sheets that are connected by edges, and a bounding ball.
struct Body {
    interfaces: Vec<usize>,
    middle: Vector,
    radius: f64,
}

fn bodies(interfaces: &[Interface], edges: &[Edge]) -> Vec<Body> {
    let mut neighbours = vec![Vec::new(); interfaces.len()];
    for edge in edges {
        let first = edge.first();
        for interface in edge.interfaces().filter(|&interface| interface != first) {
            neighbours[first].push(interface);
            neighbours[interface].push(first);
        }
    }
    let mut is_reached = vec![false; interfaces.len()];
    let mut bodies = Vec::new();
    for start in 0..interfaces.len() {
        let (mut members, mut reached) = (Vec::new(), vec![start]);
        while let Some(interface) = reached.pop() {
            if !std::mem::replace(&mut is_reached[interface], true) {
                members.push(interface);
                reached.extend(&neighbours[interface]);
            }
        }
        if !members.is_empty() {
            bodies.push(Body::of(interfaces, members));
        }
    }
    bodies
}

impl Body {
    fn of(all: &[Interface], interfaces: Vec<usize>) -> Self {
        let middle = middle(&all[interfaces[0]].shape);
        let reach = |interface: &usize| match &all[*interface].shape {
            Piece::Face(polygon, _) => {
                polygon.vertices().iter().map(|&v| (v - middle).length()).fold(0.0, f64::max)
            }
            Piece::Sphere(sphere) => (sphere.center - middle).length() + sphere.radius,
            Piece::Disk(disk) => (disk.center - middle).length() + disk.radius,
            Piece::Quadric(quadric) => (quadric.center() - middle).length() + quadric.radius(),
        };
        let radius = interfaces.iter().map(reach).fold(0.0, f64::max);
        Self { interfaces, middle, radius }
    }

    /// Whether the line through a point comes near the bounding ball, with a margin for rounding.
    fn is_near(&self, through: Vector) -> bool {
        let o = self.middle - through;
        let along = (o.dot(DIRECTION) / DIRECTION.dot(DIRECTION)) * DIRECTION;
        (o - along).length() <= (1.0 + 1e-6) * self.radius
    }
}

/// Returns the first side of a body on a ray through one of its sheets, and the side before it.
fn first_sight(interfaces: &[Interface], bodies: &[Body], body: &Body) -> Option<(Side, Side)> {
    let through = body.middle;
    let mut hits: Vec<Hit> = Vec::new();
    for other in bodies.iter().filter(|other| other.is_near(through)) {
        let is_body = std::ptr::eq(other, body);
        for &index in &other.interfaces {
            let crossings = crossings(&interfaces[index].shape, through).into_iter();
            hits.extend(crossings.map(|(at, from_front)| Hit { at, index, from_front, is_body }));
        }
    }
    hits.sort_by(|a, b| a.at.total_cmp(&b.at));
    let first = hits.iter().position(|hit| hit.is_body)?;
    let before = first.checked_sub(1).map_or(Side::Outside, |before| hits[before].left());
    Some((hits[first].met(), before))
}

/// Crossing of a ray with a sheet.
struct Hit {
    /// The position along the ray.
    at: f64,
    index: usize,
    from_front: bool,
    is_body: bool,
}

impl Hit {
    /// Returns the side at which the ray arrives.
    fn met(&self) -> Side {
        if self.from_front { Side::Front(self.index) } else { Side::Back(self.index) }
    }

    /// Returns the side from which the ray continues.
    fn left(&self) -> Side {
        if self.from_front { Side::Back(self.index) } else { Side::Front(self.index) }
    }
}

/// Returns a point of a sheet, or the centre of a sphere.
fn middle(piece: &Piece) -> Vector {
    match piece {
        Piece::Face(polygon, _) => Vector::mean(&polygon.convex_pieces()[0]),
        Piece::Sphere(sphere) => sphere.center,
        Piece::Disk(disk) => disk.point([0.5, 0.0]),
        Piece::Quadric(quadric) => quadric.point([0.5, 0.0]).0,
    }
}

/// Returns where the line through a point crosses a sheet, and whether from its front.
fn crossings(piece: &Piece, through: Vector) -> Vec<(f64, bool)> {
    match piece {
        Piece::Face(polygon, _) => {
            let at = plane(polygon.vertices()[0], polygon.normal(), through);
            let crosses = |at: &f64| contains(polygon, through + *at * DIRECTION);
            at.filter(crosses).map(|at| (at, polygon.normal().dot(DIRECTION) < 0.0)).into_iter().collect()
        }
        Piece::Sphere(sphere) => {
            // |o + t d|² = R² with o the point relative to the centre.
            let o = through - sphere.center;
            let d2 = DIRECTION.dot(DIRECTION);
            let half = o.dot(DIRECTION) / d2;
            let root = half * half - (o.dot(o) - sphere.radius * sphere.radius) / d2;
            if root.is_nan() || root <= 0.0 {
                return Vec::new();
            }
            vec![(-half - root.sqrt(), !sphere.inward), (-half + root.sqrt(), sphere.inward)]
        }
        Piece::Disk(disk) => {
            let at = plane(disk.center, disk.normal, through);
            let crosses = |at: &f64| disk.reaches(through + *at * DIRECTION);
            at.filter(crosses).map(|at| (at, disk.normal.dot(DIRECTION) < 0.0)).into_iter().collect()
        }
        Piece::Quadric(quadric) => crossings_of(quadric, through),
    }
}

/// Returns where the line through a point crosses a quadric, and whether from its front.
fn crossings_of(quadric: &Quadric, through: Vector) -> Vec<(f64, bool)> {
    let crossings = quadric.crossings(through, DIRECTION).into_iter().flatten();
    crossings.map(|Crossing { distance, enters }| (distance, enters != quadric.inward)).collect()
}

/// Returns where the line through a point crosses a plane.
fn plane(point: Vector, normal: Vector, through: Vector) -> Option<f64> {
    let slope = normal.dot(DIRECTION);
    (slope != 0.0).then(|| normal.dot(point - through) / slope)
}

/// Whether a polygon contains a point of its plane.
fn contains(polygon: &Polygon, point: Vector) -> bool {
    polygon.convex_pieces().iter().any(|piece| {
        (0..piece.len()).all(|i| {
            let (a, b) = (piece[i], piece[(i + 1) % piece.len()]);
            polygon.normal().dot((b - a).cross(point - a)) >= 0.0
        })
    })
}
