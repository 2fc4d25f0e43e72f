//! Beams: computes the lit part of a face under light from a point or a direction, with occluders.
//!
//! ```text
//! face ─ every screen before it casts a prism or a cone of shadow ─▶ convex lit pieces
//! convex lit pieces ─▶ the border of the shadow
//! ```
//! A shadow is bounded by the planes through an edge of a screen and the rays through that edge.
//! Two screens with a common edge share its plane to the last bit, so no light slips between them.
//! A screen that the beam grazes casts no shadow.

use super::Between;
use super::{Screen, Screens};
use crate::geometry::clip::{split, split_along};
use crate::geometry::{Plane, Vector, edges};

/// Rounding error of a distance from a plane, relative to the largest distance in its face.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// The largest number of pieces of the lit part of a face. A face with more is not cut.
const MOST_PIECES: usize = 1 << 12;

/// Distance, in extents of the scene, at which a distant source is behind everything.
const BEYOND: f64 = 4.0;

/// Light from a source without extent.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Beam {
    /// Light from a point.
    From(Vector),
    /// Parallel light from far away, along this unit vector.
    Along(Vector),
}

/// The lit part of a face.
#[derive(Clone, Debug, Default)]
pub(crate) struct Lit {
    /// Convex pieces, counter-clockwise seen from the front of the face.
    pub(crate) pieces: Vec<Vec<Vector>>,
    /// Whether the lit part is all of the face, or none of it.
    pub(crate) is_whole: bool,
}

impl Beam {
    /// Returns the plane of the rays through an edge of a screen. The reversed edge has the same
    /// plane with the opposite normal.
    fn plane_through(self, [a, b]: [Vector; 2]) -> Plane {
        match self {
            Self::From(source) => Plane { point: source, normal: (a - source).cross(b - source) },
            Self::Along(direction) => {
                let is_first = a.coordinates() < b.coordinates();
                Plane { point: if is_first { a } else { b }, normal: direction.cross(b - a) }
            }
        }
    }

    /// Whether the source is on the side to which a plane's normal points.
    fn comes_from_above(self, plane: Plane, resolution: f64) -> bool {
        match self {
            Self::From(source) => plane.distance(source) > resolution,
            Self::Along(direction) => plane.normal.dot(direction) < 0.0,
        }
    }

    /// Returns the height of the source over a plane. For a distant source, this is the sine of its
    /// elevation times the extent of the scene.
    fn height_above(self, plane: Plane, extent: f64) -> f64 {
        match self {
            Self::From(source) => plane.distance(source),
            Self::Along(direction) => -plane.normal.dot(direction) * extent,
        }
    }
}

impl Screens {
    /// Returns the part of a face that a beam reaches; `None` where it has too many pieces.
    pub(crate) fn lit(&self, (outline, normal): (&[Vector], Vector), beam: Beam) -> Option<Lit> {
        let face = Plane { point: outline[0], normal };
        let extent = if self.screens.is_empty() { 0.0 } else { self.tree.bounds().extent() };
        let dark = Lit { pieces: Vec::new(), is_whole: true };
        if !beam.comes_from_above(face, self.resolution) {
            return Some(dark);
        }
        let mut between = Vec::new();
        let found = match beam {
            Beam::From(source) => self.between(&[source], None, outline, normal, &mut between),
            Beam::Along(direction) => {
                let away = BEYOND * extent * direction;
                let source: Vec<Vector> = outline.iter().rev().map(|&corner| corner - away).collect();
                self.between(outline, Some(normal), &source, -normal, &mut between)
            }
        };
        if found == Between::All {
            return Some(dark);
        }
        let mut pieces = vec![outline.to_vec()];
        let mut is_whole = true;
        for &screen in between.iter().flat_map(|index| self.screens_of(index)) {
            let shadow = self.shadow(&self.screens[screen as usize], beam, face, extent);
            if shadow.is_empty() {
                continue;
            }
            let mut rest = Vec::with_capacity(pieces.len());
            for piece in pieces {
                is_whole &= !cut_from(piece, &shadow, &mut rest);
            }
            pieces = rest;
            if pieces.len() > MOST_PIECES {
                return None;
            }
        }
        Some(Lit { is_whole: is_whole || pieces.is_empty(), pieces })
    }

    /// Returns the planes, with inward normals, of the shadow cast by the part of a screen that is
    /// between the beam's source and a face.
    fn shadow(&self, screen: &Screen, beam: Beam, face: Plane, extent: f64) -> Vec<Plane> {
        let above = beam.height_above(screen.plane, extent);
        if above.abs() <= self.resolution {
            return Vec::new();
        }
        let (mut outline, mut rest) = (Vec::new(), Vec::new());
        let highest = screen.vertices.iter().map(|&v| face.distance(v)).fold(f64::NEG_INFINITY, f64::max);
        if highest <= self.resolution {
            return Vec::new();
        }
        split(&screen.vertices, |v| face.distance(v), &mut outline, &mut rest);
        if let Beam::From(source) = beam {
            let height = face.distance(source);
            let whole = std::mem::take(&mut outline);
            split(&whole, |v| height - face.distance(v), &mut outline, &mut rest);
        }
        let inwards = |[a, b]: [Vector; 2]| beam.plane_through(if above > 0.0 { [b, a] } else { [a, b] });
        edges(&outline).map(inwards).collect()
    }
}

