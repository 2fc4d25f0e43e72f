//! Shadows of point and distant lights: random suns and lamps above plates and a ground, compared
//! with an integration over slabs of the ground.
//!
//! The ground is black or reflects; plates are black. So the light at a point below all plates is
//! that of the lit part of the ground, a closed form. `FORMS_SHADOWS` is the number of scenes of
//! each kind.

mod slabs;

use forms_kernels::solid_angle_triangle;
use forms_radiometry::form_factor::form_factor;
use forms_radiometry::geometry::{Polygon, Vector};
use forms_radiometry::scene::{Effect, Scene, read};
use forms_radiometry::simulation::{Answer, ErrorKind, Quantity, Unwatched, plan, simulate};
use forms_testing::SplitMix;
use forms_testing::scene_text::{material, point_receiver, polygon, surface, surface_receiver, tolerance};
use slabs::{Trapezoid, area, uncovered};
use std::f64::consts::PI;

/// Half of the ground's side.
const HALF: f64 = 5.0;
/// Height of the points; plates are above it.
const HEIGHT: f64 = 0.4;

/// Part of the estimates that may be off by more than their errors.
const ESTIMATES: f64 = 0.02;

/// Light source.
#[derive(Clone, Copy, Debug)]
enum Source {
    Sun(Vector),
    Lamp(Vector),
}

/// Scene whose exact answers are known.
struct Case {
    source: Source,
    plates: Vec<Vec<Vector>>,
    reflectance: f64,
    tolerance: f64,
    points: Vec<(Vector, Vector)>,
}

fn between(random: &mut SplitMix, low: f64, high: f64) -> f64 {
    low + (high - low) * random.unit()
}

fn array(Vector { x, y, z }: Vector) -> [f64; 3] {
    [x, y, z]
}

/// Returns a rectangle or triangle of random orientation, above the points.
fn plate(random: &mut SplitMix) -> Vec<Vector> {
    let mut vector = |size: f64| {
        let mut coordinate = || between(random, -size, size);
        Vector::new(coordinate(), coordinate(), coordinate())
    };
    let (along, other) = (vector(1.0), vector(1.0));
    let across = along.cross(other).cross(along);
    let (along, across) = (along.unit().expect("a way"), across.unit().expect("another"));
    let [length, width] = [(); 2].map(|()| between(random, 0.05, 1.5));
    let middle =
        Vector::new(between(random, -4.0, 4.0), between(random, -4.0, 4.0), between(random, 2.2, 3.0));
    let corner = |u: f64, v: f64| middle + (u * length) * along + (v * width) * across;
    let mut corners = vec![corner(-0.5, -0.5), corner(0.5, -0.5), corner(0.5, 0.5), corner(-0.5, 0.5)];
    corners.truncate(3 + random.below(2));
    corners
}

impl Case {
    fn new(random: &mut SplitMix, is_lamp: bool, reflectance: f64) -> Self {
        let mut slope = || between(random, -0.9, 0.9);
        let source = if is_lamp {
            Source::Lamp(Vector::new(3.0 * slope(), 3.0 * slope(), 6.0 + 2.0 * slope()))
        } else {
            Source::Sun(Vector::new(slope(), slope(), -1.0).unit().expect("a direction"))
        };
        let plates = (0..1 + random.below(4)).map(|_| plate(random)).collect();
        let mut point = || {
            let position = Vector::new(between(random, -3.0, 3.0), between(random, -3.0, 3.0), HEIGHT);
            (position, Vector::new(between(random, -0.3, 0.3), between(random, -0.3, 0.3), -1.0))
        };
        let points = vec![point(), point()];
        Self { source, plates, reflectance, tolerance: random.of(&[1e-2, 1e-3, 1e-4]), points }
    }

