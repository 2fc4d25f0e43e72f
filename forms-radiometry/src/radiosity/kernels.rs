//! Kernels of a scene: one table maps the contents of a scene, and the effects that are simulated,
//! to the kernels that run.
//!
//! ```text
//! scene, faces, question ─▶ required computations ─▶ the rows of the table that perform them
//! ```
//! If a kernel has effects, its specialisation without the effects that the scene does not need is
//! used, as [`arriving`](super::gathered_light) selects it.

use super::direct::kinds;
use super::question::Question;
use super::reflectance::is_reflecting;
use crate::scene::{ReceiverKind, Scene, Shape, Surface};
use crate::used_kernel::UsedKernel;
use crate::visibility::Face;
use forms_kernels::gathered_light::Effects as LightKinds;
use forms_kernels::{
    edge_form_factor, edge_potential, exchange_density, form_factor_beside_disk, form_factor_point_disk,
    form_factor_point_sphere, irradiance, solid_angle_disk, solid_angle_sphere, solid_angle_triangle,
};

/// Computations that a scene requires.
struct Computed {
    /// The kinds of light that receivers gather by exact pieces, if any receiver does.
    gathered: Option<LightKinds>,
    /// The kinds of light that surfaces send on to rays and cameras, if light straight from light
    /// sources to these does not count.
    seen: Option<LightKinds>,
    /// The kinds of direct light at the points of surfaces that reflect or whose mean is computed,
    /// if there are any.
    straight: Option<LightKinds>,
    /// Whether points see faces that send light.
    views: bool,
    /// Whether receivers look in all directions.
    spheres: bool,
    /// Whether light is exchanged between elements by exact pieces.
    reflections: bool,
    /// Whether points can see spheres and disks as a whole.
    whole: [bool; 2],
    /// Whether the light of faces is integrated over surfaces.
    exchange: bool,
}

impl Computed {
    fn of(scene: &Scene, faces: &[Face], question: &Question, is_precise: bool) -> Self {
        let straight = kinds(scene, faces);
        let reflected = question.orders != Some(0) && faces.iter().any(|f| is_reflecting(scene, f));
        let asks = |is: fn(&ReceiverKind) -> bool| scene.receivers.iter().any(|receiver| is(&receiver.kind));
        let asks_points = asks(|kind| kind.is_irradiance_at_points() || kind.is_all_around());
        let asks_elsewhere = asks(|kind| match kind {
            ReceiverKind::Point { .. } | ReceiverKind::Points(_) | ReceiverKind::Sphere { .. } => false,
            ReceiverKind::Surface { grid, .. } => grid.is_some(),
            ReceiverKind::Faces { .. } => false,
            ReceiverKind::Ray { .. } | ReceiverKind::Camera(_) => false,
        });
        // the closed forms for points add up light in double-double, without the kernel
        let gathers = asks_elsewhere || (question.is_seen && question.direct) || (asks_points && !is_precise);
        let on_surfaces = !question.receives.all().is_empty();
        let has_points = on_surfaces || reflected;
        let from_faces = straight.luminaires || (straight.surroundings && !faces.is_empty());
        let is_straight = question.orders == Some(0);
        let is_seen = |surface: &Surface| straight.surroundings || surface.emits();
        let shines = |is: fn(&Shape) -> bool| {
            scene.surfaces.iter().any(|surface| is(&surface.shape) && is_seen(surface))
        };
        let is_whole = |is| is_straight && asks_points && shines(is);
        Self {
            whole: [
                is_whole(|shape| matches!(shape, Shape::Sphere(_))),
                is_whole(|shape| matches!(shape, Shape::Disk(_))),
            ],
            gathered: gathers.then(|| question.kinds(straight)),
            seen: (question.is_seen && !question.direct).then(|| question.seen_kinds(straight)),
            straight: has_points.then_some(straight),
            views: reflected || (from_faces && (question.direct || has_points || question.is_seen)),
            spheres: asks(ReceiverKind::is_all_around),
            reflections: reflected,
            exchange: on_surfaces && from_faces && !straight.surroundings && !straight.beams,
        }
    }
}

/// Returns the kernels that the simulation of a scene with these faces runs. They depend on whether
/// direct light at points [is computed to the last digit](super::is_precise).
pub(crate) fn kernels(
    scene: &Scene,
    faces: &[Face],
    question: &Question,
    is_precise: bool,
) -> Vec<UsedKernel> {
    let Computed { gathered, seen, straight, views, spheres, reflections, whole, exchange } =
        Computed::of(scene, faces, question, is_precise);
    let [whole_spheres, whole_disks] = whole;
    let all_light = gathered.map(|kinds| member(kinds, "light gathered by a receiver"));
    let seen_light = seen.map(|kinds| member(kinds, "light gathered by a surface that is seen"));
    let is_another = straight.filter(|straight| ![gathered, seen].contains(&Some(*straight)));
    let direct_light = is_another.map(|kinds| member(kinds, "direct light at points of surfaces"));
    macro_rules! row {
        ($is_used:expr, $name:ident, $what:literal) => {
            ($is_used).then(|| UsedKernel::whole(stringify!($name), $name::OPERATIONS, $what))
        };
    }
    let table = [
        all_light,
        seen_light,
        direct_light,
        row!(views, edge_form_factor, "form factor of the visible part of a face, edge by edge"),
        row!(views && spheres, solid_angle_triangle, "solid angle of the visible part of a face"),
        row!(whole_spheres, form_factor_point_sphere, "form factor of a whole sphere"),
        row!(whole_spheres && spheres, solid_angle_sphere, "solid angle of a whole sphere"),
        row!(whole_disks, form_factor_point_disk, "form factor of a whole disk, along its axis"),
        row!(whole_disks, form_factor_beside_disk, "form factor of a whole disk, across its axis"),
        row!(whole_disks && spheres, solid_angle_disk, "solid angle of a whole disk"),
        row!(reflections || exchange, exchange_density, "light exchanged between points of two surfaces"),
        row!(exchange, edge_potential, "light from surface to surface, edge by edge"),
        row!(exchange, irradiance, "irradiance from an emitter by its form factor"),
    ];
    table.into_iter().flatten().collect()
}

/// Returns the specialisation of the kernel that gathers these kinds of light.
fn member(kinds: LightKinds, what: &'static str) -> UsedKernel {
    let LightKinds { luminaires, surroundings, beams, interreflection } = kinds;
    let effects = [
        ("luminaires", luminaires),
        ("surroundings", surroundings),
        ("beams", beams),
        ("interreflection", interreflection),
    ];
    UsedKernel {
        name: "gathered_light",
        without: effects.into_iter().filter(|(_, is_on)| !is_on).map(|(name, _)| name).collect(),
        operations: kinds.operations(),
        operations_of_all: LightKinds::ALL.operations(),
        what,
    }
}
