//! Shapes: parses `<shape>` into a surface with its material, its emission, and its receivers.

use super::bsdf::{Bsdf, Law};
use super::media::Index;
use super::normals::{self, SmoothMesh};
use super::object::Object;
use super::{Node, Reader};
use crate::geometry::{Affine, Corners, Disk, Mesh, MeshError, Polygon, Profile, Quadric, Sphere, Vector};
use crate::scene::element::unique;
use crate::scene::mesh_file::MeshFile;
use crate::scene::model::{MaterialKind, Shape, Surface};
use crate::scene::value::{Domain, LENGTH, NOT_NEGATIVE};
use std::sync::Arc;

const KINDS: [&str; 10] =
    ["rectangle", "cube", "sphere", "disk", "cylinder", "obj", "ply", "serialized", "shapegroup", "instance"];

const PARTS: [&str; 9] = [
    "to_world",
    "flip_normals",
    "bsdf",
    "emitter",
    "sensor",
    "medium",
    "filename",
    "face_normals",
    "shape_index",
];

/// Numbers of the meshes of a file.
const SHAPE_INDEX: Domain = Domain {
    expected: "an integer of at least 0",
    contains: |x| x.fract() == 0.0 && (0.0..=1e9).contains(&x),
};

const OPAQUE_WITH_MEDIUM: &str = "an interior or exterior medium of an opaque surface is not supported";

/// The geometry of a shape.
pub(super) struct Geometry {
    pub(super) shape: Shape,
    /// The texture coordinates at the corners of its polygon or mesh.
    pub(super) texture: Corners<[f64; 2]>,
    /// Its interpolated normals, if they are not those of its faces.
    pub(super) smooth: Option<SmoothMesh>,
}

impl Geometry {
    /// Returns the geometry of a shape without texture coordinates.
    fn of(shape: Shape) -> Self {
        Self { shape, texture: Corners::default(), smooth: None }
    }
}

impl<'a> Reader<'a, '_, '_> {
    /// Parses a top-level shape. The shapes of a group are read with its instances.
    pub(super) fn top_shape(&mut self, node: Node<'a>) {
        match &*self.kind(node) {
            "shapegroup" => {}
            "instance" => self.instance(node),
            _ => self.shape(node),
        }
    }

    pub(super) fn shape(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        let name = self.shape_name(&object);
        let geometry = self.geometry(&mut object);
        let emitter = self.take_object(&mut object, "emitter");
        let radiance = emitter.map(|emitter| self.area_emitter(emitter));
        let bsdf = match self.take_object(&mut object, "bsdf") {
            Some(bsdf) => Bsdf::read(self, bsdf),
            None => Bsdf::default(self.bands, radiance.is_some(), node.range()),
        };
        let material = self.material_of(&mut object, &bsdf);
        let radiance = radiance.unwrap_or_else(|| vec![0.0; self.bands]);
        self.check_sides(node, &bsdf, &radiance);
        self.own_sensor(&mut object, &bsdf, &name);
        let place = node.attribute_node("type").map_or(node.range(), |kind| kind.range_value());
        self.finish(object, &PARTS);
        let Some(geometry) = geometry else { return };
        if geometry.shape.has_no_faces() {
            self.report.note(format!("the shape `{name}` has no faces, and is left out"));
            return;
        }
        let place = self.report.place(place);
        let two_sided = bsdf.two_sided;
        let surface = Surface {
            name,
            material,
            shape: geometry.shape.clone(),
            radiance,
            exitance: None,
            two_sided,
            place,
        };
        match &bsdf.law {
            Law::Checkered(board) => self.checkered((&bsdf, board), &geometry, surface),
            // light passes a boundary without a change of index straight on, whatever its normal is
            Law::Null => self.surfaces.push(surface),
            _ => self.add_surface(surface, geometry.smooth),
        }
    }

    /// Parses the sensor of a shape.
    fn own_sensor(&mut self, object: &mut Object<'a>, bsdf: &Bsdf, name: &str) {
        let Some(sensor) = self.take_object(object, "sensor") else { return };
        if let Law::Checkered(_) = bsdf.law {
            let message = "an irradiance meter on a shape with a checkerboard is not supported";
            self.error(sensor, message, "a reflectance without a texture");
        }
        self.irradiance_meter(sensor, self.surfaces.len(), name);
    }

