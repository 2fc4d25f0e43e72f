//! Scenes that a grammar makes, in TOML and of Mitsuba 3: some surfaces, lights, media and receivers.

use super::Random;
use std::fmt::Write;

const NUMBERS: [&str; 12] = ["0", "1", "-1", "2", "0.5", "-0.25", "3", "1e-3", "1e3", "0.1", "1.5", "-2"];
const SIZES: [&str; 6] = ["1", "0.5", "2", "0.1", "3", "1e-2"];
const LIGHTS: [&str; 8] = ["0", "1", "10", "1e-300", "1e300", "0.5", "100", "5e-324"];
const FRACTIONS: [&str; 5] = ["0", "0.5", "0.9", "1", "0.1"];
const COEFFICIENTS: [&str; 6] = ["0", "0.1", "1", "1e-160", "10", "1e3"];

fn vector(random: &mut Random) -> String {
    format!("[{}, {}, {}]", random.of(&NUMBERS), random.of(&NUMBERS), random.of(&NUMBERS))
}

/// A square about a place, that looks up or down or to a side.
fn square(random: &mut Random) -> String {
    let (x, y, z) =
        (random.below(5) as f64 - 2.0, random.below(5) as f64 - 2.0, random.below(7) as f64 - 3.0);
    let size = 0.5 + random.below(4) as f64 / 2.0;
    let corners = match random.below(3) {
        0 => [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        1 => [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0], [1.0, 0.0, 0.0]],
        _ => [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 1.0, 1.0], [0.0, 0.0, 1.0]],
    };
    let at = |c: [f64; 3]| format!("[{}, {}, {}]", x + size * c[0], y + size * c[1], z + size * c[2]);
    format!("polygon = [{}]", corners.map(at).join(", "))
}

fn surface(number: usize, random: &mut Random) -> String {
    let shape = match random.below(4) {
        0 => format!("sphere = {{ center = {}, radius = {} }}", vector(random), random.of(&SIZES)),
        1 => format!(
            "disk = {{ center = {}, normal = [0, 0, 1], radius = {} }}",
            vector(random),
            random.of(&SIZES)
        ),
        _ => square(random),
    };
    let radiance =
        if random.one_in(3) { format!("radiance = {}\n", random.of(&LIGHTS)) } else { String::new() };
    let material = random.of(&["grey", "black", "mirror"]);
    format!("[[surface]]\nname = \"s{number}\"\nmaterial = \"{material}\"\n{shape}\n{radiance}")
}

pub(super) fn toml(random: &mut Random) -> String {
    let mut text = String::new();
    if random.one_in(3) {
        let (a, s) = (random.of(&COEFFICIENTS), random.of(&COEFFICIENTS));
        let _ = writeln!(text, "[[medium]]\nname = \"fog\"\nsigma_a = {a}\nsigma_s = {s}\n");
        text += "[ambient]\nmedium = \"fog\"\n";
    }
    for (name, kind) in [("grey", "diffuse"), ("black", "black"), ("mirror", "mirror")] {
        let _ = write!(text, "[[material]]\nname = \"{name}\"\nkind = \"{kind}\"\n");
        if kind != "black" {
            let _ = writeln!(text, "reflectance = {}", random.of(&FRACTIONS));
        }
    }
    for number in 0..1 + random.below(3) {
        text += &surface(number, random);
    }
    if random.one_in(2) {
        let _ = write!(
            text,
            "[[light]]\nname = \"l\"\nkind = \"point\"\nposition = {}\nintensity = {}\n",
            vector(random),
            random.of(&LIGHTS)
        );
    }
    if random.one_in(3) {
        let _ = write!(
            text,
            "[[light]]\nname = \"sun\"\nkind = \"distant\"\ndirection = [0.1, {}, -1]\nirradiance = {}\n",
            random.of(&NUMBERS),
            random.of(&LIGHTS)
        );
    }
    match random.below(3) {
        0 => text += "[[receiver]]\nname = \"r\"\nkind = \"surface\"\nsurface = \"s0\"\n",
        1 => {
            let _ = write!(
                text,
                "[[receiver]]\nname = \"r\"\nkind = \"point\"\nposition = {}\nnormal = [0, 0, 1]\n",
                vector(random)
            );
        }
        _ => text += "[[receiver]]\nname = \"m\"\nkind = \"map\"\nsurface = \"s0\"\nresolution = [2, 2]\n",
    }
    text + "[solve]\ntolerance = 0.5\n"
}

pub(super) fn mitsuba(random: &mut Random) -> String {
    let mut text = "<scene version=\"3.0.0\">\n<integrator type=\"path\"/>\n".to_string();
    for number in 0..1 + random.below(3) {
        let kind = random.of(&["rectangle", "sphere", "disk", "cube", "serialized"]);
        let (x, z, s) = (random.of(&NUMBERS), random.of(&NUMBERS), random.of(&SIZES));
        let _ = write!(
            text,
            "<shape type=\"{kind}\" id=\"s{number}\"><transform name=\"to_world\"><scale value=\"{s}\"/>\
             <translate x=\"{x}\" z=\"{z}\"/></transform>"
        );
        let _ = match random.below(4) {
            0 => write!(text, "<bsdf type=\"twosided\"><bsdf type=\"diffuse\"/></bsdf>"),
            1 => write!(
                text,
                "<emitter type=\"area\"><float name=\"radiance\" value=\"{}\"/></emitter>",
                random.of(&LIGHTS)
            ),
            2 => write!(
                text,
                "<bsdf type=\"diffuse\"><rgb name=\"reflectance\" value=\"0.5, 0.2, 1\"/></bsdf>"
            ),
            _ => write!(text, "<string name=\"filename\" value=\"a.obj\"/>"),
        };
        text += "</shape>\n";
    }
    if random.one_in(2) {
        let _ = writeln!(
            text,
            "<emitter type=\"point\"><point name=\"position\" value=\"0, 1, 2\"/><float name=\"intensity\" value=\"{}\"/></emitter>",
            random.of(&LIGHTS)
        );
    }
    text += "<sensor type=\"perspective\"><float name=\"fov\" value=\"50\"/><transform name=\"to_world\">\
             <lookat origin=\"6, -4, 7\" target=\"0.5, 0.3, 0\" up=\"0, 0, 1\"/></transform><film type=\"hdrfilm\">\
             <integer name=\"width\" value=\"2\"/><integer name=\"height\" value=\"2\"/></film></sensor>\n";
    text + "</scene>\n"
}
