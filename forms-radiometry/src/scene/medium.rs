//! Media: parses each `[[medium]]` of the file into its coefficients, its phase function and its
//! refractive index.

use super::element::{Element, Names};
use super::error::Report;
use super::known::Known;
use super::model::Medium;
use super::value::{COEFFICIENT, MEAN_COSINE, POSITIVE};

const KEYS: &[&str] = &["name", "sigma_a", "sigma_s", "g", "n"];

pub(super) fn read(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    known: &mut Known,
    index: usize,
) -> Option<Medium> {
    element.check_keys(report, KEYS);
    let name = known.media.name(report, element, names, index);
    let absorption = element.spectrum_or(report, "sigma_a", 0.0, &COEFFICIENT, known.bands);
    let scattering = element.spectrum_or(report, "sigma_s", 0.0, &COEFFICIENT, known.bands);
    let asymmetry = element.spectrum_or(report, "g", 0.0, &MEAN_COSINE, known.bands);
    let refraction = element.spectrum_or(report, "n", 1.0, &POSITIVE, known.bands);
    let place = report.place(element.optional("name").map_or(element.place.clone(), |value| value.span()));
    Some(Medium {
        name: name?,
        absorption: absorption?,
        scattering: scattering?,
        asymmetry: asymmetry?,
        index: refraction?,
        place,
    })
}
