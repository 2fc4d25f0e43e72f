//! Forms of light sources: directions to them, with their densities per solid angle, and points on
//! them.
//!
//! ```text
//! triangle   uniform over its solid angle     disk, cylinder, cone, paraboloid   uniform over its area
//! sphere     outside, uniform over the cone that it subtends; inside, uniform over its area
//! point, spot and distant light: the only possible direction
//! ```

use super::choice::Weight;
use super::warps::{
    spherical_triangle_pdf, spherical_triangle_sample, uniform_cone_pdf, uniform_cone_sample,
    uniform_triangle_sample,
};
use crate::geometry::{Disk, Quadric, Round, Sphere, Vector};
use crate::sampling::Frame;
use crate::scene::Cone;
use crate::visibility::{Met, Wall};
use forms_kernels::{measure_area_to_solid_angle, measure_solid_angle_to_area};
use std::f64::consts::PI;

/// Where the light of a source comes from.
#[derive(Clone, Copy, Debug)]
pub(super) enum Form {
    Triangle([Vector; 3]),
    Disk(Disk),
    Sphere(Sphere),
    Quadric(Quadric),
    Point(Vector),
    Spot(Vector, Cone),
    /// The unit vector along which the light travels.
    Distant(Vector),
}

impl Form {
    /// Returns the selection data for this radiance, intensity or irradiance.
    pub(super) fn weight(&self, value: f64) -> Weight {
        let near = |area: f64, middle: Vector, radius: f64| Weight {
            strength: value * area,
            middle,
            radius,
            far: 0.0,
            direction: None,
            before: None,
        };
        match *self {
            Self::Triangle(corners) => {
                let middle = Vector::mean(&corners);
                let radius = corners.iter().map(|&corner| (corner - middle).length()).fold(0.0, f64::max);
                near(self.area(), middle, radius)
            }
            Self::Disk(disk) => near(self.area(), disk.center, disk.radius),
            Self::Sphere(sphere) => near(PI * sphere.radius * sphere.radius, sphere.center, sphere.radius),
            Self::Quadric(quadric) => near(0.5 * self.area(), quadric.center(), quadric.radius()),
            Self::Point(position) | Self::Spot(position, _) => near(1.0, position, 0.0),
            Self::Distant(direction) => {
                Weight { far: value, direction: Some(-direction), ..near(0.0, Vector::default(), 0.0) }
            }
        }
    }

    pub(super) fn area(&self) -> f64 {
        match self {
            Self::Triangle([a, b, c]) => 0.5 * (*b - *a).cross(*c - *a).length(),
            Self::Disk(disk) => disk.area(),
            Self::Sphere(sphere) => sphere.area(),
            Self::Quadric(quadric) => quadric.area(),
            Self::Point(_) | Self::Spot(..) | Self::Distant(_) => 0.0,
        }
    }

    /// Returns a point that is uniform over the area, and the normal of a front that is curved.
    pub(super) fn point(&self, [u, v]: [f64; 2]) -> (Vector, Vector) {
        match *self {
            Self::Triangle([a, b, c]) => {
                let [p, q] = uniform_triangle_sample(u, v);
                (a + p * (b - a) + q * (c - a), Vector::default())
            }
            Self::Disk(disk) => disk.sample([u, v]),
            Self::Sphere(sphere) => sphere.sample([u, v]),
            Self::Quadric(quadric) => quadric.point([u, v]),
            Self::Point(position) | Self::Spot(position, _) => (position, Vector::default()),
            Self::Distant(direction) => (direction, Vector::default()),
        }
    }

