//! Checkerboards: a texture of type `checkerboard` on a diffuse reflectance becomes geometry. The faces
//! of a shape are cut along the lines of the checkerboard, and the fields of each colour become a
//! surface.
//!
//! ```text
//! face, texture coordinates at its corners ─ triangles ─ cut at multiples of ½ ─▶ fields of two colours
//! ```
//! A field has the first colour if ⌊2u⌋ and ⌊2v⌋ are both even or both odd. Texture coordinates and
//! normals are linear on a triangle, so that nothing is approximated.

use super::bsdf::Bsdf;
use super::geometry::Geometry;
use super::normals::SmoothMesh;
use super::object::Object;
use super::{Node, Reader};
use crate::geometry::{Affine, Corners, FaceList, Mesh, Polygon, Vector};
use crate::scene::model::{Shape, Surface};
use crate::scene::texture::{Pattern, Picture};
use crate::scene::value::FRACTION;
use std::collections::HashMap;
use std::sync::Arc;

/// The largest number of fields of a shape.
const MOST_FIELDS: f64 = 1e6;

/// The names of the colours.
pub(super) const COLOURS: [&str; 2] = ["color0", "color1"];

/// A checkerboard.
#[derive(Clone, Debug)]
pub(super) struct Checkerboard {
    pub(super) colours: [Vec<f64>; 2],
    /// The map of texture coordinates, of which z is ignored.
    pub(super) to_uv: Affine,
}

/// The fields of one colour: a mesh, and its normals.
struct Fields {
    mesh: Arc<Mesh>,
    normals: Corners<Vector>,
}

/// A corner of a piece of a face.
#[derive(Clone, Copy)]
struct Corner {
    position: Vector,
    /// Texture coordinates, in fields.
    uv: [f64; 2],
    normal: Vector,
}

impl<'a> Reader<'a, '_, '_> {
    /// Takes the checkerboard that a property of an object is, or refers to.
    pub(super) fn take_checkerboard(&mut self, object: &mut Object<'a>, name: &str) -> Option<Checkerboard> {
        let texture = self.take_texture(object, name, &["checkerboard"])?;
        Some(self.checkerboard(texture))
    }

    pub(super) fn checkerboard(&mut self, node: Node<'a>) -> Checkerboard {
        let mut object = self.object(node);
        let mut colour = |name: &str, default: f64| {
            let colour = self.colour(&mut object, name, &FRACTION);
            colour.unwrap_or_else(|| vec![default; self.bands])
        };
        let colours = [colour(COLOURS[0], 0.4), colour(COLOURS[1], 0.2)];
        let to_uv = self.transform_named(&mut object, "to_uv");
        self.finish(object, &[COLOURS[0], COLOURS[1], "to_uv"]);
        Checkerboard { colours, to_uv }
    }
}

impl Reader<'_, '_, '_> {
    /// Adds a surface for each colour of a shape with a checkerboard.
    pub(super) fn checkered(
        &mut self,
        (bsdf, board): (&Bsdf, &Checkerboard),
        geometry: &Geometry,
        surface: Surface,
    ) {
        let both = match board.fields_of(geometry) {
            Ok(both) => both,
            Err(reason) => {
                self.without_coordinates(&surface, reason);
                return;
            }
        };
        for (colour, Fields { mesh, normals }) in both.into_iter().enumerate() {
            if mesh.faces().len() == 0 {
                continue;
            }
            let name = format!("{}/{}", surface.name, COLOURS[colour]);
            let material = bsdf.material_of_colour(self, board, colour);
            let smooth = geometry.smooth.as_ref().map(|smooth| SmoothMesh {
                file: smooth.file.clone(),
                place: smooth.place.clone(),
                normals,
                ..*smooth
            });
            let shape = Shape::Mesh(mesh);
            self.add_surface(Surface { name, material, shape, ..surface.clone() }, smooth);
        }
    }
}

impl Checkerboard {
    /// Returns the same checkerboard as a pattern, and its largest value in each band.
    pub(super) fn pattern(&self, bands: usize) -> (Arc<Pattern>, Vec<f64>) {
        let (pattern, most) =
            Pattern::new(Picture::Checkerboard(self.colours.clone()), self.to_uv, 0.0, bands);
        (Arc::new(pattern), most)
    }

