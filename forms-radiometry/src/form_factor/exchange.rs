//! Exchange area: computes A₁F₁₂ for two polygons, with an estimate of its error.
//!
//! ```text
//! polygons ─ convex pieces, each clipped by the plane of the other ─▶ outlines facing each other
//!     ├─ far apart ────────▶ areas: cos cos'/(π r²) at Gauss points of both
//!     ├─ edges separated ──▶ apart: contour integrals, with rules by the distances of the edges
//!     └─ otherwise ────────▶ contour: contour integrals in f64, double-double where they cancel
//! disks ───────────────────▶ circles: contour integrals by the trapezoidal rule
//! with occluders ──────────▶ obstructed: form factors of the visible part over the smaller polygon
//! ```
//! The choice follows from the error estimates that the methods themselves report.

mod apart;
mod areas;
mod changes;
mod circles;
mod contour;
mod doubt;
mod kronrod;
mod obstructed;

pub(crate) use areas::{Patch, gauss, patches};
pub(crate) use changes::Changes;
pub(crate) use circles::{exchange_of_disks, exchange_with_disk};
pub use obstructed::visible_exchange;
pub(crate) use obstructed::{FirstLook, exchange_with, first_look};

use super::double_double::{Rounded, heights, way};
use crate::geometry::clip::split;
use crate::geometry::scale::power_of_two;
use crate::geometry::{Polygon, Vector};
use crate::visibility::Face;
use contour::{Edge, integral};
use forms::math::{DoubleDouble, Real};
use std::ops::AddAssign;

/// The corners of a planar polygon in order.
type Outline = [Vector];

/// The least tolerance: rounding error of the best-conditioned sums.
const LEAST_TOLERANCE: f64 = 1e-15;

/// Relative tolerance of the quadrature for a result that is exact to the last digit.
const TO_LAST_DIGIT: f64 = 0.05 * f64::EPSILON;

/// Distance, in units of the polygons' sizes, beyond which quadrature over the areas is tried
/// first.
const FAR: f64 = 3.0;

/// Rounding error of a distance from a plane, in units of 2⁻⁵² times the distance from a point of
/// the plane.
const CUT: f64 = 16.0;

/// An exchange area A₁F₁₂ = A₂F₂₁, in the square of the unit of lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Exchange {
    /// The area.
    pub area: f64,
    /// An estimate of its error, in the same unit.
    pub error: f64,
}

/// Computes the exchange area of the fronts of two polygons without occluders, to a relative
/// tolerance.
///
/// ```text
/// A₁F₁₂ = ∫∫ cos cos'/(π r²) dA dA'
/// ```
///
/// over the parts that face each other. It is symmetric, and zero for polygons in one plane.
pub fn exchange(here: &Polygon, there: &Polygon, tolerance: f64) -> Exchange {
    let mut sum = Exchange::default();
    for piece in here.convex_pieces() {
        for other in there.convex_pieces() {
            let normals = [here.normal(), there.normal()];
            sum += between(piece, other, normals, [tolerance.max(LEAST_TOLERANCE); 2]);
        }
    }
    sum
}

impl AddAssign for Exchange {
    fn add_assign(&mut self, other: Self) {
        self.area += other.area;
        self.error += other.error;
    }
}

/// Computes the view factor F₁₂ from the front of a polygon to the front of another one without
/// occluders, and an estimate of its error: the fraction of the light leaving the first that
/// arrives at the second.
pub fn view_factor(from: &Polygon, to: &Polygon, tolerance: f64) -> Exchange {
    let Exchange { area, error } = exchange(from, to, tolerance);
    let whole = from.area();
    Exchange { area: area / whole, error: error / whole }
}

/// Computes the exchange area of two faces without occluders. `f64` is used as far as it reaches
/// the first relative tolerance; double-double is used if the error exceeds the second tolerance,
/// which is not smaller.
pub(crate) fn exchange_of(here: &Face, there: &Face, tolerances: [f64; 2]) -> Exchange {
    exchange_of_outlines([&here.vertices, &there.vertices], [here.normal, there.normal], tolerances)
}

/// Computes the exchange area of two convex outlines with these normals in the same way.
pub(crate) fn exchange_of_outlines(
    [here, there]: [&Outline; 2],
    normals: [Vector; 2],
    tolerances: [f64; 2],
) -> Exchange {
    between(here, there, normals, tolerances.map(|tolerance| tolerance.max(LEAST_TOLERANCE)))
}

