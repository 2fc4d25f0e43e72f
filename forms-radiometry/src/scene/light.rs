//! Lights without extent: parses each `[[light]]` of the file into a point light or a distant
//! light.

use super::element::{Element, Names};
use super::error::Report;
use super::model::{Light, LightKind};
use super::value::{NOT_NEGATIVE, choice};

#[derive(Clone, Copy)]
enum Kind {
    Point,
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
    let (kind, place) = element.text(report, "kind", "kind = \"point\" or \"distant\"")?;
    let kinds = [("point", Kind::Point), ("distant", Kind::Distant)];
    let kind = match choice(report, place.clone(), kind, "the kind of light", &kinds)? {
        Kind::Point => {
            element.check_keys(report, &["name", "kind", "position", "intensity"]);
            let position = element.point(report, "position");
            let intensity = element.spectrum(report, "intensity", &NOT_NEGATIVE, bands);
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
    Some(Light { name: name?, kind: kind?, place: report.place(place) })
}
