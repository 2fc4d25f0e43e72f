//! `forms simulate`: its output, its files, and its error messages.

use crate::hall::hall;
use crate::process::{Folder, forms, interrupted};
use serde_json::Value;
use std::collections::HashMap;
use std::io::Cursor;

/// Returns a scene with a lamp over a floor and some receivers.
fn room(rest: &str) -> String {
    format!(
        "name = \"Room\"\n[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5\n\
         [[surface]]\nname = \"floor\"\nmaterial = \"grey\"\npolygon = [[0,0,0], [2,0,0], [2,1,0], [0,1,0]]\n\
         [[surface]]\nname = \"lamp\"\nmaterial = \"grey\"\nradiance = 3\n\
         polygon = [[0.5,0.2,1], [0.5,0.6,1], [1,0.6,1], [1,0.2,1]]\n{rest}"
    )
}

const POINT: &str =
    "[[receiver]]\nname = \"here\"\nkind = \"point\"\nposition = [0.5, 0.5, 0]\nnormal = [0, 0, 1]\n";
const MAP: &str =
    "[[receiver]]\nname = \"floor: map\"\nkind = \"surface\"\nsurface = \"floor\"\ngrid = [6, 3]\n";

/// Returns the keys of a line of JSON in their order, and the object.
fn object(line: &str) -> (Vec<String>, Value) {
    let value: Value = serde_json::from_str(line).expect("an object");
    let keys = value.as_object().expect("an object").keys();
    let mut keys: Vec<(usize, String)> =
        keys.map(|key| (line.find(&format!("\"{key}\":")).expect("the key"), key.clone())).collect();
    keys.sort();
    (keys.into_iter().map(|(_, key)| key).collect(), value)
}

