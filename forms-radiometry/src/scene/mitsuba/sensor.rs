//! Sensors: parses `<sensor>` into a camera or, within a shape, an irradiance receiver on that
//! shape.

use super::object::Object;
use super::{Node, Reader};
use crate::camera::Camera;
use crate::geometry::Vector;
use crate::scene::model::{Receiver, ReceiverKind, SurfaceSide};
use crate::scene::value::{ANY, FIELD_OF_VIEW, PIXELS, one_of};

/// Properties of cameras that do not affect the radiance of a pixel: nothing is clipped, everything
/// is in focus and nothing moves.
const IGNORED: [&str; 5] = ["near_clip", "far_clip", "focus_distance", "shutter_open", "shutter_close"];
/// Properties of films that do not affect the radiance of a pixel.
const FILM_IGNORED: [&str; 6] =
    ["file_format", "pixel_format", "component_format", "banner", "sample_border", "compensate"];

/// Direction of the film in which a field of view is measured.
#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Diagonal,
    Smaller,
    Larger,
}

impl Axis {
    const ALL: [(&str, Self); 5] = [
        ("x", Self::X),
        ("y", Self::Y),
        ("diagonal", Self::Diagonal),
        ("smaller", Self::Smaller),
        ("larger", Self::Larger),
    ];
}

struct FieldOfView {
    /// The tangent of half of the angle.
    half: f64,
    axis: Axis,
}

impl FieldOfView {
    /// Returns the tangent of half of the vertical field of view of a film.
    fn half_height(&self, [width, height]: [f64; 2]) -> f64 {
        let side = match self.axis {
            Axis::X => width,
            Axis::Y => height,
            Axis::Diagonal => width.hypot(height),
            Axis::Smaller => width.min(height),
            Axis::Larger => width.max(height),
        };
        self.half * height / side
    }
}

impl<'a> Reader<'a, '_, '_> {
    pub(super) fn sensor(&mut self, node: Node<'a>) {
        let mut object = self.object(node);
        if !matches!(&*object.kind, "perspective" | "orthographic") {
            self.unknown(&mut object, &["perspective", "orthographic"]);
            return;
        }
        let count = self.receivers.len();
        let name = self.name(&object, "sensor", count);
        let camera = match &*object.kind {
            "orthographic" => self.orthographic(&mut object),
            _ => self.camera(&mut object),
        };
        let medium = self.take_object(&mut object, "medium").map(|medium| self.medium(medium));
        self.sensor_in(node, medium);
        self.take_object(&mut object, "sampler");
        object.ignore(&IGNORED);
        self.finish(
            object,
            &[
                "to_world",
                "fov",
                "fov_axis",
                "focal_length",
                "film",
                "sampler",
                "medium",
                "near_clip",
                "far_clip",
            ],
        );
        let place = self.report.place(node.range());
        let receiver = |camera| Receiver { name, kind: ReceiverKind::Camera(camera), time: None, place };
        self.receivers.extend(camera.map(receiver));
    }

    /// Returns the camera. It looks along z with y upright.
    fn camera(&mut self, object: &mut Object<'a>) -> Option<Camera> {
        let node = object.node;
        let to_world = self.transform(object);
        if to_world.scale(3).is_none() || to_world.mirrors() {
            let message = "non-uniform scaling or reflection of a camera is not supported";
            self.error(node, message, "a rotation, a translation and uniform scaling");
            return None;
        }
        let view = self.field_of_view(object);
        for offset in ["principal_point_offset_x", "principal_point_offset_y"] {
            if self.float(object, offset, 0.0, &ANY) != 0.0 {
                self.error(node, format!("a `{offset}` other than 0 is not supported"), "0");
            }
        }
        let resolution = self.film(object)?;
        let half_height = view?.half_height(resolution.map(|side| side as f64));
        let [origin, up, forward] = [
            to_world.point(Vector::default()),
            to_world.vector(Vector::new(0.0, 1.0, 0.0)),
            to_world.vector(Vector::new(0.0, 0.0, 1.0)),
        ];
        Camera::looking(origin, forward, up, 2.0 * half_height.atan().to_degrees(), resolution)
    }

