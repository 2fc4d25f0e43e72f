//! Rays: bodies that share no edge with what surrounds them are joined to it along a straight line.

use super::edges::Edge;
use super::sheets::{Piece, Sheet, Side};
use crate::geometry::{Polygon, Vector};

/// A direction that no model is aligned with.
const DIRECTION: Vector = Vector::new(0.486_204_391_7, 0.293_518_640_3, 0.823_106_872_9);

/// The sides that see each other along a ray to each body that has a sheet of the kind asked for: the first side
/// of the body that the ray meets, and what it leaves before it.
pub(super) fn seen(
    sheets: &[Sheet],
    edges: &[Edge],
    is_asked_for: impl Fn(&Sheet) -> bool,
) -> Vec<(Side, Side)> {
    let bodies = bodies(sheets.len(), edges);
    let mut done = vec![false; sheets.len()];
    let mut seen = Vec::new();
    for (index, sheet) in sheets.iter().enumerate().filter(|(_, sheet)| is_asked_for(sheet)) {
        if std::mem::replace(&mut done[bodies[index]], true) {
            continue;
        }
        seen.extend(first_sight(sheets, sheet, |other| bodies[other] == bodies[index]));
    }
    seen
}

/// The body that each sheet belongs to: sheets that share an edge belong to one.
fn bodies(sheets: usize, edges: &[Edge]) -> Vec<usize> {
    let mut neighbours = vec![Vec::new(); sheets];
    for edge in edges {
        let first = edge.first();
        for sheet in edge.sheets().filter(|&sheet| sheet != first) {
            neighbours[first].push(sheet);
            neighbours[sheet].push(first);
        }
    }
    let mut bodies: Vec<Option<usize>> = vec![None; sheets];
    for start in 0..sheets {
        let mut reached = vec![start];
        while let Some(sheet) = reached.pop() {
            if bodies[sheet].is_none() {
                bodies[sheet] = Some(start);
                reached.extend(&neighbours[sheet]);
            }
        }
    }
    bodies.into_iter().map(Option::unwrap_or_default).collect()
}

/// The first side of a body on a ray through one of its sheets, and the side before it.
fn first_sight(sheets: &[Sheet], target: &Sheet, is_body: impl Fn(usize) -> bool) -> Option<(Side, Side)> {
    let through = middle(&target.shape);
    let mut hits: Vec<Hit> = Vec::new();
    for (index, sheet) in sheets.iter().enumerate() {
        hits.extend(crossings(&sheet.shape, through).into_iter().map(|(at, from_front)| Hit {
            at,
            index,
            from_front,
        }));
    }
    hits.sort_by(|a, b| a.at.total_cmp(&b.at));
    let first = hits.iter().position(|hit| is_body(hit.index))?;
    let before = first.checked_sub(1).map_or(Side::Outside, |before| hits[before].left());
    Some((hits[first].met(), before))
}

/// Where a ray crosses a sheet.
struct Hit {
    /// The length along the ray.
    at: f64,
    index: usize,
    from_front: bool,
}

impl Hit {
    /// The side at which the ray arrives.
    fn met(&self) -> Side {
        if self.from_front { Side::Front(self.index) } else { Side::Back(self.index) }
    }

    /// The side at which it goes on.
    fn left(&self) -> Side {
        if self.from_front { Side::Back(self.index) } else { Side::Front(self.index) }
    }
}

/// A point within a sheet.
fn middle(piece: &Piece) -> Vector {
    match piece {
        Piece::Face(polygon, _) => {
            let piece = &polygon.convex_pieces()[0];
            (1.0 / piece.len() as f64) * piece.iter().fold(Vector::default(), |sum, &v| sum + v)
        }
        Piece::Sphere(sphere) => sphere.center,
        Piece::Disk(disk) => disk.center,
    }
}

/// Where the line through a point crosses a sheet, and whether from its front.
fn crossings(piece: &Piece, through: Vector) -> Vec<(f64, bool)> {
    match piece {
        Piece::Face(polygon, _) => {
            let at = plane(polygon.vertices()[0], polygon.normal(), through);
            let crosses = |at: &f64| contains(polygon, through + *at * DIRECTION);
            at.filter(crosses).map(|at| (at, polygon.normal().dot(DIRECTION) < 0.0)).into_iter().collect()
        }
        Piece::Sphere(sphere) => {
            // |o + t d|² = R² with o the point seen from the centre.
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
            let crosses = |at: &f64| (through + *at * DIRECTION - disk.center).length() <= disk.radius;
            at.filter(crosses).map(|at| (at, disk.normal.dot(DIRECTION) < 0.0)).into_iter().collect()
        }
    }
}

/// Where the line through a point crosses a plane.
fn plane(point: Vector, normal: Vector, through: Vector) -> Option<f64> {
    let slope = normal.dot(DIRECTION);
    (slope != 0.0).then(|| normal.dot(point - through) / slope)
}

/// Whether a point of a polygon's plane lies in it.
fn contains(polygon: &Polygon, point: Vector) -> bool {
    polygon.convex_pieces().iter().any(|piece| {
        (0..piece.len()).all(|i| {
            let (a, b) = (piece[i], piece[(i + 1) % piece.len()]);
            polygon.normal().dot((b - a).cross(point - a)) >= 0.0
        })
    })
}
