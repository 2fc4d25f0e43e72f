//! Lights without extent: parses each `[[light]]` of the file into a point light, a spot light or a distant
//! light.

use super::cone::Cone;
use super::element::{Element, Names};
use super::error::Report;
use super::model::{Light, LightKind};
use super::value::{Domain, NOT_NEGATIVE, choice};

const CUTOFF_ANGLE: &str = "cutoff_angle";
const BEAM_WIDTH: &str = "beam_width";
/// Angles to the axis of a spot light, in degrees.
pub(super) const HALF_ANGLE: Domain =
    Domain { expected: "a number of degrees above 0, up to 180", contains: |x| x > 0.0 && x <= 180.0 };
pub(super) const WIDE_BEAM: &str = "the beam of the spot light is wider than the angle at which it ends";
/// The width of the beam relative to the angle at which it ends, by default.
pub(super) const BEAM_PART: f64 = 0.75;

#[derive(Clone, Copy)]
enum Kind {
    Point,
    Spot,
    Distant,
}

pub(super) fn read(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    bands: Option<usize>,
) -> Option<Light> {
    let name = match element.optional("name") {
        None => Some(String::new()),
        Some(_) => names.name(report, element),
    };
    let (kind, place) = element.text(report, "kind", "kind = \"point\", \"spot\" or \"distant\"")?;
    let kinds = [("point", Kind::Point), ("spot", Kind::Spot), ("distant", Kind::Distant)];
    let mut cone = None;
    let kind = match choice(report, place.clone(), kind, "the kind of light", &kinds)? {
        Kind::Point => {
            element.check_keys(report, &["name", "kind", "position", "intensity"]);
            let position = element.point(report, "position");
            let intensity = element.spectrum(report, "intensity", &NOT_NEGATIVE, bands);
            position.zip(intensity).map(|(position, intensity)| LightKind::Point { position, intensity })
        }
        Kind::Spot => {
            let known = ["name", "kind", "position", "direction", "intensity", CUTOFF_ANGLE, BEAM_WIDTH];
            element.check_keys(report, &known);
            let position = element.point(report, "position");
            let intensity = element.spectrum(report, "intensity", &NOT_NEGATIVE, bands);
            cone = Some(read_cone(report, element)?);
            position.zip(intensity).map(|(position, intensity)| LightKind::Point { position, intensity })
        }
        Kind::Distant => {
            element.check_keys(report, &["name", "kind", "direction", "irradiance"]);
            let direction = element.direction(report, "direction");
            let irradiance = element.spectrum(report, "irradiance", &NOT_NEGATIVE, bands);
            direction
                .zip(irradiance)
                .map(|(direction, irradiance)| LightKind::Distant { direction, irradiance })
        }
    };
    Some(Light { name: name?, kind: kind?, cone, place: report.place(place) })
}

/// Returns the cone of a spot light, whose angles are given in degrees.
fn read_cone(report: &mut Report, element: &Element) -> Option<Cone> {
    let axis = element.direction(report, "direction");
    let cutoff = element.number(report, CUTOFF_ANGLE, &HALF_ANGLE);
    let beam = match element.optional(BEAM_WIDTH) {
        None => cutoff.map(|cutoff| BEAM_PART * cutoff),
        Some(value) => {
            let beam = element.number(report, BEAM_WIDTH, &HALF_ANGLE);
            if let (Some(beam), Some(cutoff)) = (beam, cutoff)
                && beam > cutoff
            {
                report.error(value.span(), WIDE_BEAM, "an angle up to `cutoff_angle`");
                return None;
            }
            beam
        }
    };
    let [beam, cutoff] = [beam?, cutoff?].map(f64::to_radians);
    Some(Cone { axis: axis?, beam, cutoff })
}
