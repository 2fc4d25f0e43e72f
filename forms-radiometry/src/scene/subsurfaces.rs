//! Subsurfaces: a surface that lies `on` another one, its base, replaces that part of the base.
//!
//! ```text
//! `on` keys ─ names ─▶ a base for each subsurface, no cycles
//!           ─ shapes ─▶ in the plane of the base, facing the same way, inside ─▶ cut out of base
//! ```
//! The model contains the remainder of a base, wherever its shape is used. A base can itself be a
//! subsurface: its own subsurfaces are cut out of it, and its whole outline is cut out of its base.

use super::element::Indices;
use super::error::Report;
use super::model::{Scene, Shape, Surface};
use crate::geometry::{Disk, Flat, Mesh, Polygon, Vector, common_area, off_plane, resolution};
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use std::sync::Arc;

const BASES: &str = "the name of a surface that is a polygon or a planar mesh";
const SUBSURFACES: &str = "a polygon, a disk or a planar mesh";

/// The key `on` of a surface.
pub(super) struct OnKey {
    /// The index of the surface, and its name if it has one.
    pub(super) surface: usize,
    pub(super) name: Option<String>,
    /// The name in the key.
    pub(super) base: String,
    pub(super) place: Range<usize>,
}

/// A surface that lies on another one, given by their indices.
pub(super) struct Subsurface {
    surface: usize,
    base: usize,
    /// The place of the key `on`.
    place: Range<usize>,
}

impl Subsurface {
    /// Creates a surface that lies on a base, as the file says at this place.
    pub(super) fn new(surface: usize, base: usize, place: Range<usize>) -> Self {
        Self { surface, base, place }
    }
}

/// Resolves the names of bases to surfaces. Unknown names and cycles are reported.
pub(super) fn resolve(report: &mut Report, keys: &[OnKey], surfaces: &Indices) -> Vec<Subsurface> {
    let resolved = |key: &OnKey| {
        let base = surfaces.find(report, key.place.clone(), "surface", &key.base)?;
        Some(Subsurface { surface: key.surface, base, place: key.place.clone() })
    };
    let subsurfaces: Vec<Subsurface> = keys.iter().filter_map(resolved).collect();
    let bases: HashMap<usize, usize> = subsurfaces.iter().map(|sub| (sub.surface, sub.base)).collect();
    let names: HashMap<usize, &str> =
        keys.iter().filter_map(|key| Some((key.surface, key.name.as_deref()?))).collect();
    for subsurface in &subsurfaces {
        let circle = circle(subsurface.surface, &bases);
        // a cycle is reported at its first surface
        if circle.iter().min() == Some(&subsurface.surface) {
            let names: Vec<&str> = circle.iter().filter_map(|index| names.get(index).copied()).collect();
            report.error(
                subsurface.place.clone(),
                circle_message(&names),
                "a surface that does not lie on this one",
            );
        }
    }
    subsurfaces
}

/// Returns the cycle through a surface, each surface lying on the next and the last on the first;
/// empty if there is none.
fn circle(first: usize, bases: &HashMap<usize, usize>) -> Vec<usize> {
    let next = |surface: &usize| bases.get(surface).copied().filter(|&base| base != first);
    let surfaces: Vec<usize> = std::iter::successors(Some(first), next).take(bases.len()).collect();
    let last = surfaces.last().and_then(|last| bases.get(last));
    if last == Some(&first) { surfaces } else { Vec::new() }
}

/// Describes a cycle: "`a` lies on itself", "`a` lies on `b`, `b` on `a`".
fn circle_message(names: &[&str]) -> String {
    let [first, rest @ ..] = names else { return "the surface lies on itself".to_owned() };
    let [second, ..] = rest else { return format!("`{first}` lies on itself") };
    let next = names[1..].iter().zip(names[2..].iter().chain([first]));
    let others: String = next.map(|(own, base)| format!(", `{own}` on `{base}`")).collect();
    format!("`{first}` lies on `{second}`{others}")
}

