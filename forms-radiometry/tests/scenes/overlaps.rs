//! Surfaces in one plane that get light from the same side are reported with both names, unless one
//! lies `on` the other.

use crate::{files, shown};
use forms_radiometry::scene::{Scene, SceneError, read_with_files};

/// Surface of a scene: its name, its material, and the line of its shape with lines of more keys.
pub(crate) type Surface = (&'static str, &'static str, String);

/// Message and expectation.
type Problem = (String, String);

/// A window in a wall of 4 by 3.
pub(crate) const WINDOW: &str = "polygon = [[1,0,1], [1,0,2.5], [3,0,2.5], [3,0,1]]";
pub(crate) const WALL: &str = "polygon = [[0,0,0], [0,0,3], [4,0,3], [4,0,0]]";

pub(crate) fn grey(name: &'static str, shape: impl Into<String>) -> Surface {
    (name, "grey", shape.into())
}

/// Returns a square of this side in the plane z = 0 that faces up, with a corner at x, 0.
fn square(x: f64, side: f64) -> String {
    let far = x + side;
    format!("polygon = [[{x:?},0,0], [{far:?},0,0], [{far:?},{side:?},0], [{x:?},{side:?},0]]")
}

fn mesh(name: &str) -> std::io::Result<Vec<u8>> {
    let text = match name {
        "pane.obj" => "v 1 0 1\nv 1 0 2\nv 2 0 2\nv 3 0 2\nv 3 0 1\nv 2 0 1\nf 1 2 3 6\nf 6 3 4 5\n",
        "wall.obj" => "v 0 0 0\nv 0 0 3\nv 2 0 3\nv 4 0 3\nv 4 0 0\nv 2 0 0\nf 1 2 3 6\nf 6 3 4 5\n",
        "doubled.obj" => "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 3 4\n",
        _ => return files(name),
    };
    Ok(text.into())
}

pub(crate) fn read(surfaces: &[Surface]) -> Result<Scene, Vec<SceneError>> {
    let head = "[[medium]]\nname = \"glass\"\nn = 1.5\n[[material]]\nname = \"grey\"\nkind = \"diffuse\"\n\
        reflectance = 0.5\n[[material]]\nname = \"pane\"\nkind = \"dielectric\"\ninside = \"glass\"\n";
    let surface = |(name, material, shape): &Surface| {
        format!("[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{shape}\n")
    };
    let text = head.to_owned() + &surfaces.iter().map(surface).collect::<String>();
    read_with_files(&text, "scene.toml", &mesh)
}

pub(crate) fn scene(name: &str, surfaces: &[Surface]) -> Scene {
    read(surfaces).unwrap_or_else(|errors| panic!("{name}: {}", shown(&errors)))
}

/// Checks that the surfaces of a case are read without error, or that this message, with this
/// expectation, is the only error.
pub(crate) fn check(name: &str, surfaces: &[Surface], expected: Option<(&str, &str)>) {
    let found = read(surfaces).map_or_else(|errors| errors, |_| Vec::new());
    let problems: Vec<(&str, &str)> = found.iter().map(|error| (&*error.message, &*error.expected)).collect();
    assert_eq!(problems, Vec::from_iter(expected), "{name}");
}

