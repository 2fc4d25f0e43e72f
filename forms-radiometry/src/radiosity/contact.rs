//! Contacts: cuts faces where the irradiance jumps. It jumps where other faces touch or pass
//! through a face, and at the shadow border of a point or distant light. After the cuts no element
//! contains the jump, and for each side of a piece it is known whether another face rises from it.
//!
//! A cut divides a whole piece. If the contact covers only a small part of the cut, the piece is
//! halved first. A small contact on a large face is therefore surrounded by small pieces, and no
//! long and narrow pieces run across the face.

use crate::geometry::{Vector, split};
use crate::visibility::Face;

/// Above this number, faces are not compared with each other.
const MANY: usize = 2_000;
/// Minimum fraction of a cut through a piece that a contact has to cover.
const LEAST_SHARE: f64 = 0.35;
/// Maximum number of times that a piece is halved around a contact.
const MOST_HALVINGS: usize = 16;

/// Line that another face has in common with the plane of a face, or shadow border on the face.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contact {
    ends: [Vector; 2],
    /// Normal of the other face, or a normal to the shadow border.
    normal: Vector,
    /// Whether the other face rises above the plane, so that light passes between the two faces
    /// right up to the contact.
    rises: bool,
    /// Whether this is a shadow border: no piece is allowed to contain it, however small the piece
    /// is.
    is_shadow: bool,
}

/// A convex piece of a face that no other face cuts.
#[derive(Clone, Debug)]
pub(super) struct ConvexPiece {
    pub(super) outline: Vec<Vector>,
    /// For each side, from the corner of the same index to the next one: whether another face rises
    /// from it.
    pub(super) creases: Vec<bool>,
}

impl ConvexPiece {
    /// Returns a whole face as one piece, without regard to its contacts.
    #[cfg(test)]
    pub(super) fn whole(face: &Face) -> Self {
        Self { outline: face.vertices.to_vec(), creases: vec![false; face.vertices.len()] }
    }

    fn of(outline: Vec<Vector>, contacts: &[Contact], closeness: f64) -> Self {
        let next = outline.iter().cycle().skip(1);
        let is_crease = |side: [Vector; 2]| {
            contacts.iter().any(|contact| contact.rises && contact.takes(side, closeness))
        };
        let creases = outline.iter().zip(next).map(|(&from, &to)| is_crease([from, to])).collect();
        Self { outline, creases }
    }
}

/// Returns the convex pieces of each selected face, cut along its contacts with other faces and
/// along shadow borders.
pub(super) fn pieces(
    faces: &[Face],
    closeness: f64,
    is_wanted: impl Fn(&Face) -> bool,
    shadows: impl Fn(usize, &Face) -> Vec<Contact>,
) -> Vec<Vec<ConvexPiece>> {
    let cut = |(index, face): (usize, &Face)| {
        if !is_wanted(face) {
            return Vec::new();
        }
        let mut pieces = Vec::new();
        let others = faces.iter().filter(|other| faces.len() <= MANY && !other.is_back);
        let mut contacts: Vec<Contact> = others.filter_map(|other| contact(face, other, closeness)).collect();
        contacts.extend(shadows(index, face));
        divide(
            face.vertices.to_vec(),
            &contacts,
            [closeness, 0.5_f64.powi(MOST_HALVINGS as i32) * face.area],
            &mut pieces,
        );
        pieces.into_iter().map(|outline| ConvexPiece::of(outline, &contacts, closeness)).collect()
    };
    faces.iter().enumerate().map(cut).collect()
}

/// Appends the pieces that contacts cut a piece into. Pieces of less than the least area are not
/// halved.
fn divide(
    piece: Vec<Vector>,
    contacts: &[Contact],
    [closeness, least]: [f64; 2],
    pieces: &mut Vec<Vec<Vector>>,
) {
    let share = |contact: &Contact| Some((share(&piece, *contact, closeness)?, *contact));
    let inside: Vec<(f64, Contact)> = contacts.iter().filter_map(share).collect();
    let Some(&(share, contact)) = inside.iter().max_by(|one, other| one.0.total_cmp(&other.0)) else {
        pieces.push(piece);
        return;
    };
    let (mut front, mut behind) = (Vec::new(), Vec::new());
    let is_small = area(&piece).length() <= least;
    let (share, contact) = match inside.iter().find(|(_, contact)| is_small && contact.is_shadow) {
        Some(&(_, shadow)) => (1.0, shadow),
        None => (share, contact),
    };
    if share >= LEAST_SHARE {
        split(&piece, |v| contact.normal.dot(v - contact.ends[0]), &mut front, &mut behind);
    } else if !is_small {
        let [middle, across] = half(&piece);
        split(&piece, |v| across.dot(v - middle), &mut front, &mut behind);
    } else {
        pieces.push(piece);
        return;
    }
    let inside: Vec<Contact> = inside.into_iter().map(|(_, contact)| contact).collect();
    for part in [front, behind] {
        divide(part, &inside, [closeness, least], pieces);
    }
}

