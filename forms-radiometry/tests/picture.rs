//! Direct light as cameras and rays see it: surfaces have the right places, colours and radiances,
//! and the number of threads does not matter.

use forms_radiometry::CORNELL_BOX;
use forms_radiometry::output::photograph;
use forms_radiometry::scene::{self, Effect, Force, ForcedEffect, Place, ReceiverKind, Scene};
use forms_radiometry::simulation::{Simulation, Unwatched, plan, simulate};
use std::f64::consts::PI;

const SIDE: usize = 64;

/// Decoded picture.
struct Picture {
    size: [usize; 2],
    pixels: Vec<u8>,
}

fn direct(mut scene: Scene) -> (Scene, Simulation) {
    let (effect, force) = (Effect::Interreflection, Force::Off);
    scene.solve.forced.push(ForcedEffect { effect, force, place: Place::default() });
    let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}", errors[0]));
    let found = simulate(&plan, &Unwatched);
    (scene, found)
}

/// Returns the picture of the camera of the box.
fn small_box() -> Picture {
    let text = CORNELL_BOX.replace("[512, 512]", &format!("[{SIDE}, {SIDE}]"));
    let mut scene = scene::read(&text, "cornell_box.toml").unwrap();
    scene.receivers.retain(|receiver| matches!(receiver.kind, ReceiverKind::Camera(_)));
    let (scene, found) = direct(scene);
    let [image] = &found.maps[..] else { panic!("the box has one camera") };
    decoded(photograph(image, &scene).unwrap())
}

fn decoded(file: Vec<u8>) -> Picture {
    let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut pixels).unwrap();
    Picture { size: [info.width as usize, info.height as usize], pixels }
}

/// Returns the pixel at a fraction of the width and of the height.
fn at(picture: &Picture, x: f64, y: f64) -> [u8; 3] {
    let pixel = (y * SIDE as f64) as usize * SIDE + (x * SIDE as f64) as usize;
    assert_eq!(picture.pixels[4 * pixel + 3], 255, "every pixel has a value");
    [0, 1, 2].map(|component| picture.pixels[4 * pixel + component])
}

#[test]
fn the_red_wall_is_on_the_left_the_green_on_the_right_and_the_lamp_white_in_a_black_ceiling() {
    let picture = small_box();
    assert_eq!(picture.size, [SIDE; 2]);
    let [r, g, b] = at(&picture, 0.12, 0.3);
    assert!(r > 2 * g && r > 2 * b, "left: {r} {g} {b}");
    let [r, g, b] = at(&picture, 0.88, 0.3);
    assert!(g > 2 * r && g > b, "right: {r} {g} {b}");
    assert_eq!(at(&picture, 0.5, 0.145), [255, 255, 255], "lamp");
    assert_eq!(at(&picture, 0.5, 0.08), [0, 0, 0], "ceiling");
    let [r, g, b] = at(&picture, 0.5, 0.35);
    assert!(r > 100 && r.abs_diff(g) < 8 && g.abs_diff(b) < 8, "back wall: {r} {g} {b}");
    assert_eq!(at(&picture, 0.6, 0.8), [0, 0, 0], "the side of the short block that is turned from the lamp");
}

#[test]
fn the_picture_is_the_same_for_any_number_of_threads() {
    let with_threads = |count| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build().unwrap();
        pool.install(|| small_box().pixels)
    };
    let one = with_threads(1);
    for count in [2, 3, 7] {
        assert!(with_threads(count) == one, "{count} threads");
    }
}

/// A floor, a lamp above its left half, and to its right a two-sided screen that hangs lower;
/// without bands.
const SCENE: &str = r#"
    [[material]]
    name = "grey"
    kind = "diffuse"
    reflectance = 0.5
    [[surface]]
    name = "floor"
    material = "grey"
    polygon = [[-4, -4, 0], [4, -4, 0], [4, 4, 0], [-4, 4, 0]]
    [[surface]]
    name = "lamp"
    material = "grey"
    polygon = [[-3, -1, 2], [-3, 1, 2], [-1, 1, 2], [-1, -1, 2]]
    radiance = 3
    [[surface]]
    name = "screen"
    material = "grey"
    polygon = [[1, -1, 1], [3, -1, 1], [3, 1, 1], [1, 1, 1]]
    two_sided = true
"#;

/// Returns the only answer of the scene with this receiver.
fn answer(receiver: &str) -> f64 {
    let text = format!("{SCENE}[[receiver]]\nname = \"here\"\n{receiver}");
    let (_, found) = direct(scene::read(&text, "sight.toml").unwrap());
    let [answer] = &found.answers[..] else { panic!("{receiver} has one answer") };
    answer.value
}

/// Returns the radiance of a point as seen from another one.
fn seen([x, y, z]: [f64; 3], to: [f64; 3]) -> f64 {
    let direction = [to[0] - x, to[1] - y, to[2] - z];
    answer(&format!("kind = \"ray\"\norigin = [{x}, {y}, {z}]\ndirection = {direction:?}\n"))
}

fn irradiance_from_above(position: [f64; 3]) -> f64 {
    answer(&format!("kind = \"point\"\nposition = {position:?}\nnormal = [0, 0, 1]\n"))
}

const ABOVE: [f64; 3] = [0.0, 0.0, 8.0];
const BELOW: [f64; 3] = [0.0, 0.0, 0.25];

#[test]
fn a_diffuse_surface_brings_its_reflectance_times_irradiance_over_pi() {
    let expected = 0.5 / PI * irradiance_from_above([0.0; 3]);
    let radiance = seen(ABOVE, [0.0; 3]);
    assert!(expected > 0.05 && (radiance - expected).abs() < 1e-15, "{radiance} and {expected}");
}

#[test]
fn a_lamp_brings_its_radiance_from_the_front_and_nothing_from_the_back() {
    let middle_of_lamp = [-2.0, 0.0, 2.0];
    assert_eq!(seen(ABOVE, middle_of_lamp), 0.0);
    assert_eq!(seen(BELOW, middle_of_lamp), 3.0);
}

#[test]
fn a_two_sided_surface_reflects_on_the_side_that_is_seen() {
    let middle_of_screen = [2.0, 0.0, 1.0];
    let expected = 0.5 / PI * irradiance_from_above(middle_of_screen);
    let radiance = seen(ABOVE, middle_of_screen);
    assert!(expected > 0.005 && (radiance - expected).abs() < 1e-14, "{radiance} and {expected}");
    assert_eq!(seen(BELOW, middle_of_screen), 0.0);
}

#[test]
fn outside_the_scene_there_is_nothing_to_see() {
    assert_eq!(seen(ABOVE, [-7.5, 7.5, 0.0]), 0.0);
}
