//! Reading: the text of a scene file becomes a [`Scene`]; every error of the text is collected on the way.

use super::element::{Element, Names};
use super::error::Report;
use super::model::{Band, LengthUnit, Material, Scene};
use super::value::{Domain, Value, array, choice, number, spectrum, text};
use super::{SceneError, receiver, solve, surface};
use std::collections::HashMap;
use toml::de::DeTable;

const KEYS: &[&str] = &["name", "unit", "bands", "material", "surface", "receiver", "solve"];
const KEYS_NOT_SIMULATED: &[&str] = &["medium", "light", "ambient"];
const WAVELENGTH: Domain = Domain { expected: "a wavelength in nm, above 0", contains: |x| x > 0.0 };
const FRACTION: Domain = Domain { expected: "a number from 0 to 1", contains: |x| (0.0..=1.0).contains(&x) };

/// Reads a scene. `file_name` appears in the errors; nothing is opened. A scene that asks for something the
/// format knows but this crate does not simulate is refused, so that an answer is never silently that of
/// another scene.
pub fn read(text: &str, file_name: &str) -> Result<Scene, Vec<SceneError>> {
    let mut report = Report::new(file_name, text);
    let (root, syntax_errors) = DeTable::parse_recoverable(text);
    for error in syntax_errors {
        report.error(error.span().unwrap_or(0..0), error.message(), "");
    }
    if !report.is_empty() {
        return Err(report.into_errors());
    }
    let scene = read_root(&mut report, root.get_ref());
    if report.is_empty() { Ok(scene) } else { Err(report.into_errors()) }
}

fn read_root(report: &mut Report, root: &DeTable) -> Scene {
    let element = Element { kind: "scene", table: root, place: 0..0 };
    element.check_keys(report, KEYS, KEYS_NOT_SIMULATED);
    let name = element.optional("name").and_then(|value| text(report, value, "`name`")).unwrap_or_default();
    let unit = element.optional("unit").and_then(|value| unit(report, value)).unwrap_or(LengthUnit::Metre);
    let bands = element.optional("bands").and_then(|value| bands(report, value)).unwrap_or_default();
    let bands_are_known = !bands.is_empty() || element.optional("bands").is_none();
    let band_count = bands_are_known.then_some(bands.len().max(1));
    let (materials, material_names) = materials(report, root, band_count);
    let surfaces = surface::read(report, root, &material_names, band_count);
    let receivers = receiver::read(report, root);
    solve::check(report, root);
    Scene { name: name.to_owned(), unit, bands, materials, surfaces, receivers }
}

fn unit(report: &mut Report, value: &Value) -> Option<LengthUnit> {
    let units = [("m", LengthUnit::Metre), ("cm", LengthUnit::Centimetre), ("mm", LengthUnit::Millimetre)];
    let found = text(report, value, "`unit`")?;
    choice(report, value.span(), found, "the unit", &units)
}

fn bands(report: &mut Report, value: &Value) -> Option<Vec<Band>> {
    const EXPECTED: &str = "a list of bands [low, high] in nm";
    let Some(list) = value.get_ref().as_array().filter(|list| !list.is_empty()) else {
        report.error(value.span(), "`bands` is not a list of bands", EXPECTED);
        return None;
    };
    let bands: Vec<Option<Band>> = list.iter().map(|value| band(report, value)).collect();
    bands.into_iter().collect()
}

fn band(report: &mut Report, value: &Value) -> Option<Band> {
    let ends = array(report, value, "a band", 2, "its two ends [low, high] in nm")?;
    let mut numbers = ends.iter().map(|end| number(report, end, "the end of a band", &WAVELENGTH));
    let (low, high) = (numbers.next()??, numbers.next()??);
    drop(numbers);
    if low >= high {
        report.error(value.span(), "the band ends before it begins", "[low, high] with low below high");
        return None;
    }
    Some(Band { low, high })
}

/// The indices of the materials by name. A material with an error in it keeps its name, so that the error is
/// not repeated wherever the material is used.
pub(super) type MaterialNames = HashMap<String, usize>;

fn materials(report: &mut Report, root: &DeTable, bands: Option<usize>) -> (Vec<Material>, MaterialNames) {
    let (mut names, mut indices, mut materials) = (Names::default(), MaterialNames::new(), Vec::new());
    for element in Element::list(report, root, "material") {
        let Some(name) = names.name(report, &element) else { continue };
        indices.insert(name.clone(), materials.len());
        let reflectance = reflectance(report, &element, bands).unwrap_or_default();
        materials.push(Material { name, reflectance });
    }
    (materials, indices)
}

fn reflectance(report: &mut Report, material: &Element, bands: Option<usize>) -> Option<Vec<f64>> {
    let kinds = [("diffuse", true), ("mirror", false), ("dielectric", false), ("conductor", false)];
    let (kind, place) = material.text(report, "kind", "kind = \"diffuse\"")?;
    if !choice(report, place.clone(), kind, "the kind of material", &kinds)? {
        report.error(
            place,
            format!("a material of kind `{kind}` is not supported yet"),
            "kind = \"diffuse\"",
        );
        return None;
    }
    material.check_keys(report, &["name", "kind", "reflectance"], &[]);
    let value = material.required(report, "reflectance", "a number from 0 to 1, or one a band")?;
    spectrum(report, value, "`reflectance`", &FRACTION, bands)
}