/// Computes the exchange area of two faces without occluders to the last digit; `None` where the
/// plane of one face intersects the other.
pub(crate) fn exchange_precisely(here: &Face, there: &Face) -> Option<Rounded> {
    let (a, b) = (&here.vertices, &there.vertices);
    let [of_a, of_b] = [heights(a, b), heights(b, a)];
    if of_a.iter().chain(&of_b).any(|&height| height < 0.0) {
        return None;
    }
    if of_a.iter().all(|&height| height == 0.0) || of_b.iter().all(|&height| height == 0.0) {
        return Some(Rounded::exactly(0.0));
    }
    let reach = b.iter().chain(a).map(|&corner| (corner - a[0]).length()).fold(0.0, f64::max);
    // a power of two, so that scaling rounds nothing
    let unit = DoubleDouble::from_f64(power_of_two(reach));
    let edges = |outline: &Outline| {
        let corners: Vec<_> = outline.iter().map(|&corner| way(a[0], corner).map(|x| x / unit)).collect();
        Edge::between(&corners)
    };
    let (value, error) = integral::<DoubleDouble>(&edges(a), &edges(b), TO_LAST_DIGIT);
    let scaled = Rounded { value: unit * unit * value, error: (unit * unit).to_f64() * error };
    Some(scaled.times(0.5).over_pi())
}

/// Computes the exchange area of two convex outlines with these normals.
fn between(here: &Outline, there: &Outline, [n, m]: [Vector; 2], tolerances: [f64; 2]) -> Exchange {
    // differences first: outlines far from the origin lose no accuracy
    let origin = here[0];
    let [here, there] = [here, there].map(|outline| outline.iter().map(|&v| v - origin).collect::<Vec<_>>());
    let Some((here, of_here)) = in_front(here, there[0], m) else { return Exchange::default() };
    let Some((there, of_there)) = in_front(there, here[0], n) else { return Exchange::default() };
    let [(a, size_a), (b, size_b)] = [&here, &there].map(|outline| ball(outline));
    let (distance, size) = ((b - a).length(), size_a + size_b);
    // a power of two, so that scaling rounds nothing
    let unit = power_of_two(distance.max(size));
    let scaled = |outline: Vec<Vector>| outline.into_iter().map(|v| unit.recip() * v).collect::<Vec<_>>();
    let [here, there] = [here, there].map(scaled);
    let is_far = distance > FAR * size;
    let Exchange { area, error } = in_near_units(&here, &there, [n, m], is_far, tolerances);
    let error = error + (of_here + of_there) * area.abs();
    Exchange { area: unit * unit * area, error: unit * unit * error }
}

/// Returns the part of an outline in front of a plane, if there is any, and the relative error of
/// clipping it there. The clipped edge is displaced by the rounding of its distance from the plane,
/// which matters if the outline rises only slightly above the plane.
fn in_front(outline: Vec<Vector>, point: Vector, normal: Vector) -> Option<(Vec<Vector>, f64)> {
    let height = |x: &Vector| normal.dot(*x - point);
    if outline.iter().all(|x| height(x) >= 0.0) {
        return outline.iter().any(|x| height(x) > 0.0).then_some((outline, 0.0));
    }
    let (mut front, mut behind) = (Vec::new(), Vec::new());
    split(&outline, |x| height(&x), &mut front, &mut behind);
    let highest = front.iter().map(height).fold(0.0, f64::max);
    if behind.is_empty() || highest <= 0.0 {
        return (highest > 0.0).then_some((front, 0.0));
    }
    let extent = outline.iter().map(|&x| (x - point).length()).fold(0.0, f64::max);
    Some((front, CUT * f64::EPSILON * extent / highest))
}

/// Computes the exchange area of outlines that lie in front of each other, with lengths near 1.
fn in_near_units(
    here: &Outline,
    there: &Outline,
    normals: [Vector; 2],
    is_far: bool,
    [tolerance, most]: [f64; 2],
) -> Exchange {
    let is_within = |found: &Exchange, tolerance: f64| found.error <= tolerance * found.area.abs();
    let is_enough = |found: &Exchange| is_within(found, tolerance);
    let mut best = Exchange { area: f64::NAN, error: f64::INFINITY };
    if is_far {
        best = areas::exchange(here, there, normals, tolerance);
    }
    if !is_enough(&best)
        && let Some(found) = apart::exchange(here, there, normals, tolerance)
    {
        best = better(best, found);
    }
    if !is_enough(&best) {
        best = better(best, contour::exchange::<f64>(here, there, tolerance));
    }
    if !is_within(&best, most) {
        best = better(best, contour::exchange::<DoubleDouble>(here, there, most));
    }
    best
}

fn better(a: Exchange, b: Exchange) -> Exchange {
    if b.error < a.error { b } else { a }
}

/// Returns centre and radius of a bounding ball of an outline.
fn ball(outline: &Outline) -> (Vector, f64) {
    let middle = Vector::mean(outline);
    (middle, outline.iter().fold(0.0, |radius: f64, &v| radius.max((v - middle).length())))
}

#[cfg(test)]
mod tests;
