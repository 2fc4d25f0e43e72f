//! Receiving places: the points at which a receiver measures light, and the areas over which it
//! integrates light.

use super::model::{Points, ReceiverKind, Scene, Shape, SurfaceSide};
use crate::geometry::Vector;
use crate::visibility::ReceivingArea;

impl ReceiverKind {
    /// Returns the side of a surface that the receiver measures, if it measures one.
    pub(crate) fn side(&self) -> Option<ReceivingArea> {
        match *self {
            Self::Surface { surface, side, .. } | Self::Faces { surface, side } => {
                let is_back = side == SurfaceSide::Back;
                Some(ReceivingArea { surface, is_back, face: None })
            }
            Self::Point { .. }
            | Self::Points(_)
            | Self::Ray { .. }
            | Self::Camera(_)
            | Self::Sphere { .. } => None,
        }
    }

    /// Returns the faces of this side that the receiver measures one by one.
    pub(crate) fn faces(&self, scene: &Scene) -> impl Iterator<Item = ReceivingArea> {
        let side = self.side().filter(|_| matches!(self, Self::Faces { .. }));
        let count = side.map_or(0, |side| scene.surfaces[side.surface].shape.face_count());
        side.into_iter()
            .flat_map(move |side| (0..count).map(move |face| ReceivingArea { face: Some(face), ..side }))
    }

    /// Returns the points at which the receiver measures light, each with its normal if it has one.
    pub(crate) fn points(&self) -> impl Iterator<Item = (Vector, Option<Vector>)> {
        let (one, many) = match self {
            Self::Point { position, normal } => (Some((*position, Some(*normal))), None),
            Self::Sphere { position } => (Some((*position, None)), None),
            Self::Points(points) => (None, Some(points)),
            Self::Surface { .. } | Self::Faces { .. } | Self::Ray { .. } | Self::Camera(_) => (None, None),
        };
        one.into_iter().chain(many.into_iter().flat_map(Points::iter))
    }

    /// Whether the receiver measures the irradiance at points.
    pub(crate) fn is_irradiance_at_points(&self) -> bool {
        match self {
            Self::Point { .. } => true,
            Self::Points(points) => points.normals.is_some(),
            _ => false,
        }
    }

    /// Whether the receiver measures the fluence rate and the vector irradiance at points.
    pub(crate) fn is_all_around(&self) -> bool {
        match self {
            Self::Sphere { .. } => true,
            Self::Points(points) => points.normals.is_none(),
            _ => false,
        }
    }

    /// Whether the receiver has one result for each of several points, faces, cells or pixels.
    pub(crate) fn has_cells(&self) -> bool {
        match self {
            Self::Points(_) | Self::Faces { .. } | Self::Camera(_) => true,
            Self::Surface { grid, .. } => grid.is_some(),
            Self::Point { .. } | Self::Ray { .. } | Self::Sphere { .. } => false,
        }
    }

    /// Returns the columns and rows of its cells or pixels, if these adjoin each other.
    pub(crate) fn raster(&self) -> Option<[usize; 2]> {
        match self {
            Self::Surface { grid, .. } => *grid,
            Self::Points(points) => points.grid,
            Self::Camera(camera) => Some(camera.resolution),
            Self::Point { .. } | Self::Faces { .. } | Self::Ray { .. } | Self::Sphere { .. } => None,
        }
    }
}

impl Shape {
    /// Returns the number of faces: one for a polygon, none for a curved shape or a disk.
    pub(crate) fn face_count(&self) -> usize {
        match self {
            Self::Polygon(_) => 1,
            Self::Mesh(mesh) => mesh.faces().len(),
            _ => 0,
        }
    }
}

impl Scene {
    /// Returns for each surface whether a receiver measures its faces one by one.
    pub(crate) fn are_faces_measured(&self) -> Vec<bool> {
        let mut measured = vec![false; self.surfaces.len()];
        for receiver in &self.receivers {
            if let ReceiverKind::Faces { surface, .. } = receiver.kind {
                measured[surface] = true;
            }
        }
        measured
    }

    /// Returns every area over which a receiver integrates, once for each receiver.
    pub(crate) fn receiving_areas(&self) -> impl Iterator<Item = ReceivingArea> {
        let kinds = self.receivers.iter().map(|receiver| &receiver.kind);
        kinds.flat_map(|kind| kind.side().into_iter().chain(kind.faces(self)))
    }
}
