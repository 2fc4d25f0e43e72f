//! Light sources: samples directions from which direct light arrives, with their densities. Each source
//! has a [form](super::light_forms).
//!
//! The light source is [selected](super::choice) by the irradiance that each can contribute; point
//! and distant lights are all sampled if they are few. Densities are per solid angle, and can also
//! be evaluated for directions that another technique found.
//!
//! A light source that is [`near`](super::near_field) is not sampled, and its density is zero.

use super::choice::{Choice, Sought, Weight};
use super::interface::Interface;
use super::light_forms::{Form, forms};
use super::near_field::Near;
use super::optics::largest;
use crate::geometry::Vector;
use crate::sampling::{Samples, chosen, shares};
use crate::scene::{Light, LightKind, Scene};
use crate::visibility::{Met, Wall};
use std::f64::consts::PI;
use std::ops::Range;

/// Up to this number of point and distant lights, all are sampled; of more, one is selected.
const FEW_BEAMS: usize = 16;

/// All light sources of a scene.
pub(super) struct Luminaires {
    /// Emitting walls.
    walls: Vec<Luminaire>,
    choice_of_walls: Choice,
    /// Point and distant lights.
    beams: Vec<Luminaire>,
    choice_of_beams: Choice,
    /// Cumulative fractions of the total power, over the emitting walls and then the beams.
    powers: Vec<f64>,
    emitters: Vec<Emitter>,
    /// The emitter of each wall that emits light.
    of_walls: Vec<Option<u32>>,
    /// Selection data of all light sources together.
    all: Weight,
}

/// A wall that emits light.
struct Emitter {
    /// The points from which it is not sampled.
    near: Near,
    /// Its light sources.
    sources: Range<usize>,
}

/// A light source.
pub(super) struct Luminaire {
    pub(super) source: Source,
    form: Form,
}

/// Index of the optical data of a light source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Source {
    /// A wall of this index, of this surface.
    Wall { wall: usize, surface: usize },
    /// A light of this index.
    Beam(usize),
    /// The environment map.
    Environment,
}

/// A sampled direction to a light source.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightSample {
    pub(super) source: Source,
    pub(super) direction: Vector,
    /// Distance of a point light; infinite otherwise.
    pub(super) reach: f64,
    /// Density of the direction, with the probability of selecting the light source; for a beam, the
    /// reciprocal of the factor of its intensity or irradiance.
    pub(super) density: f64,
    /// Probability with which the light source was selected.
    pub(super) chance: f64,
}

