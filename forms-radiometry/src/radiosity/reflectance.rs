//! Diffuse reflectance of surfaces and faces.

use crate::faces::is_bright;
use crate::scene::Scene;
use crate::visibility::Face;

/// Whether a surface reflects light in any band.
pub(super) fn reflects(scene: &Scene, surface: usize) -> bool {
    reflectance(scene, surface).iter().any(|&rho| rho > 0.0)
}

/// Whether a face reflects the light that it receives.
pub(crate) fn is_reflecting(scene: &Scene, face: &Face) -> bool {
    is_bright(scene, face) && reflects(scene, face.surface)
}

/// Returns the diffuse reflectance of a surface, for each band; of a rough surface or one with a texture,
/// a bound.
pub(crate) fn reflectance(scene: &Scene, surface: usize) -> &[f64] {
    scene.materials[scene.surfaces[surface].material].kind.diffuse_reflectance()
}