    /// Returns the orthographic camera. Its picture shows the coordinates from −1 to 1 along x, and as
    /// much along y as the shape of the film tells. Scaling along z has no effect.
    fn orthographic(&mut self, object: &mut Object<'a>) -> Option<Camera> {
        let to_world = self.transform(object);
        let [right, up, forward] = to_world.columns;
        let is_upright = forward.unit().is_some_and(|forward| {
            let is_across = |axis: Vector| forward.dot(axis).abs() <= 1e-6 * axis.length();
            is_across(right) && is_across(up)
        });
        let Some(scale) = to_world.scale(2).filter(|_| is_upright && !to_world.mirrors()) else {
            let message = "non-uniform scaling or reflection of a camera is not supported";
            self.error(object.node, message, "a rotation, a translation and uniform scaling");
            return None;
        };
        let resolution = self.film(object)?;
        Camera::orthographic(to_world.shift, forward, up, 2.0 * scale, resolution)
    }

    /// Returns the field of view: from `fov`, which is horizontal unless `fov_axis` states
    /// otherwise, or from the focal length, 50 mm by default, for film of 36 mm × 24 mm.
    fn field_of_view(&mut self, object: &mut Object<'a>) -> Option<FieldOfView> {
        if !object.has("fov") {
            let focal_length = self.focal_length(object)?;
            return Some(FieldOfView { half: 0.5 * 36_f64.hypot(24.0) / focal_length, axis: Axis::Diagonal });
        }
        if object.has("focal_length") {
            let message = "this sensor has both `fov` and `focal_length`";
            self.error(object.node, message, "one of the two");
            object.ignore(&["focal_length"]);
        }
        let fov = self.float(object, "fov", 90.0, &FIELD_OF_VIEW);
        let axis = match self.string(object, "fov_axis") {
            None => Axis::X,
            Some((axis, place)) => match Axis::ALL.iter().find(|(name, _)| *name == axis.to_lowercase()) {
                Some(&(_, axis)) => axis,
                None => {
                    let expected = one_of(Axis::ALL.iter().map(|(name, _)| *name));
                    self.report.error(place, format!("`fov_axis` cannot be `{axis}`"), expected);
                    return None;
                }
            },
        };
        Some(FieldOfView { half: (0.5 * fov.to_radians()).tan(), axis })
    }

    /// Returns the focal length in mm.
    fn focal_length(&mut self, object: &mut Object<'a>) -> Option<f64> {
        let Some((text, place)) = self.string(object, "focal_length") else { return Some(50.0) };
        let number = text.trim_end_matches("mm").trim().parse::<f64>().ok();
        let length = number.filter(|&length| length > 0.0 && length.is_finite());
        if length.is_none() {
            let message = format!("`focal_length` cannot be `{text}`");
            self.report.error(place, message, "a length in mm, such as `50mm`");
        }
        length
    }

    /// Returns the resolution of a film; the default is 768 × 576.
    fn film(&mut self, object: &mut Object<'a>) -> Option<[usize; 2]> {
        let Some(node) = self.take_object(object, "film") else { return Some([768, 576]) };
        let mut film = self.object(node);
        if film.kind != "hdrfilm" {
            self.unknown(&mut film, &["hdrfilm"]);
            return None;
        }
        let width = self.float(&mut film, "width", 768.0, &PIXELS);
        let height = self.float(&mut film, "height", 576.0, &PIXELS);
        let window =
            [("crop_offset_x", 0.0), ("crop_offset_y", 0.0), ("crop_width", width), ("crop_height", height)];
        for (name, whole) in window {
            if self.float(&mut film, name, whole, &ANY) != whole {
                self.error(
                    node,
                    format!("`{name}` selects a part of the film, which is not supported"),
                    format!("{whole}"),
                );
            }
        }
        self.take_object(&mut film, "rfilter");
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
        self.take_object(&mut object, "sampler");
        self.finish(object, &["film", "sampler"]);
        let place = self.report.place(node.range());
        let kind = ReceiverKind::Surface { surface, side: SurfaceSide::Front, grid: None };
        self.receivers.push(Receiver { name, kind, time: None, place });
    }
}