impl Luminaires {
    /// Returns the light sources of a scene, whose walls extend over this length.
    pub(super) fn of(scene: &Scene, (shapes, extent): (&[Wall], f64), interfaces: &[Interface]) -> Self {
        let (mut walls, mut weights, mut powers, mut emitters) =
            (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut of_walls = vec![None; shapes.len()];
        for (wall, (shape, interface)) in shapes.iter().zip(interfaces).enumerate() {
            let first = walls.len();
            let surface = &scene.surfaces[interface.surface];
            let radiance = largest(&surface.radiance);
            if radiance > 0.0 {
                let sides = if surface.two_sided { 2.0 } else { 1.0 };
                let source = Source::Wall { wall, surface: interface.surface };
                for form in forms(shape) {
                    powers.push(sides * PI * radiance * form.area());
                    let before = shape.plane().filter(|_| !surface.two_sided);
                    weights.push(Weight { before, ..form.weight(radiance) });
                    walls.push(Luminaire { source, form });
                }
                of_walls[wall] = Some(emitters.len() as u32);
                emitters.push(Emitter { near: Near::of(shape), sources: first..walls.len() });
            }
        }
        let (mut beams, mut weights_of_beams) = (Vec::new(), Vec::new());
        for (index, light) in scene.lights.iter().enumerate() {
            let (form, value) = form_of(light);
            let solid = if let Form::Distant(_) = form { extent * extent } else { 4.0 };
            powers.push(PI * solid * value);
            weights_of_beams.push(form.weight(value));
            beams.push(Luminaire { source: Source::Beam(index), form });
        }
        let [_, powers] = shares(&powers);
        let all = Weight::together(weights.iter().chain(&weights_of_beams));
        let [choice_of_walls, choice_of_beams] = [weights, weights_of_beams].map(Choice::among);
        Self { walls, choice_of_walls, beams, choice_of_beams, powers, emitters, of_walls, all }
    }

    /// Whether a ray can hit any light source.
    pub(super) fn are_met(&self) -> bool {
        !self.walls.is_empty()
    }

    /// Returns the part of a segment beyond which no light source lies abreast of it.
    pub(super) fn sought_along(&self, from: Vector, direction: Vector, length: f64) -> Sought {
        let farthest = (from - self.all.middle).length() + self.all.radius;
        Sought::along(from, from + length.min(farthest) * direction)
    }

    /// Selects an emitting wall to sample, if there is any, and returns its probability.
    pub(super) fn wall(&self, sought: Sought, samples: &mut Samples) -> Option<(&Luminaire, f64)> {
        if self.walls.is_empty() {
            return None;
        }
        let (place, chance) = self.choice_of_walls.choose(sought, samples.one())?;
        let luminaire = &self.walls[place];
        let Source::Wall { wall, .. } = luminaire.source else { return None };
        self.emitter(wall, sought.from).map(|_| (luminaire, chance))
    }

    /// Returns the beams to sample, each with its selection probability: all beams if they are few.
    pub(super) fn beams<'l>(
        &'l self,
        sought: Sought,
        samples: &mut Samples,
    ) -> impl Iterator<Item = (&'l Luminaire, f64)> + use<'l> {
        let are_few = self.beams.len() <= FEW_BEAMS;
        let one = if are_few { None } else { self.choice_of_beams.choose(sought, samples.one()) };
        let all = if are_few { &self.beams[..] } else { &[] };
        all.iter().map(|beam| (beam, 1.0)).chain(one.map(|(place, chance)| (&self.beams[place], chance)))
    }

    /// Returns the number of light sources that are sampled from a point.
    pub(super) fn sampled(&self) -> usize {
        let beams = self.beams.len();
        usize::from(self.are_met()) + if beams <= FEW_BEAMS { beams } else { 1 }
    }

    /// Returns a wall as an emitter, if it is one and its light sources are sampled from a point.
    fn emitter(&self, wall: usize, from: Vector) -> Option<&Emitter> {
        let emitter = &self.emitters[self.of_walls[wall]? as usize];
        (!emitter.near.holds(from)).then_some(emitter)
    }

    /// Selects an emitting surface by a number from 0 to 1, in proportion to its power, if there is one.
    pub(super) fn emitting(&self, number: f64) -> Option<usize> {
        match self.walls.get(chosen(&self.powers, number)?)?.source {
            Source::Wall { surface, .. } => Some(surface),
            Source::Beam(_) | Source::Environment => None,
        }
    }

    /// Returns the density with which [`wall`](Self::wall) and [`towards`](Luminaire::towards)
    /// sample the direction from a point to the wall that it hits.
    pub(super) fn density(&self, sought: Sought, from: Vector, direction: Vector, met: &Met) -> f64 {
        let Some(emitter) = self.emitter(met.wall, sought.from) else { return 0.0 };
        let density = |place: usize| {
            let density = self.walls[place].form.density(from, direction, met);
            if density > 0.0 { self.choice_of_walls.chance(sought, place) * density } else { 0.0 }
        };
        emitter.sources.clone().map(density).sum()
    }
}

impl Luminaire {
    /// Returns a direction from a point, by a point of the unit square, for a light source that was
    /// selected with this probability. `None` if the light source cannot be seen from there.
    pub(super) fn towards(&self, from: Vector, square: [f64; 2], chance: f64) -> Option<LightSample> {
        let (direction, reach, density) = self.form.towards(from, square)?;
        let is_found = density > 0.0 && density.is_finite();
        let density = chance * density;
        is_found.then_some(LightSample { source: self.source, direction, reach, density, chance })
    }

    /// Returns a point of the light source, by a point of the unit square; `None` if it is distant.
    pub(super) fn point(&self, square: [f64; 2]) -> Option<Vector> {
        match self.form {
            Form::Point(position) | Form::Spot(position, _) => Some(position),
            Form::Distant(_) => None,
            shape => Some(shape.point(square).0),
        }
    }
}

/// Returns the form of a light, and its largest intensity or irradiance.
fn form_of(light: &Light) -> (Form, f64) {
    match &light.kind {
        LightKind::Point { position, intensity } => {
            let form = light.cone.map_or(Form::Point(*position), |cone| Form::Spot(*position, cone));
            (form, largest(intensity))
        }
        LightKind::Distant { direction, irradiance } => (Form::Distant(*direction), largest(irradiance)),
    }
}

/// Front of a surface, from which points are sampled uniformly over the area.
pub(super) struct Front {
    /// The wall, the form, and the unit normal if the form is flat.
    pieces: Vec<(usize, Form, Option<Vector>)>,
    /// Cumulative areas of the pieces.
    areas: Vec<f64>,
}

impl Front {
    pub(super) fn of<'w>(walls: impl Iterator<Item = (usize, &'w Wall)>) -> Self {
        let (mut pieces, mut areas, mut sum) = (Vec::new(), Vec::new(), 0.0);
        for (index, wall) in walls {
            let normal = match wall {
                Wall::Polygon { normal, .. } => Some(*normal),
                Wall::Disk(disk) => Some(disk.normal),
                Wall::Sphere(_) | Wall::Quadric(_) => None,
            };
            for form in forms(wall) {
                sum += form.area();
                areas.push(sum);
                pieces.push((index, form, normal));
            }
        }
        Self { pieces, areas }
    }

    /// Samples a point: the wall, the position, and the unit normal there.
    pub(super) fn point(&self, samples: &mut Samples) -> Option<(usize, Vector, Vector)> {
        let along = samples.one() * self.areas.last()?;
        let (wall, form, normal) = &self.pieces[chosen(&self.areas, along)?];
        let (position, curved) = form.point(samples.pair());
        Some((*wall, position, normal.unwrap_or(curved)))
    }
}
