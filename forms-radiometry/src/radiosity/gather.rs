//! Gathering: points that receive and a luminous outline become the pieces of it that each point sees.
//!
//! Points that are close to each other share the search for what can come in between.

use super::arriving::Arriving;
use super::measure::Measure;
use super::whole::Whole;
use crate::geometry::{Between, Borders, Edges, Face, Looking, Screens, Vector, Workspace};
use crate::kernels::edge_form_factor;

/// How many numbers go into a vector of the widest kind.
const LANES: usize = 8;

/// Points that receive, all looking to one side or to all, and a convex outline that holds them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group<'g> {
    pub(crate) points: &'g [Vector],
    pub(crate) outline: &'g [Vector],
    pub(crate) measure: Measure,
}

/// The geometry that light passes through.
pub(crate) struct Transport {
    pub(crate) faces: Vec<Face>,
    pub(crate) screens: Screens,
    /// Whether what stands in between is looked for.
    pub(crate) occlusion: bool,
    /// The error that rules of integration may leave, relative to what they integrate.
    pub(crate) accuracy: f64,
}

/// Lists that are reused from group to group.
#[derive(Default)]
pub(crate) struct Scratch {
    pub(super) between: Vec<u32>,
    /// What may come in between before any of a face.
    pub(super) before_face: Vec<u32>,
    pub(super) view: Workspace,
    /// What only screens take.
    borders: Option<Box<Borders>>,
    edges: Edges,
    /// Of each point of a group the measure, over π, of what it sees of a luminaire.
    measures: Vec<f64>,
    pub(super) arriving: Arriving,
    pub(super) whole: Whole,
    /// The points of a group that see all of an element.
    pub(super) seeing: Vec<usize>,
}

/// What a group of points sees of a luminous outline.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Seen {
    Nothing,
    /// Every point sees all of it.
    Whole,
    /// Each point has to be asked.
    Parts,
}

impl Transport {
    /// The faces of the front of a surface.
    pub(crate) fn fronts(&self, surface: usize) -> impl Iterator<Item = &Face> + Clone {
        self.faces.iter().filter(move |face| face.is_front_of(surface))
    }

    /// Their area.
    pub(crate) fn front_area(&self, surface: usize) -> f64 {
        self.fronts(surface).map(|face| face.area).sum()
    }

    /// How many operations it takes at most to see so many edges from so many points, in vectors: each edge is computed once, and each screen
    /// may cut it in single numbers.
    pub(crate) fn operations(&self, points: usize, edges: usize) -> f64 {
        let screens = if self.occlusion { self.screens.count() } else { 0 };
        let of_edge = edge_form_factor::OPERATIONS * (1 + LANES * screens);
        points as f64 * edges as f64 * of_edge as f64
    }

    /// Calls `each` with the index of a point and a convex piece that it sees of a luminous outline with this normal,
    /// relative to the point, for all of them.
    pub(crate) fn see(
        &self,
        group: Group,
        (outline, normal): (&[Vector], Vector),
        scratch: &mut Scratch,
        mut each: impl FnMut(usize, &[Vector]),
    ) {
        if self.seen(group, (outline, normal), None, &mut scratch.between) != Seen::Nothing {
            self.see_parts(group, (outline, normal), &scratch.between, &mut scratch.view, &mut each);
        }
    }

    /// What a group sees of a luminous outline, as far as that is the same for all points; what may come in between is remembered, of all
    /// screens or among some.
    pub(super) fn seen(
        &self,
        group: Group,
        (outline, normal): (&[Vector], Vector),
        among: Option<&[u32]>,
        between: &mut Vec<u32>,
    ) -> Seen {
        if is_turned_away(group, (outline, normal)) {
            return Seen::Nothing;
        }
        between.clear();
        if self.occlusion {
            let receivers = (group.outline, group.measure.horizon());
            let found = self.screens.between_among(among, receivers, (outline, normal), between);
            if matches!(found, Between::All) {
                return Seen::Nothing;
            }
        }
        self.seen_past(group, (outline, normal), between)
    }

