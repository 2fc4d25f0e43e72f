//! Receivers: each `[[receiver]]` of the file becomes a point or a camera.

use super::element::{Element, Names};
use super::error::Report;
use super::model::{PointReceiver, Receiver};
use super::value::{Domain, Value, array, choice, direction, number, vector};
use crate::camera::{Camera, MAXIMAL_RESOLUTION};
use toml::de::DeTable;

const POINT_KEYS: &[&str] = &["name", "kind", "position", "normal"];
const CAMERA_KEYS: &[&str] = &["name", "kind", "origin", "target", "up", "fov", "resolution"];
const KEYS_NOT_SIMULATED: &[&str] = &["time"];
const FIELD_OF_VIEW: Domain =
    Domain { expected: "an angle in degrees, above 0 and below 180", contains: |x| x > 0.0 && x < 180.0 };
const PIXELS: Domain = Domain {
    expected: "a whole number of pixels from 1 to 8192",
    contains: |x| x.fract() == 0.0 && (1.0..=MAXIMAL_RESOLUTION as f64).contains(&x),
};

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Camera,
    NotSimulated,
}

pub(super) fn read(report: &mut Report, root: &DeTable) -> Vec<Receiver> {
    let mut names = Names::default();
    let elements = Element::list(report, root, "receiver");
    elements.iter().filter_map(|element| receiver(report, element, &mut names)).collect()
}

fn receiver(report: &mut Report, element: &Element, names: &mut Names) -> Option<Receiver> {
    let kinds = [
        ("point", Kind::Point),
        ("camera", Kind::Camera),
        ("surface", Kind::NotSimulated),
        ("ray", Kind::NotSimulated),
        ("sphere", Kind::NotSimulated),
    ];
    let name = names.name(report, element);
    let (kind, place) = element.text(report, "kind", "kind = \"point\" or kind = \"camera\"")?;
    match choice(report, place.clone(), kind, "the kind of receiver", &kinds)? {
        Kind::Point => point(report, element, name).map(Receiver::Point),
        Kind::Camera => camera(report, element, name).map(Receiver::Camera),
        Kind::NotSimulated => {
            let message = format!("a receiver of kind `{kind}` is not supported yet");
            report.error(place, message, "`point` or `camera`");
            None
        }
    }
}

fn point(report: &mut Report, element: &Element, name: Option<String>) -> Option<PointReceiver> {
    element.check_keys(report, POINT_KEYS, KEYS_NOT_SIMULATED);
    let position = element.required(report, "position", "position = [x, y, z]");
    let position = position.and_then(|value| vector(report, value, "`position`"));
    let normal = element.required(report, "normal", "normal = [x, y, z]");
    let normal = normal.and_then(|value| direction(report, value, "`normal`"));
    Some(PointReceiver { name: name?, position: position?, normal: normal? })
}

fn camera(report: &mut Report, element: &Element, name: Option<String>) -> Option<Camera> {
    element.check_keys(report, CAMERA_KEYS, KEYS_NOT_SIMULATED);
    let mut point = |key: &'static str| {
        let value = element.required(report, key, &format!("{key} = [x, y, z]"))?;
        vector(report, value, &format!("`{key}`"))
    };
    let (origin, target, up) = (point("origin"), point("target"), point("up"));
    let fov = element.required(report, "fov", "fov = …, the vertical field of view in degrees");
    let fov = fov.and_then(|value| number(report, value, "`fov`", &FIELD_OF_VIEW));
    let resolution = element.required(report, "resolution", "resolution = [width, height]");
    let resolution = resolution.and_then(|value| pixels(report, value));
    let camera = Camera::new(name?, origin?, target?, up?, fov?, resolution?);
    if camera.is_none() {
        let place = element.optional("up").map_or(element.place.clone(), |value| value.span());
        let expected = "a target apart from the origin, and an `up` across the line of sight";
        report.error(place, "the camera has no direction or no upright", expected);
    }
    camera
}

fn pixels(report: &mut Report, value: &Value) -> Option<[usize; 2]> {
    let sides = array(report, value, "`resolution`", 2, "resolution = [width, height]")?;
    let mut numbers = sides.iter().map(|side| number(report, side, "`resolution`", &PIXELS));
    let (width, height) = (numbers.next()?, numbers.next()?);
    Some([width? as usize, height? as usize])
}
