//! Exchange area of separated contours: pairs of edges become integrals by Gauss rules. The number
//! of points of each rule follows from the distance of the edges, before any value is computed.
//!
//! ```text
//! A₁F₁₂ = 1/(2π) Σᵢⱼ eᵢ·fⱼ ∫ (∫ ln r dt) ds
//! |remainder of n points| ≤ 4/n ρ⁻²ⁿ times both lengths
//! ```
//! For a point q of the inner edge, ln r as a function of the position s along the outer edge has
//! its branch points at the foot of q plus or minus i times the distance of q. In units of half the
//! outer edge they lie on the ellipse with the foci a and b, the ends of that edge, with ρ + 1/ρ =
//! (|q − a| + |q − b|)/half, which is at least 2 |q − middle|/half. The remainder of the rule for a
//! logarithm is the integral of its kernel 2π ρ⁻²ⁿ⁻¹ (1 + o(1)) along the cut from there, below π/n
//! ρ⁻²ⁿ.
//!
//! Source: P. Davis, P. Rabinowitz, Methods of Numerical Integration (1984), 4.6.

use super::areas::{MOST_POINTS, gauss, roughly};
use super::contour::{Edge, ROUNDINGS, dot, subtracted};
use super::{Exchange, Outline};
use crate::geometry::Vector;
use forms_kernels::edge_potential;
use std::f64::consts::PI;

/// Factor of ρ⁻²ⁿ/n: larger than π, to cover rules with few points.
const REMAINDER: f64 = 4.0;

/// The least number of points of a rule.
const LEAST_POINTS: usize = 2;

/// Fraction of the tolerance that is allotted to the quadrature rules.
const RULES: f64 = 0.25;

/// A pair of edges.
struct Pair<'e> {
    outer: &'e Edge<f64>,
    inner: &'e Edge<f64>,
    /// The length of the outer edge, times the cosine of the angle between the edges.
    weight: f64,
    /// The number of points along the outer edge.
    points: usize,
}

/// Computes the exchange area of two outlines that lie in front of each other, to approximately a
/// relative tolerance, with its error. Returns `None` where edges are so close that a rule needs
/// too many points.
pub(super) fn exchange(
    here: &Outline,
    there: &Outline,
    normals: [Vector; 2],
    tolerance: f64,
) -> Option<Exchange> {
    let (edges, others) = (Edge::<f64>::of(here), Edge::<f64>::of(there));
    let count = edges.len() * others.len();
    let share = RULES * 2.0 * PI * tolerance * roughly(here, there, normals) / count as f64;
    let (mut pairs, mut remainder) = (Vec::with_capacity(count), 0.0);
    for a in &edges {
        for b in &others {
            let cosine = dot(a.direction, b.direction);
            if cosine != 0.0 {
                let (outer, inner) = if a.length <= b.length { (a, b) } else { (b, a) };
                let (points, left) = points(outer, inner, cosine.abs(), share)?;
                pairs.push(Pair { outer, inner, weight: cosine * outer.length, points });
                remainder += left;
            }
        }
    }
    Some(integrated(&pairs, remainder))
}

/// Returns the least number of points for which the remainder of the integral over a pair of edges
/// with this cosine is within `share`, and that remainder.
fn points(outer: &Edge<f64>, inner: &Edge<f64>, cosine: f64, share: f64) -> Option<(usize, f64)> {
    let half = 0.5 * outer.length;
    // half of ρ + 1/ρ; at most 1 where the distance of the edges is within half an edge
    let least = distance(outer.at(half), inner) / half;
    if least <= 1.0 {
        return None;
    }
    let rho = least + (least * least - 1.0).sqrt();
    let factor = 1.0 / (rho * rho);
    let mut power = REMAINDER * cosine * outer.length * inner.length;
    (1..=MOST_POINTS).find_map(|points| {
        power *= factor;
        let left = power / points as f64;
        (left <= share && points >= LEAST_POINTS).then_some((points, left))
    })
}

/// Sums the integrals over pairs of edges; `remainder` is the error of their rules.
fn integrated(pairs: &[Pair], remainder: f64) -> Exchange {
    if pairs.is_empty() {
        return Exchange::default();
    }
    let rows = pairs.iter().map(|pair| pair.points).sum();
    let mut numbers = vec![0.0; 8 * rows];
    let mut columns = numbers.chunks_exact_mut(rows);
    let [x, y, z, u, v, w, length, values] =
        std::array::from_fn(|_| columns.next().expect("there are seven arguments and their value"));
    let mut row = 0;
    for Pair { outer, inner, points, .. } in pairs {
        let [a, b, c] = subtracted(inner.start, outer.start);
        let [e, f, g] = outer.direction.map(|along| outer.length * along);
        // one loop that writes all columns is faster than seven short loops
        for [at, _] in gauss(*points) {
            (x[row], y[row], z[row]) = (a - at * e, b - at * f, c - at * g);
            [u[row], v[row], w[row]] = inner.direction;
            length[row] = inner.length;
            row += 1;
        }
    }
    edge_potential::batch_unguarded(x, y, z, u, v, w, length, values).expect("columns have one length");
    let (mut sum, mut magnitude, mut values) = (0.0, 0.0, &*values);
    for Pair { weight, points, .. } in pairs {
        let (own, rest) = values.split_at(*points);
        let (mut integral, mut size) = (0.0, 0.0);
        for (value, [_, weight]) in own.iter().zip(gauss(*points)) {
            integral += weight * value;
            size += weight * value.abs();
        }
        sum += weight * integral;
        magnitude += weight.abs() * size;
        values = rest;
    }
    let scale = 1.0 / (2.0 * PI);
    Exchange { area: scale * sum, error: scale * (remainder + ROUNDINGS * f64::EPSILON * magnitude) }
}

/// Returns the distance of a point from an edge.
fn distance(point: [f64; 3], edge: &Edge<f64>) -> f64 {
    let place = dot(subtracted(point, edge.start), edge.direction).clamp(0.0, edge.length);
    let way = subtracted(point, edge.at(place));
    dot(way, way).sqrt()
}
