//! Texts of scenes, for tests and measurements: each element becomes its table of a scene file, and a scene is all of them, one after
//! the other.

use std::fmt::Display;

/// A point or a direction.
pub(crate) type Point = [f64; 3];

/// The faces of the unit cube, which look inwards, by their names.
pub(crate) const CUBE: [(&str, [Point; 4]); 6] = [
    ("floor", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
    ("ceiling", [[0.0, 0.0, 1.0], [0.0, 1.0, 1.0], [1.0, 1.0, 1.0], [1.0, 0.0, 1.0]]),
    ("left", [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]]),
    ("right", [[1.0, 0.0, 0.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [1.0, 1.0, 0.0]]),
    ("front", [[0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    ("back", [[0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]]),
];

/// A diffuse material.
pub(crate) fn material(name: &str, reflectance: impl Display) -> String {
    format!("[[material]]\nname = \"{name}\"\nkind = \"diffuse\"\nreflectance = {reflectance}\n")
}

/// A surface; `shape` is the line that says its shape, and may be followed by lines of more keys.
pub(crate) fn surface(name: &str, material: &str, shape: &str) -> String {
    format!("[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{shape}\n")
}

/// The shape of a polygon.
pub(crate) fn polygon(corners: &[Point]) -> String {
    format!("polygon = {corners:?}")
}

/// A receiver at a point.
pub(crate) fn point_receiver(name: &str, position: Point, normal: Point) -> String {
    format!(
        "[[receiver]]\nname = \"{name}\"\nkind = \"point\"\nposition = {position:?}\nnormal = {normal:?}\n"
    )
}

/// A receiver with the name of the surface that it covers.
pub(crate) fn surface_receiver(surface: &str) -> String {
    format!("[[receiver]]\nname = \"{surface}\"\nkind = \"surface\"\nsurface = \"{surface}\"\n")
}

/// What is asked of the solver.
pub(crate) fn tolerance(tolerance: f64) -> String {
    format!("[solve]\ntolerance = {tolerance:?}\n")
}

/// A surface of its own material.
pub(crate) fn surface_of_its_own(name: &str, shape: &str, reflectance: &str, exitance: &str) -> String {
    material(name, reflectance) + &surface(name, name, &format!("{shape}\nexitance = {exitance}"))
}

/// The unit cube, each face of its own material.
pub(crate) fn cube(reflectances: [f64; 6], exitances: [f64; 6]) -> String {
    let faces = CUBE.iter().zip(reflectances.iter().zip(exitances));
    let texts = faces.map(|((name, corners), (rho, exitance))| {
        surface_of_its_own(name, &polygon(corners), &rho.to_string(), &exitance.to_string())
    });
    texts.collect()
}
