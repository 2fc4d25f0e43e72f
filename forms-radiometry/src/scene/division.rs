//! Division: the surfaces of a scene become smaller surfaces, of which view factors are asked.
//!
//! ```text
//! surface   as the file has them
//! group     each mesh becomes the groups that its file names
//! face      each mesh becomes its faces
//! ```

use super::model::{Scene, Shape, Surface};
use std::sync::Arc;

/// What a row of view factors belongs to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Division {
    /// Surfaces of the file.
    #[default]
    Surfaces,
    /// Groups of faces that mesh files name; other surfaces as they are.
    Groups,
    /// Faces of meshes; other surfaces as they are.
    Faces,
}

impl Scene {
    /// Returns the scene with its surfaces divided, without its receivers. The groups of a mesh are
    /// named `surface/group`, its faces `surface#1`, `surface#2`, and so on.
    #[must_use]
    pub fn divided(&self, division: Division) -> Self {
        let surfaces = self.surfaces.iter().flat_map(|surface| parts(surface, division)).collect();
        Self { surfaces, receivers: Vec::new(), ..self.clone() }
    }
}

fn parts(surface: &Surface, division: Division) -> Vec<Surface> {
    let part = |name: String, shape: Shape| Surface {
        name: format!("{}{name}", surface.name),
        shape,
        ..surface.clone()
    };
    match (&surface.shape, division) {
        (Shape::Mesh(mesh), Division::Groups) if !mesh.groups().is_empty() => mesh
            .groups()
            .iter()
            .map(|(name, faces)| part(format!("/{name}"), Shape::Mesh(Arc::new(mesh.part(faces)))))
            .collect(),
        (Shape::Mesh(mesh), Division::Faces) => mesh
            .polygons()
            .enumerate()
            .map(|(index, polygon)| part(format!("#{}", index + 1), Shape::Polygon(polygon)))
            .collect(),
        _ => vec![surface.clone()],
    }
}
