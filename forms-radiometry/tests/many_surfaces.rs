//! Scenes of thousands of surfaces: known answers and laws hold within the printed errors.

use forms_radiometry::scene::{Scene, read_with_files};
use forms_radiometry::simulation::{Answer, ErrorKind, Quantity, Unwatched, plan, simulate};
use forms_testing::SplitMix;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::fmt::Write;

use forms_testing::scene_text::{
    self, CUBE, Point, material, point_receiver, polygon, surface_receiver as receiver, tolerance as asked,
};

/// Whether numeric code is optimised; otherwise hundreds of surfaces have to suffice.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);

/// Meshes by the names of their files, as OBJ.
#[derive(Default)]
struct Meshes(HashMap<String, String>);

impl Meshes {
    /// Adds a mesh of polygons that share no vertices.
    fn add(&mut self, name: &str, polygons: &[Vec<Point>]) {
        let mut text = String::new();
        let mut count = 0;
        for polygon in polygons {
            polygon.iter().for_each(|[x, y, z]| writeln!(text, "v {x:?} {y:?} {z:?}").unwrap());
            let indices: Vec<String> = (1..=polygon.len()).map(|i| (count + i).to_string()).collect();
            writeln!(text, "f {}", indices.join(" ")).unwrap();
            count += polygon.len();
        }
        self.0.insert(format!("{name}.obj"), text);
    }

    /// Adds a wall of n² pairs of triangles as two meshes. Of each pair one triangle is in either mesh,
    /// so that none has a neighbour in its mesh, and the triangles stay what they are.
    fn add_wall(&mut self, name: &str, corners: [Point; 4], n: usize) {
        let all = triangles(corners, n);
        let every_second = |first: usize| all.iter().skip(first).step_by(2).cloned().collect::<Vec<_>>();
        self.add(name, &every_second(0));
        self.add(&other_half(name), &every_second(1));
    }

    fn scene(&self, text: &str) -> Scene {
        let file = |name: &str| Ok(self.0[name].clone().into_bytes());
        read_with_files(text, "test.toml", &file).unwrap_or_else(|errors| panic!("{}", errors[0]))
    }

    fn answers(&self, text: &str) -> Vec<Answer> {
        let scene = self.scene(text);
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        simulate(&plan, &Unwatched).answers
    }
}

/// Divides a parallelogram with these corners into n² pairs of triangles.
fn triangles([corner, beside, _, above]: [Point; 4], n: usize) -> Vec<Vec<Point>> {
    let at = |i: usize, j: usize| {
        let [u, v] = [i, j].map(|i| i as f64 / n as f64);
        let along = |axis: usize, to: Point| to[axis] - corner[axis];
        [0, 1, 2].map(|axis| corner[axis] + u * along(axis, beside) + v * along(axis, above))
    };
    let cell = |(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [vec![a, b, c], vec![a, c, d]]
    };
    (0..n * n).flat_map(|index| cell((index % n, index / n))).collect()
}

/// Returns a surface with its own material and mesh.
fn surface(name: &str, reflectance: f64, exitance: f64) -> String {
    let shape = format!("mesh = \"{name}.obj\"\nexitance = {exitance:?}");
    material(name, reflectance) + &scene_text::surface(name, name, &shape)
}

/// Returns the name of the other half of a wall.
fn other_half(name: &str) -> String {
    format!("{name}, other half")
}

/// Returns both halves of a wall.
fn wall(name: &str, reflectance: f64, exitance: f64) -> String {
    surface(name, reflectance, exitance) + &surface(&other_half(name), reflectance, exitance)
}

/// Number of standard errors that hardly any answer is off by.
const HARDLY_EXCEEDED: f64 = 5.0;

/// Returns the error that an answer hardly ever exceeds.
fn largest_error(answer: &Answer) -> f64 {
    if answer.kind == ErrorKind::Sigma { HARDLY_EXCEEDED * answer.error } else { answer.error }
}

/// Returns the answer of a receiver for a quantity, its error, and the error that it hardly ever
/// exceeds.
fn answer(answers: &[Answer], receiver: &str, quantity: Quantity) -> [f64; 3] {
    let is_meant = |answer: &&Answer| answer.receiver == receiver && answer.quantity == quantity;
    let found = answers.iter().find(is_meant).unwrap_or_else(|| panic!("{receiver} {quantity:?}"));
    [found.value, found.error, largest_error(found)]
}

fn assert_within(name: &str, [found, error, largest]: [f64; 3], expected: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(off <= largest, "{name}: {found} is off by {off:e}, said {error:e}");
    assert!(error <= tolerance * expected.abs(), "{name}: {error:e} is not what was asked for");
}

