//! Transport method: exact visible pieces of all elements, or rays, whichever is expected to take
//! less time.
//!
//! ```text
//! pieces   v s (n (1 + k²) + c k)       n nodes, s reflecting elements; k times as many at the end
//! rays     32 m + 16 (r + c) (t σ/ε)²   m elements, r readings, c cells of maps, t of Student,
//!                                       σ the standard deviation of a path
//! ```
//! These costs are in rays, for the tolerance ε: the exact view of an element costs v rays. Among
//! surfaces that occlude each other, the error of the first elements is about 1, and errors fall
//! with the power 3/2 of the area of elements: k = (1/ε)^(2/3). Without occlusion, pieces are as
//! accurate as polynomials of second degree, whose integrals have an error of 1/10 at first, which
//! falls with the third power of the area: k = (1/10ε)^(1/3). The cost of pieces is that of pairs,
//! and is limited by memory; the cost of rays hardly depends on the surfaces. The deviation of a
//! path is hardly known in advance, so rays are given up as soon as they prove slower than pieces
//! would be. Pieces that occlude each other and that cannot be split once within the maximum number
//! of nodes give no error estimate: then rays are used, however long they take.
//!
//! Rays always account for occlusion. They are therefore not used if there is occlusion that is not
//! to be simulated. They are not used either if there is neither occlusion nor reflection and all
//! light has closed forms, or if there are images.

use super::coarsest_elements::{MOST_NODES, first_order};
use super::costs::{FEWEST_PATHS, PATH, RAYS, STUDENT, VIEW};
use super::question::Question;
use super::reference::{Shape, reference};
use super::reflectance::is_reflecting;
use crate::effects::Hiding;
use crate::faces::faces;
use crate::scene::{ReceiverKind, Scene};
use crate::visibility::Face;

/// Standard deviation of a path's value, relative to a reading: typical where a third of the light
/// is reflected.
const DEVIATION: f64 = 0.2;
/// Minimum number of nodes with which a rough solution is not too rough, and the maximum number.
const FEWEST_NODES: usize = 4_096;
const MOST_ROUGH_NODES: usize = 1 << 20;
/// Error of the first elements, and the power of their number by which it falls: among surfaces
/// that occlude each other, and without occlusion.
const HIDDEN: [f64; 2] = [1.0, 1.5];
const FREE: [f64; 2] = [0.1, 3.0];
/// Minimum number of parts that an element is split into.
const PARTS: f64 = 4.0;

/// Transport method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Gathering {
    /// By the exact pieces that points see of all elements.
    Pieces,
    /// By rays, and by paths for the light that rays do not cover, as long as no more than `most`
    /// rays are needed.
    Rays { most: f64 },
}

impl Gathering {
    /// Selects the method at each tessellation level of a scene, up to the finest.
    pub(crate) fn at_each_level(
        scene: &Scene,
        question: &Question,
        hiding: Hiding,
        finest: usize,
    ) -> Vec<Self> {
        let is_straight = hiding == Hiding::Nothing && question.orders == Some(0);
        if is_straight || hiding == Hiding::LeftOut || asks_for_images(scene) {
            return vec![Self::Pieces; finest + 1];
        }
        let of_level = |fineness| Self::of(scene, &faces(scene, fineness), hiding);
        (0..=finest).map(of_level).collect()
    }

    /// Selects the method for a scene with these faces by the expected time.
    fn of(scene: &Scene, faces: &[Face], hiding: Hiding) -> Self {
        let is_hidden = hiding == Hiding::Simulated;
        let [first_error, power] = if is_hidden { HIDDEN } else { FREE };
        let sources = sources(scene, faces);
        let nodes = coarsest_nodes(sources) as f64;
        let (readings, cells) = requested_values(scene);
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

/// Whether there are images, whose pixels all share the cost of exact pieces.
fn asks_for_images(scene: &Scene) -> bool {
    scene.receivers.iter().any(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)))
}

/// Returns the number of faces that reflect.
fn sources(scene: &Scene, faces: &[Face]) -> usize {
    faces.iter().filter(|face| is_reflecting(scene, face)).count()
}

/// Returns the number of nodes that this many elements begin with.
fn coarsest_nodes(elements: usize) -> usize {
    let nodes = |order| elements * reference(Shape::Square, order).nodes.len();
    nodes(first_order(nodes))
}

/// Returns the number of readings that a scene asks for, and the number of cells of maps.
fn requested_values(scene: &Scene) -> (usize, usize) {
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

/// Returns the number of paths that this many values need to reach the tolerance.
fn paths(scene: &Scene, numbers: usize) -> f64 {
    numbers as f64 * (STUDENT * DEVIATION / scene.solve.tolerance).powi(2).max(FEWEST_PATHS)
}

/// Returns the number of nodes of a rough solution that take as long as the paths of all readings.
pub(crate) fn worthwhile_nodes(scene: &Scene) -> usize {
    let (readings, cells) = requested_values(scene);
    let nodes = PATH * paths(scene, readings + cells) / (f64::from(RAYS) + PATH);
    (nodes as usize).clamp(FEWEST_NODES, MOST_ROUGH_NODES)
}