/// Returns the common line of another face and the plane of a face, if it is a line.
fn contact(face: &Face, other: &Face, closeness: f64) -> Option<Contact> {
    let origin = face.vertices[0];
    let height = |v: Vector| face.normal.dot(v - origin);
    let mut ends: Vec<Vector> = Vec::new();
    let (mut is_off, mut rises) = (false, false);
    for (i, &a) in other.vertices.iter().enumerate() {
        let b = other.vertices[(i + 1) % other.vertices.len()];
        let (from, to) = (height(a), height(b));
        is_off |= from.abs() > closeness;
        rises |= from > closeness;
        if from.abs() <= closeness {
            ends.push(a);
        } else if to.abs() > closeness && (from > 0.0) != (to > 0.0) {
            ends.push(a + (from / (from - to)) * (b - a));
        }
    }
    let (&first, &last) = (ends.first()?, ends.last()?);
    let is_line = is_off && (last - first).length() > closeness;
    is_line.then_some(Contact { ends: [first, last], normal: other.normal, rises, is_shadow: false })
}

impl Contact {
    /// Returns a shadow border on a face with this normal.
    pub(super) fn of_shadow(ends: [Vector; 2], normal: Vector) -> Option<Self> {
        let across = normal.cross(ends[1] - ends[0]).unit()?;
        Some(Self { ends, normal: across, rises: false, is_shadow: true })
    }

    /// Whether the contact covers most of a side.
    fn takes(&self, [from, to]: [Vector; 2], closeness: f64) -> bool {
        let Some(along) = (self.ends[1] - self.ends[0]).unit() else { return false };
        let way = |v: Vector| v - self.ends[0];
        let is_off = |v: Vector| (way(v) - along.dot(way(v)) * along).largest() > closeness;
        if is_off(from) || is_off(to) {
            return false;
        }
        let ordered = |[a, b]: [Vector; 2]| {
            let [a, b] = [along.dot(way(a)), along.dot(way(b))];
            [a.min(b), a.max(b)]
        };
        let ([low, high], [first, last]) = (ordered([from, to]), ordered(self.ends));
        high.min(last) - low.max(first) > 0.5 * (high - low)
    }
}

/// Returns the fraction of the cut through a piece along a contact that the contact covers, if it
/// lies inside the piece.
fn share(piece: &[Vector], Contact { ends: [from, to], normal, .. }: Contact, closeness: f64) -> Option<f64> {
    let side = |v: &Vector| normal.dot(*v - from);
    if !piece.iter().any(|v| side(v) > closeness) || !piece.iter().any(|v| side(v) < -closeness) {
        return None;
    }
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let facing = area(piece);
    for (i, &a) in piece.iter().enumerate() {
        let inwards = facing.cross(piece[(i + 1) % piece.len()] - a);
        let (at_from, at_to) = (inwards.dot(from - a), inwards.dot(to - a));
        let crossing = at_from / (at_from - at_to);
        if at_from < at_to {
            low = low.max(crossing);
        } else if at_from > at_to {
            high = high.min(crossing);
        } else if at_from < 0.0 {
            return None;
        }
    }
    let taken = high.min(1.0) - low.max(0.0);
    (taken * (to - from).length() > closeness).then(|| taken / (high - low))
}

/// Returns the area of a piece times its normal.
fn area(piece: &[Vector]) -> Vector {
    let about = piece[0];
    let twice = piece[1..]
        .windows(2)
        .fold(Vector::default(), |sum, pair| sum + (pair[0] - about).cross(pair[1] - about));
    0.5 * twice
}