#[test]
fn json_is_the_plan_effect_by_effect_and_then_the_answers() {
    let folder = Folder::with(&[("room.toml", &room(&format!("{POINT}{MAP}")))]);
    let run = forms(&folder, &["simulate", "room.toml", "--json"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let of = |first: &str| -> Vec<(Vec<String>, Value)> {
        run.output.lines().map(object).filter(|(keys, _)| keys[0] == first).collect()
    };
    let [plan, methods, answers, shared] = ["effect", "method", "receiver", "shared"].map(of);
    assert_eq!(run.output.lines().count(), plan.len() + 1 + answers.len() + 1);
    assert_eq!(methods[0].0, ["method", "receivers"]);
    let method = serde_json::json!(["radiosity on adaptive elements"]);
    assert_eq!(methods[0].1["method"], method);
    let why = "surfaces are diffuse, in a vacuum, and reflect light";
    let of_receiver = |receiver| serde_json::json!({ "receiver": receiver, "method": method, "why": why });
    assert_eq!(methods[0].1["receivers"], serde_json::json!(["here", "floor: map"].map(of_receiver)));
    assert_eq!(shared[0].0, ["shared", "seconds"]);
    assert_eq!(shared[0].1["shared"], "solution");
    assert!(shared[0].1["seconds"].as_f64().is_some_and(|seconds| seconds > 0.0), "{}", shared[0].1);
    let effects: Vec<&str> = plan.iter().filter_map(|(_, line)| line["effect"].as_str()).collect();
    let all = forms_radiometry::scene::Effect::ALL.map(|(name, _)| name);
    assert_eq!(effects, all);
    for (keys, line) in &plan {
        let limited = ["effect", "on", "orders", "why", "bound"];
        let expected: Vec<&str> =
            limited.into_iter().filter(|&key| key != "orders" || !line["orders"].is_null()).collect();
        assert_eq!(*keys, expected);
        assert!(line["on"].is_boolean() && line["why"].as_str().is_some_and(|why| !why.is_empty()), "{line}");
    }
    assert_eq!(plan[0].1["on"], true, "direct light");
    let asked: Vec<[&str; 3]> = answers
        .iter()
        .map(|(_, line)| ["receiver", "quantity", "unit"].map(|key| line[key].as_str().unwrap_or("")))
        .collect();
    assert_eq!(
        asked,
        [["here", "irradiance", "W/m²"], ["floor: map", "irradiance", "W/m²"], ["floor: map", "flux", "W"]]
    );
    for (keys, line) in &answers {
        assert_eq!(*keys, ["receiver", "quantity", "unit", "band", "value", "error", "kind", "seconds"]);
        assert!(
            line["band"].is_null() && ["bound", "estimate", "sigma"].iter().any(|kind| line["kind"] == *kind),
            "{line}"
        );
        assert!(["value", "error", "seconds"].iter().all(|key| line[key].is_f64()), "{line}");
    }
    let [mean, flux] = [&answers[1], &answers[2]].map(|(_, line)| line["value"].as_f64().expect("a number"));
    assert!((flux - 2.0 * mean).abs() < 1e-9 * flux, "the floor has 2 m²: {mean} {flux}");
}

#[test]
fn results_on_geometry_go_into_the_folder_of_the_output() {
    let plane = "[[receiver]]\nname = \"scene\"\nkind = \"point\"\n\
                 plane = { origin = [0, 0, 0.5], u = [2, 0, 0], v = [0, 1, 0], count = [2, 3] }\n";
    let faces = "[[receiver]]\nname = \"faces\"\nkind = \"faces\"\nsurface = \"floor\"\n";
    let folder = Folder::with(&[("room.toml", &room(&format!("{MAP}{plane}{faces}")))]);
    let run = forms(&folder, &["simulate", "room.toml", "--vtu"]);
    assert_eq!(run.status, 2);
    assert!(run.errors.contains("--out <DIR>"), "{}", run.errors);
    let run = forms(&folder, &["simulate", "room.toml", "--out", "out", "--vtu", "--json"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    for file in ["scene.vtu", "floor__map.vtu", "scene_2.vtu", "faces.vtu", "scene.png", "floor__map.exr"] {
        assert!(!folder.read(&format!("out/{file}")).is_empty(), "{file}");
    }
    assert!(!folder.path("out/faces.png").exists(), "faces are in no order");
    let answers = run.output.lines().map(object).filter(|(keys, _)| keys[0] == "receiver");
    let quantities: Vec<String> = answers
        .filter(|(_, line)| line["receiver"] == "faces")
        .filter_map(|(_, line)| line["quantity"].as_str().map(str::to_owned))
        .collect();
    assert_eq!(quantities, ["irradiance", "flux", "net_flux"]);
}

#[test]
fn the_text_is_the_plan_and_the_answers_as_tables() {
    let folder = Folder::with(&[("room.toml", &room(POINT))]);
    let run = forms(&folder, &["simulate", "room.toml"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let lines: Vec<&str> = run.output.lines().collect();
    assert_eq!(lines[0], "Plan of Room");
    for part in ["effect", "simulated", "bound [W/m²]", "why"] {
        assert!(lines[1].contains(part), "{}", run.output);
    }
    let from_head = lines.iter().copied().skip_while(|line| !line.trim_start().starts_with("kernel "));
    let kernels: Vec<&str> = from_head.take_while(|line| !line.is_empty()).collect();
    assert!(kernels[0].ends_with("operations  computes"), "{}", run.output);
    let gathered: Vec<&str> = kernels[1].split_whitespace().collect();
    assert_eq!(gathered[..4], ["gathered_light", "2", "of", "5"], "of luminaires and reflected");
    assert!(kernels.iter().any(|line| line.trim_start().starts_with("edge_form_factor ")), "{}", run.output);
    assert!(kernels.iter().all(|line| line.chars().count() <= 80), "{}", run.output);
    let answer = lines.iter().find(|line| line.trim_start().starts_with("here ")).expect("the answer");
    assert!(
        answer.contains(" irradiance ") && answer.contains(" ± ") && answer.contains(" W/m² "),
        "{answer}"
    );
    assert!(run.output.contains("largest error relative to its answer"), "{}", run.output);
    let method = "\n  method: radiosity on adaptive elements\n  reason: surfaces are diffuse, in a vacuum";
    assert!(run.output.contains(method), "{}", run.output);
    let shared = lines.iter().find(|line| line.trim_start().starts_with("(shared) ")).expect("the rest");
    assert!(shared.contains(" solution ") && shared.ends_with('s'), "{shared}");
}

#[test]
fn the_parts_of_the_largest_error_are_told_where_there_are_several() {
    const CUBE: [&str; 6] = [
        "[0,0,0], [1,0,0], [1,1,0], [0,1,0]",
        "[0,0,1], [0,1,1], [1,1,1], [1,0,1]",
        "[0,0,0], [0,1,0], [0,1,1], [0,0,1]",
        "[1,0,0], [1,0,1], [1,1,1], [1,1,0]",
        "[0,0,0], [0,0,1], [1,0,1], [1,0,0]",
        "[0,1,0], [1,1,0], [1,1,1], [0,1,1]",
    ];
    let wall = |(index, corners): (usize, &&str)| {
        format!("[[surface]]\nname = \"{index}\"\nmaterial = \"wall\"\nexitance = 1\npolygon = [{corners}]\n")
    };
    let walls: String = CUBE.iter().enumerate().map(wall).collect();
    let room = |reflectance: &str| {
        format!(
            "[[material]]\nname = \"wall\"\nkind = \"diffuse\"\nreflectance = {reflectance}\n{walls}{POINT}"
        )
    };
    let folder = Folder::with(&[("grey.toml", &room("0.5")), ("black.toml", &room("0"))]);
    let output = |scene| forms(&folder, &["simulate", scene]).output;
    let found = output("grey.toml");
    let parts =
        found.lines().find_map(|line| line.strip_prefix("this error consists of ")).expect("the parts");
    assert!(parts.contains("% quadrature") && parts.contains("% rounding"), "{parts}");
    let percents =
        parts.split(", ").map(|part| part.split('%').next().unwrap().parse::<f64>().expect("a number"));
    // Each percentage is rounded.
    assert!((percents.sum::<f64>() - 100.0).abs() <= 2.0, "{parts}");
    // The error of a closed form consists of rounding only.
    assert!(!output("black.toml").contains("this error consists of"));
}

/// Returns the channels of an EXR file and its width and height.
fn channels(folder: &Folder, name: &str) -> (HashMap<String, Vec<f32>>, (usize, usize)) {
    let image = exr::prelude::read_first_flat_layer_from_file(folder.path(name)).expect("OpenEXR");
    let list = image.layer_data.channel_data.list.into_iter();
    let values =
        list.map(|channel| (channel.name.to_string(), channel.sample_data.values_as_f32().collect()));
    (values.collect(), image.layer_data.size.into())
}

#[test]
fn the_files_have_every_cell_and_agree_with_each_other() {
    let folder = Folder::with(&[("room.toml", &room(&format!("{POINT}{MAP}")))]);
    let run = forms(&folder, &["simulate", "room.toml", "--out", "new/results"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    assert!(run.output.contains("results.csv, floor__map.exr, floor__map.png, error.svg"), "{}", run.output);
    let table = folder.read("new/results/results.csv");
    let mut reader = csv::Reader::from_reader(table.as_slice());
    assert_eq!(
        reader.headers().expect("a header"),
        vec!["receiver", "quantity", "band", "bin", "i", "j", "value", "error", "kind"]
    );
    let lines: Vec<csv::StringRecord> = reader.records().map(|line| line.expect("a line")).collect();
    let (scalars, cells): (Vec<_>, Vec<_>) = lines.iter().partition(|line| line[4].is_empty());
    assert_eq!((scalars.len(), cells.len()), (3, 6 * 3));
    let (channels, size) = channels(&folder, "new/results/floor__map.exr");
    assert_eq!(size, (6, 3));
    for cell in cells {
        let [i, j] = [4, 5].map(|place| cell[place].parse::<usize>().expect("a number"));
        let value: f64 = cell[6].parse().expect("a number");
        assert_eq!(channels["Y"][(2 - j) * 6 + i], value as f32, "{i}, {j}");
    }
    let picture = folder.read("new/results/floor__map.png");
    let mut picture = png::Decoder::new(Cursor::new(picture)).read_info().expect("PNG");
    let mut pixels = vec![0; picture.output_buffer_size().expect("a size")];
    let frame = picture.next_frame(&mut pixels).expect("pixels");
    assert_eq!((frame.width, frame.height), (6 * 43, 3 * 43));
    let figure = String::from_utf8(folder.read("new/results/error.svg")).expect("text");
    assert!(
        figure.starts_with("<svg") && figure.contains("tolerance 1e-3") && figure.contains("[s]"),
        "{figure}"
    );
}

#[test]
fn each_band_has_its_answers_and_its_channel() {
    let bands = format!("bands = [[400, 550], [550, 700]]\n{}", room(MAP));
    let folder = Folder::with(&[("room.toml", &bands)]);
    let run = forms(&folder, &["simulate", "room.toml", "--json", "--out", "."]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let objects = run.output.lines().map(|line| object(line).1).filter(|line| line["receiver"].is_string());
    let bands: Vec<Option<u64>> = objects.map(|line| line["band"].as_u64()).collect();
    assert_eq!(bands, [Some(0), Some(1), Some(0), Some(1)]);
    let (channels, _) = channels(&folder, "floor__map.exr");
    let mut names: Vec<&str> = channels.keys().map(String::as_str).collect();
    names.sort_unstable();
    assert_eq!(names, ["B", "G", "R", "band0", "band1"]);
}

#[test]
fn what_cannot_be_done_is_said_before_the_work() {
    let scene = room(POINT);
    let ball = room(&format!(
        "{POINT}[[surface]]\nname = \"ball\"\nmaterial = \"silver\"\nsphere = {{ center = [0, 0, 2], radius = 0.1 }}\n\
        [[material]]\nname = \"silver\"\nkind = \"mirror\"\nreflectance = 0.9\n\
        [[light]]\nkind = \"point\"\nposition = [0, 0, 1]\nintensity = 1\n"
    ));
    let nothing = "<scene version=\"3.0.0\"/>";
    let files = [
        ("room.toml", scene.as_str()),
        ("dark.toml", &room("")),
        ("ball.toml", &ball),
        ("dark.xml", nothing),
        ("taken", ""),
    ];
    let folder = Folder::with(&files);
    let cases: [(&[&str], &str); 6] = [
        (&["missing.toml"], "error: missing.toml: "),
        (&["dark.toml"], "add a receiver, for example\n  [[receiver]]"),
        (&["dark.xml"], "add a sensor"),
        (
            &["ball.toml"],
            "distant lights that the curved surface `ball` reflects or refracts is not supported",
        ),
        (&["room.toml", "--out", "taken"], "cannot create the folder `taken`: "),
        (&["room.toml", "--out", "taken/below"], "cannot create the folder `taken/below`: "),
    ];
    for (arguments, message) in cases {
        let run = forms(&folder, &[&["simulate"], arguments].concat());
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{arguments:?}");
        assert!(
            run.errors.starts_with("error: ") && run.errors.contains(message),
            "{arguments:?}: {}",
            run.errors
        );
    }
}

#[test]
fn a_receiver_that_the_message_suggests_is_simulated() {
    let folder = Folder::with(&[("dark.toml", &room(""))]);
    let errors = forms(&folder, &["simulate", "dark.toml"]).errors;
    let (_, receiver) = errors.split_once("for example\n").expect("an example");
    folder.write("lit.toml", room(receiver).as_bytes());
    assert_eq!(forms(&folder, &["simulate", "lit.toml"]).status, 0);
    let floor = "<shape type=\"rectangle\"/><shape type=\"sphere\"><emitter type=\"area\"><rgb name=\"radiance\" value=\"1, 1, 1\"/></emitter></shape>";
    folder.write("dark.xml", format!("<scene version=\"3.0.0\">{floor}</scene>").as_bytes());
    let errors = forms(&folder, &["simulate", "dark.xml"]).errors;
    let (_, sensor) = errors.split_once("for example\n").expect("an example");
    let scene = format!("<scene version=\"3.0.0\">{sensor}</scene>");
    let read = forms_radiometry::scene::read(&scene, "lit.xml").map(|scene| scene.receivers.len());
    assert_eq!(read, Ok(1));
}

#[test]
fn a_file_that_cannot_be_written_is_named_and_the_others_are_written() {
    let folder = Folder::with(&[("room.toml", &room(MAP))]);
    std::fs::create_dir_all(folder.path("out/floor__map.png")).expect("a folder in the way");
    let run = forms(&folder, &["simulate", "room.toml", "--out", "out"]);
    assert_eq!(run.status, 2);
    let name = std::path::Path::new("out").join("floor__map.png");
    assert!(
        run.errors.starts_with(&format!("error: `{}` cannot be written: ", name.display())),
        "{}",
        run.errors
    );
    assert!(
        run.output.contains("floor: map") && run.output.contains("floor__map.exr, error.svg"),
        "{}",
        run.output
    );
}

#[cfg(unix)]
#[test]
fn work_that_is_stopped_gives_what_there_is() {
    let large = MAP.replace("[6, 3]", "[600, 600]").replace("floor: map", "large");
    let folder = Folder::with(&[("room.toml", &room(&format!("{POINT}{large}")))]);
    let run =
        interrupted(&folder, &["simulate", "room.toml", "--json", "--out", "out"], "\"effect\":\"time\"");
    assert_eq!(run.status, 130, "{}", run.errors);
    assert!(run.errors.contains("stopped: answers may be missing"), "{}", run.errors);
    assert!(folder.read("out/results.csv").starts_with(b"receiver,quantity,"));
}

#[test]
fn work_whose_time_is_over_gives_what_there_is_and_says_what_misses_the_tolerance() {
    let folder = Folder::with(&[("hall.toml", &hall(1e-9))]);
    let run = |seconds: &str| forms(&folder, &["simulate", "hall.toml", "--json", "--seconds", seconds]);
    let late = run("0.3");
    assert_eq!(late.status, 3, "{}", late.errors);
    assert!(late.errors.starts_with("the time is over: answers may be missing"), "{}", late.errors);
    let answers = late.output.lines().map(|line| object(line).1);
    assert!(answers.filter(|line| line["receiver"].is_string()).all(|line| line["missed"] == true));
    for wrong in ["-1", "soon", "nan"] {
        let run = run(wrong);
        assert_eq!(run.status, 2, "{}", run.errors);
        assert!(run.errors.contains("expected a number of seconds"), "{}", run.errors);
    }
}

#[test]
fn an_exposure_is_the_irradiance_times_the_time_and_follows_it() {
    let ball = "[[receiver]]\nname = \"ball\"\nkind = \"sphere\"\nposition = [1, 0.5, 0.5]\n";
    let folder = Folder::with(&[("room.toml", &room(&format!("{POINT}{MAP}{ball}")))]);
    let run = forms(&folder, &["simulate", "room.toml", "--json", "--exposure", "2.5", "--out", "out"]);
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    let answers: Vec<Value> = run.output.lines().map(|line| object(line).1).collect();
    let answers: Vec<&Value> = answers.iter().filter(|line| line["receiver"].is_string()).collect();
    let asked: Vec<[&str; 2]> =
        answers.iter().map(|line| ["quantity", "unit"].map(|key| line[key].as_str().unwrap_or(""))).collect();
    let vector = |axis| [axis, "W/m²"];
    let irradiance = [["irradiance", "W/m²"], ["exposure", "J/m²"]];
    let fluence = [["fluence_rate", "W/m²"], ["fluence", "J/m²"]];
    let axes = ["vector_irradiance_x", "vector_irradiance_y", "vector_irradiance_z"].map(vector);
    let expected = [&irradiance[..], &irradiance, &[["flux", "W"]], &fluence, &axes].concat();
    assert_eq!(asked, expected);
    for pair in answers.windows(2).filter(|pair| pair[1]["unit"] == "J/m²") {
        let [rate, sum] = ["value", "error"].map(|key| [0, 1].map(|i| pair[i][key].as_f64().unwrap()));
        assert!((rate[1] - 2.5 * rate[0]).abs() <= 1e-15 * rate[1], "{pair:?}");
        assert!(sum[1] >= 2.5 * sum[0] && sum[1] < 2.51 * sum[0] + 1e-15 * rate[1], "{pair:?}");
    }
    let table = String::from_utf8(folder.read("out/results.csv")).expect("text");
    let lines = |quantity: &str| table.lines().filter(|line| line.contains(quantity)).count();
    assert_eq!([lines(",exposure,"), lines(",fluence,")], [2, 1]);
}

#[test]
fn a_time_that_is_none_and_light_that_is_not_steady_have_no_exposure() {
    let timed = format!("{POINT}time = {{ start = 0, width = 1e-9, bins = 4 }}\n");
    let folder = Folder::with(&[("room.toml", &room(POINT)), ("timed.toml", &room(&timed))]);
    for seconds in ["0", "-1", "nan", "inf", "1e999", "long"] {
        let run = forms(&folder, &["simulate", "room.toml", "--exposure", seconds]);
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{seconds}");
        assert!(
            run.errors.contains("expected a number of seconds from 1e-30 to 1e30"),
            "{seconds}: {}",
            run.errors
        );
    }
    let run = forms(&folder, &["simulate", "timed.toml", "--exposure", "1"]);
    assert_eq!((run.status, run.output.as_str()), (2, ""));
    assert!(run.errors.contains("timed.toml:20:8: the receiver `here` is time-resolved"), "{}", run.errors);
}
