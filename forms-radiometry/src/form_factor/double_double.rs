//! Precise measures: form factor and solid angle of an unoccluded convex polygon, sphere or disk as
//! seen from a point, in double-double.
//!
//! ```text
//! corners − point, exactly ─▶ part above the horizon ─▶ edges or triangles
//! edges or triangles ─ kernels in double-double ─▶ sum and its rounding error
//! a sphere or a disk as a whole ─▶ round
//! ```
//! If a polygon is small, far away or seen edge-on, its edge terms cancel, and `f64` keeps few
//! digits of the sum or none. Double-double keeps them.

mod round;

pub(crate) use round::SeenWhole;

use crate::geometry::Vector;
use forms::math::{DoubleDouble, Real};
use forms_kernels::{edge_form_factor, solid_angle_triangle};
use std::f64::consts::PI;
use std::ops::Add;

/// Relative error of a term: a function loses a few of the last of the 106 bits.
const TERM: f64 = 64.0 * f64::EPSILON * f64::EPSILON;

/// Numbers below this that are multiples of 2⁻¹⁰ are decimals of at most 15 digits: a decimal that
/// was rounded to such a number is equal to it.
const FEW_DIGITS: f64 = 1e5;
const FEW_PLACES: f64 = 1024.0;
/// Angle by which rounding of the coordinates can turn a unit vector.
const TURNED: f64 = 0.5 * f64::EPSILON + TERM;

/// A vector in double-double.
pub(crate) type Precise = [DoubleDouble; 3];

/// A number, and a bound on its rounding error.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rounded {
    pub(crate) value: DoubleDouble,
    pub(crate) error: f64,
}

impl Rounded {
    pub(crate) fn exactly(value: f64) -> Self {
        Self { value: DoubleDouble::from_f64(value), error: 0.0 }
    }

    /// Returns the product with a number.
    pub(crate) fn times(self, factor: f64) -> Self {
        let value = DoubleDouble::from_f64(factor) * self.value;
        Self { value, error: factor.abs() * self.error }
    }

    /// Returns the product with a number of the scene file. A number of few binary digits is
    /// exactly the written one; any other can have been rounded.
    pub(crate) fn times_datum(self, datum: f64) -> Self {
        let Self { value, error } = self.times(datum);
        let is_as_written = datum.abs() < FEW_DIGITS && (FEW_PLACES * datum).fract() == 0.0;
        let rounding = if is_as_written { 0.0 } else { 0.5 * f64::EPSILON };
        Self { value, error: error + rounding * value.to_f64().abs() }
    }

    /// Returns the product with π.
    pub(crate) fn times_pi(self) -> Self {
        Self { value: pi() * self.value, error: PI * self.error }
    }

    /// Returns the quotient by π.
    pub(crate) fn over_pi(self) -> Self {
        Self { value: self.value / pi(), error: self.error / PI }
    }

    /// Returns the nearest `f64`, and a bound on its error.
    pub(crate) fn nearest(self) -> [f64; 2] {
        let value = self.value.to_f64();
        [value, self.error + (self.value.low().abs() + TERM * value.abs())]
    }
}

impl Add for Rounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: self.error + other.error }
    }
}

fn pi() -> DoubleDouble {
    DoubleDouble::constant(&[PI, 1.224_646_799_147_353_2e-16])
}

/// Converts a vector exactly.
fn precise(v: Vector) -> Precise {
    v.coordinates().map(DoubleDouble::from_f64)
}

/// Returns the exact vector from one point to another.
pub(crate) fn way(from: Vector, to: Vector) -> Precise {
    let (from, to) = (precise(from), precise(to));
    std::array::from_fn(|axis| to[axis] - from[axis])
}

pub(crate) fn dot([a, b, c]: Precise, [u, v, w]: Precise) -> DoubleDouble {
    DoubleDouble::sum_of_products(a, u, b, v) + c * w
}

fn cross([a, b, c]: Precise, [u, v, w]: Precise) -> Precise {
    let minor = DoubleDouble::difference_of_products;
    [minor(b, w, c, v), minor(c, u, a, w), minor(a, v, b, u)]
}

