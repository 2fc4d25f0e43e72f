//! Triangles: the light of an emitting triangle after extinction in a medium becomes a sum over the
//! points of a quadrature rule, with an error bound that is known before any value is.
//!
//! ```text
//! ∫ m(x/r) e^(−σ r) h/r³ dA,  x = a + s (b − a + t (c − b)),  dA = 2A s ds dt
//!                                                       h the height of the point above the plane
//! ```
//! As a function of s, or of t, the integrand is analytic where Re x·x > 0. Let M be an upper bound
//! of it in the ellipse with the foci at the ends of the interval and the sum ρ of its half axes.
//! Then the error of the Gauss rule with N points is at most 32/15 M ρ^(−2N)/(1 − ρ⁻²) on an
//! interval of length 1. The least bound of several ρ is taken. The trivial bound is that the
//! integral is not negative and below its largest integrand times the area. If no ρ gives a better
//! bound than this, no value is computed, and the trivial bound is the error. Triangles are halved
//! until the sum of all bounds is small enough. So no error is an estimate, and no feature that
//! lies between the points is missed.
//!
//! Source: L. N. Trefethen, Is Gauss quadrature better than Clenshaw–Curtis? (2008), theorem 4.5.

use super::halving::{Part, Piece, halved};
use super::{OF_HEIGHT, Reached, gauss_error, rounding, transmittance};
use crate::form_factor::gauss;
use crate::geometry::Vector;
use crate::radiosity::measure::Measure;
use crate::scene::Scene;
use crate::visibility::Face;
use forms_kernels::measure_area_to_solid_angle;
use std::f64::consts::PI;

/// Number of points of the rule along each side of the square.
const POINTS: usize = 8;
/// Sums of the half axes of the ellipses.
const ELLIPSES: [f64; 9] = [1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 14.0, 24.0, 50.0];

/// An emitting triangle as a point sees it.
pub(super) struct Triangle {
    /// The vectors from the point to its corners.
    corners: [Vector; 3],
    /// The unit normal of its plane, and the height of the point above it.
    normal: Vector,
    height: f64,
    surface: usize,
}

/// Returns the triangles of a convex piece of a face, relative to a point at this height above its
/// plane.
pub(super) fn fan<'f>(
    piece: &'f [Vector],
    face: &'f Face,
    height: f64,
) -> impl Iterator<Item = Triangle> + 'f {
    let triangle = move |pair: &[Vector]| Triangle {
        corners: [piece[0], pair[0], pair[1]],
        normal: face.normal,
        height,
        surface: face.surface,
    };
    piece[1..].windows(2).map(triangle)
}

/// Integrand.
pub(super) struct Integrand<'i> {
    pub(super) measures: &'i [Measure],
    pub(super) extinction: &'i [f64],
    pub(super) scene: &'i Scene,
}

/// Size and distance of a triangle.
struct Extent {
    nearest: f64,
    farthest: f64,
    diameter: f64,
    area: f64,
    height: f64,
}

impl Integrand<'_> {
    /// Returns the integrals over all triangles, by measure and band. Their errors are below the
    /// goal, a fraction of the largest value of the band.
    pub(super) fn integrated(&self, triangles: Vec<Triangle>, goal: f64) -> Vec<Reached> {
        halved(triangles, (self.measures.len(), self.extinction), goal, |triangle| self.part(triangle))
    }

    /// Evaluates a triangle.
    fn part(&self, triangle: Triangle) -> Part<Triangle> {
        let extent = triangle.extent();
        let radiances = &self.scene.surfaces[triangle.surface].radiance;
        let (mut errors, mut rounded, mut is_found) = (Vec::new(), Vec::new(), Vec::new());
        for (&extinction, radiance) in self.extinction.iter().zip(radiances) {
            let (most, error) = (extent.most(extinction), extent.error(extinction));
            let lost = rounding(extinction, extent.farthest)
                + OF_HEIGHT * f64::EPSILON * (extent.farthest / extent.height);
            // NaN fails this comparison, so that it does not count as a small error
            is_found.push(*radiance > 0.0 && error < most);
            errors.push(radiance * if error < most { error } else { most });
            rounded.push(radiance * lost * most);
        }
        let mut values = vec![0.0; self.measures.len() * self.extinction.len()];
        if is_found.contains(&true) {
            self.add(&triangle, extent.area, radiances, &mut values);
            let bands = self.extinction.len();
            let hidden = values.iter_mut().enumerate().filter(|(place, _)| !is_found[place % bands]);
            hidden.for_each(|(_, value)| *value = 0.0);
        }
        Part { piece: triangle, values, errors, rounding: rounded }
    }

    /// Adds the integral over a triangle by the rule.
    fn add(&self, triangle: &Triangle, area: f64, radiances: &[f64], values: &mut [f64]) {
        let [a, b, c] = triangle.corners;
        let rule = gauss(POINTS);
        for &[s, of_s] in rule {
            for &[t, of_t] in rule {
                let way = a + s * ((b - a) + t * (c - b));
                let squared = way.dot(way);
                let distance = squared.sqrt();
                let covered = 2.0
                    * area
                    * s
                    * of_s
                    * of_t
                    * measure_area_to_solid_angle(squared, triangle.height / distance);
                let direction = (1.0 / distance) * way;
                let of_measures = values.chunks_exact_mut(self.extinction.len());
                for (measure, of_bands) in self.measures.iter().zip(of_measures) {
                    let factor = covered * measure.factor(direction);
                    for ((value, &extinction), radiance) in
                        of_bands.iter_mut().zip(self.extinction).zip(radiances)
                    {
                        *value += factor * radiance * transmittance(extinction, distance);
                    }
                }
            }
        }
    }
}

