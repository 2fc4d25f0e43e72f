//! Coarsest elements: the faces of a scene become the elements before any is split, whose order
//! depends on their number.

use super::contact;
use super::element::{Element, HIGHEST_ORDER};
use super::question::Question;
use super::reflectance::is_reflecting;
use super::shadows::Shadows;
use super::transport::Transport;
use crate::geometry::closeness;
use crate::scene::Scene;
use crate::visibility::Face;

/// Maximum number of nodes: the matrix of more does not fit into the memory of a small machine.
pub(super) const MOST_NODES: usize = 12_000;

/// Reduced orders of elements, each for more than this number of nodes before any is split: linear
/// polynomials as soon as each element could not be split once, constants only where there is
/// hardly room for anything else, because they converge slowly.
const MOST_OF_ORDERS: [(usize, usize); 2] = [(2, MOST_NODES / 8), (1, MOST_NODES / 2)];

/// Polynomials on the faces of disks and spheres have degrees below this.
const ORDER_ON_ROUND: usize = 2;

/// Returns the order of the elements before any is split, by the number of nodes that they have
/// with each order.
fn first_order(nodes: impl Fn(usize) -> usize) -> usize {
    let lower = |order, (lower, most)| if nodes(order) > most { lower } else { order };
    MOST_OF_ORDERS.into_iter().fold(HIGHEST_ORDER, lower)
}

/// Returns the elements before any is split: of all faces that reflect light, or whose mean is
/// requested and is not an integral alone: the direct light of a face whose mean is requested
/// `is_summed` over its nodes, or not.
pub(super) fn coarsest(
    scene: &Scene,
    transport: &Transport,
    question: &Question,
    is_summed: &dyn Fn(&Face) -> bool,
    shadows: &Shadows,
) -> Vec<Element> {
    let reflected = question.orders != Some(0);
    let has_elements = |face: &Face| {
        let is_source = reflected && is_reflecting(scene, face);
        is_source || question.receives.have(face) && (reflected || is_summed(face))
    };
    let mut elements = Vec::new();
    let corners = transport.faces.iter().flat_map(|face| &face.vertices).copied();
    let closeness = closeness(corners);
    let borders = |index: usize, face: &Face| {
        let is_cut = reflected && !scene.surfaces[face.surface].shape.is_round();
        if is_cut { shadows.borders(index, face, closeness) } else { Vec::new() }
    };
    let pieces = contact::pieces(&transport.faces, closeness, has_elements, borders);
    for (index, (face, pieces)) in transport.faces.iter().zip(pieces).enumerate() {
        elements.extend(pieces.iter().flat_map(|piece| Element::of(index, face, piece)));
    }
    // the faces of a polyhedron are as small as its shape requires: linear polynomials on them are
    // as accurate as the shape
    let is_round_face =
        |element: &&mut Element| scene.surfaces[transport.faces[element.face].surface].shape.is_round();
    elements.iter_mut().filter(is_round_face).for_each(|element| element.order = ORDER_ON_ROUND);
    let nodes = |order| elements.iter().map(|element| element.count_with(order)).sum();
    let order = first_order(nodes);
    elements.iter_mut().for_each(|element| element.order = element.order.min(order));
    elements
}
