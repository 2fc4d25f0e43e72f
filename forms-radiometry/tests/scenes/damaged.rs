//! No text makes the readers of scenes and meshes panic, and every error that they report has a
//! place.

use crate::{EVERYTHING, PART_OBJ, media, mitsuba, read};
use forms_radiometry::scene::{
    Effect, Force, ForcedEffect, Place, ReceiverKind, Scene, SceneError, read_with_files,
};
use forms_radiometry::simulation::{Unwatched, Watch, plan, simulate};
use forms_radiometry::{CORNELL_BOX, view_factors};
use forms_testing::SplitMix;
use std::sync::atomic::{AtomicUsize, Ordering};

/// First state of the random numbers, so that a failure can be repeated.
const SEED: u64 = 7;

/// Replacements for a number or a bracket.
const FRAGMENTS: [&str; 28] = [
    "nan",
    "-inf",
    "1e999",
    "-0.0",
    "1e-320",
    "1e308",
    "9223372036854775808",
    "0xffffffffffffffffff",
    "[",
    "]",
    "[[",
    "{",
    "\"",
    "\"\"\"",
    "=",
    ".",
    ",",
    "\n",
    "\r\n",
    "ä𝄞",
    "\u{0}",
    "true",
    "1979-05-27",
    "[[surface]]\n",
    "<",
    "/>",
    "$",
    "&amp;",
];

/// Returns the text with a few characters, lines or numbers removed, doubled or replaced.
fn mutate(text: &str, sequence: &mut SplitMix) -> String {
    let mut characters: Vec<char> = text.chars().collect();
    for _ in 0..=sequence.below(3) {
        let start = sequence.below(characters.len());
        let end = (start + sequence.below(12)).min(characters.len());
        let replacement: Vec<char> = match sequence.below(8) {
            0 => Vec::new(),
            1 => characters[start..end].repeat(2),
            2 => FRAGMENTS[sequence.below(FRAGMENTS.len())].chars().collect(),
            3..6 => {
                let digit = char::from(b"0123456789"[sequence.below(10)]);
                characters[start..end].iter().map(|c| if c.is_ascii_digit() { digit } else { *c }).collect()
            }
            _ => {
                let from = sequence.below(characters.len());
                characters[from..(from + sequence.below(40)).min(characters.len())].to_vec()
            }
        };
        characters.splice(start..end, replacement);
    }
    characters.into_iter().collect()
}

/// Returns the bytes with a few of them replaced, and sometimes truncated.
fn damage(bytes: &[u8], sequence: &mut SplitMix) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=sequence.below(3) {
        let at = sequence.below(bytes.len());
        bytes[at] = sequence.below(256) as u8;
    }
    if sequence.below(4) == 0 {
        bytes.truncate(sequence.below(bytes.len()));
    }
    bytes
}

fn check(text: &str, errors: &[SceneError]) {
    assert!(!errors.is_empty(), "{text}");
    let lines = text.split('\n').count();
    for error in errors {
        assert!(error.line <= lines && error.to_string().contains(&error.message), "{error}");
    }
}

#[test]
fn no_mutation_of_a_scene_makes_the_reader_or_the_solver_panic() {
    let mut sequence = SplitMix(SEED);
    let (mut right, mut wrong, mut lit) = (0, 0, 0);
    let water = media::text(&media::glass_of_water(), "");
    for i in 0..5000 {
        let (text, name) = match i % 5 {
            0 => (CORNELL_BOX, "mutant.toml"),
            1 => (mitsuba::EVERYTHING, "mutant.xml"),
            2 => (&*water, "mutant.toml"),
            _ => (EVERYTHING, "mutant.toml"),
        };
        let text = mutate(text, &mut sequence);
        match read(&text, name) {
            Ok(scene) => {
                right += 1;
                if i % 5 == 0 {
                    lit += usize::from(has_direct_light(scene, &text));
                }
            }
            Err(errors) => {
                wrong += 1;
                check(&text, &errors);
            }
        }
    }
    assert!(right > 200 && wrong > 2000 && lit > 100, "{right} right, {wrong} wrong, {lit} lit");
}

