//! Closed forms: view factors of spheres, disks and polygons that nothing hides from each other.
//!
//! ```text
//! sphere and sphere      a quadrature of one smooth integrand (`view_factor_spheres`)
//! sphere and flat piece  Ω/4π, Ω the solid angle from the centre, if the sphere is in front of its plane
//! flat and flat          a sum over pairs of borders ([`flat_shapes`](super::flat_shapes))
//! shapes about one axis  sums over disks ([`coaxial`])
//! sphere around a convex surface   1, and by A₁F₁₂ = A₂F₂₁ and the sum of the row the others
//! ```
//! Nothing is between two surfaces if each of the others is aside, behind one of the two, around
//! both, or outside the hull of both.
//!
//! What leaves a sphere evenly arrives at a surface element in front of it like light from its
//! centre, because the element sees all of the sphere above its horizon.

use super::coaxial::{self, ROUNDING, area};
use super::flat_shapes::FlatShape;
use super::{Row, ViewFactor};
use crate::answer::ErrorKind;
use crate::geometry::bounds::Bounds;
use crate::geometry::{Disk, Polygon, Round, Sphere, Vector};
use crate::scene::{Scene, Shape, Surface};
use crate::visibility::{Between, Face, Screens};
use forms_kernels::{solid_angle_triangle, view_factor_spheres};
use std::f64::consts::PI;
use std::sync::{Arc, OnceLock};

/// A shape counts as behind a plane if it reaches no farther in front of it than this part of its size.
const BEHIND: f64 = 1e-9;

/// The surfaces of a scene, each with a ball around it.
pub(super) struct ClosedForms {
    scene: Arc<Scene>,
    balls: Vec<(Vector, f64)>,
    /// The occluders among flat shapes and meshes.
    flat_screens: OnceLock<Screens>,
}

impl ClosedForms {
    pub(super) fn of(scene: Arc<Scene>) -> Self {
        let balls = scene.surfaces.iter().map(|one| ball(&one.shape)).collect();
        Self { scene, balls, flat_screens: OnceLock::new() }
    }

    fn surfaces(&self) -> &[Surface] {
        &self.scene.surfaces
    }

    fn shape(&self, surface: usize) -> &Shape {
        &self.surfaces()[surface].shape
    }

    /// Returns the view factors of a surface that have a closed form, each with the kind of its
    /// error.
    pub(super) fn known(&self, surface: usize) -> Vec<Option<(ViewFactor, ErrorKind)>> {
        (0..self.balls.len()).map(|other| self.factor(surface, other)).collect()
    }

    /// Returns the row of a surface if all its view factors are known.
    pub(super) fn row(known: &[Option<(ViewFactor, ErrorKind)>]) -> Option<Row> {
        let (factors, kinds): (Vec<ViewFactor>, Vec<ErrorKind>) =
            known.iter().copied().collect::<Option<Vec<_>>>()?.into_iter().unzip();
        let is_bound = kinds.iter().all(|&kind| kind == ErrorKind::Bound);
        Some(Row { factors, kind: if is_bound { ErrorKind::Bound } else { ErrorKind::Estimate } })
    }

    fn factor(&self, from: usize, to: usize) -> Option<(ViewFactor, ErrorKind)> {
        if self.surfaces()[from].two_sided || self.surfaces()[to].two_sided {
            return None;
        }
        let value = self.enclosed(from, to).or_else(|| self.between(from, to));
        let rounded = value.map(|value| ViewFactor { value, error: ROUNDING * value });
        let bound = rounded.or_else(|| coaxial::factor(self.surfaces(), from, to));
        let bound = bound.map(|factor| (factor, ErrorKind::Bound));
        bound.or_else(|| Some((self.flat(from, to)?, ErrorKind::Estimate)))
    }

