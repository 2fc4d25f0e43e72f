//! Expected cost of radiosity: what a solution to the tolerance costs, before there is one.
//!
//! ```text
//! reflected light   v s (n (1 + k²) + c k)     n nodes, k times as many at the end, s reflecting faces
//! direct light      v l (p + c + n k) + e l f  l bright faces, p points, c cells, f receiving faces
//! ```
//! The unit is the cost of a ray: an exact view of a face costs v rays, an integral over a pair of
//! faces e rays, and both more where occluders stand between: the plan counts these for some pairs. Among surfaces that occlude each other, the error of the first elements is about
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
use super::first_faces::FirstFaces;
use super::question::Question;
use super::reflectance::is_reflecting;
use super::shadows::Shadows;
use super::transport::Transport;
use crate::effects::Hiding;
use crate::faces::{faces, is_bright, is_round};
use crate::geometry::Vector;
use crate::scene::{ReceiverKind, Scene};
use crate::visibility::{Between, Face, Screens};
use crate::watch::Unwatched;
use std::sync::Arc;

/// Cost of an exact view of a face, and of the light exchanged by two faces, in rays.
const VIEW: f64 = 16.0;
const EXCHANGE: f64 = 4.0;
/// Number of possible occluders that double the cost of a view.
const CROWD: f64 = 8.0;
/// Number of possible occluders beyond which the pieces that are left between them make views more
/// expensive.
const THRONG: f64 = 12.0;
/// Number of views of an integral that each occluder adds, up to a number that the tolerance needs.
const VIEWS: f64 = 45.0;
/// Number of points, and of receiving faces, whose occluders are counted.
const ASKED: usize = 16;
/// Error of the first elements among surfaces that occlude each other, and without occlusion.
const HIDDEN: f64 = 1.0;
const FREE: f64 = 0.1;
/// Minimum number of parts that an element is split into.
const PARTS: f64 = 4.0;
/// Error of the second polyhedra of curved shapes; that of each further one is a quarter.
const SHAPE: f64 = 1e-2;

/// Cost of polyhedra of curved shapes that reflect light, relative to flat surfaces with as many
/// nodes: median of random rooms.
const ROUND: f64 = 3.0;
/// Number of points at which the light of a pixel is gathered.
const PIXEL: usize = 4;

/// Expected costs in rays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Expected {
    /// Of the solution; infinite if there would be too many nodes.
    pub(crate) solution: f64,
    /// Of the direct light at a point.
    pub(crate) point: f64,
}

/// Returns the expected costs of a scene.
pub(crate) fn expected_cost(
    scene: &Scene,
    question: &Question,
    hiding: Hiding,
    first: &FirstFaces,
) -> Expected {
    let finest = if is_round(scene) { finest(scene.solve.tolerance) } else { 0 };
    let costs = (0..=finest).map(|fineness| at_fineness(scene, fineness, question, hiding, first));
    let of_shapes = if finest > 0 && question.orders != Some(0) { ROUND } else { 1.0 };
    let add = |a: Expected, b: Expected| Expected {
        solution: a.solution + b.solution,
        point: a.point.max(b.point),
    };
    let Expected { solution, point } = costs.fold(Expected { solution: 0.0, point: 0.0 }, add);
    Expected { solution: of_shapes * solution, point }
}

/// Returns the tessellation level at which curved shapes are expected to meet the tolerance.
fn finest(tolerance: f64) -> usize {
    let levels = (SHAPE / tolerance).log(4.0).ceil().max(0.0);
    FINEST.min(1 + levels as usize)
}

