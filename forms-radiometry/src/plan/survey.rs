//! The survey of a scene: its contents, and how much light passes from surface to surface, at
//! points of the coarsest elements.

use super::occlusion_bound::{Obstacles, Reflected};
use super::reflection_bound::Surroundings;
use crate::answer::Quantity;
use crate::effects::{forced, reflects_nothing};
use crate::faces::{emits, faces, round_surfaces};
use crate::geometry::Vector;
use crate::parallelism::Parallelism;
use crate::radiosity::driver::readings::Reading;
use crate::radiosity::{
    Lights, Question, Radiosity, ReceivingAreas, Scratch, Transport, bulges, is_reflecting, most_direct,
    reflectance,
};
use crate::scene::{Effect, Force, LightKind, MaterialKind, ReceiverKind, Scene, Surface, WorkingScene};
use crate::visibility::{Between, Face, Screens};
use crate::watch::Unwatched;
use std::f64::consts::PI;
use std::sync::Arc;

/// Scenes with more faces than this are surveyed by rays: neither bounds nor occluders are found
/// then.
pub(super) const MANY: usize = 256;
/// Margin for a norm that was found at points: the part of the way to its largest possible value by
/// which it is raised.
const MARGIN: f64 = 0.25;
/// Rounding error of a closed scene.
const CLOSED: f64 = 1e-9;

/// Findings of the survey.
pub(crate) struct Survey {
    /// Whether anything emits light.
    pub(crate) emits: bool,
    /// Whether any surface reflects.
    pub(crate) reflects: bool,
    /// Estimate, with a margin, of the largest part of the light that a reflection leaves.
    pub(crate) contraction: f64,
    /// Description of the occluders between surfaces, lights and receivers, if there are any.
    pub(crate) in_between: Option<String>,
    /// Largest increase if these occluders were omitted, in the units of the answers and relative
    /// to them.
    pub(crate) occlusion: Option<[f64; 2]>,
    /// Largest increase by all reflections together, in the units of the answers and relative to
    /// them.
    pub(crate) interreflection: Option<[f64; 2]>,
    /// Largest change by replacing all bands with their middle, in the units of the answers and
    /// relative to them; `None` where nothing differs between bands.
    pub(crate) band_spread: Option<[f64; 2]>,
    /// Whether all reflected light meets surfaces, and all of them reflect everything.
    closed_and_white: bool,
}

impl Survey {
    pub(crate) fn of(working: &WorkingScene) -> Self {
        let scene = working.scene.as_ref();
        let faces = faces(scene, 0);
        let is_large = faces.len() > MANY;
        let largest_albedo = largest(scene, |surface| reflectance(scene, surface));
        let screens = match is_large {
            true if largest_albedo == 0.0 => Screens::none(&faces),
            true => Screens::met_by_rays(&faces),
            false => Screens::of(&faces),
        };
        // effects that the file turns off are not examined further, nor are their occluders; a
        // light trap is refused all the same
        let is_unseen = !is_large && reflects_nothing(scene) && largest_albedo < 1.0;
        let (faces, screens) = (Arc::new(faces), Arc::new(screens));
        let transport = Transport { faces, screens, occlusion: true, hides_outside: true, accuracy: 1e-2 };
        let lights = Lights::of(scene, &transport);
        let sampled = match is_large {
            true => Surroundings::by_rays(scene, &transport),
            false if is_unseen => Surroundings::unseen(largest_albedo),
            false => Surroundings::of(scene, &transport),
        };
        let contraction = sampled.contraction + MARGIN * (largest_albedo - sampled.contraction).max(0.0);
        let contraction = if sampled.may_see { contraction } else { 0.0 };
        let bulges = if is_large { None } else { bulge_before(scene, &transport.faces) };
        let mut survey = Self {
            emits: !scene.lights.is_empty()
                || lights.kinds().surroundings
                || (0..transport.faces.len()).any(|face| emits(scene, &transport.faces[face])),
            reflects: largest_albedo > 0.0,
            contraction,
            in_between: in_between(scene, &transport).or_else(|| bulges.clone()),
            occlusion: None,
            interreflection: None,
            band_spread: None,
            closed_and_white: largest_albedo >= 1.0
                && sampled.contraction >= 1.0 - CLOSED
                && sampled.closure >= 1.0 - CLOSED
                && all_white(scene),
        };
        if !is_large {
            survey.bound(working, &transport, &lights, bulges.is_some());
        } else {
            // bounds need exact direct light, at every surface that is a receiver
            survey.band_spread =
                spreads(scene).iter().any(|&spread| spread > 0.0).then_some([f64::INFINITY; 2]);
        }
        survey
    }

