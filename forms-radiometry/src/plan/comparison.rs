//! Comparison: the expected costs of radiosity and of path tracing decide between them where both
//! can find the answers.
//!
//! ```text
//! scene ─┬─ elements, views of faces ─▶ cost of radiosity ─┐
//!        └─ a few paths ─▶ rays for the tolerance ─────────┴▶ the solver that costs less
//! ```
//! The cost of radiosity is that of pairs of elements, that of path tracing the number of samples
//! until they agree: neither follows from the contents of a scene alone. Both are predicted in the
//! same unit, the cost of a ray, by [`expected_cost`] and [`expected_rays`].

use super::working_scene::SimulatedScene;
use crate::effects::{Hiding, SimulatedEffects};
use crate::faces::is_round;
use crate::paths::driver::{Computable, ExpectedRays, expected_rays};
use crate::paths::{Limits, World};
use crate::radiosity::{Question, expected_cost};
use crate::scene::{Receiver, ReceiverKind};
use std::sync::Arc;

/// Cost of radiosity, in rays, below which it is not compared with that of path tracing: about a
/// second, and some seconds for images, whose pixels are worth waiting for without noise.
const SMALL: f64 = 1e6;
const SMALL_IMAGE: f64 = 1e7;

/// Number of faces beyond which they are not kept together with the world of paths: there is no room
/// for both, and to build them again takes little of the time of a solution.
const CROWDED: usize = 200_000;

/// Returns the world in which paths are traced, the receivers that need no samples, and the reason,
/// if path tracing is expected to cost less than radiosity. Direct light at points has closed
/// forms there, too, unless these cost more than samples.
pub(super) fn cheaper_paths(
    simulated: &mut SimulatedScene,
    computable: Computable,
) -> Option<(Arc<World>, Computable, String)> {
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    if !may_be_by_paths(effects) {
        return None;
    }
    let question = Question::of(scene, effects);
    let expected = expected_cost(scene, &question, effects.hiding, simulated.first_faces());
    let small = if scene.receivers.iter().any(is_image) { SMALL_IMAGE } else { SMALL };
    if expected.solution <= small {
        return None;
    }
    if expected.solution.is_infinite() || simulated.first_faces().faces(scene).len() > CROWDED {
        simulated.forget_faces();
    }
    let (scene, effects) = (simulated.scene(), &simulated.effects);
    let world = world_of(simulated);
    let ExpectedRays { rays, values } = expected_rays(simulated.task(&world, computable), expected.solution)?;
    let reason = if expected.solution.is_infinite() {
        "exact visibility would need too many elements"
    } else if expected.solution > rays {
        "paths are expected to take less time than exact visibility"
    } else {
        return None;
    };
    let is_straight = effects.orders == Some(0) && Limits::of(effects).direct && !is_round(scene);
    let computable = match is_straight && expected.point <= rays / values as f64 {
        true => computable.with_straight(),
        false => computable,
    };
    Some((world, computable, reason.to_owned()))
}

/// Whether a scene of diffuse surfaces in a vacuum may be solved by path tracing. Paths always
/// account for occlusion: they are not traced where it is omitted. They are not needed where all
/// light has closed forms.
fn may_be_by_paths(effects: &SimulatedEffects) -> bool {
    match effects.hiding {
        Hiding::LeftOut => false,
        Hiding::Nothing if effects.orders == Some(0) => false,
        Hiding::Nothing | Hiding::Simulated => true,
    }
}

pub(super) fn is_image(receiver: &Receiver) -> bool {
    matches!(receiver.kind, ReceiverKind::Camera(_))
}

pub(super) fn world_of(simulated: &SimulatedScene) -> Arc<World> {
    Arc::new(World::new(simulated.shared_scene()))
}