    /// The same where this may come in between, and the luminaire is neither behind nor below all points.
    pub(super) fn seen_past(
        &self,
        group: Group,
        (outline, normal): (&[Vector], Vector),
        between: &[u32],
    ) -> Seen {
        let is_before = |&point: &Vector| normal.dot(point - outline[0]) > self.screens.resolution();
        let is_above = |horizon: Vector| {
            let least = |&point: &Vector| outline.iter().all(|&v| horizon.dot(v - point) >= 0.0);
            group.outline.iter().all(least)
        };
        let is_whole = between.is_empty()
            && group.outline.iter().all(is_before)
            && group.measure.horizon().is_none_or(is_above);
        if is_whole { Seen::Whole } else { Seen::Parts }
    }

    /// The pieces that the points of a group see, after what may come in between was looked for.
    pub(super) fn see_parts(
        &self,
        group: Group,
        (outline, normal): (&[Vector], Vector),
        between: &[u32],
        view: &mut Workspace,
        mut each: impl FnMut(usize, &[Vector]),
    ) {
        let horizon = group.measure.horizon();
        for (index, &point) in group.points.iter().enumerate() {
            if between.is_empty() {
                let piece = view.above_horizon(point, horizon, (outline, normal), self.screens.resolution());
                if !piece.is_empty() {
                    each(index, piece);
                }
                continue;
            }
            for piece in self.screens.visible(point, horizon, outline, normal, between, view) {
                each(index, piece);
            }
        }
    }

    /// The measure, over π, of what each point of a group sees of a luminous outline with this normal; nothing where none sees any of it.
    pub(crate) fn measured<'s>(
        &self,
        group: Group,
        luminaire: (&[Vector], Vector),
        scratch: &'s mut Scratch,
    ) -> Option<&'s [f64]> {
        let mut between = std::mem::take(&mut scratch.between);
        let seen = self.seen(group, luminaire, None, &mut between);
        let is_seen = self.measure_seen(seen, group, luminaire, &between, scratch);
        scratch.between = between;
        is_seen.then_some(&scratch.measures)
    }

    /// The same where these screens, and no others, may come in between.
    pub(crate) fn measured_past<'s>(
        &self,
        group: Group,
        luminaire: (&[Vector], Vector),
        between: &[u32],
        scratch: &'s mut Scratch,
    ) -> Option<&'s [f64]> {
        let is_away = is_turned_away(group, luminaire);
        let seen = if is_away { Seen::Nothing } else { self.seen_past(group, luminaire, between) };
        let is_seen = self.measure_seen(seen, group, luminaire, between, scratch);
        is_seen.then_some(&scratch.measures)
    }

    /// Measures what is seen like this past these screens; says whether any of it is.
    fn measure_seen(
        &self,
        seen: Seen,
        group: Group,
        luminaire: (&[Vector], Vector),
        screens: &[u32],
        scratch: &mut Scratch,
    ) -> bool {
        if seen == Seen::Nothing {
            return false;
        }
        let Scratch { view, borders, edges, measures, .. } = scratch;
        measures.clear();
        measures.resize(group.points.len(), 0.0);
        let Group { points, outline, measure } = group;
        match measure.along() {
            None => self.see_parts(group, luminaire, screens, view, |index, piece| {
                measures[index] += measure.of(piece);
            }),
            Some(along) if seen == Seen::Whole => {
                edges.add_form_factors_of_whole((points, luminaire.0), along, measures);
            }
            Some((along, sign)) if screens.is_empty() => {
                edges.clear();
                self.see_parts(group, luminaire, screens, view, |index, piece| edges.push(index, piece));
                edges.add_form_factors(along, sign, measures);
            }
            Some(along) => {
                let borders = borders.get_or_insert_default();
                let looking = Looking { points, outline, horizon: measure.horizon(), luminaire, screens };
                self.screens.add_form_factors(looking, along, (view, borders), measures);
            }
        }
        true
    }
}

/// Whether all points of a group are behind a luminaire with this normal, or it is below their horizon.
fn is_turned_away(group: Group, (outline, normal): (&[Vector], Vector)) -> bool {
    let behind = |points: &[Vector], normal: Vector, at: Vector| {
        points.iter().all(|&point| normal.dot(point - at) <= 0.0)
    };
    let is_below = |horizon| behind(outline, horizon, group.points[0]);
    behind(group.outline, normal, outline[0]) || group.measure.horizon().is_some_and(is_below)
}
