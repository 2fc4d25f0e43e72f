//! Sheets: splits every surface into faces with two sides; coincident vertices are shared.

use super::boundary::boundary;
use crate::geometry::{Disk, Mesh, Polygon, Quadric, Sphere, Vector, Welded, closeness};
use crate::scene::model::{Scene, Shape};

/// A piece of a surface.
pub(crate) struct Interface {
    /// The index of its surface.
    pub(crate) surface: usize,
    /// The index of the face of a mesh, where receivers measure these faces.
    pub(crate) part: usize,
    pub(crate) shape: Piece,
}

/// The shape of a sheet.
pub(crate) enum Piece {
    /// A polygon, and its edges as vertex numbers, including those around its holes. Its inside is
    /// on the left of each edge.
    Face(Polygon, Vec<[usize; 2]>),
    Sphere(Sphere),
    Disk(Disk),
    Quadric(Quadric),
}

/// A side of a sheet, or the outside of the whole scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    Front(usize),
    Back(usize),
    Outside,
}

impl Interface {
    /// Returns the disk, if the sheet is one. No other sheet can share its rim.
    pub(crate) fn disk(&self) -> Option<&Disk> {
        if let Piece::Disk(disk) = &self.shape { Some(disk) } else { None }
    }

    /// Returns the disks that were cut out of the sheet.
    pub(crate) fn round_holes(&self) -> &[Disk] {
        if let Piece::Face(polygon, _) = &self.shape { polygon.round_holes() } else { &[] }
    }
}

/// Returns the sheets of a scene in which nothing asks for their edges: each flat part of a mesh is
/// one sheet, or each face where receivers measure these.
pub(crate) fn sheets_without_edges(scene: &Scene) -> Vec<Interface> {
    let are_measured = scene.are_faces_measured();
    sheets(scene, |surface, mesh| match are_measured[surface] {
        true => mesh.polygons().collect(),
        false => mesh.flat_parts().collect(),
    })
}

/// Returns the sheets of a scene, with these polygons of meshes. Their faces have no edges yet.
fn sheets(scene: &Scene, polygons: impl Fn(usize, &Mesh) -> Vec<Polygon>) -> Vec<Interface> {
    let mut pieces = Vec::new();
    for (surface, shape) in scene.surfaces.iter().map(|surface| &surface.shape).enumerate() {
        match shape {
            Shape::Polygon(polygon) => pieces.push((surface, 0, Piece::Face(polygon.clone(), Vec::new()))),
            Shape::Mesh(mesh) => {
                let faces = polygons(surface, mesh).into_iter().enumerate();
                pieces.extend(faces.map(|(part, polygon)| (surface, part, Piece::Face(polygon, Vec::new()))));
            }
            Shape::Sphere(sphere) => pieces.push((surface, 0, Piece::Sphere(*sphere))),
            Shape::Disk(disk) => pieces.push((surface, 0, Piece::Disk(*disk))),
            Shape::Quadric(quadric) => pieces.push((surface, 0, Piece::Quadric(*quadric))),
        }
    }
    pieces.into_iter().map(|(surface, part, shape)| Interface { surface, part, shape }).collect()
}

/// Returns the sheets of a scene, and the numbered vertices of their faces.
pub(crate) fn interfaces(scene: &Scene) -> (Vec<Interface>, Vec<Vector>) {
    let mut interfaces = sheets(scene, |_, mesh| mesh.polygons().collect());
    let polygons = interfaces.iter().filter_map(|interface| match &interface.shape {
        Piece::Face(polygon, _) => Some(polygon),
        Piece::Sphere(_) | Piece::Disk(_) | Piece::Quadric(_) => None,
    });
    let mut welded = Welded::new(closeness(polygons.flat_map(Polygon::vertices).copied()));
    for interface in &mut interfaces {
        if let Piece::Face(polygon, edges) = &mut interface.shape {
            let mut numbers = |outline: &[Vector]| outline.iter().map(|&v| welded.number(v)).collect();
            let outline: Vec<usize> = numbers(polygon.vertices());
            let holes: Vec<Vec<usize>> = polygon.holes().iter().map(|hole| numbers(hole)).collect();
            *edges = boundary(&outline, &holes, &welded.vertices);
        }
    }
    (interfaces, welded.vertices)
}
