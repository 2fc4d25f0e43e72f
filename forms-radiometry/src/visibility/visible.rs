//! Visible part: clips the occluders out of the part of a luminaire above a point's horizon; one
//! convex piece becomes several.
//!
//! The cone of directions of each screen in front of the luminaire's plane is clipped out. Pieces
//! are relative to the point.

use super::cone::{Cutting, Scratch};
use super::horizon::{View, Workspace};
use super::{Screen, Screens};
use crate::geometry::Vector;
use crate::geometry::bounds::Bounds;
use crate::geometry::clip::{Pieces, split};

/// A luminaire relative to a receiver, its visible part, and buffers for clipping.
struct Cut<'w> {
    luminaire: &'w [Vector],
    visible: &'w mut Pieces,
    lists: &'w mut Cutting,
}

impl Screens {
    /// Returns the part of a luminaire that a receiver sees behind some screens: convex pieces
    /// relative to `position`, above the horizon of `normal` if there is one. There are none where
    /// the receiver is behind the luminaire or in its plane.
    pub(crate) fn visible<'w>(
        &self,
        position: Vector,
        normal: Option<Vector>,
        luminaire: &[Vector],
        luminaire_normal: Vector,
        screens: &[u32],
        work: &'w mut Workspace,
    ) -> impl Iterator<Item = &'w [Vector]> + use<'w> {
        let view = work.begin(position, normal, (luminaire, luminaire_normal), self.resolution);
        if !work.visible.is_empty() && !screens.is_empty() {
            let mut cut = work.cut();
            cut.lists.luminaire_cone.set(cut.visible.last(), true);
            for &index in screens {
                self.hide_any(index as usize, view, &mut cut);
                if cut.visible.is_empty() {
                    break;
                }
            }
        }
        work.visible.iter()
    }

    /// Clips a screen or a body out of the visible part.
    fn hide_any(&self, index: usize, view: View, cut: &mut Cut) {
        if let Some(screen) = self.screens.get(index) {
            self.hide(screen, view, cut);
            return;
        }
        let body = &self.bodies[index - self.screens.len()];
        if cut.is_beside(&body.bounds, view) {
            return;
        }
        let Cutting { screen_cone, seen, .. } = &mut *cut.lists;
        let shadow = body.shadow(view.position, self.resolution, seen);
        let side = |edge: [Vector; 2]| {
            let [a, b] = edge.map(|end| end - view.position);
            b.cross(a)
        };
        let sides = |edges| screen_cone.set_sides(Iterator::map(edges, side));
        if shadow.map(sides).is_some() {
            cut.cut();
        } else {
            body.screens.iter().for_each(|&screen| self.hide(&self.screens[screen as usize], view, cut));
        }
    }

    /// Whether the plane of a screen, at this distance from a receiver, has the receiver and a part
    /// of the luminaire on different sides. Corners are relative to the receiver.
    fn parts(&self, screen: &Screen, distance: f64, luminaire: &[Vector]) -> bool {
        let is_beyond = |v: &Vector| {
            let of_luminaire = distance + screen.plane.normal.dot(*v);
            if distance > 0.0 { of_luminaire < -self.resolution } else { of_luminaire > self.resolution }
        };
        distance.abs() > self.resolution && luminaire.iter().any(is_beyond)
    }

    /// Clips a screen out of the visible part, if it has the receiver and a part of the luminaire
    /// on different sides.
    fn hide(&self, screen: &Screen, view: View, cut: &mut Cut) {
        let distance = screen.plane.distance(view.position);
        if self.parts(screen, distance, cut.luminaire) {
            cut.lists.screen.clear();
            cut.lists.screen.extend(screen.vertices.iter().map(|&v| v - view.position));
            cut.hide(view, distance > 0.0, self.resolution);
        }
    }
}

impl Workspace {
    /// Returns the visible part of the luminaire, with buffers for clipping.
    fn cut(&mut self) -> Cut<'_> {
        let lists = self.cutting.get_or_insert_default();
        Cut { luminaire: &self.luminaire, visible: &mut self.visible, lists }
    }
}

impl Cut<'_> {
    /// Clips the cone over the part of the screen in front of the luminaire's plane out of the
    /// visible part.
    fn hide(&mut self, view: View, from_front: bool, resolution: f64) {
        let height = |v: Vector| view.height + view.luminaire_normal.dot(v);
        let (lowest, highest) =
            self.lists.screen.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| {
                let height = height(v);
                (low.min(height), high.max(height))
            });
        if highest <= resolution {
            return;
        }
        if lowest < 0.0 {
            let Scratch { inside, outside, .. } = &mut self.lists.scratch;
            split(&self.lists.screen, height, inside, outside);
            std::mem::swap(&mut self.lists.screen, inside);
        }
        let below_horizon =
            view.horizon.is_some_and(|normal| self.lists.screen.iter().all(|&x| normal.dot(x) <= 0.0));
        if below_horizon || self.lists.luminaire_cone.misses(&self.lists.screen) {
            return;
        }
        self.lists.screen_cone.set(&self.lists.screen, from_front);
        self.cut();
    }

    /// Whether a box is below the horizon or outside the luminaire's cone, by a conservative test.
    fn is_beside(&self, bounds: &Bounds, view: View) -> bool {
        let is_beyond = |side: Vector| side.dot(bounds.farthest(side) - view.position) <= 0.0;
        view.horizon.is_some_and(is_beyond)
            || self.lists.luminaire_cone.sides().iter().any(|&side| is_beyond(side))
    }

    /// Clips the screen's cone out of the visible part.
    fn cut(&mut self) {
        self.lists.rest.clear();
        for piece in self.visible.iter() {
            self.lists.screen_cone.cut_from(piece, &mut self.lists.scratch, &mut self.lists.rest);
        }
        std::mem::swap(self.visible, &mut self.lists.rest);
    }
}
