//! Convex bodies: screens that share edges are joined into one body, whose shadow is clipped out at
//! once.
//!
//! ```text
//! screens ─ joined at convex edges ─▶ groups ─ convex, closed but for one plane ─▶ bodies
//! ```
//! Seen from a point outside a convex body, the edges between visible and invisible sides are the
//! silhouette of its shadow. A body can be open in one plane, like a box without a bottom: seen
//! from the body's side of that plane it looks closed.

use super::Screen;
use crate::geometry::bounds::Bounds;
use crate::geometry::{FaceList, Plane, Vector, Welded, edges};
use rustc_hash::FxHashMap;

/// The largest number of screens of a body: each corner is compared with each plane.
const MOST_SCREENS: usize = 1 << 14;

/// Screens that bound a convex body, with their fronts on the outside.
#[derive(Clone, Debug)]
pub(super) struct Body {
    /// The indices of the screens.
    pub(super) screens: Vec<u32>,
    pub(super) planes: Vec<Plane>,
    edges: Vec<Edge>,
    /// The plane in which the body is open.
    pub(super) lid: Option<Plane>,
    corners: Vec<Vector>,
    pub(super) bounds: Bounds,
}

/// An edge of a body, from a to b in the orientation of `side`.
#[derive(Clone, Copy, Debug)]
struct Edge {
    ends: [Vector; 2],
    side: usize,
    /// The side beyond the edge; `None` where the body is open.
    beyond: Option<usize>,
}

/// Mark of an edge without a screen beyond it.
const NOTHING: u32 = u32::MAX;

/// For each screen, the screens beyond its edges, in the order of its vertices.
struct Neighbours(FaceList);

impl Neighbours {
    fn of(&self, screen: usize) -> impl Iterator<Item = Option<usize>> {
        self.0.get(screen).iter().map(|&beyond| (beyond != NOTHING).then_some(beyond as usize))
    }
}

/// Finds the bodies, and for each screen its body, if any.
pub(super) fn bodies(screens: &[Screen], resolution: f64, rounding: f64) -> (Vec<Body>, Vec<Option<u32>>) {
    let neighbours = neighbours(screens, [resolution, rounding]);
    let mut bodies = Vec::new();
    let mut of_screen = vec![None; screens.len()];
    for group in groups(&neighbours, screens.len()) {
        if let Some(body) = Body::of(&group, screens, &neighbours, [resolution, rounding]) {
            group.iter().for_each(|&screen| of_screen[screen] = Some(bodies.len() as u32));
            bodies.push(body);
        }
    }
    (bodies, of_screen)
}

/// Returns, for each edge, the screen that has the same edge in the opposite direction, if the two
/// enclose less than half a turn. If there are several, as where bodies touch, it is the one that
/// encloses the smallest angle. A screen that lies back to back with the first encloses nothing.
fn neighbours(screens: &[Screen], [resolution, rounding]: [f64; 2]) -> Neighbours {
    let mut welded = Welded::new(resolution);
    let mut outlines = FaceList::default();
    screens.iter().for_each(|screen| outlines.push(screen.vertices.iter().map(|&v| welded.number(v))));
    drop(welded);
    let sides = |(screen, outline)| edges(outline).map(move |edge| (edge, screen as u32));
    let mut owners: Vec<([u32; 2], u32)> = outlines.iter().enumerate().flat_map(sides).collect();
    owners.sort_unstable();
    let others = |edge: [u32; 2]| {
        let first = owners.partition_point(|(other, _)| *other < edge);
        owners[first..].iter().take_while(move |(other, _)| *other == edge).map(|&(_, screen)| screen)
    };
    let encloses = |plane: Plane, other: &Screen| {
        let is_behind = other.vertices.iter().all(|&corner| plane.distance(corner) <= rounding);
        let is_solid = other.vertices.iter().any(|&corner| plane.distance(corner) < -resolution);
        is_behind && (is_solid || plane.normal.dot(other.plane.normal) > 0.0)
    };
    let mut neighbours = FaceList::default();
    for (screen, outline) in screens.iter().zip(outlines.iter()) {
        let turn = |other: &u32| screen.plane.normal.dot(screens[*other as usize].plane.normal);
        neighbours.push(edges(outline).map(|[a, b]| {
            let convex = others([b, a]).filter(|&other| encloses(screen.plane, &screens[other as usize]));
            convex.min_by(|one, other| turn(one).total_cmp(&turn(other))).unwrap_or(NOTHING)
        }));
    }
    Neighbours(neighbours)
}

/// Returns the connected groups of neighbouring screens, without screens that are alone.
fn groups(neighbours: &Neighbours, count: usize) -> Vec<Vec<usize>> {
    let mut is_known = vec![false; count];
    let mut groups = Vec::new();
    for start in 0..count {
        if std::mem::replace(&mut is_known[start], true) {
            continue;
        }
        let mut group = vec![start];
        let mut place = 0;
        while let Some(&screen) = group.get(place) {
            for other in neighbours.of(screen).flatten() {
                if !std::mem::replace(&mut is_known[other], true) {
                    group.push(other);
                }
            }
            place += 1;
        }
        if group.len() > 1 {
            groups.push(group);
        }
    }
    groups
}

