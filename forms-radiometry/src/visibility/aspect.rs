//! Aspects: cells of points from which a luminaire looks topologically the same behind its
//! occluders.
//!
//! ```text
//! points ─ planes of luminaire, horizon and screens ─▶ cells: each shadow has the same silhouette
//!        ─ planes through an edge of one outline and a corner of the other ─▶ cells: the same
//!                                                corners are hidden, the same edges cross
//! ```
//! The side of an edge from a to b on which a point p sees a corner c is the sign of
//! ```text
//! (b − p) × (a − p) · (c − p)  =  (b − c) × (a − c) · (c − p),
//! ```
//! which is affine in p: the points that see c on the same side lie on one side of the plane
//! through a, b and c.
//!
//! Source of the term: J. Koenderink, A. van Doorn, The internal representation of solid shape with
//! respect to vision (1979).

use super::arrangement::{Arrangement, Cell, Side};
use super::body::Body;
use super::silhouette_crossing::{End, MOST, Signs};
use super::{Screen, Screens};
use crate::geometry::{Plane, Vector};
use smallvec::SmallVec;

/// Products below this fraction of their bound have an uncertain sign: far above rounding, far
/// below usual values.
const UNSURE: f64 = 1e-11;

/// The largest number of sides of a body for which aspects are computed.
const MOST_SIDES: usize = 64;

/// The largest number of occluders for each point for which aspects are computed: their planes take
/// longer than the shadows themselves if there are few points, and of many occluders hardly any
/// point sees the shadow of only one.
pub(super) const MOST_OCCLUDERS: f64 = 0.7;

/// Receivers that see a luminaire behind some occluders.
#[derive(Clone, Copy)]
pub(crate) struct Looking<'l> {
    pub(crate) points: &'l [Vector],
    /// Corners of a convex set that contains the points.
    pub(crate) outline: &'l [Vector],
    /// Normal of the horizon. The part of the luminaire below the horizon does not count.
    pub(crate) horizon: Option<Vector>,
    /// The outline of the luminaire, and its unit normal.
    pub(crate) luminaire: (&'l [Vector], Vector),
    /// The potential occluders.
    pub(crate) screens: &'l [u32],
}

/// The shadows that can hide a part of a luminaire.
#[derive(Clone, Debug, Default)]
pub(super) struct Shadows {
    /// Silhouette edges of the shadows, with the shadow on their left, and the end of each shadow's
    /// edges.
    edges: Vec<[Vector; 2]>,
    ends: Vec<usize>,
    seen: Vec<bool>,
}

/// The appearance of a luminaire behind these shadows.
#[derive(Clone, Debug, Default)]
pub(super) struct Aspect {
    /// The shadow that hides a part.
    pub(super) shadow: Vec<[Vector; 2]>,
    /// The edges of the contour of the visible part.
    pub(super) border: Vec<[End; 2]>,
    signs: Signs,
}

