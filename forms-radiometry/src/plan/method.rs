//! Methods: how the answers of a plan are found, decided once.
//!
//! ```text
//! concentric spheres ─▶ closed forms
//! diffuse surfaces in a vacuum
//!   no reflections ─▶ closed forms, integrated over surfaces ┐ path tracing where that is
//!   reflections    ─▶ radiosity                              ┘ expected to cost less
//! anything else    ─▶ path tracing; quadrature and ray trees where these need no samples
//! ```
//! [`Solver`] is the decision as a solver takes it, and [`ReceiverMethod`] the same decision for one
//! receiver, by name and with its reason. Where only the work shows which of two methods suffices,
//! both are named.

use super::comparison::{cheaper_paths, is_image, world_of};
use super::survey::MANY;
use super::working_scene::SimulatedScene;
use crate::effects::{EffectSet, SimulatedEffects};
use crate::faces::{faces, is_round};
use crate::paths::driver::Computable;
use crate::paths::{Limits, World};
use crate::radiosity::Shells;
use crate::scene::{Effect, MaterialKind, Receiver, ReceiverKind, Scene, Surface};
use std::sync::Arc;

/// Method that finds answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Method {
    /// Closed forms of the light from emitters to points.
    ClosedForms,
    /// Integrals of these over surfaces and pixels.
    ClosedFormIntegrals,
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

/// How the solver of a scene is chosen.
pub(super) enum Choice {
    /// By path tracing, for this reason.
    Paths(String),
    /// As a whole.
    Whole,
    /// As a whole, unless path tracing is expected to cost less.
    Cheaper,
}

/// Solver of a scene, with the choices that it takes from the plan.
#[derive(Clone, Debug)]
pub(crate) enum Solver {
    /// The scene is solved as a whole.
    Radiosity,
    /// The scene is concentric spheres, whose reflections have a closed form.
    Shells(Arc<Shells>),
    /// Path tracing in this world, except for the kinds of receivers whose answers need no samples.
    Paths { world: Arc<World>, computable: Computable },
}

/// Returns the reason why a scene needs path tracing. There is none if it has only diffuse surfaces
/// with the normals of their faces in a vacuum, with numbers and maps of them, and with images only
/// of flat surfaces with few faces.
pub(super) fn reason_for_paths(scene: &Scene) -> Option<String> {
    if let Some(reason) = reason_of_surfaces(scene) {
        return Some(reason);
    }
    if scene.lights.iter().any(|light| light.cone.is_some()) {
        return Some("the intensity of a spot light depends on the direction".to_owned());
    }
    if scene.solve.events.is_some() {
        return Some("the number of events along a path is limited".to_owned());
    }
    if scene.ambient.map.is_some() {
        return Some("light from outside depends on the direction".to_owned());
    }
    if let Some(receiver) = scene.receivers.iter().find(|receiver| receiver.time.is_some()) {
        return Some(format!("the receiver `{}` is time-resolved", receiver.name));
    }
    let ambient = scene.ambient.medium.map(|medium| &scene.media[medium]);
    if let Some(medium) = ambient.filter(|medium| !medium.is_vacuum()) {
        return Some(format!("the medium `{}` fills the scene", medium.name));
    }
    let is_parallel = |receiver: &&Receiver| match &receiver.kind {
        ReceiverKind::Camera(camera) => camera.is_orthographic(),
        _ => false,
    };
    if let Some(receiver) = scene.receivers.iter().find(is_parallel) {
        return Some(format!("the camera `{}` is orthographic", receiver.name));
    }
    let image = scene.receivers.iter().find(|receiver| is_image(receiver))?;
    if is_round(scene) {
        return Some(format!("the image `{}` is of curved surfaces", image.name));
    }
    (faces(scene, 0).len() > MANY).then(|| format!("the image `{}` is of more than {MANY} faces", image.name))
}

/// Returns the reason why the surfaces of a scene need path tracing, if there is one.
fn reason_of_surfaces(scene: &Scene) -> Option<String> {
    let kind = |surface: &Surface| &scene.materials[surface.material].kind;
    let first = |is_it: &dyn Fn(&Surface) -> bool, what: &str| {
        let surface = scene.surfaces.iter().find(|surface| is_it(surface))?;
        Some(format!("the surface `{}` {what}", surface.name))
    };
    first(&|surface| !matches!(kind(surface), MaterialKind::Diffuse { .. }), "is not diffuse")
        .or_else(|| first(&|surface| surface.texture.is_some(), "has a texture"))
        .or_else(|| first(&|surface| surface.shape.is_smooth(), "has interpolated normals"))
}

/// Chooses the solver of a scene, and the methods of each of its receivers.
pub(super) fn decide(simulated: &mut SimulatedScene, choice: Choice) -> (Solver, Vec<ReceiverMethod>) {
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    if let Some(shells) = Shells::of(scene, effects).filter(|_| !matches!(choice, Choice::Paths(_))) {
        return (Solver::Shells(Arc::new(shells)), of_shells(scene));
    }
    let computable = Computable::of(scene, &Limits::of(effects));
    let by_paths = match choice {
        Choice::Paths(reason) => Some((world_of(simulated), computable, reason)),
        Choice::Whole => None,
        Choice::Cheaper => cheaper_paths(simulated, computable).map(|(world, computable, reason)| {
            let possible = reason_for_radiosity(&simulated.effects);
            (world, computable, format!("{possible}; {reason}"))
        }),
    };
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    match by_paths {
        Some((world, computable, reason)) => {
            let methods = of_paths(scene, computable, &reason);
            (Solver::Paths { world, computable }, methods)
        }
        None => (Solver::Radiosity, of_radiosity(scene, effects)),
    }
}

