//! Regions: the surfaces of a scene divide space into regions. A region behind a dielectric must be
//! closed, and exactly one medium must fill it.
//!
//! ```text
//! surfaces ─ sheets ─┬─ sides that meet at an edge ─────┐
//!                    └─ sides that see each other ──────┴─ regions ─ media
//! ```
//! Every face has two sides. Around an edge, the sides that face each other bound the same region;
//! at an edge that belongs to a single face, these are the two sides of that face. Bodies that
//! share no edge are connected along a ray. The medium behind a dielectric is given, and the region
//! outside of everything is filled by the ambient medium. If the two sides of a dielectric bound
//! the same region, its medium is entered and never left.

mod boundary;
mod edges;
mod interfaces;
mod rays;
mod rims;

use super::error::Report;
use super::model::{Material, MaterialKind, Scene, Surface};
use super::working_units::WorkingScene;
use crate::geometry::Vector;
use edges::{Edge, edges};
pub(crate) use interfaces::sheets_without_edges;
pub(crate) use interfaces::{Interface, Piece};
use interfaces::{Side, interfaces};
use std::collections::HashMap;

/// The index of a medium, or vacuum.
pub(crate) type Filling = Option<usize>;

/// A sheet, and the media on its two sides.
pub(crate) struct FilledInterface {
    pub(crate) interface: Interface,
    pub(crate) front: Filling,
    pub(crate) back: Filling,
}

/// Returns the sheets of a valid scene, in which every region is filled by one medium.
pub(crate) fn filled(scene: &Scene) -> Box<dyn Iterator<Item = FilledInterface> + '_> {
    if !scene.surfaces.iter().any(|surface| inside(scene, surface).is_some()) {
        let ambient = scene.ambient.medium;
        let filled = move |interface| FilledInterface { interface, front: ambient, back: ambient };
        return Box::new(sheets_without_edges(scene).map(filled));
    }
    let (interfaces, vertices) = interfaces(scene);
    let mut regions = Regions::new(interfaces.len());
    let edges = edges(&interfaces, &vertices);
    regions.join_at(&interfaces, &edges);
    // a body that is not the boundary of a medium lies inside one
    rays::seen(&interfaces, &edges, |_| true).into_iter().for_each(|(a, b)| regions.join(a, b));
    let mut fillings = HashMap::from([(regions.of(Side::Outside), scene.ambient.medium)]);
    for (index, interface) in interfaces.iter().enumerate() {
        if let Some(medium) = inside(scene, &scene.surfaces[interface.surface]) {
            fillings.insert(regions.of(Side::Back(index)), Some(medium));
        }
    }
    let mut filling = move |side: Side| match fillings.get(&regions.of(side)) {
        Some(filling) => *filling,
        None => scene.ambient.medium,
    };
    let filled = move |(index, interface)| FilledInterface {
        interface,
        front: filling(Side::Front(index)),
        back: filling(Side::Back(index)),
    };
    Box::new(interfaces.into_iter().enumerate().map(filled))
}

/// The medium in front of a boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Front {
    /// The index of the surface.
    pub(super) surface: usize,
    pub(super) filling: Filling,
}

/// Reports media that are entered and never left, and regions with two conflicting media. If there
/// are none, returns the medium in front of each boundary.
pub(super) fn check(report: &mut Report, scene: &Scene) -> Vec<Front> {
    if !scene.surfaces.iter().any(|surface| inside(scene, surface).is_some()) {
        return Vec::new();
    }
    let working = scene.in_working_units();
    let (interfaces, vertices) = interfaces(&working.scene);
    let edges = edges(&interfaces, &vertices);
    if overlaps(report, scene, &interfaces, &edges) {
        return Vec::new();
    }
    let mut regions = Regions::new(interfaces.len());
    regions.join_at(&interfaces, &edges);
    if open_boundaries(report, &working, &interfaces, &edges, &mut regions) {
        return Vec::new();
    }
    let is_dielectric = |interface: &Interface| inside(scene, &scene.surfaces[interface.surface]).is_some();
    for (a, b) in rays::seen(&interfaces, &edges, is_dielectric) {
        regions.join(a, b);
    }
    fill(report, scene, &interfaces, &mut regions)
}

/// Returns the medium behind a surface, if the surface is the boundary of one.
fn inside(scene: &Scene, surface: &Surface) -> Option<usize> {
    match scene.materials[surface.material] {
        Material { kind: MaterialKind::Dielectric { inside }, .. } => Some(inside),
        _ => None,
    }
}

/// Reports boundaries of media that coincide with another surface, so that their order is
/// undetermined. Returns whether there was one.
fn overlaps(report: &mut Report, scene: &Scene, interfaces: &[Interface], edges: &[Edge]) -> bool {
    let mut told = vec![false; scene.surfaces.len()];
    for (a, b) in edges.iter().filter_map(Edge::overlapping) {
        let (a, b) = (interfaces[a].surface, interfaces[b].surface);
        let [first, second] = [&scene.surfaces[a.min(b)], &scene.surfaces[a.max(b)]];
        let concerns_media = inside(scene, first).is_some() || inside(scene, second).is_some();
        if concerns_media && !std::mem::replace(&mut told[a.max(b)], true) {
            let message = format!("`{}` overlaps `{}` in one plane", second.name, first.name);
            report.error_at(&second.place, message, "one surface between two media");
        }
    }
    told.contains(&true)
}

