//! Scenes of View3D (.vs3): vertices and surfaces with their emissivities become a scene of diffuse
//! surfaces for view factors.
//!
//! ```text
//! T title │ C control │ F 3 or 3a │ V vertices │ S, N, O surfaces │ E end
//!   S surface ── `base` ─▶ lies on another surface, `cmb` ─▶ one surface with another
//!   N null surface, O obstruction ─▶ a black surface
//! ```
//! Lengths have no unit, and are read as metres. Control values set the accuracy of View3D's own
//! method and are ignored.

mod element;
mod shape;

use super::element::unique;
use super::error::Report;
use super::model::{Ambient, LengthUnit, Material, MaterialKind, Scene, Shape, Solve, Surface};
use super::subsurfaces::Subsurface;
use super::words::Fault;
use crate::geometry::{Mesh, Polygon, Vector};
use element::{Element, Elements};
use shape::Format;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// Reads the scene, and its surfaces that lie on others.
pub(super) fn read(report: &mut Report, text: &str) -> Option<(Scene, Vec<Subsurface>)> {
    let mut reader = Reader {
        report,
        format: None,
        name: String::new(),
        vertices: HashMap::new(),
        rows: Vec::new(),
        known: HashMap::new(),
    };
    for element in Elements::of(text) {
        if !reader.element(element) {
            break;
        }
    }
    let Reader { name, rows, known, .. } = reader;
    if report.is_empty() && rows.is_empty() {
        report.error(0..0, "the file has no surfaces", "lines that begin with S");
    }
    report.is_empty().then(|| scene(report, name, &rows, &known))
}

/// What a surface is to the others.
#[derive(Clone, Copy, PartialEq)]
enum Role {
    /// It exchanges light.
    Surface,
    /// It covers a part of its base.
    Null,
    /// It only hides others.
    Obstruction,
}

/// A surface of the file.
struct Row {
    number: u32,
    role: Role,
    polygon: Polygon,
    /// The numbers of the surface that it lies on, and of the one that it is a part of; or zero.
    base: u32,
    combined: u32,
    emissivity: f64,
    name: String,
    place: Range<usize>,
}

struct Reader<'r> {
    report: &'r mut Report,
    format: Option<Format>,
    name: String,
    vertices: HashMap<u32, Vector>,
    rows: Vec<Row>,
    /// The index of the row of each number.
    known: HashMap<u32, usize>,
}

impl Reader<'_> {
    /// Reads an element; returns whether others may follow.
    fn element(&mut self, mut element: Element) -> bool {
        match element.keyword {
            'T' => self.name = element.rest().to_owned(),
            'C' | 'X' => {}
            'F' => match element.word("the format").and_then(Format::of) {
                Ok(format) => self.format = Some(format),
                Err(fault) => self.fault(fault),
            },
            'V' => {
                let read = element.number().and_then(|number| Ok((number, element.point()?)));
                match read {
                    Ok(vertex) => self.vertices.extend([vertex]),
                    Err(fault) => self.fault(fault),
                }
            }
            'S' => self.surface(Role::Surface, element),
            'N' => self.surface(Role::Null, element),
            'O' => self.surface(Role::Obstruction, element),
            'M' => {
                let message = "masking surfaces are not supported: they face their base without a distance";
                self.report.error(element.place, message, "a base without the covered part");
            }
            'E' | '*' => return false,
            _ => {
                let message = format!("`{}` is no element of a View3D file", element.keyword);
                self.report.error(element.place, message, "T, C, F, V, S, N, O or E");
            }
        }
        true
    }

    fn fault(&mut self, fault: Fault) {
        self.report.error(fault.range, fault.message, fault.expected);
    }

    fn surface(&mut self, role: Role, element: Element) {
        match self.row(role, element) {
            Ok(row) => {
                if let Some(&other) = self.known.get(&row.number) {
                    let line = self.report.line(self.rows[other].place.start, row.place.start);
                    let message = format!("surface {} is already defined in {line}", row.number);
                    self.report.error(row.place.clone(), message, "a number of its own");
                }
                self.known.entry(row.number).or_insert(self.rows.len());
                self.rows.push(row);
            }
            Err(fault) => self.fault(fault),
        }
    }

    fn row(&self, role: Role, mut element: Element) -> Result<Row, Fault> {
        let place = element.place.clone();
        let Some(format) = self.format else {
            return Err(element.fault("a surface before the format", "F 3, or F 3a, before it"));
        };
        let number = element.number()?;
        let outline = format.begin(&mut element, &self.vertices)?;
        let (mut base, mut combined, mut emissivity, mut name) = (0, 0, 1.0, String::new());
        if role != Role::Obstruction {
            (base, combined) = (element.number()?, element.number()?);
            emissivity = element.fraction("the emissivity")?;
            name = element.word("the name of the surface")?.text.to_owned();
        }
        if role != Role::Surface {
            emissivity = 1.0;
        }
        let vertices = outline.vertices(&mut element)?;
        let polygon = Polygon::new(vertices)
            .map_err(|error| element.fault(&error.to_string(), "a simple planar polygon"));
        Ok(Row { number, role, polygon: polygon?, base, combined, emissivity, name, place })
    }
}

