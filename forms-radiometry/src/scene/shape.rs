//! Shapes of surfaces: flat, round, or a mesh.

use crate::geometry::{Disk, Mesh, Polygon, Quadric, Round, Sphere};
use std::sync::Arc;

/// Geometry of a surface.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A planar polygon.
    Polygon(Polygon),
    /// A mesh of planar polygons. Surfaces that name the same file share it.
    Mesh(Arc<Mesh>),
    /// A sphere.
    Sphere(Sphere),
    /// A disk or an annulus.
    Disk(Disk),
    /// A cylinder, a cone or a paraboloid.
    Quadric(Quadric),
}

impl Shape {
    /// Whether the shape is curved, or has a curved border.
    pub(crate) fn is_round(&self) -> bool {
        self.as_round().is_some()
    }

    /// Whether the shape is curved, and not only its border.
    pub(crate) fn is_curved(&self) -> bool {
        matches!(self, Self::Sphere(_) | Self::Quadric(_))
    }

    /// Returns the shape if it is curved, or has a curved border.
    pub(crate) fn as_round(&self) -> Option<&dyn Round> {
        match self {
            Self::Sphere(sphere) => Some(sphere),
            Self::Disk(disk) => Some(disk),
            Self::Quadric(quadric) => Some(quadric),
            Self::Polygon(_) | Self::Mesh(_) => None,
        }
    }

    /// Whether the shape is a mesh whose normals are interpolated between its vertices.
    pub(crate) fn is_smooth(&self) -> bool {
        matches!(self, Self::Mesh(mesh) if mesh.is_smooth())
    }

    /// Whether the shape is a mesh without faces.
    pub(crate) fn has_no_faces(&self) -> bool {
        matches!(self, Self::Mesh(mesh) if mesh.faces().len() == 0)
    }

    /// Returns the polygon, if the shape is one.
    pub fn as_polygon(&self) -> Option<&Polygon> {
        match self {
            Self::Polygon(polygon) => Some(polygon),
            Self::Mesh(_) | Self::Sphere(_) | Self::Disk(_) | Self::Quadric(_) => None,
        }
    }
}
