//! `forms simulate --shard` and `forms merge`: shares combine to the results of a single run, and
//! parts that do not belong together are reported.

use crate::hall::{FILES, LAMP, hall};
use crate::process::{Folder, forms, forms_with_threads};

/// Asserts that the merged shares give the same files as a run without shares.
fn assert_shares_are_the_whole(folder: &Folder, count: usize, threads: [&str; 2], options: &[&str]) {
    let simulate = |rest: &[&str], threads: &str| {
        let run = forms_with_threads(folder, &[&["simulate", "hall.toml"], options, rest].concat(), threads);
        assert_eq!((run.status, run.errors.as_str()), (0, ""), "{rest:?}");
    };
    simulate(&["--out", "whole"], threads[0]);
    let parts: Vec<String> = (1..=count).map(|share| format!("{share}.part")).collect();
    for (place, part) in parts.iter().enumerate() {
        let share = format!("{}/{count}", place + 1);
        simulate(&["--shard", &share, "--out", part], threads[place % 2]);
    }
    let last_first: Vec<&str> = parts.iter().rev().map(String::as_str).collect();
    let run = forms(folder, &[&["merge"], last_first.as_slice(), &["--out", "merged"]].concat());
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    for file in FILES {
        let [whole, merged] = ["whole", "merged"].map(|name| folder.read(&format!("{name}/{file}")));
        assert!(!whole.is_empty() && whole == merged, "{file} of {count} shares, {options:?}");
    }
}

#[test]
fn shares_come_to_the_bits_of_one_run_however_many_there_are() {
    let folder = Folder::with(&[("hall.toml", &hall(0.1))]);
    for (count, threads) in [(1, ["1", "2"]), (3, ["2", "1"]), (7, ["1", "2"])] {
        assert_shares_are_the_whole(&folder, count, threads, &[]);
        assert_shares_are_the_whole(&folder, count, threads, &["--samples", "1024"]);
    }
    assert_shares_are_the_whole(&folder, 2, ["1", "2"], &["--exposure", "2.5", "--isa", "baseline"]);
}

#[test]
fn points_and_faces_are_divided_among_shares_like_cells() {
    let many = "[[receiver]]\nname = \"many\"\nkind = \"sphere\"\npoints = \"points.csv\"\n\
                [[receiver]]\nname = \"faces\"\nkind = \"faces\"\nsurface = \"floor\"\n";
    let text = hall(0.1).replace("[solve]", &format!("{many}[solve]"));
    let folder = Folder::with(&[("hall.toml", &text), ("points.csv", "x,y,z\n1,0.5,0.1\n0.2,0.5,0.5\n")]);
    assert_shares_are_the_whole(&folder, 3, ["1", "2"], &[]);
    let table = String::from_utf8(folder.read("merged/results.csv")).expect("text");
    let rows = |start: &str| table.lines().filter(|line| line.starts_with(start)).count();
    assert_eq!(rows("many,fluence_rate,,,1,0,"), 1);
    assert_eq!((rows("many,"), rows("faces,net_flux,")), (4 * 3, 2));
    let parts = ["1.part", "2.part", "3.part"];
    let run = forms(&folder, &[&["merge"], &parts[..], &["--out", "geometry", "--vtu"]].concat());
    assert_eq!((run.status, run.errors.as_str()), (0, ""));
    for file in ["scene.vtu", "here.vtu", "map.vtu", "many.vtu", "faces.vtu"] {
        assert!(!folder.read(&format!("geometry/{file}")).is_empty(), "{file}");
    }
}

/// Returns the standard output of a run in JSON, without the times.
fn untimed(output: &str) -> Vec<String> {
    output.lines().map(|line| line.split(",\"seconds\"").next().unwrap_or(line).to_owned()).collect()
}

