//! Quadrics of revolution: the lateral surfaces of cylinders, cones and paraboloids between two
//! planes perpendicular to their axis.
//!
//! ```text
//! ρ² = r²(s), s from 0 to 1 along the axis
//! cylinder, cone   r  = r₀ + s (r₁ − r₀)
//! paraboloid       r² = r₀² + s (r₁² − r₀²)
//! ```
//! ρ is the distance from the axis. Each is a part of the boundary of a convex body: a ray that
//! leaves it on the outside does not come back to it.

mod crossings;

pub(crate) use crossings::Crossing;

use super::disk::{Disk, are_beyond, avoids, passes};
use super::{EDGES, ROUNDING, Rim, Round, across, circle, ring};
use crate::geometry::Vector;
use crossings::JOINT;
use std::f64::consts::PI;

/// Number of rings of the coarsest tessellation of a paraboloid.
const RINGS: usize = 6;
/// Fraction of a segment within which an intersection is not that of an end that lies on the shape.
const INNER: f64 = 1e-12;

/// How the radius changes along the axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Profile {
    /// The radius is linear: a cylinder or a cone.
    Straight,
    /// The square of the radius is linear: a paraboloid.
    Parabolic,
}

/// A cylinder, a cone or a paraboloid, without the disks at its ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadric {
    /// The centres of its ends.
    pub ends: [Vector; 2],
    /// The radii at its ends, of which at most one is zero.
    pub radii: [f64; 2],
    /// How the radius changes between them.
    pub profile: Profile,
    /// Whether the front is the inside.
    pub inward: bool,
}

