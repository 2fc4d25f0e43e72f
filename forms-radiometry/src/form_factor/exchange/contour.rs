//! Exchange area by double contour integration: sums integrals of the logarithm of the distance
//! over pairs of edges.
//!
//! ```text
//! A₁F₁₂ = 1/(2π) ∮∮ ln r dx·dy                      (Stokes, twice: kernels/exchange.forms)
//!       = 1/(2π) Σᵢⱼ eᵢ·fⱼ ∫ (∫ ln r dt) ds
//! ```
//! The inner integral is the kernel `edge_potential`, exact also where edges touch. The outer one
//! is taken over the shorter edge by a Gauss–Kronrod rule with adaptive bisection. Constants in ln
//! r cancel over closed contours, so any unit of length is valid; a unit near the distance of the
//! polygons keeps the logarithms small.

use super::kronrod::{self, Integral, POINTS};
use super::{Exchange, Outline};
use forms::math::{DoubleDouble, Real};
use forms_kernels::edge_potential;
use std::f64::consts::PI;

/// Rounding error of a sum of terms, in units of their magnitudes times the precision of the number
/// type.
pub(super) const ROUNDINGS: f64 = 8.0;

/// The largest number of bisection rounds: where the rule converges slowly at a point, the parts
/// shrink to within 2⁻⁶⁰ of it.
const MOST_ROUNDS: usize = 60;

/// The largest number of parts. If it is reached, the remaining error is reported.
const MOST_PARTS: usize = 4096;

/// Number type in which the integral is computed.
pub(super) trait Number: Real {
    /// The relative error of a function's value.
    const EPSILON: f64;
    /// Computes the potentials of edges, one for each row.
    fn potentials(rows: &Rows<Self>) -> Vec<Self>;
}

/// Arguments of the potential in columns. Each row has the start of an edge relative to a point,
/// the edge's direction and its length.
pub(super) struct Rows<T> {
    columns: [Vec<T>; 7],
}

impl<T: Real> Rows<T> {
    fn with_capacity(count: usize) -> Self {
        Rows { columns: std::array::from_fn(|_| Vec::with_capacity(count)) }
    }

    fn push(&mut self, start: [T; 3], edge: &Edge<T>) {
        let [x, y, z] = start;
        let [u, v, w] = edge.direction;
        for (column, value) in self.columns.iter_mut().zip([x, y, z, u, v, w, edge.length]) {
            column.push(value);
        }
    }
}

impl Number for f64 {
    const EPSILON: f64 = f64::EPSILON;

    fn potentials(Rows { columns: [x, y, z, u, v, w, length] }: &Rows<f64>) -> Vec<f64> {
        let mut values = vec![0.0; x.len()];
        edge_potential::batch_unguarded(x, y, z, u, v, w, length, &mut values)
            .expect("columns grow together");
        values
    }
}

impl Number for DoubleDouble {
    // a function loses a few of the bits of a double-double
    const EPSILON: f64 = 16.0 * f64::EPSILON * f64::EPSILON;

    fn potentials(Rows { columns: [x, y, z, u, v, w, length] }: &Rows<DoubleDouble>) -> Vec<DoubleDouble> {
        (0..x.len()).map(|i| edge_potential::dd(x[i], y[i], z[i], u[i], v[i], w[i], length[i])).collect()
    }
}

/// An edge of an outline.
pub(super) struct Edge<T> {
    pub(super) start: [T; 3],
    pub(super) direction: [T; 3],
    pub(super) length: T,
}

impl<T: Number> Edge<T> {
    /// Returns the edges of an outline, without those of zero length.
    pub(super) fn of(outline: &Outline) -> Vec<Self> {
        let points: Vec<[T; 3]> = outline.iter().map(|point| point.coordinates().map(T::from_f64)).collect();
        Self::between(&points)
    }

    /// Returns the edges from each corner to the next.
    pub(super) fn between(points: &[[T; 3]]) -> Vec<Self> {
        let edge = |place: usize| {
            let (start, end) = (points[place], points[(place + 1) % points.len()]);
            let way = subtracted(end, start);
            let length = dot(way, way).sqrt();
            let is_point = length.to_f64() == 0.0;
            (!is_point).then(|| Edge { start, direction: way.map(|x| x / length), length })
        };
        (0..points.len()).filter_map(edge).collect()
    }

    pub(super) fn at(&self, place: T) -> [T; 3] {
        std::array::from_fn(|axis| place.mul_add(self.direction[axis], self.start[axis]))
    }
}

pub(super) fn dot<T: Real>([a, b, c]: [T; 3], [u, v, w]: [T; 3]) -> T {
    a * u + b * v + c * w
}

pub(super) fn subtracted<T: Real>(a: [T; 3], b: [T; 3]) -> [T; 3] {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

/// A part of the outer edge of a pair.
struct Part<'e, T> {
    outer: &'e Edge<T>,
    inner: &'e Edge<T>,
    cosine: T,
    middle: T,
    half: T,
}

