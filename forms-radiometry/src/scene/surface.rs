//! Surfaces: each `[[surface]]` of the file becomes a polygon with a material and, for a lamp, a radiance.

use super::element::{Element, Names};
use super::error::Report;
use super::model::Surface;
use super::read::MaterialNames;
use super::value::{Domain, Value, boolean, one_of, spectrum, vector};
use crate::geometry::{Polygon, Vector};
use toml::de::DeTable;

const KEYS: &[&str] = &["name", "material", "polygon", "radiance", "exitance", "two_sided"];
const SHAPES_NOT_SIMULATED: &[&str] = &["mesh", "sphere", "disk"];
const NOT_NEGATIVE: Domain = Domain { expected: "a number of at least 0", contains: |x| x >= 0.0 };

pub(super) fn read(
    report: &mut Report,
    root: &DeTable,
    materials: &MaterialNames,
    bands: Option<usize>,
) -> Vec<Surface> {
    let mut names = Names::default();
    let elements = Element::list(report, root, "surface");
    elements.iter().filter_map(|element| surface(report, element, &mut names, materials, bands)).collect()
}

fn surface(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    materials: &MaterialNames,
    bands: Option<usize>,
) -> Option<Surface> {
    element.check_keys(report, KEYS, SHAPES_NOT_SIMULATED);
    let name = names.name(report, element);
    let material = material(report, element, materials);
    let polygon = polygon(report, element);
    let radiance = radiance(report, element, bands);
    let two_sided = match element.optional("two_sided") {
        None => Some(false),
        Some(value) => boolean(report, value, "`two_sided`"),
    };
    Some(Surface {
        name: name?,
        material: material?,
        polygon: polygon?,
        radiance: radiance?,
        two_sided: two_sided?,
    })
}

fn material(report: &mut Report, element: &Element, materials: &MaterialNames) -> Option<usize> {
    let (name, place) = element.text(report, "material", "the name of a material")?;
    let index = materials.get(name).copied();
    if index.is_none() {
        let mut known: Vec<&str> = materials.keys().map(String::as_str).collect();
        known.sort_unstable();
        let expected = match known[..] {
            [] => "a material of the scene, which has none".to_owned(),
            _ => one_of(known.into_iter()),
        };
        report.error(place, format!("no material is named `{name}`"), expected);
    }
    index
}

fn polygon(report: &mut Report, element: &Element) -> Option<Polygon> {
    const EXPECTED: &str = "polygon = [[x, y, z], …], counter-clockwise seen from the front";
    if SHAPES_NOT_SIMULATED.iter().any(|shape| element.optional(shape).is_some()) {
        return None;
    }
    let value = element.required(report, "polygon", EXPECTED)?;
    let vertices = vertices(report, value, EXPECTED)?;
    match Polygon::new(vertices) {
        Ok(polygon) => Some(polygon),
        Err(error) => {
            report.error(value.span(), error.to_string(), "a simple planar polygon");
            None
        }
    }
}

fn vertices(report: &mut Report, value: &Value, expected: &str) -> Option<Vec<Vector>> {
    let Some(list) = value.get_ref().as_array() else {
        report.error(value.span(), "`polygon` is not a list of vertices", expected);
        return None;
    };
    let vertices: Vec<Option<Vector>> = list.iter().map(|item| vector(report, item, "a vertex")).collect();
    vertices.into_iter().collect()
}

/// The radiance of a surface, given as such or as its exitance M = π L.
fn radiance(report: &mut Report, element: &Element, bands: Option<usize>) -> Option<Vec<f64>> {
    match (element.optional("radiance"), element.optional("exitance")) {
        (None, None) => Some(vec![0.0; bands.unwrap_or(1)]),
        (Some(value), None) => spectrum(report, value, "`radiance`", &NOT_NEGATIVE, bands),
        (None, Some(value)) => {
            let exitance = spectrum(report, value, "`exitance`", &NOT_NEGATIVE, bands)?;
            Some(exitance.into_iter().map(|m| m / std::f64::consts::PI).collect())
        }
        (Some(_), Some(exitance)) => {
            report.error(
                exitance.span(),
                "the surface has both a radiance and an exitance",
                "one of the two",
            );
            None
        }
    }
}