impl Quadric {
    /// Returns the quadric with all lengths multiplied by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { ends: self.ends.map(|end| factor * end), radii: self.radii.map(|r| factor * r), ..self }
    }

    /// Returns the name of the shape.
    pub(crate) fn name(&self) -> &'static str {
        match self.profile {
            Profile::Parabolic => "paraboloid",
            Profile::Straight if self.radii[0] == self.radii[1] => "cylinder",
            Profile::Straight => "cone",
        }
    }

    /// Returns the unit vector along the axis, and the length.
    pub(crate) fn axis(&self) -> (Vector, f64) {
        let way = self.ends[1] - self.ends[0];
        (way.unit().expect("the ends of a quadric differ"), way.length())
    }

    /// Returns the smaller of its length and its largest radius.
    pub(crate) fn least_extent(&self) -> f64 {
        self.axis().1.min(self.largest_radius())
    }

    fn largest_radius(&self) -> f64 {
        self.radii[0].max(self.radii[1])
    }

    /// Returns the coefficients of r²(s) = q₀ + q₁ s + q₂ s².
    fn squared(&self) -> [f64; 3] {
        let [r, end] = self.radii;
        let more = end - r;
        match self.profile {
            Profile::Straight => [r * r, 2.0 * r * more, more * more],
            Profile::Parabolic => [r * r, more * (end + r), 0.0],
        }
    }

    /// Returns r(s).
    fn radius_at(&self, s: f64) -> f64 {
        let [r, end] = self.radii;
        match self.profile {
            Profile::Straight => (1.0 - s) * r + s * end,
            Profile::Parabolic => ((1.0 - s) * r * r + s * end * end).sqrt(),
        }
    }

    /// Returns r dr/dz at s: the normal is (ρ, −r dr/dz), away from and along the axis.
    fn slope(&self, s: f64) -> f64 {
        let [r, end] = self.radii;
        let length = self.axis().1;
        match self.profile {
            Profile::Straight => self.radius_at(s) * (end - r) / length,
            Profile::Parabolic => 0.5 * (end - r) * (end + r) / length,
        }
    }

    /// Returns a point relative to this axis of its own: s, and the vector from the axis.
    fn relative(&self, (axis, length): (Vector, f64), point: Vector) -> (f64, Vector) {
        let way = point - self.ends[0];
        let along = axis.dot(way);
        (along / length, way - along * axis)
    }

    /// Returns the area.
    ///
    /// Of a paraboloid with r dr/dz = k: dA = 2π √(r² + k²) dz = (π/k) √(r² + k²) d(r²).
    pub(crate) fn area(&self) -> f64 {
        let ([r, end], length) = (self.radii, self.axis().1);
        match self.profile {
            Profile::Straight => PI * (r + end) * length.hypot(end - r),
            Profile::Parabolic => {
                let k = self.slope(0.0);
                let root = r.hypot(k);
                2.0 * PI / 3.0 * (root / k) * root * root * (1.5 * self.growth().ln_1p()).exp_m1()
            }
        }
    }

    /// Returns by what part r² + k² grows from one end of a paraboloid to the other.
    fn growth(&self) -> f64 {
        let ([r, end], k) = (self.radii, self.slope(0.0));
        let root = r.hypot(k);
        (end - r) / root * ((end + r) / root)
    }

    /// Returns the s below which this fraction of the area lies.
    fn part(&self, fraction: f64) -> f64 {
        let [r, end] = self.radii;
        match self.profile {
            Profile::Straight => {
                let radius = (r * r * (1.0 - fraction) + end * end * fraction).sqrt();
                fraction * (r + end) / (radius + r)
            }
            Profile::Parabolic => {
                let growth = self.growth();
                let all = (1.5 * growth.ln_1p()).exp_m1();
                ((fraction * all).ln_1p() / 1.5).exp_m1() / growth
            }
        }
    }

    /// Returns a point of a uniform distribution over the area, by a point of the unit square, and
    /// the unit normal of the front there.
    pub(crate) fn point(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        let s = self.part(u).clamp(0.0, 1.0);
        let (axis, length) = self.axis();
        let [right, up] = across(axis);
        let (sine, cosine) = (2.0 * PI * v).sin_cos();
        let outward = cosine * right + sine * up;
        let position = self.ends[0] + (s * length) * axis + self.radius_at(s) * outward;
        (position, self.normal(s, outward))
    }

    /// Returns the unit normal of the front at s, in this unit direction away from the axis.
    fn normal(&self, s: f64, outward: Vector) -> Vector {
        let axis = self.axis().0;
        let normal = self.radius_at(s) * outward - self.slope(s) * axis;
        let normal = normal.unit().unwrap_or(if self.radii[0] == 0.0 { -axis } else { axis });
        if self.inward { -normal } else { normal }
    }

    /// Projects a point near the shape onto it, away from the axis, and returns it with the unit
    /// normal of the front.
    pub(crate) fn foot(&self, point: Vector) -> (Vector, Vector) {
        let (axis, length) = self.axis();
        let (s, off) = self.relative((axis, length), point);
        let s = s.clamp(0.0, 1.0);
        let outward = off.unit().unwrap_or(across(axis)[0]);
        let position = self.ends[0] + (s * length) * axis + self.radius_at(s) * outward;
        (position, self.normal(s, outward))
    }

    /// Returns how far outside a point is, to first order; negative inside. `None` beyond the ends.
    pub(crate) fn height(&self, point: Vector) -> Option<f64> {
        let (s, off) = self.relative(self.axis(), point);
        let is_beside = (-JOINT..=1.0 + JOINT).contains(&s);
        is_beside.then(|| {
            let radius = self.radius_at(s.clamp(0.0, 1.0));
            let steepness = self.slope(s.clamp(0.0, 1.0)) / radius.max(f64::MIN_POSITIVE);
            (off.length() - radius) / 1.0_f64.hypot(steepness)
        })
    }

    /// Whether a point is inside, between the planes of the ends.
    pub(crate) fn holds(&self, point: Vector) -> bool {
        let (s, off) = self.relative(self.axis(), point);
        (0.0..=1.0).contains(&s) && off.length() < self.radius_at(s)
    }

    /// Returns the disks that close its ends.
    fn lids(&self) -> [Disk; 2] {
        let normal = self.axis().0;
        [0, 1].map(|end| Disk { center: self.ends[end], normal, radius: self.radii[end], hole: 0.0 })
    }

    /// Returns points whose convex hull contains the shape.
    pub(crate) fn hull(&self) -> impl Iterator<Item = Vector> {
        let (axis, radius) = (self.axis().0, 1.02 * self.largest_radius());
        self.ends.into_iter().flat_map(move |end| circle(end, axis, radius, 0))
    }

    /// Returns the circles in which the shape ends.
    pub(crate) fn rims(&self) -> Vec<Rim> {
        let (axis, _) = self.axis();
        let side = if self.inward { -1.0 } else { 1.0 };
        let rim = |end: usize| {
            let (radius, slope) = (self.radii[end], self.slope(end as f64));
            let towards = if end == 0 { 1.0 } else { -1.0 };
            let length = radius.hypot(slope);
            Rim {
                center: self.ends[end],
                axis,
                radius,
                into: [towards * slope / length, towards * radius / length],
                normal: [side * radius / length, -side * slope / length],
            }
        };
        (0..2).filter(|&end| self.radii[end] > 0.0).map(rim).collect()
    }

    /// Returns convex polygons that approximate the shape, counter-clockwise seen from its front.
    /// Each step of `fineness` doubles the number of edges around it, and of rings along a
    /// paraboloid.
    pub(crate) fn pieces(&self, fineness: usize) -> Vec<Vec<Vector>> {
        let (axis, length) = self.axis();
        let rings = self.rings(fineness);
        let circles: Vec<Vec<Vector>> = (0..=rings)
            .map(|place| {
                let radius =
                    (self.radii[0] * (rings - place) as f64 + self.radii[1] * place as f64) / rings as f64;
                circle(self.ends[0] + (self.at(radius, place, rings) * length) * axis, axis, radius, fineness)
            })
            .collect();
        let mut pieces: Vec<Vec<Vector>> =
            circles.windows(2).flat_map(|pair| ring([&pair[0], &pair[1]])).collect();
        if self.inward {
            pieces.iter_mut().for_each(|piece| piece.reverse());
        }
        pieces
    }

    fn rings(&self, fineness: usize) -> usize {
        if self.profile == Profile::Straight { 1 } else { RINGS << fineness }
    }

    /// Returns the s of the circle of this radius, the `place`-th of `rings`.
    fn at(&self, radius: f64, place: usize, rings: usize) -> f64 {
        let [r, end] = self.radii;
        match self.profile {
            Profile::Straight => place as f64 / rings as f64,
            Profile::Parabolic => (radius - r) / (end - r) * ((radius + r) / (end + r)),
        }
    }
}

