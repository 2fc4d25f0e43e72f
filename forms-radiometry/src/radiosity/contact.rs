//! Contacts: where faces touch or pass through a face, irradiance on it jumps; there it is cut, so that no element has the jump
//! inside.

use crate::geometry::{Face, Vector, split};

/// Faces of more than this many are not compared with each other.
const MANY: usize = 2_000;

/// The convex pieces of each face that the others leave uncut.
pub(super) fn pieces(faces: &[Face], resolution: f64) -> Vec<Vec<Vec<Vector>>> {
    let cut = |face: &Face| {
        let mut pieces = vec![face.vertices.clone()];
        if faces.len() <= MANY {
            for other in faces.iter().filter(|other| !other.is_back) {
                if let Some(contact) = contact(face, other, resolution) {
                    pieces = pieces
                        .into_iter()
                        .flat_map(|piece| cut_by(piece, contact, other, resolution))
                        .collect();
                }
            }
        }
        pieces
    };
    faces.iter().map(cut).collect()
}

/// The two ends of what another face has in common with the plane of a face, if that is a line.
fn contact(face: &Face, other: &Face, resolution: f64) -> Option<[Vector; 2]> {
    let origin = face.vertices[0];
    let height = |v: Vector| face.normal.dot(v - origin);
    let mut ends: Vec<Vector> = Vec::new();
    let mut is_off = false;
    for (i, &a) in other.vertices.iter().enumerate() {
        let b = other.vertices[(i + 1) % other.vertices.len()];
        let (from, to) = (height(a), height(b));
        is_off |= from.abs() > resolution;
        if from.abs() <= resolution {
            ends.push(a);
        } else if to.abs() > resolution && (from > 0.0) != (to > 0.0) {
            ends.push(a + (from / (from - to)) * (b - a));
        }
    }
    let (&first, &last) = (ends.first()?, ends.last()?);
    (is_off && (last - first).length() > resolution).then_some([first, last])
}

/// The two parts of a piece, if a contact passes through it.
fn cut_by(piece: Vec<Vector>, [from, to]: [Vector; 2], other: &Face, resolution: f64) -> Vec<Vec<Vector>> {
    let (mut low, mut high) = (0.0_f64, 1.0_f64);
    let normal = piece[1..]
        .windows(2)
        .fold(Vector::default(), |sum, pair| sum + (pair[0] - piece[0]).cross(pair[1] - piece[0]));
    for (i, &a) in piece.iter().enumerate() {
        let inwards = normal.cross(piece[(i + 1) % piece.len()] - a);
        let (at_from, at_to) = (inwards.dot(from - a), inwards.dot(to - a));
        if at_from < 0.0 && at_to < 0.0 {
            return vec![piece];
        }
        let crossing = at_from / (at_from - at_to);
        if at_from < 0.0 {
            low = low.max(crossing);
        } else if at_to < 0.0 {
            high = high.min(crossing);
        }
    }
    if (high - low) * (to - from).length() <= resolution {
        return vec![piece];
    }
    let side = |v: Vector| other.normal.dot(v - from);
    let parts = piece.iter().any(|&v| side(v) > resolution) && piece.iter().any(|&v| side(v) < -resolution);
    if !parts {
        return vec![piece];
    }
    let (mut front, mut behind) = (Vec::new(), Vec::new());
    split(&piece, side, &mut front, &mut behind);
    vec![front, behind]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(vertices: Vec<Vector>) -> Face {
        let twice = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]);
        let normal = twice.unit().expect("a polygon");
        Face { surface: 0, is_back: false, vertices, normal, area: twice.length() }
    }

    #[test]
    fn a_floor_is_cut_where_a_wall_stands_on_it_and_nowhere_else() {
        let floor = face(vec![
            Vector::new(0.0, 0.0, 0.0),
            Vector::new(2.0, 0.0, 0.0),
            Vector::new(2.0, 2.0, 0.0),
            Vector::new(0.0, 2.0, 0.0),
        ]);
        let wall = |x: f64, low: f64| {
            let corner = |y, z| Vector::new(x, y, z);
            face(vec![corner(0.5, low), corner(1.0, low), corner(1.0, 1.0), corner(0.5, 1.0)])
        };
        for (name, other, expected) in [
            ("a wall that stands on it", wall(0.5, 0.0), 2),
            ("a wall that goes through it", wall(0.5, -1.0), 2),
            ("a wall above it", wall(0.5, 0.2), 1),
            ("a wall at its border", wall(2.0, 0.0), 1),
            ("a wall beside it", wall(3.0, 0.0), 1),
        ] {
            let pieces = pieces(&[floor.clone(), other], 1e-9);
            assert_eq!(pieces[0].len(), expected, "{name}");
        }
    }
}
