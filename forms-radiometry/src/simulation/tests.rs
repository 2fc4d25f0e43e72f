//! Light gathered by rays and light gathered by exact visibility are the same.

use super::{Answer, Unwatched, plan};
use crate::effects::Hiding;
use crate::progress::Progress;
use crate::radiosity::driver::solved;
use crate::radiosity::{Gathering, Question};
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
name = "surface"
kind = "surface"
surface = "floor"
"#;

fn by(gathering: Gathering, text: &str) -> Vec<Answer> {
    let scene = read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let scene = (plan.simulated.scene(), plan.simulated.effects);
    plan.simulated.finished(solved(&[gathering], scene, &Progress::new(&Unwatched))).answers
}

fn by_rays(text: &str) -> Vec<Answer> {
    by(Gathering::Rays { most: f64::INFINITY }, text)
}

fn closed_room() -> String {
    let front = polygon(&[[0.0, 0.0, 0.0], [0.0, 0.0, 2.0], [3.0, 0.0, 2.0], [3.0, 0.0, 0.0]]);
    ROOM.to_owned() + &surface("front", "wall", &front)
}

#[test]
fn rays_and_exact_pieces_find_the_same_light() {
    let all = [
        ("a lamp", LAMP.to_string(), ""),
        ("a point", POINT.to_string(), ""),
        ("two reflections", [LAMP, POINT].concat(), "interreflection = 2"),
        ("one reflection", [LAMP, SUN].concat(), "interreflection = 1"),
        ("no reflection", [LAMP, SKY].concat(), "interreflection = \"off\""),
        ("reflected light alone", [LAMP, SUN].concat(), "direct = \"off\""),
        ("the sun", SUN.to_string(), ""),
        ("the sky", SKY.to_string(), ""),
        ("all of them", [LAMP, POINT, SUN, SKY].concat(), ""),
    ];
    let (count, tolerances) = if IS_OPTIMISED { (all.len(), [1e-2, 3e-2]) } else { (3, [5e-2, 1e-1]) };
    for (name, lights, effects) in &all[..count] {
        let [pieces, rays] = tolerances.map(|tolerance| {
            let solve = format!("[solve]\ntolerance = {tolerance}\neffects = {{ {effects} }}\n");
            format!("{}{RECEIVERS}{lights}{solve}", closed_room())
        });
        for (a, b) in by(Gathering::Pieces, &pieces).iter().zip(by_rays(&rays)) {
            let (off, allowed) = ((a.value - b.value).abs(), a.error + b.error);
            let what = format!("{name}: {} {:?}", a.receiver, a.quantity);
            assert!(off <= allowed, "{what}: {} ± {:e} and {} ± {:e}", a.value, a.error, b.value, b.error);
        }
    }
}

/// A closed room without occluders: nothing is hidden, so rays meet all surfaces that exact
/// visibility sees.
#[test]
fn where_nothing_is_hidden_rays_and_exact_pieces_find_the_same_light_too() {
    let faces = CUBE.map(|(name, corners)| surface(name, "wall", &polygon(&corners)));
    let receivers = point_receiver("point", [0.3, 0.4, 0.2], [0.1, 0.3, 1.0]) + &surface_receiver("back");
    let light = "[[light]]\nkind = \"point\"\nposition = [0.6, 0.5, 0.8]\nintensity = 2\n";
    let room =
        |tolerance| [&material("wall", 0.6), &faces.concat(), &receivers, light, &asked(tolerance)].concat();
    let rays = by_rays(&room(5e-2));
    for (a, b) in by(Gathering::Pieces, &room(1e-2)).iter().zip(&rays) {
        let (off, allowed) = ((a.value - b.value).abs(), a.error + b.error);
        assert!(off <= allowed, "{} {:?}: {} and {}, {allowed:e}", a.receiver, a.quantity, a.value, b.value);
    }
}

/// Many faces and one number at low accuracy: rays are chosen, unless they would meet occluders
/// that the file omits.
#[test]
fn what_is_left_out_is_not_met_by_rays() {
    let sphere = "sphere = { center = [0, 0, 0], radius = 1, inward = true }";
    let wall = material("wall", 0.6) + &surface("shell", "wall", &format!("{sphere}\nexitance = 1"));
    let receiver = point_receiver("point", [0.0, 0.0, 0.2], [0.0, 0.0, 1.0]);
    let scene = read(&(wall + &receiver + &asked(0.1)), "test.toml").expect("the scene is right");
    let question = |orders| Question { orders, receives: vec![false], direct: true, is_seen: false };
    let gathering = |orders, hiding| Gathering::at_each_level(&scene, &question(orders), hiding, 0)[0];
    assert!(matches!(gathering(None, Hiding::Simulated), Gathering::Rays { .. }));
    assert!(matches!(gathering(None, Hiding::Nothing), Gathering::Rays { .. }));
    assert_eq!(gathering(None, Hiding::LeftOut), Gathering::Pieces);
    assert_eq!(gathering(Some(0), Hiding::Nothing), Gathering::Pieces);
}

/// Many receivers with the same question: each gets rays of its own.
#[test]
fn answers_to_one_question_differ_less_than_their_errors_and_not_much_less() {
    const COPIES: usize = 40;
    let all = [("the sky", SKY), ("a lamp", LAMP), ("a point", POINT)];
    let (count, tolerance) = if IS_OPTIMISED { (all.len(), 2e-2) } else { (1, 1e-1) };
    for (name, lights) in &all[..count] {
        let receiver = |index: usize| point_receiver(&index.to_string(), [1.2, 1.7, 0.4], [0.1, 0.3, 1.0]);
        let receivers: String = (0..COPIES).map(receiver).collect();
        let found = by_rays(&[&closed_room(), &receivers, *lights, &asked(tolerance)].concat());
        let mean = found.iter().map(|answer| answer.value).sum::<f64>() / COPIES as f64;
        let squares =
            |of: fn(&Answer, f64) -> f64| found.iter().map(|answer| of(answer, mean).powi(2)).sum::<f64>();
        let exceeded = found.iter().filter(|answer| (answer.value - mean).abs() > answer.error).count();
        assert_eq!(exceeded, 0, "{name}");
        // by Student's quantile and the distrusted doubling, errors are some four standard
        // deviations
        let ratio = (squares(|answer, _| answer.error) / squares(|answer, mean| answer.value - mean)).sqrt();
        assert!((2.5..15.0).contains(&ratio), "{name}: errors are {ratio} deviations");
    }
}
