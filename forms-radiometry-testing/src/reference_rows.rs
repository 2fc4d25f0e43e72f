//! Rows of the reference as scenes: the statement of a row about a solid angle, a form factor, a
//! view factor, or a closed room becomes a scene with one receiver. The answer times a factor is
//! the value of the row.
//!
//! ```text
//! row of JSON ─ kernel or group, inputs ─▶ Posed ─▶ scene ─ tolerance ─▶ answer
//!                                                   answer and value are compared exactly
//! ```

mod shapes;

use forms_radiometry::scene::read;
use forms_radiometry::simulation::Quantity::{Irradiance, Radiance};
use forms_radiometry::simulation::{Answer, ErrorKind, Quantity, Unwatched, plan, simulate};
use forms_testing::exact;
use forms_testing::scene_text::{
    CUBE, Point, elements, material, polygon, surface, surface_receiver, tolerance,
};
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use serde_json::Value;
use shapes::{Light, facing, rectangle, upright};
use std::f64::consts::PI;

const VISIBLE: &str = include_str!("../../tests/reference/visible.json");
const OWN: &str = include_str!("../../tests/reference/own.json");

/// A row as a scene.
pub struct Row {
    /// Name of the row.
    pub id: String,
    value: BigRational,
    posed: Posed,
}

/// A scene, and the conversion of its answer to the value of a row.
struct Posed {
    text: String,
    quantity: Quantity,
    factor: f64,
}

/// Result for a row.
#[derive(Debug)]
pub struct Compared {
    /// The computed value.
    pub value: f64,
    /// Its distance from the value of the row.
    pub off: f64,
    /// The reported error.
    pub bound: f64,
}

/// Returns the rows of a file that describe a scene whose answer has a bound.
pub fn visible() -> Vec<Row> {
    rows(VISIBLE)
}

/// Returns the rows that follow from definitions and describe such a scene.
pub fn own() -> Vec<Row> {
    rows(OWN)
}

fn rows(file: &str) -> Vec<Row> {
    let file: Value = serde_json::from_str(file).expect("JSON");
    file["cases"].as_array().expect("a list of rows").iter().filter_map(Row::of).collect()
}

impl Row {
    fn of(row: &Value) -> Option<Self> {
        let text = |key: &str| row[key].as_str().unwrap_or_default().to_owned();
        let posed = posed(row)?;
        Some(Self { id: text("id"), value: exact(&text("value")).abs(), posed })
    }

    /// Simulates the row with a tolerance and returns the comparison, if the answer is not sampled.
    pub fn compared(&self, asked: f64) -> Option<Compared> {
        let Posed { text, quantity, factor } = &self.posed;
        let text = text.clone() + &tolerance(asked);
        let scene = match read(&text, &self.id) {
            // lengths are from 1e-152 to 1e152
            Err(errors) if errors[0].to_string().contains("out of range") => return None,
            read => read.unwrap_or_else(|errors| panic!("{}\n{text}", errors[0])),
        };
        let plan = plan(&scene).unwrap_or_else(|errors| panic!("{}: {}", self.id, errors[0]));
        let found = simulate(&plan, &Unwatched).answers;
        let is_meant = |answer: &&Answer| answer.quantity == *quantity && answer.kind != ErrorKind::Sigma;
        let answer = found.iter().find(is_meant)?;
        let value = factor * answer.value;
        let off = (BigRational::from_float(value).expect("a number") - &self.value).abs();
        Some(Compared { value, off: off.to_f64().expect("a number"), bound: factor * answer.error })
    }

    /// Whether the scene contains spheres, whose tessellations have many faces.
    pub fn has_spheres(&self) -> bool {
        self.posed.text.contains("sphere = {")
    }

    /// Returns the value of the row.
    pub fn value(&self) -> f64 {
        self.value.to_f64().expect("a number")
    }
}

/// Inputs of a row by their names.
struct Inputs<'r>(&'r Value);

impl Inputs<'_> {
    fn number(&self, name: &str) -> f64 {
        let value = &self.0[name];
        let number = value.as_f64().or_else(|| value.as_str().and_then(|text| text.parse().ok()));
        number.unwrap_or_else(|| panic!("{name} of {}", self.0))
    }

    fn numbers<const N: usize>(&self, names: [&str; N]) -> [f64; N] {
        names.map(|name| self.number(name))
    }

    /// Returns the point or direction whose coordinates are named by a letter and `x`, `y`, `z`.
    fn point(&self, letter: &str) -> Point {
        ["x", "y", "z"].map(|axis| self.number(&format!("{letter}{axis}")))
    }

    fn points(&self, name: &str) -> Vec<Point> {
        let points = self.0[name].as_array().expect("points").iter();
        points.map(|point| [0, 1, 2].map(|axis| point[axis].as_f64().expect("a number"))).collect()
    }
}

