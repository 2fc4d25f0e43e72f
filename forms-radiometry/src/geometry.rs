//! Geometry of light. A list of vertices is checked and becomes a polygon. A polygon seen from a
//! point spans a cone of directions; subtracting the cones of all occluders from it leaves the
//! visible part. The exchange area of two polygons is a sum over their edges.

mod clip;
mod cone;
pub(crate) mod double_double;
mod edges;
mod exchange;
mod form_factor;
mod mesh;
mod overlap;
mod polygon;
mod round;
pub(crate) mod scale;
mod sides;
mod tessellation_gap;
mod triangulation;
mod vector;
mod visibility;
mod weld;

pub(crate) use clip::split;
pub(crate) use edges::{Edges, fill};
pub use exchange::{Exchange, exchange, view_factor, visible_exchange};
pub(crate) use exchange::{Patch, exchange_of, exchange_precisely, exchange_with, gauss, patches};
pub(crate) use form_factor::edge_sum;
pub use form_factor::form_factor;
#[cfg(test)]
pub(crate) use form_factor::form_factor_of_pieces;
pub use mesh::{FaceError, Mesh, MeshError};
pub(crate) use overlap::{Flat, common_area, off_plane, overlap, resolution};
pub use polygon::{Polygon, PolygonError};
pub(crate) use polygon::{area, edges, intersection};
pub(crate) use round::Round;
pub use round::{Disk, Sphere};
pub(crate) use tessellation_gap::bulge;
pub use vector::Vector;
pub(crate) use visibility::{
    Beam, Between, Borders, Boxes, Face, Lit, Looking, Met, Plane, Screens, Start, Wall, Walls, Workspace,
    closeness, distance_of_boxes,
};
pub(crate) use weld::Welded;
