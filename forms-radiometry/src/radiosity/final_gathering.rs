//! Final gathering: traces light backwards along rays, if there are too many surfaces for the exact
//! pieces of all of them. This module computes the rough solution; [`walk`](super::walk) continues
//! paths from a point.
//!
//! ```text
//! faces ─▶ elements ─ rays from each ─▶ rows ─▶ rough Ẽ ─┬─ gathered ──────────────┬─▶ readings
//!                                                        └─ E − Ẽ by random paths ─┘
//! ```
//! A receiver gets ∫ ρ E dF. It gathers ρ Ẽ by many rays, and adds the mean of ρ (E − Ẽ) where some
//! rays end. Ẽ is a control variate: errors of its elements and of its rows do not bias the result,
//! but only determine the number of paths that it takes. D is exact if light sources are few; if
//! they are many faces, or the surroundings, rays sample them.
//!
//! Source: M. Giles, Multilevel Monte Carlo path simulation (2008), for the sum of a cheap mean and
//! a small difference.

use super::brightest::most_of_beams;
use super::costs::{RAYS, VIEW};
use super::direct::Lights;
use super::directions::above;
use super::element::Element;
use super::measure::Measure;
use super::method::worthwhile_nodes;
use super::operator::{Operator, Row};
use super::question::Question;
use super::reflectance::{is_reflecting, reflectance};
use super::solution::of_bands;
use super::subdivision::Subdivision;
use super::transport::{Group, Scratch, Transport};
use crate::faces::emitted;
use crate::geometry::Vector;
use crate::sampling::{Net, key};
use crate::scene::Scene;
use crate::watch::Watch;
use forms_kernels::irradiance;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Number of nodes where the emitting part of the hemisphere is sampled.
const SAMPLED_NODES: usize = 512;
/// Number of emitters for which occluders are counted at such a node.
const SAMPLED_LIGHTS: usize = 4;
/// Relative standard deviation below which rays that hit the emitters count as equivalent to their
/// exact sum.
const DEVIATION: f64 = 0.25;

/// A scene with a rough solution, in which paths are traced.
pub(crate) struct FinalGathering<'t> {
    pub(crate) scene: &'t Scene,
    pub(crate) transport: &'t Transport,
    lights: &'t Lights<'t>,
    pub(crate) watch: &'t dyn Watch,
    pub(crate) question: Question,
    pub(super) subdivision: Subdivision,
    /// Whether rays sample emitting faces and the surroundings, instead of an exact sum over them.
    pub(crate) by_rays: bool,
    /// The rough irradiance of each node, band by band: direct, with all requested reflections, and
    /// with all but the last of these.
    pub(crate) direct: Vec<Vec<f64>>,
    pub(crate) irradiance: Vec<Vec<f64>>,
    pub(crate) reflected: Vec<Vec<f64>>,
    /// For each band the largest radiosity that rays have to hit: light sources, nodes, and places
    /// that point or distant lights can reach.
    pub(crate) brightest: Vec<f64>,
    /// Estimated fraction of the light that a reflection leaves.
    pub(crate) contraction: f64,
}

/// Purposes of random numbers; the numbers of different purposes are independent.
#[derive(Clone, Copy)]
pub(crate) enum Numbers {
    /// Points where the emitting part of the hemisphere is sampled.
    Hemispheres,
    /// Rows of the rough solution.
    Rows,
    /// Probes.
    Probes,
}

/// A point where light is reflected.
#[derive(Clone, Copy)]
pub(crate) struct Place {
    pub(crate) element: usize,
    pub(crate) position: Vector,
}

/// End of a ray: in the surroundings, or on a face, which has elements if it reflects or receives.
pub(crate) struct End {
    pub(crate) face: Option<usize>,
    pub(crate) place: Option<Place>,
}

impl<'t> FinalGathering<'t> {
    /// Computes the rough solution.
    pub(crate) fn new(
        scene: &'t Scene,
        transport: &'t Transport,
        lights: &'t Lights<'t>,
        question: Question,
        watch: &'t dyn Watch,
    ) -> Self {
        let subdivision =
            Subdivision::of(scene, &transport.faces, &question.receives, worthwhile_nodes(scene));
        let mut paths = Self {
            scene,
            transport,
            lights,
            watch,
            question,
            subdivision,
            by_rays: false,
            direct: Vec::new(),
            irradiance: Vec::new(),
            reflected: Vec::new(),
            brightest: Vec::new(),
            contraction: 0.0,
        };
        paths.by_rays = paths.lights_are_met();
        paths.brightest = paths.brightest_light();
        paths.solve();
        paths.note_reflected();
        paths
    }

