//! Light that is gathered by rays and by exact pieces is the same light.

use super::solver::simulate_by;
use super::{Answer, Unwatched, plan};
use crate::radiosity::Gathering;
use crate::scene::read;

/// A room of 3 by 3 by 2 with a table on one leg and a lamp; bands as the text says.
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

fn by(
    gathering: fn(&crate::scene::Scene, &[crate::geometry::Face], bool) -> Gathering,
    text: &str,
) -> Vec<Answer> {
    let scene = read(text, "test.toml").unwrap_or_else(|errors| panic!("{}", errors[0]));
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    simulate_by(gathering, &scene, &plan, &Unwatched).answers
}

fn assert_agree(name: &str, text: &str) {
    let pieces = by(
        |_, _, _| Gathering::Pieces,
        &format!("{text}[solve]\ntolerance = 1e-2\neffects = {{ EFFECTS }}\n")
            .replace("EFFECTS", effects(name)),
    );
    let rays = by(
        |_, _, _| Gathering::Rays,
        &format!("{text}[solve]\ntolerance = 4e-2\neffects = {{ EFFECTS }}\n")
            .replace("EFFECTS", effects(name)),
    );
    for (a, b) in pieces.iter().zip(&rays) {
        let (off, allowed) = ((a.value - b.value).abs(), a.error + b.error);
        eprintln!(
            "{name}: {} {:?}: {} ± {:e} and {} ± {:e} {}",
            a.receiver,
            a.quantity,
            a.value,
            a.error,
            b.value,
            b.error,
            off / b.error
        );
        assert!(off <= allowed, "{name}: {} {:?}: {} and {}", a.receiver, a.quantity, a.value, b.value);
    }
}

fn effects(name: &str) -> &'static str {
    match name {
        "no reflection" => "interreflection = \"off\"",
        "one reflection" => "interreflection = 1",
        "two reflections" => "interreflection = 2",
        "reflected light alone" => "direct = \"off\"",
        _ => "",
    }
}

#[test]
fn rays_and_exact_pieces_find_the_same_light() {
    let front = "[[surface]]\nname = \"front\"\nmaterial = \"wall\"\npolygon = [[0, 0, 0], [0, 0, 2], [3, 0, 2], [3, 0, 0]]\n";
    let room = format!("{ROOM}{front}");
    for (name, lights) in [
        ("a lamp", LAMP.to_string()),
        ("a point", POINT.to_string()),
        ("the sun", SUN.to_string()),
        ("the sky", SKY.to_string()),
        ("all of them", [LAMP, POINT, SUN, SKY].concat()),
        ("no reflection", [LAMP, SKY].concat()),
        ("one reflection", [LAMP, SUN].concat()),
        ("two reflections", [LAMP, POINT].concat()),
        ("reflected light alone", [LAMP, SUN].concat()),
    ] {
        let (tables, arrays): (String, String) = (lights.clone(), RECEIVERS.to_string());
        assert_agree(name, &format!("{room}{arrays}{tables}"));
    }
}
