//! Light transport: computes the pieces of a luminous outline that each receiving point sees.
//!
//! Points that are close to each other share the search for possible occluders.

use super::gathered_light::Arriving;
use super::measure::Measure;
use super::whole_elements::Whole;
use crate::geometry::{Edges, Vector};
use crate::visibility::{Between, Borders, Face, Looking, ReceivingArea, Screens, Workspace};
use forms_kernels::edge_form_factor;
use std::sync::Arc;

/// Number of values in a vector of the widest kind.
const LANES: usize = 8;

/// Receiving points, all of which look to one side or in all directions, and a convex outline that
/// contains them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Group<'g> {
    pub(crate) points: &'g [Vector],
    pub(crate) outline: &'g [Vector],
    pub(crate) measure: Measure,
}

/// The geometry that light passes through.
pub(crate) struct Transport {
    pub(crate) faces: Arc<Vec<Face>>,
    pub(crate) screens: Arc<Screens>,
    /// Whether occluders are searched.
    pub(crate) occlusion: bool,
    /// Whether faces hide the light from outside that comes from behind them. Where occluders are left
    /// out they hide none: faces one behind the other would hide the same light more than once.
    pub(crate) hides_outside: bool,
    /// Allowed quadrature error, relative to the integral.
    pub(crate) accuracy: f64,
}

/// Lists that are reused from group to group.
#[derive(Default)]
pub(crate) struct Scratch {
    pub(crate) between: Vec<u32>,
    /// Possible occluders of any part of a face.
    pub(crate) before_face: Vec<u32>,
    pub(crate) view: Workspace,
    /// Workspace that only occluders need.
    borders: Option<Box<Borders>>,
    edges: Edges,
    /// For each point of a group the measure, over π, of the visible part of a luminous outline.
    measures: Vec<f64>,
    pub(crate) arriving: Arriving,
    pub(crate) whole: Whole,
    /// The points of a group that see all of an element.
    pub(crate) seeing: Vec<usize>,
}

/// Visibility of a luminous outline from a group of points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Seen {
    Nothing,
    /// Every point sees all of it.
    Whole,
    /// Visibility has to be computed for each point.
    Parts,
}

impl Transport {
    /// Returns the faces of a receiving area. The faces of a surface follow each other.
    pub(crate) fn faces_in(&self, area: ReceivingArea) -> impl Iterator<Item = &Face> + Clone {
        self.indices_in(area).map(|index| &self.faces[index])
    }

    /// Returns the indices of these faces.
    pub(crate) fn indices_in(&self, area: ReceivingArea) -> impl Iterator<Item = usize> + Clone {
        let first = self.faces.partition_point(|face| face.surface < area.surface);
        let own = self.faces[first..].iter().take_while(move |face| face.surface == area.surface);
        own.enumerate().filter(move |(_, face)| area.contains(face)).map(move |(index, _)| first + index)
    }

    /// Returns the area of these faces.
    pub(crate) fn size_of(&self, area: ReceivingArea) -> f64 {
        self.faces_in(area).map(|face| face.area).sum()
    }

    /// Returns the maximum number of operations to see this number of edges from this number of
    /// points, with vector instructions: each edge is computed once, and each occluder can cut it
    /// in scalar operations.
    pub(crate) fn operations(&self, points: usize, edges: usize) -> f64 {
        let screens = if self.occlusion { self.screens.count() } else { 0 };
        let of_edge = edge_form_factor::OPERATIONS * (1 + LANES * screens);
        points as f64 * edges as f64 * of_edge as f64
    }

    /// Calls `each` for all points and all convex pieces that they see of a luminous outline with
    /// this normal: with the index of the point, and with the piece relative to the point.
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

    /// Returns the visibility of a luminous outline from a group, where it is the same for all
    /// points. Stores the possible occluders, searched among all screens or among some of them.
    pub(crate) fn seen(
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

    /// Returns the same visibility for these possible occluders, if the outline is neither behind
    /// nor below all points.
    pub(crate) fn seen_past(
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

    /// Calls `each` with the pieces that the points of a group see, after the search for possible
    /// occluders.
    pub(crate) fn see_parts(
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

    /// Returns the measure, over π, of the part of a luminous outline with this normal that each
    /// point of a group sees; `None` if no point sees any of it.
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

    /// Returns the same measures if these screens are the only possible occluders.
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

    /// Measures the visible part of a luminous outline behind these screens; returns whether any
    /// part is visible.
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

/// Whether all points of a group are behind a luminous outline with this normal, or the outline is
/// below their horizon.
fn is_turned_away(group: Group, (outline, normal): (&[Vector], Vector)) -> bool {
    let behind = |points: &[Vector], normal: Vector, at: Vector| {
        points.iter().all(|&point| normal.dot(point - at) <= 0.0)
    };
    let is_below = |horizon| behind(outline, horizon, group.points[0]);
    behind(group.outline, normal, outline[0]) || group.measure.horizon().is_some_and(is_below)
}