/// Simulates the direct light at the points of a scene. Returns whether it can be simulated.
fn has_direct_light(mut scene: Scene, text: &str) -> bool {
    scene.receivers.retain(|receiver| matches!(receiver.kind, ReceiverKind::Point { .. }));
    let (effect, force) = (Effect::Interreflection, Force::Off);
    scene.solve.forced = vec![ForcedEffect { effect, force, place: Place::default() }];
    let Ok(plan) = plan(&scene) else { return false };
    let found = simulate(&plan, &Unwatched);
    assert!(!found.answers.iter().any(|answer| answer.value.is_nan() || answer.value < 0.0), "{text}");
    true
}

/// Whether numeric code is optimised; otherwise fewer mutants are run.
const IS_OPTIMISED: bool = !cfg!(debug_assertions);

/// Diffuse surfaces of every shape, lights and receivers of every kind.
const DIFFUSE: &str = r#"
unit = "cm"
bands = [[400, 500], [500, 600]]
[[material]]
name = "white"
kind = "diffuse"
reflectance = [0.5, 0.25]
[[surface]]
name = "floor"
material = "white"
polygon = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0]]
[[surface]]
name = "wall"
material = "white"
polygon = [[0, 0, 0], [0, 2, 0], [0, 2, 2], [0, 1, 1], [0, 0, 2]]
two_sided = true
[[surface]]
name = "lamp"
material = "white"
disk = { center = [1, 1, 2], normal = [0, 0, -1], radius = 0.25 }
exitance = [20, 25]
[[light]]
kind = "point"
position = [1, 1, 1.5]
intensity = 30
[[light]]
kind = "distant"
direction = [0, 1, -1]
irradiance = 3
[[receiver]]
name = "point"
kind = "point"
position = [1, 0.5, 0]
normal = [0, 0, 1]
[[receiver]]
name = "surface"
kind = "surface"
surface = "floor"
grid = [4, 4]
[[receiver]]
name = "ray"
kind = "ray"
origin = [1, 1, 1]
direction = [-1, 0.25, 0]
[[receiver]]
name = "sphere"
kind = "sphere"
position = [1, 1.5, 1]
[ambient]
radiance = 0.1
[solve]
tolerance = 0.5
effects = { interreflection = 2 }
"#;

/// Observer that stops the work after a fixed number of queries.
struct Impatient(AtomicUsize);

impl Watch for Impatient {
    fn progress(&self, _stage: &str, _fraction: f64) {}

    fn is_stopped(&self) -> bool {
        self.0.fetch_add(1, Ordering::Relaxed) > 3000
    }
}

/// Simulates a scene with a loose tolerance and a limited time. Returns whether it can be simulated
/// at all.
fn is_simulated(mut scene: Scene, text: &str) -> bool {
    scene.solve.tolerance = scene.solve.tolerance.max(0.5);
    for receiver in &mut scene.receivers {
        if let ReceiverKind::Surface { grid: Some(sides), .. } = &mut receiver.kind {
            *sides = sides.map(|side| side.min(8));
        }
    }
    let Ok(plan) = plan(&scene) else { return false };
    let found = simulate(&plan, &Impatient(AtomicUsize::new(0)));
    for answer in &found.answers {
        let is_told = answer.value.is_finite() || answer.error == f64::INFINITY;
        assert!(!answer.value.is_nan() && is_told && answer.error >= 0.0, "{answer:?}\n{text}");
    }
    for map in &found.maps {
        let mut cells = map.values.iter().flatten().zip(map.errors.iter().flatten());
        assert!(cells.all(|(value, error)| value.is_nan() || !error.is_nan()), "{}\n{text}", map.receiver);
    }
    for factor in view_factors(&scene).rows.iter().flatten() {
        assert!(factor.value.is_finite() && factor.error >= 0.0, "{factor:?}\n{text}");
    }
    true
}