/// Appends the convex pieces of a piece that are outside a shadow. Returns whether the shadow
/// covers any part of it.
fn cut_from(piece: Vec<Vector>, shadow: &[Plane], rest: &mut Vec<Vec<Vector>>) -> bool {
    let reach = piece.iter().map(|&v| (v - piece[0]).largest()).fold(0.0, f64::max);
    let rounding = |plane: &Plane| {
        let away = (piece[0] - plane.point).largest();
        ROUNDING * plane.normal.largest() * (reach + away)
    };
    let is_beyond = |plane: &Plane| piece.iter().all(|&v| plane.distance(v) <= rounding(plane));
    if shadow.iter().any(is_beyond) {
        rest.push(piece);
        return false;
    }
    let sides = shadow.iter().map(|plane| (|v: Vector| plane.distance(v), rounding(plane)));
    let (beyond, inside) = split_along(&piece, sides);
    if inside.is_empty() {
        rest.push(piece);
        return false;
    }
    rest.extend(beyond);
    true
}

impl Lit {
    /// Returns the lit part without occluders: all of a face if the beam comes from its front,
    /// otherwise nothing.
    pub(crate) fn unhidden((outline, normal): (&[Vector], Vector), beam: Beam, resolution: f64) -> Self {
        let is_lit = beam.comes_from_above(Plane { point: outline[0], normal }, resolution);
        Self { pieces: if is_lit { vec![outline.to_vec()] } else { Vec::new() }, is_whole: true }
    }

    /// Returns the segments of the shadow's border inside the face, with the lit part on their
    /// left. They are the edges of the lit pieces, minus the edges that are shared with other
    /// pieces or with the face.
    pub(crate) fn border(&self, outline: &[Vector], closeness: f64) -> Vec<[Vector; 2]> {
        if self.is_whole {
            return Vec::new();
        }
        let own = || self.pieces.iter().flat_map(|piece| edges(piece));
        let against: Vec<[Vector; 2]> = own().chain(edges(outline).map(|[a, b]| [b, a])).collect();
        own().flat_map(|side| uncovered(side, &against, closeness)).collect()
    }
}

