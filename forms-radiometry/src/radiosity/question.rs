//! Requirements of the receivers of a scene for a solution.

use crate::effects::SimulatedEffects;
use crate::scene::{Effect, Receiver, ReceiverKind, Scene};
use crate::visibility::{Face, ReceivingArea};
use forms_kernels::gathered_light::Effects as LightKinds;
use rustc_hash::FxHashSet;

/// Requirements for the solution.
#[derive(Clone, Debug)]
pub(crate) struct Question {
    /// Maximum number of reflections, if there is one; 0 if light is not reflected.
    pub(crate) orders: Option<u32>,
    /// Areas over which receivers integrate.
    pub(crate) receives: ReceivingAreas,
    /// Whether receivers get direct light.
    pub(crate) direct: bool,
    /// Whether rays or cameras look at surfaces.
    pub(crate) is_seen: bool,
}

impl Question {
    /// Returns the requirements of the receivers of a scene, with these effects.
    pub(crate) fn of(scene: &Scene, effects: &SimulatedEffects) -> Self {
        Self {
            orders: effects.orders,
            receives: ReceivingAreas::of(scene),
            direct: effects.has(Effect::Direct),
            is_seen: asks_for_rays(scene),
        }
    }

    /// Returns the kinds of light that receivers gather if these are the kinds of direct light.
    pub(super) fn kinds(&self, straight: LightKinds) -> LightKinds {
        let straight = if self.direct { straight } else { LightKinds::NONE };
        self.seen_kinds(straight)
    }

    /// Returns the part of the light of sources that an eye gets from them: 0 without direct light.
    pub(super) fn seen_part(&self) -> f64 {
        if self.direct { 1.0 } else { 0.0 }
    }

    /// Returns the kinds of light that seen surfaces gather if these are the kinds of direct light:
    /// the light of a source is direct to the eye that sees the source, and not where a surface
    /// reflects it to the eye.
    pub(super) fn seen_kinds(&self, straight: LightKinds) -> LightKinds {
        LightKinds { interreflection: self.orders != Some(0), ..straight }
    }
}

/// The areas over which the receivers of a scene integrate.
#[derive(Clone, Debug)]
pub(crate) struct ReceivingAreas {
    /// Each area once.
    areas: Vec<ReceivingArea>,
    /// Whether the front and the back of each surface contain any of them.
    sides: Vec<[bool; 2]>,
}

impl ReceivingAreas {
    pub(crate) fn of(scene: &Scene) -> Self {
        let (mut areas, mut known) = (Vec::new(), FxHashSet::default());
        let mut sides = vec![[false; 2]; scene.surfaces.len()];
        for area in scene.receiving_areas().filter(|&area| known.insert(area)) {
            areas.push(area);
            sides[area.surface][usize::from(area.is_back)] = true;
        }
        Self { areas, sides }
    }

    /// Returns the areas, each once.
    pub(crate) fn all(&self) -> &[ReceivingArea] {
        &self.areas
    }

    /// Whether a face is part of any of them. A receiver measures all faces of a side, or none.
    pub(crate) fn have(&self, face: &Face) -> bool {
        self.sides[face.surface][usize::from(face.is_back)]
    }
}

/// Whether a receiver is a ray or a camera, which needs the first surface along rays.
pub(crate) fn asks_for_rays(scene: &Scene) -> bool {
    let is_seen =
        |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Ray { .. } | ReceiverKind::Camera(_));
    scene.receivers.iter().any(is_seen)
}
