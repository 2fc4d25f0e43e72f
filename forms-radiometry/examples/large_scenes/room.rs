//! A room of 10 m by 10 m by 4 m with a lamp under its ceiling, whose floor is full of boxes of
//! different heights and random orientations.

use forms_testing::SplitMix;
use forms_testing::scene_text::{Point, material, polygon, surface};
use std::f64::consts::TAU;

/// The sides of the room.
const SIZE: [f64; 3] = [10.0, 10.0, 4.0];
/// Number of surfaces of a room without boxes, and of a box, which stands on the floor.
const SHELL: usize = 7;
const BOX: usize = 5;

/// Ten receivers: points at three heights that face up, down and to a wall, a sphere, a ray and a
/// wall.
const RECEIVERS: &str = r#"
[[receiver]]
name = "up 1"
kind = "point"
position = [2.1, 3.3, 1.6]
normal = [0, 0, 1]
[[receiver]]
name = "up 2"
kind = "point"
position = [7.7, 6.2, 1.6]
normal = [0, 0, 1]
[[receiver]]
name = "down 1"
kind = "point"
position = [5.2, 4.9, 2]
normal = [0, 0, -1]
[[receiver]]
name = "down 2"
kind = "point"
position = [1.2, 8.8, 3]
normal = [0, 0, -1]
[[receiver]]
name = "sideways 1"
kind = "point"
position = [9.1, 1.3, 1.5]
normal = [-1, 0.5, 0]
[[receiver]]
name = "sideways 2"
kind = "point"
position = [4.4, 2.3, 1.8]
normal = [0.2, 1, -0.3]
[[receiver]]
name = "on the wall"
kind = "point"
position = [0, 5, 1.5]
normal = [1, 0, 0]
[[receiver]]
name = "ball"
kind = "sphere"
position = [6, 3, 1.9]
[[receiver]]
name = "sight"
kind = "ray"
origin = [5, 5, 2.5]
direction = [-3, 1, 0.2]
[[receiver]]
name = "wall"
kind = "surface"
surface = "left"
[solve]
tolerance = 1e-2
"#;

/// Returns the text of a scene with about this many surfaces, and ten receivers.
pub(crate) fn asked(surfaces: usize) -> String {
    with_boxes(surfaces) + RECEIVERS
}

/// Returns the room with about this many surfaces, and no receivers.
pub(crate) fn with_boxes(surfaces: usize) -> String {
    let mut text = String::from("name = \"A room of boxes\"\n");
    for (name, reflectance) in [("paint", 0.7), ("wood", 0.4), ("cloth", 0.2)] {
        text += &material(name, reflectance);
    }
    shell(&mut text);
    let boxes = surfaces.saturating_sub(SHELL).div_ceil(BOX);
    let columns = (boxes as f64).sqrt().ceil() as usize;
    let mut random = SplitMix(1);
    for index in 0..boxes {
        let cell = [index % columns, index / columns];
        add_box(&mut text, index, cell, 1.0 / columns as f64, &mut random);
    }
    text
}

fn shell(text: &mut String) {
    let [x, y, z] = SIZE;
    let under = z - 0.1;
    let faces: [(&str, &str, [Point; 4]); SHELL] = [
        ("floor", "wood", [[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, y, 0.0], [0.0, y, 0.0]]),
        ("ceiling", "paint", [[0.0, 0.0, z], [0.0, y, z], [x, y, z], [x, 0.0, z]]),
        ("left", "paint", [[0.0, 0.0, 0.0], [0.0, y, 0.0], [0.0, y, z], [0.0, 0.0, z]]),
        ("right", "paint", [[x, 0.0, 0.0], [x, 0.0, z], [x, y, z], [x, y, 0.0]]),
        ("front", "paint", [[0.0, 0.0, 0.0], [0.0, 0.0, z], [x, 0.0, z], [x, 0.0, 0.0]]),
        ("back", "paint", [[0.0, y, 0.0], [x, y, 0.0], [x, y, z], [0.0, y, z]]),
        ("lamp", "paint", [[4.0, 4.0, under], [4.0, 6.0, under], [6.0, 6.0, under], [6.0, 4.0, under]]),
    ];
    faces.iter().for_each(|(name, material, corners)| *text += &surface(name, material, &polygon(corners)));
    // belongs to the lamp, which is the last surface
    text.push_str("exitance = 100\n");
}

/// Adds a box without a bottom, within its cell of the floor.
fn add_box(text: &mut String, index: usize, [column, row]: [usize; 2], size: f64, random: &mut SplitMix) {
    let middle = [(column as f64 + 0.5) * size * SIZE[0], (row as f64 + 0.5) * size * SIZE[1]];
    let half = size * SIZE[0] * (0.15 + 0.15 * random.unit());
    let height = 0.2 + 1.2 * random.unit() * random.unit();
    let turn = TAU * random.unit();
    let corner = |i: usize, z: f64| {
        let (sin, cos) = (turn + TAU * (i % 4) as f64 / 4.0).sin_cos();
        [middle[0] + half * cos, middle[1] + half * sin, z]
    };
    let material = if random.unit() < 0.5 { "wood" } else { "cloth" };
    let top: Vec<[f64; 3]> = (0..4).map(|i| corner(i, height)).collect();
    *text += &surface(&format!("top {index}"), material, &polygon(&top));
    for i in 0..4 {
        let side = [corner(i, 0.0), corner(i + 1, 0.0), corner(i + 1, height), corner(i, height)];
        *text += &surface(&format!("side {i} of {index}"), material, &polygon(&side));
    }
}
