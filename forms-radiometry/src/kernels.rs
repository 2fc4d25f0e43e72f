//! The library's kernels: every light-transport formula of this crate is generated code with a
//! proof.
//!
//! Each file declares the forms and maps from which a kernel is made, and proves the claims that
//! the kernel relies on; a false claim there does not compile. All kernels are pure functions of
//! scalars, in the units of the caller.

forms::include_forms!("kernels/solid_angle.forms");
forms::include_forms!("kernels/irradiance.forms");
forms::include_forms!("kernels/gathered_light.forms");
forms::include_forms!("kernels/polygon_solid_angle.forms");
forms::include_forms!("kernels/round_solid_angle.forms");
forms::include_forms!("kernels/polygon_form_factor.forms");
forms::include_forms!("kernels/round_form_factor.forms");
forms::include_forms!("kernels/linear_luminaire.forms");
forms::include_forms!("kernels/rectangle_view_factor.forms");
forms::include_forms!("kernels/disk_view_factor.forms");
forms::include_forms!("kernels/sphere_view_factor.forms");
forms::include_forms!("kernels/exchange.forms");
forms::include_forms!("kernels/reflection.forms");
forms::include_forms!("kernels/reconnection.forms");
forms::include_forms!("kernels/transport.forms");
forms::include_forms!("kernels/single_scattering.forms");
forms::include_forms!("kernels/airlight.forms");
forms::include_forms!("kernels/chandrasekhar.forms");
forms::include_forms!("kernels/fresnel.forms");
forms::include_forms!("kernels/phase_function.forms");
forms::include_forms!("kernels/planck.forms");
forms::include_forms!("kernels/warps_uniform.forms");
forms::include_forms!("kernels/warps_microfacet.forms");
forms::include_forms!("kernels/warps_axis.forms");
forms::include_forms!("kernels/warps_distance.forms");
forms::include_forms!("kernels/warps_spherical_triangle.forms");
forms::include_forms!("kernels/warps_spherical_rectangle.forms");
