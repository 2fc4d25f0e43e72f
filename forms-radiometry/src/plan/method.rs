//! Methods: how the answers of a plan are found, decided once.
//!
//! ```text
//! diffuse surfaces in a vacuum
//!   no reflections ─▶ closed forms, integrated over surfaces ┐ sampled where that takes
//!   reflections    ─▶ radiosity                              ┘ fewer operations
//! anything else    ─▶ path tracing; quadrature and ray trees where these need no samples
//! ```
//! [`Solver`] is the decision as a solver takes it, and [`ReceiverMethod`] the same decision for one
//! receiver, by name and with its reason. Where only the work shows which of two methods suffices,
//! both are named.

use super::survey::MANY;
use super::working_scene::SimulatedScene;
use crate::effects::{EffectSet, SimulatedEffects};
use crate::faces::{faces, is_round};
use crate::paths::driver::Computable;
use crate::paths::{Limits, World};
use crate::radiosity::driver::FINEST;
use crate::radiosity::{Gathering, Question};
use crate::scene::{Effect, MaterialKind, Receiver, ReceiverKind, Scene};
use std::sync::Arc;

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

/// Methods of a receiver.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ReceiverMethod {
    /// Name of the receiver.
    pub receiver: String,
    /// The methods, the main one first. There are several where only the work shows which one
    /// suffices.
    pub methods: Vec<Method>,
    /// Reason for the choice.
    pub why: String,
}

/// Solver of a scene, with the choices that it takes from the plan.
#[derive(Clone, Debug)]
pub(crate) enum Solver {
    /// The scene is solved as a whole, with this transport method at each tessellation level.
    Radiosity(Vec<Gathering>),
    /// Path tracing in this world, except for the kinds of receivers whose answers need no samples.
    Paths { world: Arc<World>, computable: Computable },
}

/// Returns the reason why a scene needs path tracing. There is none if it has only diffuse surfaces
/// in a vacuum, with numbers and maps of them, and with images only of flat surfaces with few
/// faces.
pub(super) fn reason_for_paths(scene: &Scene) -> Option<String> {
    let kind = |material: usize| &scene.materials[material].kind;
    let is_directional = |material: usize| !matches!(kind(material), MaterialKind::Diffuse { .. });
    if let Some(surface) = scene.surfaces.iter().find(|surface| is_directional(surface.material)) {
        return Some(format!("the surface `{}` is not diffuse", surface.name));
    }
    if let Some(receiver) = scene.receivers.iter().find(|receiver| receiver.time.is_some()) {
        return Some(format!("the receiver `{}` is time-resolved", receiver.name));
    }
    let ambient = scene.ambient.medium.map(|medium| &scene.media[medium]);
    if let Some(medium) = ambient.filter(|medium| !medium.is_vacuum()) {
        return Some(format!("the medium `{}` fills the scene", medium.name));
    }
    let is_image = |receiver: &&Receiver| matches!(receiver.kind, ReceiverKind::Camera(_));
    let image = scene.receivers.iter().find(is_image)?;
    if is_round(scene) {
        return Some(format!("the image `{}` is of curved surfaces", image.name));
    }
    (faces(scene, 0).len() > MANY).then(|| format!("the image `{}` is of more than {MANY} faces", image.name))
}

/// Chooses the solver of a scene, and the methods of each of its receivers. The scene is solved by
/// path tracing if there is a reason for it.
pub(super) fn decide(simulated: &SimulatedScene, paths: Option<String>) -> (Solver, Vec<ReceiverMethod>) {
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    match paths {
        Some(reason) => {
            let computable = Computable::of(scene, &Limits::of(effects));
            let world = Arc::new(World::new(simulated.shared_scene()));
            (Solver::Paths { world, computable }, of_paths(scene, computable, &reason))
        }
        None => {
            // curved surfaces are tessellated several times
            let finest = if is_round(scene) { FINEST } else { 0 };
            let question = Question::of(scene, effects);
            let transport = Gathering::at_each_level(scene, &question, effects.hiding, finest);
            let methods = of_radiosity(scene, effects, &transport);
            (Solver::Radiosity(transport), methods)
        }
    }
}

