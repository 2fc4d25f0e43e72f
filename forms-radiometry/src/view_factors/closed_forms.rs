//! Closed forms: view factors of spheres, disks and polygons that nothing hides from each other.
//!
//! ```text
//! sphere and sphere      a quadrature of one smooth integrand (`view_factor_spheres`)
//! sphere and flat piece  Ω/4π, Ω the solid angle from the centre, if the sphere is in front of its plane
//! shapes about one axis  sums over disks ([`coaxial`])
//! sphere around a convex surface   1, and by A₁F₁₂ = A₂F₂₁ and the sum of the row the others
//! ```
//! What leaves a sphere evenly arrives at a surface element in front of it like light from its
//! centre, because the element sees all of the sphere above its horizon.

use super::ViewFactor;
use super::coaxial::{self, COAXIAL, ROUNDING, area};
use crate::geometry::bounds::Bounds;
use crate::geometry::{Disk, Polygon, Round, Sphere, Vector};
use crate::scene::{Scene, Shape, Surface};
use forms_kernels::{solid_angle_triangle, view_factor_sphere_disk, view_factor_spheres};
use std::f64::consts::PI;

/// The surfaces of a scene, each with a ball around it.
pub(super) struct ClosedForms<'s> {
    surfaces: &'s [Surface],
    balls: Vec<(Vector, f64)>,
}

impl<'s> ClosedForms<'s> {
    pub(super) fn of(scene: &'s Scene) -> Self {
        Self { surfaces: &scene.surfaces, balls: scene.surfaces.iter().map(|one| ball(&one.shape)).collect() }
    }

    /// Returns the view factors of a surface that have a closed form.
    pub(super) fn row(&self, surface: usize) -> Vec<Option<ViewFactor>> {
        (0..self.surfaces.len()).map(|other| self.factor(surface, other)).collect()
    }

    fn factor(&self, from: usize, to: usize) -> Option<ViewFactor> {
        if self.surfaces[from].two_sided || self.surfaces[to].two_sided {
            return None;
        }
        let value = self.enclosed(from, to).or_else(|| self.between(from, to));
        let rounded = value.map(|value| ViewFactor { value, error: ROUNDING * value });
        rounded.or_else(|| coaxial::factor(self.surfaces, from, to))
    }

    /// Returns the view factor of two surfaces that nothing occludes, or of a surface to itself.
    fn between(&self, from: usize, to: usize) -> Option<f64> {
        let [one, other] = [from, to].map(|index| &self.surfaces[index].shape);
        if from == to {
            return is_convex(one).then_some(0.0);
        }
        self.is_free(from, to).then(|| unobstructed(one, other)).flatten()
    }

    /// Returns the view factor where a sphere around a convex surface is all there is.
    fn enclosed(&self, from: usize, to: usize) -> Option<f64> {
        let hollow = |index: usize| match self.surfaces[index].shape {
            Shape::Sphere(sphere) if sphere.inward => Some(sphere),
            _ => None,
        };
        match self.surfaces.len() {
            1 => hollow(from).map(|_| 1.0),
            2 => {
                let shell = (0..2).find(|&index| hollow(index).is_some())?;
                let (sphere, inner) = (hollow(shell)?, 1 - shell);
                let (center, radius) = self.balls[inner];
                let is_inside = (center - sphere.center).length() + radius <= sphere.radius;
                let shape = &self.surfaces[inner].shape;
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

    /// Whether no other surface can be between two: the balls around the others are farther from the
    /// line between their centres than they reach from it.
    fn is_free(&self, from: usize, to: usize) -> bool {
        let [(a, one), (b, other)] = [from, to].map(|index| self.balls[index]);
        let reach = one.max(other);
        (0..self.surfaces.len()).filter(|&index| index != from && index != to).all(|index| {
            let (center, radius) = self.balls[index];
            let (along, way) = (b - a, center - a);
            let share = (way.dot(along) / along.dot(along)).clamp(0.0, 1.0);
            (way - share * along).length() > reach + radius
        })
    }
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
            let is_coaxial =
                (sphere.center - disk.center).cross(disk.normal).length() <= COAXIAL * disk.radius;
            let [whole, hole] = disk.whole_and_hole();
            let of_disk = |disk: Disk| {
                if disk.radius > 0.0 { view_factor_sphere_disk(disk.radius, height) } else { 0.0 }
            };
            is_coaxial.then(|| of_disk(whole) - of_disk(hole))
        }
        Shape::Sphere(_) | Shape::Mesh(_) | Shape::Quadric(_) => None,
    }
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
