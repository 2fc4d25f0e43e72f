//! Source text of the theory and of the kernels that ship with the library.

/// A source file in the forms language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TheoryFile {
    /// File name.
    pub name: &'static str,
    /// Source text.
    pub text: &'static str,
    /// Text of the file that records the forms chosen for the kernels, if there is one.
    pub choices: Option<&'static str>,
}

/// A file of the folder `theory`.
macro_rules! theory_file {
    ($name:literal) => {
        TheoryFile { name: $name, text: include_str!(concat!("../theory/", $name)), choices: None }
    };
}

/// The identities of Lessig, Fiume and Desbrun, *On the Mathematical Formulation of Radiance*,
/// numbered as in the paper. `refute … as_printed` marks equations that are wrong as printed.
pub const RADIANCE: TheoryFile = theory_file!("radiance.forms");

/// Returns the theory: one file for each topic, from the definitions of the quantities to sampling
/// densities. Every statement has a name, an explanation and a source.
pub fn theory() -> &'static [TheoryFile] {
    &[
        theory_file!("quantities.forms"),
        theory_file!("units.forms"),
        theory_file!("lambert.forms"),
        theory_file!("photons.forms"),
        theory_file!("sun.forms"),
        theory_file!("poynting.forms"),
        RADIANCE,
        theory_file!("vector_irradiance.forms"),
        theory_file!("rays.forms"),
        theory_file!("refraction.forms"),
        theory_file!("etendue.forms"),
        theory_file!("density_transport.forms"),
        theory_file!("transport_equation.forms"),
        theory_file!("radiance_operators.forms"),
        theory_file!("neumann_series.forms"),
        theory_file!("light_traps.forms"),
        theory_file!("bsdf.forms"),
        theory_file!("jacobians.forms"),
        theory_file!("sampling.forms"),
    ]
}

/// A file of the folder `kernels`, with its file of choices where there is one.
macro_rules! kernel_file {
    ($name:literal) => {
        TheoryFile { name: $name, text: include_str!(concat!("../kernels/", $name)), choices: None }
    };
    ($name:literal, $choices:literal) => {
        TheoryFile {
            name: $name,
            text: include_str!(concat!("../kernels/", $name)),
            choices: Some(include_str!(concat!("../kernels/", $choices))),
        }
    };
}

/// Returns the files whose `pub kernel`s are the library's kernels; each also contains the
/// statements that its kernels rely on.
pub fn library() -> &'static [TheoryFile] {
    &[
        kernel_file!("solid_angle.forms"),
        kernel_file!("irradiance.forms"),
        kernel_file!("gathered_light.forms"),
        kernel_file!("polygon_solid_angle.forms"),
        kernel_file!("round_solid_angle.forms"),
        kernel_file!("polygon_form_factor.forms"),
        kernel_file!("round_form_factor.forms"),
        kernel_file!("linear_luminaire.forms"),
        kernel_file!("rectangle_view_factor.forms"),
        kernel_file!("disk_view_factor.forms"),
        kernel_file!("sphere_view_factor.forms"),
        kernel_file!("exchange.forms"),
        kernel_file!("reflection.forms"),
        kernel_file!("reconnection.forms"),
        kernel_file!("transport.forms"),
        kernel_file!("single_scattering.forms"),
        kernel_file!("airlight.forms"),
        kernel_file!("chandrasekhar.forms"),
        kernel_file!("fresnel.forms"),
        kernel_file!("phase_function.forms"),
        kernel_file!("planck.forms"),
        kernel_file!("warps_uniform.forms"),
        kernel_file!("warps_microfacet.forms"),
        kernel_file!("warps_axis.forms"),
        kernel_file!("warps_distance.forms"),
        kernel_file!("warps_spherical_triangle.forms"),
        kernel_file!("warps_spherical_rectangle.forms"),
    ]
}
