//! Geometry: parses the type of a `<shape>`, with its transform, into a polygon, a mesh or a round shape,
//! with texture coordinates and normals.

use super::normals::{self, SmoothMesh};
use super::object::Object;
use super::{Node, Reader};
use crate::geometry::{Affine, Corners, Disk, Mesh, MeshError, Polygon, Profile, Quadric, Sphere, Vector};
use crate::scene::mesh_file::MeshFile;
use crate::scene::model::Shape;
use crate::scene::value::{Domain, LENGTH};
use std::sync::Arc;

const KINDS: [&str; 10] =
    ["rectangle", "cube", "sphere", "disk", "cylinder", "obj", "ply", "serialized", "shapegroup", "instance"];

/// Numbers of the meshes of a file.
const SHAPE_INDEX: Domain = Domain {
    expected: "an integer of at least 0",
    contains: |x| x.fract() == 0.0 && (0.0..=1e9).contains(&x),
};

/// The texture coordinates at the corners of each face of the cube, of those at the corners of a texture.
const TEXTURE_OF_CUBE: [[u32; 4]; 6] =
    [[2, 3, 0, 1], [3, 0, 1, 2], [3, 0, 1, 2], [1, 2, 3, 0], [3, 0, 1, 2], [0, 1, 2, 3]];

/// The geometry of a shape.
pub(super) struct Geometry {
    pub(super) shape: Shape,
    /// The texture coordinates at the corners of its polygon or mesh.
    pub(super) texture: Corners<[f64; 2]>,
    /// Its interpolated normals, if they are not those of its faces.
    pub(super) smooth: Option<SmoothMesh>,
    /// The unit axes of a sphere or a disk, by which it has texture coordinates.
    pub(super) axes: Option<[Vector; 3]>,
}

impl Geometry {
    /// Returns the geometry of a shape without texture coordinates.
    fn of(shape: Shape) -> Self {
        Self { shape, texture: Corners::default(), smooth: None, axes: None }
    }
}

impl Geometry {
    /// Returns the geometry of a sphere or a disk.
    fn round(shape: Shape, to_world: &Affine) -> Self {
        let unit = |axis: Vector| axis.unit().unwrap_or_default();
        Self { axes: Some(to_world.columns.map(unit)), ..Self::of(shape) }
    }
}

impl<'a> Reader<'a, '_, '_> {
    /// Returns the geometry of a shape.
    pub(super) fn geometry(&mut self, object: &mut Object<'a>) -> Option<Geometry> {
        let own = self.transform(object);
        let to_world = self.instance.as_ref().map_or(own, |instance| instance.to_world.after(&own));
        let flipped = self.boolean(object, "flip_normals", false, false);
        match &*object.kind {
            "rectangle" => self.rectangle(object.node, &to_world, flipped),
            "cube" => {
                let shape = self.moved(object.node, cube(), &to_world, flipped);
                shape.map(|shape| Geometry { texture: texture_of_cube(flipped), ..Geometry::of(shape) })
            }
            "sphere" => {
                self.sphere(object, &to_world, flipped).map(|shape| Geometry::round(shape, &to_world))
            }
            "disk" => {
                self.disk(object.node, &to_world, flipped).map(|shape| Geometry::round(shape, &to_world))
            }
            "cylinder" => self.cylinder(object, &to_world, flipped).map(Geometry::of),
            "obj" | "ply" | "serialized" => self.mesh(object, &to_world, flipped),
            _ => {
                self.unknown(object, &KINDS);
                None
            }
        }
    }

    /// Returns the square [−1, 1]² of the plane z = 0, seen from above. Its normal is transformed
    /// by the inverse transpose of the transform, so a reflection keeps its front on the same side.
    fn rectangle(&mut self, node: Node<'a>, to_world: &Affine, flipped: bool) -> Option<Geometry> {
        let mut corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        if flipped != to_world.mirrors() {
            corners.reverse();
        }
        let vertices = corners.map(|(x, y)| to_world.point(Vector::new(x, y, 0.0))).to_vec();
        let mut texture = Corners {
            values: corners.map(|(x, y)| [0.5 + 0.5 * x, 0.5 + 0.5 * y]).to_vec(),
            ..Corners::default()
        };
        texture.push(0, 0..4);
        let polygon =
            Polygon::new(vertices).map_err(|error| self.error(node, error.to_string(), "a rectangle"));
        polygon.ok().map(|polygon| Geometry { texture, ..Geometry::of(Shape::Polygon(polygon)) })
    }

    fn sphere(&mut self, object: &mut Object<'a>, to_world: &Affine, flipped: bool) -> Option<Shape> {
        let center = self.vector(object, "center").unwrap_or_default();
        let radius = self.float(object, "radius", 1.0, &LENGTH);
        let Some(scale) = to_world.scale(3) else {
            let message = "non-uniform scaling of a sphere is not supported";
            self.error(object.node, message, "uniform scaling");
            return None;
        };
        Some(Shape::Sphere(Sphere {
            center: to_world.point(center),
            radius: scale * radius,
            inward: flipped,
        }))
    }

    /// Returns the unit disk of the plane z = 0, seen from above.
    fn cylinder(&mut self, object: &mut Object<'a>, to_world: &Affine, inward: bool) -> Option<Shape> {
        let ends = ["p0", "p1"].map(|key| self.vector(object, key));
        let ends = [ends[0].unwrap_or_default(), ends[1].unwrap_or(Vector::new(0.0, 0.0, 1.0))];
        let radius = self.float(object, "radius", 1.0, &LENGTH);
        let Some(scale) = to_world.scale(3) else {
            let message = "non-uniform scaling of a cylinder is not supported";
            self.error(object.node, message, "uniform scaling");
            return None;
        };
        if ends[0] == ends[1] {
            self.error(
                object.node,
                "both ends of the cylinder are the same point",
                "`p0` and `p1` that differ",
            );
            return None;
        }
        let ends = ends.map(|end| to_world.point(end));
        let radii = [scale * radius; 2];
        Some(Shape::Quadric(Quadric { ends, radii, profile: Profile::Straight, inward }))
    }