#[test]
fn mutations_of_diffuse_scenes_that_are_still_scenes_have_answers_or_errors() {
    const SCENES: [&str; 4] = [
        DIFFUSE,
        include_str!("../../../scenes/occluded_lamp.toml"),
        include_str!("../../../scenes/opposed_squares.toml"),
        include_str!("../../../scenes/v_groove.toml"),
    ];
    let mut sequence = SplitMix(SEED);
    let (mut simulated, mut refused) = (0, 0);
    let count = if IS_OPTIMISED { 6000 } else { 120 };
    for i in 0..count {
        let text = mutate(SCENES[i % SCENES.len()], &mut sequence);
        if let Ok(scene) = read(&text, "mutant.toml") {
            let outcome = if is_simulated(scene, &text) { &mut simulated } else { &mut refused };
            *outcome += 1;
        }
    }
    assert!(simulated > count / 10, "{simulated} simulated, {refused} refused");
}

/// Returns the places of the numbers in a text.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let is_part = |c: char| c.is_ascii_digit() || "-.".contains(c);
    let mut found = Vec::new();
    let mut from = 0;
    while let Some(start) = text[from..].find(is_part).map(|at| from + at) {
        let end = text[start..].find(|c| !is_part(c)).map_or(text.len(), |at| start + at);
        found.push(start..end);
        from = end;
    }
    found
}

#[test]
fn a_scene_with_one_number_at_the_end_of_its_range_has_answers_or_errors() {
    let (mut simulated, mut wrong) = (0, 0);
    let extremes = ["0", "1e-320", "1e-151", "1e-70", "1e70", "1e151", "1e308", "-1e40"];
    let every = if IS_OPTIMISED { 1 } else { 11 };
    let places = numbers(DIFFUSE);
    let cases = places.iter().flat_map(|place| extremes.map(|extreme| (place, extreme)));
    for (place, extreme) in cases.step_by(every) {
        let text = format!("{}{extreme}{}", &DIFFUSE[..place.start], &DIFFUSE[place.end..]);
        match read(&text, "mutant.toml") {
            Ok(scene) => simulated += usize::from(is_simulated(scene, &text)),
            Err(errors) => {
                wrong += 1;
                check(&text, &errors);
            }
        }
    }
    assert!(simulated * every > 200 && wrong > 0, "{simulated} simulated, {wrong} refused");
}

/// Returns a square of two triangles, as PLY: text, and binary in both byte orders.
fn squares() -> [Vec<u8>; 3] {
    let head = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\ncomment a square\nelement vertex 4\nproperty float x\nproperty double y\n\
             property float z\nproperty uchar red\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
        )
    };
    let text = head("ascii") + "0 0 0 9\n1 0 0 9\n1 1 0 9\n0 1 0 9\n3 0 1 2\n3 0 2 3\n";
    let bytes = |format: &str, big: bool| {
        let mut file = head(format).into_bytes();
        let mut put = |bytes: &[u8]| {
            let mut bytes = bytes.to_vec();
            if !big {
                bytes.reverse();
            }
            file.extend(bytes);
        };
        for (x, y) in [(0.0_f32, 0.0_f64), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            put(&x.to_be_bytes());
            put(&y.to_be_bytes());
            put(&0.0_f32.to_be_bytes());
            put(&[9]);
        }
        for face in [[0, 1, 2], [0, 2, 3_i32]] {
            put(&[3]);
            face.iter().for_each(|i| put(&i.to_be_bytes()));
        }
        file
    };
    [text.into_bytes(), bytes("binary_little_endian", false), bytes("binary_big_endian", true)]
}

#[test]
fn no_damage_to_a_mesh_makes_the_reader_panic() {
    let mut sequence = SplitMix(SEED);
    let mut wrong = 0;
    let [text, little, big] = squares();
    for (name, file) in
        [("part.obj", PART_OBJ.into()), ("part.ply", text), ("part.ply", little), ("part.ply", big)]
    {
        let scene = format!(
            "[[material]]\nname = \"m\"\nkind = \"diffuse\"\nreflectance = 0\n[[surface]]\nname = \"part\"\n\
             material = \"m\"\nmesh = \"{name}\"\n"
        );
        let read = |bytes: &[u8]| read_with_files(&scene, "mutant.toml", &|_| Ok(bytes.to_vec()));
        assert!(read(&file).is_ok(), "{name}");
        for _ in 0..3000 {
            let damaged = damage(&file, &mut sequence);
            if let Err(errors) = read(&damaged) {
                wrong += 1;
                check(&String::from_utf8_lossy(&damaged), &errors);
            }
        }
    }
    assert!(wrong > 4000, "{wrong} wrong");
}
