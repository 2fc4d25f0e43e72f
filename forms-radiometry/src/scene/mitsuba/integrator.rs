//! Integrators: the number of light bounces of an `<integrator>` becomes a forced effect.

use super::{Node, Reader};
use crate::scene::effect::{Effect, Force, ForcedEffect};
use crate::scene::model::{MaterialKind, Receiver, ReceiverKind};
use crate::scene::value::Domain;
use std::ops::Range;

const KINDS: [&str; 4] = ["path", "direct", "volpath", "volpathmis"];
/// Properties that only affect the run time of the integrator.
const IGNORED: [&str; 4] = ["rr_depth", "shading_samples", "emitter_samples", "bsdf_samples"];
const DEPTH: Domain = Domain {
    expected: "-1 for no limit, or an integer of at least 2",
    contains: |x| x.fract() == 0.0 && (x == -1.0 || (2.0..=1e9).contains(&x)),
};

/// Limits of an integrator.
pub(super) struct Integrator {
    /// The longest path from the lamp to the eye; `None` if there is no limit.
    depth: Option<u32>,
    follows_media: bool,
    place: Range<usize>,
}

impl<'a> Reader<'a, '_, '_> {
    pub(super) fn integrator(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        if !KINDS.contains(&&*object.kind) {
            self.unknown(&mut object, &KINDS);
            return;
        }
        if self.integrator.is_some() {
            self.error(node, "more than one integrator", "one");
        }
        let default = if object.kind == "direct" { 2.0 } else { -1.0 };
        let depth = self.float(&mut object, "max_depth", default, &DEPTH);
        if self.boolean(&mut object, "hide_emitters", false, false) {
            self.error(node, "emitters hidden from the camera are not supported", "hide_emitters = false");
        }
        object.ignore(&IGNORED);
        let follows_media = object.kind.starts_with("volpath");
        self.finish(object, &["max_depth", "rr_depth", "hide_emitters"]);
        let depth = (depth > 0.0).then_some(depth as u32);
        self.integrator = Some(Integrator { depth, follows_media, place: node.range() });
    }

    /// Returns the forced effects. A path of depth d from a lamp to a camera is reflected d − 1
    /// times, the last time towards the camera. A path to an irradiance meter, which is a surface
    /// itself, is reflected d − 1 times before it. All reflections must be diffuse.
    pub(super) fn forced(&mut self) -> Vec<ForcedEffect> {
        let Some(Integrator { depth, follows_media, place }) = self.integrator.take() else {
            return Vec::new();
        };
        if self.has_media() && !follows_media {
            let message = "this integrator ignores the participating media of the scene";
            self.report.error(place.clone(), message, "an integrator of type `volpath`");
        }
        let Some(depth) = depth else { return Vec::new() };
        let is_diffuse = |kind: &MaterialKind| matches!(kind, MaterialKind::Diffuse { .. });
        if self.has_media() || !self.materials.iter().all(|material| is_diffuse(&material.kind)) {
            let message =
                "a limit on path depth (`max_depth`) is only supported for diffuse surfaces without media";
            self.report.error(place, message, "max_depth = -1");
            return Vec::new();
        }
        let is_camera = |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Camera(_));
        let cameras = self.receivers.iter().filter(|receiver| is_camera(receiver)).count();
        if 0 < cameras && cameras < self.receivers.len() {
            let message = "a limit on path depth (`max_depth`) means one reflection fewer for a camera \
                           than for an irradiance meter";
            self.report.error(place, message, "max_depth = -1, or sensors of one kind");
            return Vec::new();
        }
        let orders = if cameras == self.receivers.len() { depth - 2 } else { depth - 1 };
        let force = if orders == 0 { Force::Off } else { Force::Orders(orders) };
        vec![ForcedEffect { effect: Effect::Interreflection, force, place: self.report.place(place) }]
    }
}
