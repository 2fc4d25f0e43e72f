//! What is wrong with a scene file is said, all of it, with its place; and no text whatever makes the reader
//! panic.

use forms_radiometry::scene::{SceneError, read};
use forms_radiometry::{CORNELL_BOX, simulate_direct};

const SCENE: &str = r#"
name = "Box"
unit = "m"
bands = [[400, 500], [500, 600]]
[[material]]
name = "white"
kind = "diffuse"
reflectance = 0.75
[[surface]]
name = "floor"
material = "white"
polygon = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
radiance = [0.5, 1]
two_sided = false
[[receiver]]
name = "here"
kind = "point"
position = [0.5, 0.5, 1]
normal = [0, 0, -2]
[[receiver]]
name = "eye"
kind = "camera"
origin = [0, 0, 9]
target = [0, 0, 0]
up = [0, 1, 0]
fov = 40
resolution = [8, 6]
[solve]
tolerance = 1e-3
seed = 1
effects = { interreflection = "off", occlusion = "on", scattering = 0 }
"#;

fn errors(text: &str) -> Vec<SceneError> {
    read(text, "box.toml").map(|_| ()).expect_err("the scene has an error")
}

#[test]
fn the_scene_that_the_cases_spoil_is_right() {
    let scene = read(SCENE, "box.toml").unwrap();
    assert_eq!(scene.surfaces[0].radiance, [0.5, 1.0]);
    assert_eq!(scene.materials[0].reflectance, [0.75, 0.75]);
    assert_eq!(scene.receivers.len(), 2);
}

#[test]
fn an_exitance_is_pi_times_the_radiance() {
    let scene = read(&SCENE.replace("radiance = [0.5, 1]", "exitance = 3"), "box.toml").unwrap();
    assert_eq!(scene.surfaces[0].radiance, [3.0 / std::f64::consts::PI; 2]);
}

#[test]
fn an_error_names_the_file_and_the_place_quotes_the_line_and_says_what_was_expected() {
    let found = errors(&SCENE.replace("reflectance = 0.75", "reflectance = [0.75, 1.5] # α"));
    let shown = "box.toml:8:22: `reflectance` is out of range
  |
8 | reflectance = [0.75, 1.5] # α
  |                      ^^^
  = expected a number from 0 to 1";
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].to_string(), shown);
}

/// What is replaced in the scene, by what, and the message that follows.
const CASES: &[(&str, &str, &str)] = &[
    ("unit = \"m\"", "unit = \"km\"", "the unit `km` is unknown"),
    ("unit = \"m\"", "unti = \"m\"", "unknown key `unti` in a scene"),
    ("unit = \"m\"", "unit = 3", "`unit` is of the wrong kind: found a value of type integer"),
    ("[500, 600]", "[600, 500]", "the band ends before it begins"),
    ("[500, 600]", "[500]", "a band has 1 values"),
    ("[500, 600]", "[0, 600]", "the end of a band is out of range"),
    ("\"diffuse\"", "\"mirror\"", "a material of kind `mirror` is not supported yet"),
    ("\"diffuse\"", "\"matt\"", "the kind of material `matt` is unknown"),
    ("reflectance = 0.75", "reflectance = -0.1", "`reflectance` is out of range"),
    ("reflectance = 0.75", "reflectance = nan", "`reflectance` is not finite"),
    ("reflectance = 0.75", "reflectance = [1, 1, 1]", "`reflectance` has 3 values"),
    ("material = \"white\"", "material = \"wite\"", "no material is named `wite`"),
    ("radiance = [0.5, 1]", "radiance = -1", "`radiance` is out of range"),
    ("radiance = [0.5, 1]", "radiance = [1, inf]", "`radiance` is not finite"),
    ("radiance = [0.5, 1]", "radiance = [1e999, 1]", "`radiance` is not finite"),
    ("two_sided = false", "two_sided = 0", "`two_sided` is of the wrong kind: found a value of type integer"),
    ("two_sided = false", "exitance = 1", "the surface has both a radiance and an exitance"),
    ("two_sided = false", "mesh = \"part.obj\"", "`mesh` of a surface is not supported yet"),
    (", [1, 1, 0], [0, 1, 0]]", "]", "a polygon needs three vertices or more, found 2"),
    (
        "[1, 1, 0]",
        "[1, 1, 0], [0.5, 1, 0.1]",
        "the polygon is not planar: vertex 4 lies 5.993e-2 off its plane (accepted: 1.0e-6)",
    ),
    ("[1, 1, 0]", "[1, 0, 0]", "vertex 2 and the one after it coincide"),
    ("[1, 1, 0]", "[1, 1]", "a vertex has 2 values"),
    ("[1, 1, 0]", "[1, 1e71, 0]", "a coordinate of a vertex is out of range"),
    ("[1, 1, 0]", "[1, nan, 0]", "a coordinate of a vertex is not finite"),
    ("[1, 1, 0], [0, 1, 0]", "[0, 1, 0], [2, 3, 0]", "the edges from vertex 2 and from vertex 4 cross"),
    ("[1, 1, 0], [0, 1, 0]", "[2, 0, 0]", "the polygon encloses no area"),
    ("normal = [0, 0, -2]", "normal = [0, 0, 0]", "`normal` has length zero"),
    ("kind = \"point\"", "kind = \"ray\"", "a receiver of kind `ray` is not supported yet"),
    ("kind = \"point\"", "kind = \"dot\"", "the kind of receiver `dot` is unknown"),
    ("name = \"eye\"", "name = \"here\"", "the receiver `here` has the name of an earlier one, in line 16"),
    ("up = [0, 1, 0]", "up = [0, 0, 1]", "the camera has no direction or no upright"),
    ("fov = 40", "fov = 180", "`fov` is out of range"),
    ("[8, 6]", "[8, 0.5]", "`resolution` is out of range"),
    ("[8, 6]", "[8, 6]\ntime = { start = 0 }", "`time` of a receiver is not supported yet"),
    ("tolerance = 1e-3", "tolerance = 0", "`tolerance` is out of range"),
    ("\"off\"", "2", "the effect `interreflection` is not supported yet"),
    ("\"on\"", "\"off\"", "leaving out the effect `occlusion` is not supported yet"),
    ("\"on\"", "\"maybe\"", "the effect `occlusion` cannot be `maybe`"),
    ("[solve]", "[ambient]\nradiance = 1\n[solve]", "`ambient` of a scene is not supported yet"),
    ("[solve]", "[[light]]\nkind = \"point\"\n[solve]", "`light` of a scene is not supported yet"),
    ("[solve]", "[[medium]]\nname = \"haze\"\n[solve]", "`medium` of a scene is not supported yet"),
];