    /// Whether rays find the light sources sooner than their exact sum is computed. M rays, a
    /// fraction f of which hits emitters, give their sum with the relative standard deviation
    /// √((1 − f)/(f M)); an exact view takes longer the more occluders are clipped from it.
    fn lights_are_met(&self) -> bool {
        let elements = &self.subdivision.elements;
        let sampled = elements.iter().step_by((elements.len() / SAMPLED_NODES).max(1));
        let (mut met, mut screens, mut all) = (0.0, 0.0, 0.0_f64);
        for (index, element) in sampled.enumerate() {
            let key = self.key(Numbers::Hemispheres, index as u64);
            let ends = self.transport.faces_above(element.centre(), element.normal, RAYS, key);
            let lit = ends.filter(|&face| self.emitted(face).iter().any(|&radiance| radiance > 0.0));
            met += lit.count() as f64 / f64::from(RAYS);
            screens += self.screens_before_lights(element);
            all += 1.0;
        }
        let (part, screens) = (met / all.max(1.0), screens / all.max(1.0));
        let rays = (1.0 - part) / (part * DEVIATION * DEVIATION);
        self.lights.faces().len() as f64 * VIEW * (1.0 + screens) > rays.max(1.0)
    }

    /// Returns the number of possible occluders between the centre of an element and an emitter, as
    /// a mean over some emitters.
    fn screens_before_lights(&self, element: &Element) -> f64 {
        if !self.transport.occlusion {
            return 0.0;
        }
        let faces = self.lights.faces();
        let (mut found, mut sum, mut all) = (Vec::new(), 0.0, 0.0_f64);
        for &face in faces.iter().step_by((faces.len() / SAMPLED_LIGHTS).max(1)) {
            let light = &self.transport.faces[face];
            let (points, normal) = ([element.centre()], Some(element.normal));
            self.transport.screens.between(&points, normal, &light.vertices, light.normal, &mut found);
            sum += found.len() as f64;
            all += 1.0;
        }
        sum / all.max(1.0)
    }

    fn solve(&mut self) {
        let watch = self.watch;
        let bands = self.scene.band_count();
        let count = self.subdivision.nodes.len();
        let done = AtomicUsize::new(0);
        let of_nodes: Vec<(Row, Vec<f64>)> = self
            .subdivision
            .nodes
            .par_iter()
            .with_min_len(16)
            .map_init(Scratch::default, |scratch, &element| {
                let done = done.fetch_add(1, Ordering::Relaxed);
                if watch.is_stopped() {
                    return (Row::default(), vec![0.0; bands]);
                }
                if done.is_multiple_of(64) {
                    watch.progress("interreflection", done as f64 / count as f64);
                }
                self.row(element as usize, scratch)
            })
            .collect();
        let mut direct = vec![Vec::with_capacity(count); bands];
        let mut rows = Vec::with_capacity(count);
        for (row, light) in of_nodes {
            rows.push(row);
            direct.iter_mut().zip(light).for_each(|(band, value)| band.push(value));
        }
        let operator = Operator::new(rows, (0..=count).collect());
        let solved = of_bands(&operator, &self.reflectances(), &direct, self.question.orders, watch);
        self.contraction = solved.contraction;
        (self.direct, self.irradiance, self.reflected) = (direct, solved.irradiance, solved.reflected);
    }

    /// Returns for each band the reflectance at each node.
    fn reflectances(&self) -> Vec<Vec<f64>> {
        let nodes = &self.subdivision.nodes;
        let of = |band: usize| nodes.iter().map(move |&element| self.reflectance(element as usize)[band]);
        (0..self.scene.band_count()).map(|band| of(band).collect()).collect()
    }

    /// Returns the row of an element, which holds the ends of the rays from its centre, each with
    /// its fraction, and the direct light there.
    fn row(&self, element: usize, scratch: &mut Scratch) -> (Row, Vec<f64>) {
        let Element { normal, .. } = self.subdivision.elements[element];
        let place = Place { element, position: self.subdivision.elements[element].centre() };
        let mut light = self.direct(place, scratch);
        let mut row = Row::default();
        if self.question.orders == Some(0) && !self.by_rays {
            return (row, light);
        }
        let net = Net::new(self.key(Numbers::Rows, element as u64));
        let mut ends = Vec::with_capacity(RAYS as usize);
        for ray in 0..RAYS {
            let end = self.trace(place.position, above(normal, net.point(ray)));
            if self.by_rays {
                let emitted = self.emitted(end.face);
                light
                    .iter_mut()
                    .zip(emitted)
                    .for_each(|(sum, &l)| *sum += irradiance(1.0, l) / f64::from(RAYS));
            }
            ends.extend(end.place.map(|place| self.subdivision.node_of[place.element]));
        }
        ends.sort_unstable();
        for end in ends.chunk_by(|a, b| a == b) {
            row.elements.push(end[0]);
            row.weights.push(end.len() as f64 / f64::from(RAYS));
        }
        (row, light)
    }

    /// Returns the key of the random numbers for an item of a purpose, for the seed of the scene.
    pub(crate) fn key(&self, part: Numbers, item: u64) -> u64 {
        key(key(self.scene.solve.seed, part as u64), item)
    }

