//! Spot lights: how they are read, in both formats, and their light at points, on surfaces, in mirrors and
//! in media.

use crate::{errors, scene, shown};
use forms_radiometry::geometry::Vector;
use forms_radiometry::scene::{LightKind, Scene, not_simulated};
use forms_radiometry::simulation::{Unwatched, plan, simulate};
use std::f64::consts::PI;

/// A spot light at (0, 0, 2) that shines down, of 3 W/sr up to 20° and none from 40° on.
const SPOT: &str = r#"
    [[light]]
    kind = "spot"
    position = [0, 0, 2]
    direction = [0, 0, -1]
    intensity = 3
    beam_width = 20
    cutoff_angle = 40
"#;
const BLACK: &str = r#"
    [[material]]
    name = "black"
    kind = "diffuse"
    reflectance = 0
"#;

fn answers(text: &str) -> Vec<[f64; 2]> {
    let scene = scene(text, "scene.toml");
    assert_eq!(not_simulated(&scene), []);
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    simulate(&plan, &Unwatched).answers.iter().map(|answer| [answer.value, answer.error]).collect()
}

fn point(name: &str, [x, y, z]: [f64; 3], normal: &str) -> String {
    format!(
        "[[receiver]]\nname = \"{name}\"\nkind = \"point\"\nposition = [{x}, {y}, {z}]\nnormal = {normal}\n"
    )
}

fn check(name: &str, [value, error]: [f64; 2], expected: f64) {
    assert!((value - expected).abs() <= 4.0 * error + 1e-12, "{name}: {value} ± {error}, {expected}");
    assert!(error <= 0.01 * expected, "{name}: {value} ± {error}, {expected}");
}

/// The irradiance is I f cos θ/d².
#[test]
fn a_spot_light_fades_between_its_angles() {
    let places = [0.0_f64, 15.0, 25.0, 35.0, 50.0];
    let up = "[0, 0, 1]";
    let receivers = places
        .map(|angle| point(&angle.to_string(), [2.0 * angle.to_radians().tan(), 0.0, 0.0], up))
        .concat();
    let found = answers(&(SPOT.to_owned() + &receivers));
    for ((angle, part), found) in places.into_iter().zip([1.0, 1.0, 0.75, 0.25, 0.0]).zip(found) {
        let expected = 3.0 * part * angle.to_radians().cos().powi(3) / 4.0;
        check(&format!("{angle}°"), found, expected);
    }
}

/// The flux of the whole light is 2π I ∫ f sin θ dθ = 2π I (1 − (sin c − sin b)/(c − b)).
#[test]
fn a_disk_that_catches_all_light_gets_the_flux_of_the_spot_light() {
    let floor = r#"
        [[surface]]
        name = "floor"
        material = "black"
        disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 2 }
        [[receiver]]
        name = "floor"
        kind = "surface"
        surface = "floor"
    "#;
    let found = answers(&[SPOT, BLACK, floor].concat());
    let [beam, cutoff] = [20_f64, 40.0].map(f64::to_radians);
    let flux = 2.0 * PI * 3.0 * (1.0 - (cutoff.sin() - beam.sin()) / (cutoff - beam));
    check("mean irradiance", found[0], flux / (4.0 * PI));
}

/// The image of the light in the mirror lies at (0, 0, −2) and shines up; the point lies 30° off its axis.
#[test]
fn a_mirror_shows_a_spot_light_by_the_angle_at_which_it_leaves() {
    let mirror = r#"
        [[material]]
        name = "silver"
        kind = "mirror"
        reflectance = 0.9
        [[surface]]
        name = "mirror"
        material = "silver"
        polygon = [[-5, -5, 0], [5, -5, 0], [5, 5, 0], [-5, 5, 0]]
    "#;
    let x = 3.0 * 30_f64.to_radians().tan();
    let found = answers(&[SPOT, mirror, &point("above", [x, 0.0, 1.0], "[0, 0, -1]")].concat());
    let cosine = 30_f64.to_radians().cos();
    check("above", found[0], 0.9 * 3.0 * 0.5 * cosine.powi(3) / 9.0);
}

#[test]
fn an_absorbing_medium_dims_a_spot_light() {
    let smoke = "[[medium]]\nname = \"smoke\"\nsigma_a = 0.5\n[ambient]\nmedium = \"smoke\"\n";
    let angle = 25_f64.to_radians();
    let place = point("floor", [2.0 * angle.tan(), 0.0, 0.0], "[0, 0, 1]");
    let found = answers(&[SPOT, smoke, &place].concat());
    let expected = 3.0 * 0.75 * angle.cos().powi(3) / 4.0 * (-0.5 * 2.0 / angle.cos()).exp();
    check("floor", found[0], expected);
}

fn cone(scene: &Scene) -> (Vector, [f64; 2]) {
    let cone = scene.lights[0].cone.expect("a spot light");
    (cone.axis, [cone.beam, cone.cutoff].map(f64::to_degrees))
}

#[test]
fn the_beam_of_a_spot_light_is_three_quarters_of_its_angle_by_default() {
    let text = SPOT.replace("    beam_width = 20\n", "");
    let (axis, [beam, cutoff]) = cone(&scene(&text, "scene.toml"));
    assert_eq!(axis, Vector::new(0.0, 0.0, -1.0));
    assert!((beam - 30.0).abs() < 1e-12 && (cutoff - 40.0).abs() < 1e-12, "{beam}, {cutoff}");
}

#[test]
fn spot_lights_of_mitsuba_shine_along_z() {
    let spot = |inside: &str| {
        format!(
            "<scene version=\"3.0.0\"><emitter type=\"spot\"><float name=\"intensity\" value=\"2\"/>\
             <transform name=\"to_world\"><lookat origin=\"1, 2, 3\" target=\"1, 5, 3\" up=\"0, 0, 1\"/>\
             </transform>{inside}</emitter></scene>"
        )
    };
    let scene = scene(&spot(""), "box.xml");
    let position = Vector::new(1.0, 2.0, 3.0);
    assert_eq!(scene.lights[0].kind, LightKind::Point { position, intensity: vec![2.0] });
    let (axis, [beam, cutoff]) = cone(&scene);
    assert!((axis - Vector::new(0.0, 1.0, 0.0)).length() < 1e-12, "{axis:?}");
    assert!((beam - 15.0).abs() < 1e-12 && (cutoff - 20.0).abs() < 1e-12, "{beam}, {cutoff}");
    let message = |inside: &str| errors(&spot(inside), "box.xml")[0].message.clone();
    let wide = "<float name=\"beam_width\" value=\"30\"/>";
    assert_eq!(message(wide), "the beam of the spot light is wider than the angle at which it ends");
    let texture = "<texture name=\"texture\" type=\"bitmap\"/>";
    assert_eq!(message(texture), "a texture of type `bitmap` is not supported");
}
