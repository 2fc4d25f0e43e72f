//! Kernels of radiometry, each generated from a formula with a proof: solid angles, form factors and
//! view factors, transmittance and scattering, reflection, sampling densities with their warps.
//!
//! Each file of the folder `kernels` declares the forms and maps from which its kernels are made,
//! and proves the claims that they rely on; a false claim does not compile. All kernels are pure
//! functions of scalars, in the units of the caller. Next to each function is a module of its name
//! with its other forms: batches, wider arithmetic, intervals of error. [`library()`] returns the
//! source text of these files, and [`theory()`] that of the identities of radiometry.
//!
//! ```
//! // one octant of the sphere of directions, seen from the origin
//! let octant = forms_kernels::solid_angle_triangle(
//!     0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0,
//! );
//! assert!((octant - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
//! ```

mod library;

pub use library::{RADIANCE, TheoryFile, library, theory};

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
