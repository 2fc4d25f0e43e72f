//! `forms view-factors`: the formats of its output, shards, resumed work, and closed scenes.

use super::process::{Folder, forms};

#[test]
fn view_factors_of_a_scene_are_a_matrix_with_sums_and_areas_or_lines_with_errors() {
    let squares = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5
        [[surface]]\nname = \"floor\"\nmaterial = \"grey\"\npolygon = [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]
        [[surface]]\nname = \"lamp\"\nmaterial = \"grey\"\npolygon = [[0,0,1], [0,1,1], [1,1,1], [1,0,1]]
        [solve]\ntolerance = 1e-12\n";
    let folder =
        Folder::with(&[("squares.toml", squares), ("broken.toml", "[[surface]]\nname = \"floor\"\n")]);
    let run = forms(&folder, &["view-factors", "squares.toml"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    let lines: Vec<&str> = run.output.lines().collect();
    assert_eq!(lines[0], "from,floor,lamp,sum,area");
    let row: Vec<f64> = lines[1].split(',').skip(1).map(|value| value.parse().expect("a number")).collect();
    assert!(row[0] == 0.0 && (row[1] - 0.199_824_895_698_387).abs() < 1e-14 && row[2] == row[1], "{row:?}");
    assert_eq!(row[3], 1.0, "the area, in m²");
    assert!(run.errors.contains("A1 F12 - A2 F21"), "{}", run.errors);
    let json = forms(&folder, &["view-factors", "squares.toml", "--json"]).output;
    assert!(
        json.lines()
            .nth(1)
            .is_some_and(|line| line.starts_with("{\"from\":\"floor\",\"to\":\"lamp\",\"value\":0.1998")),
        "{json}"
    );
    assert!(json.lines().all(|line| line.ends_with(",\"area\":1.0}")), "{json}");
    let broken = forms(&folder, &["view-factors", "broken.toml"]);
    assert_eq!((broken.status, broken.output.as_str()), (2, ""));
    assert!(broken.errors.contains("broken.toml:1:1: this surface has no `material`"), "{}", broken.errors);
}

#[test]
fn a_row_of_view_factors_above_one_is_an_error_that_names_what_it_sums_up() {
    // The lamp is there as a square and as two triangles.
    let scene = "unit = \"cm\"\n[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5
[[surface]]\nname = \"floor\"\nmaterial = \"grey\"\npolygon = [[0,0,0], [1,0,0], [1,1,0], [0,1,0]]
[[surface]]\nname = \"lamp\"\nmaterial = \"grey\"\nmesh = \"lamp.obj\"\n";
    let lamp = "v 0 0 0.1\nv 0 1 0.1\nv 1 1 0.1\nv 1 0 0.1\nf 1 2 3 4\n";
    let twice = lamp.to_owned() + "f 1 2 3\nf 1 3 4\n";
    let folder = Folder::with(&[("scene.toml", scene), ("lamp.obj", &twice)]);
    let run = forms(&folder, &["view-factors", "scene.toml"]);
    assert_eq!(run.status, 2, "{}", run.errors);
    assert!(run.output.lines().all(|line| !line.starts_with("floor,")), "{}", run.output);
    let expected = "scene.toml:9:11: the view factors of `floor` sum to 1.65";
    assert!(run.errors.contains(expected) && run.errors.contains(" to `lamp`"), "{}", run.errors);
    let folder = Folder::with(&[("scene.toml", scene), ("lamp.obj", lamp)]);
    let run = forms(&folder, &["view-factors", "scene.toml"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(run.output.lines().nth(1).is_some_and(|line| line.ends_with(",0.0001")), "{}", run.output);
}

#[test]
fn view_factors_of_disks_and_spheres_are_those_of_exact_shapes() {
    let scene = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5
        [[surface]]\nname = \"disk\"\nmaterial = \"grey\"\ndisk = { center = [0,0,0], normal = [0,0,1], radius = 1 }
        [[surface]]\nname = \"ball\"\nmaterial = \"grey\"\nsphere = { center = [0,0,1.5], radius = 0.5 }
        [solve]\ntolerance = 1e-3\n";
    let folder = Folder::with(&[("round.toml", scene)]);
    let json = forms(&folder, &["view-factors", "round.toml", "--json"]).output;
    let from_ball: serde_json::Value =
        serde_json::from_str(json.lines().nth(2).expect("four lines")).expect("JSON");
    let [value, error] = ["value", "error"].map(|key| from_ball[key].as_f64().expect("a number"));
    // Howell's catalogue, a sphere to a coaxial disk: (1 - h/sqrt(h² + r²))/2
    let expected = 0.5 * (1.0 - 1.5 / 1.5_f64.hypot(1.0));
    assert_eq!(from_ball["kind"], "bound");
    assert!((value - expected).abs() <= error && error < 1e-12, "{value}, {error} and {expected}");
}

/// Returns a scene of a corridor with a pillar and a ball.
fn corridor() -> String {
    let mut text = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5\n".to_owned();
    for (name, corners) in [
        ("floor", "[[0,0,0], [4,0,0], [4,1,0], [0,1,0]]"),
        ("left", "[[0,1,0], [4,1,0], [4,1,1], [0,1,1]]"),
        ("right", "[[4,0,0], [0,0,0], [0,0,1], [4,0,1]]"),
    ] {
        text += &format!("[[surface]]\nname = \"{name}\"\nmaterial = \"grey\"\npolygon = {corners}\n");
    }
    text + "[[surface]]\nname = \"pillar\"\nmaterial = \"grey\"\nmesh = \"pillar.obj\"
        [[surface]]\nname = \"ball\"\nmaterial = \"grey\"\nsphere = { center = [1,0.5,0.5], radius = 0.2 }
        [solve]\ntolerance = 0.01\n"
}

const PILLAR: &str = "v 2 0.4 0.1\nv 2.2 0.4 0.1\nv 2.2 0.6 0.1\nv 2 0.6 0.1\nv 2 0.4 1\nv 2.2 0.4 1\nv 2.2 0.6 1\nv 2 0.6 1\n\
    g sides\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\ng ends\nf 1 4 3 2\nf 5 6 7 8\n";

#[test]
fn shards_and_resumed_work_give_the_rows_of_one_run() {
    let folder = Folder::with(&[("scene.toml", &corridor()), ("pillar.obj", PILLAR)]);
    let whole = forms(&folder, &["view-factors", "scene.toml", "--by", "group"]);
    assert_eq!(whole.status, 0, "{}", whole.errors);
    let rows: Vec<&str> = whole.output.lines().skip(1).collect();
    let names: Vec<&str> = rows.iter().filter_map(|row| row.split(',').next()).collect();
    assert_eq!(names, ["floor", "left", "right", "pillar/sides", "pillar/ends", "ball"]);
    for shard in ["1/2", "2/2"] {
        let part = forms(&folder, &["view-factors", "scene.toml", "--by", "group", "--shard", shard]).output;
        let part: Vec<&str> = part.lines().skip(1).collect();
        assert!(part.len() == 3 && part.iter().all(|row| rows.contains(row)), "{shard}: {part:?}");
    }
    let call = ["view-factors", "scene.toml", "--by", "group", "--checkpoint", "rows"];
    assert_eq!(forms(&folder, &call).output, whole.output);
    let journal = folder.read("rows");
    // killed within a line: the rows before it are there, and the others are computed again
    for length in [0, 30, journal.len() / 3, journal.len() / 2, journal.len() - 1] {
        folder.write("rows", &journal[..length]);
        let run = forms(&folder, &call);
        assert_eq!((run.status, &run.output), (0, &whole.output), "{length}: {}", run.errors);
        assert_eq!(folder.read("rows"), journal, "{length}");
    }
    let other = forms(&folder, &["view-factors", "scene.toml", "--checkpoint", "rows"]);
    assert_eq!(other.status, 2);
    assert!(other.errors.contains("belongs to other work"), "{}", other.errors);
    folder.write("rows", b"notes of mine\n");
    let other = forms(&folder, &call);
    assert!(other.status == 2 && other.errors.contains("is not a checkpoint"), "{}", other.errors);
    assert_eq!(folder.read("rows"), b"notes of mine\n", "it is left as it is");
}

#[test]
fn pairs_of_view_factors_are_listed_without_zeros_and_faces_have_rows() {
    let folder = Folder::with(&[("scene.toml", &corridor()), ("pillar.obj", PILLAR)]);
    let run = forms(&folder, &["view-factors", "scene.toml", "--by", "face", "--sparse"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    let mut lines = run.output.lines();
    assert_eq!(lines.next(), Some("from,to,factor,error"));
    let pairs: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    assert!(pairs.iter().any(|pair| pair[0] == "pillar#2" && pair[1] == "floor"), "{}", run.output);
    let value = |pair: &Vec<&str>| pair[2].parse::<f64>().expect("a number");
    assert!(pairs.iter().all(|pair| pair.len() == 4 && value(pair) > 0.0), "{}", run.output);
    assert!(!pairs.iter().any(|pair| pair[0] == pair[1]), "flat faces do not see themselves");
}

#[test]
fn an_enclosed_matrix_obeys_both_laws_and_an_open_scene_is_refused() {
    let open = Folder::with(&[("scene.toml", &corridor()), ("pillar.obj", PILLAR)]);
    let run = forms(&open, &["view-factors", "scene.toml", "--enclose"]);
    assert_eq!(run.status, 2, "{}", run.errors);
    assert!(run.errors.contains("light leaves the scene"), "{}", run.errors);
    let shells = "[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5
        [[surface]]\nname = \"shell\"\nmaterial = \"grey\"\nsphere = { center = [0,0,0], radius = 2, inward = true }
        [[surface]]\nname = \"ball\"\nmaterial = \"grey\"\nsphere = { center = [0.3,0,0], radius = 1 }\n";
    let folder = Folder::with(&[("shells.toml", shells)]);
    let run = forms(&folder, &["view-factors", "shells.toml", "--enclose"]);
    assert_eq!(run.status, 0, "{}", run.errors);
    assert!(run.errors.contains("enclosed: rows sum to 1"), "{}", run.errors);
    let rows: Vec<Vec<f64>> = run
        .output
        .lines()
        .skip(1)
        .map(|line| line.split(',').skip(1).map(|value| value.parse().expect("a number")).collect())
        .collect();
    // the ball is convex, and sees only the shell
    assert!(
        rows[1][0] == 1.0 && (rows[0][1] - 0.25).abs() < 1e-12 && (rows[0][2] - 1.0).abs() < 1e-12,
        "{rows:?}"
    );
}
