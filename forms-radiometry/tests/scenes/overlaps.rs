//! Surfaces in one plane that get light from the same side are reported with both names, unless one lies `on` the other;
//! and a surface lies `on` another one only where it can replace a part of it.

use crate::{files, shown};
use forms_radiometry::geometry::Polygon;
use forms_radiometry::scene::{Scene, SceneError, Shape, read_with_files};

/// A surface of a scene: its name, its material, and the line of its shape with lines of more keys.
type Surface = (&'static str, &'static str, String);

/// A message and an expectation.
type Problem = (String, String);

/// A window in a wall of 4 by 3.
const WINDOW: &str = "polygon = [[1,0,1], [1,0,2.5], [3,0,2.5], [3,0,1]]";
const WALL: &str = "polygon = [[0,0,0], [0,0,3], [4,0,3], [4,0,0]]";

fn grey(name: &'static str, shape: impl Into<String>) -> Surface {
    (name, "grey", shape.into())
}

/// A square of this side in the plane z = 0 that looks up, with a corner at x, 0.
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

fn read(surfaces: &[Surface]) -> Result<Scene, Vec<SceneError>> {
    let head = "[[medium]]\nname = \"glass\"\nn = 1.5\n[[material]]\nname = \"grey\"\nkind = \"diffuse\"\n\
        reflectance = 0.5\n[[material]]\nname = \"pane\"\nkind = \"dielectric\"\ninside = \"glass\"\n";
    let surface = |(name, material, shape): &Surface| {
        format!("[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\n{shape}\n")
    };
    let text = head.to_owned() + &surfaces.iter().map(surface).collect::<String>();
    read_with_files(&text, "scene.toml", &mesh)
}

fn scene(name: &str, surfaces: &[Surface]) -> Scene {
    read(surfaces).unwrap_or_else(|errors| panic!("{name}: {}", shown(&errors)))
}

