//! Occluder search: finds the screens that can occlude a luminaire from receivers, those that some
//! segment between the two outlines intersects.
//!
//! A screen can occlude only if it rises above the receivers' horizon, lies in front of the
//! luminaire, has a receiver and a part of the luminaire on different sides, and is not separated
//! by a plane from the shaft between them. The intersection of the shaft with the screen's plane is
//! the convex hull of the points where segments between corners on different sides intersect the
//! plane. If the screen contains all of these points, it hides everything; if all lie beyond one of
//! its edges, it hides nothing. Screens of a convex body are treated together.

use super::shaft::Shaft;
use super::tree::Query;
use super::{Screen, Screens};
use crate::geometry::bounds::Bounds;
use crate::geometry::{Plane, Vector};
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Inline capacities for the corners of two quadrilaterals and for the intersections between them.
/// Only larger outlines allocate memory.
const CORNERS: usize = 8;
const PASSAGES: usize = 16;

/// Degree of occlusion of a luminaire.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Between {
    /// Nothing can be hidden.
    Nothing,
    /// A part can be hidden.
    Some,
    /// Everything is hidden from everywhere by one screen or one body.
    All,
}

struct Search<'s> {
    screens: &'s Screens,
    shaft: Shaft<'s>,
    /// The corners of both outlines, each with its distance from a screen's plane; the buffer is
    /// reused from screen to screen.
    corners: SmallVec<[(Vector, f64); CORNERS]>,
    /// The points where segments intersect that plane; the buffer is also reused.
    passages: SmallVec<[Vector; PASSAGES]>,
    found: &'s mut Vec<u32>,
    luminaire: Plane,
    /// The bodies whose screens were found.
    bodies: Vec<(u32, Part)>,
    all: bool,
}

/// The part of a body that was found.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// One screen, at this index of the list.
    One(usize),
    /// Screens that occlude individually, because the body is not completely in front of the
    /// luminaire.
    Several,
    /// The body, which replaces all of its screens.
    Whole,
}

impl Query for Search<'_> {
    fn may_be_in(&self, bounds: &Bounds) -> bool {
        self.shaft.may_meet(bounds)
    }

    fn at(&mut self, leaf: usize) -> ControlFlow<()> {
        let body = self.screens.body_of[leaf];
        let place = body.and_then(|body| self.bodies.iter().position(|(known, _)| *known == body));
        if place.is_some_and(|place| self.bodies[place].1 == Part::Whole) {
            return ControlFlow::Continue(());
        }
        match self.hidden_by(&self.screens.screens[leaf]) {
            Between::Nothing => ControlFlow::Continue(()),
            Between::Some => self.take(leaf as u32, body, place),
            Between::All => self.hide_all(leaf as u32),
        }
    }
}

