//! Occlusion bound: occluders between a place and a source take some of the source's light. Where
//! that is little, occlusion need not be simulated.
//!
//! ```text
//! a place, all sources ─▶ occluders between ─▶ Σ L min(Ω of the source, Σ Ω of its occluders) ≥ ΔE
//! reflecting faces ──────────────────────────▶ ρ/π max ΔE/(1 − k̃), the excess radiance they send
//! ```
//! Without occlusion no place gets less light than with it. Of the directions at a point, a face of
//! the area A at the distance d or more takes no more than A/d², and no more than half of them all.

use crate::effects::{forced, reflects_nothing};
use crate::faces::emits;
use crate::geometry::Vector;
use crate::radiosity::driver::readings::{Place, Reading};
use crate::radiosity::{Transport, is_reflecting, reflectance};
use crate::scene::{Effect, ReceiverKind, Scene};
use crate::visibility::Face;
use std::f64::consts::PI;

/// Occluders between the faces of a scene.
pub(crate) struct Obstacles<'s> {
    scene: &'s Scene,
    transport: &'s Transport,
    sources: Vec<Source>,
    /// Largest change for which a bound is worthwhile, relative to the largest answer under a
    /// radiance of 1: the tolerance times the brightest radiance.
    most: f64,
    /// Largest excess radiance that a face sends where occlusion is omitted.
    sent: f64,
}

/// Face that sends light.
struct Source {
    face: usize,
    /// Upper bound on its radiance in any band.
    radiance: f64,
    /// Upper bound on its reflectance in any band.
    reflectance: f64,
}

/// Strength of the reflections in a scene.
#[derive(Clone, Copy)]
pub(crate) struct Reflected {
    /// Largest part of the light that a reflection leaves.
    pub(crate) contraction: f64,
    /// Largest irradiance.
    pub(crate) irradiance: f64,
}

/// Excess light at a place where occlusion is omitted.
#[derive(Clone, Copy, Default)]
struct Taken {
    /// Excess irradiance.
    irradiance: f64,
    /// Excess of Σ ρ F.
    contraction: f64,
}

impl<'s> Obstacles<'s> {
    /// Bounds the effect of occlusion in a scene where surfaces are the only emitters. `None`
    /// where there is no bound: for shadows of other light, in images, or where reflections without
    /// shadows might leave all of the light. Also `None` where the file leaves the decision to the
    /// plan and the shadows matter more than the tolerance.
    pub(crate) fn of(scene: &'s Scene, transport: &'s Transport, reflected: Reflected) -> Option<Self> {
        let is_outside = scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0);
        let has_image =
            scene.receivers.iter().any(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)));
        if !scene.lights.is_empty() || is_outside || has_image {
            return None;
        }
        let reflects = !reflects_nothing(scene);
        let source = |(index, face): (usize, &Face)| {
            let largest = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
            let surface = &scene.surfaces[face.surface];
            let emitted = if emits(scene, face) { largest(&surface.radiance) } else { 0.0 };
            let is_reflecting = reflects && is_reflecting(scene, face);
            let reflectance = if is_reflecting { largest(reflectance(scene, face.surface)) } else { 0.0 };
            let radiance = emitted + reflectance * reflected.irradiance / PI;
            (radiance > 0.0).then_some(Source { face: index, radiance, reflectance })
        };
        let sources = transport.faces.iter().enumerate().filter_map(source).collect();
        let mut obstacles = Self { scene, transport, sources, most: f64::INFINITY, sent: 0.0 };
        if forced(scene, Effect::Occlusion).is_none() {
            let brightest = obstacles.sources.iter().map(|source| source.radiance).fold(0.0, f64::max);
            obstacles.most = scene.solve.tolerance * brightest;
        }
        obstacles.sent = obstacles.sent(reflected)?;
        let matters =
            |reading: &Reading| obstacles.taken_of(reading) > obstacles.most * reading.largest(transport);
        let has_one = Reading::requested(scene).0.iter().any(matters);
        (!has_one).then_some(obstacles)
    }

    /// Returns the largest excess radiance that reflecting faces send: ΔE ≤ max ΔE₁ + k̃ ΔE. ΔE₁ is
    /// the excess of light sent once, and k̃ is the part of the light that a reflection leaves
    /// where occlusion is omitted. `None` if that is all of the light, or if the excess is too
    /// large for occlusion to be omitted.
    fn sent(&self, reflected: Reflected) -> Option<f64> {
        let albedo = self.sources.iter().map(|source| source.reflectance).fold(0.0, f64::max);
        let mut most = Taken::default();
        let mut sent = 0.0;
        for source in self.sources.iter().filter(|source| source.reflectance > 0.0) {
            let taken = self.taken(&Place::of_face(&self.transport.faces[source.face]));
            most.irradiance = most.irradiance.max(taken.irradiance);
            most.contraction = most.contraction.max(taken.contraction);
            let left = 1.0 - (reflected.contraction + most.contraction);
            sent = albedo / PI * most.irradiance / left;
            if left <= 0.0 || sent > self.most {
                return None;
            }
        }
        Some(sent)
    }

    /// Returns an upper bound on the excess of a reading where occlusion is omitted.
    pub(crate) fn taken_of(&self, reading: &Reading) -> f64 {
        let taken = |place: &Place| self.taken(place).irradiance;
        let most = reading.places(self.scene, self.transport).iter().map(taken).fold(0.0, f64::max);
        reading.of_irradiance(self.scene, self.transport) * most + reading.largest(self.transport) * self.sent
    }

    /// Returns an upper bound on the light that occluders take on its way to a place.
    fn taken(&self, place: &Place) -> Taken {
        let (faces, screens) = (&self.transport.faces, &self.transport.screens);
        let mut found = Vec::new();
        let mut taken = Taken::default();
        for source in &self.sources {
            let face = &faces[source.face];
            screens.between(&place.outline, place.normal, &face.vertices, face.normal, &mut found);
            let before: f64 = screens.fronts(&found).map(|front| solid_angle(&faces[front], place)).sum();
            let hidden = before.min(solid_angle(face, place));
            taken.irradiance += source.radiance * hidden;
            taken.contraction += source.reflectance * hidden / PI;
        }
        taken
    }
}