/// Returns the expected costs with the faces of this fineness.
fn at_fineness(
    scene: &Scene,
    fineness: usize,
    question: &Question,
    hiding: Hiding,
    first: &FirstFaces,
) -> Expected {
    const BEYOND: Expected = Expected { solution: f64::INFINITY, point: f64::INFINITY };
    let is_hidden = hiding == Hiding::Simulated;
    let faces = if fineness == 0 { first.faces(scene) } else { Arc::new(faces(scene, fineness)) };
    let kinds = kinds(scene, &faces);
    let count = |is: &dyn Fn(&&Face) -> bool| faces.iter().filter(is).count();
    let reflecting = if question.orders == Some(0) { 0 } else { count(&|face| is_reflecting(scene, face)) };
    let receiving = count(&|face| question.receives.have(face));
    let sources = sources(scene, &faces, kinds);
    let lit: Vec<usize> = sources.into_iter().filter(|&face| is_bright(scene, &faces[face])).collect();
    let is_beyond = |nodes: usize| is_hidden && PARTS * nodes as f64 > MOST_NODES as f64;
    // without light from outside, the direct light of a surface is an integral
    if is_beyond(reflecting.max(if kinds.surroundings { receiving } else { 0 })) {
        return BEYOND;
    }
    let screens = match is_hidden {
        true if fineness == 0 => first.screens(scene),
        true => Arc::new(Screens::of(&faces)),
        false => Arc::new(Screens::none(&faces)),
    };
    let transport = Transport { faces, screens, occlusion: is_hidden, hides_outside: true, accuracy: 1.0 };
    let nodes = coarsest_nodes(scene, &transport, question, !kinds.surroundings);
    if is_beyond(nodes) {
        return BEYOND;
    }
    let (points, cells) = requested_values(scene);
    let [nodes, points, cells] = [nodes, points, cells].map(|count| count as f64);
    let [view, integral] = costs(scene, &transport, question, &lit);
    let [reflecting, receiving, lit] = [reflecting, receiving, lit.len()].map(|count| count as f64);
    let first_error = if is_hidden { HIDDEN } else { FREE } * highest_peak(scene, &transport);
    let finer = (first_error / scene.solve.tolerance).cbrt().min(MOST_NODES as f64 / nodes).max(1.0);
    let reflected = VIEW * reflecting * (nodes * (1.0 + finer * finer) + cells * finer);
    let direct = lit * (view * (points + cells + nodes * finer) + integral * receiving);
    Expected { solution: reflected + direct, point: lit * view }
}

/// Returns the mean cost of the view of a bright face from a point, and of the light exchanged with
/// a receiving face: of some of each.
fn costs(scene: &Scene, transport: &Transport, question: &Question, lit: &[usize]) -> [f64; 2] {
    let Transport { faces, screens, occlusion, .. } = transport;
    if !occlusion || lit.is_empty() {
        return [VIEW, EXCHANGE];
    }
    let mut found = Vec::new();
    let mut crowd = |outline: &[Vector], normal: Option<Vector>, index: usize| {
        let Face { vertices, normal: facing, .. } = &faces[lit[index % lit.len()]];
        match screens.between(outline, normal, vertices, *facing, &mut found) {
            Between::Some => found.len() as f64,
            Between::Nothing | Between::All => 0.0,
        }
    };
    let view = |crowd: f64| VIEW * (1.0 + crowd / CROWD + (crowd / THRONG).powi(2));
    let integral = |crowd: f64| match crowd {
        0.0 => EXCHANGE,
        _ => VIEWS * crowd.min(scene.solve.tolerance.recip()) * view(crowd),
    };
    let receiving: Vec<&Face> = faces.iter().filter(|face| question.receives.have(face)).collect();
    let points: Vec<(Vector, Option<Vector>)> = scene
        .receivers
        .iter()
        .flat_map(|receiver| receiver.kind.points())
        .chain(receiving.iter().map(|face| (Vector::mean(&face.vertices), Some(face.normal))))
        .collect();
    let some = |count: usize| (0..count).step_by(count.div_ceil(ASKED).max(1));
    let mean = |costs: Vec<f64>, else_: f64| match costs.len() {
        0 => else_,
        count => costs.iter().sum::<f64>() / count as f64,
    };
    let views = some(points.len()).map(|place| view(crowd(&[points[place].0], points[place].1, place)));
    let views = mean(views.collect(), VIEW);
    let integrals = some(receiving.len()).map(|place| {
        let face = receiving[place];
        integral(crowd(&face.vertices, Some(face.normal), place))
    });
    [views, mean(integrals.collect(), EXCHANGE)]
}

/// Returns the number of nodes before any element is split. Faces are cut where others touch them
/// and along shadow borders. `is_integral` tells whether the direct light of surfaces is an
/// integral.
fn coarsest_nodes(scene: &Scene, transport: &Transport, question: &Question, is_integral: bool) -> usize {
    let shadows = Shadows::on(scene, transport, question, &Unwatched);
    coarsest(scene, transport, question, &|_| !is_integral, &shadows).iter().map(Element::count).sum()
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
            ReceiverKind::Points(_) => points += Reading::cells(index, receiver, scene).count(),
            ReceiverKind::Camera(ref camera) => {
                let [columns, rows] = camera.resolution;
                cells += PIXEL * columns * rows;
            }
            ReceiverKind::Faces { .. } => {}
        }
    }
    (points, cells)
}
