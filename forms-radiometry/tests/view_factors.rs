//! View factors of the reference, and their reported errors.

use forms_radiometry::form_factor::{view_factor, visible_exchange};
use forms_radiometry::geometry::{Polygon, Vector};
use forms_radiometry::scene::{Scene, read};
use forms_radiometry::view_factors;
use forms_testing::SplitMix;
use serde_json::Value;
use std::fmt::Write;

const ROWS: &str = include_str!("../../tests/reference/visible.json");

fn rows(group: &str) -> Vec<Value> {
    let file: Value = serde_json::from_str(ROWS).expect("JSON");
    let rows = file["cases"].as_array().expect("a list of rows").iter();
    let rows: Vec<Value> = rows.filter(|row| row["group"] == group).cloned().collect();
    assert!(!rows.is_empty(), "{group}");
    rows
}

fn value(row: &Value) -> f64 {
    row["value"].as_str().and_then(|text| text.parse().ok()).expect("a decimal")
}

/// Returns the polygon with these vertices that faces a point: both sides of a polygon count.
fn facing(vertices: &Value, point: Vector) -> Polygon {
    let vertices = vertices.as_array().expect("vertices").iter();
    let mut vertices: Vec<Vector> = vertices.map(vector).collect();
    let polygon = Polygon::new(vertices.clone()).expect("a polygon");
    if polygon.normal().dot(point - vertices[0]) >= 0.0 {
        return polygon;
    }
    vertices.reverse();
    Polygon::new(vertices).expect("a polygon")
}

fn vector(coordinates: &Value) -> Vector {
    let number = |axis: usize| coordinates[axis].as_f64().expect("a number");
    Vector::new(number(0), number(1), number(2))
}

fn middle(vertices: &Value) -> Vector {
    let vertices: Vec<Vector> = vertices.as_array().expect("vertices").iter().map(vector).collect();
    (1.0 / vertices.len() as f64) * vertices.iter().fold(Vector::default(), |sum, &v| sum + v)
}

#[test]
fn view_factors_of_the_reference_are_right_to_twelve_digits_and_within_what_is_said() {
    for row in rows("view_factor_polygons") {
        let [a, b] = [&row["inputs"]["A"], &row["inputs"]["B"]];
        let (from, to) = (facing(a, middle(b)), facing(b, middle(a)));
        let (found, expected) = (view_factor(&from, &to, 1e-13), value(&row));
        let error = (found.area - expected).abs();
        let id = &row["id"];
        assert!(error <= 1e-12 * expected, "{id}: {} and {expected}, {:e}", found.area, error / expected);
        // the corners of the row, and the expected value, are rounded too
        assert!(
            error <= found.error + 4.0 * f64::EPSILON * expected,
            "{id}: {error:e}, said {:e}",
            found.error
        );
    }
}

#[test]
fn a_view_factor_with_an_obstruction_is_within_what_is_said() {
    let square = |height: f64, size: f64| {
        let corners = [[0.0, 0.0, height], [size, 0.0, height], [size, size, height], [0.0, size, height]];
        Value::from(corners.map(|corner| Value::from(corner.to_vec())).to_vec())
    };
    let [below, above] = [Vector::new(0.0, 0.0, -1.0), Vector::new(0.0, 0.0, 9.0)];
    let (from, to, screen) = (
        facing(&square(0.0, 1.0), above),
        facing(&square(1.0, 1.0), below),
        facing(&square(0.5, 0.5), above),
    );
    let [row] = &rows("occlusion")[..] else { panic!("one row") };
    for tolerance in [1e-3, 1e-5, 1e-6] {
        let found = visible_exchange(&from, &to, [&from, &to, &screen].into_iter(), tolerance);
        let error = (found.area - value(row)).abs();
        assert!(
            error <= found.error && found.error <= tolerance,
            "{tolerance}: {error:e}, {:e}",
            found.error
        );
    }
}

/// The corners of a box, by the bits of x, y and z, counter-clockwise from outside.
const SIDES: [[usize; 4]; 6] =
    [[0, 4, 6, 2], [1, 3, 7, 5], [0, 1, 5, 4], [2, 6, 7, 3], [0, 2, 3, 1], [4, 5, 7, 6]];

