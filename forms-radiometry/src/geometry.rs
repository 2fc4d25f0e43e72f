//! Shapes: vectors, polygons, meshes, and round shapes. A list of vertices is checked and becomes a
//! polygon; polygons are clipped, intersected and divided into triangles. Nothing here occludes
//! anything.

mod affine;
mod bounding_rectangle;
pub(crate) mod bounds;
pub(crate) mod clip;
mod corners;
pub(crate) mod edges;
mod face_list;
mod flat_parts;
mod mesh;
mod outline;
mod overlap;
pub(crate) mod plane;
mod polygon;
mod repair;
pub(crate) mod round;
pub(crate) mod scale;
pub(crate) mod sides;
mod tessellation_gap;
mod triangulation;
mod vector;
mod weld;

pub(crate) use affine::Affine;
pub(crate) use bounding_rectangle::BoundingRectangle;
pub(crate) use clip::split;
pub(crate) use corners::Corners;
pub(crate) use edges::{Edges, fill};
pub(crate) use face_list::FaceList;
pub use mesh::{FaceError, Mesh, MeshError};
pub(crate) use outline::Outline;
pub(crate) use overlap::{Flat, common_area, off_plane, overlap, resolution};
pub(crate) use plane::{Plane, closeness};
pub use polygon::{Polygon, PolygonError};
pub(crate) use polygon::{area, edges, intersection};
pub(crate) use repair::{Repaired, repaired};
#[cfg(test)]
pub(crate) use round::regular;
pub(crate) use round::{Crossing, Rim, Round, across};
pub use round::{Disk, Profile, Quadric, Sphere};
pub(crate) use tessellation_gap::bulge;
pub use vector::Vector;
pub(crate) use weld::Welded;
