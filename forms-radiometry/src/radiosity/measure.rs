//! Measures: how a receiver weights the light from a direction.
//!
//! ```text
//! plane     F = (1/π) ∫ cos θ dω   irradiance of an element with the normal n:  E = π F L
//! sphere    Ω = ∫ dω               fluence rate:                                 φ = Ω L
//! flow      −∫ ω dω                vector irradiance along an axis; ω points towards the light
//! ```
//! All measures are over π, so that a reflected radiance ρE/π and an exitance M/π enter alike.

use crate::form_factor::edge_sum;
use crate::geometry::Vector;
use forms_kernels::solid_angle_triangle;
use std::f64::consts::PI;

/// Quantity measured at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// Irradiance of a surface element with this unit normal.
    Plane(Vector),
    /// Fluence rate.
    Sphere,
    /// The component of vector irradiance along this unit vector.
    Flow(Vector),
}

impl Measure {
    /// The fluence rate and the three components of vector irradiance.
    pub(crate) const ALL_SIDES: [Self; 4] = [
        Self::Sphere,
        Self::Flow(Vector::new(1.0, 0.0, 0.0)),
        Self::Flow(Vector::new(0.0, 1.0, 0.0)),
        Self::Flow(Vector::new(0.0, 0.0, 1.0)),
    ];

    /// Returns the normal of the horizon below which light does not count.
    pub(crate) fn horizon(self) -> Option<Vector> {
        match self {
            Self::Plane(normal) => Some(normal),
            Self::Sphere | Self::Flow(_) => None,
        }
    }

    /// Returns the measure, over π, of a convex polygon relative to the receiver. The polygon lies
    /// above the horizon and its front faces the receiver.
    pub(crate) fn of(self, polygon: &[Vector]) -> f64 {
        match self {
            Self::Plane(normal) => edge_sum(polygon, normal),
            Self::Flow(axis) => -edge_sum(polygon, axis),
            Self::Sphere => {
                let a = polygon[0];
                let triangle = |pair: &[Vector]| {
                    let [b, c] = [pair[0], pair[1]];
                    // seen from the front, the triangle's normal points to the receiver
                    -solid_angle_triangle(0.0, 0.0, 0.0, a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z)
                };
                polygon[1..].windows(2).map(triangle).sum::<f64>() / PI
            }
        }
    }

    /// Returns the axis along which the measure is ∫ cos θ dω, and the sign; `None` for a measure
    /// that is no such integral.
    pub(crate) fn along(self) -> Option<(Vector, f64)> {
        match self {
            Self::Plane(normal) => Some((normal, 1.0)),
            Self::Flow(axis) => Some((axis, -1.0)),
            Self::Sphere => None,
        }
    }

    /// Returns the ratio of the measure of a small area in this direction to its solid angle.
    pub(crate) fn factor(self, direction: Vector) -> f64 {
        match self {
            Self::Plane(normal) => normal.dot(direction).max(0.0),
            Self::Sphere => 1.0,
            Self::Flow(axis) => -axis.dot(direction),
        }
    }

    /// Returns the measure of all directions, over π.
    pub(crate) fn whole(self) -> f64 {
        match self {
            Self::Plane(_) => 1.0,
            Self::Sphere => 4.0,
            Self::Flow(_) => 0.0,
        }
    }
}
