//! Disks and annuli: flat, with a circular border.

use super::{EDGES, ROUNDING, Rim, Round, WITHIN, across, circle, regular, ring};
use crate::geometry::{Vector, edges};
use std::f64::consts::PI;

/// Openings count as wider than they are by this factor, like the pieces that approximate them.
const WIDER: f64 = 1.01;
/// Points count as lying in a plane if they are no farther from it than this part of their distance.
const BESIDE: f64 = 1e-14;
/// An outline in the plane of an opening counts as beyond it.
const FARTHER: f64 = 1.0 + 1e-9;

/// A flat disk, or an annulus: a disk with a round hole around its centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// The centre.
    pub center: Vector,
    /// The unit normal, which points to the front.
    pub normal: Vector,
    /// The radius, above zero.
    pub radius: f64,
    /// The radius of the hole; 0 without one.
    pub hole: f64,
}

impl Disk {
    /// Returns the disk with all lengths multiplied by this factor.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { center: factor * self.center, radius: factor * self.radius, hole: factor * self.hole, ..self }
    }

    /// Returns the disk with front and back swapped.
    pub(crate) fn reversed(self) -> Self {
        Self { normal: -self.normal, ..self }
    }

    pub(crate) fn area(&self) -> f64 {
        PI * (self.radius - self.hole) * (self.radius + self.hole)
    }

    /// Returns the distance between the borders, or the radius.
    pub(crate) fn width(&self) -> f64 {
        self.radius - self.hole
    }

    /// Whether the disk has a hole.
    pub(crate) fn is_annulus(&self) -> bool {
        self.hole > 0.0
    }

    /// Returns the disks of which this one is the first without the second: all of it, and its hole.
    pub(crate) fn whole_and_hole(&self) -> [Self; 2] {
        [Self { hole: 0.0, ..*self }, Self { radius: self.hole, hole: 0.0, ..*self }]
    }

    /// Returns a point of a uniform distribution over an annulus, by a point of the unit square:
    /// ρ² is uniform between those of its borders.
    pub(crate) fn point(&self, [u, v]: [f64; 2]) -> Vector {
        let squared = self.hole * self.hole * (1.0 - u) + self.radius * self.radius * u;
        let ([right, up], (sine, cosine)) = (across(self.normal), (2.0 * PI * v).sin_cos());
        self.center + squared.sqrt() * (cosine * right + sine * up)
    }

    /// Returns a regular polygon around the disk.
    pub(crate) fn around(&self) -> Vec<Vector> {
        regular(self.center, self.normal, self.radius / (PI / EDGES as f64).cos(), EDGES)
    }

    /// Whether the disk contains a point of its plane.
    pub(crate) fn reaches(&self, point: Vector) -> bool {
        let off = point - self.center;
        let squared = off.dot(off);
        squared <= self.radius * self.radius && squared >= self.hole * self.hole
    }

    /// Returns the circles in which the disk ends.
    pub(crate) fn rims(&self) -> Vec<Rim> {
        let rim = |radius: f64, into: f64| Rim {
            center: self.center,
            axis: self.normal,
            radius,
            into: [into, 0.0],
            normal: [0.0, 1.0],
        };
        let hole = self.is_annulus().then(|| rim(self.hole, 1.0));
        [rim(self.radius, -1.0)].into_iter().chain(hole).collect()
    }

    /// Returns opposite corners of its axis-aligned bounding box.
    pub(crate) fn corners(&self) -> [Vector; 2] {
        let reach =
            self.normal.coordinates().map(|across| self.radius * (1.0 - across * across).max(0.0).sqrt());
        let [x, y, z] = reach;
        let reach = Vector::new(x, y, z);
        [self.center - reach, self.center + reach]
    }

    /// Returns the regular polygon that approximates the disk without its hole, counter-clockwise
    /// seen from its front. Each step of `fineness` doubles the number of edges.
    pub(crate) fn polygon(&self, fineness: usize) -> Vec<Vector> {
        circle(self.center, self.normal, self.radius, fineness)
    }

    /// Returns convex polygons that approximate the disk, with its area, counter-clockwise seen from
    /// its front.
    pub(crate) fn pieces(&self, fineness: usize) -> Vec<Vec<Vector>> {
        if !self.is_annulus() {
            return vec![self.polygon(fineness)];
        }
        let [outer, inner] = self.whole_and_hole().map(|disk| disk.polygon(fineness));
        ring([&outer, &inner])
    }
}

