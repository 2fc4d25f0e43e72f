//! Expected cost of radiosity: what a solution to the tolerance costs, before there is one.
//!
//! ```text
//! reflected light   v s (n (1 + k²) + c k)     n nodes, k times as many at the end, s reflecting faces
//! direct light      v l (p + c + n k) + e l f  l bright faces, p points, c cells, f receiving faces
//! ```
//! The unit is the cost of a ray: an exact view of a face costs v rays, an integral over a pair of
//! faces e rays. Among surfaces that occlude each other, the error of the first elements is about
//! 1, and errors fall with the third power of the size of elements. These are split along the
//! borders of shadows only, so that their number grows with the inverse of their size: k =
//! (1/ε)^(1/3) for the tolerance ε. Without occlusion, the polynomials of second degree have an
//! error of 1/10 at first, which falls with the third power of the area: k = (1/10ε)^(1/3). Below a
//! near point light, the first error is larger by the height of the peak. Elements that occlude each other, and
//! that cannot be split once within the maximum number of nodes, give no error estimate: their cost
//! is infinite.

use super::brightest::highest_peak;
use super::coarsest_elements::{MOST_NODES, coarsest};
use super::direct::{kinds, sources};
use super::driver::{FINEST, readings::Reading};
use super::element::Element;
use super::question::Question;
use super::reflectance::is_reflecting;
use super::shadows::Shadows;
use super::transport::Transport;
use crate::effects::Hiding;
use crate::faces::{faces, is_bright, is_round};
use crate::scene::{ReceiverKind, Scene};
use crate::visibility::{Face, Screens};
use crate::watch::Unwatched;

/// Cost of an exact view of a face, and of the light exchanged by two faces, in rays.
const VIEW: f64 = 16.0;
const EXCHANGE: f64 = 4.0;
/// Error of the first elements among surfaces that occlude each other, and without occlusion.
const HIDDEN: f64 = 1.0;
const FREE: f64 = 0.1;
/// Minimum number of parts that an element is split into.
const PARTS: f64 = 4.0;
/// Error of the second polyhedra of curved shapes; that of each further one is a quarter.
const SHAPE: f64 = 1e-2;

/// Returns the expected cost of the solution of a scene, in rays. It is infinite if there would be
/// too many nodes.
pub(crate) fn expected_cost(scene: &Scene, question: &Question, hiding: Hiding) -> f64 {
    let finest = if is_round(scene) { finest(scene.solve.tolerance) } else { 0 };
    (0..=finest).map(|fineness| of_faces(scene, faces(scene, fineness), question, hiding)).sum()
}

/// Returns the tessellation level at which curved shapes are expected to meet the tolerance.
fn finest(tolerance: f64) -> usize {
    let levels = (SHAPE / tolerance).log(4.0).ceil().max(0.0);
    FINEST.min(1 + levels as usize)
}

/// Returns the expected cost of the solution with these faces.
fn of_faces(scene: &Scene, faces: Vec<Face>, question: &Question, hiding: Hiding) -> f64 {
    let is_hidden = hiding == Hiding::Simulated;
    let kinds = kinds(scene, &faces);
    let count = |is: &dyn Fn(&&Face) -> bool| faces.iter().filter(is).count();
    let reflecting = if question.orders == Some(0) { 0 } else { count(&|face| is_reflecting(scene, face)) };
    let receiving = count(&|face| question.receives[face.surface] && !face.is_back);
    let lit =
        sources(scene, &faces, kinds).into_iter().filter(|&face| is_bright(scene, &faces[face])).count();
    let is_beyond = |nodes: usize| is_hidden && PARTS * nodes as f64 > MOST_NODES as f64;
    // without light from outside, the direct light of a surface is an integral
    if is_beyond(reflecting.max(if kinds.surroundings { receiving } else { 0 })) {
        return f64::INFINITY;
    }
    let screens = if is_hidden { Screens::of(&faces) } else { Screens::none(&faces) };
    let transport = Transport { faces, screens, occlusion: is_hidden, accuracy: 1.0 };
    let nodes = coarsest_nodes(scene, &transport, question, !kinds.surroundings);
    if is_beyond(nodes) {
        return f64::INFINITY;
    }
    let (points, cells) = requested_values(scene);
    let [nodes, points, cells] = [nodes, points, cells].map(|count| count as f64);
    let [reflecting, receiving, lit] = [reflecting, receiving, lit].map(|count| count as f64);
    let first_error = if is_hidden { HIDDEN } else { FREE } * highest_peak(scene, &transport);
    let finer = (first_error / scene.solve.tolerance).cbrt().min(MOST_NODES as f64 / nodes).max(1.0);
    let reflected = VIEW * reflecting * (nodes * (1.0 + finer * finer) + cells * finer);
    let direct = lit * (VIEW * (points + cells + nodes * finer) + EXCHANGE * receiving);
    reflected + direct
}

/// Returns the number of nodes before any element is split. Faces are cut where others touch them
/// and along shadow borders. `is_integral` tells whether the direct light of a surface is an
/// integral.
fn coarsest_nodes(scene: &Scene, transport: &Transport, question: &Question, is_integral: bool) -> usize {
    let shadows = Shadows::on(scene, transport, question, &Unwatched);
    let are_integrals = vec![is_integral; scene.surfaces.len()];
    coarsest(scene, transport, question, &are_integrals, &shadows).iter().map(Element::count).sum()
}

/// Returns the number of readings at points that a scene asks for, and the number of cells of maps.
fn requested_values(scene: &Scene) -> (usize, usize) {
    let (mut points, mut cells) = (0, 0);
    for (index, receiver) in scene.receivers.iter().enumerate() {
        match receiver.kind {
            ReceiverKind::Surface { grid, .. } => cells += grid.map_or(0, |[columns, rows]| columns * rows),
            ReceiverKind::Point { .. } | ReceiverKind::Ray { .. } | ReceiverKind::Sphere { .. } => {
                points += Reading::of(index, receiver).len();
            }
            ReceiverKind::Camera(_) => {}
        }
    }
    (points, cells)
}