pub(crate) fn length(v: Precise) -> DoubleDouble {
    dot(v, v).sqrt()
}

/// Normalizes a vector that is a unit vector up to the rounding of its coordinates. Also returns a
/// bound on the angle error of its direction: zero for a vector along an axis.
pub(crate) fn unit(v: Vector) -> (Precise, f64) {
    let is_along_an_axis = v.coordinates().iter().filter(|&&x| x != 0.0).count() == 1;
    let length = length(precise(v));
    (precise(v).map(|x| x / length), if is_along_an_axis { 0.0 } else { TURNED })
}

/// The side of an outline on which a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Front,
    /// In its plane or behind.
    Back,
    /// Not known: the point is nearer to the plane of the outline than the outline's own corners.
    Unknown,
}

/// Returns twice the vector area of a convex outline. It points to the side from which the outline
/// is counter-clockwise.
fn twice_area(outline: &[Vector]) -> Precise {
    let from_first: Vec<Precise> = outline.iter().map(|&corner| way(outline[0], corner)).collect();
    let twice = from_first[1..].windows(2).map(|pair| cross(pair[0], pair[1]));
    twice.fold(precise(Vector::default()), |sum, one| std::array::from_fn(|axis| sum[axis] + one[axis]))
}

/// Returns the projected area of a convex outline along this direction, which is a unit vector up
/// to rounding. It is positive where the direction points against the side from which the outline
/// is counter-clockwise.
pub(crate) fn area_across(outline: &[Vector], direction: Vector) -> Rounded {
    let (direction, turned) = unit(direction);
    let twice = twice_area(outline);
    let value = DoubleDouble::from_f64(-0.5) * dot(twice, direction);
    Rounded { value, error: turned * 0.5 * length(twice).to_f64() }
}

/// Returns the area of a convex outline.
pub(crate) fn area(outline: &[Vector]) -> DoubleDouble {
    DoubleDouble::from_f64(0.5) * length(twice_area(outline))
}

/// Returns the signed distances of points in front of the plane of a convex outline, times twice
/// its area. Points that are nearer to the plane than the outline's own corners count as lying in
/// it.
pub(crate) fn heights(points: &[Vector], outline: &[Vector]) -> Vec<f64> {
    let (height, flatness) = height_over(outline);
    let of = |&point: &Vector| Some(height(point)).filter(|height| height.abs() > flatness).unwrap_or(0.0);
    points.iter().map(of).collect()
}

/// Returns the function that maps a point to its signed distance from the plane of a convex
/// outline, times twice its area, and the largest such distance of the outline's own corners. Three
/// corners always lie in a plane.
fn height_over(outline: &[Vector]) -> (impl Fn(Vector) -> f64, f64) {
    let normal = twice_area(outline);
    let height = move |point: Vector| dot(normal, way(outline[0], point)).to_f64();
    let off = outline[3..].iter().map(|&corner| height(corner).abs()).fold(0.0, f64::max);
    (height, off)
}

/// Returns the side of a convex outline on which a point lies; seen from the front, the outline is
/// counter-clockwise.
fn side(point: Vector, outline: &[Vector]) -> Side {
    let (height, flatness) = height_over(outline);
    match height(point) {
        height if height > flatness => Side::Front,
        height if height > -flatness || (height == 0.0 && flatness > 0.0) => Side::Unknown,
        _ => Side::Back,
    }
}

/// Widens the error of a measure by its value if the side of the outline is unknown: the measure
/// can then be zero.
fn from_side(side: Side, Rounded { value, error }: Rounded) -> Rounded {
    let unsure = if side == Side::Unknown { value.to_f64().abs() } else { 0.0 };
    Rounded { value, error: error + unsure }
}

