//! Subdivision: divides the bright faces of a scene into elements, none much larger than the
//! others. Elements have a node each, or several share one. The position where a ray hits a face
//! gives the element there.

use super::clusters::clusters;
use super::contact::ConvexPiece;
use super::element::Element;
use super::reflectance::reflects;
use crate::faces::is_bright;
use crate::geometry::Vector;
use crate::scene::Scene;
use crate::visibility::Face;

/// Maximum area of an element as a fraction of the total area, so that large faces are not treated
/// as uniform.
const LARGEST: f64 = 1e-3;
/// Maximum number of parts along a side.
const MOST_PARTS: f64 = 256.0;

/// A piece of a face and its parts.
struct Piece {
    whole: Element,
    /// Number of parts along each side.
    parts: usize,
    /// The first of its elements.
    first: usize,
}

/// Elements by position.
pub(super) struct Subdivision {
    pub(super) elements: Vec<Element>,
    /// The node that gives each element its rough irradiance.
    pub(super) node_of: Vec<u32>,
    /// The element at whose centre each node lies.
    pub(super) nodes: Vec<u32>,
    /// The pieces of all faces, face by face.
    pieces: Vec<Piece>,
    /// The first piece of each face, and at the end the number of all pieces.
    first: Vec<usize>,
}

impl Subdivision {
    /// Creates the elements of the faces that reflect or receive, with about this number of nodes
    /// at most.
    pub(super) fn of(scene: &Scene, faces: &[Face], receives: &[bool], most_nodes: usize) -> Self {
        let counts =
            |face: &Face| is_bright(scene, face) && (receives[face.surface] || reflects(scene, face.surface));
        let whole: f64 = faces.iter().filter(|face| counts(face)).map(|face| face.area).sum();
        let mut subdivision = Self {
            elements: Vec::new(),
            node_of: Vec::new(),
            nodes: Vec::new(),
            pieces: Vec::new(),
            first: vec![0],
        };
        for (index, face) in faces.iter().enumerate() {
            if counts(face) {
                for piece in Element::of(index, face, &ConvexPiece::whole(face)) {
                    let parts =
                        (piece.area / (LARGEST * whole)).sqrt().ceil().clamp(1.0, MOST_PARTS) as usize;
                    let first = subdivision.elements.len();
                    subdivision.elements.extend(piece.parts(parts));
                    subdivision.pieces.push(Piece { whole: piece, parts, first });
                }
            }
            subdivision.first.push(subdivision.pieces.len());
        }
        let material = |element: &Element| scene.surfaces[faces[element.face].surface].material;
        (subdivision.node_of, subdivision.nodes) = clusters(&subdivision.elements, material, most_nodes);
        subdivision
    }

    /// Returns the element at a point of a face, if the face has any.
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
