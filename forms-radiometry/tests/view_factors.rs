//! View factors of the reference, and their reported errors.

use forms_radiometry::form_factor::{view_factor, visible_exchange};
use forms_radiometry::geometry::{Polygon, Vector};
use serde_json::Value;

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
