//! Spheres and disks that a point sees as a whole equal their closed forms, whatever else is in the
//! scene. Those that are partly hidden are within the error of their tessellation.

use forms_radiometry::scene::read;
use forms_radiometry::simulation::{Answer, Unwatched, plan, simulate};
use std::f64::consts::PI;

use forms_testing::scene_text::elements::{disk, probe, shining, sphere, square, two_sided};
use forms_testing::scene_text::{
    Point, material, point_receiver, polygon, surface, surface_receiver, tolerance,
};

const UP: Point = [0.0, 0.0, 1.0];
const DOWN: Point = [0.0, 0.0, -1.0];
const ALONG: Point = [1.0, 0.0, 0.0];
const HERE: Point = [0.0; 3];

fn here(normal: Point) -> String {
    point_receiver("here", HERE, normal)
}

/// Returns a sphere of radius 1, two above a point. `lamp` is a disk of radius 1 with this
/// normal, one above the point. Both have radiance 1.
fn ball() -> String {
    surface("ball", "black", &shining(&sphere([0.0, 0.0, 2.0], 1.0, false), 1))
}

fn lamp(normal: Point) -> String {
    surface("lamp", "black", &shining(&disk(UP, normal, 1.0), 1))
}

/// Returns a black square at this height, with sides of twice this length.
fn wall(height: f64, half: f64) -> String {
    surface("wall", "black", &square(height, half, true))
}

/// Settings of the solver: the plan decides, or occlusion is simulated in any case.
const SOLVES: [&str; 2] = ["", "effects = { occlusion = \"on\" }\n"];

/// Returns the answers of the first receiver of these elements, at a tolerance of 1 %.
fn answers(elements: &[String], solve: &str) -> Vec<Answer> {
    let text = material("black", 0) + &elements.concat() + &tolerance(1e-2) + solve;
    let scene = read(&text, "round.toml").unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}\n{text}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    let first = found.answers[0].receiver.clone();
    let answers: Vec<_> = found.answers.into_iter().filter(|answer| answer.receiver == first).collect();
    // the error reported for all answers is no less than the error of these
    let largest = |of: fn(&Answer) -> f64| answers.iter().map(of).fold(0.0, f64::max);
    let [error, scale] = [largest(|answer| answer.error), largest(|answer| answer.value.abs())];
    let told = found.history.last().map_or(0.0, |moment| moment.error);
    assert!(
        scale == 0.0 || error / scale <= told * (1.0 + 1e-9) || error <= 1e-11,
        "{error} of {scale}: {told}\n{text}"
    );
    answers
}

/// Asserts claims: a name, elements, the expected first answer, and the largest error that is
/// reported for it.
fn assert_all(claims: &[(&str, Vec<String>, f64, f64)]) {
    for (name, elements, expected, most) in claims {
        for solve in SOLVES {
            let Answer { value, error, .. } = answers(elements, solve)[0];
            // the expected value is rounded too
            let off = (value - expected).abs() - 2.0 * f64::EPSILON * expected.abs();
            assert!(off <= error, "{name}: {value} ± {error}, {expected}");
            assert!(error <= *most, "{name}: {value} ± {error}");
        }
    }
}

const DIGITS: f64 = 4.0 * f64::EPSILON;

#[test]
fn a_round_light_that_nothing_hides_is_its_closed_form() {
    // the angular radius of the ball
    let alpha = PI / 6.0;
    let half_of_ball = alpha - alpha.sin() * alpha.cos();
    let shell = surface("shell", "black", &shining(&sphere([0.3, 0.0, 0.1], 1.0, true), 1));
    let beside = [[2.0, 2.0, 0.5], [3.0, 2.0, 0.5], [3.0, 3.0, 0.5], [2.0, 3.0, 0.5]];
    let beside = surface("plate", "black", &polygon(&beside));
    let two_sided = two_sided(&lamp(UP)) + "\n";
    let sky =
        |shape: &str| vec![here(UP), surface("dark", "black", shape), "[ambient]\nradiance = 1\n".into()];
    let map = vec![here(UP), ball(), wall(-1.0, 1.0), surface_receiver("wall") + "grid = [4, 4]\n"];
    assert_all(&[
        ("a sphere", vec![here(UP), ball()], PI / 4.0, DIGITS),
        ("a sphere at an angle", vec![here([0.6, 0.0, 0.8]), ball()], 0.2 * PI, DIGITS),
        ("a sphere cut by the horizon", vec![here(ALONG), ball()], half_of_ball, DIGITS),
        ("a sphere from inside", vec![here(UP), shell], PI, 1e-11),
        ("a disk", vec![here(UP), lamp(DOWN)], PI / 2.0, DIGITS),
        ("a disk from its back", vec![here(UP), lamp(UP)], 0.0, 0.0),
        ("a disk of two sides from its back", vec![here(UP), two_sided], PI / 2.0, DIGITS),
        ("a disk beside a plate", vec![here(UP), lamp(DOWN), beside], PI / 2.0, DIGITS),
        ("a disk behind a wall", vec![here(UP), lamp(DOWN), wall(0.5, 3.0)], 0.0, DIGITS),
        ("the sky beside a sphere", sky(&sphere([0.0, 0.0, 2.0], 1.0, false)), 0.75 * PI, DIGITS),
        ("the sky beside a disk", sky(&disk(UP, UP, 1.0)), PI / 2.0, DIGITS),
        ("a sphere, while a map is asked for too", map, PI / 4.0, DIGITS),
    ]);
}

