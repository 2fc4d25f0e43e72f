//! Exchange area by quadrature over both areas: polygons are split into quadrilateral patches, and
//! the exchange density is evaluated at Gauss points of both.
//!
//! ```text
//! A₁F₁₂ = ∫∫ cos cos'/(π r²) dA dA'
//! ```
//! Nothing cancels, and few points are enough for polygons that are far apart: the integrand is
//! analytic up to its nearest pole, and with every additional point the error of the rule decreases
//! by the square of the distance in units of the size.

use super::{Exchange, Outline};
use crate::geometry::Vector;
use forms_kernels::exchange_density;
use std::sync::OnceLock;

/// The Gauss rules in the order in which they are tried, by their points along each side. The
/// difference of two successive rules, an estimate of the error of the coarser one, is reported as
/// the error of the finer one.
const ORDERS: [usize; 4] = [2, 3, 5, 8];

/// Patches whose length exceeds this multiple of their width are halved only across their length.
const SLENDER: f64 = 1.5;

/// A node in [0, 1] and its weight.
pub(crate) type Node = [f64; 2];

/// The largest number of points of a Gauss–Legendre rule.
pub(super) const MOST_POINTS: usize = 16;

/// Returns the Gauss–Legendre rule on [0, 1] with this many points, computed by Newton's method on
/// the Legendre polynomial.
pub(crate) fn gauss(count: usize) -> &'static [Node] {
    static RULES: [OnceLock<Vec<Node>>; MOST_POINTS + 1] = [const { OnceLock::new() }; MOST_POINTS + 1];
    RULES[count].get_or_init(|| {
        let legendre = |x: f64| {
            let (mut low, mut high) = (1.0, x);
            for k in 2..=count {
                let k = k as f64;
                (low, high) = (high, ((2.0 * k - 1.0) * x * high - (k - 1.0) * low) / k);
            }
            (high, count as f64 * (x * high - low) / (x * x - 1.0))
        };
        let node = |place: usize| {
            let mut x = -(std::f64::consts::PI * (place as f64 + 0.75) / (count as f64 + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(x);
                x -= value / slope;
            }
            let (_, slope) = legendre(x);
            [0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)]
        };
        (0..count).map(node).collect()
    })
}

/// A patch with four corners, of which the last two can coincide: x(s, t) is bilinear, dA = |∂ₛx ×
/// ∂ₜx| ds dt.
#[derive(Clone, Copy)]
pub(crate) struct Patch([Vector; 4]);

/// Splits a convex outline into patches.
pub(crate) fn patches(outline: &Outline) -> impl Iterator<Item = Patch> {
    let mut next = 1;
    std::iter::from_fn(move || {
        if next + 1 >= outline.len() {
            return None;
        }
        let last = (next + 2).min(outline.len() - 1);
        let patch = Patch([outline[0], outline[next], outline[next + 1], outline[last]]);
        next = last;
        Some(patch)
    })
}

impl Patch {
    /// Returns the point at these parameters, and dA/(ds dt) there.
    pub(crate) fn at(&self, s: f64, t: f64) -> (Vector, f64) {
        let Patch([a, b, c, d]) = *self;
        let (along, across, twist) = (b - a, d - a, (a - b) + (c - d));
        let by_t = across + s * twist;
        (a + s * along + t * by_t, (along + t * twist).cross(by_t).length())
    }

    /// Calls `each` with the points of a tensor-product rule, the same along both sides, and the
    /// area of each point.
    ///
    /// ∂ₛx × ∂ₜx = u × v + s u × w + t w × v with the sides u, v from the first corner and the
    /// twist w; in a plane all three are parallel.
    pub(crate) fn by_rule(&self, rule: &[Node], mut each: impl FnMut(Vector, f64)) {
        let Patch([a, b, c, d]) = *self;
        let (along, across, twist) = (b - a, d - a, (a - b) + (c - d));
        let densities = [along.cross(across), along.cross(twist), twist.cross(across)];
        let middle = densities[0] + 0.5 * (densities[1] + densities[2]);
        let normal = middle.unit().unwrap_or_default();
        let [whole, by_s, by_t] = densities.map(|density| normal.dot(density));
        for &[s, of_s] in rule {
            let (start, side) = (a + s * along, across + s * twist);
            for &[t, of_t] in rule {
                each(start + t * side, of_s * of_t * (whole + s * by_s + t * by_t));
            }
        }
    }

    /// Returns the corners in order around the patch.
    pub(super) fn corners(&self) -> &[Vector] {
        &self.0
    }