    /// The geometry that light passes through.
    pub(crate) fn transport(&self) -> &'t Transport {
        self.transport
    }

    pub(crate) fn reflectance(&self, element: usize) -> &[f64] {
        let face = &self.transport.faces[self.subdivision.elements[element].face];
        reflectance(self.scene, face.surface)
    }

    pub(crate) fn node(&self, place: Place) -> usize {
        self.subdivision.node_of[place.element] as usize
    }

    /// Returns the direct irradiance of the light sources that rays do not sample.
    pub(crate) fn direct(&self, place: Place, scratch: &mut Scratch) -> Vec<f64> {
        let normal = self.subdivision.elements[place.element].normal;
        self.straight(place.position, Measure::Plane(normal), scratch)
    }

    /// Returns the same direct light for any measure.
    pub(crate) fn straight(&self, position: Vector, measure: Measure, scratch: &mut Scratch) -> Vec<f64> {
        let points = [position];
        let group = Group { points: &points, outline: &points, measure };
        if !self.by_rays {
            return self.lights.reaching(group, self.transport, scratch).swap_remove(0);
        }
        let mut sum = vec![0.0; self.scene.band_count()];
        self.lights.add_lights(position, measure, self.transport, &mut sum);
        sum
    }

    /// Traces a ray to its end.
    pub(crate) fn trace(&self, from: Vector, direction: Vector) -> End {
        let Some(hit) = self.transport.screens.first(from, direction) else {
            return End { face: None, place: None };
        };
        let position = from + hit.distance * direction;
        let element = self.subdivision.at(hit.face, position);
        End { face: Some(hit.face), place: element.map(|element| Place { element, position }) }
    }

    /// Returns the radiance that a face emits, or that of the surroundings; an empty slice if it
    /// does not emit.
    pub(crate) fn emitted(&self, face: Option<usize>) -> &[f64] {
        let Some(face) = face.map(|face| &self.transport.faces[face]) else {
            return &self.scene.ambient.radiance;
        };
        emitted(self.scene, face)
    }

    /// Returns for each band the largest radiosity of the light sources that rays have to hit.
    fn brightest_light(&self) -> Vec<f64> {
        let emitting = self.scene.surfaces.iter().filter(|surface| surface.emits());
        let radiances =
            || emitting.clone().map(|surface| &surface.radiance).chain([&self.scene.ambient.radiance]);
        let largest = |band: usize| {
            let radiance = radiances().map(|of_bands| of_bands[band]).fold(0.0, f64::max);
            if self.by_rays { irradiance(1.0, radiance) } else { 0.0 }
        };
        (0..self.scene.band_count()).map(largest).collect()
    }

    /// Includes the radiosity of nodes, and of places that point and distant lights can reach even
    /// if they reach no node.
    fn note_reflected(&mut self) {
        if self.question.orders == Some(0) {
            return;
        }
        let reflectances = self.reflectances();
        for ((brightest, rho), rough) in self.brightest.iter_mut().zip(reflectances).zip(&self.irradiance) {
            *brightest = rho.iter().zip(rough).map(|(rho, rough)| rho * rough).fold(*brightest, f64::max);
        }
        if self.scene.lights.is_empty() {
            return;
        }
        let reflecting = self.transport.faces.par_iter().filter(|face| is_reflecting(self.scene, face));
        let lit = reflecting.map(|face| {
            let beams = most_of_beams(face, self.scene, self.transport).into_iter();
            beams.zip(reflectance(self.scene, face.surface)).map(|(beam, rho)| rho * beam).collect()
        });
        let lit = lit.reduce(|| vec![0.0; self.brightest.len()], larger);
        self.brightest = larger(std::mem::take(&mut self.brightest), lit);
    }

    /// Returns for each band an upper bound on the irradiance of point and distant lights on the
    /// front of a surface.
    pub(crate) fn most_of_beams_on(&self, surface: usize) -> Vec<f64> {
        let on_faces =
            self.transport.fronts(surface).map(|face| most_of_beams(face, self.scene, self.transport));
        on_faces.fold(vec![0.0; self.scene.band_count()], larger)
    }

    /// Adds the rough value of the light from a direction, over the measure of the direction and
    /// times a weight, to the sums: the emitted light, if rays sample the light sources, and the
    /// reflected light. Returns where the ray ends.
    pub(crate) fn gather(
        &self,
        from: Vector,
        direction: Vector,
        weight: f64,
        sums: &mut [f64],
    ) -> Option<Place> {
        let end = self.trace(from, direction);
        if self.by_rays && self.question.direct {
            let emitted = self.emitted(end.face);
            sums.iter_mut().zip(emitted).for_each(|(sum, &l)| *sum += weight * irradiance(1.0, l));
        }
        let place = end.place.filter(|_| self.question.orders != Some(0))?;
        for ((sum, rough), rho) in sums.iter_mut().zip(&self.reflected).zip(self.reflectance(place.element)) {
            *sum += weight * rho * rough[self.node(place)];
        }
        Some(place)
    }
}

/// Returns for each band the larger of two values.
pub(crate) fn larger(one: Vec<f64>, other: Vec<f64>) -> Vec<f64> {
    one.into_iter().zip(other).map(|(one, other)| f64::max(one, other)).collect()
}
