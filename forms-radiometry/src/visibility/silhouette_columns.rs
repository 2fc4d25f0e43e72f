//! Silhouette columns: the contour of the visible part of a luminaire, as columns of edges for many
//! points at once.
//!
//! ```text
//! points ─ aspect ─▶ cells of points that see the same corners and crossings ─▶ edges in columns
//!                └─▶ points that are too close to a plane ─ visible ─▶ pieces ─▶ edges in columns
//! edges in columns ─▶ sums by point
//! ```
//! Edges that cross end at the same point, to the last bit, so contours are closed. A sum over
//! edges needs no more than that, while convex pieces would have several times as many edges.
//! Points that see the same corners and crossings are computed together. Where a sign is uncertain,
//! an edge can coincide with another one: then no contour is returned, and pieces are clipped
//! instead.

use super::Screens;
use super::arrangement::{Arrangement, Cell};
use super::aspect::{Aspect, Looking, MOST_OCCLUDERS, Shadows, edge_after};
use super::horizon::Workspace;
use super::silhouette_crossing::{End, MOST};
use crate::geometry::Vector;
use crate::geometry::edges::Edges;

/// Buffers that are reused from group to group.
#[derive(Clone, Debug, Default)]
pub(crate) struct Borders {
    edges: Edges,
    /// The planes that determine the silhouettes, and the planes that determine which edges cross.
    planes: [Arrangement; 2],
    shadows: Shadows,
    drawing: Drawing,
    /// The points for which no contour is available.
    rest: Vec<u32>,
    aspects: Aspects,
}

/// What is known about the aspects of all points of an outline.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Aspects {
    /// All see the same corners and crossings: what they see is an analytic function of the point.
    #[default]
    One,
    /// There can be several; the function has kinks where one changes to the next.
    Several,
    Unknown,
}

impl Borders {
    /// Returns what is known about the aspects of the last points.
    pub(crate) fn aspects(&self) -> Aspects {
        self.aspects
    }
}

/// An aspect as points see it.
#[derive(Clone, Debug, Default)]
struct Drawing {
    aspect: Aspect,
    /// For each point, the fraction of a luminaire's edge at which the point sees a shadow's edge
    /// cross it.
    ratios: Vec<f64>,
}

impl Screens {
    /// Adds to each receiver's sum ∫ cos θ dω/π over the visible part of a luminaire, times a
    /// factor; θ is measured from the direction `along`.
    pub(crate) fn add_form_factors(
        &self,
        looking: Looking,
        (along, factor): (Vector, f64),
        (work, borders): (&mut Workspace, &mut Borders),
        sums: &mut [f64],
    ) {
        borders.edges.clear();
        borders.rest.clear();
        borders.aspects = Aspects::One;
        self.take_borders(&looking, borders);
        if !borders.rest.is_empty() {
            borders.aspects = Aspects::Unknown;
        }
        let Looking { points, horizon, luminaire: (corners, normal), screens, .. } = looking;
        for &index in &borders.rest {
            let position = points[index as usize];
            for piece in self.visible(position, horizon, corners, normal, screens, work) {
                borders.edges.push(index as usize, piece);
            }
        }
        borders.edges.add_form_factors(along, factor, sums);
    }

    /// Collects the contour edges of the visible parts, where contours are available.
    fn take_borders(&self, looking: &Looking, borders: &mut Borders) {
        let Borders { edges, planes: [planes, crossings], shadows, drawing, rest, aspects } = borders;
        let Looking { points, outline, luminaire: (corners, _), screens, .. } = *looking;
        let all = 0..points.len() as u32;
        let is_parted = corners.len() <= MOST
            && screens.len() as f64 <= MOST_OCCLUDERS * points.len() as f64
            && self.add_planes(looking, planes).is_some()
            && planes.part(points, all.clone(), outline).is_some();
        if !is_parted {
            rest.extend(all);
            return;
        }
        if !planes.cuts().is_empty() {
            *aspects = Aspects::Several;
        }
        for cell in planes.cells().filter(Self::is_in_front) {
            if self.take_shadows(looking, &cell, shadows).is_none() {
                rest.extend(cell.points);
                continue;
            }
            let mut draw = |members: &mut dyn Iterator<Item = u32>, outline: &[Vector]| {
                shadows.add_planes(corners, outline, crossings);
                crossings.part(points, members, outline)?;
                if *aspects == Aspects::One && shadows.turn_at(corners, outline, crossings.cuts()) {
                    *aspects = Aspects::Several;
                }
                for cell in crossings.cells() {
                    match drawing.aspect.set(corners, shadows, &cell) {
                        Some(()) => drawing.draw(&cell, corners, edges),
                        None => rest.extend(cell.points),
                    }
                }
                Some(())
            };
            if draw(&mut cell.points.iter().copied(), outline).is_none() {
                // planes do not separate a single point
                cell.points
                    .iter()
                    .for_each(|&index| _ = draw(&mut std::iter::once(index), &[points[index as usize]]));
                *aspects = Aspects::Several;
            }
        }
    }
}

impl Drawing {
    /// Appends the edges of the aspect as the points of a cell see them.
    fn draw(&mut self, cell: &Cell, luminaire: &[Vector], edges: &mut Edges) {
        let Self { aspect, ratios } = self;
        let (border, shadow) = (&aspect.border, &aspect.shadow);
        for (end, columns) in edges.grow(cell.points, border.len()).into_iter().enumerate() {
            let mut columns = columns.map(|column| column.chunks_exact_mut(cell.points.len()));
            for ends in border {
                let columns =
                    columns.each_mut().map(|column| column.next().expect("there is room for all edges"));
                match ends[end] {
                    End::Luminaire(corner) => place_corner(luminaire[corner], cell, columns),
                    End::Shadow(corner) => place_corner(shadow[corner][0], cell, columns),
                    End::Crossing([edge, of_shadow]) => {
                        let edges = [edge_after(luminaire, edge), shadow[of_shadow]];
                        place_crossing(edges, cell, ratios, columns);
                    }
                }
            }
        }
    }
}