    /// Returns the view factor of two flat surfaces that nothing hides from each other.
    fn flat(&self, from: usize, to: usize) -> Option<ViewFactor> {
        let [one, other] = [from, to].map(|index| FlatShape::of(self.shape(index)));
        let (one, other) = (one?, other?);
        if !self.is_unhidden([(from, &one), (to, &other)]) {
            return None;
        }
        let [size, of_other] = [from, to].map(|index| area(self.shape(index)));
        let size = size?;
        let found = one.exchange(&other, (size.min(of_other?), self.scene.solve.tolerance))?;
        Some(ViewFactor { value: found.area / size, error: found.error / size })
    }

    /// Whether no other surface can be between two flat ones.
    fn is_unhidden(&self, both: [(usize, &FlatShape); 2]) -> bool {
        let [(from, one), (to, other)] = both;
        let is_aside = |index: usize| {
            matches!(self.shape(index), Shape::Polygon(_) | Shape::Disk(_) | Shape::Mesh(_))
                || both.iter().any(|(_, flat)| self.reach(index, flat) <= BEHIND * self.balls[index].1)
                || self.is_around(index, [from, to])
                || self.is_far_from(index, [from, to])
        };
        let mut others = (0..self.balls.len()).filter(|&index| index != from && index != to);
        let screens = self.flat_screens.get_or_init(|| flat_screens(self.surfaces()));
        let mut found = Vec::new();
        let mut is_free = |a: &[Vector], b: &[Vector]| {
            screens.between(a, Some(one.normal), b, other.normal, &mut found) == Between::Nothing
        };
        others.all(is_aside) && one.outlines().all(|a| other.outlines().all(|b| is_free(&a, &b)))
    }

    /// Returns how far the ball around a surface reaches in front of the plane of a flat shape.
    fn reach(&self, index: usize, flat: &FlatShape) -> f64 {
        let (center, radius) = self.balls[index];
        flat.normal.dot(center - flat.point) + radius
    }

    /// Whether a surface is a sphere that contains both of two others.
    fn is_around(&self, index: usize, both: [usize; 2]) -> bool {
        let Shape::Sphere(sphere) = *self.shape(index) else { return false };
        both.iter().all(|&inner| {
            let (center, radius) = self.balls[inner];
            (center - sphere.center).length() + radius <= sphere.radius
        })
    }

    /// Returns the view factor of two surfaces that nothing occludes, or of a surface to itself.
    fn between(&self, from: usize, to: usize) -> Option<f64> {
        let [one, other] = [from, to].map(|index| self.shape(index));
        if from == to {
            return is_convex(one).then_some(0.0);
        }
        self.is_free(from, to).then(|| unobstructed(one, other)).flatten()
    }

    /// Returns the view factor where a sphere around a convex surface is all there is.
    fn enclosed(&self, from: usize, to: usize) -> Option<f64> {
        let hollow = |index: usize| match *self.shape(index) {
            Shape::Sphere(sphere) if sphere.inward => Some(sphere),
            _ => None,
        };
        match self.balls.len() {
            1 => hollow(from).map(|_| 1.0),
            2 => {
                let shell = (0..2).find(|&index| hollow(index).is_some())?;
                let (sphere, inner) = (hollow(shell)?, 1 - shell);
                let (center, radius) = self.balls[inner];
                let is_inside = (center - sphere.center).length() + radius <= sphere.radius;
                let shape = self.shape(inner);
                let share = area(shape)? / (4.0 * PI * sphere.radius * sphere.radius);
                // the back of a flat shape takes as much light as its front, and sends none
                let lost = if matches!(shape, Shape::Sphere(_)) { 1.0 } else { 2.0 };
                // an open shape takes light inside, too
                let is_closed = !matches!(shape, Shape::Quadric(_));
                (is_inside && is_closed && is_convex(shape)).then_some(match (from == shell, to == shell) {
                    (true, true) => 1.0 - lost * share,
                    (true, false) => share,
                    (false, true) => 1.0,
                    (false, false) => 0.0,
                })
            }
            _ => None,
        }
    }

