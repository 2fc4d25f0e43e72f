//! Light of cylinders, cones, paraboloids and annuli is the integral over their surfaces, by elements
//! and by paths.

use forms_radiometry::scene::read;
use forms_radiometry::simulation::{Answer, ErrorKind, Unwatched, plan, simulate};
use forms_testing::scene_text::elements::{mirror_aside, shining};
use forms_testing::scene_text::{Point, material, point_receiver, surface, surface_receiver, tolerance};
use std::f64::consts::PI;

/// A shape about the axis through [1, 2, z], from z = 0.5 to z = 2: its radius at the height h over
/// the lower end, and the derivative of the squared radius.
type Profile = fn(f64) -> [f64; 2];

const LENGTH: f64 = 1.5;

/// The shapes, as text without `inward`, and their profiles.
fn shapes() -> [(&'static str, &'static str, Profile); 4] {
    [
        ("cylinder", "cylinder = { from = [1, 2, 0.5], to = [1, 2, 2], radius = 0.8", |_| [0.8, 0.0]),
        ("cone", "cone = { from = [1, 2, 0.5], to = [1, 2, 2], radii = [0.9, 0]", |h| {
            let radius = 0.9 * (1.0 - h / LENGTH);
            [radius, -2.0 * radius * 0.9 / LENGTH]
        }),
        ("truncated cone", "cone = { from = [1, 2, 2], to = [1, 2, 0.5], radii = [0.9, 0.3]", |h| {
            let radius = 0.3 + 0.6 * h / LENGTH;
            [radius, 2.0 * radius * 0.6 / LENGTH]
        }),
        ("paraboloid", "paraboloid = { from = [1, 2, 0.5], to = [1, 2, 2], radius = 0.7", |h| {
            [0.7 * (h / LENGTH).sqrt(), 0.49 / LENGTH]
        }),
    ]
}

/// Returns the irradiance at a point from a front of radiance 1, ∫ cos θ cos θ′/r² dA, by the
/// midpoint rule. With ρ² = w(h): dA n = (ρ u − w′/2 k) dφ dh, u away from the axis, k along it.
fn irradiance(profile: Profile, is_inside: bool, point: Point, normal: Point) -> f64 {
    const STEPS: usize = 1200;
    let mut sum = 0.0;
    for row in 0..STEPS {
        let h = LENGTH * (row as f64 + 0.5) / STEPS as f64;
        let [radius, slope] = profile(h);
        for column in 0..STEPS {
            let (sine, cosine) = (2.0 * PI * (column as f64 + 0.5) / STEPS as f64).sin_cos();
            let place = [1.0 + radius * cosine, 2.0 + radius * sine, 0.5 + h];
            let area = [radius * cosine, radius * sine, -0.5 * slope].map(|x| if is_inside { -x } else { x });
            let way: Point = std::array::from_fn(|axis| place[axis] - point[axis]);
            let dot = |a: Point, b: Point| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
            let squared = dot(way, way);
            sum += dot(way, normal).max(0.0) * (-dot(way, area)).max(0.0) / (squared * squared);
        }
    }
    sum * 2.0 * PI / STEPS as f64 * LENGTH / STEPS as f64
}