/// How the bodies in a room are placed.
#[derive(Clone, Copy, Debug)]
enum Placed {
    Turned,
    OnAGrid,
    OnTheFloor,
}

/// Appends the sides of a box as surfaces.
fn add_box(
    text: &mut String,
    name: &str,
    [low, high]: [[f64; 3]; 2],
    is_room: bool,
    turn: impl Fn(Vector) -> Vector,
) {
    let corner = |bits: usize| {
        let at = |axis: usize| if bits >> axis & 1 == 0 { low[axis] } else { high[axis] };
        let turned = turn(Vector::new(at(0), at(1), at(2)));
        format!("[{:?}, {:?}, {:?}]", turned.x, turned.y, turned.z)
    };
    for (side, corners) in SIDES.iter().enumerate() {
        let mut corners = corners.map(corner);
        if is_room {
            corners.reverse();
        }
        let polygon = corners.join(", ");
        writeln!(text, "[[surface]]\nname = \"{name}{side}\"\nmaterial = \"grey\"\npolygon = [{polygon}]")
            .expect("text");
    }
}

/// Returns a closed room with boxes that do not touch each other.
fn room(random: &mut SplitMix, placed: Placed) -> String {
    let mut unit = || {
        let v = Vector::new(
            random.between([-1.0, 1.0]),
            random.between([-1.0, 1.0]),
            random.between([-1.0, 1.0]),
        );
        v.unit().expect("not zero")
    };
    let x = unit();
    let z = x.cross(unit()).unit().expect("two directions");
    let y = z.cross(x);
    let turn = |v: Vector| match placed {
        Placed::Turned => v.x * x + v.y * y + v.z * z,
        Placed::OnAGrid | Placed::OnTheFloor => v,
    };
    let mut eighths = |low: f64, high: f64| (8.0 * random.between([low, high])).round() / 8.0;
    let half = [eighths(0.5, 2.0), eighths(0.5, 2.0), eighths(0.5, 2.0)];
    let least = half.iter().copied().fold(f64::INFINITY, f64::min);
    let mut text =
        "[solve]\ntolerance = 1e-3\n[[material]]\nname = \"grey\"\nkind = \"diffuse\"\nreflectance = 0.5\n"
            .to_owned();
    add_box(&mut text, "room", [half.map(|x| -x), half], true, turn);
    for (body, quadrant) in [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5]].into_iter().enumerate() {
        let size = [(); 3].map(|()| 0.25 * least * f64::from(1 + random.below(4) as u32) / 4.0);
        let lift = match placed {
            Placed::OnTheFloor => size[2] - half[2],
            Placed::Turned | Placed::OnAGrid => 0.0,
        };
        let center = [quadrant[0] * half[0], quadrant[1] * half[1], lift];
        let ends = [-1.0, 1.0].map(|sign| std::array::from_fn(|axis| center[axis] + sign * size[axis]));
        add_box(&mut text, &format!("body{body}"), ends, false, turn);
    }
    text
}

#[test]
fn view_factors_of_rooms_with_bodies_are_within_what_is_said_and_no_room_is_refused() {
    let mut random = SplitMix(41);
    let (mut count, mut beyond) = (0, 0);
    for index in 0..18 {
        let placed = [Placed::Turned, Placed::OnAGrid, Placed::OnTheFloor][index % 3];
        let text = room(&mut random, placed);
        let read = |text: &str| -> Scene {
            read(text, "room.toml").unwrap_or_else(|errors| panic!("{placed:?} {index}: {}", errors[0]))
        };
        let scene = read(&text);
        let [found, finer] = [&text, &text.replace("1e-3", "1e-4")].map(|text| view_factors(&read(text)));
        assert!(found.contradictions(&scene).is_empty(), "{placed:?} {index}");
        for (found, finer) in found.rows.iter().flatten().zip(finer.rows.iter().flatten()) {
            let off = (found.value - finer.value).abs();
            assert!(
                off <= 0.01 * finer.value.max(0.01),
                "{placed:?} {index}: {} and {}",
                found.value,
                finer.value
            );
            count += 1;
            beyond += usize::from(off > 3.0 * (found.error + finer.error) + 1e-14);
        }
    }
    assert!(beyond * 2000 < count, "{beyond} of {count}");
}