#[test]
fn surfaces_that_overlap_and_face_the_same_way_are_reported_with_both_names() {
    const APART: &str = "surfaces that do not overlap";
    let (floor, back) = (square(0.0, 1.0), "polygon = [[0,0,0], [0,1,0], [1,1,0], [1,0,0]]");
    let two_sided = |shape: &str| format!("{shape}\ntwo_sided = true");
    let disk = |up: f64, radius: f64| {
        format!("disk = {{ center = [0.5,0.5,0], normal = [0,0,{up:?}], radius = {radius:?} }}")
    };
    let same_way = "both lie in one plane and face the same way";
    let a_overlaps_b = |how: &str| format!("`a` overlaps `b` (line LINE): {how}");
    let b_overlaps_a = |how: &str| format!("`b` overlaps `a` (line 15): {how}");
    let cases: Vec<(&str, String, String, Option<Problem>)> = vec![
        ("in part", square(0.0, 1.0), square(0.9, 2.0), Some((a_overlaps_b(same_way), APART.into()))),
        ("twice the same", floor.clone(), floor.clone(), Some((b_overlaps_a(same_way), APART.into()))),
        (
            "one in the other",
            square(0.0, 3.0),
            square(0.0, 1.0),
            Some((b_overlaps_a(same_way), "on = \"a\", so that `b` replaces this part of `a`".into())),
        ),
        (
            "a disk in a polygon",
            floor.clone(),
            disk(1.0, 0.25),
            Some((b_overlaps_a(same_way), "on = \"a\", so that `b` replaces this part of `a`".into())),
        ),
        ("a polygon in a disk", floor.clone(), disk(1.0, 2.0), Some((a_overlaps_b(same_way), APART.into()))),
        ("a disk in a disk", disk(1.0, 2.0), disk(1.0, 1.0), Some((b_overlaps_a(same_way), APART.into()))),
        (
            "a face of a mesh",
            "mesh = \"part.obj\"".into(),
            "polygon = [[2,0,0], [2,1,0], [3,1,0], [3,0,0]]".into(),
            Some((a_overlaps_b(same_way), APART.into())),
        ),
        ("back to back", floor.clone(), back.into(), None),
        ("a disk back to back", floor.clone(), disk(-1.0, 0.25), None),
        (
            "back to back, with two sides",
            floor.clone(),
            two_sided(back),
            Some((b_overlaps_a("both lie in one plane, and `b` is two-sided"), APART.into())),
        ),
        ("with two sides", two_sided(&floor), square(0.5, 2.0), Some((a_overlaps_b(same_way), APART.into()))),
        ("side by side", floor.clone(), square(1.0, 2.0), None),
        ("side by side up to decimals", floor.clone(), square(1.0 - 1e-9, 2.0), None),
        ("above each other", floor.clone(), floor.replace("0]", "0.001]"), None),
        ("a mesh with a face twice", "mesh = \"doubled.obj\"".into(), square(2.0, 1.0), None),
    ];
    for (name, a, b, expected) in &cases {
        let line = 19 + a.matches('\n').count();
        let expected = expected
            .as_ref()
            .map(|(message, expected)| (message.replace("LINE", &line.to_string()), expected.clone()));
        let expected = expected.as_ref().map(|(message, expected)| (&**message, &**expected));
        check(name, &[grey("a", a.clone()), grey("b", b.clone())], expected);
    }
}

#[test]
fn a_boundary_of_a_medium_lies_upon_nothing() {
    let expected = Some(("`b` overlaps `a` in one plane", "one surface between two media"));
    let pane = ("b", "pane", square(0.25, 0.5));
    check("facing the same way", &[grey("a", square(0.0, 1.0)), pane], expected);
    let pane = ("b", "pane", "polygon = [[0,0,0], [0,0.5,0], [0.5,0.5,0], [0.5,0,0]]".into());
    check("facing the other way", &[grey("a", square(0.0, 1.0)), pane], expected);
}

#[test]
fn two_surfaces_are_reported_once_however_many_of_their_faces_overlap() {
    check(
        "a mesh on a mesh",
        &[grey("wall", "mesh = \"wall.obj\""), grey("pane", "mesh = \"pane.obj\"")],
        Some((
            "`pane` overlaps `wall` (line 15): both lie in one plane and face the same way",
            "surfaces that do not overlap",
        )),
    );
}

#[test]
fn an_overlap_in_a_scene_of_mitsuba_is_reported_without_advice_to_use_on() {
    let text = "<scene version=\"3.0.0\">
        <shape type=\"rectangle\" id=\"floor\"/>
        <shape type=\"disk\" id=\"lamp\"><emitter type=\"area\"><rgb name=\"radiance\" value=\"1\"/></emitter></shape>
    </scene>";
    let found = read_with_files(text, "scene.xml", &mesh).expect_err("an overlap");
    assert_eq!(found.len(), 1, "{}", shown(&found));
    assert_eq!((found[0].line, &*found[0].expected), (3, "surfaces that do not overlap"));
    assert!(found[0].message.starts_with("`lamp` overlaps `floor` (line 2)"), "{}", found[0].message);
}

#[test]
fn a_box_of_mitsuba_stands_on_a_floor_also_if_both_are_two_sided() {
    let text = "<scene version=\"3.0.0\">
        <bsdf type=\"twosided\" id=\"grey\"><bsdf type=\"diffuse\"/></bsdf>
        <shape type=\"rectangle\" id=\"floor\"><ref id=\"grey\"/></shape>
        <shape type=\"cube\" id=\"box\"><ref id=\"grey\"/><transform name=\"to_world\">
            <scale value=\"0.25\"/><translate z=\"0.25\"/>
        </transform></shape>
    </scene>";
    let scene =
        read_with_files(text, "scene.xml", &mesh).unwrap_or_else(|errors| panic!("{}", shown(&errors)));
    assert!(scene.surfaces.iter().all(|surface| surface.two_sided));
    let turned =
        text.replace("id=\"floor\">", "id=\"floor\"><boolean name=\"flip_normals\" value=\"true\"/>");
    let found = read_with_files(&turned, "scene.xml", &mesh).expect_err("both look down");
    assert!(found[0].message.starts_with("`box` overlaps `floor`"), "{}", shown(&found));
}
