//! Choice of the solver: path tracing, or radiosity for the scene as a whole.

use super::survey::MANY;
use crate::faces::{faces, is_round};
use crate::scene::{MaterialKind, Medium, Receiver, ReceiverKind, Scene};

/// Whether a scene needs path tracing. It does unless it has only diffuse surfaces in a vacuum,
/// with numbers and maps of them, and with images only of flat surfaces with few faces.
pub(crate) fn is_by_paths(scene: &Scene) -> bool {
    let is_diffuse = |kind: &MaterialKind| matches!(kind, MaterialKind::Diffuse { .. });
    let ambient = scene.ambient.medium.map(|medium| &scene.media[medium]);
    let is_image = |receiver: &Receiver| matches!(receiver.kind, ReceiverKind::Camera(_));
    !(scene.surfaces.iter().all(|surface| is_diffuse(&scene.materials[surface.material].kind))
        && scene.receivers.iter().all(|receiver| receiver.time.is_none())
        && ambient.is_none_or(Medium::is_vacuum))
        || (scene.receivers.iter().any(is_image) && (is_round(scene) || faces(scene, 0).len() > MANY))
}
