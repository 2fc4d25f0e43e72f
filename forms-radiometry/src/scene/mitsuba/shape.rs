//! Shapes: parses `<shape>` into a surface with its material, its emission, and its receivers.

use super::bsdf::{Bsdf, Law};
use super::geometry::Geometry;
use super::media::Index;
use super::normals::SmoothMesh;
use super::object::Object;
use super::{Node, Reader};
use crate::scene::element::unique;
use crate::scene::model::{MaterialKind, Surface};
use crate::scene::value::NOT_NEGATIVE;

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

const OPAQUE_WITH_MEDIUM: &str = "an interior or exterior medium of an opaque surface is not supported";

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
            texture: None,
            place,
        };
        self.add_shape(&bsdf, geometry, surface);
    }

    /// Adds the surfaces of a shape with this material.
    fn add_shape(&mut self, bsdf: &Bsdf, geometry: Geometry, surface: Surface) {
        match &bsdf.law {
            Law::Checkered(board) if geometry.axes.is_some() => {
                let (pattern, most) = board.pattern(self.bands);
                let material = bsdf.material(self, MaterialKind::Diffuse { reflectance: most });
                self.textured(&pattern, geometry, Surface { material, ..surface });
            }
            Law::Checkered(board) => self.checkered((bsdf, board), &geometry, surface),
            Law::Textured(_, pattern) => self.textured(pattern, geometry, surface),
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
            Law::Opaque(kind) | Law::Textured(kind, _) => {
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