    fn text(&self) -> String {
        let light = match self.source {
            Source::Sun(direction) => {
                format!("kind = \"distant\"\ndirection = {:?}\nirradiance = 1000\n", array(direction))
            }
            Source::Lamp(position) => {
                format!("kind = \"point\"\nposition = {:?}\nintensity = 1000\n", array(position))
            }
        };
        let corner = |x: f64, y: f64| [x * HALF, y * HALF, 0.0];
        let ground = [corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        let mut text =
            format!("[[light]]\n{light}") + &material("black", 0) + &material("ground", self.reflectance);
        text += &surface("ground", "ground", &polygon(&ground));
        for (number, plate) in self.plates.iter().enumerate() {
            let corners: Vec<[f64; 3]> = plate.iter().copied().map(array).collect();
            let shape = polygon(&corners) + "\ntwo_sided = true";
            text += &surface(&format!("plate {number}"), "black", &shape);
        }
        for (number, &(position, normal)) in self.points.iter().enumerate() {
            text += &point_receiver(&format!("point {number}"), array(position), array(normal));
        }
        text + &surface_receiver("ground") + &tolerance(self.tolerance)
    }

    /// Returns the lit part of the ground.
    fn lit(&self) -> Vec<Trapezoid> {
        let shadow = |plate: &Vec<Vector>| {
            let of_corner = |&v: &Vector| {
                let away = match self.source {
                    Source::Sun(direction) => (v.z / -direction.z) * direction,
                    Source::Lamp(lamp) => (v.z / (lamp.z - v.z)) * (v - lamp),
                };
                [(v + away).x, (v + away).y]
            };
            plate.iter().map(of_corner).collect()
        };
        let shadows: Vec<Vec<slabs::Point>> = self.plates.iter().map(shadow).collect();
        uncovered([[-HALF; 2], [HALF; 2]], &shadows)
    }

    /// Returns the mean direct irradiance of the ground, and the light that the ground reflects to
    /// each point.
    fn right(&self) -> (f64, Vec<f64>) {
        let lit = self.lit();
        let whole = 4.0 * HALF * HALF;
        let mean = match self.source {
            Source::Sun(direction) => 1000.0 * -direction.z * area(&lit) / whole,
            Source::Lamp(lamp) => {
                1000.0 * lit.iter().map(|part| solid_angle(lamp, part)).sum::<f64>() / whole
            }
        };
        let of_point = |&(position, normal): &(Vector, Vector)| {
            let of_part = |part: &Trapezoid| match self.source {
                Source::Sun(direction) => 1000.0 * -direction.z * factor(position, normal, part),
                Source::Lamp(lamp) => 1000.0 * reflected(lamp, position, normal, part),
            };
            self.reflectance * lit.iter().map(of_part).sum::<f64>()
        };
        (mean, self.points.iter().map(of_point).collect())
    }

    fn answers(&self) -> Vec<Answer> {
        let scene: Scene =
            read(&self.text(), "shadows.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        simulate(&plan, &Unwatched).answers
    }
}

fn corners(part: &Trapezoid) -> Vec<Vector> {
    let mut corners: Vec<Vector> = part.iter().map(|&[x, y]| Vector::new(x, y, 0.0)).collect();
    corners.dedup_by(|a, b| (*a - *b).length() < 1e-13);
    if (corners[0] - corners[corners.len() - 1]).length() < 1e-13 {
        corners.pop();
    }
    corners
}

fn solid_angle(lamp: Vector, part: &Trapezoid) -> f64 {
    let v = corners(part);
    let of_triangle = |a: Vector, b: Vector, c: Vector| {
        solid_angle_triangle(lamp.x, lamp.y, lamp.z, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z).abs()
    };
    (1..v.len().saturating_sub(1)).map(|i| of_triangle(v[0], v[i], v[i + 1])).sum()
}

/// Integrates cos θ/r² of a lamp times the form factor over the places of a part, by Gauss rules on
/// pieces that are small compared with their distance.
fn reflected(lamp: Vector, position: Vector, normal: Vector, part: &Trapezoid) -> f64 {
    const SMALL: f64 = 0.4;
    const RULE: [[f64; 2]; 5] = [
        [0.046_910_077_030_668, 0.118_463_442_528_094_5],
        [0.230_765_344_947_158_5, 0.239_314_335_249_683_2],
        [0.5, 0.284_444_444_444_444_4],
        [0.769_234_655_052_841_5, 0.239_314_335_249_683_2],
        [0.953_089_922_969_332, 0.118_463_442_528_094_5],
    ];
    let normal = normal.unit().expect("a normal");
    let at = |place: Vector| {
        let [from_lamp, from_point] = [lamp, position].map(|from| from - place);
        let [lamp_squared, point_squared] = [from_lamp, from_point].map(|way| way.dot(way));
        let leaving = from_lamp.z * from_point.z / (lamp_squared.sqrt() * point_squared.sqrt());
        let arriving = (-normal.dot(from_point)).max(0.0) / point_squared.sqrt();
        leaving * arriving / (PI * lamp_squared * point_squared)
    };
    let mut open = vec![*part];
    let mut sum = 0.0;
    while let Some(part @ [a, b, c, d]) = open.pop() {
        let place = |u: f64, v: f64| {
            let along = |p: &slabs::Point, q: &slabs::Point| [0, 1].map(|i| p[i] + u * (q[i] - p[i]));
            let (low, high) = (along(&a, &b), along(&d, &c));
            [low[0], low[1] + v * (high[1] - low[1])]
        };
        let [x, y] = place(0.5, 0.5);
        let extent = part.iter().map(|corner| (corner[0] - x).hypot(corner[1] - y)).fold(0.0, f64::max);
        if extent > SMALL * (position - Vector::new(x, y, 0.0)).length() {
            let quarter = |[u, v]: [f64; 2]| {
                [place(u, v), place(u + 0.5, v), place(u + 0.5, v + 0.5), place(u, v + 0.5)]
            };
            open.extend([[0.0, 0.0], [0.5, 0.0], [0.0, 0.5], [0.5, 0.5]].map(quarter));
            continue;
        }
        for [u, w] in RULE {
            let height = place(u, 1.0)[1] - place(u, 0.0)[1];
            for [v, x] in RULE {
                let [px, py] = place(u, v);
                sum += w * x * (b[0] - a[0]) * height * at(Vector::new(px, py, 0.0));
            }
        }
    }
    sum
}

fn factor(position: Vector, normal: Vector, part: &Trapezoid) -> f64 {
    let polygon = Polygon::new(corners(part));
    // a part without area has no polygon
    polygon.map_or(0.0, |polygon| form_factor(position, normal, &polygon))
}

fn count() -> usize {
    std::env::var("FORMS_SHADOWS").map_or(30, |count| count.parse().expect("a number"))
}

/// Returns how far an answer can be off: hardly any of random errors is above five standard errors.
fn reach(answer: &Answer) -> f64 {
    if answer.kind == ErrorKind::Sigma { 5.0 * answer.error } else { answer.error }
}

/// Returns the answers whose error is exceeded, or whose error misses the tolerance, and the number
/// of all answers, over [`count`] scenes.
fn outside(seed: u64, is_lamp: bool, reflectance: f64) -> (Vec<String>, usize) {
    let mut random = SplitMix(seed);
    let (mut outside, mut all) = (Vec::new(), 0);
    for number in 0..count() {
        let case = Case::new(&mut random, is_lamp, reflectance);
        let (mean, points) = case.right();
        let answers = case.answers();
        let mut compare = |what: &str, answer: &Answer, right: f64| {
            all += 1;
            let off = (answer.value - right).abs();
            let is_met = answer.error <= case.tolerance * right.abs() + 1e-9;
            if off.is_nan() || off > reach(answer) + 1e-9 * right.abs() || !is_met {
                let (value, error) = (answer.value, answer.error);
                outside.push(format!(
                    "{number}, {what} to {:e}: {value} ± {error:e}, right is {right}",
                    case.tolerance
                ));
            }
        };
        for answer in answers.iter().filter(|answer| answer.quantity == Quantity::Irradiance) {
            let point = answer
                .receiver
                .strip_prefix("point ")
                .map(|number| number.parse::<usize>().expect("a number"));
            match point {
                None => compare("mean", answer, mean),
                Some(point) => compare("point", answer, points[point]),
            }
        }
    }
    (outside, all)
}

#[test]
fn the_mean_of_a_black_ground_is_that_of_its_lit_part() {
    for (name, seed, is_lamp) in [("sun", 1, false), ("lamp", 2, true)] {
        let (outside, all) = outside(seed, is_lamp, 0.0);
        assert!(outside.is_empty(), "{name}: {} of {all}: {outside:#?}", outside.len());
    }
}

#[test]
fn points_below_plates_get_what_the_lit_part_of_the_ground_reflects() {
    for (name, seed, is_lamp) in [("sun", 3, false), ("lamp", 4, true)] {
        let (outside, all) = outside(seed, is_lamp, 0.5);
        // sunlight is uniform where it arrives; the light of a lamp is a polynomial on elements,
        // whose errors are estimates
        let most = if is_lamp { ESTIMATES * all as f64 } else { 0.0 };
        assert!(outside.len() as f64 <= most, "{name}: {} of {all}: {outside:#?}", outside.len());
    }
}

#[test]
fn answers_to_all_tolerances_agree_within_their_errors() {
    let mut random = SplitMix(6);
    let (mut apart, mut all) = (Vec::new(), 0);
    for number in 0..count() {
        let mut case = Case::new(&mut random, number % 2 == 0, 0.5);
        let of_tolerance = |tolerance: f64| {
            case.tolerance = tolerance;
            case.answers()
        };
        let found = [1e-2, 1e-3, 1e-4, 1e-5, 1e-6].map(of_tolerance);
        for (index, finer) in found.iter().enumerate() {
            for (one, other) in found[..index].iter().flatten().zip(finer.iter().cycle()) {
                let off = (one.value - other.value).abs() / (reach(one) + reach(other));
                assert!(off <= 2.0, "{number}: {one:?}, {other:?}");
                if off > 1.0 {
                    apart.push(format!("{number}, {}: {off} of their errors", one.receiver));
                }
                all += 1;
            }
        }
    }
    assert!(apart.len() <= all / 10_000, "{} of {all}: {apart:#?}", apart.len());
}

/// Returns a black room of 4 × 3 × 3 with a window in the wall y = 0, lit by the sun; and the exact
/// mean of its floor.
fn room(random: &mut SplitMix) -> (String, f64) {
    let [width, depth, height] = [4.0, 3.0, 3.0];
    let [left, low] = [between(random, 0.2, 3.0), between(random, 0.2, 2.0)];
    let [right, high] = [left + between(random, 0.01, 0.9), low + between(random, 0.01, 0.9)];
    let way = Vector::new(between(random, -0.8, 0.8), between(random, 0.2, 2.0), -1.0);
    let direction = way.unit().expect("a direction");
    let mut text = material("black", 0);
    let mut add = |name: &str, corners: [[f64; 3]; 4]| text += &surface(name, "black", &polygon(&corners));
    let front = |x: [f64; 2], z: [f64; 2]| {
        [[x[0], 0.0, z[0]], [x[0], 0.0, z[1]], [x[1], 0.0, z[1]], [x[1], 0.0, z[0]]]
    };
    add("below", front([0.0, width], [0.0, low]));
    add("above", front([0.0, width], [high, height]));
    add("left", front([0.0, left], [low, high]));
    add("right", front([right, width], [low, high]));
    add("floor", [[0.0, 0.0, 0.0], [width, 0.0, 0.0], [width, depth, 0.0], [0.0, depth, 0.0]]);
    add("ceiling", [[0.0, 0.0, height], [0.0, depth, height], [width, depth, height], [width, 0.0, height]]);
    add("back", [[0.0, depth, 0.0], [width, depth, 0.0], [width, depth, height], [0.0, depth, height]]);
    add("side", [[0.0, 0.0, 0.0], [0.0, depth, 0.0], [0.0, depth, height], [0.0, 0.0, height]]);
    add("other side", [[width, 0.0, 0.0], [width, 0.0, height], [width, depth, height], [width, depth, 0.0]]);
    text +=
        &format!("[[light]]\nkind = \"distant\"\ndirection = {:?}\nirradiance = 1000\n", array(direction));
    text += &(surface_receiver("floor") + &tolerance(random.of(&[1e-2, 1e-4])));
    let corner = |x: f64, z: f64| [x + z * way.x, z * way.y];
    let window = vec![corner(left, low), corner(right, low), corner(right, high), corner(left, high)];
    let dark = uncovered([[0.0; 2], [width, depth]], &[window]);
    (text, 1000.0 * -direction.z * (1.0 - area(&dark) / (width * depth)))
}

#[test]
fn the_sun_through_a_window_lights_what_is_behind_it() {
    let mut random = SplitMix(5);
    for number in 0..count() {
        let (text, right) = room(&mut random);
        let scene = read(&text, "room.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let mean = &simulate(&plan, &Unwatched).answers[0];
        let off = (mean.value - right).abs();
        assert!(off <= mean.error + 1e-9, "{number}: {} ± {:e}, right is {right}", mean.value, mean.error);
    }
}

#[test]
fn without_occlusion_plates_hide_nothing_of_the_light_from_outside() {
    let mut random = SplitMix(6);
    for number in 0..count() {
        let mut text = material("black", 0);
        for plate_number in 0..=1 + random.below(6) {
            let corners: Vec<[f64; 3]> = plate(&mut random).into_iter().map(array).collect();
            text += &surface(&format!("plate {plate_number}"), "black", &polygon(&corners));
        }
        text += "[ambient]\nradiance = 10\n[solve]\neffects = { occlusion = \"off\" }\n";
        let place = [between(&mut random, -2.0, 2.0), between(&mut random, -2.0, 2.0), 0.4];
        text += &point_receiver("below", place, [0.0, 0.0, 1.0]);
        let scene = read(&text, "plates.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
        let answer = &simulate(&plan, &Unwatched).answers[0];
        let hides = plan
            .effects()
            .iter()
            .any(|effect| effect.effect == Effect::Occlusion && effect.bound != Some(0.0));
        let off = (answer.value - 10.0 * PI).abs();
        assert!(!hides || off <= answer.error, "{number}: {} ± {:e}", answer.value, answer.error);
    }
}

#[test]
fn slabs_have_the_area_that_is_left() {
    let square =
        |[x, y]: [f64; 2], side: f64| vec![[x, y], [x + side, y], [x + side, y + side], [x, y + side]];
    for (name, covers, expected) in [
        ("nothing", vec![], 100.0),
        ("a square", vec![square([0.0; 2], 2.0)], 96.0),
        ("the same twice", vec![square([0.0; 2], 2.0); 2], 96.0),
        ("two that overlap", vec![square([0.0; 2], 2.0), square([1.0; 2], 2.0)], 93.0),
        ("one that leaves", vec![square([4.0; 2], 2.0)], 99.0),
        ("a triangle", vec![vec![[0.0, 0.0], [2.0, 0.0], [0.0, 2.0]]], 98.0),
        ("all", vec![square([-6.0; 2], 12.0)], 0.0),
    ] {
        let found = area(&uncovered([[-5.0; 2], [5.0; 2]], &covers));
        assert!((found - expected).abs() < 1e-12, "{name}: {found}");
    }
}
