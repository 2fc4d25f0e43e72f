//! Emitters of the scene: parses `<emitter>` into a point light, a spot light, a distant light, or
//! light from outside.

use super::object::Object;
use super::{Node, Reader};
use crate::geometry::{Affine, Vector};
use crate::scene::cone::Cone;
use crate::scene::environment_map::EnvironmentMap;
use crate::scene::light::{BEAM_PART, HALF_ANGLE, WIDE_BEAM};
use crate::scene::model::{Light, LightKind};
use crate::scene::value::NOT_NEGATIVE;

/// Properties of emitters outside shapes.
const KNOWN: [&str; 10] = [
    "to_world",
    "position",
    "intensity",
    "direction",
    "irradiance",
    "radiance",
    "filename",
    "scale",
    "cutoff_angle",
    "beam_width",
];
const KINDS: [&str; 5] = ["point", "spot", "directional", "constant", "envmap"];

impl<'a> Reader<'a, '_, '_> {
    pub(super) fn emitter(&mut self, node: Node<'a>) {
        if self.kind(node) == "area" {
            self.shared_emitter(node);
            return;
        }
        let mut object = self.object(node);
        self.placed_once(&object);
        let to_world = self.transform(&mut object);
        let mut cone = None;
        let kind = match &*object.kind {
            "point" => Some(self.point(&mut object, &to_world)),
            "spot" => {
                cone = self.cone(&mut object, &to_world);
                let position = to_world.point(Vector::default());
                let intensity = self.required_colour(&mut object, "intensity", &NOT_NEGATIVE);
                cone.map(|_| LightKind::Point { position, intensity })
            }
            "directional" => self.directional(&mut object, &to_world),
            "constant" => {
                self.constant(&mut object);
                None
            }
            "envmap" => {
                self.environment(&mut object, &to_world);
                None
            }
            _ => {
                self.unknown(&mut object, &KINDS);
                return;
            }
        };
        let name = node.attribute("id").unwrap_or_default().to_owned();
        self.finish(object, &KNOWN);
        let place = self.report.place(node.range());
        self.lights.extend(kind.map(|kind| Light { name, kind, cone, place }));
    }

    fn point(&mut self, object: &mut Object<'a>, to_world: &Affine) -> LightKind {
        let position = self.vector(object, "position");
        let position = position.unwrap_or_else(|| to_world.point(Vector::default()));
        let intensity = self.required_colour(object, "intensity", &NOT_NEGATIVE);
        LightKind::Point { position, intensity }
    }

    /// Returns the cone of a spot light, which shines along z.
    fn cone(&mut self, object: &mut Object<'a>, to_world: &Affine) -> Option<Cone> {
        let cutoff = self.float(object, "cutoff_angle", 20.0, &HALF_ANGLE);
        let beam = self.float(object, "beam_width", BEAM_PART * cutoff, &HALF_ANGLE);
        if let Some(texture) = object.take("texture") {
            self.texture(texture);
        }
        if beam > cutoff {
            self.error(object.node, WIDE_BEAM, "a `beam_width` up to `cutoff_angle`");
            return None;
        }
        if to_world.scale(3).is_none() {
            let message = "non-uniform scaling of a spot light is not supported";
            self.error(object.node, message, "a rotation and a translation");
            return None;
        }
        let axis = to_world.vector(Vector::new(0.0, 0.0, 1.0)).unit()?;
        Some(Cone { axis, beam: beam.to_radians(), cutoff: cutoff.to_radians() })
    }

    fn directional(&mut self, object: &mut Object<'a>, to_world: &Affine) -> Option<LightKind> {
        let direction = self.vector(object, "direction");
        let direction = direction.unwrap_or_else(|| to_world.vector(Vector::new(0.0, 0.0, 1.0)));
        let irradiance = self.required_colour(object, "irradiance", &NOT_NEGATIVE);
        let Some(direction) = direction.unit() else {
            self.error(object.node, "the direction has length zero", "a vector with a direction");
            return None;
        };
        Some(LightKind::Distant { direction, irradiance })
    }

    /// Checks that a shape refers to an area emitter outside all shapes, which is read there.
    fn shared_emitter(&mut self, node: Node<'a>) {
        let id = node.attribute("id");
        let refers = |other: Node| other.has_tag_name("ref") && other.attribute("id") == id;
        if id.is_none() || !node.document().descendants().any(refers) {
            self.error(node, "this area emitter belongs to no shape", "a shape with a `ref` to its id");
        }
    }

    /// Checks that the position or direction and the transform are not both given.
    fn placed_once(&mut self, object: &Object<'a>) {
        for key in ["position", "direction"] {
            if object.has(key) && object.has("to_world") {
                let message = format!("this emitter has both `{key}` and `to_world`");
                self.error(object.node, message, "one of the two");
            }
        }
    }

    /// Reads light from outside. Its radiance is 1 by default, as in Mitsuba.
    fn constant(&mut self, object: &mut Object<'a>) {
        let one = vec![1.0; self.bands];
        let radiance = self.colour(object, "radiance", &NOT_NEGATIVE).unwrap_or(one);
        self.set_outside(object, radiance, None);
    }

    /// Sets the radiance from outside: with a map, the largest from any direction.
    pub(super) fn set_outside(
        &mut self,
        object: &Object<'a>,
        radiance: Vec<f64>,
        map: Option<EnvironmentMap>,
    ) {
        if self.outside.replace((radiance, map)).is_some() {
            self.error(object.node, "more than one emitter of type `constant` or `envmap`", "one");
        }
        self.ambient_place = object.node.range();
    }
}
