//! Shapes with textures: the texture coordinates of a shape and the pattern of its material become the
//! texture of a surface.

use super::Reader;
use super::geometry::Geometry;
use super::normals::SmoothMesh;
use crate::geometry::{Corners, FaceList, Mesh, Polygon, Vector};
use crate::scene::model::{Shape, Surface};
use crate::scene::texture::{Pattern, Texture, TextureCoordinates};
use std::sync::Arc;

/// A mesh of triangles with texture coordinates, and the normals at their corners.
struct Triangles {
    mesh: Mesh,
    normals: Corners<Vector>,
}

impl Reader<'_, '_, '_> {
    /// Adds a surface with a pattern.
    pub(super) fn textured(&mut self, pattern: &Arc<Pattern>, geometry: Geometry, surface: Surface) {
        let Geometry { shape, texture, smooth, axes } = geometry;
        let (coordinates, shape, smooth) = match (shape, axes) {
            (shape, Some(axes)) => (TextureCoordinates::Polar(axes), shape, None),
            (Shape::Polygon(polygon), _) => {
                (TextureCoordinates::Corners(texture.values), Shape::Polygon(polygon), None)
            }
            (Shape::Mesh(mesh), _) => {
                let no_normals = Corners::default();
                let normals = smooth.as_ref().map_or(&no_normals, |smooth| &smooth.normals);
                let Some(Triangles { mesh, normals }) = triangles(&mesh, &texture, normals) else {
                    self.without_coordinates(&surface, "has no texture coordinates");
                    return;
                };
                let smooth = smooth.map(|smooth| SmoothMesh { normals, ..smooth });
                (TextureCoordinates::Mesh, Shape::Mesh(Arc::new(mesh)), smooth)
            }
            _ => {
                self.without_coordinates(&surface, "has no texture coordinates here");
                return;
            }
        };
        let texture = Some(Texture { pattern: Arc::clone(pattern), coordinates });
        self.add_surface(Surface { shape, texture, ..surface }, smooth);
    }

    /// Reports a shape whose texture cannot be placed.
    pub(super) fn without_coordinates(&mut self, surface: &Surface, reason: &str) {
        let message = format!("the shape `{}` {reason}, which is not supported", surface.name);
        self.report.error_at(&surface.place, message, "a reflectance without a texture");
    }
}

/// Returns the faces of a mesh as triangles that share their first corner, as in Mitsuba. `None` if a
/// face has no texture coordinates.
fn triangles(mesh: &Mesh, texture: &Corners<[f64; 2]>, normals: &Corners<Vector>) -> Option<Triangles> {
    let mut list = FaceList::default();
    let mut of_texture = Corners { values: texture.values.clone(), indices: FaceList::default() };
    let mut of_normals = Corners { values: normals.values.clone(), indices: FaceList::default() };
    for (face, corners) in mesh.faces().enumerate() {
        let positions: Vec<Vector> = mesh.corners(face).collect();
        let (uv, own) = (texture.indices_of(face), normals.indices_of(face));
        if uv.len() != corners.len() {
            return None;
        }
        for last in 2..corners.len() {
            let triangle = [0, last - 1, last];
            if Polygon::new(triangle.map(|corner| positions[corner]).to_vec()).is_err() {
                continue;
            }
            of_texture.push(list.len(), triangle.map(|corner| uv[corner]));
            of_normals.push(list.len(), triangle.iter().filter_map(|&corner| own.get(corner).copied()));
            list.push(triangle.map(|corner| corners[corner]));
        }
    }
    let vertices = mesh.vertices().to_vec();
    Some(Triangles { mesh: Mesh::of_polygons(vertices, list).textured(of_texture), normals: of_normals })
}
