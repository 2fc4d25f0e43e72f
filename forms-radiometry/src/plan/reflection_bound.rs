//! Reflection bound: the reflecting faces visible from some points determine how much of the light
//! a reflection leaves.
//!
//! ```text
//! reflecting faces ─ all pairs: possible occluders ─▶ points of each: Σ F, Σ ρ F ─▶ largest, least
//! large scenes     ─ rays from their centres ───────▶ Σ F, Σ ρ F
//! ```
//! The possible occluders of two faces are the same for both.

use crate::geometry::Vector;
use crate::parallelism::Parallelism;
use crate::radiosity::{Group, Measure, Scratch, Transport, is_reflecting, reflectance};
use crate::scene::Scene;
use crate::visibility::{Between, Face};

/// Largest number of faces whose surroundings are evaluated.
const ASKED: usize = 64;
/// Number of rays from each of these faces in large scenes.
const RAYS: u32 = 256;
/// Position of the points near the corners of a face, as part of the way from its centre to the
/// corner.
const NEAR_CORNERS: f64 = 0.9;

/// Reflecting surroundings at some points.
pub(crate) struct Surroundings {
    /// Largest Σ ρ F.
    pub(crate) contraction: f64,
    /// Least Σ F.
    pub(crate) closure: f64,
    /// Whether some faces may see each other, if only from other points.
    pub(crate) may_see: bool,
}

/// Occlusion between two faces: how much may be hidden, and the possible occluders.
type Hidden = (Between, Vec<u32>);

/// The reflecting faces, some of which are evaluated.
struct ReflectingFaces<'s> {
    scene: &'s Scene,
    transport: &'s Transport,
    reflecting: Vec<usize>,
    /// One in this many faces is evaluated.
    step: usize,
}

impl Surroundings {
    const NOTHING: Self = Self { contraction: 0.0, closure: f64::INFINITY, may_see: false };

    /// Returns the surroundings where no visibility is evaluated: no reflection leaves more than
    /// `albedo`, the largest albedo.
    pub(crate) fn unseen(albedo: f64) -> Self {
        Self { contraction: albedo, closure: 0.0, may_see: true }
    }

    /// Evaluates the surroundings of some faces at points near their corners and at their centres.
    pub(crate) fn of(scene: &Scene, transport: &Transport) -> Self {
        let faces = ReflectingFaces::of(scene, transport);
        let places = || faces.places().collect::<Vec<_>>();
        let parallelism = Parallelism::of(faces.operations());
        let hidden = parallelism.map(places(), |_: &mut (), place| faces.hidden(place));
        let of_place = |scratch: &mut Scratch, place| faces.at(place, &hidden, scratch);
        let found = parallelism.map(places(), of_place).into_iter().fold(Self::NOTHING, Self::beside);
        // nothing is known of the faces that are not evaluated
        Self { may_see: found.may_see || faces.step > 1, ..found }
    }

    /// Estimates the surroundings of some faces at their centres from the faces that rays meet,
    /// without direct light.
    pub(crate) fn by_rays(scene: &Scene, transport: &Transport) -> Self {
        let faces = ReflectingFaces::of(scene, transport);
        let of_face = |(number, place): (usize, usize)| {
            let face = faces.face(place);
            let mut row = vec![0.0; scene.band_count()];
            let mut closure = 0.0;
            let met = transport
                .faces_above(Vector::mean(&face.vertices), face.normal, RAYS, number as u64)
                .flatten();
            for face in met.map(|met| &transport.faces[met]).filter(|face| is_reflecting(scene, face)) {
                closure += 1.0 / f64::from(RAYS);
                let reflectances = reflectance(scene, face.surface);
                row.iter_mut().zip(reflectances).for_each(|(row, rho)| *row += rho / f64::from(RAYS));
            }
            Self { contraction: row.into_iter().fold(0.0, f64::max), closure, may_see: true }
        };
        faces.places().enumerate().map(of_face).fold(Self::NOTHING, Self::beside)
    }

    /// Combines the surroundings at these points with those at others.
    fn beside(self, other: Self) -> Self {
        Self {
            contraction: self.contraction.max(other.contraction),
            closure: self.closure.min(other.closure),
            may_see: self.may_see || other.may_see,
        }
    }
}

impl<'s> ReflectingFaces<'s> {
    fn of(scene: &'s Scene, transport: &'s Transport) -> Self {
        let is_reflecting = |&index: &usize| is_reflecting(scene, &transport.faces[index]);
        let reflecting: Vec<usize> = (0..transport.faces.len()).filter(is_reflecting).collect();
        let step = reflecting.len().div_ceil(ASKED).max(1);
        Self { scene, transport, reflecting, step }
    }

    /// Returns the places of the evaluated faces among those that reflect.
    fn places(&self) -> impl Iterator<Item = usize> {
        (0..self.reflecting.len()).step_by(self.step)
    }

    fn face(&self, place: usize) -> &Face {
        &self.transport.faces[self.reflecting[place]]
    }

    fn operations(&self) -> f64 {
        let corners = |place| self.face(place).vertices.len();
        let edges = (0..self.reflecting.len()).map(corners).sum();
        self.transport.operations(self.places().map(corners).sum(), edges)
    }

    /// Orders two faces, of which the first is evaluated: the one that searches for occluders
    /// between them, then the other. The search belongs to the first evaluated face of the pair.
    fn in_order(&self, place: usize, other: usize) -> [usize; 2] {
        if other < place && other.is_multiple_of(self.step) { [other, place] } else { [place, other] }
    }