#[test]
fn in_a_furnace_of_thousands_of_triangles_every_radiance_is_that_of_the_walls() {
    let mut meshes = Meshes::default();
    let (n, tolerance, reflectances) =
        if IS_OPTIMISED { (16, 1e-2, vec![0.5, 0.9, 0.99]) } else { (6, 5e-2, vec![0.9]) };
    CUBE.iter().for_each(|(name, face)| meshes.add_wall(name, *face, n));
    for rho in reflectances {
        let expected = 1.0 / (1.0 - rho);
        let walls: String = CUBE.iter().map(|(name, _)| wall(name, rho, PI)).collect();
        let text = walls
            + &point_receiver("point", [0.1, 0.7, 0.0], [0.0, 0.0, 1.0])
            + "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0.5, 0.4, 0.3]\ndirection = [3, 1, 2]\n"
            + "[[receiver]]\nname = \"sphere\"\nkind = \"sphere\"\nposition = [0.9, 0.4, 0.3]\n"
            + &receiver("floor")
            + &asked(tolerance);
        let found = meshes.answers(&text);
        assert_within("point", answer(&found, "point", Quantity::Irradiance), PI * expected, tolerance);
        assert_within("ray", answer(&found, "ray", Quantity::Radiance), expected, tolerance);
        assert_within(
            "sphere",
            answer(&found, "sphere", Quantity::FluenceRate),
            4.0 * PI * expected,
            tolerance,
        );
        assert_within("floor", answer(&found, "floor", Quantity::Irradiance), PI * expected, tolerance);
        for axis in 0..3 {
            let [flow, error, largest] = answer(&found, "sphere", Quantity::VectorIrradiance(axis));
            assert!(flow.abs() <= largest && error <= 20.0 * tolerance * expected, "{rho}: {flow} ± {error}");
        }
    }
}

/// Rotates a point about one axis and then another. Known answers do not change by it, but all rays
/// do.
fn turned([x, y, z]: Point, turn: f64) -> Point {
    let (sin, cos) = turn.sin_cos();
    let [x, y] = [cos * x - sin * y, sin * x + cos * y];
    let (sin, cos) = (1.7 * turn).sin_cos();
    [x, cos * y - sin * z, sin * y + cos * z]
}

#[test]
fn opposed_squares_of_thousands_of_triangles_keep_their_radiosity_however_they_are_turned() {
    // mean radiosity of the square that emits nothing, by tensor Gauss–Legendre in f64
    const EXPECTED: f64 = 0.896_047_679_666_9;
    let squares = [
        ("a", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]),
        ("b", [[0.0, 0.0, 0.25], [0.0, 1.0, 0.25], [1.0, 1.0, 0.25], [1.0, 0.0, 0.25]]),
    ];
    let cases = [(12, 5e-2, 2), (24, 3e-2, 8), (32, 1e-2, 2)];
    for &(n, tolerance, turns) in if IS_OPTIMISED { &cases[..] } else { &cases[..1] } {
        for turn in 0..turns {
            let mut meshes = Meshes::default();
            for (name, square) in squares {
                let square = square.map(|corner| turned(corner, f64::from(turn)));
                meshes.add_wall(name, square, n);
            }
            let halves = ["a".to_owned(), other_half("a")];
            let receivers: String = halves.iter().map(|half| receiver(half)).collect();
            let text = wall("a", 0.9, 0.0) + &wall("b", 0.9, 1.0) + &receivers;
            let answers = meshes.answers(&(text + &asked(tolerance)));
            let [one, other] = halves.map(|half| answer(&answers, &half, Quantity::Irradiance));
            let mean = [0, 1, 2].map(|place| 0.9 * 0.5 * (one[place] + other[place]));
            assert_within("squares", mean, EXPECTED, tolerance);
        }
    }
}

#[test]
fn each_seed_has_answers_of_its_own_within_the_errors_of_the_others() {
    let mut meshes = Meshes::default();
    meshes.add_wall("a", [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]], 12);
    meshes.add_wall("b", [[0.0, 0.0, 0.25], [0.0, 1.0, 0.25], [1.0, 1.0, 0.25], [1.0, 0.0, 0.25]], 12);
    let text = wall("a", 0.9, 0.0) + &wall("b", 0.9, 1.0) + &receiver("a") + &asked(5e-2);
    let of_seed = |seed: u32| meshes.answers(&format!("{text}seed = {seed}\n")).swap_remove(0);
    let found = [1, 2, 3].map(of_seed);
    for (index, one) in found.iter().enumerate() {
        assert_eq!(one.kind, ErrorKind::Sigma);
        for other in &found[..index] {
            let off = (one.value - other.value).abs();
            assert!(off > 0.0 && off <= largest_error(one) + largest_error(other), "{one:?}, {other:?}");
        }
    }
}

