//! Integrators: the number of light bounces of an `<integrator>` becomes a forced effect, or a limit on
//! the events along paths.

use super::object::Object;
use super::{Node, Reader};
use crate::scene::effect::{Effect, Force, ForcedEffect};
use crate::scene::model::{MaterialKind, Receiver, ReceiverKind, Solve, Surface};
use crate::scene::value::Domain;
use std::ops::Range;

const KINDS: [&str; 4] = ["path", "direct", "volpath", "volpathmis"];
/// Integrators that compute further quantities next to the radiance of another integrator.
const WRAPPERS: [&str; 3] = ["aov", "moment", "stokes"];
/// Properties that only affect the run time of the integrator.
const IGNORED: [&str; 7] = [
    "rr_depth",
    "shading_samples",
    "emitter_samples",
    "bsdf_samples",
    "samples_per_pass",
    "block_size",
    "timeout",
];
const DEPTH: Domain = Domain {
    expected: "-1 for no limit, or an integer of at least 1",
    contains: |x| x.fract() == 0.0 && (x == -1.0 || (1.0..=1e9).contains(&x)),
};

/// Limits of an integrator.
pub(super) struct Integrator {
    /// The longest path from the lamp to the eye; `None` if there is no limit.
    depth: Option<u32>,
    follows_media: bool,
    hides_emitters: bool,
    is_polarised: bool,
    place: Range<usize>,
}

impl<'a> Reader<'a, '_, '_> {
    pub(super) fn integrator(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        if WRAPPERS.contains(&&*object.kind) {
            self.wrapper(object);
            return;
        }
        if !KINDS.contains(&&*object.kind) {
            let known: Vec<&str> = KINDS.into_iter().chain(WRAPPERS).collect();
            self.unknown(&mut object, &known);
            return;
        }
        if self.integrator.is_some() {
            self.error(node, "more than one integrator", "one");
        }
        let default = if object.kind == "direct" { 2.0 } else { -1.0 };
        let depth = self.float(&mut object, "max_depth", default, &DEPTH);
        let hides_emitters = self.boolean(&mut object, "hide_emitters", false, false);
        object.ignore(&IGNORED);
        let follows_media = object.kind.starts_with("volpath");
        self.finish(object, &["max_depth", "rr_depth", "hide_emitters"]);
        let depth = (depth > 0.0).then_some(depth as u32);
        self.integrator = Some(Integrator {
            depth,
            follows_media,
            hides_emitters,
            is_polarised: false,
            place: node.range(),
        });
    }

    /// Reads the integrator within another one.
    fn wrapper(&mut self, mut object: Object<'a>) {
        let node = object.node;
        let is_nested = node.parent().is_some_and(|parent| parent.has_tag_name("integrator"));
        match self.take_object(&mut object, "integrator") {
            // integrators that refer to each other could go round in circles
            Some(inner)
                if WRAPPERS.contains(&&*self.kind(inner)) && (is_nested || inner.parent() != Some(node)) =>
            {
                let message = "integrators are only supported within each other up to three deep";
                self.error(node, message, "an integrator that traces paths");
            }
            Some(inner) => self.integrator(inner),
            None => self.error(node, "this integrator contains no integrator", "one integrator"),
        }
        if object.kind == "stokes"
            && let Some(integrator) = &mut self.integrator
        {
            integrator.is_polarised = true;
        }
        object.ignore(&["aovs"]);
        object.ignore(&IGNORED);
        self.finish(object, &["integrator"]);
    }

    /// Returns the settings that the integrator implies.
    pub(super) fn solve(&mut self) -> Solve {
        let Some(integrator) = self.integrator.take() else { return Solve::default() };
        self.check_integrator(&integrator);
        let Integrator { depth: Some(depth), place, .. } = integrator else { return Solve::default() };
        self.limited(depth, place)
    }

    fn check_integrator(&mut self, integrator: &Integrator) {
        let place = || integrator.place.clone();
        if self.has_media() && !integrator.follows_media {
            let message = "this integrator ignores the participating media of the scene";
            self.report.error(place(), message, "an integrator of type `volpath`");
        }
        let has_visible_emitters = self.surfaces.iter().any(Surface::emits) || self.outside.is_some();
        if integrator.hides_emitters && has_visible_emitters {
            let message = "emitters hidden from the camera are not supported";
            self.report.error(place(), message, "hide_emitters = false");
        }
        if integrator.is_polarised && !self.is_diffuse() {
            let message = "polarised light is only supported for diffuse surfaces, which depolarise it";
            self.report.error(place(), message, "an integrator of type `path`");
        }
    }

    fn is_diffuse(&self) -> bool {
        self.materials.iter().all(|material| matches!(material.kind, MaterialKind::Diffuse { .. }))
    }

    /// Returns the settings that limit the depth of paths. A path of depth d has d − 1 events between
    /// the lamp and the sensor. Where all of them are diffuse reflections, they are orders of
    /// interreflection: the last one is towards a camera, but before an irradiance meter, which is a
    /// surface itself.
    fn limited(&mut self, depth: u32, place: Range<usize>) -> Solve {
        let is_camera = |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Camera(_));
        let cameras = self.receivers.iter().filter(|receiver| is_camera(receiver)).count();
        let has_both = 0 < cameras && cameras < self.receivers.len();
        if self.has_media() || !self.is_diffuse() || has_both {
            return Solve { events: Some(depth - 1), ..Solve::default() };
        }
        let has_only_cameras = cameras == self.receivers.len();
        if depth == 1 && cameras > 0 {
            self.without_reflection();
        }
        let orders = depth.saturating_sub(if has_only_cameras { 2 } else { 1 });
        let force = if orders == 0 { Force::Off } else { Force::Orders(orders) };
        let place = self.report.place(place);
        let forced = vec![ForcedEffect { effect: Effect::Interreflection, force, place }];
        Solve { forced, ..Solve::default() }
    }

    /// Makes all surfaces black: light that is never reflected reaches a camera only straight from
    /// an emitter.
    fn without_reflection(&mut self) {
        self.report.note("`max_depth` = 1 is read as black surfaces: a camera sees emitters only".to_owned());
        for material in &mut self.materials {
            if let MaterialKind::Diffuse { reflectance } = &mut material.kind {
                reflectance.fill(0.0);
            }
        }
    }
}