    /// Whether no other surface can be between two.
    fn is_free(&self, from: usize, to: usize) -> bool {
        let mut others = (0..self.balls.len()).filter(|&index| index != from && index != to);
        others.all(|index| self.is_far_from(index, [from, to]))
    }

    /// Whether the ball around a surface is farther from the line between the centres of two others
    /// than these reach from it.
    fn is_far_from(&self, index: usize, both: [usize; 2]) -> bool {
        let [(center, radius), (a, one), (b, other)] =
            [index, both[0], both[1]].map(|index| self.balls[index]);
        let reach = one.max(other);
        let (along, way) = (b - a, center - a);
        let share = (way.dot(along) / along.dot(along)).clamp(0.0, 1.0);
        (way - share * along).length() > reach + radius
    }
}

/// Returns the occluders among flat shapes and meshes. Those of disks reach a little farther than the
/// disks; a disk on a polygon counts as a part of it.
fn flat_screens(surfaces: &[Surface]) -> Screens {
    let mut faces = Vec::new();
    for (index, surface) in surfaces.iter().enumerate() {
        match &surface.shape {
            Shape::Polygon(polygon) => {
                let pieces = polygon.straight_pieces().iter();
                faces.extend(pieces.flat_map(|piece| Face::sides(index, piece, polygon.normal())));
            }
            Shape::Mesh(mesh) => mesh.flat_parts().for_each(|flat| faces.extend(Face::of(index, &flat))),
            Shape::Disk(disk) => faces.extend(Face::sides(index, &disk.around(), disk.normal)),
            Shape::Sphere(_) | Shape::Quadric(_) => {}
        }
    }
    Screens::of(&faces)
}

/// Whether a front sees nothing of itself.
fn is_convex(shape: &Shape) -> bool {
    match shape {
        Shape::Sphere(sphere) => !sphere.inward,
        Shape::Quadric(quadric) => !quadric.inward,
        Shape::Polygon(_) | Shape::Disk(_) => true,
        Shape::Mesh(_) => false,
    }
}

/// Returns a ball around a shape.
fn ball(shape: &Shape) -> (Vector, f64) {
    let corners = match shape {
        Shape::Sphere(Sphere { center, radius, .. }) | Shape::Disk(Disk { center, radius, .. }) => {
            return (*center, *radius);
        }
        Shape::Quadric(quadric) => return (quadric.center(), quadric.radius()),
        Shape::Polygon(polygon) => Bounds::of(polygon.vertices().iter().copied()),
        Shape::Mesh(mesh) => Bounds::of((0..mesh.faces().len()).flat_map(|face| mesh.corners(face))),
    };
    (0.5 * (corners.low + corners.high), 0.5 * (corners.high - corners.low).length())
}

/// The least and the largest number of points on a rim, and the relative change by twice as many at
/// which the rule has converged.
const RIM: [u32; 2] = [8, 1 << 14];
const RULE: f64 = 0.5 * ROUNDING;

/// Returns the view factor between the fronts of two shapes that nothing hides from each other.
fn unobstructed(one: &Shape, other: &Shape) -> Option<f64> {
    match (one, other) {
        (Shape::Sphere(a), Shape::Sphere(b)) => spheres(a, b),
        (Shape::Sphere(sphere), flat) => sphere_to_flat(sphere, flat),
        (flat, Shape::Sphere(sphere)) => {
            let ratio = 4.0 * PI * sphere.radius * sphere.radius / area(flat)?;
            sphere_to_flat(sphere, flat).map(|value| ratio * value)
        }
        _ => None,
    }
}

fn spheres(a: &Sphere, b: &Sphere) -> Option<f64> {
    let distance = (b.center - a.center).length();
    (!a.inward && !b.inward && distance >= a.radius + b.radius)
        .then(|| view_factor_spheres(a.radius, b.radius, distance))
}