#[test]
fn one_receiver_is_divided_into_its_replicates_where_the_samples_are_counted() {
    let text = hall(0.1);
    let (surfaces, _) = text.split_once("[[receiver]]\nname = \"map\"").expect("a second receiver");
    let folder = Folder::with(&[("hall.toml", surfaces)]);
    let counted = ["--samples", "640", "--json"];
    let whole = forms(&folder, &[&["simulate", "hall.toml"], counted.as_slice()].concat());
    let mut parts = Vec::new();
    for share in ["1/5", "2/5", "3/5", "4/5", "5/5"] {
        let part = share.replace('/', "of");
        let run = forms(
            &folder,
            &[&["simulate", "hall.toml", "--shard", share, "--out", &part], counted.as_slice()].concat(),
        );
        let units = if share < "3/5" { 7 } else { 6 };
        let record = format!("{{\"share\":\"{share}\",\"part\":\"{part}\",\"units\":{units},\"of\":32}}");
        assert_eq!((run.status, run.output.lines().last()), (0, Some(record.as_str())), "{}", run.errors);
        parts.push(part);
    }
    let parts: Vec<&str> = parts.iter().map(String::as_str).collect();
    let merged = forms(&folder, &[&["merge", "--json"], parts.as_slice()].concat());
    assert_eq!((merged.status, untimed(&merged.output)), (0, untimed(&whole.output)), "{}", merged.errors);

    let run = forms(&folder, &["simulate", "hall.toml", "--shard", "2/2", "--out", "empty"]);
    assert_eq!(run.status, 0);
    assert!(
        run.errors.contains("none is left for this one; with --samples each is divided into 32"),
        "{}",
        run.errors
    );
}