/// Writes the position of a corner relative to the points of a cell.
fn place_corner(corner: Vector, cell: &Cell, columns: [&mut [f64]; 3]) {
    for ((column, places), corner) in columns.into_iter().zip(cell.places).zip(corner.coordinates()) {
        column.iter_mut().zip(places).for_each(|(at, place)| *at = corner - place);
    }
}

/// Writes the intersection of the edge from a to b with the plane through a point and an edge of a
/// shadow: a + α/(α − β) (b − a), where α and β are the triple products of that edge with a and b.
fn place_crossing(
    [[a, b], [start, end]]: [[Vector; 2]; 2],
    cell: &Cell,
    ratios: &mut Vec<f64>,
    columns: [&mut [f64]; 3],
) {
    let [of_a, of_b] = [a, b].map(|corner| (end - corner).cross(start - corner));
    let [x, y, z] = cell.places;
    ratios.clear();
    ratios.extend(x.iter().zip(y).zip(z).map(|((&x, &y), &z)| {
        let point = Vector::new(x, y, z);
        let (alpha, beta) = (of_a.dot(a - point), of_b.dot(b - point));
        alpha / (alpha - beta)
    }));
    let (from, along) = (a.coordinates(), (b - a).coordinates());
    for (axis, (column, places)) in columns.into_iter().zip(cell.places).enumerate() {
        let numbers = places.iter().zip(&*ratios);
        column
            .iter_mut()
            .zip(numbers)
            .for_each(|(at, (place, ratio))| *at = (from[axis] - place) + ratio * along[axis]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form_factor::form_factor_of_pieces;
    use crate::visibility::Face;

    /// The rectangle at this height that faces down.
    fn face(surface: usize, x: [f64; 2], y: [f64; 2], height: f64) -> Face {
        let corner = |x, y| Vector::new(x, y, height);
        let corners = [corner(x[0], y[0]), corner(x[0], y[1]), corner(x[1], y[1]), corner(x[1], y[0])];
        let [front, _] = Face::sides(surface, &corners, Vector::new(0.0, 0.0, -1.0));
        front
    }

    /// Returns the form factors of a lamp by contours and by pieces, and the number of available
    /// contours.
    fn both(screens: &Screens, lamp: &Face, points: &[Vector], outline: &[Vector]) -> ([Vec<f64>; 2], usize) {
        let (mut between, mut work, mut borders) = (Vec::new(), Workspace::default(), Borders::default());
        let luminaire = (lamp.vertices.as_slice(), lamp.normal);
        let _ = screens.between(outline, Some(UP), luminaire.0, luminaire.1, &mut between);
        let looking = Looking { points, outline, horizon: Some(UP), luminaire, screens: &between };
        let mut sums = vec![0.0; points.len()];
        screens.add_form_factors(looking, (UP, 1.0), (&mut work, &mut borders), &mut sums);
        let pieces = |&point: &Vector| {
            let pieces = screens.visible(point, Some(UP), luminaire.0, luminaire.1, &between, &mut work);
            form_factor_of_pieces(pieces, UP)
        };
        let by_pieces = points.iter().map(pieces).collect();
        ([sums, by_pieces], points.len() - borders.rest.len())
    }

    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    #[test]
    fn the_border_of_what_is_seen_sums_to_what_its_pieces_do() {
        let lamp = face(0, [-1.0, 1.0], [-1.0, 1.0], 2.0);
        for (name, plate) in [
            ("a plate that takes a corner", face(1, [0.0, 2.0], [0.1, 1.7], 1.1)),
            ("a plate inside", face(1, [-0.2, 0.3], [-0.1, 0.2], 0.9)),
            ("a strip across", face(1, [-3.0, 3.0], [-0.1, 0.2], 1.3)),
            ("a plate larger than the lamp", face(1, [-2.0, 1.9], [-3.0, 2.8], 1.5)),
        ] {
            let screens = Screens::of(&[lamp.clone(), plate]);
            let places =
                |i: u32, j: u32| Vector::new(0.117 * f64::from(i) - 2.3, 0.113 * f64::from(j) - 2.4, 0.0);
            let points: Vec<Vector> = (0..41 * 41).map(|index| places(index % 41, index / 41)).collect();
            let outline = [places(0, 0), places(40, 0), places(40, 40), places(0, 40)];
            let ([together, pieces], given) = both(&screens, &lamp, &points, &outline);
            assert!(given > points.len() * 9 / 10, "{name}: {given}");
            for ((&point, together), pieces) in points.iter().zip(together).zip(pieces) {
                let ([alone, _], _) = both(&screens, &lamp, &[point], &[point]);
                for border in [together, alone[0]] {
                    assert!((border - pieces).abs() < 1e-14, "{name}, {point:?}: {border} and {pieces}");
                }
            }
        }
    }

    #[test]
    fn where_a_shadow_has_an_edge_on_one_of_the_lamp_no_border_is_given() {
        let lamp = face(0, [-1.0, 1.0], [-1.0, 1.0], 2.0);
        let screens = Screens::of(&[lamp.clone(), face(1, [-0.5, 0.1], [-0.5, 0.5], 1.0)]);
        let here = [Vector::default()];
        let ([border, pieces], given) = both(&screens, &lamp, &here, &here);
        assert!(given == 0 && border == pieces && pieces[0] > 0.05, "{pieces:?}");
    }
}
