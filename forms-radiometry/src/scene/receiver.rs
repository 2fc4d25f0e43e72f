//! Receivers: parses each `[[receiver]]` of the file into a quantity to compute.

mod check;
mod point_file;
mod points;

pub(super) use check::check;

use super::element::{Element, Names};
use super::error::Report;
use super::known::Known;
use super::mesh_file::MeshFiles;
use super::model::{Receiver, ReceiverKind, SurfaceSide, TimeBins};
use super::value::{ANY, Domain, FIELD_OF_VIEW, LENGTH, POSITIVE, Value, choice, pixels, text};
use crate::camera::Camera;

const BINS: Domain = Domain {
    expected: "an integer from 1 to 1000000",
    contains: |x| x.fract() == 0.0 && (1.0..=1e6).contains(&x),
};

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Surface,
    Faces,
    Ray,
    Camera,
    Sphere,
}

const KINDS: [(&str, Kind); 6] = [
    ("point", Kind::Point),
    ("surface", Kind::Surface),
    ("faces", Kind::Faces),
    ("ray", Kind::Ray),
    ("camera", Kind::Camera),
    ("sphere", Kind::Sphere),
];

pub(super) fn read(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    known: &Known,
    files: &MeshFiles,
) -> Option<Receiver> {
    let name = names.name(report, element);
    let expected = "kind = \"point\", \"surface\", \"faces\", \"ray\", \"camera\" or \"sphere\"";
    let (kind, place) = element.text(report, "kind", expected)?;
    let kind = choice(report, place.clone(), kind, "the kind of receiver", &KINDS)?;
    let own: &[&str] = match kind {
        Kind::Point => &["name", "kind", "position", "points", "line", "plane", "normal", "time"],
        Kind::Surface => &["name", "kind", "surface", "side", "grid", "time"],
        Kind::Faces => &["name", "kind", "surface", "side", "time"],
        Kind::Ray => &["name", "kind", "origin", "direction", "time"],
        Kind::Camera => {
            &["name", "kind", "origin", "target", "up", "projection", "fov", "width", "resolution", "time"]
        }
        Kind::Sphere => &["name", "kind", "position", "points", "line", "plane", "time"],
    };
    element.check_keys(report, own);
    let question = match kind {
        Kind::Point => points::irradiance(report, element, files),
        Kind::Surface => surface(report, element, known),
        Kind::Faces => faces(report, element, known),
        Kind::Ray => ray(report, element),
        Kind::Camera => camera(report, element).map(ReceiverKind::Camera),
        Kind::Sphere => points::all_around(report, element, files),
    };
    let time = match element.optional("time") {
        None => Some(None),
        Some(value) => time(report, value).map(Some),
    };
    Some(Receiver { name: name?, kind: question?, time: time?, place: report.place(place) })
}

fn ray(report: &mut Report, element: &Element) -> Option<ReceiverKind> {
    let (origin, direction) = (element.point(report, "origin"), element.direction(report, "direction"));
    Some(ReceiverKind::Ray { origin: origin?, direction: direction? })
}

fn surface(report: &mut Report, element: &Element, known: &Known) -> Option<ReceiverKind> {
    let side = side(report, element, known);
    let grid = match element.optional("grid") {
        None => Some(None),
        Some(value) => pixels(report, value, "`grid`", "grid = [columns, rows]").map(Some),
    };
    let (surface, side) = side?;
    Some(ReceiverKind::Surface { surface, side, grid: grid? })
}

fn faces(report: &mut Report, element: &Element, known: &Known) -> Option<ReceiverKind> {
    side(report, element, known).map(|(surface, side)| ReceiverKind::Faces { surface, side })
}

/// Reads the surface of a receiver, and the side of it that receives.
fn side(report: &mut Report, element: &Element, known: &Known) -> Option<(usize, SurfaceSide)> {
    const SIDES: [(&str, SurfaceSide); 2] = [("front", SurfaceSide::Front), ("back", SurfaceSide::Back)];
    let surface = element.reference(report, "surface", "the name of a surface", "surface", &known.surfaces);
    let side = match element.optional("side") {
        None => Some(SurfaceSide::Front),
        Some(value) => text(report, value, "`side`")
            .and_then(|found| choice(report, value.span(), found, "the side", &SIDES)),
    };
    Some((surface?, side?))
}

fn camera(report: &mut Report, element: &Element) -> Option<Camera> {
    let [origin, target, up] = ["origin", "target", "up"].map(|key| element.point(report, key));
    let is_orthographic = is_orthographic(report, element)?;
    let (needed, other) = if is_orthographic { ("width", "fov") } else { ("fov", "width") };
    if let Some(value) = element.optional(other) {
        let message = format!("a camera of this projection has no `{other}`");
        report.error(value.span(), message, format!("`{needed}`"));
    }
    let frame = match is_orthographic {
        true => element.number(report, "width", &LENGTH),
        false => element.number(report, "fov", &FIELD_OF_VIEW),
    };
    let resolution = element.required(report, "resolution", "resolution = [width, height]");
    let resolution =
        resolution.and_then(|value| pixels(report, value, "`resolution`", "resolution = [width, height]"));
    let (origin, target, up, resolution) = (origin?, target?, up?, resolution?);
    let camera = match is_orthographic {
        true => Camera::orthographic(origin, target - origin, up, frame?, resolution),
        false => Camera::new(origin, target, up, frame?, resolution),
    };
    if camera.is_none() {
        let place = element.optional("up").map_or(element.place.clone(), |value| value.span());
        let expected =
            "a target other than the origin, and an `up` that is not parallel to the viewing direction";
        report.error(place, "the orientation of the camera is undefined", expected);
    }
    camera
}

/// Whether the projection of a camera is orthographic, and not perspective.
fn is_orthographic(report: &mut Report, element: &Element) -> Option<bool> {
    let Some(value) = element.optional("projection") else { return Some(false) };
    let projection = text(report, value, "`projection`")?;
    choice(
        report,
        value.span(),
        projection,
        "the projection",
        &[("perspective", false), ("orthographic", true)],
    )
}

fn time(report: &mut Report, value: &Value) -> Option<TimeBins> {
    const EXPECTED: &str = "time = { start = 0, width = 1e-9, bins = 100 }, in seconds";
    let element = Element::single(report, value, "`time`", "`time`", EXPECTED)?;
    element.check_keys(report, &["start", "width", "bins"]);
    let start = element.number(report, "start", &ANY);
    let width = element.number(report, "width", &POSITIVE);
    let bins = element.number(report, "bins", &BINS);
    Some(TimeBins { start: start?, width: width?, bins: bins? as usize, place: report.place(value.span()) })
}