/// An occluder: a single screen, or a body.
enum Obstacle<'s> {
    Screen(&'s Screen),
    Body(&'s Body),
}

impl Screens {
    fn obstacle(&self, index: u32) -> Obstacle<'_> {
        let index = index as usize;
        self.screens
            .get(index)
            .map_or_else(|| Obstacle::Body(&self.bodies[index - self.screens.len()]), Obstacle::Screen)
    }

    /// Adds the planes that determine the silhouettes: the plane of the luminaire, one plane
    /// through each of its corners parallel to the horizon, and the planes of the occluders.
    /// Returns `None` if an occluder has too many.
    pub(super) fn add_planes(&self, looking: &Looking, planes: &mut Arrangement) -> Option<()> {
        let (corners, normal) = looking.luminaire;
        planes.clear();
        planes.add(Plane { point: corners[0], normal }, self.resolution);
        if let Some(horizon) = looking.horizon {
            corners.iter().for_each(|&point| planes.add(Plane { point, normal: -horizon }, self.rounding));
        }
        for &index in looking.screens {
            match self.obstacle(index) {
                Obstacle::Screen(screen) => planes.add(screen.plane, self.resolution),
                Obstacle::Body(body) if body.planes.len() > MOST_SIDES => return None,
                Obstacle::Body(body) => {
                    body.planes.iter().for_each(|&plane| planes.add(plane, self.rounding));
                    body.planes.iter().for_each(|&plane| planes.add(plane, self.resolution));
                    body.lid.iter().for_each(|&lid| planes.add(lid, self.rounding));
                }
            }
        }
        Some(())
    }

    /// Whether a cell of these planes is in front of the luminaire.
    pub(super) fn is_in_front(cell: &Cell) -> bool {
        cell.side(0) == Side::Front
    }

    /// Collects the silhouette edges of the shadows as a cell of these planes sees them. Returns
    /// `None` where the luminaire is not completely above the horizon, where the cell is not
    /// outside a body, or where the edges do not describe a shadow completely.
    pub(super) fn take_shadows(&self, looking: &Looking, cell: &Cell, shadows: &mut Shadows) -> Option<()> {
        let (corners, normal) = looking.luminaire;
        shadows.edges.clear();
        shadows.ends.clear();
        let mut planes = 1..;
        let mut next = || cell.side(planes.next().expect("planes do not end"));
        if looking.horizon.is_some() && corners.iter().filter(|_| next() == Side::Behind).count() > 0 {
            return None;
        }
        for &index in looking.screens {
            match self.obstacle(index) {
                Obstacle::Screen(screen) => {
                    let side = next();
                    self.take_shadow_of_screen((screen, side), (corners, normal), &mut shadows.edges)?;
                }
                Obstacle::Body(body) => {
                    let Shadows { edges, seen, .. } = &mut *shadows;
                    seen.clear();
                    seen.extend(body.planes.iter().map(|_| next() == Side::Front));
                    let outside = body.planes.iter().filter(|_| next() == Side::Front).count();
                    let is_in_lid = body.lid.is_some_and(|_| next() == Side::Front);
                    if outside == 0 || is_in_lid {
                        return None;
                    }
                    edges.extend(body.outline(seen));
                }
            }
            let start = shadows.ends.last().copied().unwrap_or(0);
            if shadows.edges.len() - start > MOST {
                return None;
            }
            shadows.ends.push(shadows.edges.len());
        }
        Some(())
    }

    /// Collects the edges of a screen's shadow, if it casts any, as seen from one side of the
    /// screen.
    fn take_shadow_of_screen(
        &self,
        (screen, side): (&Screen, Side),
        (corners, normal): (&[Vector], Vector),
        edges: &mut Vec<[Vector; 2]>,
    ) -> Option<()> {
        let beyond = |sign: f64| corners.iter().any(|&v| sign * screen.plane.distance(v) > self.resolution);
        let parts = match side {
            Side::Front => beyond(-1.0),
            Side::Behind => beyond(1.0),
            // a screen seen edge-on hides nothing
            Side::Neither => false,
        };
        if !parts {
            return Some(());
        }
        if screen.vertices.iter().any(|&v| normal.dot(v - corners[0]) < 0.0) {
            return None;
        }
        edges.extend(screen.edges().map(|[a, b]| if side == Side::Front { [a, b] } else { [b, a] }));
        Some(())
    }
}

impl Shadows {
    /// Returns the edges of each shadow.
    fn all(&self) -> impl Iterator<Item = &[[Vector; 2]]> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        starts.zip(&self.ends).map(|(start, &end)| &self.edges[start..end])
    }

    /// Returns the edges of each shadow with the corners of a luminaire, and vice versa.
    fn edges_and_corners(&self, luminaire: &[Vector]) -> impl Iterator<Item = ([Vector; 2], Vector)> {
        self.all().flat_map(move |shadow| {
            let with_corners = |&edge| luminaire.iter().map(move |&corner| (edge, corner));
            let with_starts =
                move |j| shadow.iter().map(move |&[start, _]| (edge_after(luminaire, j), start));
            shadow.iter().flat_map(with_corners).chain((0..luminaire.len()).flat_map(with_starts))
        })
    }

    /// Adds the planes through the edges of each shadow and the corners of a luminaire, and vice
    /// versa. They are to separate points in `outline`.
    pub(super) fn add_planes(&self, luminaire: &[Vector], outline: &[Vector], planes: &mut Arrangement) {
        planes.clear();
        for ([a, b], corner) in self.edges_and_corners(luminaire) {
            let distance = |&point: &Vector| (corner - point).largest();
            let reach = outline.iter().map(distance).fold(0.0, f64::max);
            let [a, b] = [a - corner, b - corner];
            let least = UNSURE * a.largest() * b.largest() * reach;
            planes.add(Plane { point: corner, normal: a.cross(b) }, least);
        }
    }

    /// Whether what points of an outline see can change at one of these planes, given by their
    /// indices.
    pub(super) fn turn_at(&self, luminaire: &[Vector], outline: &[Vector], planes: &[usize]) -> bool {
        let mut next = planes.iter().peekable();
        next.peek().is_some()
            && self.edges_and_corners(luminaire).enumerate().any(|(index, (edge, corner))| {
                next.next_if_eq(&&index).is_some() && passes_over(edge, corner, outline)
            })
    }
}