    /// Surveys the contents of a scene that is simulated by path tracing, for which no bound is
    /// known.
    pub(crate) fn without_bounds(scene: &Scene) -> Self {
        let largest_albedo = largest(scene, |surface| reflectance(scene, surface));
        let outside = scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0);
        let differs = spreads(scene).iter().any(|&spread| spread > 0.0) || has_spread_of_media(scene);
        Self {
            emits: !scene.lights.is_empty() || outside || scene.surfaces.iter().any(Surface::emits),
            reflects: largest_albedo > 0.0,
            contraction: 1.0,
            in_between: (!scene.surfaces.is_empty())
                .then(|| "surfaces can occlude each other along rays".to_string()),
            occlusion: None,
            interreflection: None,
            band_spread: differs.then_some([f64::INFINITY; 2]),
            closed_and_white: false,
        }
    }

    /// Sets the bounds relative to the direct light of every answer. Occlusion has no bound where
    /// curved shapes hide more than their faces.
    fn bound(&mut self, working: &WorkingScene, transport: &Transport, lights: &Lights, bulges: bool) {
        let scene = working.scene.as_ref();
        let direct = most_direct(scene, transport);
        let largest_albedo = largest(scene, |surface| reflectance(scene, surface));
        // ‖E‖ ≤ ‖D‖/(1 − k), and reflected light is at most ρ E/π from everywhere
        let everywhere = direct / (1.0 - self.contraction);
        let reflected = largest_albedo * everywhere / PI;
        let [of_albedo, of_light] = spreads(scene);
        let spread = if reflects_nothing(scene) {
            of_light + of_albedo * direct / PI
        } else {
            (of_light + of_albedo * everywhere / PI) / (1.0 - self.contraction)
        };
        let is_bound = self.contraction < 1.0 && !scene.receivers.is_empty();
        let is_asked = is_bound
            && !bulges
            && self.in_between.is_some()
            && forced(scene, Effect::Occlusion) != Some(Force::On);
        let found = Reflected { contraction: self.contraction, irradiance: everywhere };
        let obstacles = is_asked.then(|| Obstacles::of(scene, transport, found)).flatten();
        let bounds = bounds(working, transport, lights, [reflected, spread], obstacles.as_ref());
        let [interreflection, bands, occlusion] = bounds;
        self.interreflection = is_bound.then_some(interreflection);
        self.occlusion = obstacles.is_some().then_some(occlusion);
        // the irradiance by a point light has no bound in terms of its intensity alone
        let spreads_points = scene.lights.iter().any(|light| half_spread_of_light(light) > 0.0);
        let differs = of_light > 0.0 || of_albedo > 0.0;
        self.band_spread =
            differs.then_some(if is_bound && !spreads_points { bands } else { [f64::INFINITY; 2] });
    }

    /// Returns a bound on the light omitted after this many reflections, in the units of the
    /// answers: kⁿ times the bound on all reflections.
    pub(crate) fn after_orders(&self, count: u32) -> Option<f64> {
        self.interreflection.map(|[absolute, _]| absolute * self.contraction.powf(f64::from(count)))
    }

    /// Returns a surface that light never leaves, if there is light, and everything around it is
    /// closed and white.
    pub(crate) fn trap(&self, scene: &Scene) -> Option<usize> {
        let reflecting = |&surface: &usize| reflectance(scene, surface).iter().any(|&rho| rho >= 1.0);
        (self.emits && self.closed_and_white).then(|| (0..scene.surfaces.len()).find(reflecting)).flatten()
    }
}