/// Returns a point and a normal of the plane that halves a piece: through the middle of its longest
/// edge and the mean of its corners. The plane halves a triangle through a corner and a
/// parallelogram along its shorter edges.
fn half(piece: &[Vector]) -> [Vector; 2] {
    let next = piece.iter().cycle().skip(1);
    let edges = piece.iter().zip(next).map(|(&a, &b)| [0.5 * (a + b), b - a]);
    let longest = edges.max_by(|[_, one], [_, other]| one.dot(*one).total_cmp(&other.dot(*other)));
    let [middle, _] = longest.unwrap_or_default();
    let centre = piece.iter().fold(Vector::default(), |sum, &v| sum + (1.0 / piece.len() as f64) * v);
    [middle, area(piece).cross(centre - middle)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(vertices: Vec<Vector>) -> Face {
        let twice = (vertices[1] - vertices[0]).cross(vertices[2] - vertices[0]);
        let normal = twice.unit().expect("a polygon");
        Face { surface: 0, part: 0, is_back: false, vertices: vertices.into(), normal, area: twice.length() }
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
            face(vec![corner(0.5, low), corner(1.5, low), corner(1.5, 1.0), corner(0.5, 1.0)])
        };
        for (name, other, expected) in [
            ("a wall that stands on it", wall(0.5, 0.0), 2),
            ("a wall that goes through it", wall(0.5, -1.0), 2),
            ("a wall above it", wall(0.5, 0.2), 1),
            ("a wall at its border", wall(2.0, 0.0), 1),
            ("a wall beside it", wall(3.0, 0.0), 1),
        ] {
            let pieces = pieces(&[floor.clone(), other], 1e-9, |_| true, |_, _| Vec::new());
            assert_eq!(pieces[0].len(), expected, "{name}");
        }
    }

    #[test]
    fn a_side_is_a_crease_where_a_face_rises_from_most_of_it() {
        let corner = |x, y, z| Vector::new(x, y, z);
        let floor = face(vec![
            corner(0.0, 0.0, 0.0),
            corner(2.0, 0.0, 0.0),
            corner(2.0, 2.0, 0.0),
            corner(0.0, 2.0, 0.0),
        ]);
        let wall = |[low, high]: [f64; 2], top: f64| {
            face(vec![
                corner(2.0, low, 0.0),
                corner(2.0, high, 0.0),
                corner(2.0, high, top),
                corner(2.0, low, top),
            ])
        };
        for (name, other, expected) in [
            ("a wall along a side", wall([0.0, 2.0], 1.0), true),
            ("a wall along most of a side", wall([0.5, 2.0], 1.0), true),
            ("a wall along a small part", wall([1.5, 2.0], 1.0), false),
            ("a face that goes down from a side", wall([0.0, 2.0], -1.0), false),
        ] {
            let creases = &pieces(&[floor.clone(), other], 1e-9, |_| true, |_, _| Vec::new())[0][0].creases;
            assert_eq!(creases[..], [false, expected, false, false], "{name}");
        }
    }

    /// Returns the pieces of a floor of length 4 with other faces on it.
    fn floor_with(others: &[Face]) -> Vec<Vec<Vector>> {
        let corner = |x, y| Vector::new(x, y, 0.0);
        let floor = face(vec![corner(0.0, 0.0), corner(4.0, 0.0), corner(4.0, 4.0), corner(0.0, 4.0)]);
        let faces: Vec<Face> = std::iter::once(floor).chain(others.iter().cloned()).collect();
        pieces(&faces, 1e-9, |_| true, |_, _| Vec::new())
            .swap_remove(0)
            .into_iter()
            .map(|piece| piece.outline)
            .collect()
    }

    fn side([a, b]: [[f64; 2]; 2]) -> Face {
        let corner = |[x, y]: [f64; 2], z| Vector::new(x, y, z);
        face(vec![corner(a, 0.0), corner(b, 0.0), corner(b, 1.0), corner(a, 1.0)])
    }

    #[test]
    fn what_stands_in_a_small_place_is_cut_off_by_small_pieces() {
        let [low, high] = [1.3, 1.4];
        let corners = [[low, low], [high, low], [high, high], [low, high]];
        let leg: Vec<Face> = (0..4).map(|i| side([corners[i], corners[(i + 1) % 4]])).collect();
        let pieces = floor_with(&leg);
        let below = |piece: &&Vec<Vector>| {
            piece
                .iter()
                .all(|v| v.x >= low - 1e-9 && v.x <= high + 1e-9 && v.y >= low - 1e-9 && v.y <= high + 1e-9)
        };
        let area = |piece: &Vec<Vector>| area(piece).length();
        let of_leg: f64 = pieces.iter().filter(below).map(area).sum();
        assert!((of_leg - 0.01).abs() < 1e-12, "{of_leg} below the leg");
        let whole: f64 = pieces.iter().map(area).sum();
        assert!((whole - 16.0).abs() < 1e-12, "{whole} in all");
        let extent =
            |piece: &Vec<Vector>| piece.iter().map(|&v| (v - piece[0]).largest()).fold(0.0, f64::max);
        let longest = pieces.iter().map(|piece| extent(piece).powi(2) / area(piece)).fold(0.0, f64::max);
        assert!(longest < 16.0, "a piece is {longest} times as long as wide");
        assert!(pieces.len() < 40, "{} pieces", pieces.len());
    }

    #[test]
    fn a_contact_too_small_to_matter_ends_the_halving() {
        assert!(floor_with(&[side([[1.0, 1.0], [1.0 + 1e-6, 1.0]])]).len() <= 2 * MOST_HALVINGS);
    }
}
