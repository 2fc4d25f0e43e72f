//! Luminaires: from a receiver, a luminaire and what stands in front of it come the parts of the luminaire
//! that the receiver sees, exactly, and their form factor.

use super::clip::{Pieces, split};
use super::cone::{Cone, Scratch};
use super::form_factor::edge_sum;
use super::{Polygon, Vector};

/// One side of a convex piece of an emitting polygon, with the surfaces that can come between it and a
/// receiver.
#[derive(Clone, Debug)]
pub(crate) struct Luminaire {
    vertices: Vec<Vector>,
    plane: Plane,
    occluders: Vec<Occluder>,
    resolution: f64,
}

/// The convex part of a surface in front of a luminaire.
#[derive(Clone, Debug)]
struct Occluder {
    vertices: Vec<Vector>,
    plane: Plane,
    /// Whether some of the luminaire lies in front of the occluder's plane, and some behind it.
    luminaire_in_front: bool,
    luminaire_behind: bool,
}

/// The plane normal·x = offset.
#[derive(Clone, Copy, Debug)]
struct Plane {
    normal: Vector,
    offset: f64,
}

impl Plane {
    fn through(point: Vector, normal: Vector) -> Self {
        Self { normal, offset: normal.dot(point) }
    }

    fn distance(self, point: Vector) -> f64 {
        self.normal.dot(point) - self.offset
    }
}

/// The distance from a plane below which a point counts as lying in it: 10⁻⁹ of the extent of the scene, or
/// the rounding of its coordinates where they are far from the origin.
pub(crate) fn resolution<'a>(polygons: impl Iterator<Item = &'a Polygon>) -> f64 {
    let Some((low, high)) = corners(polygons.flat_map(Polygon::vertices).copied()) else { return 0.0 };
    let largest = low.largest().max(high.largest());
    (1e-9 * (high - low).largest()).max(16.0 * f64::EPSILON * largest)
}

/// The least and the largest corner of the box around points.
fn corners(points: impl Iterator<Item = Vector>) -> Option<(Vector, Vector)> {
    points.fold(None, |corners, v| {
        let (low, high) = corners.unwrap_or((v, v));
        Some((
            Vector::new(low.x.min(v.x), low.y.min(v.y), low.z.min(v.z)),
            Vector::new(high.x.max(v.x), high.y.max(v.y), high.z.max(v.z)),
        ))
    })
}

