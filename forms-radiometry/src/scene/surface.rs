//! Surfaces: parses each `[[surface]]` of the file into a shape with a material and, for a lamp, a
//! radiance.

use super::element::{Element, Names};
use super::error::Report;
use super::known::Known;
use super::mesh_file::MeshFiles;
use super::mesh_keys;
use super::model::{Shape, Surface};
use super::round;
use super::subsurfaces::OnKey;
use super::value::{NOT_NEGATIVE, Value, boolean, one_of, spectrum, text, vector};
use crate::geometry::{Polygon, Vector};
use std::f64::consts::PI;
use std::ops::Range;

const KEYS: &[&str] = &[
    "name",
    "material",
    "polygon",
    "mesh",
    "sphere",
    "disk",
    "annulus",
    "cylinder",
    "cone",
    "paraboloid",
    "split",
    "scale",
    "transform",
    "on",
    "radiance",
    "exitance",
    "two_sided",
];
const SHAPES: [&str; 8] = ["polygon", "mesh", "sphere", "disk", "annulus", "cylinder", "cone", "paraboloid"];

/// The shapes of a `[[surface]]`, with the names of the groups of its mesh if it is split; and the
/// place of its shape.
type Shapes = (Vec<(Option<String>, Shape)>, Range<usize>);

/// Reads a `[[surface]]`: a surface, or one for each group of its mesh. The first has this index.
pub(super) fn read(
    report: &mut Report,
    element: &Element,
    names: &mut Names,
    known: &mut Known,
    index: usize,
    files: &mut MeshFiles,
) -> Vec<Surface> {
    element.check_keys(report, KEYS);
    let name = names.name(report, element);
    let material =
        element.reference(report, "material", "the name of a material", "material", &known.materials);
    let shapes = shapes(report, element, files);
    let shapes = shapes.map(|(shapes, place)| (with_faces(report, known, name.as_deref(), shapes), place));
    register(report, (names, known), name.as_deref(), shapes.as_ref(), index);
    on(report, element, known, (index, name.clone()));
    let emission = emission(report, element, known.bands);
    let two_sided = two_sided(report, element, known, material);
    let all = || Some((name?, material?, shapes?, emission?, two_sided?));
    let Some((name, material, (shapes, place), (radiance, exitance), two_sided)) = all() else {
        return Vec::new();
    };
    let surface = |(group, shape): (Option<String>, Shape)| Surface {
        name: full_name(&name, group.as_deref()),
        material,
        shape,
        radiance: radiance.clone(),
        exitance: exitance.clone(),
        two_sided,
        texture: None,
        place: report.place(place.clone()),
    };
    shapes.into_iter().map(surface).collect()
}

/// Leaves out a mesh without faces, with a note.
fn with_faces(
    report: &mut Report,
    known: &mut Known,
    name: Option<&str>,
    shapes: Vec<(Option<String>, Shape)>,
) -> Vec<(Option<String>, Shape)> {
    if let Some(name) = name.filter(|_| shapes.iter().any(|(_, shape)| shape.has_no_faces())) {
        report.note(format!("the surface `{name}` has no faces, and is left out"));
        known.surfaces.leave_out(name);
    }
    shapes.into_iter().filter(|(_, shape)| !shape.has_no_faces()).collect()
}

/// Returns the name of a surface, or of a group of its mesh: `part/GROUP`.
fn full_name(name: &str, group: Option<&str>) -> String {
    group.map_or(name.to_owned(), |group| format!("{name}/{group}"))
}

/// Makes the names of surfaces known to the receivers. An invalid surface keeps its name.
fn register(
    report: &mut Report,
    (names, known): (&mut Names, &mut Known),
    name: Option<&str>,
    shapes: Option<&Shapes>,
    index: usize,
) {
    let Some(name) = name else { return };
    let Some((shapes, place)) = shapes else { return known.surfaces.insert(name.to_owned(), index) };
    for (offset, (group, _)) in shapes.iter().enumerate() {
        let full = full_name(name, group.as_deref());
        if group.is_some() {
            names.give(report, "surface", &full, place.clone());
        }
        known.surfaces.insert(full, index + offset);
    }
}

/// Returns the only shape of a surface, or those of the groups of its mesh.
fn shapes(report: &mut Report, element: &Element, files: &mut MeshFiles) -> Option<Shapes> {
    const EXPECTED: &str = "polygon = [[x, y, z], …], counter-clockwise seen from the front, or a `mesh`, `sphere`, `disk`, `annulus`, `cylinder`, `cone` or `paraboloid`";
    let given: Vec<&str> = SHAPES.into_iter().filter(|shape| element.optional(shape).is_some()).collect();
    let [key] = given[..] else {
        let Some(&second) = given.get(1) else {
            report.error(element.place.clone(), "this surface has no shape", EXPECTED);
            return None;
        };
        let place = element.optional(second).map_or(element.place.clone(), |value| value.span());
        let found = one_of(given.into_iter()).replace(" or ", " and ");
        report.error(place, format!("the surface has more than one shape: {found}"), "one of them");
        return None;
    };
    let value = element.optional(key)?;
    if key == "mesh" {
        let meshes = mesh_keys::read(report, element, value, files)?;
        let shapes = meshes.into_iter().map(|(group, mesh)| (group, Shape::Mesh(mesh)));
        return Some((shapes.collect(), value.span()));
    }
    mesh_keys::refuse(report, element);
    let shape = match key {
        "polygon" => polygon(report, value).map(Shape::Polygon),
        round => round::read(report, round, value),
    };
    Some((vec![(None, shape?)], value.span()))
}

/// Records the name of the surface on which this one lies; that surface can follow later in the
/// file.
fn on(report: &mut Report, element: &Element, known: &mut Known, (surface, name): (usize, Option<String>)) {
    let Some(value) = element.optional("on") else { return };
    if element.optional("split").is_some() {
        let message = "the groups of a mesh cannot lie on a surface";
        report.error(value.span(), message, "a surface without `split`");
        return;
    }
    if let Some(base) = text(report, value, "`on`") {
        known.on.push(OnKey { surface, name, base: base.to_owned(), place: value.span() });
    }
}

fn two_sided(report: &mut Report, element: &Element, known: &Known, material: Option<usize>) -> Option<bool> {
    let Some(value) = element.optional("two_sided") else { return Some(false) };
    let two_sided = boolean(report, value, "`two_sided`")?;
    if two_sided && material.is_some_and(|material| known.dielectrics.contains(&material)) {
        let message = "a dielectric cannot be two-sided: it has a medium behind it";
        report.error(value.span(), message, "two_sided = false");
        return None;
    }
    Some(two_sided)
}

fn polygon(report: &mut Report, value: &Value) -> Option<Polygon> {
    const EXPECTED: &str = "polygon = [[x, y, z], …], counter-clockwise seen from the front";
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

/// Returns the radiance of a surface, given directly or by its exitance M = π L, and that exitance.
fn emission(
    report: &mut Report,
    element: &Element,
    bands: Option<usize>,
) -> Option<(Vec<f64>, Option<Vec<f64>>)> {
    match (element.optional("radiance"), element.optional("exitance")) {
        (None, None) => Some((vec![0.0; bands.unwrap_or(1)], None)),
        (Some(value), None) => Some((spectrum(report, value, "`radiance`", &NOT_NEGATIVE, bands)?, None)),
        (None, Some(value)) => {
            let exitance = spectrum(report, value, "`exitance`", &NOT_NEGATIVE, bands)?;
            Some((exitance.iter().map(|m| m / PI).collect(), Some(exitance)))
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