    /// Returns the possible occluders between a face and each face for which it performs the
    /// search.
    fn hidden(&self, place: usize) -> Vec<Hidden> {
        let between = |other: usize| {
            let mut found = Vec::new();
            if other == place || self.in_order(place, other) != [place, other] {
                return (Between::Nothing, found);
            }
            let [here, there] = [place, other].map(|place| self.face(place));
            let (screens, normal) = (&self.transport.screens, Some(here.normal));
            let between = screens.between(&here.vertices, normal, &there.vertices, there.normal, &mut found);
            (between, found)
        };
        (0..self.reflecting.len()).map(between).collect()
    }

    /// Evaluates the surroundings of one of the faces.
    fn at(&self, place: usize, hidden: &[Vec<Hidden>], scratch: &mut Scratch) -> Surroundings {
        let Self { scene, transport, reflecting, step } = self;
        let here = self.face(place);
        let points = points(here);
        let group = self.group(place, &points);
        let mut rows = vec![vec![0.0; scene.band_count()]; points.len()];
        let mut closure = vec![0.0; points.len()];
        let mut may_see = false;
        for other in (0..reflecting.len()).filter(|&other| other != place) {
            let seen = self.face(other);
            let [row, column] = self.in_order(place, other);
            let (between, screens) = &hidden[row / step][column];
            if *between == Between::All {
                continue;
            }
            let luminaire = (seen.vertices.as_slice(), seen.normal);
            may_see = may_see
                || transport.screens.face_each_other(
                    &here.vertices,
                    Some(here.normal),
                    &seen.vertices,
                    seen.normal,
                );
            let factors = transport.measured_past(group, luminaire, screens, scratch).unwrap_or(&[]);
            for ((factor, closure), row) in factors.iter().zip(&mut closure).zip(&mut rows) {
                *closure += factor;
                let reflectances = reflectance(scene, seen.surface);
                row.iter_mut().zip(reflectances).for_each(|(row, rho)| *row += rho * factor);
            }
        }
        Surroundings {
            contraction: rows.into_iter().flatten().fold(0.0, f64::max),
            closure: closure.into_iter().fold(f64::INFINITY, f64::min),
            may_see,
        }
    }

    /// Returns the points of one of the faces as a group.
    fn group<'p>(&self, place: usize, points: &'p [Vector]) -> Group<'p> {
        let Face { vertices, normal, .. } = self.face(place);
        Group { points, outline: &points[..vertices.len()], measure: Measure::Plane(*normal) }
    }
}

/// Returns the points at which the surroundings of a face are evaluated: one near each corner, and
/// its centre.
fn points(face: &Face) -> Vec<Vector> {
    let middle = Vector::mean(&face.vertices);
    let near = |&corner: &Vector| middle + NEAR_CORNERS * (corner - middle);
    face.vertices.iter().map(near).chain([middle]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::radiosity::FirstFaces;
    use crate::scene::read;
    use forms_testing::scene_text::{CUBE, material, polygon, surface};

    /// Returns a row of this many cubes, seen from outside.
    fn cubes(count: usize) -> Scene {
        let cube = |number: usize| {
            let moved = |corner: [f64; 3]| [corner[0] + 1.5 * number as f64, corner[1], corner[2]];
            CUBE.map(|(name, mut corners)| {
                corners.reverse();
                surface(&format!("{name} {number}"), "grey", &polygon(&corners.map(moved)))
            })
        };
        let text = material("grey", 0.5) + &(0..count).flat_map(cube).collect::<String>();
        read(&text, "cubes.toml").unwrap_or_else(|errors| panic!("{}", errors[0]))
    }

    #[test]
    fn what_faces_see_past_what_was_found_for_pairs_is_what_each_sees_that_looks_for_itself() {
        for (count, step) in [(3, 1), (13, 2)] {
            let scene = cubes(count);
            let first = FirstFaces::default();
            let (faces, screens) = (first.faces(&scene), first.screens(&scene));
            let transport =
                Transport { faces, screens, occlusion: true, hides_outside: true, accuracy: 1e-2 };
            let faces = ReflectingFaces::of(&scene, &transport);
            assert_eq!((faces.reflecting.len(), faces.step), (6 * count, step));
            let hidden: Vec<_> = faces.places().map(|place| faces.hidden(place)).collect();
            let mut scratch = Scratch::default();
            let mut seen = 0;
            for place in faces.places() {
                let found = faces.at(place, &hidden, &mut scratch).contraction;
                let expected = alone(&faces, place, &mut scratch);
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{count} cubes, face {place}: {found} and {expected}"
                );
                seen += usize::from(expected > 0.01);
            }
            assert!(seen >= 2, "{count} cubes: {seen} faces see others");
        }
    }

    /// Returns the largest Σ ρ F of a face that searches for all occluders itself.
    fn alone(faces: &ReflectingFaces, place: usize, scratch: &mut Scratch) -> f64 {
        let face = faces.face(place);
        let mut largest: f64 = 0.0;
        for point in points(face) {
            let points = [point];
            let group = Group { points: &points, outline: &points, measure: Measure::Plane(face.normal) };
            let factor = |other: usize| {
                let seen = faces.face(other);
                let factors = faces.transport.measured(group, (&seen.vertices, seen.normal), scratch);
                factors.map_or(0.0, |factors| factors[0])
            };
            largest = largest.max(0.5 * (0..faces.reflecting.len()).map(factor).sum::<f64>());
        }
        largest
    }
}
