//! Scenes with many point receivers: under a lamp, under a lamp that a plate partly occludes, and
//! in a closed room.

use forms_testing::SplitMix;
use forms_testing::scene_text::{CUBE, Point, material, point_receiver, polygon, surface, tolerance};
use std::f64::consts::TAU;

/// Returns points on a floor of 4 m × 4 m under a lamp of 2 m × 2 m, 2 m above its centre.
pub(crate) fn under_a_lamp(points: usize) -> String {
    format!("{}{}", lamp(), on_the_floor(points))
}

/// Returns the same scene with a plate of 1.5 m × 1 m halfway below the lamp, off-centre.
pub(crate) fn under_a_plate(points: usize) -> String {
    let plate = polygon(&[[-0.5, -0.25, 1.0], [-0.5, 0.75, 1.0], [1.0, 0.75, 1.0], [1.0, -0.25, 1.0]]);
    format!("{}{}{}", lamp(), surface("plate", "black", &plate), on_the_floor(points))
}

/// Returns points with random normals in a cube whose walls reflect and whose ceiling emits.
pub(crate) fn in_a_cube(points: usize) -> String {
    let mut random = SplitMix(2);
    let mut text = material("paint", 0.6);
    for (name, corners) in CUBE {
        let light = if name == "ceiling" { "\nexitance = 1" } else { "" };
        text += &surface(name, "paint", &format!("{}{light}", polygon(&corners)));
    }
    for index in 0..points {
        let position = [0, 1, 2].map(|_| random.between([0.1, 0.9]));
        let up = random.between([-1.0, 1.0]);
        let (sin, cos) = random.between([0.0, TAU]).sin_cos();
        let across = (1.0 - up * up).sqrt();
        text += &point_receiver(&index.to_string(), position, [across * cos, across * sin, up]);
    }
    text + &tolerance(1e-1)
}

fn lamp() -> String {
    let corners = [[-1.0, -1.0, 2.0], [-1.0, 1.0, 2.0], [1.0, 1.0, 2.0], [1.0, -1.0, 2.0]];
    let shape = format!("{}\nradiance = 1", polygon(&corners));
    format!("{}{}", material("black", 0), surface("lamp", "black", &shape))
}

fn on_the_floor(points: usize) -> String {
    const UP: Point = [0.0, 0.0, 1.0];
    let mut random = SplitMix(1);
    let mut place = || random.between([-2.0, 2.0]);
    (0..points).map(|index| point_receiver(&index.to_string(), [place(), place(), 0.0], UP)).collect()
}
