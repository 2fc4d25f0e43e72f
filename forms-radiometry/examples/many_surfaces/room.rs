//! A room of 10 m by 10 m by 4 m with a lamp under its ceiling, whose floor is full of boxes of different heights, turned at random.

use std::f64::consts::TAU;
use std::fmt::Write;

/// The sides of the room.
const SIZE: [f64; 3] = [10.0, 10.0, 4.0];
/// The surfaces of a room without boxes, and those of a box, which stands on the floor.
const SHELL: usize = 7;
const BOX: usize = 5;

/// Ten receivers: points at three heights that look up, down and to a wall, a sphere, a ray and a wall.
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

/// SplitMix64 (Steele, Lea, Flood 2014), as numbers from 0 to 1.
struct Uniform(u64);

impl Uniform {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// The text of a scene with about this many surfaces.
pub(crate) fn with_boxes(surfaces: usize) -> String {
    let mut text = String::from("name = \"A room of boxes\"\n");
    for (name, reflectance) in [("paint", 0.7), ("wood", 0.4), ("cloth", 0.2)] {
        write!(text, "[[material]]\nname = \"{name}\"\nkind = \"diffuse\"\nreflectance = {reflectance}\n")
            .unwrap();
    }
    shell(&mut text);
    let boxes = surfaces.saturating_sub(SHELL).div_ceil(BOX);
    let columns = (boxes as f64).sqrt().ceil() as usize;
    let mut random = Uniform(1);
    for index in 0..boxes {
        let cell = [index % columns, index / columns];
        add_box(&mut text, index, cell, 1.0 / columns as f64, &mut random);
    }
    text + RECEIVERS
}

fn polygon(text: &mut String, name: &str, material: &str, corners: &[[f64; 3]]) {
    writeln!(text, "[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\npolygon = {corners:?}")
        .unwrap();
}

fn shell(text: &mut String) {
    let [x, y, z] = SIZE;
    polygon(text, "floor", "wood", &[[0.0, 0.0, 0.0], [x, 0.0, 0.0], [x, y, 0.0], [0.0, y, 0.0]]);
    polygon(text, "ceiling", "paint", &[[0.0, 0.0, z], [0.0, y, z], [x, y, z], [x, 0.0, z]]);
    polygon(text, "left", "paint", &[[0.0, 0.0, 0.0], [0.0, y, 0.0], [0.0, y, z], [0.0, 0.0, z]]);
    polygon(text, "right", "paint", &[[x, 0.0, 0.0], [x, 0.0, z], [x, y, z], [x, y, 0.0]]);
    polygon(text, "front", "paint", &[[0.0, 0.0, 0.0], [0.0, 0.0, z], [x, 0.0, z], [x, 0.0, 0.0]]);
    polygon(text, "back", "paint", &[[0.0, y, 0.0], [x, y, 0.0], [x, y, z], [0.0, y, z]]);
    let z = z - 0.1;
    polygon(text, "lamp", "paint", &[[4.0, 4.0, z], [4.0, 6.0, z], [6.0, 6.0, z], [6.0, 4.0, z]]);
    text.push_str("exitance = 100\n");
}

/// A box without a bottom, within its cell of the floor.
fn add_box(text: &mut String, index: usize, [column, row]: [usize; 2], size: f64, random: &mut Uniform) {
    let middle = [(column as f64 + 0.5) * size * SIZE[0], (row as f64 + 0.5) * size * SIZE[1]];
    let half = size * SIZE[0] * (0.15 + 0.15 * random.next());
    let height = 0.2 + 1.2 * random.next() * random.next();
    let turn = TAU * random.next();
    let corner = |i: usize, z: f64| {
        let (sin, cos) = (turn + TAU * (i % 4) as f64 / 4.0).sin_cos();
        [middle[0] + half * cos, middle[1] + half * sin, z]
    };
    let material = if random.next() < 0.5 { "wood" } else { "cloth" };
    let top: Vec<[f64; 3]> = (0..4).map(|i| corner(i, height)).collect();
    polygon(text, &format!("top {index}"), material, &top);
    for i in 0..4 {
        let side = [corner(i, 0.0), corner(i + 1, 0.0), corner(i + 1, height), corner(i, height)];
        polygon(text, &format!("side {i} of {index}"), material, &side);
    }
}
