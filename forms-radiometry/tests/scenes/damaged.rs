//! No text whatever makes the readers of scenes and meshes panic, and every error they give has a place.

use crate::{EVERYTHING, PART_OBJ, media, mitsuba, read};
use forms_radiometry::scene::{SceneError, read_with_files};
use forms_radiometry::{CORNELL_BOX, simulate_direct};

/// Marsaglia's xorshift: a fixed sequence, so that a failure can be repeated.
struct Sequence(u64);

impl Sequence {
    fn new() -> Self {
        Self(0x9e37_79b9_7f4a_7c15)
    }

    fn below(&mut self, bound: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % bound as u64) as usize
    }
}

/// What a number or a bracket may be replaced by.
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

/// The bytes with a few of them replaced, and perhaps cut short.
fn damage(bytes: &[u8], sequence: &mut Sequence) -> Vec<u8> {
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
    let mut sequence = Sequence::new();
    let (mut right, mut wrong) = (0, 0);
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
                for result in simulate_direct(&scene).unwrap_or_default() {
                    assert!(!result.irradiance.iter().any(|e| e.is_nan() || *e < 0.0), "{text}");
                }
            }
            Err(errors) => {
                wrong += 1;
                check(&text, &errors);
            }
        }
    }
    assert!(right > 200 && wrong > 2000, "{right} right, {wrong} wrong");
}

/// A square of two triangles, as PLY: text, and bytes in both orders.
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
    let mut sequence = Sequence::new();
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