    /// Returns a direction to the form, its distance if it is a point, and the density.
    pub(super) fn towards(&self, from: Vector, square: [f64; 2]) -> Option<(Vector, f64, f64)> {
        match *self {
            Self::Point(position) => {
                let offset = position - from;
                let direction = offset.unit()?;
                Some((direction, offset.length(), offset.dot(offset)))
            }
            Self::Spot(position, cone) => {
                let offset = position - from;
                let direction = offset.unit()?;
                Some((direction, offset.length(), offset.dot(offset) / cone.factor(-direction)))
            }
            Self::Distant(direction) => Some((-direction, f64::INFINITY, 1.0)),
            Self::Triangle(corners) => {
                let [a, b, c] = corners.map(|corner| corner - from);
                let [u, v] = square;
                let [x, y, z] = spherical_triangle_sample(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, u, v);
                let direction = Vector::new(x, y, z).unit()?;
                Some((direction, f64::INFINITY, triangle_density([a, b, c], direction)))
            }
            Self::Sphere(sphere) if outside(&sphere, from).is_some() => {
                let (axis, height) = outside(&sphere, from)?;
                let direction = Frame::about(axis).place(uniform_cone_sample(height, square[0], square[1]));
                Some((direction, f64::INFINITY, cone_density(height)))
            }
            Self::Quadric(quadric) => {
                let direction = (quadric.point(square).0 - from).unit()?;
                Some((direction, f64::INFINITY, quadric_density(&quadric, from, direction)))
            }
            Self::Disk(_) | Self::Sphere(_) => {
                let (point, normal) = self.point(square);
                let offset = point - from;
                let direction = offset.unit()?;
                let density = self.density_of_area(offset.dot(offset), normal.dot(direction).abs());
                Some((direction, f64::INFINITY, density))
            }
        }
    }

    /// Returns the density of directions to points that are uniform over the area.
    pub(super) fn density_of_area(&self, squared: f64, cosine: f64) -> f64 {
        measure_solid_angle_to_area(squared, cosine) / self.area()
    }

    pub(super) fn density(&self, from: Vector, direction: Vector, met: &Met) -> f64 {
        match *self {
            Self::Triangle(corners) => triangle_density(corners.map(|corner| corner - from), direction),
            Self::Sphere(sphere) if outside(&sphere, from).is_some() => {
                outside(&sphere, from).map_or(0.0, |(_, height)| cone_density(height))
            }
            Self::Quadric(quadric) => quadric_density(&quadric, from, direction),
            Self::Disk(_) | Self::Sphere(_) => {
                let offset = met.position - from;
                let covered =
                    measure_area_to_solid_angle(offset.dot(offset), met.normal.dot(direction).abs());
                1.0 / (covered * self.area())
            }
            Self::Point(_) | Self::Spot(..) | Self::Distant(_) => 0.0,
        }
    }
}

/// Returns the forms of a wall: a polygon becomes a fan of triangles.
pub(super) fn forms(wall: &Wall) -> Vec<Form> {
    match wall {
        Wall::Polygon { vertices, .. } => {
            let fan = vertices[1..].windows(2).map(|pair| Form::Triangle([vertices[0], pair[0], pair[1]]));
            fan.filter(|triangle| triangle.area() > 0.0).collect()
        }
        Wall::Disk(disk) => vec![Form::Disk(*disk)],
        Wall::Sphere(sphere) => vec![Form::Sphere(*sphere)],
        Wall::Quadric(quadric) => vec![Form::Quadric(*quadric)],
    }
}

fn triangle_density([a, b, c]: [Vector; 3], direction: Vector) -> f64 {
    let Vector { x, y, z } = direction;
    spherical_triangle_pdf(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z, x, y, z)
}

/// Returns the density of directions to points that are uniform over the area of a quadric: a line
/// can meet it twice.
fn quadric_density(quadric: &Quadric, from: Vector, direction: Vector) -> f64 {
    let density = |distance: f64| {
        let (_, normal) = quadric.foot(from + distance * direction);
        measure_solid_angle_to_area(distance * distance, normal.dot(direction).abs()) / quadric.area()
    };
    let ahead = quadric.crossings(from, direction).into_iter().flatten().filter(|met| met.distance > 0.0);
    ahead.map(|met| density(met.distance)).sum()
}

/// Returns, from outside a sphere, the direction to its centre, and 1 minus the cosine of its
/// angular radius: s²/(1 + √(1 − s²)) with s = R/d.
fn outside(sphere: &Sphere, from: Vector) -> Option<(Vector, f64)> {
    let offset = sphere.center - from;
    let distance = offset.length();
    let sine = sphere.radius / distance;
    let squared = sine * sine;
    (sine < 1.0).then(|| offset.unit().map(|axis| (axis, squared / (1.0 + (1.0 - squared).sqrt())))).flatten()
}

/// Returns the density in a cone, which does not depend on the direction.
fn cone_density(height: f64) -> f64 {
    uniform_cone_pdf(height, 0.0, 0.0, 1.0)
}