    /// Returns the fields of each colour of a shape, or the reason why there are none.
    fn fields_of(&self, geometry: &Geometry) -> Result<[Fields; 2], &'static str> {
        let mesh = match &geometry.shape {
            Shape::Polygon(polygon) => Mesh::of_outlines([polygon.vertices()]).ok().map(Arc::new),
            Shape::Mesh(mesh) => Some(Arc::clone(mesh)),
            Shape::Sphere(_) | Shape::Disk(_) | Shape::Quadric(_) => None,
        };
        let mesh = mesh.ok_or("has no texture coordinates here")?;
        let no_normals = Corners::default();
        let normals = geometry.smooth.as_ref().map_or(&no_normals, |smooth| &smooth.normals);
        self.fields(&mesh, &geometry.texture, normals)
    }

    /// Returns the fields of each colour of a mesh with these texture coordinates and normals, or the
    /// reason why there are none.
    fn fields(
        &self,
        mesh: &Mesh,
        texture: &Corners<[f64; 2]>,
        normals: &Corners<Vector>,
    ) -> Result<[Fields; 2], &'static str> {
        let mut parts = [Pieces::default(), Pieces::default()];
        let mut count = 0.0;
        for (face, polygon) in mesh.polygons().enumerate() {
            let uv = texture.of(face).ok_or("has no texture coordinates")?;
            let own = normals.of(face).unwrap_or_else(|| vec![polygon.normal(); uv.len()]);
            let corner = |i: usize| Corner {
                position: polygon.vertices()[i],
                uv: self.in_fields(uv[i]),
                normal: own.get(i).copied().unwrap_or(polygon.normal()),
            };
            for last in 2..polygon.vertices().len().min(uv.len()) {
                let triangle = [0, last - 1, last].map(corner);
                count += extent(&triangle, 0) * extent(&triangle, 1);
                if count.is_nan() || count > MOST_FIELDS {
                    return Err("has too many fields of a checkerboard");
                }
                cut(&triangle, &mut parts);
            }
        }
        Ok(parts.map(Pieces::fields))
    }

    /// Returns texture coordinates in units of fields.
    fn in_fields(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        let [x, y, _] = self.to_uv.columns;
        let shift = self.to_uv.shift;
        [2.0 * (u * x.x + v * y.x + shift.x), 2.0 * (u * x.y + v * y.y + shift.y)]
    }
}

/// Returns the number of fields that a triangle can extend over along an axis.
fn extent(corners: &[Corner], axis: usize) -> f64 {
    let [least, most] = range(corners, axis);
    most.floor() - least.floor() + 1.0
}

fn range(corners: &[Corner], axis: usize) -> [f64; 2] {
    let along = || corners.iter().map(|corner| corner.uv[axis]);
    [along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max)]
}

/// Cuts a triangle into its fields, and adds each to its colour.
fn cut(triangle: &[Corner], parts: &mut [Pieces; 2]) {
    for (column, strip) in strips(triangle, 0) {
        for (row, field) in strips(&strip, 1) {
            let is_second = (column - row).rem_euclid(2.0) == 1.0;
            parts[usize::from(is_second)].add(&field);
        }
    }
}

/// Cuts a convex piece at the integers along an axis.
fn strips(piece: &[Corner], axis: usize) -> Vec<(f64, Vec<Corner>)> {
    let [least, most] = range(piece, axis);
    let (mut strips, mut start) = (Vec::new(), least.floor());
    while start < most || start == least {
        let within = clipped(&clipped(piece, axis, start, 1.0), axis, start + 1.0, -1.0);
        if within.len() > 2 {
            strips.push((start, within));
        }
        start += 1.0;
    }
    strips
}

/// Returns the part of a convex piece beyond a coordinate, in the direction of this sign.
fn clipped(piece: &[Corner], axis: usize, at: f64, sign: f64) -> Vec<Corner> {
    let mut kept = Vec::with_capacity(piece.len() + 1);
    for (i, a) in piece.iter().enumerate() {
        let b = &piece[(i + 1) % piece.len()];
        let [from, to] = [a, b].map(|corner| sign * (corner.uv[axis] - at));
        if from >= 0.0 {
            kept.push(*a);
        }
        if from * to < 0.0 {
            kept.push(between(a, b, axis, at));
        }
    }
    kept
}

/// Returns the corner at a coordinate between two corners. The result does not depend on their order,
/// so that neighbouring faces meet.
fn between(a: &Corner, b: &Corner, axis: usize, at: f64) -> Corner {
    let (a, b) = if a.uv[axis] < b.uv[axis] { (a, b) } else { (b, a) };
    let t = (at - a.uv[axis]) / (b.uv[axis] - a.uv[axis]);
    let mut uv = [0, 1].map(|axis| a.uv[axis] + t * (b.uv[axis] - a.uv[axis]));
    uv[axis] = at;
    Corner {
        position: a.position + t * (b.position - a.position),
        uv,
        normal: a.normal + t * (b.normal - a.normal),
    }
}

/// The pieces of one colour so far. Corners at one position are one vertex.
#[derive(Default)]
struct Pieces {
    vertices: Vec<Vector>,
    numbers: HashMap<[u64; 3], u32>,
    faces: FaceList,
    normals: Corners<Vector>,
}

impl Pieces {
    /// Adds a piece, unless it has no area.
    fn add(&mut self, piece: &[Corner]) {
        if Polygon::new(piece.iter().map(|corner| corner.position).collect()).is_err() {
            return;
        }
        let first = self.normals.values.len() as u32;
        self.normals.values.extend(piece.iter().map(|corner| corner.normal));
        self.normals.push(self.faces.len(), first..first + piece.len() as u32);
        let Self { vertices, numbers, .. } = self;
        let number = |corner: &Corner| {
            let key = corner.position.coordinates().map(f64::to_bits);
            *numbers.entry(key).or_insert_with(|| {
                vertices.push(corner.position);
                vertices.len() as u32 - 1
            })
        };
        self.faces.push(piece.iter().map(number));
    }

    fn fields(self) -> Fields {
        Fields { mesh: Arc::new(Mesh::of_polygons(self.vertices, self.faces)), normals: self.normals }
    }
}