/// Returns the corners of a convex outline relative to a point, clipped at the horizon of a normal
/// if there is one.
fn seen(point: Vector, outline: &[Vector], horizon: Option<Precise>) -> Vec<Precise> {
    let corners: Vec<Precise> = outline.iter().map(|&corner| way(point, corner)).collect();
    let Some(normal) = horizon else { return corners };
    let mut above = Vec::with_capacity(corners.len() + 2);
    for (index, &b) in corners.iter().enumerate() {
        let a = corners[(index + corners.len() - 1) % corners.len()];
        let [alpha, beta] = [a, b].map(|corner| dot(normal, corner));
        if alpha.to_f64() * beta.to_f64() < 0.0 {
            let share = alpha / (alpha - beta);
            above.push(std::array::from_fn(|axis| a[axis] + share * (b[axis] - a[axis])));
        }
        if beta.to_f64() >= 0.0 {
            above.push(b);
        }
    }
    above
}

/// Returns the angle between two vectors.
fn angle([a, b]: [Precise; 2]) -> f64 {
    let [across, along] = [length(cross(a, b)), dot(a, b)].map(DoubleDouble::to_f64);
    across.atan2(along)
}

/// Returns the change of the term γ n·(a × b)/|a × b| of an edge that subtends the angle γ, over
/// 2π, per change of the directions of its ends, each varied independently. Where the directions
/// are nearly equal or opposite, the plane through both is ill-conditioned.
fn of_edge(edge: [Precise; 2]) -> f64 {
    let angle = angle(edge);
    (0.5 * angle + if angle > 0.0 { angle / angle.sin().max(0.0) } else { 1.0 }) / PI
}

/// Bounds the change of a polygon's form factor per relative change of its corners and of its edge
/// terms. An edge that subtends an angle γ adds at most γ/2π. When one of its ends moves, the edge
/// sweeps the area tan(γ/2)/π: where its ends are nearly opposite, it is ill-conditioned. For an
/// edge of length l between distances r and r′, sin(γ/2) ≤ l/(r + r′).
pub(crate) fn rounding(point: Vector, polygon: &[Vector]) -> f64 {
    let next = polygon.iter().skip(1).chain(polygon.first());
    let of_edge = |(&a, &b): (&Vector, &Vector)| {
        of_sine(((b - a).length() / ((a - point).length() + (b - point).length())).min(1.0))
    };
    polygon.iter().zip(next).map(of_edge).sum()
}

/// Bounds the change of the term of an edge that subtends an angle γ with sin(γ/2) no more than
/// this: γ/2 ≤ π/2 sin(γ/2).
fn of_sine(sine: f64) -> f64 {
    0.5 * sine + sine / (PI * ((1.0 - sine) * (1.0 + sine)).sqrt())
}

/// Returns each corner with the next one.
fn edges(corners: &[Precise]) -> impl Iterator<Item = [Precise; 2]> {
    let next = corners.iter().skip(1).chain(corners.first());
    corners.iter().zip(next).map(|(&a, &b)| [a, b])
}

/// Returns the bound of [`rounding`] for all points that are at least this far from the corners of
/// a polygon. It is infinite where this distance is no more than half the length of an edge.
pub(crate) fn rounding_beyond(distance: f64, polygon: &[Vector]) -> f64 {
    let next = polygon.iter().skip(1).chain(polygon.first());
    let of_edge = |(&a, &b): (&Vector, &Vector)| of_sine(((b - a).length() / (2.0 * distance)).min(1.0));
    polygon.iter().zip(next).map(of_edge).sum()
}

/// Returns ∫ cos θ dω/π over the part of a convex outline that a point sees; θ is measured from
/// `direction`. With a horizon, only the part above the plane with the normal `direction` counts.
pub(crate) fn form_factor(
    point: Vector,
    outline: &[Vector],
    direction: Vector,
    has_horizon: bool,
) -> Rounded {
    let side = side(point, outline);
    let mut sum = Rounded::exactly(0.0);
    if side == Side::Back {
        return sum;
    }
    let (axis, turned) = unit(direction);
    let corners = seen(point, outline, has_horizon.then_some(axis));
    let mut around = 0.0;
    for [a, b] in edges(&corners) {
        let ([ax, ay, az], [bx, by, bz], [nx, ny, nz]) = (a, b, axis);
        let value = edge_form_factor::dd(bx, by, bz, ax, ay, az, nx, ny, nz);
        around += angle([a, b]);
        sum = sum + Rounded { value, error: TERM * of_edge([a, b]) };
    }
    // a turn by δ changes an edge term by at most δ γ/2π, and the whole sum by at most δ Ω/π
    let most = (around / (2.0 * PI)).min(solid_angle_at_most(point, outline) / PI);
    from_side(side, sum + Rounded { error: turned * most, ..Rounded::exactly(0.0) })
}

