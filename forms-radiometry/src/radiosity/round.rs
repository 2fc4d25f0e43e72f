//! Round surfaces, as points see them: what is seen of one as a whole, and what it hides that the pieces which stand for it do not.
//!
//! ```text
//! a sphere or disk ─ nothing before it, not even a bulge of another one ─▶ its measure as a whole
//! a face ─┬─ no piece before it ─▶ a bound of the bulge that a shape has beyond its pieces
//!         └─ a piece before all of it ─▶ whether the shape itself is
//! ```

use super::direct::{Lights, hides};
use super::gather::{Scratch, Transport};
use super::measure::Measure;
use crate::faces::round_surfaces;
use crate::geometry::precise::{Rounded, SeenWhole};
use crate::geometry::{Between, Face, Round, Vector, bulge};
use crate::scene::{Light, LightKind, Scene, Shape};
use forms::math::Real;

impl Measure {
    /// The measure, over π, of a round shape that nothing hides, if it has a closed form.
    fn of_whole(self, point: Vector, shape: &dyn SeenWhole) -> Option<Rounded> {
        match self {
            Self::Plane(normal) => shape.form_factor(point, normal, true),
            Self::Flow(axis) => Some(shape.form_factor(point, axis, false)?.times(-1.0)),
            Self::Sphere => shape.solid_angle_over_pi(point),
        }
    }

    /// A bound on the measure, over π, of any part of it.
    pub(super) fn at_most(self, point: Vector, outline: &[Vector]) -> f64 {
        let whole = if let Self::Flow(_) = self { Self::Sphere } else { self };
        whole.precisely(point, outline).value.to_f64()
    }
}

impl Lights<'_> {
    /// The measure, over π, of a round surface that a point sees as a whole, and whether it sees its back.
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
            Shape::Polygon(_) | Shape::Mesh(_) => return None,
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

    /// Whether what hides all of a face from a point is no piece of a round shape, or the shape itself hides all of it: each of its corners.
    pub(super) fn is_surely_hidden(
        &self,
        point: Vector,
        face: &Face,
        transport: &Transport,
        between: &[u32],
    ) -> bool {
        let surfaces = transport.screens.fronts(between).map(|front| transport.faces[front].surface);
        let round = surfaces.filter_map(|surface| self.scene().surfaces[surface].shape.as_round());
        let mut corners = face.vertices.iter();
        round.take(1).all(|shape| corners.all(|&corner| shape.meets([point, corner])))
    }
}

/// A bound on the solid angle, over π, of what round surfaces other than this one hide from a point of an outline that looks to it, where their pieces
/// hide nothing.
pub(crate) fn bulges<'s>(
    round: impl Iterator<Item = (usize, &'s dyn Round)>,
    at: (Vector, Option<Vector>),
    luminaire: (&[Vector], Vector),
    own: Option<usize>,
) -> f64 {
    let others = round.filter(|(index, _)| Some(*index) != own);
    others.map(|(_, shape)| bulge(shape, at, luminaire)).sum()
}

/// Whether a point sees a light without extent. It is not known where the first that stands before it is a piece of a round shape that does not itself.
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
