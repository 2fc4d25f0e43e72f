//! Options that override the solver settings of a scene: they give the same results as a scene with
//! their values, in all commands that read a scene, and mistakes in them are reported.

use crate::hall::{HALL, LAMP, hall};
use crate::process::{Folder, Run, forms};

/// Returns the standard output of a run in JSON, without the times.
fn untimed(run: &Run) -> Vec<String> {
    let untimed = |line: &str| line.split(",\"seconds\"").next().unwrap_or(line).to_owned();
    run.output.lines().map(untimed).collect()
}

/// Returns the printed answers of a scene, without the reasons of the plan.
fn answers(run: &Run) -> Vec<String> {
    untimed(run).into_iter().filter(|line| line.contains("\"receiver\"")).collect()
}

/// A room in TOML, and a scene with an irradiance meter in the format of Mitsuba.
const WHITE: &str = "[[material]]\nname = \"white\"\nkind = \"diffuse\"\nreflectance = 0.5\n\
    [[surface]]\nname = \"floor\"\nmaterial = \"white\"\npolygon = [[0,0,0], [2,0,0], [2,1,0], [0,1,0]]\n\
    [[surface]]\nname = \"lamp\"\nmaterial = \"white\"\nradiance = 3\n\
    polygon = [[0.5,0.2,1], [0.5,0.6,1], [1,0.6,1], [1,0.2,1]]\n\
    [[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";
const MITSUBA: &str = "<scene version=\"3.0.0\">\
    <shape type=\"rectangle\"><sensor type=\"irradiancemeter\"><film type=\"hdrfilm\">\
    <integer name=\"width\" value=\"1\"/><integer name=\"height\" value=\"1\"/></film></sensor></shape>\
    <shape type=\"rectangle\"><transform name=\"to_world\"><rotate x=\"1\" angle=\"180\"/>\
    <translate z=\"2\"/></transform><emitter type=\"area\"><rgb name=\"radiance\" value=\"1, 1, 1\"/></emitter></shape>\
    </scene>";

#[test]
fn options_give_what_a_scene_with_their_values_gives() {
    let said =
        "[solve]\ntolerance = 0.02\nseed = 7\neffects = { interreflection = 1, occlusion = \"off\" }\n";
    let other = "[solve]\ntolerance = 0.4\nseed = 3\neffects = { interreflection = 5 }\n";
    let paths = "[solve]\ntolerance = 0.1\nseed = 7\neffects = { interreflection = 1 }\n";
    let folder = Folder::with(&[
        ("said.toml", &format!("{WHITE}{said}")),
        ("other.toml", &format!("{WHITE}{other}")),
        ("silent.toml", WHITE),
        ("hall said.toml", &format!("{HALL}{paths}")),
        ("hall.toml", &hall(0.4)),
    ]);
    let of = |scene, options: &[&str]| {
        let run = forms(&folder, &[&["simulate", scene, "--json"], options].concat());
        assert!(run.status == 0 || run.status == 3, "{scene} {options:?}: {}", run.errors);
        answers(&run)
    };
    let options = [
        "--tolerance",
        "0.02",
        "--seed",
        "7",
        "--effects",
        "interreflection=1,occlusion=off",
        "--threads",
        "3",
    ];
    let expected = of("said.toml", &[]);
    assert_eq!(of("other.toml", &options), expected);
    assert_eq!(of("silent.toml", &options), expected);
    assert_ne!(of("silent.toml", &[]), expected);
    let options = ["--tolerance", "0.1", "--seed", "7", "--effects", "interreflection=1"];
    let expected = of("hall said.toml", &[]);
    assert_eq!(of("hall.toml", &options), expected);
    assert_ne!(of("hall.toml", &[&options[..2], &["--seed", "8"], &options[4..]].concat()), expected);
}

#[test]
fn answers_do_not_depend_on_threads() {
    let folder = Folder::with(&[("room.toml", WHITE), ("hall.toml", &hall(0.1)), ("lamp.toml", LAMP)]);
    for scene in ["room.toml", "hall.toml", "lamp.toml"] {
        let of = |threads| untimed(&forms(&folder, &["simulate", scene, "--json", "--threads", threads]));
        assert!(!of("1").is_empty());
        assert!(["2", "5"].iter().all(|threads| of(threads) == of("1")), "{scene}");
    }
    let factors = |threads| forms(&folder, &["view-factors", "room.toml", "--threads", threads]).output;
    assert!(factors("1").starts_with("from,") && factors("1") == factors("3"));
}

