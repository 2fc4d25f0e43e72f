//! Normals: Mitsuba interpolates the normals of a mesh between its vertices. Here faces are flat, so
//! such a mesh is an error where its normals matter to an answer.

use super::Reader;
use crate::geometry::{Mesh, Vector};
use crate::scene::mesh_file::{MeshFile, is_same_normal};
use crate::scene::model::{MaterialKind, ReceiverKind};
use std::collections::HashSet;
use std::ops::Range;

/// The largest angle in degrees between normals that are interpolated on a diffuse surface and
/// those of its faces. The two triangles of a quad that is not planar differ by about as much.
const SMALL_ANGLE: f64 = 0.5;

/// A mesh with normals other than those of its faces.
pub(super) struct SmoothMesh {
    pub(super) file: String,
    pub(super) place: Range<usize>,
    pub(super) surface: usize,
    /// The largest angle in degrees between its normals and those of its faces, if it is known.
    pub(super) angle: Option<f64>,
}

/// Returns whether the normals of a mesh are those of its faces, or the largest angle in degrees
/// between them, if it is small.
pub(super) fn angle(file: &MeshFile) -> Result<(), Option<f64>> {
    if file.has_normals {
        return if file.has_normals_of_faces { Ok(()) } else { Err(None) };
    }
    match angle_at_vertices(&file.mesh) {
        None => Err(None),
        Some(0.0) => Ok(()),
        Some(angle) => Err(Some(angle)),
    }
}

/// Returns the largest angle in degrees between faces with a common vertex, or `None` if it is not
/// small. Normals that differ only by rounding have an angle of zero. A normal of a vertex is a
/// mean of the normals of its faces, and differs by no more from any of them.
fn angle_at_vertices(mesh: &Mesh) -> Option<f64> {
    let mut normals: Vec<Vec<Vector>> = vec![Vec::new(); mesh.vertices().len()];
    let mut largest = 0.0_f64;
    for (face, polygon) in mesh.faces().zip(mesh.polygons()) {
        let normal = polygon.normal();
        for &vertex in face {
            let others = &mut normals[vertex as usize];
            if others.iter().any(|&other| is_same_normal(other, normal)) {
                continue;
            }
            for other in others.iter() {
                let angle = other.cross(normal).length().atan2(other.dot(normal)).to_degrees();
                largest = largest.max(angle);
            }
            if largest > SMALL_ANGLE {
                return None;
            }
            others.push(normal);
        }
    }
    Some(largest)
}

impl Reader<'_, '_, '_> {
    /// Reports meshes whose normals matter to a receiver. Normals do not matter where nothing is
    /// reflected, emitted or measured. On diffuse surfaces small angles are noted.
    pub(super) fn check_normals(&mut self) {
        let mut known: Vec<Range<usize>> = Vec::new();
        let mut noted = HashSet::new();
        for mesh in std::mem::take(&mut self.smooth_meshes) {
            if known.contains(&mesh.place) || !self.depends_on_normals(mesh.surface) {
                continue;
            }
            let SmoothMesh { file, place, surface, angle } = mesh;
            known.push(place.clone());
            match angle.filter(|_| self.is_diffuse_surface(surface)) {
                Some(angle) => {
                    let note = format!(
                        "{file}: the normals of the faces are used, from which interpolated normals differ by \
                         up to {angle:.2}°"
                    );
                    if noted.insert(note.clone()) {
                        self.report.note(note);
                    }
                }
                None => {
                    let message = format!(
                        "`{file}` would be shaded with interpolated normals, which are not supported"
                    );
                    self.report.error(place, message, "<boolean name=\"face_normals\" value=\"true\"/>");
                }
            }
        }
    }

    fn depends_on_normals(&self, index: usize) -> bool {
        let Some(surface) = self.surfaces.get(index) else { return false };
        let is_black = match self.materials.get(surface.material).map(|material| &material.kind) {
            Some(MaterialKind::Diffuse { reflectance }) => reflectance.iter().all(|&part| part == 0.0),
            _ => false,
        };
        let measures =
            |kind: &ReceiverKind| matches!(kind, ReceiverKind::Surface { surface, .. } if *surface == index);
        let is_measured = self.receivers.iter().any(|receiver| measures(&receiver.kind));
        !self.receivers.is_empty() && (is_measured || !is_black || surface.emits())
    }

    fn is_diffuse_surface(&self, index: usize) -> bool {
        let material = self.surfaces.get(index).and_then(|surface| self.materials.get(surface.material));
        material.is_some_and(|material| matches!(material.kind, MaterialKind::Diffuse { .. }))
    }
}
