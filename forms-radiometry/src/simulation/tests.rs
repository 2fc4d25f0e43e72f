//! Path tracing and radiosity find the same light.

use super::{Answer, ErrorKind, Unwatched, plan};
use crate::job::Share;
use crate::paths::driver::{Computable, Division, simulate};
use crate::paths::{Limits, World};
use crate::plan::Plan;
use crate::progress::Progress;
use crate::radiosity::driver::solved;
use crate::scene::read;
use forms_testing::scene_text::{
    CUBE, material, point_receiver, polygon, surface, surface_receiver, tolerance as asked,
};

/// Whether numeric code is optimised; otherwise fewer cases are run.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);

/// A room of 3 by 3 by 2 with a table on one leg, without lights.
const ROOM: &str = r#"
[[material]]
name = "wall"
kind = "diffuse"
reflectance = 0.6
[[material]]
name = "wood"
kind = "diffuse"
reflectance = 0.3
[[surface]]
name = "floor"
material = "wood"
polygon = [[0, 0, 0], [3, 0, 0], [3, 3, 0], [0, 3, 0]]
[[surface]]
name = "left"
material = "wall"
polygon = [[0, 0, 0], [0, 3, 0], [0, 3, 2], [0, 0, 2]]
[[surface]]
name = "right"
material = "wall"
polygon = [[3, 0, 0], [3, 0, 2], [3, 3, 2], [3, 3, 0]]
[[surface]]
name = "back"
material = "wall"
polygon = [[0, 3, 0], [3, 3, 0], [3, 3, 2], [0, 3, 2]]
[[surface]]
name = "table"
material = "wood"
polygon = [[1, 1, 0.8], [2, 1.2, 0.8], [1.8, 2.2, 0.8]]
two_sided = true
[[surface]]
name = "leg"
material = "wood"
polygon = [[1.5, 1.2, 0.1], [1.7, 1.6, 0.1], [1.7, 1.6, 0.7], [1.5, 1.2, 0.7]]
two_sided = true
"#;

const LAMP: &str = r#"
[[surface]]
name = "lamp"
material = "wall"
polygon = [[1, 1, 1.9], [1, 2, 1.9], [2, 2, 1.9], [2, 1, 1.9]]
exitance = 5
"#;

const POINT: &str = "[[light]]\nkind = \"point\"\nposition = [0.9, 1.1, 1.6]\nintensity = 2\n";
const SUN: &str = "[[light]]\nkind = \"distant\"\ndirection = [0.3, 0.5, -1]\nirradiance = 4\n";
const SKY: &str = "[ambient]\nradiance = 1.5\n";

const RECEIVERS: &str = r#"
[[receiver]]
name = "point"
kind = "point"
position = [1.2, 1.7, 0.4]
normal = [0.1, 0.3, 1]
[[receiver]]
name = "sphere"
kind = "sphere"
position = [0.6, 0.9, 1.1]
[[receiver]]
name = "ray"
kind = "ray"
origin = [2.5, 0.3, 1.5]
direction = [-1, 1.4, -1]
[[receiver]]
name = "ray to the lamp"
kind = "ray"
origin = [1.5, 1.5, 1.0]
direction = [0, 0, 1]
[[receiver]]
name = "surface"
kind = "surface"
surface = "floor"
"#;

/// Number of standard errors that hardly any answer is off by.
const HARDLY_EXCEEDED: f64 = 5.0;

fn plan_of(text: &str) -> Plan {
    let scene = read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
    plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]))
}

fn by_radiosity(text: &str) -> Vec<Answer> {
    let simulated = plan_of(text).simulated;
    let found =
        solved(simulated.scene(), simulated.effects, simulated.first_faces(), &Progress::new(&Unwatched));
    simulated.finished(found).answers
}

fn by_paths(text: &str) -> Vec<Answer> {
    traced(text, |computable| computable)
}

