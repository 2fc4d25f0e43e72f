//! How light is gathered: by exact pieces of all elements, or by rays, whichever is expected to take less.
//!
//! ```text
//! pieces   v s (n (1 + k²) + c k)          n nodes, s elements that reflect; k times as many of both at the end
//! rays     32 m + 16 (r + c) (t σ/ε)²      m elements, r readings, c cells of maps, t of Student, σ the deviation of a path
//! ```
//! in rays, with the tolerance ε: the exact view of an element takes as long as v of them. Among surfaces that hide each other the first
//! elements are exact to about 1, and errors fall like the power 3/2 of the area of elements: k = (1/ε)^(2/3). Where nothing is hidden,
//! pieces are as exact as polynomials of second degree, whose integrals are off by 1/10 at first and by the third power of the area:
//! k = (1/10ε)^(1/3). The cost of pieces is that of pairs, and ends where memory does; that of rays hardly depends on the surfaces. What a
//! path deviates by is hardly known before: so rays are given up when it is seen that they take longer than pieces would. Pieces that
//! hide each other and could not be split once within the most nodes could not tell their error: then rays it is, however long they take.
//!
//! Rays always meet what stands in between. So where something does and is not to be simulated, there are none; nor where nothing is hidden
//! or reflected, and all light has closed forms; nor where there are images.

use super::paths::{RAYS, VIEW};
use super::probe::{FEWEST_PATHS, PATH, STUDENT};
use super::reference::{Shape, reference};
use super::system::{MOST_NODES, Question, first_order, is_reflecting};
use crate::geometry::Face;
use crate::scene::{ReceiverKind, Scene};

/// The deviation of what a path finds, relative to a reading: typical where a third of the light is reflected.
const DEVIATION: f64 = 0.2;
/// The fewest nodes that a rough solution is not too rough with, and the most.
const FEWEST_NODES: usize = 4_096;
const MOST_ROUGH_NODES: usize = 1 << 20;
/// The error of the first elements, and the power of their number by which it falls: among surfaces that hide each other, and where
/// nothing is hidden.
const HIDDEN: [f64; 2] = [1.0, 1.5];
const FREE: [f64; 2] = [0.1, 3.0];
/// Into how many parts elements are split at least.
const PARTS: f64 = 4.0;

/// How light is gathered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Gathering {
    /// By the exact pieces that points see of all elements.
    Pieces,
    /// By rays, and by paths for what these leave out, as long as no more than so many rays are needed.
    Rays { most: f64 },
}

/// What surfaces hide.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hiding {
    /// They may hide each other, and that is simulated.
    Simulated,
    /// They may hide each other, and that is left out.
    LeftOut,
    /// Nothing stands in between.
    Nothing,
}

impl Gathering {
    /// How light is gathered in a scene with these faces.
    pub(crate) fn of(scene: &Scene, faces: &[Face], question: &Question, hiding: Hiding) -> Self {
        let is_straight = hiding == Hiding::Nothing && question.orders == Some(0);
        if is_straight || hiding == Hiding::LeftOut || asks_for_images(scene) {
            return Self::Pieces;
        }
        let is_hidden = hiding == Hiding::Simulated;
        let [first_error, power] = if is_hidden { HIDDEN } else { FREE };
        let sources = sources(scene, faces);
        let nodes = coarsest_nodes(sources) as f64;
        let (readings, cells) = asked(scene);
        let paths = paths(scene, readings + cells);
        let finer =
            (first_error / scene.solve.tolerance).powf(1.0 / power).min(MOST_NODES as f64 / nodes).max(1.0);
        let views = nodes * (1.0 + finer * finer) + cells as f64 * finer;
        let by_pieces = VIEW * sources as f64 * views;
        let by_rays = f64::from(RAYS) * sources as f64 + PATH * paths;
        let is_beyond_pieces = is_hidden && PARTS * nodes > MOST_NODES as f64;
        match is_beyond_pieces || by_rays < by_pieces {
            true if is_beyond_pieces => Self::Rays { most: f64::INFINITY },
            true => Self::Rays { most: by_pieces },
            false => Self::Pieces,
        }
    }
}

/// Whether there are images, all of whose pixels share what exact pieces take.
fn asks_for_images(scene: &Scene) -> bool {
    scene.receivers.iter().any(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)))
}

/// How many faces reflect.
fn sources(scene: &Scene, faces: &[Face]) -> usize {
    faces.iter().filter(|face| is_reflecting(scene, face)).count()
}

/// How many nodes this many elements begin with.
fn coarsest_nodes(elements: usize) -> usize {
    let nodes = |order| elements * reference(Shape::Square, order).nodes.len();
    nodes(first_order(nodes))
}

/// How many readings a scene asks for, and how many cells of maps.
fn asked(scene: &Scene) -> (usize, usize) {
    let (mut readings, mut cells) = (0, 0);
    for receiver in &scene.receivers {
        match receiver.kind {
            ReceiverKind::Surface { grid, .. } => {
                readings += 1;
                cells += grid.map_or(0, |[columns, rows]| columns * rows);
            }
            ReceiverKind::Sphere { .. } => readings += 4,
            ReceiverKind::Point { .. } | ReceiverKind::Ray { .. } => readings += 1,
            ReceiverKind::Camera(_) => {}
        }
    }
    (readings, cells)
}

/// How many paths it takes to find this many numbers within the tolerance.
fn paths(scene: &Scene, numbers: usize) -> f64 {
    numbers as f64 * (STUDENT * DEVIATION / scene.solve.tolerance).powi(2).max(FEWEST_PATHS)
}

/// How many nodes of a rough solution take as long as the paths of all readings.
pub(super) fn worthwhile_nodes(scene: &Scene) -> usize {
    let (readings, cells) = asked(scene);
    let nodes = PATH * paths(scene, readings + cells) / (f64::from(RAYS) + PATH);
    (nodes as usize).clamp(FEWEST_NODES, MOST_ROUGH_NODES)
}