/// Makes the scene of all surfaces; those that are combined are one mesh.
fn scene(
    report: &mut Report,
    name: String,
    rows: &[Row],
    known: &HashMap<u32, usize>,
) -> (Scene, Vec<Subsurface>) {
    let mut scene = Scene {
        name,
        unit: LengthUnit::Metre,
        bands: Vec::new(),
        media: Vec::new(),
        materials: Vec::new(),
        surfaces: Vec::new(),
        lights: Vec::new(),
        receivers: Vec::new(),
        ambient: Ambient { radiance: vec![0.0], ..Ambient::default() },
        solve: Solve::default(),
        notes: Vec::new(),
    };
    let indices = add_surfaces(report, &mut scene, rows);
    scene.notes = notes(rows);
    (scene, subsurfaces(report, rows, known, &indices))
}

/// Adds a surface for each row that is combined with no other before it. Returns the index of the
/// surface that each number became.
fn add_surfaces(report: &mut Report, scene: &mut Scene, rows: &[Row]) -> HashMap<u32, usize> {
    let mut combined: HashMap<u32, Vec<&Row>> = HashMap::new();
    for row in rows.iter().filter(|row| row.combined != 0) {
        combined.entry(row.combined).or_default().push(row);
    }
    let mut indices: HashMap<u32, usize> = HashMap::new();
    let mut names = HashSet::new();
    for row in rows.iter().filter(|row| row.combined == 0) {
        let index = scene.surfaces.len();
        let others = combined.get(&row.number).map_or(&[][..], Vec::as_slice);
        let parts: Vec<&Row> = std::iter::once(&row).chain(others).copied().collect();
        indices.extend(parts.iter().map(|part| (part.number, index)));
        let name = own_name(&names, row);
        names.insert(name.clone());
        let surface = surface(report, &mut scene.materials, name, &parts);
        scene.surfaces.push(surface);
    }
    indices
}

/// Returns the surfaces that lie on others. Numbers of surfaces that do not exist are reported.
fn subsurfaces(
    report: &mut Report,
    rows: &[Row],
    known: &HashMap<u32, usize>,
    indices: &HashMap<u32, usize>,
) -> Vec<Subsurface> {
    let mut subsurfaces = Vec::new();
    for row in rows {
        let first = known.get(&row.combined).map(|&first| &rows[first]);
        if row.combined != 0 && first.is_none_or(|first| first.combined != 0) {
            let message = format!(
                "surface {} is combined with surface {}, which is not a first one",
                row.number, row.combined
            );
            report.error(row.place.clone(), message, "the number of a surface that is combined with none");
            continue;
        }
        if row.base != 0 {
            match (indices.get(&row.number), indices.get(&row.base)) {
                (Some(&own), Some(&base)) if own != base => {
                    subsurfaces.push(Subsurface::new(own, base, row.place.clone()));
                }
                _ => {
                    let message =
                        format!("there is no surface {} for surface {} to lie on", row.base, row.number);
                    report.error(row.place.clone(), message, "the number of another surface");
                }
            }
        }
    }
    subsurfaces
}

fn notes(rows: &[Row]) -> Vec<String> {
    let count = rows.iter().filter(|row| row.role != Role::Surface).count();
    let note = "obstructions and null surfaces are black surfaces here, with rows of their own";
    if count > 0 { vec![note.to_owned()] } else { Vec::new() }
}

/// Makes one surface of rows that are combined.
fn surface(report: &mut Report, materials: &mut Vec<Material>, name: String, rows: &[&Row]) -> Surface {
    let first = rows[0];
    if let Some(other) = rows.iter().find(|row| row.emissivity != first.emissivity) {
        let message = format!(
            "surface {} has another emissivity than surface {}, with which it is combined",
            other.number, first.number
        );
        report.error(other.place.clone(), message, "one emissivity for both");
    }
    let shape = match rows {
        [only] => Shape::Polygon(outward(only)),
        _ => {
            let polygons: Vec<Polygon> = rows.iter().map(|row| outward(row)).collect();
            let mesh = Mesh::of_outlines(polygons.iter().map(Polygon::vertices));
            Shape::Mesh(Arc::new(mesh.expect("its faces are polygons")))
        }
    };
    Surface {
        name,
        material: material(materials, first, report),
        shape,
        radiance: vec![0.0],
        exitance: None,
        two_sided: false,
        texture: None,
        place: report.place(first.place.clone()),
    }
}

/// Returns the polygon of a row. A null surface faces its base, and is turned to lie on it.
fn outward(row: &Row) -> Polygon {
    if row.role == Role::Null { row.polygon.reversed() } else { row.polygon.clone() }
}

/// Returns the name of a surface, or one with its number if it has none, or another has it.
fn own_name(names: &HashSet<String>, row: &Row) -> String {
    let is_taken = |name: &str| names.contains(name);
    match (row.name.is_empty(), is_taken(&row.name)) {
        (true, _) => unique(&format!("surface {}", row.number), is_taken),
        (false, true) => unique(&format!("{} ({})", row.name, row.number), is_taken),
        (false, false) => row.name.clone(),
    }
}

/// Returns the index of the material with the reflectance 1 − ε.
fn material(materials: &mut Vec<Material>, row: &Row, report: &Report) -> usize {
    let kind = MaterialKind::Diffuse { reflectance: vec![1.0 - row.emissivity] };
    let known = materials.iter().position(|material| material.kind == kind);
    known.unwrap_or_else(|| {
        let place = report.place(row.place.clone());
        materials.push(Material { name: format!("emissivity {}", row.emissivity), kind, place });
        materials.len() - 1
    })
}
