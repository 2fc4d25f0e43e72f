//! Scenes: how each format is read, and how its errors are reported. This module has a scene with
//! one of everything in the format, and the helpers shared by the tests.

mod damaged;
mod elements;
mod errors;
mod files;
mod media;
mod mesh_damage;
mod mesh_formats;
mod meshes;
mod mitsuba;
mod mitsuba_errors;
mod mitsuba_files;
mod mitsuba_images;
mod mitsuba_media;
mod mitsuba_objects;
mod mitsuba_rough;
mod mitsuba_spectra;
mod mitsuba_textures;
mod overlaps;
mod page;
mod spots;
mod subsurfaces;
mod view3d;

use forms_radiometry::scene::{Scene, SceneError, read_with_files};
use std::io;

/// One of everything, so that each test can damage a part of it.
pub(crate) const EVERYTHING: &str = r#"
name = "Box"
unit = "m"
bands = [[400, 500], [500, 600]]

[[medium]]
name = "haze"
sigma_a = 0.1
sigma_s = [0.2, 0.3]
g = -0.5
n = 1
[[medium]]
name = "glass"
n = [1.52, 1.51]

[[material]]
name = "white"
kind = "diffuse"
reflectance = 0.75
[[material]]
name = "silver"
kind = "mirror"
reflectance = [0.9, 1]
[[material]]
name = "pane"
kind = "dielectric"
inside = "glass"
[[material]]
name = "gold"
kind = "conductor"
eta = [1.4, 0.4]
k = 2

[[surface]]
name = "floor"
material = "white"
polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
radiance = [0.5, 1]
two_sided = false
[[surface]]
name = "part"
material = "gold"
mesh = "part.obj"
[[surface]]
name = "ball"
material = "pane"
sphere = { center = [0, 0, 4], radius = 0.5, inward = false }
[[surface]]
name = "lid"
material = "silver"
disk = { center = [0, 0, 8], normal = [0, 0, -3], radius = 2 }
exitance = 3
two_sided = true

[[light]]
kind = "point"
position = [0, 0, 2]
intensity = 1.5
[[light]]
name = "sun"
kind = "distant"
direction = [0, 3, -4]
irradiance = [1000, 900]

[[receiver]]
name = "here"
kind = "point"
position = [0.5, 0.5, 1]
normal = [0, 0, -2]
[[receiver]]
name = "map"
kind = "surface"
surface = "floor"
grid = [64, 32]
[[receiver]]
name = "beam"
kind = "ray"
origin = [0, 0, 1]
direction = [0, 2, 0]
[[receiver]]
name = "eye"
kind = "camera"
origin = [0, 0, 9]
target = [0, 0, 0]
up = [0, 1, 0]
fov = 40
resolution = [8, 6]
[[receiver]]
name = "all around"
kind = "sphere"
position = [0, 0, 1]
time = { start = 0, width = 1e-9, bins = 100 }

[ambient]
medium = "haze"
radiance = 0.25

[solve]
tolerance = 1e-2
seed = 7
effects = { interreflection = "off", occlusion = "on", scattering = 2 }
"#;

/// A tetrahedron.
pub(crate) const PART_OBJ: &str = "\
# a tetrahedron
v 2 0 0
v 3 0 0
v 2 1 0
v 2 0 1
f 1 3 2
f 1 2 4
f 2 3 4
f 3 1 4
";

/// Two points with normals.
pub(crate) const SENSORS_CSV: &str = "x,y,z,nx,ny,nz\n0.5,0.5,0.85,0,0,1\n1.5,0.5,0.85,0,0,2\n";

/// Returns the files that scenes of the tests can name.
pub(crate) fn files(name: &str) -> io::Result<Vec<u8>> {
    match name {
        "part.obj" => Ok(PART_OBJ.into()),
        "sensors.csv" => Ok(SENSORS_CSV.into()),
        _ => Err(io::ErrorKind::NotFound.into()),
    }
}

pub(crate) fn read(text: &str, name: &str) -> Result<Scene, Vec<SceneError>> {
    read_with_files(text, name, &files)
}

/// Reads the scene of a valid text.
pub(crate) fn scene(text: &str, name: &str) -> Scene {
    read(text, name).unwrap_or_else(|errors| panic!("{}", shown(&errors)))
}

/// Returns the errors of an invalid text.
pub(crate) fn errors(text: &str, name: &str) -> Vec<SceneError> {
    read(text, name).map(|_| ()).expect_err("the scene has an error")
}

pub(crate) fn shown(errors: &[SceneError]) -> String {
    errors.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

/// Text that is replaced, its replacement, the line and column of the first error, and its message.
pub(crate) type Placed<'t> = (&'t str, &'t str, (usize, usize), &'t str);

/// Checks that each replacement in a text leads to its error, at its place.
pub(crate) fn check_places(text: &str, cases: &[Placed], errors: impl Fn(&str) -> Vec<SceneError>) {
    let mut wrong = Vec::new();
    for &(from, to, place, message) in cases {
        assert!(text.contains(from), "{from}");
        let found = errors(&text.replacen(from, to, 1));
        let is_told = found
            .first()
            .is_some_and(|error| ((error.line, error.column), error.message.as_str()) == (place, message));
        if !is_told {
            wrong.push(format!("{from} → {to}, {message}, {place:?}:\n{}", shown(&found)));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}

/// Checks that each replacement in a text leads to one error, in the lines of the replacement or in
/// up to `before` lines before it.
pub(crate) fn check_each(text: &str, name: &str, cases: &[(&str, &str, &str)], before: usize) {
    let mut wrong = Vec::new();
    for &(from, to, message) in cases {
        let start = text.find(from).unwrap_or_else(|| panic!("{from} is not in the text"));
        let found = errors(&text.replacen(from, to, 1), name);
        let first = text[..start].matches('\n').count() + 1;
        let lines = first.saturating_sub(before)..=first + to.matches('\n').count();
        match &found[..] {
            [error] if error.message == message && lines.contains(&error.line) => {}
            _ => wrong.push(format!("{from} → {to}, {message}, lines {lines:?}:\n{}", shown(&found))),
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n\n"));
}
