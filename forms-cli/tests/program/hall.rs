//! A scene with a mirror, which requires path tracing: a number, a map and an image.

/// Returns the scene with this tolerance.
pub(crate) fn hall(tolerance: f64) -> String {
    format!("{HALL}[solve]\ntolerance = {tolerance:?}\n")
}

/// Files of `--out` that contain every bit of the answers.
pub(crate) const FILES: [&str; 3] = ["results.csv", "map.exr", "eye.exr"];

pub(crate) const HALL: &str = r#"
[[material]]
name = "grey"
kind = "diffuse"
reflectance = 0.5
[[material]]
name = "silver"
kind = "mirror"
reflectance = 0.9
[[surface]]
name = "floor"
material = "grey"
polygon = [[0,0,0], [2,0,0], [2,1,0], [0,1,0]]
[[surface]]
name = "wall"
material = "silver"
polygon = [[0,0,0], [0,1,0], [0,1,1], [0,0,1]]
[[surface]]
name = "lamp"
material = "grey"
polygon = [[0.5,0,1], [0.5,1,1], [1,1,1], [1,0,1]]
radiance = 1
[[receiver]]
name = "here"
kind = "point"
position = [1, 0.5, 0.1]
normal = [0, 0, 1]
[[receiver]]
name = "map"
kind = "surface"
surface = "floor"
grid = [3, 2]
[[receiver]]
name = "eye"
kind = "camera"
origin = [1, 0.5, 0.5]
target = [0, 0.5, 0.2]
up = [0, 0, 1]
fov = 60
resolution = [4, 3]
"#;

/// Scene that is solved as a whole, without paths.
pub(crate) const LAMP: &str = r#"
[[material]]
name = "black"
kind = "diffuse"
reflectance = 0
[[surface]]
name = "lamp"
material = "black"
polygon = [[0.5,0,1], [0.5,1,1], [1,1,1], [1,0,1]]
radiance = 1
[[receiver]]
name = "here"
kind = "point"
position = [1, 0.5, 0.1]
normal = [0, 0, 1]
"#;