/// Returns bounds on the change of an answer by each of these radiances from everywhere, and by
/// occluders: in the unit of the answer, and relative to its direct light.
fn bounds(
    working: &WorkingScene,
    transport: &Transport,
    lights: &Lights,
    radiances: [f64; 2],
    obstacles: Option<&Obstacles>,
) -> [[f64; 2]; 3] {
    const NOTHING: [[f64; 2]; 3] = [[0.0; 2]; 3];
    if radiances == [0.0; 2] && obstacles.is_none() {
        return NOTHING;
    }
    let scene = working.scene.as_ref();
    // effects that the file decides need no bound relative to the answers, which are not cheap
    let is_free = |effect| forced(scene, effect).is_none();
    let matters = [radiances[0] > 0.0, radiances[1] > 0.0, obstacles.is_some()];
    let is_decided = [Effect::Interreflection, Effect::Bands, Effect::Occlusion]
        .into_iter()
        .zip(matters)
        .any(|(effect, matters)| is_free(effect) && matters);
    let question =
        Question { orders: Some(0), receives: ReceivingAreas::of(scene), direct: true, is_seen: false };
    let straight = is_decided.then(|| Radiosity::new(scene, transport, lights, question, &Unwatched));
    let of_reading = |scratch: &mut Scratch, reading: Reading| {
        let largest = reading.largest(transport);
        let least = straight.as_ref().map_or(0.0, |straight| {
            let values = reading.value(scene, straight, scratch);
            values.iter().map(|value| value.abs()).fold(f64::INFINITY, f64::min)
        });
        let bound = |change| match change {
            0.0 => [0.0; 2],
            _ => [reading.quantity.in_unit(change, &working.units), change / least],
        };
        let taken = obstacles.map_or(0.0, |obstacles| obstacles.taken_of(&reading));
        [largest * radiances[0], largest * radiances[1], taken].map(bound)
    };
    let larger = |a: [[f64; 2]; 3], b: [[f64; 2]; 3]| {
        [0, 1, 2].map(|effect| [0, 1].map(|kind| f64::max(a[effect][kind], b[effect][kind])))
    };
    let has_image = scene.receivers.iter().any(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)));
    let of_images = has_image.then(|| {
        let [reflected, spread] = radiances.map(|radiance| of_image(radiance, working));
        [reflected, spread, [0.0; 2]]
    });
    let (readings, _) = Reading::requested(scene);
    let operations = straight.as_ref().map_or(0.0, |straight| straight.operations(readings.len()));
    let bounds = Parallelism::of(operations).map(readings, of_reading);
    bounds.into_iter().chain(of_images).fold(NOTHING, larger)
}

/// Returns the change of an image by a radiance from everywhere: each pixel gets all of it, and the
/// darkest pixel may be black without it.
fn of_image(radiance: f64, working: &WorkingScene) -> [f64; 2] {
    if radiance == 0.0 {
        [0.0; 2]
    } else {
        [Quantity::Radiance.in_unit(radiance, &working.units), f64::INFINITY]
    }
}

fn largest<'s>(scene: &'s Scene, of: impl Fn(usize) -> &'s [f64]) -> f64 {
    (0..scene.surfaces.len()).flat_map(of).copied().fold(0.0, f64::max)
}

fn half_spread(values: &[f64]) -> f64 {
    let (low, high) =
        values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| (low.min(v), high.max(v)));
    if values.is_empty() { 0.0 } else { 0.5 * (high - low) }
}

/// Returns the largest half spread over the bands of a reflectance, and of a light.
fn spreads(scene: &Scene) -> [f64; 2] {
    let spread_of = |lists: &dyn Fn(usize) -> Vec<f64>| {
        (0..scene.surfaces.len()).map(|surface| half_spread(&lists(surface))).fold(0.0, f64::max)
    };
    let of_albedo = spread_of(&|surface| {
        let reflectance = reflectance(scene, surface).to_vec();
        // the colour of a texture can be that of any band
        let black = scene.surfaces[surface].texture.as_ref().filter(|_| reflectance.len() > 1).map(|_| 0.0);
        reflectance.into_iter().chain(black).collect()
    });
    let of_light = spread_of(&|surface| scene.surfaces[surface].radiance.clone())
        .max(half_spread_of_ambient(scene))
        .max(scene.lights.iter().map(half_spread_of_light).fold(0.0, f64::max));
    [of_albedo, of_light]
}

/// Returns the half spread of the light from outside. The spread of a map is at most its largest
/// radiance.
fn half_spread_of_ambient(scene: &Scene) -> f64 {
    let radiance = &scene.ambient.radiance;
    match scene.ambient.map {
        Some(_) if radiance.len() > 1 => 0.5 * radiance.iter().copied().fold(0.0, f64::max),
        _ => half_spread(radiance),
    }
}

fn half_spread_of_light(light: &crate::scene::Light) -> f64 {
    match &light.kind {
        LightKind::Point { intensity, .. } => half_spread(intensity),
        LightKind::Distant { irradiance, .. } => half_spread(irradiance),
    }
}

/// Whether an optical number of a medium, a mirror or a metal differs between bands.
fn has_spread_of_media(scene: &Scene) -> bool {
    let of_media = scene.media.iter().any(|medium| {
        [&medium.absorption, &medium.scattering, &medium.asymmetry, &medium.index]
            .into_iter()
            .any(|values| half_spread(values) > 0.0)
    });
    let of_materials = scene.materials.iter().any(|material| match &material.kind {
        MaterialKind::Mirror { reflectance } => half_spread(reflectance) > 0.0,
        MaterialKind::Conductor { eta, k } => half_spread(eta) > 0.0 || half_spread(k) > 0.0,
        MaterialKind::Plastic { reflectance, specular, .. } => {
            half_spread(reflectance) > 0.0 || half_spread(specular) > 0.0
        }
        MaterialKind::Rough(rough) => rough.spectra().any(|values| half_spread(values) > 0.0),
        MaterialKind::Diffuse { .. } | MaterialKind::Dielectric { .. } => false,
    });
    of_media || of_materials
}