#[test]
fn a_round_light_that_is_cut_is_within_the_error_of_its_pieces() {
    let half = wall(0.5, 1.0).replace("[-1.0, ", "[0.0, ");
    // the half x > 0 at the height 1, with x/ρ⁴ per area, ρ² = 1 + r²: ∫ cos φ dφ = 2, and ∫ r²/(1
    // + r²)² dr = (atan 1 − ½)/2
    let half_disk = PI / 4.0 - 0.5;
    assert_all(&[
        ("a disk cut by the horizon", vec![here(ALONG), lamp(DOWN)], half_disk, 1e-2),
        ("a disk of which a plate hides half", vec![here(UP), lamp(DOWN), half], PI / 4.0, 1e-2),
    ]);
}

/// Rotates a point about the axis z.
fn turned(degrees: f64, [x, y, z]: Point) -> Point {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    [cosine * x - sine * y, sine * x + cosine * y, z]
}

/// Returns the centre of a sphere of radius 1. The sphere reaches this far across the plane through
/// the point and the edge x = 1 of a lamp at the height 2.
fn beside_the_way(into: f64) -> Point {
    [0.5 + 0.5 * 5.0_f64.sqrt() * (1.0 - into), 0.0, 1.0]
}

/// A sphere that reaches a little into the line of sight is missed by its coarsest tessellation,
/// where that lies inside the sphere.
#[test]
fn what_a_sphere_hides_beyond_its_pieces_is_in_the_error() {
    for degrees in [0.0_f64, 9.0, 18.0, 27.0] {
        let turned = |place| turned(degrees, place);
        let corners = [[-1.0, -1.0, 2.0], [-1.0, 1.0, 2.0], [1.0, 1.0, 2.0], [1.0, -1.0, 2.0]].map(turned);
        let lamp = surface("lamp", "black", &shining(&polygon(&corners), 1));
        let open = answers(&[here(UP), lamp.clone()], "")[0].value;
        for into in [0.002, 0.01, 0.02] {
            let center = beside_the_way(into);
            let ball = surface("ball", "black", &sphere(turned(center), 1.0, false));
            let hidden = hidden_of_lamp(center);
            assert!(hidden > 1e-5, "{hidden}");
            for solve in SOLVES {
                let found = &answers(&[here(UP), lamp.clone(), ball.clone()], solve)[0];
                let off = (found.value + hidden - open).abs();
                assert!(off <= found.error + 0.01 * hidden, "{degrees}°: {found:?}, {open} − {hidden}");
            }
        }
    }
}

#[test]
fn a_sphere_hides_a_point_of_light_where_it_is_and_not_where_its_pieces_are() {
    for degrees in [0.0_f64, 9.0, 18.0, 27.0] {
        let turned = |place| turned(degrees, place);
        let at = turned([1.0, 0.0, 2.0]);
        let light =
            format!("[[light]]\nname = \"light\"\nkind = \"point\"\nposition = {at:?}\nintensity = 1\n");
        for into in [-0.01, -1e-6, 1e-6, 0.01] {
            let center = beside_the_way(into);
            let ball = surface("ball", "black", &sphere(turned(center), 1.0, false));
            let found = &answers(&[here(UP), ball, light.clone()], "")[0];
            // I cos θ/r²
            let expected = if into > 0.0 { 0.0 } else { 2.0 / 5.0_f64.powf(1.5) };
            let off = (found.value - expected).abs();
            assert!(off <= found.error + DIGITS, "{degrees}°, {into}: {found:?}, {expected}");
            assert!(found.error <= DIGITS || into < 0.0, "{degrees}°, {into}: {found:?}");
        }
    }
}

/// Returns the light of the lamp that a unit sphere about a point hides, by the centres of small
/// squares: z²/ρ⁴ per area, z = 2.
fn hidden_of_lamp([x, _, z]: Point) -> f64 {
    const STEP: f64 = 1e-3;
    let mut sum = 0.0;
    for (i, j) in (0..400).flat_map(|i| (-500..500).map(move |j| (i, j))) {
        let (u, v) = (1.0 - STEP * (f64::from(i) + 0.5), STEP * (f64::from(j) + 0.5));
        let squared = u * u + v * v + 4.0;
        let along = u * x + 2.0 * z;
        let is_hidden = x * x + z * z - along * along / squared < 1.0;
        sum += if is_hidden { 4.0 / (squared * squared) * STEP * STEP } else { 0.0 };
    }
    sum
}

#[test]
fn a_round_light_flows_along_the_way_from_its_middle() {
    let found = answers(&[probe("here", HERE), ball()], "");
    let expected = [2.0 * PI * (1.0 - 0.75_f64.sqrt()), 0.0, 0.0, -PI / 4.0];
    for (answer, expected) in found.iter().zip(expected) {
        let off = (answer.value - expected).abs();
        assert!(off <= answer.error + 2.0 * f64::EPSILON && answer.error <= DIGITS, "{answer:?}, {expected}");
    }
    let on_axis = &answers(&[probe("here", HERE), lamp(DOWN)], "")[0];
    let expected = 2.0 * PI * (1.0 - 0.5_f64.sqrt());
    assert!((on_axis.value - expected).abs() <= 2.0 * DIGITS && on_axis.error <= DIGITS, "{on_axis:?}");
}