#[test]
fn each_error_is_reported_in_its_line_with_its_own_message() {
    for &(from, to, message) in CASES {
        let text = SCENE.replacen(from, to, 1);
        let found = errors(&text);
        let messages: Vec<&str> = found.iter().map(|error| error.message.as_str()).collect();
        assert_eq!(messages, [message], "{from} → {to}");
        let start = SCENE.find(from).unwrap();
        let lines = text[..start].lines().count()..=text[..start + to.len()].lines().count();
        assert!(lines.contains(&found[0].line), "{from} → {to}: line {}", found[0].line);
    }
}

#[test]
fn what_is_missing_is_reported_at_the_head_of_its_element() {
    let cases = [
        ("name = \"white\"\n", 5, "this material has no `name`"),
        ("material = \"white\"\n", 9, "this surface has no `material`"),
        ("normal = [0, 0, -2]\n", 15, "this receiver has no `normal`"),
        ("fov = 40\n", 20, "this receiver has no `fov`"),
    ];
    for (removed, line, message) in cases {
        let found = errors(&SCENE.replacen(removed, "", 1));
        assert!(
            found.iter().any(|error| error.line == line && error.message == message),
            "{message}: {found:?}"
        );
    }
}

#[test]
fn all_errors_are_collected_in_the_order_of_the_text() {
    let text = SCENE.replace("0.75", "7").replace("[0, 0, -2]", "[0, 0, 0]").replace("\"m\"", "\"km\"");
    let lines: Vec<usize> = errors(&text).iter().map(|error| error.line).collect();
    assert_eq!(lines, [3, 8, 19]);
}

#[test]
fn brackets_without_end_are_an_error_and_not_an_overflow_of_the_stack() {
    for bracket in ["[", "{a=", "[[", "a."] {
        assert!(!errors(&format!("bands = {}", bracket.repeat(100_000))).is_empty());
    }
}

#[test]
fn a_text_that_is_not_toml_is_an_error_with_its_place() {
    let found = errors("name = \"Box\"\nunit = = 3\n");
    assert_eq!((found[0].line, found[0].column), (2, 8), "{found:?}");
}

/// Marsaglia's xorshift: a fixed sequence, so that a failure can be repeated.
struct Sequence(u64);

impl Sequence {
    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as usize
    }
}

/// What a number or a bracket may be replaced by.
const FRAGMENTS: [&str; 24] = [
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
];

/// The text with a few characters, lines or numbers removed, doubled or replaced.
fn mutate(text: &str, sequence: &mut Sequence) -> String {
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

#[test]
fn no_mutation_of_a_scene_makes_the_reader_or_the_solver_panic() {
    let mut sequence = Sequence(0x9e37_79b9_7f4a_7c15);
    let (mut right, mut wrong) = (0, 0);
    for i in 0..2000 {
        let text = mutate(if i % 4 == 0 { CORNELL_BOX } else { SCENE }, &mut sequence);
        match read(&text, "mutant.toml") {
            Ok(scene) => {
                right += 1;
                for result in simulate_direct(&scene) {
                    assert!(!result.irradiance.iter().any(|e| e.is_nan() || *e < 0.0), "{text}");
                }
            }
            Err(errors) => {
                wrong += 1;
                assert!(!errors.is_empty());
                let lines = text.split('\n').count();
                for error in errors {
                    assert!(error.line <= lines && error.to_string().contains(&error.message));
                }
            }
        }
    }
    assert!(right > 100 && wrong > 1000, "{right} right, {wrong} wrong");
}