fn reason_for_radiosity(effects: &SimulatedEffects) -> &'static str {
    match effects.orders {
        Some(0) => "surfaces are diffuse, in a vacuum, and no reflection is simulated",
        _ => "surfaces are diffuse, in a vacuum, and reflect light",
    }
}

/// Returns the methods of a scene of concentric spheres.
fn of_shells(scene: &Scene) -> Vec<ReceiverMethod> {
    let why = "surfaces are concentric spheres in a vacuum: their light is the same at all points of a side";
    let of_receiver = |receiver: &Receiver| ReceiverMethod {
        receiver: receiver.name.clone(),
        methods: vec![Method::ClosedForms],
        why: why.to_owned(),
    };
    scene.receivers.iter().map(of_receiver).collect()
}

/// Returns the methods of a scene that is solved as a whole.
fn of_radiosity(scene: &Scene, effects: &SimulatedEffects) -> Vec<ReceiverMethod> {
    let of_receiver = |receiver: &Receiver| {
        let method = match receiver.kind {
            _ if effects.orders != Some(0) => Method::Radiosity,
            ReceiverKind::Surface { .. } | ReceiverKind::Faces { .. } | ReceiverKind::Camera(_) => {
                Method::ClosedFormIntegrals
            }
            ReceiverKind::Point { .. }
            | ReceiverKind::Points(_)
            | ReceiverKind::Sphere { .. }
            | ReceiverKind::Ray { .. } => Method::ClosedForms,
        };
        let why = reason_for_radiosity(effects).to_owned();
        ReceiverMethod { receiver: receiver.name.clone(), methods: vec![method], why }
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
            ReceiverKind::Point { .. } | ReceiverKind::Points(_) | ReceiverKind::Sphere { .. }
                if computable.is_straight() =>
            {
                (vec![Method::ClosedForms], "")
            }
            ReceiverKind::Surface { grid: Some(_), .. } if computable.is_straight() => {
                (vec![Method::PathTracing, Method::ClosedForms], "; cells have closed forms")
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

    fn methods(text: &str) -> Vec<Method> {
        let scene = crate::scene::read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0])).methods()
    }

    fn of(rest: &str) -> Vec<Method> {
        let square = |z: f64| polygon(&[[0.0, 0.0, z], [1.0, 0.0, z], [1.0, 1.0, z], [0.0, 1.0, z]]);
        let lamp = polygon(&[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
        let lamp = surface("lamp", "wall", &lamp) + "radiance = 1\n";
        methods(&[&material("wall", 0.5), &surface("floor", "wall", &square(0.0)), &lamp, rest].concat())
    }

    /// Returns a point that a sphere lights from inside, with black slats in between.
    fn sphere(slats: usize, rest: &str) -> String {
        let shape = "sphere = { center = [0, 0, 0], radius = 1, inward = true }\nexitance = 1";
        let slat = |index: usize| {
            let x = index as f64 / slats as f64 - 0.5;
            let corners = [[x, -0.1, 0.5], [x + 0.01, -0.1, 0.5], [x + 0.01, 0.1, 0.5], [x, 0.1, 0.5]];
            surface(&format!("slat {index}"), "black", &polygon(&corners))
        };
        let slats: String = (0..slats).map(slat).collect();
        [
            &material("wall", 0.6),
            &material("black", 0.0),
            &surface("shell", "wall", shape),
            &slats[..],
            &point_receiver("point", [0.0, 0.0, 0.2], [0.0, 0.0, 1.0]),
            rest,
        ]
        .concat()
    }

    /// Returns a ray to the floor below a lamp.
    fn ray_in_room(rest: &str) -> String {
        let floor = polygon(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
        let lamp = polygon(&[[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]);
        let ray = "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.5, 0.5, 0.5]\ndirection = [0, 0, -1]\n";
        let surfaces = surface("floor", "wall", &floor) + &surface("lamp", "wall", &lamp);
        [&material("wall", 0.5), &surfaces[..], "radiance = 1\n", ray, rest].concat()
    }

    #[test]
    fn paths_are_traced_where_radiosity_would_cost_far_more() {
        let effects = |effects: &str| format!("{}effects = {{ {effects} }}\n", tolerance(1e-2));
        for (name, text, expected) in [
            ("a sphere", sphere(0, &tolerance(1e-2)), Method::ClosedForms),
            ("occluders in a sphere", sphere(9, &tolerance(1e-2)), Method::PathTracing),
            ("occlusion is left out", sphere(9, &effects("occlusion = \"off\"")), Method::Radiosity),
            ("direct light", sphere(0, &effects("interreflection = \"off\"")), Method::ClosedForms),
            ("no direct light along a ray", ray_in_room(&effects("direct = \"off\"")), Method::Radiosity),
            ("all light along a ray", ray_in_room(&tolerance(1e-2)), Method::Radiosity),
        ] {
            assert_eq!(methods(&text)[0], expected, "{name}");
        }
    }

    #[test]
    fn the_method_does_not_depend_on_the_seed() {
        for asked in [1e-1, 1e-2, 1e-3, 1e-4, 1e-5] {
            let of_seed = |seed: u32| methods(&sphere(9, &format!("{}seed = {seed}\n", tolerance(asked))));
            let first = of_seed(1);
            (2..6).for_each(|seed| assert_eq!(of_seed(seed), first, "{asked:e}, seed {seed}"));
        }
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
