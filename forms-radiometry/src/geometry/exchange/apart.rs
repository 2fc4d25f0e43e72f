//! Exchange by outlines whose edges are apart: pairs of edges become integrals by one Gauss rule, whose number of points follows from
//! the least distance of two edges before any value is taken.
//!
//! ```text
//! A₁F₁₂ = 1/(2π) Σᵢⱼ eᵢ·fⱼ ∫ (∫ ln r dt) ds,      |remainder of n points| ≤ 4 ρ⁻²ⁿ times both lengths
//! ```
//! For a point q of the inner edge, ln r as a function of the place s along the outer edge has its branch points at the foot of q
//! plus or minus i times the distance of q. In the unit of half the outer edge they lie on the ellipse about its ends a and b with
//! ρ + 1/ρ = (|q − a| + |q − b|)/half, which is at least 2 |q − middle|/half. The remainder of the rule for a logarithm is the integral
//! of its kernel 2π ρ⁻²ⁿ⁻¹ (1 + o(1)) along the cut from there, below π/n ρ⁻²ⁿ.
//!
//! Source: P. Davis, P. Rabinowitz, Methods of Numerical Integration (1984), 4.6.

use super::areas::{MOST_POINTS, gauss, roughly};
use super::contour::{Edge, ROUNDINGS, dot, subtracted};
use super::{Exchange, Outline};
use crate::geometry::Vector;
use crate::kernels::edge_potential;
use std::f64::consts::PI;

/// The factor of ρ⁻²ⁿ: more than π/n for the fewest points.
const REMAINDER: f64 = 4.0;

/// Fewer points are not taken.
const LEAST_POINTS: usize = 2;

/// Rows that a batch takes at once: columns of a multiple of them are read where they stand, and not copied.
const BLOCK: usize = 256;

/// The part of the tolerance that the rules may take.
const RULES: f64 = 0.25;

/// A pair of edges, and the cosine between them.
struct Pair<'e> {
    outer: &'e Edge<f64>,
    inner: &'e Edge<f64>,
    cosine: f64,
}

/// The exchange area of two outlines that lie in front of each other, to about a relative tolerance, with its error; nothing where edges
/// are so close that it takes too many points.
pub(super) fn exchange(
    here: &Outline,
    there: &Outline,
    normals: [Vector; 2],
    tolerance: f64,
) -> Option<Exchange> {
    let (edges, others) = (Edge::<f64>::of(here), Edge::<f64>::of(there));
    let mut pairs = Vec::with_capacity(edges.len() * others.len());
    let (mut least, mut weight) = (f64::INFINITY, 0.0);
    for a in &edges {
        for b in &others {
            let cosine = dot(a.direction, b.direction);
            if cosine != 0.0 {
                let (outer, inner) = if a.length <= b.length { (a, b) } else { (b, a) };
                let half = 0.5 * outer.length;
                least = least.min(2.0 * distance(outer.at(half), inner) / half);
                weight += cosine.abs() * outer.length * inner.length;
                pairs.push(Pair { outer, inner, cosine });
            }
        }
    }
    if pairs.is_empty() {
        return Some(Exchange::default());
    }
    // not above 1 where edges are closer than half of one
    let rho = 0.5 * (least + (least * least - 4.0).max(0.0).sqrt());
    let most = REMAINDER * weight;
    let remainder = RULES * 2.0 * PI * tolerance * roughly(here, there, normals);
    let points = (0.5 * (most / remainder).ln() / rho.ln()).ceil().max(LEAST_POINTS as f64);
    (rho > 1.0 && points <= MOST_POINTS as f64).then(|| {
        let points = points as usize;
        integrated(&pairs, points, most * rho.powi(-2 * points as i32))
    })
}

/// The sum over pairs of edges by the rule of so many points, which leaves this of it.
fn integrated(pairs: &[Pair], points: usize, remainder: f64) -> Exchange {
    let rule = gauss(points);
    let used = pairs.len() * points;
    let rows = used.next_multiple_of(BLOCK);
    let mut numbers = vec![0.0; 8 * rows];
    let (arguments, values) = numbers.split_at_mut(7 * rows);
    let mut columns = arguments.chunks_exact_mut(rows);
    let [x, y, z, u, v, w, length] =
        std::array::from_fn(|_| columns.next().expect("there are seven columns"));
    for (number, Pair { outer, inner, .. }) in pairs.iter().enumerate() {
        let own = number * points..(number + 1) * points;
        let [a, b, c] = subtracted(inner.start, outer.start);
        let [e, f, g] = outer.direction.map(|along| outer.length * along);
        let of_places = x[own.clone()].iter_mut().zip(&mut y[own.clone()]).zip(&mut z[own.clone()]);
        for (((x, y), z), [at, _]) in of_places.zip(rule) {
            (*x, *y, *z) = (a - at * e, b - at * f, c - at * g);
        }
        let [along_x, along_y, along_z] = inner.direction;
        u[own.clone()].fill(along_x);
        v[own.clone()].fill(along_y);
        w[own.clone()].fill(along_z);
        length[own].fill(inner.length);
    }
    // rows that nothing is read from: an edge of length 1 a little beside the point
    [&mut *x, &mut *w, &mut *length].into_iter().for_each(|column| column[used..].fill(1.0));
    edge_potential::batch_unguarded(x, y, z, u, v, w, length, values).expect("columns have one length");
    let (mut sum, mut magnitude) = (0.0, 0.0);
    for (Pair { outer, cosine, .. }, values) in pairs.iter().zip(values.chunks_exact(points)) {
        let (mut integral, mut size) = (0.0, 0.0);
        for (value, [_, weight]) in values.iter().zip(rule) {
            integral += weight * value;
            size += weight * value.abs();
        }
        sum += cosine * outer.length * integral;
        magnitude += cosine.abs() * outer.length * size;
    }
    let scale = 1.0 / (2.0 * PI);
    Exchange { area: scale * sum, error: scale * (remainder + ROUNDINGS * f64::EPSILON * magnitude) }
}

/// The distance of a point from an edge.
fn distance(point: [f64; 3], edge: &Edge<f64>) -> f64 {
    let place = dot(subtracted(point, edge.start), edge.direction).clamp(0.0, edge.length);
    let way = subtracted(point, edge.at(place));
    dot(way, way).sqrt()
}
