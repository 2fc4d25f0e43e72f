//! The warps and densities of paths, without the guard that limits their error to a few units in
//! the last place.
//!
//! A sample is one of many: its rounding error is at most 10⁻¹⁰ of the spread. The guard would
//! remove it by recomputing the sample in higher precision where a triangle is wide or thin. A slab
//! below a light source a thousand times as wide takes 20 times as long with the guard.

pub(super) use forms_kernels::cosine_hemisphere_pdf::unguarded as cosine_hemisphere_pdf;
pub(crate) use forms_kernels::cosine_hemisphere_sample::unguarded as cosine_hemisphere_sample;
pub(super) use forms_kernels::equiangular_pdf::unguarded as equiangular_pdf;
pub(super) use forms_kernels::equiangular_sample::unguarded as equiangular_sample;
pub(super) use forms_kernels::free_flight_pdf::unguarded as free_flight_pdf;
pub(super) use forms_kernels::free_flight_sample::unguarded as free_flight_sample;
pub(super) use forms_kernels::fresnel_conductor::unguarded as fresnel_conductor;
pub(super) use forms_kernels::fresnel_dielectric::unguarded as fresnel_dielectric;
pub(super) use forms_kernels::ggx_visible_sample::unguarded as ggx_visible_sample;
pub(super) use forms_kernels::henyey_greenstein::unguarded as henyey_greenstein;
pub(super) use forms_kernels::henyey_greenstein_direction_sample::unguarded as henyey_greenstein_direction_sample;
pub(super) use forms_kernels::spherical_triangle_pdf::unguarded as spherical_triangle_pdf;
pub(super) use forms_kernels::spherical_triangle_sample::unguarded as spherical_triangle_sample;
pub(super) use forms_kernels::uniform_cone_pdf::unguarded as uniform_cone_pdf;
pub(super) use forms_kernels::uniform_cone_sample::unguarded as uniform_cone_sample;
pub(crate) use forms_kernels::uniform_disk_sample::unguarded as uniform_disk_sample;
pub(super) use forms_kernels::uniform_sphere_pdf::unguarded as uniform_sphere_pdf;
pub(crate) use forms_kernels::uniform_sphere_sample::unguarded as uniform_sphere_sample;
pub(super) use forms_kernels::uniform_triangle_sample::unguarded as uniform_triangle_sample;