/// Reports each surface with the same region on both sides. Returns whether there was one.
fn open_boundaries(
    report: &mut Report,
    working: &WorkingScene,
    interfaces: &[Interface],
    edges: &[Edge],
    regions: &mut Regions,
) -> bool {
    const EXPECTED: &str =
        "a closed boundary: surfaces that meet edge to edge, split where another surface ends on them";
    let scene = working.scene.as_ref();
    let (mut of_surfaces, mut of_regions) = (HashMap::new(), HashMap::new());
    for edge in edges.iter().filter(|edge| edge.is_free()) {
        of_surfaces.entry(interfaces[edge.first()].surface).or_insert(edge);
        of_regions.entry(regions.of(Side::Back(edge.first()))).or_insert(edge);
    }
    let mut told = vec![false; scene.surfaces.len()];
    for (index, interface) in interfaces.iter().enumerate() {
        let surface = &scene.surfaces[interface.surface];
        let Some(medium) = inside(scene, surface).filter(|_| !told[interface.surface]) else { continue };
        let region = regions.of(Side::Back(index));
        if regions.of(Side::Front(index)) != region {
            continue;
        }
        told[interface.surface] = true;
        let nearest = of_surfaces.get(&interface.surface).or_else(|| of_regions.get(&region));
        let gap = nearest.map_or(String::new(), |edge| {
            let of = &scene.surfaces[interfaces[edge.first()].surface].name;
            let place = |v: Vector| {
                let v = working.units.factor.recip() * v;
                format!("[{}, {}, {}]", v.x, v.y, v.z)
            };
            let border = match (edge.center, edge.ends.map(place)) {
                (Some(center), _) => format!("rim of `{of}` around {}", place(center)),
                (None, [a, b]) => format!("edge of `{of}` from {a} to {b}"),
            };
            format!(": the {border} meets no other surface")
        });
        let medium = &scene.media[medium].name;
        let message = format!("the boundary of `{medium}` at `{}` is not closed{gap}", surface.name);
        report.error_at(&surface.place, message, EXPECTED);
    }
    told.contains(&true)
}

/// Fills every region, and reports regions with two media and boundaries between a medium and
/// itself. A region without boundaries of media is filled by the ambient medium.
fn fill(report: &mut Report, scene: &Scene, interfaces: &[Interface], regions: &mut Regions) -> Vec<Front> {
    const EXPECTED: &str =
        "faces whose vertices are counter-clockwise seen from outside the medium behind them";
    let mut fillings: HashMap<usize, (Filling, String)> = HashMap::new();
    fillings.insert(regions.of(Side::Outside), (scene.ambient.medium, "around the scene".to_owned()));
    let boundaries = || {
        let boundary = |(index, interface): (usize, &Interface)| {
            inside(scene, &scene.surfaces[interface.surface]).map(|medium| (index, interface.surface, medium))
        };
        interfaces.iter().enumerate().filter_map(boundary)
    };
    let mut told = vec![false; scene.surfaces.len()];
    for (index, surface, medium) in boundaries() {
        let name = &scene.surfaces[surface].name;
        let own = (Some(medium), format!("behind `{name}`"));
        let (filling, from) = fillings.entry(regions.of(Side::Back(index))).or_insert(own);
        if *filling != Some(medium) && !std::mem::replace(&mut told[surface], true) {
            let (own, other) = (named(scene, Some(medium)), named(scene, *filling));
            let message = format!("{own} behind `{name}` fills the same region as {other} {from}");
            report.error_at(&scene.surfaces[surface].place, message, EXPECTED);
        }
    }
    let mut fronts = Vec::new();
    for (index, surface, medium) in boundaries() {
        let front = fillings.get(&regions.of(Side::Front(index)));
        let filling = front.map_or(scene.ambient.medium, |(filling, _)| *filling);
        if filling == Some(medium) && !std::mem::replace(&mut told[surface], true) {
            let message =
                format!("{} is on both sides of `{}`", named(scene, filling), scene.surfaces[surface].name);
            report.error_at(&scene.surfaces[surface].place, message, EXPECTED);
        }
        fronts.push(Front { surface, filling });
    }
    fronts.sort_unstable();
    fronts.dedup();
    fronts
}

fn named(scene: &Scene, filling: Filling) -> String {
    filling.map_or("vacuum".to_owned(), |medium| format!("`{}`", scene.media[medium].name))
}

/// Union-find structure of the sides that bound one region: a forest in which every tree is a set.
struct Regions {
    parents: Vec<usize>,
}

impl Regions {
    /// Creates a separate set for each side of this many sheets, and for the outside.
    fn new(interfaces: usize) -> Self {
        Self { parents: (0..=2 * interfaces).collect() }
    }

    fn index(&self, side: Side) -> usize {
        match side {
            Side::Front(interface) => 2 * interface,
            Side::Back(interface) => 2 * interface + 1,
            Side::Outside => self.parents.len() - 1,
        }
    }

    /// Returns the region that a side bounds.
    fn of(&mut self, side: Side) -> usize {
        let mut node = self.index(side);
        while self.parents[node] != node {
            self.parents[node] = self.parents[self.parents[node]];
            node = self.parents[node];
        }
        node
    }

    /// Joins the sides that face each other at edges, and the sides of a disk with those of the
    /// surface on which it lies.
    fn join_at(&mut self, interfaces: &[Interface], edges: &[Edge]) {
        for (a, b) in edges.iter().flat_map(Edge::facing) {
            self.join(a, b);
        }
        for (index, disk) in
            interfaces.iter().enumerate().filter_map(|(index, interface)| Some((index, interface.disk()?)))
        {
            if let Some(base) = interfaces.iter().position(|interface| interface.round_holes().contains(disk))
            {
                self.join(Side::Front(index), Side::Front(base));
                self.join(Side::Back(index), Side::Back(base));
            }
        }
    }

    fn join(&mut self, a: Side, b: Side) {
        let (a, b) = (self.of(a), self.of(b));
        self.parents[a] = b;
    }
}