/// Cuts subsurfaces out of their bases. Subsurfaces that are not inside their bases are reported.
pub(super) fn cut(report: &mut Report, scene: &mut Scene, subsurfaces: &[Subsurface]) {
    if subsurfaces.is_empty() {
        return;
    }
    let working = scene.in_working_units();
    let mut openings: BTreeMap<usize, Vec<Opening>> = BTreeMap::new();
    for subsurface in subsurfaces {
        match Opening::of(&working.scene, subsurface, working.units.factor) {
            Ok(opening) => openings.entry(subsurface.base).or_default().push(opening),
            Err((message, expected)) => report.error(subsurface.place.clone(), message, expected),
        }
    }
    let mut shapes = Vec::new();
    for (&base, openings) in &openings {
        match cut_shape(&working.scene.surfaces[base].shape, openings) {
            Ok(shape) => shapes.push((base, shape.scaled(working.units.factor.recip()))),
            Err(message) => {
                let message = format!("{message} of `{}`", scene.surfaces[base].name);
                report.error(openings[0].place.clone(), message, "surfaces that do not cover it completely");
            }
        }
    }
    for (base, shape) in shapes {
        scene.surfaces[base].shape = shape;
    }
}

/// The part of a base that a subsurface replaces.
struct Opening {
    shapes: Vec<Flat>,
    /// Lengths below this count as rounding.
    resolution: f64,
    place: Range<usize>,
}

/// An error message and the expected input.
type Problem = (String, String);

impl Opening {
    /// Returns the opening for a subsurface, if it lies in the plane of its base, faces the same
    /// way and is inside.
    fn of(scene: &Scene, subsurface: &Subsurface, factor: f64) -> Result<Self, Problem> {
        let [own, base] = [subsurface.surface, subsurface.base].map(|index| &scene.surfaces[index]);
        let [shapes, bases] = allowed_shapes(own, base)?;
        let plane = &bases[0];
        if let Some(height) = shapes.iter().filter_map(|shape| off_plane(shape, plane)).reduce(f64::max) {
            let height = height / factor;
            let message = format!("`{}` is {height:.1e} away from the plane of `{}`", own.name, base.name);
            return Err((message, format!("a surface in the plane of `{}`", base.name)));
        }
        if shapes.iter().any(|shape| shape.normal().dot(plane.normal()) < 0.0) {
            let message = format!("`{}` does not face the same way as `{}`", own.name, base.name);
            let expected = match own.shape {
                Shape::Disk(_) => "a normal in the opposite direction",
                _ => "vertices in the opposite order",
            };
            return Err((message, expected.to_owned()));
        }
        let resolution = shapes.iter().map(|shape| resolution(shape, plane)).fold(0.0, f64::max);
        let outside = |shape: &Flat| {
            let inside: f64 = bases.iter().map(|base| common_area(shape, base)).sum();
            let outside = shape.area() - inside;
            (outside > resolution * shape.extent()).then(|| 100.0 * outside / shape.area())
        };
        if let Some(part) = shapes.iter().find_map(outside) {
            let message = format!("{part:.2} % of the area of `{}` lies outside `{}`", own.name, base.name);
            return Err((message, format!("a surface inside `{}`", base.name)));
        }
        Ok(Self { shapes, resolution, place: subsurface.place.clone() })
    }
}