impl Body {
    /// Returns the body that a group of screens bounds, if it does.
    fn of(
        group: &[usize],
        screens: &[Screen],
        neighbours: &Neighbours,
        [resolution, rounding]: [f64; 2],
    ) -> Option<Self> {
        if group.len() > MOST_SCREENS {
            return None;
        }
        let place: FxHashMap<usize, usize> =
            group.iter().enumerate().map(|(place, &screen)| (screen, place)).collect();
        let edges_of = |(side, &screen): (usize, &usize)| {
            // if more than two screens share an edge, the neighbour can belong to another group
            let beyond =
                neighbours.of(screen).map(|other| other.and_then(|other| place.get(&other).copied()));
            let edge = move |(ends, beyond)| Edge { ends, side, beyond };
            screens[screen].edges().zip(beyond).map(edge).collect::<Vec<_>>()
        };
        let edges: Vec<Edge> = group.iter().enumerate().flat_map(edges_of).collect();
        let corners: Vec<Vector> = edges.iter().map(|edge| edge.ends[0]).collect();
        let planes: Vec<Plane> = group.iter().map(|&screen| screens[screen].plane).collect();
        let lid = lid(&edges, &corners, rounding)?;
        let is_behind = |plane: &Plane| corners.iter().all(|&corner| plane.distance(corner) <= rounding);
        let is_solid = corners.iter().any(|&corner| planes[0].distance(corner) < -resolution);
        if !is_solid || !planes.iter().chain(&lid).all(is_behind) {
            return None;
        }
        let once = |edge: &Edge| edge.beyond.is_none_or(|beyond| edge.side < beyond);
        let screens = group.iter().map(|&screen| screen as u32).collect();
        let bounds = Bounds::of(corners.iter().copied());
        Some(Self { screens, planes, edges: edges.into_iter().filter(once).collect(), lid, corners, bounds })
    }

    /// Whether the whole body is in front of a plane or in it.
    pub(super) fn is_before(&self, plane: Plane, rounding: f64) -> bool {
        self.corners.iter().all(|&corner| plane.distance(corner) >= -rounding)
    }

    /// Whether the body lies between all points of one outline and all points of another. The
    /// region that it hides from a point is convex, and so is the set of points from which it hides
    /// a given point: testing corners is enough.
    pub(super) fn hides_all(&self, [here, there]: [&[Vector]; 2]) -> bool {
        here.iter().all(|&from| there.iter().all(|&to| self.is_between(from, to)))
    }

    /// Whether the segment between two points outside enters the body and leaves it again.
    fn is_between(&self, from: Vector, to: Vector) -> bool {
        let (mut enter, mut leave) = (f64::NEG_INFINITY, f64::INFINITY);
        for plane in self.planes.iter().chain(&self.lid) {
            let (start, end) = (plane.distance(from), plane.distance(to));
            if start > end {
                enter = enter.max(start / (start - end));
            } else if start < end {
                leave = leave.min(start / (start - end));
            } else if start >= 0.0 {
                return false;
            }
        }
        0.0 <= enter && enter < leave && leave <= 1.0
    }

    /// Returns the edges of the body's silhouette seen from a point, in no particular order, each
    /// with the body on its left. Returns `None` where the point is not outside the body or lies
    /// beyond the plane of its opening. `seen` is a buffer for which sides are visible.
    pub(super) fn shadow<'b>(
        &'b self,
        apex: Vector,
        resolution: f64,
        seen: &'b mut Vec<bool>,
    ) -> Option<impl Iterator<Item = [Vector; 2]> + 'b> {
        if self.lid.is_some_and(|lid| lid.distance(apex) > 0.0) {
            return None;
        }
        let mut is_outside = false;
        seen.clear();
        seen.extend(self.planes.iter().map(|plane| {
            let distance = plane.distance(apex);
            is_outside |= distance > resolution;
            distance > 0.0
        }));
        is_outside.then(|| self.outline(seen))
    }

    /// Returns the same silhouette from a point that sees these sides.
    pub(super) fn outline<'b>(&'b self, seen: &'b [bool]) -> impl Iterator<Item = [Vector; 2]> + 'b {
        let side = move |edge: &Edge| {
            let [a, b] = edge.ends;
            match (seen[edge.side], edge.beyond.is_some_and(|beyond| seen[beyond])) {
                (true, false) => Some([a, b]),
                (false, true) => Some([b, a]),
                _ => None,
            }
        };
        self.edges.iter().filter_map(side)
    }
}

/// Returns the plane of all edges without a side beyond, with its normal away from the corners:
/// `Some(None)` if there are no such edges, `None` if they do not lie in a plane.
#[expect(clippy::option_option, reason = "open in no plane is not the same as not open")]
fn lid(edges: &[Edge], corners: &[Vector], rounding: f64) -> Option<Option<Plane>> {
    let open: Vec<[Vector; 2]> =
        edges.iter().filter(|edge| edge.beyond.is_none()).map(|edge| edge.ends).collect();
    let Some(&[point, _]) = open.first() else { return Some(None) };
    // edges run around the opening in the orientation of their sides, opposite to that of a lid
    let twice = open.iter().fold(Vector::default(), |sum, &[a, b]| sum + (b - point).cross(a - point));
    let plane = Plane { point, normal: twice.unit()? };
    let is_in_plane = |&[a, _]: &[Vector; 2]| plane.distance(a).abs() <= rounding;
    let is_lid =
        open.iter().all(is_in_plane) && corners.iter().all(|&corner| plane.distance(corner) <= rounding);
    is_lid.then_some(Some(plane))
}