/// Returns the answers of path tracing, in which these receivers need no samples.
fn traced(text: &str, computable: impl Fn(Computable) -> Computable) -> Vec<Answer> {
    let simulated = plan_of(text).simulated;
    let world = World::new(simulated.shared_scene());
    let computable = computable(Computable::of(simulated.scene(), &Limits::of(&simulated.effects)));
    let division = Division { share: Share::WHOLE, budget: None };
    let (task, progress) = (simulated.task(&world, computable), Progress::new(&Unwatched));
    let found = simulate(task, division, (None, None), &progress).expect("there is no state");
    simulated.finished(found).answers
}

/// Asserts that two answers differ by no more than their errors explain.
fn assert_same(name: &str, exact: &Answer, sampled: &Answer) {
    let off = (exact.value - sampled.value).abs();
    let allowed = exact.error + HARDLY_EXCEEDED * sampled.error;
    assert!(off <= allowed, "{name}: {exact:?} and {sampled:?}");
}

fn closed_room() -> String {
    let front = polygon(&[[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [3.0, 0.0, 2.0], [3.0, 0.0, 0.0]]);
    ROOM.to_owned() + &surface("front", "wall", &front)
}

#[test]
fn paths_and_radiosity_find_the_same_light() {
    let all = [
        ("a lamp", LAMP.to_string(), ""),
        ("a point", POINT.to_string(), ""),
        ("two reflections", [LAMP, POINT].concat(), "interreflection = 2"),
        ("one reflection", [LAMP, SUN].concat(), "interreflection = 1"),
        ("no reflection", [LAMP, SKY].concat(), "interreflection = \"off\""),
        ("reflected light alone", [LAMP, SUN].concat(), "direct = \"off\""),
        ("what is seen alone", [LAMP, SUN].concat(), "direct = \"off\", interreflection = \"off\""),
        ("the sun", SUN.to_string(), ""),
        ("the sky", SKY.to_string(), ""),
        ("all of them", [LAMP, POINT, SUN, SKY].concat(), ""),
    ];
    let (count, tolerances) =
        if IS_OPTIMISED { (all.len(), [1e-2, 1e-2]) } else { (all.len(), [1e-1, 3e-2]) };
    for (name, lights, effects) in &all[..count] {
        let [finely, roughly] = tolerances.map(|tolerance| {
            let solve = format!("[solve]\ntolerance = {tolerance}\neffects = {{ {effects} }}\n");
            format!("{}{RECEIVERS}{lights}{solve}", closed_room())
        });
        for (exact, sampled) in by_radiosity(&finely).into_iter().zip(by_paths(&roughly)) {
            assert_same(name, &exact, &sampled);
        }
    }
}

/// A lamp that no other surface faces lights a point, and nothing reflects its light.
#[test]
fn where_no_light_is_reflected_the_reflected_light_is_zero_for_certain() {
    let point = point_receiver("point", [1.2, 1.7, 0.4], [0.1, 0.3, 1.0]);
    let solve = "[solve]\neffects = { direct = \"off\", interreflection = 1 }\n";
    let text = [&material("wall", 0.5), LAMP, &point, solve].concat();
    let found = by_radiosity(&text);
    assert!(found.iter().all(|answer| answer.value == 0.0 && answer.error == 0.0), "{found:?}");
}

#[test]
fn direct_light_at_points_has_closed_forms_beside_sampled_means() {
    let receivers = surface_receiver("floor")
        + &point_receiver("point", [1.2, 1.7, 0.4], [0.1, 0.3, 1.0])
        + "[[receiver]]\nname = \"ball\"\nkind = \"sphere\"\nposition = [1.0, 0.5, 0.6]\n";
    for (name, lights) in [("a lamp", LAMP), ("a point", POINT), ("the sun", SUN), ("the sky", SKY)] {
        let solve = "[solve]\ntolerance = 1e-2\neffects = { interreflection = \"off\" }\n";
        let text = [&closed_room(), &receivers, lights, solve].concat();
        let straight = traced(&text, Computable::with_straight);
        for (exact, found) in by_radiosity(&text).iter().zip(&straight) {
            assert_same(name, exact, found);
            let is_closed = found.receiver != "floor";
            assert_eq!(found.kind == ErrorKind::Bound, is_closed, "{name}: {found:?}");
            assert!(!is_closed || found.error <= 1e-12 * found.value.abs().max(1e-3), "{name}: {found:?}");
        }
    }
}

/// A closed room without occluders: nothing is hidden, so paths meet all surfaces that exact
/// visibility sees.
#[test]
fn where_nothing_is_hidden_paths_and_radiosity_find_the_same_light_too() {
    let faces = CUBE.map(|(name, corners)| surface(name, "wall", &polygon(&corners)));
    let receivers = point_receiver("point", [0.3, 0.4, 0.2], [0.1, 0.3, 1.0]) + &surface_receiver("back");
    let light = "[[light]]\nkind = \"point\"\nposition = [0.6, 0.5, 0.8]\nintensity = 2\n";
    let room =
        |tolerance| [&material("wall", 0.6), &faces.concat(), &receivers, light, &asked(tolerance)].concat();
    for (exact, sampled) in by_radiosity(&room(1e-2)).iter().zip(&by_paths(&room(5e-2))) {
        assert_same("a cube", exact, sampled);
    }
}

#[test]
fn in_front_of_round_lamps_paths_and_radiosity_find_the_same_light_too() {
    let faces = CUBE.map(|(name, corners)| surface(name, "wall", &polygon(&corners)));
    let lamp = |shape: &str| surface("lamp", "wall", shape) + "radiance = 2\n";
    let receivers = point_receiver("point", [0.3, 0.4, 0.2], [0.1, 0.3, 1.0]) + &surface_receiver("floor");
    let [finely, roughly] = if IS_OPTIMISED { [1e-2, 1e-2] } else { [1e-1, 2e-2] };
    for (name, shape) in [
        (
            "a disk on the ceiling",
            "disk = { center = [0.4, 0.5, 1], normal = [0, 0, -1], radius = 0.2 }\non = \"ceiling\"",
        ),
        ("a disk in the room", "disk = { center = [0.4, 0.5, 0.8], normal = [0, 0, -1], radius = 0.2 }"),
        ("a ball", "sphere = { center = [0.6, 0.5, 0.7], radius = 0.2 }"),
    ] {
        let room = |tolerance| {
            [&material("wall", 0.6), &faces.concat(), &lamp(shape), &receivers[..], &asked(tolerance)]
                .concat()
        };
        for (exact, sampled) in by_radiosity(&room(finely)).iter().zip(&by_paths(&room(roughly))) {
            assert_same(name, exact, sampled);
        }
    }
}

/// Many receivers with the same question: each gets paths of its own.
#[test]
fn answers_to_one_question_differ_by_their_standard_errors() {
    const COPIES: usize = 40;
    let all = [("the sky", SKY), ("a lamp", LAMP), ("a point", POINT)];
    let (count, tolerance) = if IS_OPTIMISED { (all.len(), 2e-2) } else { (1, 1e-1) };
    for (name, lights) in &all[..count] {
        let receiver = |index: usize| point_receiver(&index.to_string(), [1.2, 1.7, 0.4], [0.1, 0.3, 1.0]);
        let receivers: String = (0..COPIES).map(receiver).collect();
        let found = by_paths(&[&closed_room(), &receivers, *lights, &asked(tolerance)].concat());
        let mean = found.iter().map(|answer| answer.value).sum::<f64>() / COPIES as f64;
        let squares =
            |of: fn(&Answer, f64) -> f64| found.iter().map(|answer| of(answer, mean).powi(2)).sum::<f64>();
        let ratio = (squares(|answer, _| answer.error) / squares(|answer, mean| answer.value - mean)).sqrt();
        assert!((0.7..2.0).contains(&ratio), "{name}: errors are {ratio} deviations");
    }
}