/// Returns an upper bound on the solid angle of a face from anywhere at a place.
fn solid_angle(face: &Face, place: &Place) -> f64 {
    let distance = distance(&face.vertices, place, face.normal);
    (face.area / (distance * distance)).min(2.0 * PI)
}

/// Returns a lower bound on the distance of an outline with this normal from a place: the widest
/// gap between the two, along either normal and along the line through their centres. Both lie in
/// the convex hulls of their corners, so a gap along any direction is a gap between them.
fn distance(outline: &[Vector], place: &Place, normal: Vector) -> f64 {
    let between_middles = (Vector::mean(outline) - Vector::mean(&place.outline)).unit();
    let gap = |along: Vector| {
        let range = |corners: &[Vector]| {
            let heights = corners.iter().map(|&corner| along.dot(corner));
            heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| [low.min(h), high.max(h)])
        };
        let ([low, high], [least, most]) = (range(outline), range(&place.outline));
        (low - most).max(least - high)
    };
    [Some(normal), place.normal, between_middles].into_iter().flatten().map(gap).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use crate::answer::Answer;
    use crate::plan::Plan;
    use crate::scene::{Effect, read};
    use crate::simulation::{Unwatched, plan, simulate};
    use forms_testing::scene_text::{material, point_receiver, polygon, surface, surface_receiver};

    /// Returns a floor, a lamp above it, and between them a plate of this size at this position.
    fn lamp_and_plate(reflectance: f64, size: f64, [x, y, z]: [f64; 3]) -> String {
        let square = |z: f64| [[-1.0, -1.0, z], [1.0, -1.0, z], [1.0, 1.0, z], [-1.0, 1.0, z]];
        let mut lamp = square(2.0);
        lamp.reverse();
        let plate = [[x, y, z], [x + size, y, z], [x + size, y + size, z + 0.1 * size]];
        [
            material("grey", reflectance),
            material("black", 0.0),
            surface("lamp", "grey", &(polygon(&lamp) + "\nexitance = 3")),
            surface("floor", "grey", &polygon(&square(0.0))),
            surface("plate", "black", &polygon(&plate)),
        ]
        .concat()
    }

    fn to_the_lamp() -> String {
        point_receiver("point", [0.3, 0.2, 0.1], [0.1, 0.0, 1.0]) + &surface_receiver("floor")
    }

    /// Returns a sphere receiver and a ray receiver. The ray meets the same surface with and
    /// without occlusion.
    fn to_all_sides() -> String {
        let sphere = "[[receiver]]\nname = \"sphere\"\nkind = \"sphere\"\nposition = [0.1, 0.2, 0.3]\n";
        let ray = "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.9, 0, 1]\ndirection = [-0.3, 0.2, -1]\n";
        [sphere, ray].concat()
    }

    /// Returns a point receiver that gets reflected light only, none of which is occluded.
    fn to_the_floor() -> String {
        point_receiver("down", [0.0, 0.0, 0.1], [0.0, 0.0, -1.0])
    }

    fn solved(text: &str) -> (Plan, Vec<Answer>) {
        let scene = read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let answers = simulate(&plan, &Unwatched).answers;
        (plan, answers)
    }

    fn occlusion(plan: &Plan) -> (bool, Option<f64>) {
        let planned = plan.effects.iter().find(|planned| planned.effect == Effect::Occlusion);
        planned.map_or((false, None), |planned| (planned.on, planned.bound))
    }

    #[test]
    fn obstacles_take_no_more_than_is_said() {
        let cases = [
            (0.0, 0.3, [0.1, 0.1, 1.0], to_the_lamp()),
            (0.0, 0.02, [0.4, 0.3, 0.5], to_the_lamp()),
            (0.5, 0.1, [0.0, 0.0, 1.1], to_all_sides()),
            (0.5, 0.02, [-0.4, 0.3, 0.9], to_the_lamp()),
            (0.5, 0.3, [-0.1, -0.1, 0.6], to_the_floor()),
        ];
        for (reflectance, size, place, receivers) in cases {
            let text = lamp_and_plate(reflectance, size, place) + &receivers;
            let forced = |force: &str| {
                let effects = format!("occlusion = \"{force}\", interreflection = \"on\", bands = \"on\"");
                solved(&format!("{text}[solve]\ntolerance = 1e-4\neffects = {{ {effects} }}\n"))
            };
            let [(without, open), (_, hidden)] = [forced("off"), forced("on")];
            let bound = occlusion(&without).1.expect("there is a bound");
            let changes = open.iter().zip(&hidden).map(|(open, hidden)| {
                let (change, rest) = ((open.value - hidden.value).abs(), open.error + hidden.error);
                assert!(change <= bound + rest, "{}: {change:e}, bound {bound:e}, {rest:e}", open.receiver);
                change
            });
            let most = changes.fold(0.0, f64::max);
            assert!(most > 0.0 && bound < 100.0 * most, "plate of {size}: {most:e}, bound {bound:e}");
        }
    }

    #[test]
    fn what_hides_less_than_the_tolerance_is_left_out() {
        for reflectance in [0.0, 0.5] {
            let plate = lamp_and_plate(reflectance, 0.01, [0.4, 0.3, 1.0]) + &to_the_lamp();
            for (tolerance, is_on) in [(1e-2, false), (1e-6, true)] {
                let (plan, answers) = solved(&format!("{plate}[solve]\ntolerance = {tolerance:?}\n"));
                let what = format!("reflectance {reflectance}, to {tolerance}");
                assert_eq!(occlusion(&plan).0, is_on, "{what}");
                assert!(is_on || answers.iter().all(|answer| answer.parts.effects > 0.0), "{what}");
            }
        }
    }

    #[test]
    fn shadows_of_other_light_than_that_of_surfaces_have_no_bound() {
        let plate = lamp_and_plate(0.0, 0.01, [0.4, 0.3, 1.0])
            + &to_the_lamp()
            + "[solve]\neffects = { occlusion = \"off\" }\n";
        let lights = [
            "",
            "[ambient]\nradiance = 1e-9\n",
            "[[light]]\nkind = \"point\"\nposition = [0, 0, 1.5]\nintensity = 1e-9\n",
        ];
        for light in lights {
            let (plan, _) = solved(&format!("{plate}{light}"));
            assert_eq!(occlusion(&plan).1.is_some(), light.is_empty(), "{light}");
        }
    }
}
