//! Lights that emit nothing change no answer: every number and its error are finite.

use crate::process::{Folder, forms};
use serde_json::Value;

/// Lights without extent in one or two bands, with no emission in one band or in all.
const LIGHTS: &[&str] = &[
    "kind = \"point\"\nposition = [0, 0, 1]\nintensity = 0",
    "kind = \"distant\"\ndirection = [0, 0, -1]\nirradiance = 0",
    "kind = \"point\"\nposition = [0, 0, 1]\nintensity = [0, 1]",
    "kind = \"distant\"\ndirection = [0, 0, -1]\nirradiance = [0, 1]",
];

/// Materials and media that select different solvers.
const SURROUNDINGS: &[(&str, &str)] = &[
    ("kind = \"diffuse\"\nreflectance = 0.5", ""),
    ("kind = \"mirror\"\nreflectance = 0.5", ""),
    (
        "kind = \"diffuse\"\nreflectance = 0.5",
        "[[medium]]\nname = \"fog\"\nsigma_a = 1\nsigma_s = 1\n[ambient]\nmedium = \"fog\"\n",
    ),
];

fn scene(light: &str, (material, rest): (&str, &str)) -> String {
    let bands = if light.contains("[0, 1]") { "bands = [[400, 500], [500, 600]]\n" } else { "" };
    format!(
        "{bands}[[material]]\nname = \"floor\"\n{material}\n[[surface]]\nname = \"floor\"\nmaterial = \"floor\"\n\
         polygon = [[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]\n[[light]]\n{light}\n{rest}\
         [[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0, 0, 0]\nnormal = [0, 0, 1]\n\
         [[receiver]]\nname = \"mean\"\nkind = \"surface\"\nsurface = \"floor\"\n[solve]\ntolerance = 0.03\n"
    )
}

#[test]
fn a_light_that_emits_nothing_leaves_every_answer_finite() {
    for light in LIGHTS {
        for &surroundings in SURROUNDINGS {
            let folder = Folder::with(&[("dark.toml", &scene(light, surroundings))]);
            let run = forms(&folder, &["simulate", "dark.toml", "--json"]);
            assert_eq!((run.status, run.errors.as_str()), (0, ""), "{light} {surroundings:?}");
            let lines = run.output.lines().map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
            let answers: Vec<Value> = lines.filter(|line| line.get("receiver").is_some()).collect();
            assert!(answers.len() >= 3, "{light}: {}", run.output);
            for answer in answers {
                let numbers = [&answer["value"], &answer["error"]];
                let are_finite = numbers.iter().all(|number| number.as_f64().is_some_and(f64::is_finite));
                assert!(are_finite, "{light} {surroundings:?}: {answer}");
                let is_dark = light.ends_with("= 0") || answer["band"] == 0;
                assert!(
                    !is_dark || numbers.iter().all(|number| number.as_f64() == Some(0.0)),
                    "{light}: {answer}"
                );
            }
        }
    }
}
