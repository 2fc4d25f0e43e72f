//! The keys of a surface that is a mesh: its file, the parts into which it is split, and how it is
//! scaled and moved.

use super::element::Element;
use super::error::Report;
use super::mesh_file::MeshFiles;
use super::value::{COORDINATE, LENGTH, Value, array, choice, number, text};
use crate::geometry::{Affine, Mesh, Vector};
use std::sync::Arc;

/// Keys that only a mesh has.
const KEYS: [&str; 3] = ["split", "scale", "transform"];
const ROWS: &str = "three rows [a, b, c, d], for x ↦ a x + b y + c z + d";

/// The meshes of a surface; with the names of the groups into which it is split, if it is.
pub(super) type Meshes = Vec<(Option<String>, Arc<Mesh>)>;

/// Reports keys of meshes in a surface of another shape.
pub(super) fn refuse(report: &mut Report, element: &Element) {
    for value in KEYS.iter().filter_map(|key| Some((key, element.optional(key)?))) {
        let (key, value) = value;
        report.error(value.span(), format!("`{key}` is for meshes only"), "a surface with a `mesh`");
    }
}

/// Reads the mesh of a surface and returns its parts, scaled and moved.
pub(super) fn read(
    report: &mut Report,
    element: &Element,
    value: &Value,
    files: &mut MeshFiles,
) -> Option<Meshes> {
    let is_split = is_split(report, element);
    let map = map(report, element);
    let name = text(report, value, "`mesh`")?;
    let file = files.file(report, value.span(), name)?;
    let whole = moved(report, value, &file.mesh, &map?)?;
    if !is_split? {
        let groups = file.groups.into_iter().map(|group| (group.name, group.faces)).collect();
        return Some(vec![(None, Arc::new(whole.grouped(groups)))]);
    }
    if file.groups.is_empty() {
        let message = format!("`{name}` names no groups of faces");
        let place = element.optional("split").map_or(value.span(), |value| value.span());
        report.error(place, message, "a file with groups, or no `split`");
        return None;
    }
    let part =
        |group: &super::mesh_file::Group| (Some(group.name.clone()), Arc::new(whole.part(&group.faces)));
    Some(file.groups.iter().map(part).collect())
}

fn is_split(report: &mut Report, element: &Element) -> Option<bool> {
    let Some(value) = element.optional("split") else { return Some(false) };
    let found = text(report, value, "`split`")?;
    choice(report, value.span(), found, "the split", &[("group", true)])
}

/// Returns the map x ↦ A (s x) + b of the keys `scale` and `transform`.
fn map(report: &mut Report, element: &Element) -> Option<Affine> {
    let scale = match element.optional("scale") {
        None => Some(1.0),
        Some(value) => number(report, value, "`scale`", &LENGTH),
    };
    let transform = match element.optional("transform") {
        None => Some(Affine::IDENTITY),
        Some(value) => transform(report, value),
    };
    let scale = scale?;
    Some(transform?.after(&Affine::scaling(Vector::new(scale, scale, scale))))
}

/// Returns the map with these rows; a fourth row has to be [0, 0, 0, 1].
fn transform(report: &mut Report, value: &Value) -> Option<Affine> {
    let given = value.get_ref().as_array().map_or(3, |rows| rows.len());
    let rows = array(report, value, "`transform`", if given == 4 { 4 } else { 3 }, ROWS)?;
    let row = |value| {
        let numbers = array(report, value, "a row of `transform`", 4, ROWS)?;
        let number = |value| number(report, value, "a number of `transform`", &COORDINATE);
        let numbers: Vec<Option<f64>> = numbers.iter().map(number).collect();
        numbers.into_iter().collect::<Option<Vec<f64>>>()
    };
    let rows: Vec<Option<Vec<f64>>> = rows.iter().map(row).collect();
    let rows: Vec<Vec<f64>> = rows.into_iter().collect::<Option<_>>()?;
    if rows.get(3).is_some_and(|last| *last != [0.0, 0.0, 0.0, 1.0]) {
        report.error(value.span(), "the transform is not affine", "[0, 0, 0, 1] in a fourth row");
        return None;
    }
    let column = |j: usize| Vector::new(rows[0][j], rows[1][j], rows[2][j]);
    let map = Affine { columns: [0, 1, 2].map(column), shift: column(3) };
    if !map.is_invertible() {
        report.error(value.span(), "the transform has no inverse", "an invertible transform");
        return None;
    }
    Some(map)
}

/// Returns the mesh after a map. Its fronts stay fronts, also after a reflection.
fn moved(report: &mut Report, value: &Value, mesh: &Arc<Mesh>, map: &Affine) -> Option<Arc<Mesh>> {
    if *map == Affine::IDENTITY {
        return Some(Arc::clone(mesh));
    }
    match mesh.moved(map.mirrors(), |v| map.point(v)) {
        Ok(mesh) => Some(Arc::new(mesh)),
        Err(errors) => {
            let message = format!("after its transform, {}", errors[0]);
            report.error(value.span(), message, "a transform that keeps the faces planar");
            None
        }
    }
}