impl Luminaire {
    /// The luminaires that the front of a polygon makes among others, or its back.
    pub(crate) fn of<'a>(
        emitter: &Polygon,
        front: bool,
        others: impl Iterator<Item = &'a Polygon> + Clone,
        resolution: f64,
    ) -> Vec<Self> {
        let normal = if front { emitter.normal() } else { -emitter.normal() };
        let plane = Plane::through(emitter.vertices()[0], normal);
        let piece_to_luminaire = |piece: &Vec<Vector>| {
            let mut vertices = piece.clone();
            if !front {
                vertices.reverse();
            }
            let pieces =
                others.clone().flat_map(|other| other.convex_pieces().iter().map(|p| (p, other.normal())));
            let occluders = pieces
                .filter_map(|(piece, normal)| Occluder::new(piece, normal, plane, &vertices, resolution))
                .collect();
            Self { vertices, plane, occluders, resolution }
        };
        emitter.convex_pieces().iter().map(piece_to_luminaire).collect()
    }

    /// The same luminaire for receivers in a convex outline that look to one side of it, with what cannot come between left out.
    pub(crate) fn seen_from(&self, receivers: &[Vector], normal: Vector) -> Self {
        let ground = Plane::through(receivers[0], normal);
        let hull = || receivers.iter().chain(&self.vertices).copied();
        let (low, high) = corners(hull()).unwrap_or_default();
        let may_hide = |occluder: &&Occluder| {
            let above_ground = occluder.vertices.iter().any(|&v| ground.distance(v) > self.resolution);
            let from_front = receivers.iter().any(|&v| occluder.plane.distance(v) > self.resolution);
            let from_behind = receivers.iter().any(|&v| occluder.plane.distance(v) < -self.resolution);
            let parts =
                (from_front && occluder.luminaire_behind) || (from_behind && occluder.luminaire_in_front);
            let near = corners(occluder.vertices.iter().copied()).is_some_and(|(other_low, other_high)| {
                let meets = |low: f64, high: f64| low <= high + self.resolution;
                [(low.x, other_high.x), (low.y, other_high.y), (low.z, other_high.z)]
                    .iter()
                    .all(|&(a, b)| meets(a, b))
                    && [(other_low.x, high.x), (other_low.y, high.y), (other_low.z, high.z)]
                        .iter()
                        .all(|&(a, b)| meets(a, b))
            });
            above_ground && parts && near
        };
        Self { occluders: self.occluders.iter().filter(may_hide).cloned().collect(), ..self.clone() }
    }

    /// Whether nothing can come before it.
    pub(crate) fn is_free(&self) -> bool {
        self.occluders.is_empty()
    }

    /// The form factor from a receiver (unit normal) to this luminaire, were nothing in between.
    pub(crate) fn unoccluded_form_factor(
        &self,
        position: Vector,
        normal: Vector,
        work: &mut Workspace,
    ) -> f64 {
        self.clip_at_horizon(position, normal, work);
        work.visible.iter().fold(0.0, |sum, piece| sum + edge_sum(piece, normal))
    }

    /// The form factor from a receiver (unit normal) to what it sees of this luminaire.
    ///
    /// The luminaire, clipped at the receiver's horizon, is a convex polygon; each occluder is a cone of
    /// directions that is cut out of it, and leaves convex pieces. An occluder in whose plane the receiver
    /// lies is seen edge-on and hides nothing: so a surface does not hide the lamp from its own points.
    pub(crate) fn visible_form_factor(&self, position: Vector, normal: Vector, work: &mut Workspace) -> f64 {
        self.clip_at_horizon(position, normal, work);
        if work.visible.is_empty() {
            return 0.0;
        }
        for occluder in &self.occluders {
            let distance = occluder.plane.distance(position);
            let between = (distance > self.resolution && occluder.luminaire_behind)
                || (distance < -self.resolution && occluder.luminaire_in_front);
            if between {
                work.occlude(occluder, position, normal, distance > 0.0);
            }
        }
        work.visible.iter().fold(0.0, |sum, piece| sum + edge_sum(piece, normal))
    }

    /// Leaves in the workspace what of the luminaire is above the horizon of a receiver in front of it,
    /// relative to the receiver.
    fn clip_at_horizon(&self, position: Vector, normal: Vector, work: &mut Workspace) {
        work.visible.clear();
        if self.plane.distance(position) <= self.resolution {
            return;
        }
        work.relative.clear();
        work.relative.extend(self.vertices.iter().map(|&v| v - position));
        split(&work.relative, |x| normal.dot(x), &mut work.scratch.inside, &mut work.scratch.outside);
        if work.scratch.inside.is_empty() {
            return;
        }
        work.luminaire.set(&work.scratch.inside, true);
        work.visible.push(&work.scratch.inside);
    }
}

impl Occluder {
    /// The part of a convex polygon in front of the luminaire's plane, if it can hide the luminaire from any
    /// point. A surface in the luminaire's own plane, such as the ceiling around a lamp, cannot.
    fn new(
        polygon: &[Vector],
        normal: Vector,
        luminaire: Plane,
        luminaire_vertices: &[Vector],
        resolution: f64,
    ) -> Option<Self> {
        if polygon.iter().all(|&v| luminaire.distance(v) <= resolution) {
            return None;
        }
        let (mut before, mut beyond) = (Vec::new(), Vec::new());
        split(polygon, |v| luminaire.distance(v), &mut before, &mut beyond);
        let plane = Plane::through(*before.first()?, normal);
        let luminaire_in_front = luminaire_vertices.iter().any(|&v| plane.distance(v) > resolution);
        let luminaire_behind = luminaire_vertices.iter().any(|&v| plane.distance(v) < -resolution);
        Some(Self { vertices: before, plane, luminaire_in_front, luminaire_behind })
    }
}

/// Lists that are reused from receiver to receiver.
#[derive(Clone, Debug, Default)]
pub(crate) struct Workspace {
    relative: Vec<Vector>,
    luminaire: Cone,
    occluder: Cone,
    scratch: Scratch,
    visible: Pieces,
    rest: Pieces,
}