impl<T: Number> Part<'_, T> {
    fn halves(&self) -> [Self; 2] {
        let half = T::from_f64(0.5) * self.half;
        [self.middle - half, self.middle + half].map(|middle| Self { middle, half, ..*self })
    }

    fn points(&self, rows: &mut Rows<T>) {
        for place in kronrod::places(self.middle, self.half) {
            rows.push(subtracted(self.inner.start, self.outer.at(place)), self.inner);
        }
    }
}

/// Integrates each part.
fn integrated<T: Number>(parts: &[Part<'_, T>]) -> Vec<Integral<T>> {
    let mut rows = Rows::with_capacity(POINTS * parts.len());
    parts.iter().for_each(|part| part.points(&mut rows));
    let values = T::potentials(&rows);
    let integral = |(part, values): (&Part<'_, T>, &[T])| {
        let Integral { value, magnitude, error } = kronrod::integral(values, part.half);
        let weight = part.cosine.to_f64().abs();
        Integral { value: part.cosine * value, magnitude: weight * magnitude, error: weight * error }
    };
    parts.iter().zip(values.chunks_exact(POINTS)).map(integral).collect()
}

/// Computes the exchange area of two outlines that lie in front of each other, to a relative
/// tolerance or to the limit of rounding.
pub(super) fn exchange<T: Number>(here: &Outline, there: &Outline, tolerance: f64) -> Exchange {
    let (integral, error) = integral(&Edge::<T>::of(here), &Edge::<T>::of(there), tolerance);
    let scale = 1.0 / (2.0 * PI);
    let area = scale * integral.to_f64();
    // if the sum has more digits than an `f64`, the rounding of the result remains
    Exchange { area, error: scale * error + 0.5 * f64::EPSILON * area.abs() }
}

/// Computes the integral over all pairs of edges, which is 2π times the exchange area, and its
/// error.
pub(super) fn integral<T: Number>(here: &[Edge<T>], there: &[Edge<T>], tolerance: f64) -> (T, f64) {
    let mut parts: Vec<Part<'_, T>> = Vec::new();
    for a in here {
        for b in there {
            let (outer, inner) = if a.length.to_f64() <= b.length.to_f64() { (a, b) } else { (b, a) };
            let cosine = dot(outer.direction, inner.direction);
            if cosine.to_f64() != 0.0 {
                let half = T::from_f64(0.5) * outer.length;
                parts.push(Part { outer, inner, cosine, middle: half, half });
            }
        }
    }
    let mut integrals = integrated(&parts);
    for _ in 0..MOST_ROUNDS {
        let sum = Sum::of(&integrals);
        let accepted = (tolerance * sum.value.to_f64().abs()).max(sum.rounding);
        if sum.error <= accepted {
            break;
        }
        let share = 0.5 * accepted / integrals.len() as f64;
        let slow = |place: &usize| {
            let Integral { magnitude, error, .. } = integrals[*place];
            error > share.max(rounding::<T>(magnitude))
        };
        let slow: Vec<usize> = (0..parts.len()).filter(slow).collect();
        if slow.is_empty() || parts.len() + slow.len() > MOST_PARTS {
            break;
        }
        let halves: Vec<Part<'_, T>> = slow.iter().flat_map(|&place| parts[place].halves()).collect();
        let mut found = integrated(&halves).into_iter();
        for (place, halves) in slow.into_iter().zip(pairs(halves)) {
            let [first, second] = halves;
            parts[place] = first;
            parts.push(second);
            let next = "there are two integrals for each part";
            integrals[place] = found.next().expect(next);
            integrals.push(found.next().expect(next));
        }
    }
    let sum = Sum::of(&integrals);
    (sum.value, sum.error + sum.rounding)
}

/// Returns the rounding error of an integral whose absolute value integrates to `magnitude`.
fn rounding<T: Number>(magnitude: f64) -> f64 {
    ROUNDINGS * T::EPSILON * magnitude
}

/// Returns the elements of a list of even length in pairs.
fn pairs<P>(list: Vec<P>) -> impl Iterator<Item = [P; 2]> {
    let mut list = list.into_iter();
    std::iter::from_fn(move || Some([list.next()?, list.next()?]))
}

/// The sum over all parts.
struct Sum<T> {
    value: T,
    error: f64,
    rounding: f64,
}

impl<T: Number> Sum<T> {
    fn of(integrals: &[Integral<T>]) -> Self {
        let mut sum = Sum { value: T::from_f64(0.0), error: 0.0, rounding: 0.0 };
        for integral in integrals {
            sum.value = sum.value + integral.value;
            sum.error += integral.error;
            sum.rounding += rounding::<T>(integral.magnitude);
        }
        sum
    }
}