    /// Adds a surface, with the interpolated normals of its mesh.
    pub(super) fn add_surface(&mut self, surface: Surface, smooth: Option<SmoothMesh>) {
        let index = self.surfaces.len();
        self.smooth_meshes.extend(smooth.map(|smooth| SmoothMesh { surface: index, ..smooth }));
        self.surfaces.push(surface);
    }

    /// Returns the id of a shape, or a name made of a number; within an instance, after its name.
    fn shape_name(&mut self, object: &Object<'a>) -> String {
        let count = self.surfaces.len();
        let name = self.name(object, "shape", count);
        let Some(instance) = &self.instance else { return name };
        let name = format!("{}/{name}", instance.name);
        unique(&name, |taken| self.surfaces.iter().any(|surface| surface.name == taken))
    }

    /// Rejects two-sided emitters. In Mitsuba the back of a two-sided surface reflects but does not
    /// emit; here the back acts like the front.
    fn check_sides(&mut self, node: Node<'a>, bsdf: &Bsdf, radiance: &[f64]) {
        let emits = radiance.iter().any(|&radiance| radiance > 0.0);
        if bsdf.two_sided && emits {
            let message = "a two-sided surface that emits from one side only is not supported";
            self.error(node, message, "a bsdf that is not `twosided` for a shape with an emitter");
        }
    }

    /// Returns the material of a shape: its bsdf, with the media inside and outside the shape.
    fn material_of(&mut self, object: &mut Object<'a>, bsdf: &Bsdf) -> usize {
        let inside = self.named_medium(object, "interior");
        let outside = self.named_medium(object, "exterior");
        let node = object.node;
        let (index, n) = match &bsdf.law {
            Law::Opaque(kind) => {
                if inside.is_some() || outside.is_some() {
                    self.error(node, OPAQUE_WITH_MEDIUM, "a bsdf of type `dielectric` or `null`");
                }
                return bsdf.material(self, kind.clone());
            }
            Law::Dielectric { inside, outside, outside_place } => {
                (Index::Given(inside.to_bits()), Some((*outside, outside_place.clone())))
            }
            Law::Null => (Index::OfFront, None),
            Law::Checkered(_) => {
                if inside.is_some() || outside.is_some() {
                    self.error(node, OPAQUE_WITH_MEDIUM, "a bsdf of type `dielectric` or `null`");
                }
                return 0;
            }
            Law::Wrong => return 0,
        };
        if matches!(bsdf.law, Law::Null) && inside.is_none() {
            self.error(
                node,
                "a bsdf of type `null` without an interior medium has no effect",
                "an interior medium",
            );
        }
        let inside = self.filled(inside, index, node.range());
        self.boundary(node, inside, n, outside);
        bsdf.material(self, MaterialKind::Dielectric { inside })
    }

    /// Takes the medium named `interior` or `exterior`, and returns its number in the document.
    fn named_medium(&mut self, object: &mut Object<'a>, name: &str) -> Option<usize> {
        let node = object.take(name)?;
        let medium = self.resolved(node)?;
        if !medium.has_tag_name("medium") {
            let message = format!("`{name}` cannot be a `{}`", medium.tag_name().name());
            self.error(node, message, "`medium`");
            return None;
        }
        Some(self.medium(medium))
    }

    fn geometry(&mut self, object: &mut Object<'a>) -> Option<Geometry> {
        let own = self.transform(object);
        let to_world = self.instance.as_ref().map_or(own, |instance| instance.to_world.after(&own));
        let flipped = self.boolean(object, "flip_normals", false, false);
        match &*object.kind {
            "rectangle" => self.rectangle(object.node, &to_world, flipped),
            "cube" => self.moved(object.node, cube(), &to_world, flipped).map(Geometry::of),
            "sphere" => self.sphere(object, &to_world, flipped).map(Geometry::of),
            "disk" => self.disk(object.node, &to_world, flipped).map(Geometry::of),
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

    /// Returns the radiance of an area emitter.
    fn area_emitter(&mut self, node: Node<'a>) -> Vec<f64> {
        let mut object = self.object(node);
        if object.kind != "area" {
            self.unknown(&mut object, &["area"]);
            return vec![0.0; self.bands];
        }
        let radiance = self.required_colour(&mut object, "radiance", &NOT_NEGATIVE);
        self.finish(object, &["radiance"]);
        radiance
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
