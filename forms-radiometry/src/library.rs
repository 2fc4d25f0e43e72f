//! The theory and the kernels that come with the library, as the text they are generated from.

/// One file of the forms language.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TheoryFile {
    /// Its file name.
    pub name: &'static str,
    /// Its characters.
    pub text: &'static str,
}

/// The identities of Lessig, Fiume and Desbrun, *On the Mathematical Formulation of Radiance*, by their
/// numbers there. `refute … as_printed` marks equations that are wrong as printed.
pub const RADIANCE: TheoryFile =
    TheoryFile { name: "radiance.forms", text: include_str!("../theory/radiance.forms") };

/// The files whose `pub kernel`s are the library's kernels, each beside the statements it rests on.
pub fn library() -> &'static [TheoryFile] {
    &[
        TheoryFile { name: "solid_angle.forms", text: include_str!("../kernels/solid_angle.forms") },
        TheoryFile { name: "irradiance.forms", text: include_str!("../kernels/irradiance.forms") },
        TheoryFile { name: "reflection.forms", text: include_str!("../kernels/reflection.forms") },
        TheoryFile { name: "reconnection.forms", text: include_str!("../kernels/reconnection.forms") },
        TheoryFile { name: "transport.forms", text: include_str!("../kernels/transport.forms") },
    ]
}