#[test]
fn a_part_that_is_missing_damaged_of_other_work_or_repeated_is_named() {
    let other = hall(0.1).replace("0.9", "0.8");
    let folder = Folder::with(&[("hall.toml", &hall(0.1)), ("other.toml", &other)]);
    let simulate = |arguments: &[&str]| {
        let run = forms(&folder, &[&["simulate"], arguments].concat());
        assert_eq!(run.status, 0, "{}", run.errors);
    };
    simulate(&["hall.toml", "--shard", "1/2", "--out", "a"]);
    simulate(&["hall.toml", "--shard", "2/2", "--out", "b"]);
    simulate(&["hall.toml", "--shard", "2/2", "--out", "b again"]);
    simulate(&["hall.toml", "--shard", "2/3", "--out", "of three"]);
    simulate(&["hall.toml", "--shard", "2/2", "--samples", "64", "--out", "counted"]);
    simulate(&["hall.toml", "--shard", "2/2", "--exposure", "2", "--out", "exposed"]);
    simulate(&["hall.toml", "--shard", "2/2", "--isa", "baseline", "--out", "baseline"]);
    simulate(&["other.toml", "--shard", "2/2", "--out", "other"]);
    simulate(&["hall.toml", "--checkpoint", "checkpoint"]);
    let mut bytes = folder.read("b");
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    folder.write("damaged", &bytes);
    folder.write("cut", &folder.read("b")[..middle]);
    let cases: [(&[&str], &[&str]); 11] = [
        (&["a"], &["shard 2/2 is missing", "forms simulate hall.toml --shard 2/2 --out PART"]),
        (&["exposed"], &["shard 1/2 is missing", "--shard 1/2 --exposure 2 --out PART"]),
        (&["counted"], &["shard 1/2 is missing", "--shard 1/2 --samples 64 --out PART"]),
        (&["a", "damaged"], &["the part `damaged` is damaged", "shard 2/2 is missing"]),
        (&["a", "cut"], &["the part `cut` is damaged"]),
        (&["a", "hall.toml"], &["the part `hall.toml` was written by another program"]),
        (&["a", "checkpoint"], &["the part `checkpoint` was written by another program"]),
        (&["a", "nowhere"], &["the part `nowhere` cannot be read"]),
        (&["a", "of three"], &["the part `of three` does not match `a`", "it is shard 2/3"]),
        (&["a", "counted"], &["the part `counted` does not match `a`", "64 samples per value"]),
        (&["a", "other"], &["the part `other` does not match `a`", "another scene"]),
    ];
    for (parts, messages) in cases {
        let run = forms(&folder, &[&["merge"], parts].concat());
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{parts:?}");
        messages
            .iter()
            .for_each(|message| assert!(run.errors.contains(message), "{message}: {}", run.errors));
    }
    let run = forms(&folder, &["merge", "a", "b", "b again"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(run.errors.contains("`b` and `b again` are both shard 2/2 and identical"), "{}", run.errors);
    if forms::math::Instructions::best().name() != "baseline" {
        let run = forms(&folder, &["merge", "a", "baseline"]);
        assert_eq!(run.status, 2);
        assert!(run.errors.contains("computed with other instructions"), "{}", run.errors);
    }
}

#[test]
fn a_scene_that_is_solved_as_a_whole_is_the_first_share_and_its_parts_come_to_the_bytes_of_one_run() {
    let map = "[[receiver]]\nname = \"map\"\nkind = \"surface\"\nsurface = \"lamp\"\ngrid = [3, 2]\n";
    let folder = Folder::with(&[("lamp.toml", &format!("{LAMP}{map}"))]);
    assert_eq!(forms(&folder, &["simulate", "lamp.toml", "--out", "whole"]).status, 0);
    for count in [1, 3, 7] {
        let parts: Vec<String> = (1..=count).map(|share| format!("{share} of {count}")).collect();
        for (share, part) in (1..).zip(&parts) {
            let run = forms(
                &folder,
                &["simulate", "lamp.toml", "--shard", &format!("{share}/{count}"), "--out", part],
            );
            let what = if share == 1 { "all of the work" } else { "nothing" };
            assert!(run.status == 0 && run.output.contains(what), "{} {}", run.output, run.errors);
            let note = format!("all of the work belongs to shard 1/{count}");
            assert_eq!(run.errors.contains(&note), count > 1, "{}", run.errors);
        }
        let out = format!("merged {count}");
        let arguments: Vec<&str> = parts.iter().rev().map(String::as_str).chain(["--out", &out]).collect();
        let run = forms(&folder, &[&["merge"], arguments.as_slice()].concat());
        assert_eq!(run.status, 0, "{}", run.errors);
        for file in ["results.csv", "map.exr"] {
            assert_eq!(
                folder.read(&format!("{out}/{file}")),
                folder.read(&format!("whole/{file}")),
                "{file}"
            );
        }
    }
    let run = forms(&folder, &["merge", "2 of 3", "3 of 3"]);
    assert!(run.status == 2 && run.errors.contains("shard 1/3 is missing"), "{}", run.errors);
    let run = forms(&folder, &["merge", "1 of 3", "1 of 3", "2 of 3", "3 of 3"]);
    assert!(run.status == 0 && run.errors.contains("and identical"), "{}", run.errors);
}

#[test]
fn the_call_is_checked_before_the_work() {
    let folder = Folder::with(&[("hall.toml", &hall(0.1)), ("lamp.toml", LAMP)]);
    let cases: [(&[&str], &str); 7] = [
        (&["hall.toml", "--shard", "1/2"], "--out"),
        (
            &["hall.toml", "--shard", "3/2", "--out", "a"],
            "`3/2` is not a shard: expected i/n with i from 1 to n",
        ),
        (&["hall.toml", "--shard", "0/0", "--out", "a"], "`0/0` is not a shard"),
        (&["hall.toml", "--samples", "0"], "0 is not a valid number of samples"),
        (&["hall.toml", "--isa", "abacus"], "this processor has baseline"),
        (&["hall.toml", "--shard", "1/2", "--out", "no/where"], "the part `no/where` cannot be written"),
        (&["lamp.toml", "--samples", "64"], "so it has no samples: omit --samples"),
    ];
    for (arguments, message) in cases {
        let run = forms(&folder, &[&["simulate"], arguments].concat());
        assert_eq!((run.status, run.output.as_str()), (2, ""), "{arguments:?}");
        assert!(run.errors.contains(message), "{arguments:?}: {}", run.errors);
    }
}