    /// Returns the distance of the farthest corner from a point.
    pub(crate) fn radius(&self, centre: Vector) -> f64 {
        self.0.iter().map(|&corner| (corner - centre).length()).fold(0.0, f64::max)
    }

    /// Returns the area: the density dA/(ds dt) is linear in each parameter.
    pub(super) fn area(&self) -> f64 {
        self.at(0.5, 0.5).1
    }

    /// Splits the patch in two along its longer direction; `None` unless its sides in one direction
    /// are much longer than those across.
    pub(crate) fn halves(&self) -> Option<[Patch; 2]> {
        let Patch([a, b, c, d]) = *self;
        let squared = |from: Vector, to: Vector| (to - from).dot(to - from);
        let along = squared(a, b).max(squared(d, c));
        let across = squared(a, d).max(squared(b, c));
        let middle = |from: Vector, to: Vector| from + 0.5 * (to - from);
        if along > SLENDER * SLENDER * across {
            let (low, high) = (middle(a, b), middle(d, c));
            Some([Patch([a, low, high, d]), Patch([low, b, c, high])])
        } else if across > SLENDER * SLENDER * along {
            let (low, high) = (middle(a, d), middle(b, c));
            Some([Patch([a, b, high, low]), Patch([low, high, c, d])])
        } else {
            None
        }
    }

    /// Splits the patch into four by halving each parameter.
    pub(crate) fn quarters(&self) -> [Patch; 4] {
        let corner = |s: f64, t: f64| self.at(s, t).0;
        [(0.0, 0.0), (0.5, 0.0), (0.0, 0.5), (0.5, 0.5)].map(|(s, t)| {
            Patch([(s, t), (s + 0.5, t), (s + 0.5, t + 0.5), (s, t + 0.5)].map(|(s, t)| corner(s, t)))
        })
    }
}

/// Estimates the exchange area by concentrating each outline at its centre.
pub(super) fn roughly(here: &Outline, there: &Outline, [n, m]: [Vector; 2]) -> f64 {
    let area = |outline: &Outline| patches(outline).map(|patch| patch.area()).sum::<f64>();
    let way = Vector::mean(there) - Vector::mean(here);
    let squared = way.dot(way);
    area(here) * area(there) * (n.dot(way) * m.dot(way)).abs() / (std::f64::consts::PI * squared * squared)
}

/// Returns quadrature points of a convex outline, each with its area.
fn points(outline: &Outline, count: usize) -> Vec<(Vector, f64)> {
    let mut points = Vec::new();
    for patch in patches(outline) {
        for &[s, of_s] in gauss(count) {
            for &[t, of_t] in gauss(count) {
                let (point, density) = patch.at(s, t);
                points.push((point, of_s * of_t * density));
            }
        }
    }
    points
}

/// Sums the exchange density over the points of both outlines.
fn sum(here: &Outline, there: &Outline, [n, m]: [Vector; 2], count: usize) -> f64 {
    let (here, there) = (points(here, count), points(there, count));
    let rows = here.len() * there.len();
    let mut ways: [Vec<f64>; 3] = std::array::from_fn(|_| Vec::with_capacity(rows));
    let mut weights = Vec::with_capacity(rows);
    for &(x, of_x) in &here {
        for &(y, of_y) in &there {
            let way = y - x;
            ways.iter_mut().zip([way.x, way.y, way.z]).for_each(|(column, value)| column.push(value));
            weights.push(of_x * of_y);
        }
    }
    let normals = [n.x, n.y, n.z, m.x, m.y, m.z].map(|value| vec![value; rows]);
    let [rx, ry, rz] = &ways;
    let [nx, ny, nz, mx, my, mz] = &normals;
    let mut densities = vec![0.0; rows];
    exchange_density::batch_unguarded(rx, ry, rz, nx, ny, nz, mx, my, mz, &mut densities)
        .expect("columns grow together");
    weights.iter().zip(densities).map(|(weight, density)| weight * density).sum()
}

/// Computes the exchange area of two convex outlines with these unit normals by the first rule
/// whose error is within a relative tolerance. If no rule is, returns the result of the last one
/// with its error.
pub(super) fn exchange(here: &Outline, there: &Outline, normals: [Vector; 2], tolerance: f64) -> Exchange {
    let mut before = sum(here, there, normals, ORDERS[0]);
    let mut found = Exchange { area: before, error: f64::INFINITY };
    for &order in &ORDERS[1..] {
        let area = sum(here, there, normals, order);
        let rounding = 64.0 * f64::EPSILON * area.abs();
        found = Exchange { area, error: (area - before).abs() + rounding };
        if found.error <= tolerance * area.abs() {
            break;
        }
        before = area;
    }
    found
}
