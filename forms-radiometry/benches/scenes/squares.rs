//! View factors between unit squares: pairs in general position for the time, and hard cases with
//! known values.

use forms_radiometry::form_factor::view_factor;
use forms_radiometry::geometry::{Polygon, Vector};
use forms_testing::processor_clock::seconds;
use std::fmt::Write;
use std::io;
use std::path::Path;

/// Tolerance of the view factors that are timed.
const TOLERANCE: f64 = 1e-12;
/// Number of pairs in general position.
const GENERAL: usize = 64;

/// Pair of squares.
pub(crate) struct Pair {
    title: String,
    squares: [Polygon; 2],
    /// View factor, if it is known in closed form.
    known: Option<f64>,
}

/// Measurements of all pairs.
pub(crate) struct Measured {
    /// Processor time of one view factor in general position; no other thread takes part.
    pub(crate) seconds: f64,
    /// Title and largest relative error of each case.
    pub(crate) errors: Vec<(String, f64)>,
}

impl Pair {
    /// Whether it is in general position.
    pub(crate) fn is_general(&self) -> bool {
        self.known.is_none()
    }

    /// Returns the view factor from the first to the second.
    pub(crate) fn view_factor(&self) -> f64 {
        let [from, to] = &self.squares;
        view_factor(from, to, TOLERANCE).area
    }

    /// Returns the reference: the known value, or the view factor computed to the last digits.
    fn reference(&self) -> f64 {
        let [from, to] = &self.squares;
        self.known.unwrap_or_else(|| view_factor(from, to, 0.0).area)
    }
}

/// Returns numbers that fill [0, 1) evenly: the additive recurrence of the powers of the root of x⁸
/// = x + 1.
fn evenly(index: usize, axis: usize) -> f64 {
    const ROOT: f64 = 1.096_981_557_798_56;
    (0.5 + index as f64 * ROOT.powi(-1 - axis as i32)).fract()
}

/// Returns the unit square with this centre, whose front faces along a direction.
fn square(middle: Vector, normal: Vector, turn: f64) -> Polygon {
    let normal = normal.unit().expect("a normal has a length");
    let aside = if normal.x.abs() < 0.5 { Vector::new(1.0, 0.0, 0.0) } else { Vector::new(0.0, 1.0, 0.0) };
    let across = normal.cross(aside).unit().expect("the axis is not parallel");
    let up = normal.cross(across);
    let corner = |quarter: usize| {
        let (sine, cosine) = (turn + std::f64::consts::FRAC_PI_2 * quarter as f64).sin_cos();
        middle + 0.5_f64.sqrt() * (cosine * across + sine * up)
    };
    Polygon::new((0..4).map(corner).collect()).expect("a square is a polygon")
}

/// Returns squares at a distance of 2 to 3 that face each other, in all orientations.
fn general(index: usize) -> Pair {
    let n = |axis| evenly(index, axis);
    let height = 2.0 * n(0) - 1.0;
    let (sine, cosine) = (2.0 * std::f64::consts::PI * n(1)).sin_cos();
    let out = (1.0 - height * height).sqrt();
    let direction = Vector::new(out * cosine, out * sine, height);
    let tilt = |axis| Vector::new(n(axis) - 0.5, n(axis + 1) - 0.5, n(axis + 2) - 0.5);
    let from = square(Vector::new(0.0, 0.0, 0.0), direction + tilt(2), n(5));
    let to = square((2.0 + n(6)) * direction, -direction + tilt(3), n(4));
    Pair { title: "general position, distance 2 to 3".to_string(), squares: [from, to], known: None }
}

/// Returns directly opposed unit squares at this distance, moved along all axes by an offset.
fn opposed(distance: f64, offset: f64, known: f64) -> Pair {
    let at = |x: f64, y: f64, z: f64| Vector::new(x + offset, y + offset, z + offset);
    let below = vec![at(0.0, 0.0, 0.0), at(1.0, 0.0, 0.0), at(1.0, 1.0, 0.0), at(0.0, 1.0, 0.0)];
    let above =
        vec![at(0.0, 0.0, distance), at(0.0, 1.0, distance), at(1.0, 1.0, distance), at(1.0, 0.0, distance)];
    let moved = if offset == 0.0 { String::new() } else { format!(", {offset:.0e} from the origin") };
    let squares = [below, above].map(|outline| Polygon::new(outline).expect("a square is a polygon"));
    Pair { title: format!("opposed, distance {distance}{moved}"), squares, known: Some(known) }
}

/// Returns every pair. Known values are Howell C-11 in 40 digits.
pub(crate) fn all() -> Vec<Pair> {
    let mut pairs: Vec<Pair> = (0..GENERAL).map(general).collect();
    pairs.extend([
        opposed(0.25, 0.0, 0.632_036_430_013_860_3),
        opposed(1e4, 0.0, 3.183_098_840_617_247_8e-9),
        opposed(1e6, 0.0, 3.183_098_861_835_785e-13),
        opposed(1e-6, 0.0, 0.999_998_000_010_029_5),
        opposed(0.25, 1e8, 0.632_036_430_013_860_3),
    ]);
    pairs
}

/// Measures the time of one view factor and the errors of all pairs, and writes the pairs into a
/// directory for the scripts.
pub(crate) fn measured(pairs: &[Pair], folder: &Path) -> io::Result<Measured> {
    let mut lines = "title,general,reference,vertices of both\n".to_string();
    for pair in pairs {
        write!(lines, "\"{}\",{},{:e}", pair.title, u8::from(pair.is_general()), pair.reference())
            .expect("a String takes all text");
        for Vector { x, y, z } in pair.squares.iter().flat_map(Polygon::vertices) {
            write!(lines, ",{x:e},{y:e},{z:e}").expect("a String takes all text");
        }
        lines.push('\n');
    }
    std::fs::write(folder.join("squares.csv"), lines)?;
    let mut errors: Vec<(String, f64)> = Vec::new();
    for pair in pairs {
        let reference = pair.reference();
        let error = (pair.view_factor() - reference).abs() / reference;
        match errors.last_mut().filter(|(title, _)| *title == pair.title) {
            Some((_, largest)) => *largest = largest.max(error),
            None => errors.push((pair.title.clone(), error)),
        }
    }
    let general: Vec<&Pair> = pairs.iter().filter(|pair| pair.is_general()).collect();
    let all = seconds(&mut || {
        std::hint::black_box(general.iter().map(|pair| pair.view_factor()).sum::<f64>());
    });
    let seconds = all / general.len() as f64;
    println!("{:30} {:10.3} µs", "one view factor", 1e6 * seconds);
    Ok(Measured { seconds, errors })
}
