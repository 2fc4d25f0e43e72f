//! Unfolding: the light in a scene in front of a plane mirror that absorbs nothing equals the light
//! in the scene next to its mirror image, without the mirror.
//!
//! Without a medium the unfolded scene is diffuse, and its light is found on elements, by no path.
//! In fog both scenes are path traced, with next-event estimation at each scattering along a path.

use crate::claims::answers;
use forms_radiometry::scene::read;
use forms_radiometry::simulation::{Answer, ErrorKind};
use forms_testing::SplitMix;
use forms_testing::scene_text::elements::{filled_with, medium, mirror, probe, shining, two_sided};
use forms_testing::scene_text::{Point, material, point_receiver, polygon, surface, tolerance};

const FAR: f64 = 1e4;
/// Number of standard errors by which two numbers may differ.
const DEVIATIONS: f64 = 4.0;

struct Case {
    random: SplitMix,
    tables: String,
    images: String,
}

impl Case {
    fn within(&mut self, low: Point, high: Point) -> Point {
        std::array::from_fn(|axis| low[axis] + (high[axis] - low[axis]) * self.random.unit())
    }

    /// Adds a parallelogram about a point, and its image.
    fn add(&mut self, name: &str, [middle, a, b]: [Point; 3], more: &str) {
        let corner = |u: f64, v: f64| std::array::from_fn(|axis| middle[axis] + u * a[axis] + v * b[axis]);
        let corners: [Point; 4] =
            [corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
        let mut image = corners.map(|[x, y, z]| [-x, y, z]);
        image.reverse();
        let table = |name: &str, corners: &[Point]| surface(name, name, &(polygon(corners) + more));
        let reflectance = if more.contains("radiance") { 0.0 } else { 0.6 };
        let image_name = format!("image of {name}");
        self.tables += &(material(name, reflectance) + &table(name, &corners));
        self.images += &(material(&image_name, reflectance) + &table(&image_name, &image));
    }

    /// Returns a lamp of any size that shines to both sides, a floor and a board that reflect, a
    /// point and a probe.
    fn of(seed: u64) -> Self {
        let mut case = Self { random: SplitMix(seed), tables: String::new(), images: String::new() };
        let size = case.random.of(&[0.01, 0.03, 0.1, 0.4]);
        let lamp = case.within([0.5, -1.0, 1.0], [1.5, 1.0, 2.0]);
        let [a, b] = [(); 2].map(|()| case.within([-size; 3], [size; 3]));
        case.add("lamp", [lamp, a, b], &two_sided(&shining("", 1.0 / (size * size))));
        case.add("floor", [[2.0, 0.0, 0.0], [4.0, 0.0, 0.0], [0.0, 4.0, 0.0]], "");
        let board = case.within([2.0, -1.0, 0.8], [3.0, 1.0, 1.6]);
        let [a, b] = [(); 2].map(|()| case.within([-0.5; 3], [0.5; 3]));
        case.add("board", [board, a, b], &two_sided(""));
        let [here, normal] =
            [case.within([0.2, -1.5, 0.1], [1.8, 1.5, 0.6]), case.within([-1.0; 3], [0.2, 1.0, 1.0])];
        let there = case.within([0.2, -1.5, 0.1], [1.8, 1.5, 0.6]);
        case.tables += &(point_receiver("point", here, normal) + &probe("probe", there));
        case
    }
}

fn of(text: &str) -> Vec<Answer> {
    answers("unfolded", &read(text, "unfolded.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0])))
}

/// Compares the light in front of a mirror with the light next to an image, with more tables in
/// both scenes.
fn compare(seed: u64, more: &str) {
    let case = Case::of(seed);
    let plane = polygon(&[[0.0, -FAR, -FAR], [0.0, FAR, -FAR], [0.0, FAR, FAR], [0.0, -FAR, FAR]]);
    let silver = mirror("silver", 1) + &surface("mirror", "silver", &plane);
    let before = of(&[&case.tables, &silver[..], more].concat());
    let beside = of(&[&case.tables, &case.images[..], more].concat());
    for (mirrored, unfolded) in before.iter().zip(&beside) {
        let sigma = |answer: &Answer| match answer.kind {
            ErrorKind::Sigma => DEVIATIONS * answer.error,
            _ => answer.error,
        };
        let off = (mirrored.value - unfolded.value).abs();
        assert!(off <= sigma(mirrored).hypot(sigma(unfolded)), "{seed}: {mirrored:?}, {unfolded:?}");
    }
}

#[test]
fn a_mirror_is_as_good_as_an_image_of_the_scene() {
    (0..10).for_each(|seed| compare(seed, &tolerance(2e-2)));
}

#[test]
fn in_fog_a_mirror_is_as_good_as_an_image_of_the_scene() {
    let fog = medium("fog", [&0.1, &0.3, &0.4, &1]) + &filled_with("fog");
    let more = fog
        + &tolerance(5e-2).replace("[solve]", "[solve]\neffects = { scattering = 2, interreflection = 1 }");
    (10..14).for_each(|seed| compare(seed, &more));
}