/// Returns the scene of a row, where there is one.
fn posed(row: &Value) -> Option<Posed> {
    match row["kernel"].as_str() {
        Some(kernel) => of_kernel(kernel, &Inputs(&row["args"])),
        None => of_group(row["group"].as_str()?, &Inputs(&row["inputs"])),
    }
}

fn of_kernel(kernel: &str, inputs: &Inputs) -> Option<Posed> {
    let axis = [0.0, 0.0, 1.0];
    match kernel {
        "solid_angle_triangle" => {
            seen_from(inputs, ["a", "b", "c"].map(|letter| inputs.point(letter)).to_vec())
        }
        "solid_angle_rectangle" => seen_from(inputs, corners(inputs)?),
        "form_factor_point_triangle" => {
            received(inputs, ["a", "b", "c"].map(|letter| inputs.point(letter)).to_vec())
        }
        "form_factor_point_rectangle" => received(inputs, corners(inputs)?),
        "solid_angle_disk" => {
            let [r, d] = inputs.numbers(["r", "d"]);
            apart(d / r)?;
            Some(Light::Disk([0.0, 0.0, d], r).seen([0.0; 3]))
        }
        "solid_angle_sphere" => {
            let [r, d] = inputs.numbers(["R", "d"]);
            apart(d / r - 1.0)?;
            Some(Light::Sphere([0.0, 0.0, d], r).seen([0.0; 3]))
        }
        "form_factor_point_disk" => {
            let [r, h, a] = inputs.numbers(["r", "h", "a"]);
            apart(h / r.max(a))?;
            Some(Light::Disk([a, 0.0, h], r).received([0.0; 3], axis))
        }
        "form_factor_point_sphere" => {
            let [d, r, cosine] = inputs.numbers(["d", "R", "cos_theta"]);
            let normal = [((1.0 - cosine) * (1.0 + cosine)).sqrt(), 0.0, cosine];
            Some(Light::Sphere([0.0, 0.0, d], r).received([0.0; 3], normal))
        }
        _ => between(kernel, inputs),
    }
}

/// Returns a distance, if a scene with lengths near 1 can distinguish it from zero.
fn apart(distance: f64) -> Option<f64> {
    (distance > 1e-14).then_some(distance)
}

/// Returns the scene of the view factor of two surfaces: the mean irradiance of the first from an
/// exitance of 1 of the second.
fn between(kernel: &str, inputs: &Inputs) -> Option<Posed> {
    let rectangle_of = |sides| Light::Polygon(rectangle(sides, 0.0, true));
    let posed = match kernel {
        "view_factor_parallel_rectangles" => {
            let [a, b, c] = inputs.numbers(["a", "b", "c"]);
            Light::Polygon(rectangle([a, b], c, false)).onto(&rectangle_of([a, b]), 1.0)
        }
        "view_factor_perpendicular_rectangles" => {
            let [h, w, l] = inputs.numbers(["h", "w", "l"]);
            Light::Polygon(upright(l, h)).onto(&rectangle_of([w, l]), 1.0)
        }
        "view_factor_coaxial_disks" => {
            let [r1, r2, a] = inputs.numbers(["r1", "r2", "a"]);
            apart(a / r1.max(r2))?;
            Light::Disk([0.0, 0.0, a], r2).onto(&Light::DiskUp([0.0; 3], r1), 1.0)
        }
        "view_factor_sphere_disk" => {
            let [r, h] = inputs.numbers(["r2", "h"]);
            let radius = 0.5 * h;
            let areas = (r / radius).powi(2) / 4.0;
            Light::Sphere([0.0, 0.0, h], radius).onto(&Light::DiskUp([0.0; 3], r), areas)
        }
        "view_factor_sphere_rectangle" => {
            let [d, a, b] = inputs.numbers(["d", "l1", "l2"]);
            let radius = 0.5 * d;
            let areas = a * b / (4.0 * PI * radius * radius);
            Light::Sphere([0.0, 0.0, d], radius).onto(&rectangle_of([a, b]), areas)
        }
        "view_factor_spheres" => {
            let [r1, r2, d] = inputs.numbers(["r1", "r2", "D"]);
            Light::Sphere([0.0, 0.0, d], r2).onto(&Light::Sphere([0.0; 3], r1), 1.0)
        }
        "transmittance" => {
            let [sigma, t] = inputs.numbers(["sigma", "t"]);
            absorbed(sigma, apart(t)?)
        }
        _ => return None,
    };
    Some(posed)
}