/// Returns the view factor from a sphere to the front of a flat shape, if the sphere is on one side
/// of its plane.
fn sphere_to_flat(sphere: &Sphere, flat: &Shape) -> Option<f64> {
    let (point, normal) = match flat {
        Shape::Polygon(polygon) => (polygon.vertices()[0], polygon.normal()),
        Shape::Disk(disk) => (disk.center, disk.normal),
        Shape::Sphere(_) | Shape::Mesh(_) | Shape::Quadric(_) => return None,
    };
    let height = normal.dot(sphere.center - point);
    if sphere.inward || height.abs() < sphere.radius {
        return None;
    }
    match flat {
        _ if height < 0.0 => Some(0.0),
        Shape::Polygon(polygon) => Some(solid_angle(polygon, sphere.center) / (4.0 * PI)),
        Shape::Disk(disk) => {
            let away = (sphere.center - disk.center).cross(disk.normal).length();
            let [whole, hole] =
                disk.whole_and_hole().map(|disk| solid_angle_of_disk(disk.radius, height, away));
            Some((whole? - hole?) / (4.0 * PI))
        }
        Shape::Sphere(_) | Shape::Mesh(_) | Shape::Quadric(_) => None,
    }
}

/// Returns the solid angle of a disk from a point at this height above its plane and this distance
/// from its axis; `None` where the point is so close to the rim that the rule does not converge.
///
/// Seen from the foot of the point, an element of the rim at distance s has the angle
/// dα = (R² − a R cos φ)/s² dφ, and the sector within it the solid angle (1 − h/q) dα, q² = h² + s²:
/// ```text
/// Ω = ∫ (R² − a R cos φ)/(q (q + h)) dφ,   q² = p² − 2 a R cos φ,   p² = h² + a² + R²
///   = ∫ R²/(q (q + h)) (1 − 2 a² cos² φ (p + q + h)/((p + q) p (p + h))) dφ
/// ```
/// The second form subtracts cos φ/(p (p + h)), whose integral is zero, and so does not cancel from
/// afar. The integrand is periodic and analytic: the trapezoidal rule doubles its digits with its
/// points.
fn solid_angle_of_disk(radius: f64, height: f64, away: f64) -> Option<f64> {
    let middle = radius.hypot(away).hypot(height);
    let at = |angle: f64| {
        let (sine, cosine) = ((0.5 * angle).sin(), angle.cos());
        let squared = (away - radius).powi(2) + 4.0 * away * radius * sine * sine;
        let ray = squared.sqrt().hypot(height);
        let turned = 2.0 * (away * cosine / middle) * (away * cosine / (middle + height));
        let both = middle + ray;
        radius * radius / (ray * (ray + height)) * (1.0 - turned * (both + height) / both)
    };
    let sum = |count: u32, first: f64| -> f64 {
        (0..count).map(|index| at((f64::from(index) + first) * 2.0 * PI / f64::from(count))).sum()
    };
    let (mut count, mut before) = (RIM[0], sum(RIM[0], 0.0));
    while count < RIM[1] {
        let after = before + sum(count, 0.5);
        let [old, new] = [before / f64::from(count), after / f64::from(2 * count)];
        if (new - old).abs() <= RULE * new.abs() {
            return Some(2.0 * PI * new);
        }
        (count, before) = (2 * count, after);
    }
    None
}

/// Returns the solid angle of a polygon from a point in front of it.
fn solid_angle(polygon: &Polygon, point: Vector) -> f64 {
    let of_triangle = |a: Vector, b: Vector, c: Vector| {
        let [p, a, b, c] = [point, a, b, c].map(Vector::coordinates);
        solid_angle_triangle(p[0], p[1], p[2], a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]).abs()
    };
    let of_piece = |piece: &Vec<Vector>| {
        (1..piece.len() - 1).map(|i| of_triangle(piece[0], piece[i], piece[i + 1])).sum::<f64>()
    };
    polygon.convex_pieces().iter().map(of_piece).sum()
}
