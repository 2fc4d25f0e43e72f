//! Exchange area of flat shapes with round borders, by double contour integration.
//!
//! ```text
//! A₁F₁₂ = 1/(2π) ∮∮ ln r dx·dy                                       (Stokes, twice)
//! circle and outline   x = c + R (cos φ u + sin φ v): Σⱼ ∮ (dx·fⱼ) ∫ ln r dt, the inner integral exact
//! circle and circle    both integrals by the rule
//! ```
//! The integrand is smooth and periodic in φ, so that the trapezoidal rule converges faster than any
//! power of the number of points, unless the borders touch. The number is doubled until two results
//! agree; their difference is the error.

use super::contour::{Edge, ROUNDINGS, dot, subtracted};
use super::{Exchange, Outline, in_front};
use crate::geometry::scale::power_of_two;
use crate::geometry::{Disk, Vector, across};
use forms_kernels::edge_potential;
use std::f64::consts::PI;

/// Smallest and largest number of points on a circle.
const FEWEST: usize = 32;
const MOST: usize = 4096;
/// Largest number of points on each of two circles.
const MOST_OF_TWO: usize = 512;
/// Relative difference of two results at which the number of points is enough.
const AGREE: f64 = 1e-13;
/// A disk counts as touching a plane if it reaches no farther beyond it than this part of its radius.
const TOUCHES: f64 = 1e-12;

/// A sum of terms, and the sum of their absolute values.
#[derive(Clone, Copy, Default)]
struct Sum {
    value: f64,
    magnitude: f64,
}

impl Sum {
    fn add(&mut self, term: f64) {
        self.value += term;
        self.magnitude += term.abs();
    }
}

/// Returns the exchange area of the fronts of a disk and a convex outline without occluders. `None`
/// where the plane of the outline cuts the disk, or the rule does not reach the tolerance.
pub(crate) fn exchange_with_disk(
    disk: &Disk,
    (outline, normal): (&Outline, Vector),
    tolerance: f64,
) -> Option<Exchange> {
    if !is_in_front(disk, outline[0], normal)? {
        return Some(Exchange::default());
    }
    let outline: Vec<Vector> = outline.iter().map(|&v| v - disk.center).collect();
    let Some((outline, of_cut)) = in_front(outline, Vector::default(), disk.normal) else {
        return Some(Exchange::default());
    };
    let reach = outline.iter().map(|v| v.length()).fold(disk.radius, f64::max);
    // a power of two, so that scaling rounds nothing
    let unit = power_of_two(reach);
    let scaled: Vec<Vector> = outline.iter().map(|&v| unit.recip() * v).collect();
    let edges = Edge::<f64>::of(&scaled);
    let circle = Circle { center: Vector::default(), radius: disk.radius / unit, axes: across(disk.normal) };
    let found = by_doubling(MOST, tolerance, |count| circle.with_edges(&edges, count))?;
    let Exchange { area, error } = found;
    Some(Exchange { area: unit * unit * area, error: unit * unit * (error + of_cut * area.abs()) })
}

/// Returns the exchange area of the fronts of two disks without occluders. `None` where the plane of
/// one cuts the other, or the rule does not reach the tolerance.
pub(crate) fn exchange_of_disks([one, other]: [&Disk; 2], tolerance: f64) -> Option<Exchange> {
    if !(is_in_front(one, other.center, other.normal)? && is_in_front(other, one.center, one.normal)?) {
        return Some(Exchange::default());
    }
    let way = other.center - one.center;
    let unit = power_of_two(way.length().max(one.radius).max(other.radius));
    let circle = |disk: &Disk, center: Vector| Circle {
        center: unit.recip() * center,
        radius: disk.radius / unit,
        axes: across(disk.normal),
    };
    let [one, other] = [circle(one, Vector::default()), circle(other, way)];
    let found = by_doubling(MOST_OF_TWO, tolerance, |count| one.with_circle(&other, count))?;
    Some(Exchange { area: unit * unit * found.area, error: unit * unit * found.error })
}

/// Whether a disk is in front of a plane; `None` where the plane cuts it.
fn is_in_front(disk: &Disk, point: Vector, normal: Vector) -> Option<bool> {
    let height = normal.dot(disk.center - point);
    let reach = disk.radius * normal.cross(disk.normal).length();
    let slack = TOUCHES * (disk.radius + (disk.center - point).length());
    match height {
        _ if height <= slack - reach => Some(false),
        _ if height >= reach - slack => Some(true),
        _ => None,
    }
}

/// Returns the exchange area by a rule with enough points.
fn by_doubling(most: usize, tolerance: f64, rule: impl Fn(usize) -> Sum) -> Option<Exchange> {
    let scale = 1.0 / (2.0 * PI);
    let (mut count, mut last) = (FEWEST, rule(FEWEST).value);
    loop {
        count *= 2;
        let Sum { value, magnitude } = rule(count);
        let rounding = ROUNDINGS * f64::EPSILON * magnitude;
        let error = (value - last).abs() + rounding;
        if error <= rounding + AGREE * value.abs() || (count == most && error <= tolerance * value.abs()) {
            return Some(Exchange { area: scale * value, error: scale * error });
        }
        if count >= most {
            return None;
        }
        last = value;
    }
}

/// A circle, counter-clockwise seen from where its two axes turn so.
struct Circle {
    center: Vector,
    radius: f64,
    axes: [Vector; 2],
}

impl Circle {
    /// Returns some points, evenly spread over the circle, and the path from each to the next along
    /// the tangent.
    fn points(&self, count: usize) -> impl Iterator<Item = [[f64; 3]; 2]> {
        let step = 2.0 * PI / count as f64;
        let [u, v] = self.axes;
        (0..count).map(move |place| {
            let (sine, cosine) = (step * place as f64).sin_cos();
            let point = self.center + self.radius * (cosine * u + sine * v);
            let path = (step * self.radius) * (cosine * v - sine * u);
            [point, path].map(Vector::coordinates)
        })
    }

    /// Returns ∮∮ ln r dx·dy with the edges of an outline.
    fn with_edges(&self, edges: &[Edge<f64>], count: usize) -> Sum {
        let mut sum = Sum::default();
        for [point, path] in self.points(count) {
            for edge in edges {
                let [x, y, z] = subtracted(edge.start, point);
                let [u, v, w] = edge.direction;
                sum.add(dot(path, edge.direction) * edge_potential(x, y, z, u, v, w, edge.length));
            }
        }
        sum
    }

    /// Returns ∮∮ ln r dx·dy with another circle.
    fn with_circle(&self, other: &Self, count: usize) -> Sum {
        let there: Vec<_> = other.points(count).collect();
        let mut sum = Sum::default();
        for [here, path] in self.points(count) {
            for &[point, other_path] in &there {
                let way = subtracted(point, here);
                sum.add(0.5 * dot(way, way).ln() * dot(path, other_path));
            }
        }
        sum
    }
}