/// Returns the scene of radiance 1 behind a medium of this thickness that only absorbs.
fn absorbed(sigma: f64, t: f64) -> Posed {
    let far = [[t, -1.0, -1.0], [t, -1.0, 1.0], [t, 1.0, 1.0], [t, 1.0, -1.0]];
    let text = elements::medium("gas", [&sigma, &0, &0, &1])
        + &elements::filled_with("gas")
        + &material("black", 0)
        + &surface("lamp", "black", &elements::shining(&polygon(&far), 1))
        + &elements::ray("ray", [0.0; 3], [1.0, 0.0, 0.0]);
    Posed { text, quantity: Radiance, factor: 1.0 }
}

/// Returns the corners of a rectangle given by a corner and two sides, if the other corners are not
/// rounded.
fn corners(inputs: &Inputs) -> Option<Vec<Point>> {
    let [corner, u, v] = ["o", "u", "v"].map(|letter| inputs.point(letter));
    let beside = shapes::sum(corner, u)?;
    Some(vec![corner, beside, shapes::sum(beside, v)?, shapes::sum(corner, v)?])
}

fn seen_from(inputs: &Inputs, corners: Vec<Point>) -> Option<Posed> {
    let from = inputs.point("p");
    Some(Light::Polygon(facing(corners, from)?).seen(from))
}

fn received(inputs: &Inputs, corners: Vec<Point>) -> Option<Posed> {
    let at = inputs.point("p");
    Some(Light::Polygon(facing(corners, at)?).received(at, inputs.point("n")))
}

fn of_group(group: &str, inputs: &Inputs) -> Option<Posed> {
    match group {
        "point_to_polygon" => {
            let [at, normal] = ["p", "n"].map(|name| inputs.points_of(name));
            Some(Light::Polygon(facing(inputs.points("v"), at)?).received(at, normal))
        }
        "view_factor_polygons" => {
            let [a, b] = ["A", "B"].map(|name| inputs.points(name));
            let [to_a, to_b] = [&a, &b].map(|corners| shapes::middle(corners));
            let (from, to) = (facing(b, to_a)?, facing(a, to_b)?);
            Some(Light::Polygon(from).onto(&Light::Polygon(to), 1.0))
        }
        "closure" => Some(closed_box(inputs.numbers(["a", "b", "c"]))),
        "furnace" if inputs.0.get("Le").is_some() => {
            let [emitted, rho] = inputs.numbers(["Le", "rho"]);
            let shell = format!("{}\nradiance = {emitted:?}", elements::sphere([0.0; 3], 1.0, true));
            let text = material("white", format!("{rho:?}"))
                + &surface("shell", "white", &shell)
                + &elements::ray("ray", [0.1, 0.2, 0.3], [3.0, 2.0, 1.0]);
            Some(Posed { text, quantity: Radiance, factor: 1.0 })
        }
        "continuous_radiosity" if inputs.0.get("c").is_some() => {
            let [rho, c] = inputs.numbers(["rho", "c"]);
            let square = |height, is_up| polygon(&rectangle([1.0, 1.0], height, is_up));
            let text = material("grey", format!("{rho:?}"))
                + &surface("a", "grey", &square(0.0, true))
                + &surface("b", "grey", &format!("{}\nexitance = 1", square(c, false)))
                + &surface_receiver("a");
            Some(Posed { text, quantity: Irradiance, factor: rho })
        }
        "occlusion" => {
            let screen =
                surface("screen", "black", &elements::two_sided(&polygon(&rectangle([0.5, 0.5], 0.5, true))));
            let mut posed = Light::Polygon(rectangle([1.0, 1.0], 1.0, false))
                .onto(&Light::Polygon(rectangle([1.0, 1.0], 0.0, true)), 1.0);
            posed.text += &screen;
            Some(posed)
        }
        _ => None,
    }
}

impl Inputs<'_> {
    fn points_of(&self, name: &str) -> Point {
        [0, 1, 2].map(|axis| self.0[name][axis].as_f64().expect("a number"))
    }
}

/// Returns the scene of the floor of a closed box whose other faces have an exitance of 1.
fn closed_box(sides: [f64; 3]) -> Posed {
    let face = |(name, corners): &(&str, [Point; 4])| {
        let corners = corners.map(|corner| [0, 1, 2].map(|axis| sides[axis] * corner[axis]));
        let exitance = if *name == "floor" { 0 } else { 1 };
        surface(name, "black", &format!("{}\nexitance = {exitance}", polygon(&corners)))
    };
    let text = material("black", 0) + &CUBE.iter().map(face).collect::<String>() + &surface_receiver("floor");
    Posed { text, quantity: Irradiance, factor: 1.0 }
}