/// Returns the parts of a segment that are not covered by any of the other segments in the opposite
/// direction.
fn uncovered([a, b]: [Vector; 2], others: &[[Vector; 2]], closeness: f64) -> Vec<[Vector; 2]> {
    let length = (b - a).length();
    let Some(along) = (b - a).unit().filter(|_| length > closeness) else { return Vec::new() };
    let off = |v: Vector| {
        let way = v - a;
        (way - along.dot(way) * along).largest()
    };
    let mut open = vec![[0.0, length]];
    for &[from, to] in others {
        let [low, high] = [along.dot(to - a), along.dot(from - a)];
        if high - low <= 0.0 || high <= 0.0 || low >= length || off(from) > closeness || off(to) > closeness {
            continue;
        }
        let parts = open.iter().flat_map(|&[start, end]| [[start, end.min(low)], [start.max(high), end]]);
        open = parts.filter(|[start, end]| end - start > closeness).collect();
    }
    open.into_iter().map(|ends| ends.map(|place| a + place * along)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::visibility::Face;

    fn corner([x, y, z]: [f64; 3]) -> Vector {
        Vector::new(x, y, z)
    }

    /// A horizontal rectangle that faces up, at a height.
    fn level([low, high]: [[f64; 2]; 2], z: f64) -> Vec<Vector> {
        [[low[0], low[1]], [high[0], low[1]], [high[0], high[1]], [low[0], high[1]]]
            .map(|[x, y]| corner([x, y, z]))
            .to_vec()
    }

    fn sides(surface: usize, outline: &[Vector]) -> [Face; 2] {
        let normal = (outline[1] - outline[0]).cross(outline[2] - outline[0]).unit().expect("a polygon");
        Face::sides(surface, outline, normal)
    }

    fn area(lit: &Lit) -> f64 {
        let of_piece = |piece: &Vec<Vector>| {
            let twice = piece[1..].windows(2).map(|v| (v[0] - piece[0]).cross(v[1] - piece[0]).z);
            0.5 * twice.sum::<f64>()
        };
        lit.pieces.iter().map(of_piece).sum()
    }

    /// Returns the lit part of a ground of 10 × 10 below some outlines.
    fn ground(screens: &[Vec<Vector>], beam: Beam) -> (Lit, Vec<Vector>) {
        let outline = level([[-5.0; 2], [5.0; 2]], 0.0);
        let mut faces = sides(0, &outline).to_vec();
        faces.extend(screens.iter().enumerate().flat_map(|(i, screen)| sides(i + 1, screen)));
        let lit = Screens::of(&faces).lit((&outline, faces[0].normal), beam).expect("few pieces");
        (lit, outline)
    }

    fn box_of([low, high]: [[f64; 3]; 2]) -> Vec<Vec<Vector>> {
        let at =
            |i: usize| corner([0, 1, 2].map(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] }));
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
            .map(|face| face.map(at).to_vec())
            .to_vec()
    }

    #[test]
    fn the_lit_area_is_that_of_the_ground_without_the_shadows() {
        let plate = |z| level([[-1.0; 2], [1.0; 2]], z);
        let down = Vector::new(0.0, 0.0, -1.0);
        let aslant = Vector::new(0.6, 0.0, -0.8);
        let upright = vec![
            corner([0.0, -1.0, 0.0]),
            corner([0.0, 1.0, 0.0]),
            corner([0.0, 1.0, 2.0]),
            corner([0.0, -1.0, 2.0]),
        ];
        let lamp = Vector::new(0.0, 0.0, 4.0);
        let cases: [(&str, Vec<Vec<Vector>>, Beam, f64); 13] = [
            ("nothing above", vec![], Beam::Along(down), 100.0),
            ("a plate", vec![plate(1.5)], Beam::Along(down), 96.0),
            ("a plate, aslant", vec![plate(1.5)], Beam::Along(aslant), 96.0),
            ("two plates above each other", vec![plate(1.5), plate(2.5)], Beam::Along(down), 96.0),
            ("two plates, aslant", vec![plate(1.0), plate(2.0)], Beam::Along(aslant), 94.5),
            ("a plate below", vec![plate(-1.0)], Beam::Along(down), 100.0),
            ("a plate on the ground", vec![plate(0.0)], Beam::Along(down), 100.0),
            ("edge-on", vec![upright.clone()], Beam::Along(down), 100.0),
            ("a wall", vec![upright], Beam::Along(aslant), 97.0),
            ("a box", box_of([[-1.0, -1.0, 1.0], [1.0, 1.0, 2.0]]), Beam::Along(aslant), 94.5),
            ("a box on the ground", box_of([[-1.0, -1.0, 0.0], [1.0, 1.0, 1.0]]), Beam::Along(aslant), 94.5),
            ("a plate half way to a lamp", vec![plate(2.0)], Beam::From(lamp), 84.0),
            ("a plate above a lamp", vec![plate(5.0)], Beam::From(lamp), 100.0),
        ];
        for (name, screens, beam, expected) in cases {
            let (lit, _) = ground(&screens, beam);
            assert!((area(&lit) - expected).abs() < 1e-12, "{name}: {}", area(&lit));
        }
    }

    #[test]
    fn a_roof_above_all_of_it_leaves_nothing() {
        let (lit, _) = ground(&[level([[-9.0; 2], [9.0; 2]], 1.0)], Beam::Along(Vector::new(0.0, 0.0, -1.0)));
        assert!(lit.pieces.is_empty() && lit.is_whole);
        let (lit, _) = ground(&[], Beam::Along(Vector::new(0.0, 0.0, 1.0)));
        assert!(lit.pieces.is_empty() && lit.is_whole);
    }

    #[test]
    fn a_screen_that_reaches_above_a_lamp_shades_what_it_has_behind_it() {
        // a wall at x = 1 from the ground to above the lamp: all beyond it is dark
        let wall = vec![
            corner([1.0, -9.0, 0.0]),
            corner([1.0, 9.0, 0.0]),
            corner([1.0, 9.0, 8.0]),
            corner([1.0, -9.0, 8.0]),
        ];
        let (lit, _) = ground(&[wall], Beam::From(Vector::new(0.0, 0.0, 4.0)));
        assert!((area(&lit) - 60.0).abs() < 1e-12, "{}", area(&lit));
    }

    #[test]
    fn the_border_of_a_shadow_is_that_of_the_screen_and_not_of_the_pieces() {
        let plate = level([[-1.0; 2], [1.0; 2]], 1.5);
        let halves = vec![level([[-1.0; 2], [0.0, 1.0]], 1.5), level([[0.0, -1.0], [1.0; 2]], 1.5)];
        for (name, screens) in [("a plate", vec![plate]), ("two halves", halves)] {
            let (lit, outline) = ground(&screens, Beam::Along(Vector::new(0.0, 0.0, -1.0)));
            let border = lit.border(&outline, 1e-9);
            let length: f64 = border.iter().map(|&[a, b]| (b - a).length()).sum();
            assert!((length - 8.0).abs() < 1e-9, "{name}: {length} {border:?}");
        }
        // a shadow that leaves the ground: its border ends there
        let (lit, outline) =
            ground(&[level([[4.0, -1.0], [9.0, 1.0]], 1.0)], Beam::Along(Vector::new(0.0, 0.0, -1.0)));
        let length: f64 = lit.border(&outline, 1e-9).iter().map(|&[a, b]| (b - a).length()).sum();
        assert!((length - 4.0).abs() < 1e-9, "{length}");
    }
}
