//! A surface can lie `on` another one only where it can replace a part of it; the other surface is
//! then the remainder.

use crate::overlaps::{Surface, WALL, WINDOW, check, grey, read, scene};
use crate::shown;
use forms_radiometry::geometry::Polygon;
use forms_radiometry::scene::{Scene, Shape};

/// Returns the area of a surface.
fn area(scene: &Scene, name: &str) -> f64 {
    let surface = scene.surfaces.iter().find(|surface| surface.name == name).expect("a surface");
    match &surface.shape {
        Shape::Polygon(polygon) => polygon.area(),
        Shape::Mesh(mesh) => mesh.polygons().map(|polygon| polygon.area()).sum(),
        Shape::Sphere(_) | Shape::Disk(_) | Shape::Quadric(_) => panic!("{name} is round"),
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
    let inside = "a surface inside `wall`";
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
            "`a` is 3.0e-2 away from the plane of `wall`",
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
            "50.00 % of the area of `a` lies outside `wall`",
            inside,
        ),
        (
            "outside",
            vec![wall(), grey("a", on("polygon = [[5,0,1], [5,0,2], [6,0,2], [6,0,1]]", "wall"))],
            "100.00 % of the area of `a` lies outside `wall`",
            inside,
        ),
        (
            "a disk outside in part",
            vec![wall(), grey("a", on(&disk.replace("[2,0,1.5]", "[2,0,3]"), "wall"))],
            "50.00 % of the area of `a` lies outside `wall`",
            inside,
        ),
        (
            "a window as large as its wall",
            vec![wall(), grey("a", on(WALL, "wall"))],
            "nothing is left of `wall`",
            "surfaces that do not cover it completely",
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
            "on = \"a\", so that `b` replaces this part of `a`",
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
    // a box of glass behind opaque walls with one window
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
        assert!(found[0].message.contains("is not closed"), "{name}: {}", shown(&found));
    }
}
