//! Subdivision: the bright faces of a scene become elements with one node each, none much larger than the others, and the place where a
//! ray meets a face becomes the element there.

use super::element::Element;
use super::system::reflects;
use crate::faces::is_bright;
use crate::geometry::{Face, Vector};
use crate::scene::Scene;

/// Elements are at most this part of the area of all, so that large faces are not taken for uniform.
const LARGEST: f64 = 1e-3;
/// The most parts along a side.
const MOST_PARTS: f64 = 256.0;

/// A piece of a face and its parts.
struct Piece {
    whole: Element,
    /// The parts along each side.
    parts: usize,
    /// The first of its elements.
    first: usize,
}

/// Elements by place.
pub(super) struct Subdivision {
    pub(super) elements: Vec<Element>,
    /// The pieces of all faces, face by face.
    pieces: Vec<Piece>,
    /// The first piece of each face, and at the end the count of all.
    first: Vec<usize>,
}

impl Subdivision {
    /// The elements of the faces that reflect or receive.
    pub(super) fn of(scene: &Scene, faces: &[Face], receives: &[bool]) -> Self {
        let counts =
            |face: &Face| is_bright(scene, face) && (receives[face.surface] || reflects(scene, face.surface));
        let whole: f64 = faces.iter().filter(|face| counts(face)).map(|face| face.area).sum();
        let mut subdivision = Self { elements: Vec::new(), pieces: Vec::new(), first: vec![0] };
        for (index, face) in faces.iter().enumerate() {
            if counts(face) {
                for piece in Element::of(index, face, &face.vertices) {
                    let parts =
                        (piece.area / (LARGEST * whole)).sqrt().ceil().clamp(1.0, MOST_PARTS) as usize;
                    let first = subdivision.elements.len();
                    subdivision.elements.extend(piece.parts(parts));
                    subdivision.pieces.push(Piece { whole: piece, parts, first });
                }
            }
            subdivision.first.push(subdivision.pieces.len());
        }
        subdivision
    }

    /// The element at a point of a face, if the face has any.
    pub(super) fn at(&self, face: usize, point: Vector) -> Option<usize> {
        let pieces = &self.pieces[self.first[face]..self.first[face + 1]];
        let piece = match pieces {
            [] => return None,
            [only] => only,
            _ => pieces.iter().find(|piece| piece.whole.contains(point)).unwrap_or(&pieces[0]),
        };
        Some(piece.first + piece.whole.part_of(piece.parts, point))
    }
}