/// Returns a black floor in the sun below regular slats, and its exact mean. A few per cent of the
/// floor are in shadow, or nearly all of it.
fn slats(random: &mut SplitMix) -> (String, f64) {
    let count = random.of(&[15, 20, 24, 30, 32]);
    let [length, width] = [random.of(&[4.0, 8.41, PI]), 1.0 + 11.0 * random.unit()];
    let pitch = length / f64::from(count);
    let slat = pitch * random.of(&[0.015, 0.1, 0.5, 0.99]);
    let [height, slope] = [0.3 + 1.7 * random.unit(), random.unit()];
    let floor = [[0.0, 0.0, 0.0], [length, 0.0, 0.0], [length, width, 0.0], [0.0, width, 0.0]];
    let mut text = material("black", 0) + &material("grey", 0.5);
    text += &scene_text::surface("floor", "black", &polygon(&floor));
    let mut covered = 0.0;
    let before = (slope * height / pitch).ceil() as i32;
    for number in -1 - before..count {
        let low = pitch * (f64::from(number) + 0.3);
        let at = |x: f64, y: f64| [x, y, height];
        let corners = [at(low, -9.0), at(low + slat, -9.0), at(low + slat, 21.0), at(low, 21.0)];
        let shape = polygon(&corners) + "\ntwo_sided = true";
        text += &scene_text::surface(&format!("slat {number}"), "grey", &shape);
        let [begin, end] = [low, low + slat].map(|x| (x + slope * height).clamp(0.0, length));
        covered += end - begin;
    }
    text += &format!("[[light]]\nkind = \"distant\"\ndirection = [{slope:?}, 0, -1]\nirradiance = 900\n");
    text += &(receiver("floor") + &asked(1e-2) + "effects = { interreflection = \"off\" }\n");
    (text, 900.0 / slope.hypot(1.0) * (1.0 - covered / length))
}

#[test]
fn regular_shadows_are_exact() {
    let mut random = SplitMix(1);
    for number in 0..4 {
        let (text, right) = slats(&mut random);
        let floor = Meshes::default().answers(&text).swap_remove(0);
        let (value, error) = (floor.value, floor.error);
        let is_right = (value - right).abs() <= error + 1e-9 * right;
        assert!(is_right, "{number}: {value} ± {error}, right is {right}");
        assert_ne!(floor.kind, ErrorKind::Sigma);
    }
}

/// A pattern that fits the grid of the random points could be missed by all of them. A mirror far
/// away makes path tracing necessary, and changes no answer.
#[test]
fn random_points_are_right_about_regular_shadows_with_every_seed() {
    let mirror = "[[material]]\nname = \"silver\"\nkind = \"mirror\"\nreflectance = 0.9\n".to_owned()
        + &scene_text::surface(
            "mirror",
            "silver",
            "disk = { center = [0, 0, -50], normal = [0, 0, -1], radius = 0.1 }",
        );
    let (mut random, mut all, mut beyond_three) = (SplitMix(1), 0, 0);
    for number in 0..4 {
        let (text, right) = slats(&mut random);
        for seed in 0..20 {
            let floor = Meshes::default().answers(&format!("{mirror}{text}seed = {seed}\n")).swap_remove(0);
            let off = (floor.value - right).abs() / floor.error;
            assert!(off <= HARDLY_EXCEEDED, "{number}, seed {seed}: {floor:?}, right is {right}");
            assert_eq!(floor.kind, ErrorKind::Sigma);
            all += 1;
            beyond_three += usize::from(off > 3.0);
        }
    }
    assert!(20 * beyond_three <= all, "{beyond_three} of {all} are beyond three standard errors");
}

#[test]
fn what_is_emitted_in_a_closed_room_full_of_blocks_is_absorbed() {
    let mut meshes = Meshes::default();
    let reflectances = [0.3, 0.7, 0.5, 0.0, 0.6, 0.8];
    let mut text = String::new();
    for ((name, face), rho) in CUBE.iter().zip(reflectances) {
        meshes.add(name, &triangles(*face, 4));
        text += &surface(name, rho, if *name == "ceiling" { 1.0 } else { 0.0 });
        text += &receiver(name);
    }
    // blocks of different heights, without bottoms
    let block = |index: usize| {
        let [x, y] = [index % 14, index / 14].map(|i| 0.06 + 0.065 * i as f64);
        let height = 0.05 + 0.4 * ((index * 7) % 11) as f64 / 11.0;
        let corner = |i: usize, z: f64| {
            [[0.0, 0.0], [0.03, 0.01], [0.02, 0.04], [-0.01, 0.03]].map(|[a, b]| [x + a, y + b, z])[i % 4]
        };
        let side = move |i: usize| {
            vec![corner(i, 0.0), corner(i + 1, 0.0), corner(i + 1, height), corner(i, height)]
        };
        let top = (0..4).map(|i| corner(i, height)).collect();
        (0..4).map(side).chain([top]).collect::<Vec<_>>()
    };
    let (count, tolerance) = if IS_OPTIMISED { (14 * 14, 5e-2) } else { (2 * 14, 0.15) };
    let blocks: Vec<Vec<Point>> = (0..count).flat_map(block).collect();
    meshes.add("blocks", &blocks);
    text = text + &surface("blocks", 0.4, 0.0) + &receiver("blocks");
    text += &asked(tolerance);
    let found = meshes.answers(&text);
    let names = CUBE.iter().map(|(name, _)| *name).chain(["blocks"]);
    let mut absorbed = [0.0; 3];
    for (name, rho) in names.zip(reflectances.into_iter().chain([0.4])) {
        let flux = answer(&found, name, Quantity::Flux);
        absorbed = [0, 1, 2].map(|i| absorbed[i] + (1.0 - rho) * flux[i]);
    }
    assert_within("absorbed", absorbed, 1.0, tolerance);
}
