//! Texts of scenes, for tests and measurements: each element becomes its table of a scene file, and
//! a scene is the concatenation of all tables.

pub mod elements;

use std::fmt::Display;

/// A point or a direction.
pub type Point = [f64; 3];

/// Faces of the unit cube, which face inwards, by their names.
pub const CUBE: [(&str, [Point; 4]); 6] = [
    ("floor", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
    ("ceiling", [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]),
    ("left", [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]),
    ("right", [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 0.0]]),
    ("front", [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    ("back", [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]]),
];

/// Returns a diffuse material.
pub fn material(name: &str, reflectance: impl Display) -> String {
    format!("[[material]]\nname = \"{name}\"\nkind = \"diffuse\"\nreflectance = {reflectance}\n")
}

/// Returns a surface; `shape` is the line that gives its shape, and may be followed by lines of
/// more keys.
pub fn surface(name: &str, material: &str, shape: &str) -> String {
    format!("[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{shape}\n")
}

/// Returns the shape of a polygon.
pub fn polygon(corners: &[Point]) -> String {
    format!("polygon = {corners:?}")
}

/// Returns a receiver at a point.
pub fn point_receiver(name: &str, position: Point, normal: Point) -> String {
    format!(
        "[[receiver]]\nname = \"{name}\"\nkind = \"point\"\nposition = {position:?}\nnormal = {normal:?}\n"
    )
}

/// Returns a receiver with the name of the surface that it covers.
pub fn surface_receiver(surface: &str) -> String {
    format!("[[receiver]]\nname = \"{surface}\"\nkind = \"surface\"\nsurface = \"{surface}\"\n")
}

/// Returns the setting of the solver's tolerance.
pub fn tolerance(tolerance: f64) -> String {
    format!("[solve]\ntolerance = {tolerance:?}\n")
}

/// Returns a surface with its own material.
pub fn surface_of_its_own(name: &str, shape: &str, reflectance: &str, exitance: &str) -> String {
    material(name, reflectance) + &surface(name, name, &format!("{shape}\nexitance = {exitance}"))
}

/// Returns the unit cube, each face with its own material.
pub fn cube(reflectances: [f64; 6], exitances: [f64; 6]) -> String {
    let faces = CUBE.iter().zip(reflectances.iter().zip(exitances));
    let texts = faces.map(|((name, corners), (rho, exitance))| {
        surface_of_its_own(name, &polygon(corners), &rho.to_string(), &exitance.to_string())
    });
    texts.collect()
}