impl Round for Quadric {
    fn center(&self) -> Vector {
        0.5 * (self.ends[0] + self.ends[1])
    }

    /// Of a paraboloid, how far the cylinder around it reaches.
    fn reach(&self, along: Vector) -> f64 {
        let (axis, length) = self.axis();
        let (half, beside) = (0.5 * length * axis.dot(along), axis.cross(along).length());
        let [r, end] = match self.profile {
            Profile::Straight => self.radii,
            Profile::Parabolic => [self.largest_radius(); 2],
        };
        (beside * r - half).max(beside * end + half) / self.radius()
    }

    fn meets(&self, [a, b]: [Vector; 2]) -> bool {
        let is_inner = |crossing: Crossing| (INNER..=1.0 - INNER).contains(&crossing.distance);
        self.crossings(a, b - a).into_iter().flatten().any(is_inner)
    }

    /// Returns a bound from below: |ρ² − r²(s)| changes by at most 2 √(ρ² + (r dr/dz)²) per length.
    fn distance(&self, point: Vector) -> f64 {
        let (axis, length) = self.axis();
        let (s, off) = self.relative((axis, length), point);
        let within = s.clamp(0.0, 1.0);
        let (away, radius) = (off.length(), self.radius_at(within));
        let most = away.max(self.largest_radius());
        let slope = self.slope(0.0).abs().max(self.slope(1.0).abs());
        ((away - radius) * (away + radius) / (2.0 * most.hypot(slope))).hypot((s - within) * length)
    }

    /// Returns the radius of a ball about the centre that holds the shape.
    fn radius(&self) -> f64 {
        (0.5 * self.axis().1).hypot(self.largest_radius())
    }

    fn rounding(&self) -> f64 {
        ROUNDING * (self.center().largest() + self.radius())
    }

    /// Exceeds both (1 − cos(π/N)) r and the distance of the vertices outside the circle, and adds
    /// the height of the arc of a paraboloid over the chord of a ring.
    fn deviation(&self, fineness: usize) -> f64 {
        let of_circle = self.largest_radius() * (PI / (EDGES << fineness) as f64).powi(2);
        let rings = self.rings(fineness) as f64;
        let of_arc =
            if self.profile == Profile::Straight { 0.0 } else { 0.25 * self.axis().1 / (rings * rings) };
        of_circle + of_arc
    }

    /// A line that meets the shape at one point of the outline, and none of the disks at its ends at
    /// any, meets it at all.
    fn hides(&self, point: Vector, outline: &[Vector]) -> bool {
        let meets = |&corner: &Vector| self.meets([point, corner]);
        outline.iter().all(meets) && self.lids().into_iter().all(|lid| avoids(lid, point, outline))
    }

    /// Nothing beyond the ends is between. A line that passes the disks at both ends, or one of them from the inside, meets nothing
    /// between.
    fn shows_through(&self, point: Vector, outline: &[Vector]) -> bool {
        let axis = self.axis().0;
        let is_beyond = |end: usize, axis: Vector| are_beyond(self.ends[end], axis, point, outline);
        if is_beyond(0, -axis) || is_beyond(1, axis) {
            return true;
        }
        let needed = if self.holds(point) { 1 } else { 2 };
        let [one, other] = self.lids().map(|lid| passes(lid, point, outline));
        one.zip(other).is_some_and(|(one, other)| usize::from(one) + usize::from(other) == needed)
    }

    /// The part may be as long as the shape.
    fn cap(&self, _: f64, _: f64) -> f64 {
        self.radius()
    }
}