/// Checks that the surfaces of a case are read, or that this message, with this expectation, is all that is wrong.
fn check(name: &str, surfaces: &[Surface], expected: Option<(&str, &str)>) {
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
            Some((b_overlaps_a(same_way), "on = \"a\", with which `b` replaces that part of `a`".into())),
        ),
        (
            "a disk in a polygon",
            floor.clone(),
            disk(1.0, 0.25),
            Some((b_overlaps_a(same_way), "on = \"a\", with which `b` replaces that part of `a`".into())),
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
    let expected = Some(("`b` lies upon `a`", "one surface between two media"));
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

/// The area of a surface.
fn area(scene: &Scene, name: &str) -> f64 {
    let surface = scene.surfaces.iter().find(|surface| surface.name == name).expect("a surface");
    match &surface.shape {
        Shape::Polygon(polygon) => polygon.area(),
        Shape::Mesh(mesh) => mesh.polygons().map(|polygon| polygon.area()).sum(),
        Shape::Sphere(_) | Shape::Disk(_) => panic!("{name} is round"),
    }
}

#[test]
fn a_surface_on_another_one_replaces_that_part_of_it() {
    use std::f64::consts::PI;
    let on = |shape: &str, base: &str| format!("{shape}\non = \"{base}\"");
    let wall = || grey("wall", WALL);
    let window = || grey("window", on(WINDOW, "wall"));
    let door = || grey("door", on("polygon = [[0.2,0,0], [0.2,0,2], [0.9,0,2], [0.9,0,0]]", "wall"));
    let pane = || grey("pane", on("polygon = [[1.5,0,1.5], [1.5,0,2], [2.5,0,2], [2.5,0,1.5]]", "window"));
    let lamp = grey("lamp", on("disk = { center = [2,0,1.5], normal = [0,1,0], radius = 0.5 }", "wall"));
    let cases: Vec<(&str, Vec<Surface>, f64)> = vec![
        ("a window", vec![wall(), window()], 9.0),
        ("a window before its wall", vec![window(), wall()], 9.0),
        ("a window and a door", vec![window(), wall(), door()], 7.6),
        ("a pane in a window in a wall", vec![pane(), wall(), window()], 9.0),
        ("a mesh", vec![wall(), grey("pane", on("mesh = \"pane.obj\"", "wall"))], 10.0),
        ("on a mesh", vec![grey("wall", "mesh = \"wall.obj\""), window()], 9.0),
        ("a disk", vec![wall(), lamp], 12.0 - 0.25 * PI),
        (
            "a window at the edge",
            vec![wall(), grey("top", on("polygon = [[0,0,2], [0,0,3], [4,0,3], [4,0,2]]", "wall"))],
            8.0,
        ),
        (
            "a window off the plane by rounding",
            vec![wall(), grey("a", on(&WINDOW.replace(",0,", ",1e-10,"), "wall"))],
            9.0,
        ),
        (
            "a window beyond the edge by rounding",
            vec![wall(), grey("a", on("polygon = [[1,0,-1e-9], [1,0,1], [2,0,1], [2,0,-1e-9]]", "wall"))],
            11.0,
        ),
    ];
    for (name, surfaces, expected) in &cases {
        let found = area(&scene(name, surfaces), "wall");
        assert!((found - expected).abs() < 1e-8, "{name}: {found}");
    }
    let nested = scene("nested", &cases[3].1);
    assert!((area(&nested, "window") - 2.5).abs() < 1e-14 && (area(&nested, "pane") - 0.5).abs() < 1e-14);
    let outline = nested.surfaces[1].shape.as_polygon().map(Polygon::vertices);
    assert_eq!(outline.map(<[_]>::len), Some(4), "the outline of a wall stays");
}

#[test]
fn a_surface_that_cannot_lie_on_another_one_is_reported_with_the_reason() {
    let on = |shape: &str, base: &str| format!("{shape}\non = \"{base}\"");
    let wall = || grey("wall", WALL);
    let disk = "disk = { center = [2,0,1.5], normal = [0,1,0], radius = 0.5 }";
    let ball = "sphere = { center = [2,0,1], radius = 0.5 }";
    let bases = "the name of a surface that is a polygon or a planar mesh";
    let shapes = "a polygon, a disk or a planar mesh";
    let inside = "a surface inside of `wall`";
    let circle = "a surface that does not lie on this one";
    let cases: Vec<(&str, Vec<Surface>, &str, &str)> = vec![
        (
            "an unknown name",
            vec![wall(), grey("a", on(WINDOW, "wal"))],
            "no surface is named `wal`",
            "`a` or `wall`",
        ),
        ("itself", vec![grey("a", on(WINDOW, "a"))], "`a` lies on itself", circle),
        (
            "a circle of two",
            vec![grey("a", on(WINDOW, "b")), grey("b", on(WALL, "a"))],
            "`a` lies on `b`, `b` on `a`",
            circle,
        ),
        (
            "a circle of three that another one leads to",
            vec![
                grey("d", on(WINDOW, "c")),
                grey("a", on(WINDOW, "b")),
                grey("b", on(WALL, "c")),
                grey("c", on(WALL, "a")),
            ],
            "`a` lies on `b`, `b` on `c`, `c` on `a`",
            circle,
        ),
        (
            "a sphere",
            vec![wall(), grey("a", on(ball, "wall"))],
            "`a` is a sphere, and cannot lie on a surface",
            shapes,
        ),
        (
            "on a sphere",
            vec![grey("ball", ball), grey("a", on(WINDOW, "ball"))],
            "no surface can lie on `ball`, which is a sphere",
            bases,
        ),
        (
            "on a disk",
            vec![grey("b", disk), grey("a", on(WINDOW, "b"))],
            "no surface can lie on `b`, which is a disk",
            bases,
        ),
        (
            "a mesh that is not planar",
            vec![wall(), grey("a", on("mesh = \"part.obj\"", "wall"))],
            "`a` is a mesh that is not planar, and cannot lie on a surface",
            shapes,
        ),
        (
            "on a mesh that is not planar",
            vec![grey("b", "mesh = \"part.obj\""), grey("a", on(WINDOW, "b"))],
            "no surface can lie on `b`, which is a mesh that is not planar",
            bases,
        ),
        (
            "a disk on a mesh",
            vec![grey("b", "mesh = \"wall.obj\""), grey("a", on(disk, "b"))],
            "`a` is a disk, which cannot lie on the mesh `b`",
            "a polygon",
        ),
        (
            "off the plane",
            vec![wall(), grey("a", on(&WINDOW.replace(",0,", ",0.03,"), "wall"))],
            "`a` lies 3.0e-2 off the plane of `wall`",
            "a surface in the plane of `wall`",
        ),
        (
            "the other way",
            vec![wall(), grey("a", on("polygon = [[3,0,1], [3,0,2.5], [1,0,2.5], [1,0,1]]", "wall"))],
            "`a` does not face the same way as `wall`",
            "vertices in the opposite order",
        ),
        (
            "a disk the other way",
            vec![wall(), grey("a", on(&disk.replace("[0,1,0]", "[0,-1,0]"), "wall"))],
            "`a` does not face the same way as `wall`",
            "a normal in the opposite direction",
        ),
        (
            "outside in part",
            vec![wall(), grey("a", on("polygon = [[3,0,1], [3,0,2], [5,0,2], [5,0,1]]", "wall"))],
            "`a` reaches beyond `wall`, by 50.00 % of its area",
            inside,
        ),
        (
            "outside",
            vec![wall(), grey("a", on("polygon = [[5,0,1], [5,0,2], [6,0,2], [6,0,1]]", "wall"))],
            "`a` reaches beyond `wall`, by 100.00 % of its area",
            inside,
        ),
        (
            "a disk outside in part",
            vec![wall(), grey("a", on(&disk.replace("[2,0,1.5]", "[2,0,3]"), "wall"))],
            "`a` reaches beyond `wall`, by 50.00 % of its area",
            inside,
        ),
        (
            "a window as large as its wall",
            vec![wall(), grey("a", on(WALL, "wall"))],
            "nothing is left of `wall`",
            "surfaces that leave a part of it",
        ),
        (
            "two that overlap",
            vec![
                wall(),
                grey("a", on(WINDOW, "wall")),
                grey("b", on("polygon = [[2,0,2], [2,0,3], [4,0,3], [4,0,2]]", "wall")),
            ],
            "`b` overlaps `a` (line 19): both lie in one plane and face the same way",
            "surfaces that do not overlap",
        ),
        (
            "a pane on the wall of its window",
            vec![
                wall(),
                grey("a", on(WINDOW, "wall")),
                grey("b", on("polygon = [[2,0,2], [2,0,2.3], [2.4,0,2.3], [2.4,0,2]]", "wall")),
            ],
            "`b` overlaps `a` (line 19): both lie in one plane and face the same way",
            "on = \"a\", with which `b` replaces that part of `a`",
        ),
    ];
    for (name, surfaces, message, expected) in &cases {
        check(name, surfaces, Some((message, expected)));
    }
}

#[test]
fn an_error_of_on_stands_where_the_key_does() {
    let found =
        read(&[grey("wall", WALL), grey("a", format!("on = \"wal\"\n{WINDOW}"))]).expect_err("no wall");
    assert_eq!((found.len(), found[0].line, found[0].column), (1, 19, 6), "{}", shown(&found));
}

#[test]
fn a_window_is_a_part_of_the_wall_around_a_medium() {
    // a box of glass behind opaque walls, into which one window looks
    let faces: [(&str, [[f64; 3]; 4]); 6] = [
        ("below", [[0., 0., 0.], [0., 3., 0.], [4., 3., 0.], [4., 0., 0.]]),
        ("above", [[0., 0., 3.], [4., 0., 3.], [4., 3., 3.], [0., 3., 3.]]),
        ("wall", [[0., 0., 0.], [4., 0., 0.], [4., 0., 3.], [0., 0., 3.]]),
        ("behind", [[0., 3., 0.], [0., 3., 3.], [4., 3., 3.], [4., 3., 0.]]),
        ("left", [[0., 0., 0.], [0., 0., 3.], [0., 3., 3.], [0., 3., 0.]]),
        ("right", [[4., 0., 0.], [4., 3., 0.], [4., 3., 3.], [4., 0., 3.]]),
    ];
    let body = || faces.map(|(name, corners)| grey(name, format!("polygon = {corners:?}"))).to_vec();
    let pane = |name: &'static str, [left, low]: [f64; 2], [right, high]: [f64; 2]| {
        let corners = [[left, 0.0, low], [right, 0.0, low], [right, 0.0, high], [left, 0.0, high]];
        (name, "pane", format!("polygon = {corners:?}\non = \"wall\""))
    };
    let lens = (
        "lens",
        "pane",
        "disk = { center = [2,0,1.5], normal = [0,-1,0], radius = 1 }\non = \"wall\"".into(),
    );
    let frame = grey("frame", "polygon = [[1,0,1], [3,0,1], [3,0,2], [1,0,2]]\non = \"wall\"");
    let in_frame =
        ("pane", "pane", "polygon = [[2,0,1.5], [2.5,0,1.5], [2.5,0,2], [2,0,2]]\non = \"frame\"".into());
    for (name, panes) in [
        ("in the middle", vec![pane("a", [1.0, 1.0], [2.0, 2.0])]),
        ("at the ground", vec![pane("a", [1.0, 0.0], [2.0, 2.0])]),
        ("in a corner", vec![pane("a", [0.0, 0.0], [2.0, 2.0])]),
        ("from side to side", vec![pane("a", [0.0, 1.0], [4.0, 2.0])]),
        ("side by side", vec![pane("a", [1.0, 1.0], [2.0, 2.0]), pane("b", [2.0, 1.0], [3.0, 2.0])]),
        (
            "with a corner in common",
            vec![pane("a", [1.0, 1.0], [2.0, 2.0]), pane("b", [2.0, 2.0], [3.0, 3.0])],
        ),
        ("round", vec![lens]),
        ("in a frame", vec![frame, in_frame]),
    ] {
        scene(name, &[body(), panes.clone()].concat());
        let without_floor: Vec<Surface> = [body()[1..].to_vec(), panes].concat();
        let found = read(&without_floor).expect_err("an open body");
        assert!(found[0].message.contains("is entered through"), "{name}: {}", shown(&found));
    }
}