    fn disk(&mut self, node: Node<'a>, to_world: &Affine, flipped: bool) -> Option<Shape> {
        let [u, v] =
            [Vector::new(1.0, 0.0, 0.0), Vector::new(0.0, 1.0, 0.0)].map(|axis| to_world.vector(axis));
        let (Some(radius), Some(normal)) = (to_world.scale(2), u.cross(v).unit()) else {
            let message = "non-uniform scaling of a disk is not supported";
            self.error(node, message, "uniform scaling in the plane of the disk");
            return None;
        };
        let normal = if flipped == to_world.mirrors() { normal } else { -normal };
        Some(Shape::Disk(Disk { center: to_world.point(Vector::default()), normal, radius, hole: 0.0 }))
    }

    fn mesh(&mut self, object: &mut Object<'a>, to_world: &Affine, flipped: bool) -> Option<Geometry> {
        let node = object.node;
        let has_flat_faces = self.boolean(object, "face_normals", false, true);
        let flips_texture = self.boolean(object, "flip_tex_coords", object.kind == "obj", false);
        let (file, name) = self.mesh_file(object)?;
        let shape = match *to_world == Affine::IDENTITY && !flipped {
            true => Shape::Mesh(Arc::clone(&file.mesh)),
            false => self.moved(node, Ok((*file.mesh).clone()), to_world, flipped)?,
        };
        let mut geometry = Geometry::of(shape);
        let Shape::Mesh(mesh) = &geometry.shape else { return None };
        geometry.texture = texture(&file, flips_texture, flipped);
        if !has_flat_faces {
            let normals = normals::of_corners(&file, mesh, to_world, flipped);
            let angle = normals::largest_angle(mesh, &normals);
            let (place, surface) = (node.range(), self.surfaces.len());
            geometry.smooth =
                (angle > 0.0).then_some(SmoothMesh { file: name, place, surface, normals, angle });
        }
        Some(geometry)
    }

    /// Returns the mesh file of a shape, and its name.
    fn mesh_file(&mut self, object: &mut Object<'a>) -> Option<(MeshFile, String)> {
        let is_serialized = object.kind == "serialized";
        let number = if is_serialized { self.float(object, "shape_index", 0.0, &SHAPE_INDEX) } else { 0.0 };
        let Some((name, place)) = self.string(object, "filename") else {
            self.error(
                object.node,
                format!("this shape of type `{}` has no `filename`", object.kind),
                "a string",
            );
            return None;
        };
        if !name.to_lowercase().ends_with(&format!(".{}", object.kind)) {
            self.report.error(
                place,
                format!("`{name}` does not have the extension `.{}` of the shape type", object.kind),
                "a file and a shape of the same type",
            );
            return None;
        }
        let file = match is_serialized {
            true => self.files.serialized(self.report, place, &name, number as usize)?,
            false => self.files.file(self.report, place, &name)?,
        };
        Some((file, name))
    }

    fn moved(
        &mut self,
        node: Node<'a>,
        mesh: Result<Mesh, Vec<MeshError>>,
        to_world: &Affine,
        flipped: bool,
    ) -> Option<Shape> {
        if to_world.mirrors() {
            let message = "a transform with reflection would turn this shape inside out";
            self.error(node, message, "a transform without reflection, or `flip_normals`");
            return None;
        }
        match mesh.and_then(|mesh| mesh.moved(flipped, |v| to_world.point(v))) {
            Ok(mesh) => Some(Shape::Mesh(Arc::new(mesh))),
            Err(errors) => {
                for error in errors.iter().take(1) {
                    self.error(
                        node,
                        format!("after its transform, {error}"),
                        "a transform that keeps the faces planar",
                    );
                }
                None
            }
        }
    }
}

/// Returns the texture coordinates at the corners of a mesh, whose faces are reversed if it is flipped.
fn texture(file: &MeshFile, is_turned: bool, flipped: bool) -> Corners<[f64; 2]> {
    let turned = |&[u, v]: &[f64; 2]| if is_turned { [u, 1.0 - v] } else { [u, v] };
    let values = file.texture.values.iter().map(turned).collect();
    let mut texture = Corners { values, ..Corners::default() };
    for face in 0..file.mesh.faces().len() {
        texture.push(face, normals::in_order(file.texture.indices_of(face), flipped));
    }
    texture
}

/// Returns the cube [−1, 1]³, with its faces outwards.
fn cube() -> Result<Mesh, Vec<MeshError>> {
    let corner = |i: u32| {
        let at = |axis: u32| if i >> axis & 1 == 1 { 1.0 } else { -1.0 };
        Vector::new(at(0), at(1), at(2))
    };
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    Mesh::new((0..8).map(corner).collect(), &faces.map(|face| face.to_vec()))
}

/// Returns the texture coordinates of the cube: each face shows the whole texture, as in Mitsuba.
fn texture_of_cube(flipped: bool) -> Corners<[f64; 2]> {
    let values = vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]];
    let mut texture = Corners { values, ..Corners::default() };
    for (face, corners) in TEXTURE_OF_CUBE.iter().enumerate() {
        texture.push(face, normals::in_order(corners, flipped));
    }
    texture
}