impl Search<'_> {
    fn hide_all(&mut self, index: u32) -> ControlFlow<()> {
        self.all = true;
        self.found.clear();
        self.found.push(index);
        ControlFlow::Break(())
    }

    /// Adds a screen that can occlude. If it is the second screen of its body and the whole body is
    /// in front of the luminaire, adds the body instead of both and of its other screens. `place`
    /// is the index of the body in `bodies`.
    fn take(&mut self, screen: u32, body: Option<u32>, place: Option<usize>) -> ControlFlow<()> {
        let (Some(index), Some(place)) = (body, place) else {
            self.bodies.extend(body.map(|body| (body, Part::One(self.found.len()))));
            self.found.push(screen);
            return ControlFlow::Continue(());
        };
        let body = &self.screens.bodies[index as usize];
        let part = &mut self.bodies[place].1;
        match *part {
            Part::One(first) if body.is_before(self.luminaire, self.screens.rounding) => {
                *part = Part::Whole;
                let index = self.screens.screens.len() as u32 + index;
                self.found[first] = index;
                if body.hides_all(self.shaft.outlines) {
                    return self.hide_all(index);
                }
            }
            _ => {
                *part = Part::Several;
                self.found.push(screen);
            }
        }
        ControlFlow::Continue(())
    }

    fn hidden_by(&mut self, screen: &Screen) -> Between {
        let [receivers, luminaire] = self.sides(screen.plane);
        let parts = (receivers.in_front && luminaire.behind) || (receivers.behind && luminaire.in_front);
        if !parts {
            return Between::Nothing;
        }
        self.shaft.complete();
        if !self.shaft.may_hold(&screen.vertices) {
            return Between::Nothing;
        }
        self.find_passages();
        let mut holds_all = receivers.in_front != receivers.behind && luminaire.in_front != luminaire.behind;
        for [a, b] in screen.edges() {
            let inward = screen.plane.normal.cross(b - a);
            let rounding = self.screens.rounding * inward.largest();
            let mut all_beyond = true;
            for &passage in &self.passages {
                let inside = inward.dot(passage - a);
                all_beyond &= inside <= rounding;
                holds_all &= inside >= -rounding;
            }
            if all_beyond {
                return Between::Nothing;
            }
        }
        if holds_all { Between::All } else { Between::Some }
    }

    /// Returns the sides of a plane on which the corners of both outlines lie.
    fn sides(&mut self, plane: Plane) -> [Sides; 2] {
        self.corners.clear();
        self.shaft.outlines.map(|outline| {
            let start = self.corners.len();
            self.corners.extend(outline.iter().map(|&corner| (corner, plane.distance(corner))));
            Sides::of(&self.corners[start..], self.screens.resolution)
        })
    }

    /// Computes points that include all corners of the intersection of the plane with the shaft;
    /// the other points lie inside it.
    fn find_passages(&mut self) {
        self.passages.clear();
        for &(a, alpha) in self.corners.iter().filter(|(_, alpha)| *alpha >= 0.0) {
            for &(b, beta) in self.corners.iter().filter(|(_, beta)| *beta <= 0.0) {
                let share = if alpha > 0.0 { alpha / (alpha - beta) } else { 0.0 };
                self.passages.push(a + share * (b - a));
            }
        }
    }
}

/// The sides of a plane on which there are points.
struct Sides {
    in_front: bool,
    behind: bool,
}

impl Sides {
    /// Returns the sides for points with these distances; a point whose distance is below the
    /// resolution counts as lying in the plane.
    fn of(points: &[(Vector, f64)], resolution: f64) -> Self {
        let mut sides = Self { in_front: false, behind: false };
        for (_, distance) in points {
            sides.in_front |= *distance > resolution;
            sides.behind |= *distance < -resolution;
        }
        sides
    }
}

impl Screens {
    /// Finds the screens that can occlude a convex luminaire from receivers in a convex outline,
    /// which face the side of `normal` if there is one. `found` receives their indices; if one
    /// screen or body hides everything, only its index. Returns [`Between::Nothing`] where no
    /// receiver faces the luminaire.
    pub(crate) fn between(
        &self,
        receivers: &[Vector],
        normal: Option<Vector>,
        luminaire: &[Vector],
        luminaire_normal: Vector,
        found: &mut Vec<u32>,
    ) -> Between {
        self.between_among(None, (receivers, normal), (luminaire, luminaire_normal), found)
    }

    /// Searches like [`between`](Self::between), but only among these screens. The potential
    /// occluders of a part of a luminaire are among those of the whole.
    pub(crate) fn between_among(
        &self,
        among: Option<&[u32]>,
        (receivers, normal): (&[Vector], Option<Vector>),
        (luminaire, luminaire_normal): (&[Vector], Vector),
        found: &mut Vec<u32>,
    ) -> Between {
        found.clear();
        if !self.face_each_other(receivers, normal, luminaire, luminaire_normal) {
            return Between::Nothing;
        }
        let facing = Plane { point: luminaire[0], normal: luminaire_normal };
        let ground = normal.map(|normal| Plane { point: receivers[0], normal });
        let mut search = Search {
            screens: self,
            shaft: Shaft::new([receivers, luminaire], self.rounding),
            corners: SmallVec::new(),
            passages: SmallVec::new(),
            found,
            luminaire: facing,
            bodies: Vec::new(),
            all: false,
        };
        let shaft = &mut search.shaft;
        [Some(facing), ground].into_iter().flatten().for_each(|plane| shaft.cut(plane, self.resolution));
        let _ = match among {
            None => self.tree.walk(&mut search),
            Some(among) => {
                let mut screens = among.iter().flat_map(|index| self.screens_of(index));
                screens.try_for_each(|&screen| search.at(screen as usize))
            }
        };
        match (search.all, found.is_empty()) {
            (true, _) => Between::All,
            (false, true) => Between::Nothing,
            (false, false) => Between::Some,
        }
    }
}