fn answers(elements: &[&str], precision: f64) -> Vec<Answer> {
    let text = material("black", 0) + &elements.concat() + &tolerance(precision);
    let scene = read(&text, "quadric.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    simulate(&plan, &Unwatched).answers
}

fn assert_near(name: &str, answer: &Answer, expected: f64) {
    let allowed = if answer.kind == ErrorKind::Sigma { 5.0 * answer.error } else { answer.error };
    let off = (answer.value - expected).abs();
    assert!(off <= allowed + 2e-6 * expected, "{name}: {} ± {}, {expected}", answer.value, answer.error);
    assert!(answer.error <= 5e-3 * expected, "{name}: {} ± {}", answer.value, answer.error);
}

/// Points with their normals: outside of all shapes, and inside.
const OUTSIDE: [(Point, Point); 3] = [
    ([3.0, 2.5, 1.0], [-1.0, 0.0, 0.0]),
    ([2.5, 2.0, 1.5], [-0.6, 0.0, 0.8]),
    ([1.2, 2.1, -0.5], [0.0, 0.0, 1.0]),
];
const INSIDE: [(Point, Point); 2] = [([1.1, 2.0, 1.0], [0.0, 0.6, 0.8]), ([0.9, 2.05, 0.9], [1.0, 0.0, 0.0])];

#[test]
fn a_point_receives_the_integral_over_a_round_front() {
    for (name, shape, profile) in shapes() {
        for (is_inside, points) in [(false, &OUTSIDE[..]), (true, &INSIDE[..])] {
            for &(position, normal) in points {
                let expected = irradiance(profile, is_inside, position, normal);
                let lamp = format!("{shape}, inward = {is_inside} }}");
                let lamp = surface("lamp", "black", &shining(&lamp, 1));
                let here = point_receiver("here", position, normal);
                let by_elements = answers(&[&lamp, &here], 1e-3);
                assert_near(&format!("{name} from {position:?}"), &by_elements[0], expected);
                let by_paths = answers(&[&lamp, &here, &mirror_aside()], 3e-3);
                assert_eq!(by_paths[0].kind, ErrorKind::Sigma);
                assert_near(&format!("{name} from {position:?}, paths"), &by_paths[0], expected);
            }
        }
    }
}

/// In an evenly lit closed can, everything receives π times the radiance.
#[test]
fn an_evenly_lit_can_shines_evenly() {
    let side = "cylinder = { from = [0, 0, 0], to = [0, 0, 1], radius = 0.7, inward = true }";
    let ring = "annulus = { center = [0, 0, 0], normal = [0, 0, 1], radii = [0.4, 0.7] }";
    let tip = "cone = { from = [0, 0, 0], to = [0, 0, -0.6], radii = [0.4, 0], inward = true }";
    let cover = "paraboloid = { from = [0, 0, 1.4], to = [0, 0, 1], radius = 0.7, inward = true }";
    let all = [("side", side), ("ring", ring), ("tip", tip), ("cover", cover)];
    let lit: String = all.map(|(name, shape)| surface(name, "black", &shining(shape, 1))).concat();
    let asked: String = all.map(|(name, _)| surface_receiver(name)).concat();
    let here = point_receiver("here", [0.1, 0.2, 0.3], [0.6, 0.0, 0.8]);
    for aside in [String::new(), mirror_aside()] {
        for answer in answers(&[&lit, &here, &aside], 2e-3) {
            assert_near("a point in the can", &answer, PI);
        }
    }
    for answer in answers(&[&lit, &asked, &mirror_aside()], 2e-3) {
        if answer.quantity.name() == "irradiance" {
            assert_near(&answer.receiver, &answer, PI);
        }
    }
}

/// A ray through a glass of water on its axis: at normal incidence R = ((n − 1)/(n + 1))² is
/// reflected at both ends, and e^(−σd) is transmitted between them.
#[test]
fn a_cylinder_with_disks_at_its_ends_is_filled_with_water() {
    let water = "[[medium]]\nname = \"water\"\nsigma_a = 0.5\nsigma_s = 0\nn = 1.33\n\
        [[material]]\nname = \"glass\"\nkind = \"dielectric\"\ninside = \"water\"\n";
    let side = surface("side", "glass", "cylinder = { from = [0, 0, 0], to = [0, 0, 2], radius = 1 }");
    let end = |name: &str, height: f64, up: f64| {
        let shape = format!("disk = {{ center = [0, 0, {height:?}], normal = [0, 0, {up:?}], radius = 1 }}");
        surface(name, "glass", &shape)
    };
    let ray = "[[receiver]]\nname = \"ray\"\nkind = \"ray\"\norigin = [0, 0, 5]\ndirection = [0, 0, -1]\n";
    let sky = "[ambient]\nradiance = 1\n";
    let elements = [water, &side, &end("bottom", 0.0, -1.0), &end("top", 2.0, 1.0), ray, sky];
    let found = &answers(&elements, 1e-4)[0];
    let (r, t) = ((0.33_f64 / 2.33).powi(2), (-1.0_f64).exp());
    // reflected at the top, and after any number of reflections inside
    let expected = r + (1.0 - r).powi(2) * (t + r * t * t) / (1.0 - r * r * t * t);
    assert!(
        (found.value - expected).abs() <= found.error + 1e-12,
        "{} ± {}, {expected}",
        found.value,
        found.error
    );

    let open = [water, &side, &end("bottom", 0.0, -1.0), &end("top", 2.1, 1.0), ray].concat();
    let text = material("black", 0) + &open;
    let errors = read(&text, "open.toml").expect_err("the top is not closed");
    let message = errors[0].to_string();
    assert!(message.contains("the rim of `side` around [0, 0, 2] meets no other surface"), "{message}");
}