impl Workspace {
    /// Cuts an occluder out of what is visible.
    fn occlude(&mut self, occluder: &Occluder, position: Vector, normal: Vector, seen_from_front: bool) {
        self.relative.clear();
        self.relative.extend(occluder.vertices.iter().map(|&v| v - position));
        let below_horizon = self.relative.iter().all(|&x| normal.dot(x) <= 0.0);
        if below_horizon || self.luminaire.misses(&self.relative) {
            return;
        }
        self.occluder.set(&self.relative, seen_from_front);
        self.rest.clear();
        for piece in self.visible.iter() {
            self.occluder.cut_from(piece, &mut self.scratch, &mut self.rest);
        }
        std::mem::swap(&mut self.visible, &mut self.rest);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ORIGIN: Vector = Vector::new(0.0, 0.0, 0.0);
    const UP: Vector = Vector::new(0.0, 0.0, 1.0);

    fn rectangle(x: (f64, f64), y: (f64, f64), height: f64) -> Polygon {
        let corners = [(x.0, y.0), (x.0, y.1), (x.1, y.1), (x.1, y.0)];
        Polygon::new(corners.map(|(x, y)| Vector::new(x, y, height)).to_vec()).unwrap()
    }

    /// What occluders leave of the form factor of the lamp [−1, 1]² at height 2, seen from the origin.
    fn visible_fraction(occluders: &[Polygon]) -> f64 {
        let lamp = rectangle((-1.0, 1.0), (-1.0, 1.0), 2.0);
        let all = || occluders.iter().chain([&lamp]);
        let mut work = Workspace::default();
        let luminaires = Luminaire::of(&lamp, true, all(), resolution(all()));
        let [luminaire] = &luminaires[..] else { panic!("a square is one luminaire") };
        let visible = luminaire.visible_form_factor(ORIGIN, UP, &mut work);
        visible / luminaire.unoccluded_form_factor(ORIGIN, UP, &mut work)
    }

    #[test]
    fn occluders_leave_what_symmetry_says() {
        let half = || rectangle((0.0, 9.0), (-9.0, 9.0), 1.0);
        let wall = [(1.0, -9.0), (1.0, 9.0), (-1.0, 9.0), (-1.0, -9.0)];
        let wall_through_the_receiver =
            Polygon::new(wall.map(|(z, y)| Vector::new(0.0, y, z)).to_vec()).unwrap();
        // The plane through the lamp's plane at x = x₀ that leans by `slope`.
        let leaning = |x: f64, slope: f64| {
            let corners = [(-9.0, -3.0), (9.0, -3.0), (9.0, 3.0), (-9.0, 3.0)];
            Polygon::new(corners.map(|(y, z)| Vector::new(x + slope * z, y, 2.0 + z)).to_vec()).unwrap()
        };
        let cases = [
            ("nothing in between", vec![], 1.0),
            ("all hidden", vec![rectangle((-9.0, 9.0), (-9.0, 9.0), 1.0)], 0.0),
            ("just hidden", vec![rectangle((-0.5, 0.5), (-0.5, 0.5), 1.0)], 0.0),
            ("half hidden", vec![half()], 0.5),
            ("the same half twice", vec![half(), rectangle((0.0, 9.0), (-9.0, 9.0), 0.5)], 0.5),
            ("a quarter left", vec![half(), rectangle((-9.0, 9.0), (0.0, 9.0), 0.5)], 0.25),
            ("two halves", vec![half(), rectangle((-9.0, 0.0), (-9.0, 9.0), 0.5)], 0.0),
            ("beside the lamp", vec![rectangle((0.5, 9.0), (-9.0, 9.0), 1.0)], 1.0),
            ("beyond the lamp", vec![rectangle((-9.0, 9.0), (-9.0, 9.0), 3.0)], 1.0),
            ("in the lamp's plane", vec![rectangle((-9.0, 9.0), (-9.0, 9.0), 2.0)], 1.0),
            ("behind the receiver", vec![rectangle((-9.0, 9.0), (-9.0, 9.0), -1.0)], 1.0),
            ("under the receiver's feet", vec![rectangle((-9.0, 9.0), (-9.0, 9.0), 0.0)], 1.0),
            ("edge-on", vec![wall_through_the_receiver], 1.0),
            ("leaning away from the lamp's edge", vec![leaning(1.0, -1.0)], 1.0),
            ("leaning from the lamp's edge over the receiver", vec![leaning(1.0, 1.0)], 0.0),
            ("leaning through the lamp's middle", vec![leaning(0.0, 1.0)], 0.5),
        ];
        for (name, occluders, expected) in cases {
            let found = visible_fraction(&occluders);
            assert!((found - expected).abs() < 1e-14, "{name}: {found}");
        }
    }

    #[test]
    fn the_back_of_a_luminaire_is_the_mirror_image_of_its_front() {
        let lamp = rectangle((-1.0, 1.0), (-0.5, 2.0), 1.0);
        let mut work = Workspace::default();
        let mut seen_from = |front: bool, z: f64, normal: Vector| {
            let luminaires = Luminaire::of(&lamp, front, std::iter::empty(), 1e-9);
            luminaires[0].visible_form_factor(Vector::new(0.3, 0.2, z), normal, &mut work)
        };
        assert!(seen_from(true, 0.0, UP) > 0.1);
        assert_eq!(seen_from(false, 0.0, UP), 0.0);
        assert!((seen_from(true, 0.0, UP) - seen_from(false, 2.0, -UP)).abs() < 1e-15);
    }
}
