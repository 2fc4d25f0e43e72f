//! Overlaps: reports coplanar surfaces that overlap and receive light from the same side.
//!
//! ```text
//! surfaces ─ flat pieces whose boxes meet ─ in one plane, of different surfaces ─ common area
//! common area ─▶ an error that names both surfaces
//! ```
//! Light would arrive at both surfaces. Fronts that face the same way receive it from the same
//! side. So do surfaces that face opposite ways if either is two-sided or a dielectric, which acts
//! on both of its sides. One-sided surfaces back to back, like the two faces of a thin wall, share
//! no side. Faces of one mesh are not compared: they have the same material and radiance, and there
//! is no second surface on which they could lie.
//!
//! In Mitsuba scenes nearly every material is two-sided, and a box on a floor would be an error
//! although no light reaches the sides in contact. In these scenes two-sided surfaces can touch
//! back to back.

use super::error::Report;
use super::model::{MaterialKind, Scene, Shape, Surface};
use crate::geometry::{Flat, Vector, closeness, overlap};
use crate::visibility::Boxes;
use std::cell::OnceCell;
use std::collections::{BTreeMap, HashSet};
use std::ops::ControlFlow;

/// The format of a scene file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Format {
    Toml,
    Mitsuba,
}

/// Reports surfaces that overlap.
pub(super) fn check(report: &mut Report, scene: &Scene, format: Format) {
    if scene.surfaces.len() < 2 {
        return;
    }
    let working = scene.in_working_units();
    for pair in pairs(&working.scene, format) {
        let (place, message, expected) = pair.described(scene, format);
        report.error_at(&scene.surfaces[place].place, message, expected);
    }
}

/// Two surfaces that overlap; the surface with the smaller overlapping piece comes first.
struct Pair {
    surfaces: [usize; 2],
    faces_same_way: bool,
    /// Whether the first piece lies in the second, which is larger.
    is_inside: bool,
}

/// A flat piece of a surface: the surface itself, or a face of its mesh.
struct Piece<'s> {
    surface: usize,
    shape: &'s Shape,
    face: usize,
    flat: OnceCell<Flat>,
}

impl<'s> Piece<'s> {
    /// Returns the pieces of all surfaces.
    fn all(scene: &'s Scene) -> impl Iterator<Item = Self> {
        scene.surfaces.iter().enumerate().flat_map(|(surface, Surface { shape, .. })| {
            let count = match shape {
                Shape::Polygon(_) | Shape::Disk(_) => 1,
                Shape::Mesh(mesh) => mesh.faces().len(),
                Shape::Sphere(_) | Shape::Quadric(_) => 0,
            };
            (0..count).map(move |face| Self { surface, shape, face, flat: OnceCell::new() })
        })
    }

    /// Returns points whose bounding box contains the piece, and a margin within which other pieces
    /// count as near.
    fn reach(&self) -> (Vec<Vector>, f64) {
        let points = match self.shape {
            Shape::Polygon(polygon) => polygon.vertices().to_vec(),
            Shape::Mesh(mesh) => mesh.corners(self.face).collect(),
            Shape::Disk(disk) => disk.corners().to_vec(),
            Shape::Sphere(_) | Shape::Quadric(_) => Vec::new(),
        };
        let margin = 2.0 * closeness(points.iter().copied());
        (points, margin)
    }

    fn flat(&self) -> &Flat {
        self.flat.get_or_init(|| match self.shape {
            Shape::Mesh(mesh) => Flat::Polygon(mesh.polygon(self.face)),
            Shape::Polygon(polygon) => Flat::Polygon(polygon.clone()),
            Shape::Disk(disk) => Flat::Disk(*disk),
            Shape::Sphere(_) | Shape::Quadric(_) => unreachable!("a curved shape has no flat pieces"),
        })
    }
}

/// Finds the pairs of surfaces that overlap, each once.
fn pairs(scene: &Scene, format: Format) -> Vec<Pair> {
    let pieces = near_others(scene);
    let boxes = Boxes::around(pieces.iter().map(Piece::reach));
    let (mut found, mut known) = (Vec::new(), HashSet::new());
    for (index, piece) in pieces.iter().enumerate() {
        let compare = |other: usize| {
            let surfaces = [piece.surface, pieces[other].surface];
            let is_new = other > index && surfaces[0] != surfaces[1] && !known.contains(&surfaces);
            if let Some(pair) = is_new.then(|| pair(scene, format, piece, &pieces[other])).flatten() {
                known.insert(surfaces);
                found.push(pair);
            }
            ControlFlow::Continue(())
        };
        let (points, margin) = piece.reach();
        let _ = boxes.meeting(points, margin, compare);
    }
    found
}