/// Returns the flat shapes of a subsurface and of its base, if their kinds are allowed.
fn allowed_shapes(own: &Surface, base: &Surface) -> Result<[Vec<Flat>; 2], Problem> {
    let refused =
        |what: &str| (format!("no surface can lie on `{}`, which is {what}", base.name), BASES.to_owned());
    let shapes = flat_shapes(&own.shape).map_err(|what| {
        (format!("`{}` is {what}, and cannot lie on a surface", own.name), SUBSURFACES.to_owned())
    })?;
    let bases = flat_shapes(&base.shape).map_err(refused)?;
    match (&own.shape, &base.shape) {
        (_, Shape::Disk(_)) => Err(refused("a disk")),
        (Shape::Disk(_), Shape::Mesh(_)) => {
            let message = format!("`{}` is a disk, which cannot lie on the mesh `{}`", own.name, base.name);
            Err((message, "a polygon".to_owned()))
        }
        _ => Ok([shapes, bases]),
    }
}

/// Returns the pieces of a planar shape, or the kind of a shape that is not planar.
fn flat_shapes(shape: &Shape) -> Result<Vec<Flat>, &'static str> {
    match shape {
        Shape::Polygon(polygon) => Ok(vec![Flat::Polygon(polygon.clone())]),
        Shape::Disk(disk) if disk.is_annulus() => Err("an annulus"),
        Shape::Disk(disk) => Ok(vec![Flat::Disk(*disk)]),
        Shape::Mesh(mesh) => {
            let faces: Vec<Flat> = mesh.polygons().map(Flat::Polygon).collect();
            let is_in_plane = |face: &Flat| {
                off_plane(face, &faces[0]).is_none() && face.normal().dot(faces[0].normal()) > 0.0
            };
            let is_planar = !faces.is_empty() && faces.iter().all(is_in_plane);
            if is_planar { Ok(faces) } else { Err("a mesh that is not planar") }
        }
        Shape::Sphere(_) => Err("a sphere"),
        Shape::Quadric(quadric) => Err(match quadric.name() {
            "cylinder" => "a cylinder",
            "cone" => "a cone",
            _ => "a paraboloid",
        }),
    }
}

/// Returns the remainder of a shape around openings, or the beginning of an error message.
fn cut_shape(shape: &Shape, openings: &[Opening]) -> Result<Shape, &'static str> {
    let cut = |polygon: Polygon| openings.iter().try_fold(polygon, without);
    match shape {
        Shape::Polygon(polygon) => {
            let left = cut(polygon.clone()).map(|left| left.without_disks(disks(openings)));
            let left = left.filter(|left| !left.convex_pieces().is_empty());
            left.map(Shape::Polygon).ok_or("nothing is left")
        }
        Shape::Mesh(mesh) => {
            let left: Vec<Polygon> = mesh.polygons().filter_map(cut).collect();
            let outlines: Vec<&Vec<Vector>> = left.iter().flat_map(Polygon::convex_pieces).collect();
            mesh_of(&outlines).map(|mesh| Shape::Mesh(Arc::new(mesh)))
        }
        Shape::Sphere(_) | Shape::Disk(_) | Shape::Quadric(_) => Ok(shape.clone()),
    }
}

/// Returns the remainder of a polygon around the polygons of an opening.
fn without(left: Polygon, Opening { shapes, resolution, .. }: &Opening) -> Option<Polygon> {
    let polygon = |shape: &Flat| match shape {
        Flat::Polygon(polygon) => Some(polygon.clone()),
        Flat::Disk(_) => None,
    };
    let holes: Vec<Polygon> = shapes.iter().filter_map(polygon).collect();
    left.without(&holes, *resolution)
}

fn disks(openings: &[Opening]) -> Vec<Disk> {
    let disk = |shape: &Flat| match shape {
        Flat::Disk(disk) => Some(*disk),
        Flat::Polygon(_) => None,
    };
    openings.iter().flat_map(|opening| &opening.shapes).filter_map(disk).collect()
}

/// Builds the mesh with these outlines as faces.
fn mesh_of(outlines: &[&Vec<Vector>]) -> Result<Mesh, &'static str> {
    if outlines.is_empty() {
        return Err("nothing is left");
    }
    Mesh::of_outlines(outlines.iter().map(|outline| &outline[..])).map_err(|_| "only slivers are left")
}