#[test]
fn a_scene_of_mitsuba_is_solved_as_the_options_say() {
    let folder = Folder::with(&[("scene.xml", MITSUBA)]);
    let run = forms(&folder, &["simulate", "scene.xml", "--tolerance", "1e-5"]);
    assert!(run.status == 0 && run.output.contains("(tolerance 1e-5)"), "{}{}", run.output, run.errors);
    let effects = ["--effects", "interreflection=off", "--seed", "4"];
    let run = forms(&folder, &[&["simulate", "scene.xml"], &effects[..]].concat());
    assert!(run.output.contains("--effects turns it off"), "{}{}", run.output, run.errors);
    assert!(run.output.contains("\n  method: closed forms integrated over surfaces\n"), "{}", run.output);
}

#[test]
fn wrong_values_are_named_with_what_to_write() {
    let folder = Folder::with(&[("room.toml", WHITE), ("hall.toml", &hall(0.1))]);
    let cases: [(&[&str], &str); 10] = [
        (&["--tolerance", "0"], "'0' for '--tolerance <X>': expected a number above 0 and below 1"),
        (&["--tolerance", "-1"], "expected a number above 0 and below 1"),
        (&["--seed", "-1"], "expected an integer from 0 to 2^53"),
        (&["--seed", "1.5"], "expected an integer from 0 to 2^53"),
        (&["--threads", "0"], "expected an integer from 1 to 4096"),
        (&["--threads", "many"], "expected an integer from 1 to 4096"),
        (&["--effects", "occlusion"], "`occlusion` has no value: expected effect=value, for example"),
        (
            &["--effects", "shade=on"],
            "unknown key `shade` in a list of effects: expected `direct`, `occlusion`",
        ),
        (&["--effects", "occlusion=2"], "the effect `occlusion` has no orders: expected \"on\" or \"off\""),
        (&["--effects", "mirror=on,mirror=off"], "the effect `mirror` is given twice"),
    ];
    for (options, message) in cases {
        let run = forms(&folder, &[&["simulate", "room.toml"], options].concat());
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{options:?}");
        assert!(run.errors.contains(message), "{options:?}: {}", run.errors);
    }
    // An error that only the plan detects is reported at the place of the option.
    let run = forms(&folder, &["simulate", "hall.toml", "--effects", "mirror=on,occlusion=off"]);
    assert_eq!((run.status, run.output.as_str()), (2, ""));
    assert!(
        run.errors.starts_with(
            "error: --effects:1:21: path tracing, which is needed because the surface `wall` is not diffuse, \
             cannot ignore occlusion"
        ),
        "{}",
        run.errors
    );
    let run = forms(&folder, &["view-factors", "room.toml", "--tolerance", "2"]);
    assert!(
        run.status == 2 && run.errors.contains("expected a number above 0 and below 1"),
        "{}",
        run.errors
    );
}

#[test]
fn checkpoints_and_shares_are_of_the_values_that_were_given() {
    let folder = Folder::with(&[("hall.toml", &hall(0.01))]);
    let simulate = |options: &[&str]| forms(&folder, &[&["simulate", "hall.toml"], options].concat());
    let coarse = ["--tolerance", "0.1", "--seed", "9"];
    let kept = [&coarse[..], &["--checkpoint", "state"]].concat();
    assert_eq!(simulate(&kept).status, 0);
    assert!(simulate(&kept).errors.contains("resuming from `state`"));
    let cases: [(&[&str], &str); 3] = [
        (&["--seed", "9"], "it was computed with tolerance 0.1, not 0.01"),
        (&["--tolerance", "0.1"], "it was computed with seed 9, not 1"),
        (&["--tolerance", "0.1", "--seed", "9", "--effects", "interreflection=1"], "with other effects"),
    ];
    for (options, message) in cases {
        let run = simulate(&[options, &["--checkpoint", "state"]].concat());
        assert!(run.status == 2 && run.errors.contains(message), "{options:?}: {}", run.errors);
    }

    let options = [&coarse[..], &["--effects", "interreflection=2"]].concat();
    for (share, part) in [("1/2", "a"), ("2/2", "b")] {
        assert_eq!(simulate(&[&options[..], &["--shard", share, "--out", part]].concat()).status, 0);
    }
    let missing = forms(&folder, &["merge", "a"]);
    let call = "forms simulate hall.toml --shard 2/2 --tolerance 0.1 --seed 9 --effects interreflection=2 --out PART";
    assert!(missing.status == 2 && missing.errors.contains(call), "{}", missing.errors);
    let whole = simulate(&[&options[..], &["--json"]].concat());
    let merged = forms(&folder, &["merge", "a", "b", "--json", "--threads", "1"]);
    assert_eq!((merged.status, untimed(&merged)), (whole.status, untimed(&whole)), "{}", merged.errors);
    assert_eq!(simulate(&["--seed", "9", "--tolerance", "0.1", "--shard", "2/2", "--out", "c"]).status, 0);
    let run = forms(&folder, &["merge", "a", "c"]);
    assert!(
        run.status == 2 && run.errors.contains("does not match `a`: it belongs to the same scene"),
        "{}",
        run.errors
    );
}