/// Whether a point of an outline can see a corner on an edge from a to b, and not only on its line.
///
/// In the plane through all three, p sees the corner c between a and b where (a − p) × (c − p) and
/// (c − p) × (b − p) point to the side to which (a − p) × (b − p) does. All three are affine in p: one
/// that has the same sign where the plane enters and leaves the outline has it in between.
fn passes_over([a, b]: [Vector; 2], corner: Vector, outline: &[Vector]) -> bool {
    let normal = (a - corner).cross(b - corner);
    let height = |p: Vector| normal.dot(p - corner);
    let mut sides: SmallVec<[[f64; 3]; 2]> = SmallVec::new();
    for (index, &p) in outline.iter().enumerate() {
        let q = outline[(index + 1) % outline.len()];
        let [of_p, of_q] = [p, q].map(height);
        if (of_p < 0.0) == (of_q < 0.0) {
            continue;
        }
        let p = p + of_p / (of_p - of_q) * (q - p);
        let side = |from: Vector, to: Vector| normal.dot((from - p).cross(to - p));
        sides.push([side(a, b), side(a, corner), side(corner, b)]);
    }
    let [enters, leaves] = sides[..] else { return true };
    let is_opposite = |part: usize| enters[0] * enters[part] < 0.0 && leaves[0] * leaves[part] < 0.0;
    enters[0] * leaves[0] <= 0.0 || !(is_opposite(1) || is_opposite(2))
}

impl Aspect {
    /// Sets this to the aspect that a cell of these planes sees. Returns `None` where more than one
    /// shadow hides a part of the luminaire, and where a corner is so close to an edge that its
    /// side is uncertain.
    pub(super) fn set(&mut self, luminaire: &[Vector], shadows: &Shadows, cell: &Cell) -> Option<()> {
        self.shadow.clear();
        self.border.clear();
        let mut plane = 0;
        for edges in shadows.all() {
            let counts = [luminaire.len(), edges.len()];
            let [of_shadow, of_luminaire] = [plane, plane + counts[0] * counts[1]];
            plane += 2 * counts[0] * counts[1];
            let all_beyond =
                |first: usize, count: usize| (first..first + count).all(|p| cell.side(p) == Side::Behind);
            let is_beside = (0..counts[1]).any(|k| all_beyond(of_shadow + k * counts[0], counts[0]))
                || (0..counts[0]).any(|j| all_beyond(of_luminaire + j * counts[1], counts[1]));
            if is_beside || edges.is_empty() {
                continue;
            }
            if !self.shadow.is_empty() {
                return None;
            }
            self.shadow.extend_from_slice(edges);
            self.signs.counts = counts;
            for (k, [_, end]) in edges.iter().enumerate() {
                self.signs.next[k] = edges.iter().position(|[start, _]| start == end)?;
                self.signs.inside[0][k] = bits(cell, of_shadow + k * counts[0], counts[0])?;
            }
            for j in 0..counts[0] {
                self.signs.inside[1][j] = bits(cell, of_luminaire + j * counts[1], counts[1])?;
            }
        }
        if self.shadow.is_empty() {
            let count = luminaire.len();
            self.border.extend((0..count).map(|corner| [corner, (corner + 1) % count].map(End::Luminaire)));
            return Some(());
        }
        self.signs.border(&mut self.border)
    }
}

/// Returns, as bits, which of `count` planes from `first` on a cell is in front of; `None` where
/// this is uncertain.
fn bits(cell: &Cell, first: usize, count: usize) -> Option<u32> {
    (0..count).try_fold(0, |bits, place| match cell.side(first + place) {
        Side::Front => Some(bits | 1 << place),
        Side::Behind => Some(bits),
        Side::Neither => None,
    })
}

/// Returns the edge that begins at a corner of an outline.
pub(super) fn edge_after(outline: &[Vector], corner: usize) -> [Vector; 2] {
    [outline[corner], outline[(corner + 1) % outline.len()]]
}
