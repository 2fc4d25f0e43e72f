//! Kernels of path tracing: one table maps the effects of a scene to the kernels that its paths
//! run.

use crate::effects::EffectSet;
use crate::scene::{Effect, MaterialKind, Receiver, ReceiverKind, Scene, Shape};
use crate::used_kernel::UsedKernel;
use forms_kernels::{
    basic_radiance, cosine_hemisphere_pdf, cosine_hemisphere_sample, equiangular_pdf, equiangular_sample,
    free_flight_pdf, free_flight_sample, fresnel_conductor, fresnel_dielectric, henyey_greenstein,
    henyey_greenstein_direction_sample, measure_area_to_solid_angle, measure_solid_angle_to_area,
    spherical_triangle_pdf, spherical_triangle_sample, transmittance, uniform_cone_pdf, uniform_cone_sample,
    uniform_disk_sample, uniform_sphere_pdf, uniform_sphere_sample, uniform_triangle_sample,
};

/// Whether a material reflects diffusely.
fn reflects(kind: &MaterialKind) -> bool {
    match kind {
        MaterialKind::Diffuse { reflectance } | MaterialKind::Plastic { reflectance, .. } => {
            reflectance.iter().any(|&rho| rho > 0.0)
        }
        MaterialKind::Rough(rough) => rough.base.iter().any(|&rho| rho > 0.0),
        MaterialKind::Mirror { .. } | MaterialKind::Dielectric { .. } | MaterialKind::Conductor { .. } => {
            false
        }
    }
}

/// Returns the kernels that the paths of a scene run, and those that evaluate the analytic
/// receivers.
pub(crate) fn kernels(scene: &Scene, is_computed: &dyn Fn(&Receiver) -> bool) -> Vec<UsedKernel> {
    let effects = EffectSet::of_scene(scene);
    let materials = || scene.surfaces.iter().map(|surface| &scene.materials[surface.material].kind);
    let sampled = || scene.receivers.iter().filter(|receiver| !is_computed(receiver));
    let (samples, computes) = (sampled().next().is_some(), scene.receivers.iter().any(is_computed));
    let emits = |is: fn(&Shape) -> bool| scene.surfaces.iter().any(|s| s.emits() && is(&s.shape));
    let shines = |is: fn(&Shape) -> bool| samples && emits(is);
    let asks = |is: fn(&ReceiverKind) -> bool| sampled().any(|receiver| is(&receiver.kind));
    let is_flat = |shape: &Shape| matches!(shape, Shape::Polygon(_) | Shape::Mesh(_));
    let planes = (samples && materials().any(reflects))
        || asks(|kind| kind.is_irradiance_at_points() || kind.side().is_some());
    let surfaces = asks(|kind| kind.side().is_some());
    let spheres = asks(ReceiverKind::is_all_around);
    let metals = materials().any(|kind| matches!(kind, MaterialKind::Conductor { .. }));
    let coats = materials().any(|kind| matches!(kind, MaterialKind::Plastic { .. }));
    let (triangles, disks) = (shines(is_flat), shines(|shape| matches!(shape, Shape::Disk(_))));
    let balls = shines(|shape| matches!(shape, Shape::Sphere(_)));
    let [absorption, scattering, refraction] =
        [Effect::Absorption, Effect::Scattering, Effect::Refraction].map(|effect| effects.has(effect));
    let scatters_once = computes && scattering;
    macro_rules! row {
        ($is_used:expr, $name:ident, $what:literal) => {
            ($is_used).then(|| UsedKernel::whole(stringify!($name), $name::OPERATIONS, $what))
        };
    }
    let table = [
        row!(planes, cosine_hemisphere_sample, "cosine-weighted directions from surfaces and receivers"),
        row!(planes, cosine_hemisphere_pdf, "their density"),
        row!(spheres || balls, uniform_sphere_sample, "uniform directions, and points on spheres"),
        row!(spheres, uniform_sphere_pdf, "their density"),
        row!(triangles, spherical_triangle_sample, "directions to flat emitters"),
        row!(triangles, spherical_triangle_pdf, "their density"),
        row!(disks, uniform_disk_sample, "points on disk emitters"),
        row!(balls, uniform_cone_sample, "directions to spherical emitters"),
        row!(balls, uniform_cone_pdf, "their density"),
        row!(
            disks || balls,
            measure_solid_angle_to_area,
            "densities of directions to disk and spherical emitters"
        ),
        row!(disks || balls, measure_area_to_solid_angle, "the same for directions of another technique"),
        row!(
            (computes && emits(is_flat)) || scatters_once,
            measure_area_to_solid_angle,
            "direct light of flat emitters, or of point lights on a ray"
        ),
        row!(surfaces || (triangles && scattering), uniform_triangle_sample, "points on flat surfaces"),
        row!(absorption || scattering, transmittance, "transmittance of media"),
        row!(samples && scattering, free_flight_sample, "free-flight distances"),
        row!(samples && scattering, free_flight_pdf, "their density"),
        row!(samples && scattering, equiangular_sample, "equiangular distances about an emitter"),
        row!(samples && scattering, equiangular_pdf, "their density"),
        row!(scattering, henyey_greenstein, "phase function"),
        row!(samples && scattering, henyey_greenstein_direction_sample, "directions of scattered light"),
        row!(refraction || coats, fresnel_dielectric, "reflectance of boundaries"),
        row!(refraction, basic_radiance, "radiance in another index"),
        row!(metals, fresnel_conductor, "reflectance of metals"),
    ];
    table.into_iter().flatten().collect()
}
