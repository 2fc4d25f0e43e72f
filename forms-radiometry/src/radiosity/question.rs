//! Requirements for a solution: what the receivers of a scene need.

use crate::effects::SimulatedEffects;
use crate::scene::{Effect, Receiver, ReceiverKind, Scene};
use forms_kernels::gathered_light::Effects as LightKinds;

/// Requirements for the solution.
#[derive(Clone, Debug)]
pub(crate) struct Question {
    /// Maximum number of reflections, if there is one; 0 if light is not reflected.
    pub(crate) orders: Option<u32>,
    /// Whether each surface is a receiver.
    pub(crate) receives: Vec<bool>,
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
            receives: receiving(scene),
            direct: effects.has(Effect::Direct),
            is_seen: asks_for_rays(scene),
        }
    }

    /// Returns the kinds of light that receivers gather if these are the kinds of direct light.
    pub(super) fn kinds(&self, straight: LightKinds) -> LightKinds {
        let straight = if self.direct { straight } else { LightKinds::NONE };
        LightKinds { interreflection: self.orders != Some(0), ..straight }
    }
}

/// Returns for each surface whether it is a receiver.
pub(crate) fn receiving(scene: &Scene) -> Vec<bool> {
    let mut receives = vec![false; scene.surfaces.len()];
    for receiver in &scene.receivers {
        if let ReceiverKind::Surface { surface, .. } = receiver.kind {
            receives[surface] = true;
        }
    }
    receives
}

/// Whether a receiver is a ray or a camera, which needs the first surface along rays.
pub(crate) fn asks_for_rays(scene: &Scene) -> bool {
    let is_seen =
        |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Ray { .. } | ReceiverKind::Camera(_));
    scene.receivers.iter().any(is_seen)
}
