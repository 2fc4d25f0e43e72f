//! What a point sees of a luminaire: the luminaire, clipped at the point's horizon, becomes one convex piece, and what screens leave of it
//! several.
//!
//! Each screen in front of the luminaire's plane is a cone of directions that is cut out. Pieces are relative to the point.

use super::border::Border;
use super::bounds::Bounds;
use super::{Screen, Screens, Vector};
use crate::geometry::clip::{Pieces, split};
use crate::geometry::cone::{Cone, Scratch};

/// Lists that are reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    pub(super) luminaire: Vec<Vector>,
    screen: Vec<Vector>,
    luminaire_cone: Cone,
    screen_cone: Cone,
    pub(super) seen: Vec<bool>,
    pub(super) border: Border,
    scratch: Scratch,
    visible: Pieces,
    rest: Pieces,
}

/// A receiver and the plane of a luminaire in front of which it is.
#[derive(Clone, Copy)]
struct View {
    position: Vector,
    horizon: Option<Vector>,
    luminaire_normal: Vector,
    /// The distance of the receiver from the luminaire's plane.
    height: f64,
}

impl Screens {
    /// What a receiver sees of a luminaire with some screens in between: convex pieces relative to `position`, above the horizon of
    /// `normal` if there is one. There are none where the receiver is behind the luminaire or in its plane.
    pub(crate) fn visible<'w>(
        &self,
        position: Vector,
        normal: Option<Vector>,
        luminaire: &[Vector],
        luminaire_normal: Vector,
        screens: &[u32],
        work: &'w mut Workspace,
    ) -> impl Iterator<Item = &'w [Vector]> + use<'w> {
        work.visible.clear();
        let height = luminaire_normal.dot(position - luminaire[0]);
        if height > self.resolution {
            let view = View { position, horizon: normal, luminaire_normal, height };
            work.begin(luminaire, view);
            if !work.visible.is_empty() && !screens.is_empty() {
                work.luminaire_cone.set(work.visible.last(), true);
                for &index in screens {
                    self.hide_any(index as usize, view, work);
                    if work.visible.is_empty() {
                        break;
                    }
                }
            }
        }
        work.visible.iter()
    }

    /// Cuts a screen or a body out of what is visible.
    fn hide_any(&self, index: usize, view: View, work: &mut Workspace) {
        if let Some(screen) = self.screens.get(index) {
            self.hide(screen, view, work);
            return;
        }
        let body = &self.bodies[index - self.screens.len()];
        if work.is_beside(&body.bounds, view) {
            return;
        }
        let Workspace { screen_cone, seen, .. } = &mut *work;
        let shadow = body.shadow(view.position, self.resolution, seen);
        let sides = |edges| screen_cone.set_sides(Iterator::map(edges, |[a, b]: [Vector; 2]| b.cross(a)));
        if shadow.map(sides).is_some() {
            work.cut();
        } else {
            body.screens.iter().for_each(|&screen| self.hide(&self.screens[screen as usize], view, work));
        }
    }

    /// Whether a screen's plane, at this distance from a receiver, has the receiver and a part of the luminaire on different sides. Corners
    /// are relative to the receiver.
    pub(super) fn parts(&self, screen: &Screen, distance: f64, luminaire: &[Vector]) -> bool {
        let is_beyond = |v: &Vector| {
            let of_luminaire = distance + screen.plane.normal.dot(*v);
            if distance > 0.0 { of_luminaire < -self.resolution } else { of_luminaire > self.resolution }
        };
        distance.abs() > self.resolution && luminaire.iter().any(is_beyond)
    }

    /// Cuts a screen out of what is visible, if it has the receiver and a part of the luminaire on different sides.
    fn hide(&self, screen: &Screen, view: View, work: &mut Workspace) {
        let distance = screen.plane.distance(view.position);
        if self.parts(screen, distance, &work.luminaire) {
            work.screen.clear();
            work.screen.extend(screen.vertices.iter().map(|&v| v - view.position));
            work.hide(view, distance > 0.0, self.resolution);
        }
    }
}

impl Workspace {
    /// Begins with what of the luminaire is above the horizon.
    fn begin(&mut self, luminaire: &[Vector], view: View) {
        self.luminaire.clear();
        self.luminaire.extend(luminaire.iter().map(|&v| v - view.position));
        match view.horizon {
            Some(normal) if self.luminaire.iter().any(|&v| normal.dot(v) < 0.0) => {
                let Scratch { inside, outside, .. } = &mut self.scratch;
                split(&self.luminaire, |x| normal.dot(x), inside, outside);
                if !inside.is_empty() {
                    self.visible.push(inside);
                }
            }
            _ => self.visible.push(&self.luminaire),
        }
    }

    /// Cuts the cone over what of the screen is in front of the luminaire's plane out of what is visible.
    fn hide(&mut self, view: View, from_front: bool, resolution: f64) {
        let height = |v: Vector| view.height + view.luminaire_normal.dot(v);
        let (lowest, highest) =
            self.screen.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| {
                let height = height(v);
                (low.min(height), high.max(height))
            });
        if highest <= resolution {
            return;
        }
        if lowest < 0.0 {
            let Scratch { inside, outside, .. } = &mut self.scratch;
            split(&self.screen, height, inside, outside);
            std::mem::swap(&mut self.screen, inside);
        }
        let below_horizon =
            view.horizon.is_some_and(|normal| self.screen.iter().all(|&x| normal.dot(x) <= 0.0));
        if below_horizon || self.luminaire_cone.misses(&self.screen) {
            return;
        }
        self.screen_cone.set(&self.screen, from_front);
        self.cut();
    }

    /// Whether a box is below the horizon or beside the luminaire, as far as that is easily seen.
    fn is_beside(&self, bounds: &Bounds, view: View) -> bool {
        let is_beyond = |side: Vector| side.dot(bounds.farthest(side) - view.position) <= 0.0;
        view.horizon.is_some_and(is_beyond) || self.luminaire_cone.sides().iter().any(|&side| is_beyond(side))
    }

    /// Cuts the screen's cone out of what is visible.
    fn cut(&mut self) {
        self.rest.clear();
        for piece in self.visible.iter() {
            self.screen_cone.cut_from(piece, &mut self.scratch, &mut self.rest);
        }
        std::mem::swap(&mut self.visible, &mut self.rest);
    }
}