impl Piece for Triangle {
    /// Returns the halves on both sides of the middle of the longest edge.
    fn halves(&self) -> [Self; 2] {
        let [a, b, c] = self.corners;
        let length = |a: Vector, b: Vector| (b - a).dot(b - a);
        // rotated so that the longest edge is the first
        let turned = [[a, b, c], [b, c, a], [c, a, b]];
        let longest = |one: &&[Vector; 3], other: &&[Vector; 3]| {
            length(one[0], one[1]).total_cmp(&length(other[0], other[1]))
        };
        let [a, b, c] = *turned.iter().max_by(longest).expect("a triangle has edges");
        let middle = 0.5 * (a + b);
        [[a, middle, c], [middle, b, c]].map(|corners| Self { corners, ..*self })
    }
}

impl Triangle {
    fn extent(&self) -> Extent {
        let [a, b, c] = self.corners;
        let edges = [[a, b], [b, c], [c, a]];
        let farthest = self.corners.into_iter().map(Vector::length).fold(0.0, f64::max);
        let diameter = edges.into_iter().map(|[a, b]| (b - a).length()).fold(0.0, f64::max);
        let area = 0.5 * (b - a).cross(c - a).length();
        Extent { nearest: self.nearest(edges), farthest, diameter, area, height: self.height }
    }

    /// Returns the least distance of a point of the triangle: that of the foot of the height if the
    /// foot lies within, otherwise that of an edge.
    fn nearest(&self, edges: [[Vector; 2]; 3]) -> f64 {
        let foot = -self.height * self.normal;
        let sides = edges.map(|[a, b]| self.normal.dot((b - a).cross(foot - a)));
        if sides.iter().all(|&side| side >= 0.0) || sides.iter().all(|&side| side <= 0.0) {
            return self.height;
        }
        let of_edge = |[a, b]: [Vector; 2]| {
            let along = b - a;
            let squared = along.dot(along);
            let place = if squared > 0.0 { (-a.dot(along) / squared).clamp(0.0, 1.0) } else { 0.0 };
            (a + place * along).length()
        };
        edges.map(of_edge).into_iter().fold(f64::INFINITY, f64::min).max(self.height)
    }
}

impl Extent {
    /// Returns an upper bound on any measure of the triangle, at a radiance of 1.
    fn most(&self, extinction: f64) -> f64 {
        let ratio = self.height / self.nearest;
        let solid_angle = (self.area * ratio / (self.nearest * self.nearest)).min(2.0 * PI);
        solid_angle * transmittance(extinction, self.nearest)
    }

    /// Returns the least error bound of the rule, at a radiance of 1.
    fn error(&self, extinction: f64) -> f64 {
        ELLIPSES.iter().map(|&rho| self.error_in(rho, extinction)).fold(f64::INFINITY, f64::min)
    }

    /// Returns the error bound of the rule from one ellipse. With the half axes α and β of the
    /// ellipse, and with the diameter d, the largest length of a line of points:
    /// |Re x| ≥ nearest − d/2 (α − 1), |Im x| ≤ d/2 β, |s| ≤ (1 + α)/2; and Re √z ≥ √(Re z).
    fn error_in(&self, rho: f64, extinction: f64) -> f64 {
        let [alpha, beta] = [0.5 * (rho + 1.0 / rho), 0.5 * (rho - 1.0 / rho)];
        let [beyond, across] = [0.5 * self.diameter * (alpha - 1.0), 0.5 * self.diameter * beta];
        let near = self.nearest - beyond;
        if near <= across {
            return f64::INFINITY;
        }
        let squared = (near - across) * (near + across);
        let [distance, far] = [squared.sqrt(), self.farthest + beyond + across];
        let largest =
            transmittance(extinction, distance) * (self.height / distance) * (far / distance) / squared;
        let of_rule = 0.5 * gauss_error(rho, POINTS);
        // (1 + α) for s, and 1 for t, as the mean of s is one half
        self.area * largest * of_rule * (2.0 + alpha)
    }
}