/// Returns the methods of a scene that is solved as a whole with these transport methods.
fn of_radiosity(scene: &Scene, effects: &SimulatedEffects, transport: &[Gathering]) -> Vec<ReceiverMethod> {
    let is_direct = effects.orders == Some(0);
    let sampling = if is_direct { Method::DirectSampling } else { Method::FinalGathering };
    let mut why = match is_direct {
        true => "surfaces are diffuse, in a vacuum, and no reflection is simulated".to_owned(),
        false => "surfaces are diffuse, in a vacuum, and reflect light".to_owned(),
    };
    let is_sampled = |gathering: &Gathering| matches!(gathering, Gathering::Rays { .. });
    let is_sampled_only = |gathering: &Gathering| *gathering == Gathering::Rays { most: f64::INFINITY };
    if transport.iter().any(is_sampled_only) {
        why += "; exact visibility would need too many nodes";
    } else if transport.iter().any(is_sampled) {
        why += "; rays are expected to take less time than exact visibility, which follows if they do not";
    }
    let of_receiver = |receiver: &Receiver| {
        let exact = match receiver.kind {
            _ if !is_direct => Method::Radiosity,
            ReceiverKind::Surface { .. } | ReceiverKind::Camera(_) => Method::ClosedFormIntegrals,
            ReceiverKind::Point { .. } | ReceiverKind::Sphere { .. } | ReceiverKind::Ray { .. } => {
                Method::ClosedForms
            }
        };
        let of_level = |gathering: &Gathering| match gathering {
            Gathering::Pieces => vec![exact],
            gathering if is_sampled_only(gathering) => vec![sampling],
            Gathering::Rays { .. } => vec![sampling, exact],
        };
        let mut methods = Vec::new();
        transport.iter().flat_map(of_level).for_each(|method| add(&mut methods, method));
        ReceiverMethod { receiver: receiver.name.clone(), methods, why: why.clone() }
    };
    scene.receivers.iter().map(of_receiver).collect()
}

/// Returns the methods of a scene that is solved by path tracing for this reason. Which rays are
/// split by smooth surfaces only is known after tracing them.
fn of_paths(scene: &Scene, computable: Computable, reason: &str) -> Vec<ReceiverMethod> {
    let scatters = EffectSet::of_scene(scene).has(Effect::Scattering);
    let of_receiver = |receiver: &Receiver| {
        let (methods, more) = match receiver.kind {
            ReceiverKind::Ray { .. } if computable.has(receiver) => {
                (vec![Method::Quadrature], "; the medium scatters light of point or distant lights once")
            }
            _ if computable.has(receiver) => (vec![Method::Quadrature], "; the medium only attenuates light"),
            ReceiverKind::Ray { .. } if receiver.time.is_none() && !scatters => {
                let both = vec![Method::PathTracing, Method::RayTrees];
                (both, "; no samples are needed if the ray meets only smooth or black surfaces")
            }
            _ => (vec![Method::PathTracing], ""),
        };
        ReceiverMethod { receiver: receiver.name.clone(), methods, why: format!("{reason}{more}") }
    };
    scene.receivers.iter().map(of_receiver).collect()
}

fn add(methods: &mut Vec<Method>, method: Method) {
    if !methods.contains(&method) {
        methods.push(method);
    }
}

/// Returns each method of the receivers once, the main one first. Integrals of closed forms include
/// the closed forms.
pub(super) fn distinct(receivers: &[ReceiverMethod], is_by_paths: bool) -> Vec<Method> {
    let mut methods = Vec::new();
    receivers.iter().flat_map(|own| &own.methods).for_each(|&method| add(&mut methods, method));
    if methods.contains(&Method::ClosedFormIntegrals) {
        methods.retain(|&method| method != Method::ClosedForms);
    }
    if is_by_paths {
        methods.sort_unstable();
    }
    methods
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulation::plan;
    use forms_testing::scene_text::{
        material, point_receiver, polygon, surface, surface_receiver, tolerance,
    };

    fn of(rest: &str) -> Vec<Method> {
        let square = |z: f64| polygon(&[[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]);
        let lamp = polygon(&[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
        let lamp = surface("lamp", "wall", &lamp) + "radiance = 1\n";
        let text = [&material("wall", 0.5), &surface("floor", "wall", &square(0.0)), &lamp, rest].concat();
        let scene = crate::scene::read(&text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0])).methods()
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
        assert_eq!(of(&[&point, &floor, &direct[..]].concat()), [Method::ClosedFormIntegrals]);
        assert_eq!(of(&[&point, fog].concat()), [Method::PathTracing]);
        assert_eq!(of(&[ray, glass].concat()), [Method::PathTracing, Method::RayTrees]);
        let black = "effects = { interreflection = \"off\" }\n";
        assert_eq!(of(&[&point, glass, &tolerance(1e-3), black].concat()), [Method::Quadrature]);
    }
}