/// Whether all segments from a point to the corners of an outline pass a disk, or none does. `None`
/// if some do.
pub(super) fn passes(disk: Disk, point: Vector, outline: &[Vector]) -> Option<bool> {
    let opening = Disk { radius: WIDER * disk.radius, hole: 0.0, ..disk };
    let crosses = |&corner: &Vector| opening.meets([point, point + FARTHER * (corner - point)]);
    let count = outline.iter().filter(|corner| crosses(corner)).count();
    (count == 0 || count == outline.len()).then_some(count > 0)
}

/// Whether no segment from a point to a convex outline passes a disk, as far as that shows in their
/// intersections with its plane.
pub(super) fn avoids(disk: Disk, point: Vector, outline: &[Vector]) -> bool {
    let height = |point: Vector| disk.normal.dot(point - disk.center);
    let above = height(point);
    let crosses = |&corner: &Vector| above * height(corner) < 0.0;
    if !outline.iter().all(crosses) {
        return !outline.iter().any(crosses);
    }
    let crossing = |&corner: &Vector| {
        let share = above / (above - height(corner));
        point + share * (corner - point) - disk.center
    };
    let places: Vec<Vector> = outline.iter().map(crossing).collect();
    let beside = |[a, b]: [Vector; 2]| {
        let outward = disk.normal.cross(b - a).unit().unwrap_or_default();
        let is_before = |outward: Vector| {
            let nearest = places.iter().map(|&place| outward.dot(place)).fold(f64::INFINITY, f64::min);
            WITHIN * nearest >= disk.radius
        };
        is_before(outward) || is_before(-outward) || a.unit().is_some_and(is_before)
    };
    edges(&places).any(beside)
}

/// Whether a point and an outline are on one side of a plane, or in it.
pub(super) fn are_beyond(place: Vector, normal: Vector, point: Vector, outline: &[Vector]) -> bool {
    let reach = outline.iter().chain([&point]).map(|&end| (end - place).length()).fold(0.0, f64::max);
    outline.iter().chain([&point]).all(|&end| normal.dot(end - place) >= -BESIDE * reach)
}

impl Round for Disk {
    fn center(&self) -> Vector {
        self.center
    }

    fn reach(&self, along: Vector) -> f64 {
        self.normal.cross(along).length()
    }

    fn meets(&self, [a, b]: [Vector; 2]) -> bool {
        let [alpha, beta] = [a, b].map(|end| self.normal.dot(end - self.center));
        let away = (a + (alpha / (alpha - beta)) * (b - a) - self.center).length();
        alpha * beta < 0.0 && WITHIN * away >= self.hole && away <= WITHIN * self.radius
    }

    /// Returns the distance from the nearer border.
    fn distance(&self, point: Vector) -> f64 {
        let way = point - self.center;
        let height = self.normal.dot(way);
        let away = (way - height * self.normal).length();
        let outer = (away - self.radius).abs();
        let nearer = if self.is_annulus() { outer.min((away - self.hole).abs()) } else { outer };
        nearer.hypot(height)
    }

    fn radius(&self) -> f64 {
        self.radius
    }

    fn hides(&self, point: Vector, outline: &[Vector]) -> bool {
        let [whole, hole] = self.whole_and_hole();
        let meets = |&corner: &Vector| whole.meets([point, corner]);
        outline.iter().all(meets) && (!self.is_annulus() || avoids(hole, point, outline))
    }

    fn shows_through(&self, point: Vector, outline: &[Vector]) -> bool {
        let [_, hole] = self.whole_and_hole();
        let is_beside = |normal: Vector| are_beyond(self.center, normal, point, outline);
        is_beside(self.normal)
            || is_beside(-self.normal)
            || self.is_annulus() && passes(hole, point, outline) == Some(true)
    }

    fn rounding(&self) -> f64 {
        let along = self.normal.coordinates().map(|across| (1.0 - across * across).max(0.0).sqrt());
        let lengths = self.center.coordinates().map(|center| center.abs() + self.radius);
        let moved: f64 = lengths.into_iter().zip(along).map(|(length, along)| length * along).sum();
        ROUNDING * moved
    }

    /// Exceeds both (1 − cos(π/N)) r and the distance of the vertices outside the circle.
    fn deviation(&self, fineness: usize) -> f64 {
        self.radius * (PI / (EDGES << fineness) as f64).powi(2)
    }
}
