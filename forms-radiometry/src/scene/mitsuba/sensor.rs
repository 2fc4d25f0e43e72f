//! Sensors: parses `<sensor>` into a camera or, within a shape, an irradiance receiver on that
//! shape.

use super::object::Object;
use super::{Node, Reader};
use crate::camera::Camera;
use crate::geometry::Vector;
use crate::scene::model::{Receiver, ReceiverKind};
use crate::scene::value::{FIELD_OF_VIEW, PIXELS};

/// Properties of films that do not affect the radiance of a pixel.
const FILM_IGNORED: [&str; 6] =
    ["file_format", "pixel_format", "component_format", "banner", "sample_border", "compensate"];

impl<'a> Reader<'a, '_, '_> {
    pub(super) fn sensor(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        if object.kind != "perspective" {
            self.unknown(&mut object, &["perspective"]);
            return;
        }
        let count = self.receivers.len();
        let name = self.name(&object, "sensor", count);
        let camera = self.camera(&mut object);
        let medium = self.take_object(&mut object, "medium").map(|medium| self.medium(medium));
        self.sensor_in(node, medium);
        object.take_tag("sampler");
        object.ignore(&["near_clip", "far_clip"]);
        self.finish(
            object,
            &["to_world", "fov", "fov_axis", "film", "sampler", "medium", "near_clip", "far_clip"],
        );
        let place = self.report.place(node.range());
        let receiver = |camera| Receiver { name, kind: ReceiverKind::Camera(camera), time: None, place };
        self.receivers.extend(camera.map(receiver));
    }

    /// Returns the camera. It looks along z with y upright; its field of view is horizontal unless
    /// `fov_axis` states otherwise.
    fn camera(&mut self, object: &mut Object<'a>) -> Option<Camera> {
        let node = object.node;
        let to_world = self.transform(object);
        if to_world.scale(3).is_none() || to_world.mirrors() {
            let message = "non-uniform scaling or reflection of a camera is not supported";
            self.error(node, message, "a rotation, a translation and uniform scaling");
            return None;
        }
        if !object.has("fov") {
            self.error(node, "this sensor has no `fov`", "a float in degrees");
        }
        let fov = self.float(object, "fov", 90.0, &FIELD_OF_VIEW);
        let axis = self.string(object, "fov_axis");
        let resolution = self.film(object)?;
        let [width, height] = resolution.map(|side| side as f64);
        let half = (0.5 * fov.to_radians()).tan();
        let half_height = match axis.as_ref().map_or("x", |(axis, _)| axis) {
            "x" => half * height / width,
            "y" => half,
            "diagonal" => half * height / width.hypot(height),
            "smaller" => half * height / width.min(height),
            "larger" => half * height / width.max(height),
            other => {
                let (message, place) =
                    (format!("`fov_axis` cannot be `{other}`"), axis.clone().map_or(0..0, |a| a.1));
                self.report.error(place, message, "`x`, `y`, `diagonal`, `smaller` or `larger`");
                return None;
            }
        };
        let [origin, up, forward] = [
            to_world.point(Vector::default()),
            to_world.vector(Vector::new(0.0, 1.0, 0.0)),
            to_world.vector(Vector::new(0.0, 0.0, 1.0)),
        ];
        Camera::looking(origin, forward, up, 2.0 * half_height.atan().to_degrees(), resolution)
    }

    /// Returns the resolution of a film; the default is 768 × 576.
    fn film(&mut self, object: &mut Object<'a>) -> Option<[usize; 2]> {
        let Some(node) = object.take_tag("film") else { return Some([768, 576]) };
        let mut film = self.object(node);
        if film.kind != "hdrfilm" {
            self.unknown(&mut film, &["hdrfilm"]);
            return None;
        }
        let width = self.float(&mut film, "width", 768.0, &PIXELS);
        let height = self.float(&mut film, "height", 576.0, &PIXELS);
        film.take_tag("rfilter");
        film.ignore(&FILM_IGNORED);
        self.finish(film, &["width", "height", "rfilter"]);
        Some([width as usize, height as usize])
    }

    /// Adds a receiver for the mean irradiance of a shape.
    pub(super) fn irradiance_meter(&mut self, node: Node<'a>, surface: usize, shape: &str) {
        let mut object = self.object(node);
        if object.kind != "irradiancemeter" {
            self.unknown(&mut object, &["irradiancemeter"]);
            return;
        }
        let name = self.name(&object, &format!("irradiance of {shape}"), 0);
        let film = self.film(&mut object);
        if film.is_some_and(|resolution| resolution != [1, 1]) {
            self.error(
                node,
                "an irradiance meter with more than one pixel is not supported",
                "a film of 1 × 1",
            );
        }
        object.take_tag("sampler");
        self.finish(object, &["film", "sampler"]);
        let place = self.report.place(node.range());
        let kind = ReceiverKind::Surface { surface, grid: None };
        self.receivers.push(Receiver { name, kind, time: None, place });
    }
}
