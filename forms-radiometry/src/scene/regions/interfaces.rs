//! Sheets: splits every surface into faces with two sides; coincident vertices are shared.

use super::boundary::boundary;
use crate::geometry::{Disk, Mesh, Polygon, Quadric, Sphere, Vector, Welded, closeness};
use crate::scene::model::{Scene, Shape, Surface};
use std::iter::once;

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
pub(crate) fn sheets_without_edges(scene: &Scene) -> impl Iterator<Item = Interface> {
    let are_measured = scene.are_faces_measured();
    sheets(scene, move |surface, mesh| match are_measured[surface] {
        true => Box::new(mesh.polygons()),
        false => Box::new(mesh.flat_parts()),
    })
}

/// The polygons of a mesh, one at a time: there can be millions.
type Polygons<'m> = Box<dyn Iterator<Item = Polygon> + 'm>;

/// Returns the sheets of a scene, with these polygons of meshes. Their faces have no edges yet.
fn sheets<'s>(
    scene: &'s Scene,
    polygons: impl Fn(usize, &'s Mesh) -> Polygons<'s>,
) -> impl Iterator<Item = Interface> {
    let face = |polygon| Piece::Face(polygon, Vec::new());
    let of_surface = move |(surface, Surface { shape, .. }): (usize, &'s Surface)| {
        let pieces: Box<dyn Iterator<Item = Piece>> = match shape {
            Shape::Polygon(polygon) => Box::new(once(face(polygon.clone()))),
            Shape::Mesh(mesh) => Box::new(polygons(surface, mesh).map(face)),
            Shape::Sphere(sphere) => Box::new(once(Piece::Sphere(*sphere))),
            Shape::Disk(disk) => Box::new(once(Piece::Disk(*disk))),
            Shape::Quadric(quadric) => Box::new(once(Piece::Quadric(*quadric))),
        };
        pieces.enumerate().map(move |(part, shape)| Interface { surface, part, shape })
    };
    scene.surfaces.iter().enumerate().flat_map(of_surface)
}

/// Returns the sheets of a scene, and the numbered vertices of their faces.
pub(crate) fn interfaces(scene: &Scene) -> (Vec<Interface>, Vec<Vector>) {
    let mut interfaces: Vec<Interface> = sheets(scene, |_, mesh| Box::new(mesh.polygons())).collect();
    let polygons = interfaces.iter().filter_map(|interface| match &interface.shape {
        Piece::Face(polygon, _) => Some(polygon),
        Piece::Sphere(_) | Piece::Disk(_) | Piece::Quadric(_) => None,
    });
    let mut welded = Welded::new(closeness(polygons.flat_map(Polygon::vertices).copied()));
    for interface in &mut interfaces {
        if let Piece::Face(polygon, edges) = &mut interface.shape {
            let mut numbers =
                |outline: &[Vector]| outline.iter().map(|&v| welded.number(v) as usize).collect();
            let outline: Vec<usize> = numbers(polygon.vertices());
            let holes: Vec<Vec<usize>> = polygon.holes().iter().map(|hole| numbers(hole)).collect();
            *edges = boundary(&outline, &holes, &welded.vertices);
        }
    }
    (interfaces, welded.vertices)
}