/// Returns the pieces whose boxes intersect the box of another surface.
fn near_others(scene: &Scene) -> Vec<Piece<'_>> {
    let mut reaches: BTreeMap<usize, (Vec<Vector>, f64)> = BTreeMap::new();
    for piece in Piece::all(scene) {
        let (points, margin) = piece.reach();
        let (all, widest) = reaches.entry(piece.surface).or_default();
        all.extend(points);
        *widest = widest.max(margin);
    }
    let surfaces: Vec<usize> = reaches.keys().copied().collect();
    let boxes = Boxes::around(reaches.into_values());
    let meets_other = |piece: &Piece| {
        let (points, margin) = piece.reach();
        let is_other = |place: usize| {
            if surfaces[place] == piece.surface { ControlFlow::Continue(()) } else { ControlFlow::Break(()) }
        };
        boxes.meeting(points, margin, is_other).is_break()
    };
    Piece::all(scene).filter(meets_other).collect()
}

/// Returns the pair of two pieces if they overlap and receive light from the same side.
fn pair(scene: &Scene, format: Format, a: &Piece, b: &Piece) -> Option<Pair> {
    let faces_same_way = a.flat().normal().dot(b.flat().normal()) > 0.0;
    let acts_behind = |piece: &Piece| {
        let is_two_sided = format == Format::Toml && scene.surfaces[piece.surface].two_sided;
        is_two_sided || is_dielectric(scene, piece.surface)
    };
    if !faces_same_way && !acts_behind(a) && !acts_behind(b) {
        return None;
    }
    let common = overlap(a.flat(), b.flat())?;
    let [(own, area), (other, larger)] = match [a, b].map(|piece| (piece.surface, piece.flat().area())) {
        [a, b] if a.1 < b.1 => [a, b],
        [a, b] => [b, a],
    };
    let is_inside = common >= (1.0 - 1e-6) * area && area < (1.0 - 1e-6) * larger;
    Some(Pair { surfaces: [own, other], faces_same_way, is_inside })
}

fn is_dielectric(scene: &Scene, surface: usize) -> bool {
    matches!(scene.materials[scene.surfaces[surface].material].kind, MaterialKind::Dielectric { .. })
}

impl Pair {
    /// Returns the surface at which the pair is reported, the message, and the expected input.
    fn described(&self, scene: &Scene, format: Format) -> (usize, String, String) {
        let [own, other] = self.surfaces.map(|index| &scene.surfaces[index]);
        if self.surfaces.iter().any(|&surface| is_dielectric(scene, surface)) {
            let [first, second] =
                [self.surfaces[0].min(self.surfaces[1]), self.surfaces[0].max(self.surfaces[1])];
            let [earlier, later] = [first, second].map(|index| &scene.surfaces[index].name);
            let message = format!("`{later}` overlaps `{earlier}` in one plane");
            return (second, message, "one surface between two media".to_owned());
        }
        let line = other.place.position().map_or(String::new(), |(_, line, _)| format!(" (line {line})"));
        let how = if self.faces_same_way {
            "both lie in one plane and face the same way".to_owned()
        } else {
            let two_sided = if own.two_sided { own } else { other };
            format!("both lie in one plane, and `{}` is two-sided", two_sided.name)
        };
        let message = format!("`{}` overlaps `{}`{line}: {how}", own.name, other.name);
        let is_subsurface = format == Format::Toml && self.is_inside && self.faces_same_way;
        let can_lie =
            matches!((&own.shape, &other.shape), (Shape::Polygon(_) | Shape::Disk(_), Shape::Polygon(_)));
        let expected = if is_subsurface && can_lie {
            format!("on = {:?}, so that `{}` replaces this part of `{}`", other.name, own.name, other.name)
        } else {
            "surfaces that do not overlap".to_owned()
        };
        (self.surfaces[0], message, expected)
    }
}
