//! A medium that is entered through the surfaces of a scene is left through them too, and fills a
//! space that no other medium fills. These tests define the rule by bodies, and by the same bodies
//! with defects.

use crate::{errors, read, shown};
use forms_radiometry::geometry::Vector;

/// List of polygons, with the material of each.
pub(crate) type Body = Vec<(String, &'static str, Vec<Vector>)>;

/// Returns the faces of a box, counter-clockwise seen from outside: bottom, top, front, back, left,
/// right.
fn cuboid(name: &str, material: &'static str, low: [f64; 3], high: [f64; 3]) -> Body {
    let corner = |i: usize| {
        let at = |axis: usize| if i >> axis & 1 == 1 { high[axis] } else { low[axis] };
        Vector::new(at(0), at(1), at(2))
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let face = |(i, face): (usize, &[usize; 4])| (format!("{name}_{i}"), material, face.map(corner).to_vec());
    faces.iter().enumerate().map(face).collect()
}

fn reversed(mut body: Body) -> Body {
    body.iter_mut().for_each(|(_, _, vertices)| vertices.reverse());
    body
}

/// Returns a scene of the bodies, followed by the rest of its text.
pub(crate) fn text(bodies: &[Body], rest: &str) -> String {
    let mut text = String::from(
        "[[medium]]\nname = \"glass\"\nn = 1.5\n[[medium]]\nname = \"water\"\nn = 1.33\n\
         [[material]]\nname = \"glass\"\nkind = \"dielectric\"\ninside = \"glass\"\n\
         [[material]]\nname = \"water\"\nkind = \"dielectric\"\ninside = \"water\"\n\
         [[material]]\nname = \"wall\"\nkind = \"diffuse\"\nreflectance = 0.5\n",
    );
    for (name, material, vertices) in bodies.iter().flatten() {
        let vertices: Vec<[f64; 3]> = vertices.iter().map(|v| [v.x, v.y, v.z]).collect();
        text +=
            &format!("[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\npolygon = {vertices:?}\n");
    }
    text + rest
}

fn check(name: &str, bodies: &[Body], rest: &str) {
    if let Err(errors) = read(&text(bodies, rest), "media.toml") {
        panic!("{name}: {}", shown(&errors));
    }
}

fn refused(name: &str, bodies: &[Body], rest: &str, expected: &[&str]) {
    let found = errors(&text(bodies, rest), "media.toml");
    let messages: Vec<&str> = found.iter().map(|error| &*error.message).collect();
    assert_eq!(messages, expected, "{name}");
}

fn unit(material: &'static str) -> Body {
    cuboid("cube", material, [0.0; 3], [1.0; 3])
}

fn without(mut body: Body, face: usize) -> Body {
    body.remove(face);
    body
}

fn sphere(name: &str, material: &str, radius: f64, inward: bool) -> String {
    format!(
        "[[surface]]\nname = \"{name}\"\nmaterial = \"{material}\"\n\
         sphere = {{ center = [0.5, 0.5, 0.5], radius = {radius}, inward = {inward} }}\n"
    )
}

#[test]
fn a_closed_body_holds_its_medium() {
    check("cube", &[unit("glass")], "");
    check("sphere", &[], &sphere("ball", "glass", 1.0, false));
    check(
        "cube with a coordinate that rounding moved",
        &[{
            let mut cube = unit("glass");
            cube[3].2.iter_mut().filter(|v| v.x == 1.0).for_each(|v| v.x += 1e-14);
            cube
        }],
        "",
    );
}

#[test]
fn bodies_may_lie_in_each_other() {
    let small = || cuboid("small", "water", [0.25; 3], [0.75; 3]);
    check("water in glass", &[unit("glass"), small()], "");
    check("a ball in a cube", &[unit("glass")], &sphere("ball", "water", 0.4, false));
    check("a cube in a ball", &[unit("glass")], &sphere("ball", "water", 4.0, false));
    let shell = sphere("outside", "glass", 1.0, false) + &sphere("inside", "glass", 0.5, true);
    check("a hollow ball", &[], &shell);
}

/// Returns water up to z = 0.5 in a glass: walls from x = 0 to 1, water between 0.25 and 0.75, open
/// at the top.
pub(crate) fn glass_of_water() -> Vec<Body> {
    let corners = |x: [f64; 2], y: [f64; 2], z: f64| {
        [[x[0], y[0], z], [x[1], y[0], z], [x[1], y[1], z], [x[0], y[1], z]]
            .map(|[x, y, z]| Vector::new(x, y, z))
    };
    let ring = |outer: [Vector; 4], inner: [Vector; 4], name: &str| -> Body {
        let side = |i: usize| {
            let j = (i + 1) % 4;
            (format!("{name}_{i}"), "glass", vec![outer[i], outer[j], inner[j], inner[i]])
        };
        (0..4).map(side).collect()
    };
    let outer = |z| corners([0.0, 1.0], [0.0, 1.0], z);
    let inner = |z| corners([0.25, 0.75], [0.25, 0.75], z);
    let bottom = vec![("bottom".to_owned(), "glass", outer(0.0).into_iter().rev().collect())];
    let rim = ring(outer(1.0), inner(1.0), "rim");
    let dry = reversed(ring(inner(0.5), inner(1.0), "dry"));
    let wet = reversed(ring(inner(0.2), inner(0.5), "wet"));
    let floor = vec![("floor".to_owned(), "glass", inner(0.2).to_vec())];
    let water = vec![("water".to_owned(), "water", inner(0.5).to_vec())];
    vec![bottom, ring(outer(0.0), outer(1.0), "wall"), rim, dry, wet, floor, water]
}

#[test]
fn media_may_meet_along_a_line() {
    check("a glass of water", &glass_of_water(), "");
}

#[test]
fn what_is_opaque_closes_a_medium_too() {
    let basin = |height: f64| reversed(without(cuboid("basin", "wall", [0.0; 3], [1.0, 1.0, height]), 1));
    let square = [[0.0, 0.0, 1.0], [1.0, 0.0, 1.0], [1.0, 1.0, 1.0], [0.0, 1.0, 1.0]];
    let surface =
        || vec![("pool".to_owned(), "water", square.map(|[x, y, z]| Vector::new(x, y, z)).to_vec())];
    check("a basin filled to its edge", &[basin(1.0), surface()], "");
    let split = cuboid("half", "wall", [0.0; 3], [0.5, 1.0, 1.0]).swap_remove(0);
    let other = cuboid("rest", "wall", [0.5, 0.0, 0.0], [1.0; 3]).swap_remove(0);
    let floor = reversed(vec![split, other]);
    check("a basin whose floor is in two pieces", &[without(basin(1.0), 0), floor, surface()], "");
    let gap = "the edge of `basin_2` from [1, 0, 0] to [0, 0, 0] meets no other surface";
    refused(
        "a basin without a floor",
        &[without(basin(1.0), 0), surface()],
        "",
        &[&format!("the boundary of `water` at `pool` is not closed: {gap}")],
    );
    let gap = "the edge of `pool` from [0, 0, 1] to [1, 0, 1] meets no other surface";
    refused(
        "a basin whose walls go on above the water",
        &[basin(2.0), surface()],
        "",
        &[&format!("the boundary of `water` at `pool` is not closed: {gap}")],
    );
}

#[test]
fn an_opening_is_named_by_an_edge_of_it() {
    let message = |face: &str| {
        format!(
            "the boundary of `glass` at `cube_{face}` is not closed: the edge of `cube_0` \
             from [0, 1, 0] to [1, 1, 0] \
             meets no other surface"
        )
    };
    let found = errors(&text(&[without(unit("glass"), 3)], ""), "media.toml");
    assert_eq!(found.len(), 5);
    assert_eq!(found[0].message, message("0"));
    let single = vec![unit("glass").swap_remove(0)];
    assert_eq!(errors(&text(&[single], ""), "media.toml").len(), 1);
    let disk = "[[surface]]\nname = \"lens\"\nmaterial = \"glass\"\n\
                disk = { center = [0, 0, 0], normal = [0, 0, 1], radius = 1 }\n";
    refused(
        "a disk",
        &[],
        disk,
        &[
            "the boundary of `glass` at `lens` is not closed: the rim of `lens` around [0, 0, 0] meets no other surface",
        ],
    );
}

#[test]
fn a_body_that_is_turned_inside_out_would_fill_the_scene() {
    let found = errors(&text(&[reversed(unit("glass"))], ""), "media.toml");
    assert_eq!(found.len(), 6);
    let message = "`glass` behind `cube_0` fills the same region as vacuum around the scene";
    assert_eq!(found[0].message, message);
    refused(
        "an inward sphere",
        &[],
        &sphere("ball", "glass", 1.0, true),
        &["`glass` behind `ball` fills the same region as vacuum around the scene"],
    );
}

#[test]
fn a_face_that_is_turned_has_its_medium_on_both_sides() {
    let mut cube = unit("glass");
    cube[1].2.reverse();
    let found = errors(&text(&[cube], ""), "media.toml");
    let message = "`glass` behind `cube_1` fills the same region as vacuum around the scene";
    assert_eq!(found[0].message, message, "{}", shown(&found));
}

#[test]
fn a_space_is_filled_once() {
    refused(
        "a shell that says water outside and glass inside of it",
        &[],
        &(sphere("outside", "glass", 1.0, false) + &sphere("inside", "water", 0.5, true)),
        &["`water` behind `inside` fills the same region as `glass` behind `outside`"],
    );
    refused(
        "glass in glass",
        &[],
        &(sphere("outside", "glass", 1.0, false) + &sphere("inside", "glass", 0.5, false)),
        &["`glass` is on both sides of `inside`"],
    );
    refused(
        "a bubble of nothing in a scene full of glass",
        &[],
        &(sphere("bubble", "glass", 1.0, true) + "[ambient]\nmedium = \"glass\"\n"),
        &["`glass` is on both sides of `bubble`"],
    );
    refused(
        "glass in a scene full of it",
        &[],
        &(sphere("ball", "glass", 1.0, false) + "[ambient]\nmedium = \"glass\"\n"),
        &["`glass` is on both sides of `ball`"],
    );
}

#[test]
fn boundaries_that_lie_upon_each_other_have_no_order() {
    let found = errors(
        &text(&[unit("glass"), cuboid("next", "water", [1.0, 0.0, 0.0], [2.0, 1.0, 1.0])], ""),
        "m.toml",
    );
    let messages: Vec<&str> = found.iter().map(|error| &*error.message).collect();
    assert_eq!(messages, ["`next_4` overlaps `cube_5` in one plane"]);
}