/// Bounds the solid angle of a convex outline: the cross-section of a bounding ball over the square
/// of the ball's least distance.
fn solid_angle_at_most(point: Vector, outline: &[Vector]) -> f64 {
    let center = Vector::mean(outline);
    let radius = outline.iter().map(|&corner| (corner - center).length()).fold(0.0, f64::max);
    let nearest = (point - center).length() - radius;
    if nearest > 0.0 { PI * (radius / nearest).powi(2) } else { f64::INFINITY }
}

/// Returns the solid angle of a convex outline as seen from a point.
pub(crate) fn solid_angle(point: Vector, outline: &[Vector]) -> Rounded {
    let side = side(point, outline);
    let mut sum = Rounded::exactly(0.0);
    if side == Side::Back {
        return sum;
    }
    let corners = seen(point, outline, None);
    let zero = DoubleDouble::from_f64(0.0);
    for pair in corners[1..].windows(2) {
        let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (corners[0], pair[0], pair[1]);
        // seen from the front, the triangle's normal points towards the point
        let value = -solid_angle_triangle::dd(zero, zero, zero, ax, ay, az, bx, by, bz, cx, cy, cz);
        let around: f64 = edges(&[corners[0], pair[0], pair[1]]).map(angle).sum();
        sum = sum + Rounded { value, error: TERM * around };
    }
    from_side(side, sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The square with this half side at this height that faces down.
    fn square(half: f64, height: f64) -> Vec<Vector> {
        [[-1.0, -1.0], [-1.0, 1.0], [1.0, 1.0], [1.0, -1.0]]
            .map(|[x, y]| Vector::new(half * x, half * y, height))
            .to_vec()
    }

    const HERE: Vector = Vector::new(0.0, 0.0, 0.0);

    #[test]
    fn a_small_square_far_away_has_the_leading_terms_of_its_series() {
        let up = Vector::new(0.0, 0.6, 0.8);
        for exponent in [10, 20, 40] {
            let half = 0.5_f64.powi(exponent);
            // F = 4 h² n·z/π (1 − 4 h²/3 + …), Ω = 4 h² (1 − h² + …)
            let area = 4.0 * half * half;
            let [found, error] = form_factor(HERE, &square(half, 1.0), up, true).nearest();
            let expected = area * 0.8 / PI * (1.0 - 4.0 / 3.0 * half * half);
            assert!(
                (found - expected).abs() <= error + (4.0 * f64::EPSILON + 2.0 * half.powi(4)) * expected,
                "{half}: {found}"
            );
            assert!(error <= 4.0 * f64::EPSILON * expected.max(half), "{half}: {error}");
            let [found, error] = solid_angle(HERE, &square(half, 1.0)).nearest();
            let expected = area * (1.0 - half * half);
            assert!(
                (found - expected).abs() <= error + (4.0 * f64::EPSILON + 2.0 * half.powi(4)) * expected,
                "{half}: {found}"
            );
        }
    }

    #[test]
    fn only_what_is_above_the_horizon_counts_and_only_from_the_front() {
        let across = Vector::new(1.0, 0.0, 0.0);
        let half: Vec<Vector> =
            square(1.0, 1.0).into_iter().map(|v| Vector::new(v.x.max(0.0), v.y, v.z)).collect();
        let [whole, part] =
            [square(1.0, 1.0), half].map(|outline| form_factor(HERE, &outline, across, true).nearest()[0]);
        assert_eq!(whole, part);
        let behind: Vec<Vector> = square(1.0, 1.0).into_iter().rev().collect();
        assert_eq!(form_factor(HERE, &behind, across, true).nearest(), [0.0; 2]);
        assert_eq!(solid_angle(HERE, &square(1.0, 0.0)).nearest(), [0.0; 2]);
    }
}
