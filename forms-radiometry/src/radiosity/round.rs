//! Round shapes as points see them: the measure of disks and spheres as a whole, and the occlusion
//! that their tessellation misses.
//!
//! ```text
//! sphere or disk ─ no occluder, nor the gap of another tessellation ─▶ its measure as a whole
//! a face ─┬─ no piece before it ─▶ a bound on the gap between a shape and its tessellation
//!         └─ a piece before all of it ─▶ whether the shape itself hides the face
//! ```

use super::direct::Lights;
use super::measure::Measure;
use super::point_lights::hides;
use super::transport::{Scratch, Transport};
use crate::faces::round_surfaces;
use crate::form_factor::double_double::{Rounded, SeenWhole};
use crate::geometry::{Round, Vector, bulge};
use crate::scene::{Light, LightKind, Scene, Shape};
use crate::visibility::{Between, Face};
use forms::math::Real;

impl Measure {
    /// Returns the measure, over π, of a disk or sphere without occluders, if it has a closed form.
    pub(super) fn of_whole(self, point: Vector, shape: &dyn SeenWhole) -> Option<Rounded> {
        match self {
            Self::Plane(normal) => shape.form_factor(point, normal, true),
            Self::Flow(axis) => Some(shape.form_factor(point, axis, false)?.times(-1.0)),
            Self::Sphere => shape.solid_angle_over_pi(point),
        }
    }

    /// Returns a bound on the measure, over π, of any part of an outline.
    pub(super) fn at_most(self, point: Vector, outline: &[Vector]) -> f64 {
        let whole = if let Self::Flow(_) = self { Self::Sphere } else { self };
        whole.precisely(point, outline).value.to_f64()
    }
}

impl Lights<'_> {
    /// Returns the measure, over π, of a disk or sphere that a point sees as a whole, and whether
    /// it sees the back.
    pub(super) fn whole(
        &self,
        (point, measure): (Vector, Measure),
        surface: usize,
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Option<(Rounded, bool)> {
        let shape: &dyn SeenWhole = match &self.scene().surfaces[surface].shape {
            Shape::Sphere(sphere) => sphere,
            Shape::Disk(disk) => disk,
            Shape::Polygon(_) | Shape::Mesh(_) | Shape::Quadric(_) => return None,
        };
        if self.scene().surfaces.len() > 1 {
            let (outline, normal) = shape.outline(point)?;
            let points = [point];
            let receivers = (points.as_slice(), measure.horizon());
            let luminaire = (outline.as_slice(), normal);
            let found = transport.screens.between_among(None, receivers, luminaire, &mut scratch.between);
            let mut before = transport.screens.fronts(&scratch.between);
            let is_hidden = found == Between::All
                || before.any(|face| transport.faces[face].surface != surface)
                || bulges(round_surfaces(self.scene()), (point, measure.horizon()), luminaire, Some(surface))
                    > 0.0;
            if is_hidden {
                return None;
            }
        }
        Some((measure.of_whole(point, shape)?, !shape.shows_front(point)))
    }

    /// Whether a face that is fully occluded from a point is certainly hidden: no piece of a round
    /// shape is among the occluders, or the shape itself hides all of the face.
    pub(super) fn is_surely_hidden(
        &self,
        point: Vector,
        face: &Face,
        transport: &Transport,
        between: &[u32],
    ) -> bool {
        let surfaces = transport.screens.fronts(between).map(|front| transport.faces[front].surface);
        let round = surfaces.filter_map(|surface| self.scene().surfaces[surface].shape.as_round());
        round.take(1).all(|shape| shape.hides(point, &face.vertices))
    }
}

/// Returns a bound on the solid angle, over π, of the part of an outline that disks and spheres
/// other than this one hide from a point while their pieces hide nothing. The outline faces the
/// point.
pub(crate) fn bulges<'s>(
    round: impl Iterator<Item = (usize, &'s dyn Round)>,
    at: (Vector, Option<Vector>),
    luminaire: (&[Vector], Vector),
    own: Option<usize>,
) -> f64 {
    let others = round.filter(|(index, _)| Some(*index) != own);
    others.map(|(_, shape)| bulge(shape, at, luminaire)).sum()
}

/// Whether a point sees a point or distant light. `None` if that is unknown: the first occluder is
/// a piece of a disk or sphere that does not itself occlude the light.
pub(super) fn sees(point: Vector, light: &Light, scene: &Scene, transport: &Transport) -> Option<bool> {
    if !transport.occlusion {
        return Some(true);
    }
    let way = |to: f64| match light.kind {
        LightKind::Point { position, .. } => position - point,
        LightKind::Distant { direction, .. } => -to * direction,
    };
    let stands_before = |shape: &dyn Round| {
        let beyond = 2.0 * ((shape.center() - point).length() + shape.radius());
        shape.meets([point, point + way(beyond)])
    };
    if round_surfaces(scene).any(|(_, shape)| stands_before(shape)) {
        return Some(false);
    }
    if !hides(light, point, transport) {
        return Some(true);
    }
    let first = transport.screens.first(point, way(1.0));
    let is_piece =
        first.is_some_and(|hit| scene.surfaces[transport.faces[hit.face].surface].shape.is_round());
    (!is_piece).then_some(false)
}
