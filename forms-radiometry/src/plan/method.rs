//! Methods: the names of the field for the ways in which the answers of a plan are found.
//!
//! ```text
//! diffuse surfaces in a vacuum
//!   no reflections ─▶ closed forms, integrated over surfaces ┐ sampled where that takes
//!   reflections    ─▶ radiosity                              ┘ fewer operations
//! anything else    ─▶ path tracing; quadrature and ray trees where these need no samples
//! ```
//! This module only reports names. The choice itself is made by
//! [`is_by_paths`](super::solver::is_by_paths) and [`Gathering::of`]. Where only the work shows
//! which of two methods suffices, both are named.

use super::Plan;
use super::working_scene::Prepared;
use crate::effects::{EffectSet, SimulatedEffects};
use crate::faces::{faces, is_round};
use crate::paths::Limits;
use crate::paths::driver::Computable;
use crate::radiosity::driver::FINEST;
use crate::radiosity::{Gathering, Question};
use crate::scene::{Effect, Receiver, ReceiverKind, Scene};

/// Method that finds answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// Closed forms of the light from emitters to points.
    ClosedForms,
    /// Integrals of these over surfaces and pixels.
    ClosedFormIntegrals,
    /// Sampled rays to emitters.
    DirectSampling,
    /// Sampled rays from receivers to surfaces whose radiosity is known roughly, and paths for the
    /// remainder.
    FinalGathering,
    /// Radiosity on elements that are refined where the answers need it.
    Radiosity,
    /// Sampled paths from receivers.
    PathTracing,
    /// Integrals along rays, and over the parts of surfaces visible from points.
    Quadrature,
    /// All rays into which smooth surfaces split one ray.
    RayTrees,
}

impl Method {
    /// Returns its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::ClosedForms => "closed forms",
            Self::ClosedFormIntegrals => "closed forms integrated over surfaces",
            Self::Quadrature => "adaptive quadrature",
            Self::DirectSampling => "Monte Carlo sampling of direct light",
            Self::FinalGathering => "Monte Carlo final gathering",
            Self::Radiosity => "radiosity on adaptive elements",
            Self::PathTracing => "Monte Carlo path tracing",
            Self::RayTrees => "ray trees",
        }
    }
}

/// Returns the methods of a plan, the main one first. There are several where receivers differ, or
/// where only the work shows which one suffices.
pub fn methods(scene: &Scene, plan: &Plan) -> Vec<Method> {
    let prepared = Prepared::of(scene, plan);
    let working = prepared.working();
    if prepared.is_by_paths() {
        of_paths(&working.scene, &prepared.effects)
    } else {
        of_whole(&working.scene, &prepared.effects)
    }
}

/// Returns the methods of a scene of diffuse surfaces in a vacuum. Curved surfaces are tessellated
/// several times, and the method is chosen again each time.
fn of_whole(scene: &Scene, effects: &SimulatedEffects) -> Vec<Method> {
    let finest = if is_round(scene) { FINEST } else { 0 };
    let question = Question::of(scene, effects);
    let gathering = |fineness| Gathering::of(scene, &faces(scene, fineness), &question, effects.hiding);
    let is_integrated =
        |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Surface { .. } | ReceiverKind::Camera(_));
    let (sampling, exact): (Method, &[Method]) = match effects.orders {
        Some(0) if scene.receivers.iter().any(is_integrated) => {
            (Method::DirectSampling, &[Method::ClosedFormIntegrals])
        }
        Some(0) => (Method::DirectSampling, &[Method::ClosedForms]),
        _ => (Method::FinalGathering, &[Method::Radiosity]),
    };
    let of_gathering = |gathering| match gathering {
        Gathering::Pieces => exact.to_vec(),
        Gathering::Rays { most } if most.is_infinite() => vec![sampling],
        Gathering::Rays { .. } => [&[sampling], exact].concat(),
    };
    distinct((0..=finest).flat_map(|fineness| of_gathering(gathering(fineness))))
}

/// Returns the methods of any other scene. Which rays are split by smooth surfaces only, is known
/// after tracing them.
fn of_paths(scene: &Scene, effects: &SimulatedEffects) -> Vec<Method> {
    let computable = Computable::of(scene, &Limits::of(effects));
    let scatters = EffectSet::of_scene(scene).has(Effect::Scattering);
    let of_receiver = |receiver: &Receiver| match receiver.kind {
        _ if computable.has(receiver) => vec![Method::Quadrature],
        ReceiverKind::Ray { .. } if receiver.time.is_none() && !scatters => {
            vec![Method::PathTracing, Method::RayTrees]
        }
        _ => vec![Method::PathTracing],
    };
    let mut methods = distinct(scene.receivers.iter().flat_map(of_receiver));
    methods.sort_unstable();
    methods
}

/// Returns each method once, in the order of first occurrence.
fn distinct(methods: impl Iterator<Item = Method>) -> Vec<Method> {
    let mut found = Vec::new();
    for method in methods {
        if !found.contains(&method) {
            found.push(method);
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene_text::{material, point_receiver, polygon, surface, surface_receiver, tolerance};
    use crate::simulation::plan;

    fn of(rest: &str) -> Vec<Method> {
        let square = |z: f64| polygon(&[[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]);
        let lamp = polygon(&[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
        let lamp = surface("lamp", "wall", &lamp) + "radiance = 1\n";
        let text = [&material("wall", 0.5), &surface("floor", "wall", &square(0.0)), &lamp, rest].concat();
        let scene = crate::scene::read(&text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        methods(&scene, &plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0])))
    }

    #[test]
    fn the_method_is_that_of_the_plan() {
        let point = point_receiver("point", [0.5, 0.5, 0.5], [0.0, 0.0, 1.0]);
        let direct = tolerance(1e-3) + "effects = { interreflection = \"off\" }\n";
        let fog = "[[medium]]\nname = \"fog\"\nsigma_a = 0.1\nsigma_s = 1\n[ambient]\nmedium = \"fog\"\n";
        let glass = "[[medium]]\nname = \"smoke\"\nsigma_a = 1\n[ambient]\nmedium = \"smoke\"\n";
        let ray =
            "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.5, 0.5, 0.5]\ndirection = [0, 0, 1]\n";
        assert_eq!(of(&[&point, &tolerance(1e-3)[..]].concat()), [Method::Radiosity]);
        assert_eq!(of(&[&point, &direct[..]].concat()), [Method::ClosedForms]);
        let floor = surface_receiver("floor");
        assert_eq!(of(&[&floor, &direct[..]].concat()), [Method::ClosedFormIntegrals]);
        assert_eq!(of(&[&point, fog].concat()), [Method::PathTracing]);
        assert_eq!(of(&[ray, glass].concat()), [Method::PathTracing, Method::RayTrees]);
        let black = "effects = { interreflection = \"off\" }\n";
        assert_eq!(of(&[&point, glass, &tolerance(1e-3), black].concat()), [Method::Quadrature]);
    }
}