fn all_white(scene: &Scene) -> bool {
    (0..scene.band_count())
        .any(|band| (0..scene.surfaces.len()).all(|surface| reflectance(scene, surface)[band] >= 1.0))
}

/// Whether all surfaces, lights and receivers are on one side of every face. Then the surfaces are
/// parts of the boundary of a convex room, and none occludes anything in it.
fn is_convex_room(scene: &Scene, faces: &[Face], resolution: f64) -> bool {
    let mut inside: Vec<Vector> = faces.iter().flat_map(|face| &face.vertices).copied().collect();
    for light in &scene.lights {
        let LightKind::Point { position, .. } = light.kind else { return false };
        inside.push(position);
    }
    if scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0) {
        return false;
    }
    let points = scene.receivers.iter().flat_map(|receiver| receiver.kind.points());
    inside.extend(points.map(|(position, _)| position));
    faces.iter().filter(|face| !face.is_back).all(|face| {
        let heights = || inside.iter().map(|&point| face.normal.dot(point - face.vertices[0]));
        heights().all(|height| height >= -resolution) || heights().all(|height| height <= resolution)
    })
}

/// Describes a face that a curved shape may partly hide from a point receiver, if there is one. The
/// tessellation of the shape may not show this, as the shape is larger than its faces.
fn bulge_before(scene: &Scene, faces: &[Face]) -> Option<String> {
    let round: Vec<_> = round_surfaces(scene).collect();
    if round.is_empty() {
        return None;
    }
    let is_source = |face: &&Face| emits(scene, face) || is_reflecting(scene, face);
    let may_be_behind = |face: &Face, point: Vector, horizon: Option<Vector>| {
        let luminaire = (face.vertices.as_slice(), face.normal);
        face.normal.dot(point - face.vertices[0]) > 0.0
            && bulges(round.iter().copied(), (point, horizon), luminaire, Some(face.surface)) > 0.0
    };
    let mut points = scene.receivers.iter().flat_map(|receiver| receiver.kind.points());
    let behind = points.find_map(|(point, horizon)| {
        faces.iter().filter(is_source).find(|face| may_be_behind(face, point, horizon))
    })?;
    Some(format!("an occluder may be in front of the surface `{}`", scene.surfaces[behind.surface].name))
}

/// Describes an occluder between two faces, or between a receiver and a face, if there can be any.
fn in_between(scene: &Scene, transport: &Transport) -> Option<String> {
    let faces = &transport.faces;
    let counts = |index: usize| {
        let face = &faces[index];
        emits(scene, face) || is_reflecting(scene, face)
    };
    let sources: Vec<usize> = (0..faces.len()).filter(|&index| counts(index)).collect();
    if faces.len() > MANY {
        return Some(format!("some of the {} faces may occlude others", faces.len()));
    }
    if is_convex_room(scene, faces, transport.screens.resolution()) {
        return None;
    }
    if !scene.lights.is_empty() && !faces.is_empty() {
        return Some("surfaces may occlude point lights or distant lights".to_string());
    }
    if scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0) && !faces.is_empty() {
        return Some("surfaces occlude ambient light".to_string());
    }
    let stands_before = |outline: &[Vector], normal: Option<Vector>| {
        let mut found = Vec::new();
        let mut is_free = |&&source: &&usize| {
            let Face { vertices, normal: facing, .. } = &faces[source];
            let between = transport.screens.between(outline, normal, vertices, *facing, &mut found);
            matches!(between, Between::Nothing)
        };
        let &source = sources.iter().find(|source| !is_free(source))?;
        Some(format!(
            "an occluder is in front of the surface `{}`",
            scene.surfaces[faces[source].surface].name
        ))
    };
    let points = scene.receivers.iter().flat_map(|receiver| receiver.kind.points());
    let points: Vec<(Vector, Option<Vector>)> = points.collect();
    let of_point = |&(position, normal): &(Vector, Option<Vector>)| stands_before(&[position], normal);
    let receives = ReceivingAreas::of(scene);
    let of_face = |index: usize| {
        let is_asked = counts(index) || receives.have(&faces[index]);
        is_asked.then(|| stands_before(&faces[index].vertices, Some(faces[index].normal))).flatten()
    };
    let corners: usize = faces.iter().map(|face| face.vertices.len()).sum();
    let edges: usize = sources.iter().map(|&index| faces[index].vertices.len()).sum();
    let parallelism = Parallelism::of(transport.operations(corners + points.len(), edges));
    parallelism.find_map(&points, of_point).or_else(|| parallelism.find_map(0..faces.len(), of_face))
}
