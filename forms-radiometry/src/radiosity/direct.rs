//! Direct light: lights of all kinds and what stands before them become what a receiver gets straight from them.
//!
//! ```text
//! a face of radiance L       F L, F = μ(visible part)
//! from outside, radiance L   open, μ(all directions) − Σ μ(visible parts of all faces)
//! a point of intensity I     I/r² where it is seen,   times cos θ for a plane
//! from far away              E where nothing hides it, times cos θ
//! ```
//! μ is the measure of the receiver over π. All of it is exact but for rounding. What the receiver makes of it is gathered by
//! [`arriving`](super::arriving).

use super::arriving::{Arriving, Kinds};
use super::closed_form::emitted;
use super::gather::{Group, Scratch, Transport};
use super::measure::Measure;
use super::shadows::{Shadows, spectrum};
use crate::faces::emits;
use crate::geometry::precise::Rounded;
use crate::geometry::{Exchange, Face, Vector, exchange_of, exchange_precisely, exchange_with};
use crate::kernels::gathered_light::Effects;
use crate::scene::{Light, LightKind, ReceiverKind, Scene};
use crate::simulation::Watch;
use std::f64::consts::PI;

/// The relative errors to which faces with nothing in between exchange light where these have so many pairs of edges at most: to the last digit two
/// quadrilaterals, of 16 pairs, take 1 to 20 ms, to the twelfth, where `f64` has it, some 5 µs, and hardly less to fewer. Beside a map of what comes straight, which takes less, the last
/// digit is not worth that.
const OF_FEW: [(usize, f64); 2] = [(80, LAST_DIGIT), (1024, 1e-12)];
const LAST_DIGIT: f64 = 1e-15;
/// Exchange below this part of a surface is computed to the absolute error of this part.
const LEAST: f64 = 1e-3;

/// What shines in a scene.
pub(crate) struct Lights<'s> {
    scene: &'s Scene,
    /// The faces that have to be seen: those that emit, and all of them where light comes from outside.
    faces: Vec<usize>,
    /// The round surfaces that they are pieces of.
    round: Vec<usize>,
    kinds: Kinds,
}

/// The faces that a point has to see for direct light: those that emit, and all of them where light comes from outside.
pub(super) fn sources(scene: &Scene, faces: &[Face], kinds: Effects) -> Vec<usize> {
    let counts = |&index: &usize| kinds.surroundings || emits(scene, &faces[index]);
    (0..faces.len()).filter(counts).collect()
}

/// What comes straight to a surface in closed forms and integrals over it.
#[derive(Clone, Debug)]
pub(super) struct Integral {
    /// For each band the flux, and what rules of integration leave of it beside rounding.
    pub(super) flux: Vec<Rounded>,
    pub(super) of_rules: Vec<f64>,
    /// The kinds of light that it is of; those of other kinds are summed over nodes.
    pub(super) kinds: Effects,
}

impl Integral {
    fn of_nothing(bands: usize) -> Self {
        Self { flux: vec![Rounded::exactly(0.0); bands], of_rules: vec![0.0; bands], kinds: Effects::NONE }
    }

    fn add(&mut self, flux: &[Rounded]) {
        self.flux.iter_mut().zip(flux).for_each(|(sum, &flux)| *sum = *sum + flux);
    }
}

impl<'s> Lights<'s> {
    pub(crate) fn of(scene: &'s Scene, transport: &Transport) -> Self {
        let effects = kinds(scene, &transport.faces);
        let faces = sources(scene, &transport.faces, effects);
        let mut round: Vec<usize> = faces.iter().map(|&index| transport.faces[index].surface).collect();
        round.dedup();
        round.retain(|&surface| scene.surfaces[surface].shape.is_round());
        Self { scene, faces, round, kinds: Kinds::of(effects) }
    }

    /// The kinds of light that come straight from lights.
    pub(crate) fn kinds(&self) -> Effects {
        self.kinds.effects()
    }

    /// The round surfaces that have to be seen for what comes straight to a point.
    pub(super) fn round(&self) -> &[usize] {
        &self.round
    }

    pub(super) fn scene(&self) -> &Scene {
        self.scene
    }

    /// The faces that have to be seen for what comes straight to a point.
    pub(super) fn faces(&self) -> &[usize] {
        &self.faces
    }

    /// How many operations it takes at most to find what comes straight to so many points. A light without extent counts as an edge.
    pub(crate) fn operations(&self, points: usize, transport: &Transport) -> f64 {
        let of_faces: usize = self.faces.iter().map(|&index| transport.faces[index].vertices.len()).sum();
        transport.operations(points, of_faces + self.scene.lights.len())
    }

    /// What each point of a group gets, for each band.
    pub(crate) fn reaching(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let mut gathered = vec![0.0; bands * group.points.len()];
        self.gather(group, transport, scratch, &mut gathered);
        gathered.chunks_exact(bands).map(<[f64]>::to_vec).collect()
    }

    /// The same, point by point and band by band.
    pub(crate) fn gather(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
        gathered: &mut [f64],
    ) {
        let mut arriving = std::mem::take(&mut scratch.arriving);
        arriving.begin(self.kinds, gathered.len());
        self.add_arriving(group, transport, scratch, &mut arriving);
        arriving.gather(self.kinds, gathered);
        scratch.arriving = arriving;
    }

    /// Adds what arrives at the points of a group straight from lights.
    pub(super) fn add_arriving(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
        arriving: &mut Arriving,
    ) {
        let bands = self.scene.band_count();
        let Effects { luminaires, surroundings, beams, .. } = self.kinds();
        if luminaires || surroundings {
            self.add_faces(group, transport, scratch, arriving);
        }
        if beams {
            for (sum, &point) in arriving.beams.chunks_exact_mut(bands).zip(group.points) {
                self.add_lights(point, group.measure, transport, sum);
            }
        }
    }

    /// Adds what faces emit, and what comes from outside beside them.
    fn add_faces(&self, group: Group, transport: &Transport, scratch: &mut Scratch, arriving: &mut Arriving) {
        let bands = self.scene.band_count();
        // of each point the form factor of directions in which no face stands, for every band
        arriving.open.fill(group.measure.whole());
        for &index in &self.faces {
            let face = &transport.faces[index];
            let Some(measures) = transport.measured(group, (&face.vertices, face.normal), scratch) else {
                continue;
            };
            for (open, measure) in arriving.open.chunks_exact_mut(bands).zip(measures) {
                open.iter_mut().for_each(|open| *open -= measure);
            }
            if emits(self.scene, face) {
                let radiance = &self.scene.surfaces[face.surface].radiance;
                let of_points = arriving.emitted.chunks_exact_mut(bands).zip(measures);
                of_points.for_each(|(sum, &measure)| {
                    sum.iter_mut().zip(radiance).for_each(|(sum, radiance)| *sum += measure * radiance);
                });
            }
        }
        let outside = &self.scene.ambient.radiance;
        arriving.outside.chunks_exact_mut(bands).for_each(|of_point| of_point.copy_from_slice(outside));
    }

    /// The flux that comes straight to the fronts of a surface, as integrals over it, and not as a sum over points that may miss what is near
    /// an edge or in a shadow; `is_all` if nothing is reflected. Of no kind of light where the work is stopped.
    pub(super) fn flux(
        &self,
        (surface, is_all): (usize, bool),
        transport: &Transport,
        shadows: &Shadows,
        watch: &dyn Watch,
    ) -> Integral {
        let mut integral = Integral::of_nothing(self.scene.band_count());
        if !self.kinds().surroundings
            && let Some(flux) = self.flux_of_faces((surface, is_all), transport, watch)
        {
            let (flux, of_rules): (Vec<Rounded>, Vec<f64>) = flux.into_iter().unzip();
            integral.add(&flux);
            integral.of_rules = of_rules;
            integral.kinds.luminaires = self.kinds().luminaires;
        }
        let of_face = |index: usize| shadows.flux(index, self.scene, transport);
        let fronts = (0..transport.faces.len()).filter(|&index| transport.faces[index].is_front_of(surface));
        if self.kinds().beams
            && let Some(of_faces) = fronts.map(of_face).collect::<Option<Vec<_>>>()
        {
            of_faces.iter().for_each(|flux| integral.add(flux));
            integral.kinds.beams = true;
        }
        integral
    }

    /// For each band the flux of faces that emit, and what rules of integration leave of it; nothing where the work is stopped.
    fn flux_of_faces(
        &self,
        (surface, is_all): (usize, bool),
        transport: &Transport,
        watch: &dyn Watch,
    ) -> Option<Vec<(Rounded, f64)>> {
        let mut flux = vec![(Rounded::exactly(0.0), 0.0); self.scene.band_count()];
        let received: usize = transport.fronts(surface).map(|face| face.vertices.len()).sum();
        let pairs = received * self.edges(transport);
        let has_map = self.scene.receivers.iter().any(|receiver| {
            matches!(receiver.kind, ReceiverKind::Surface { surface: of, grid: Some(_) } if of == surface)
        });
        let mut of_few =
            OF_FEW.into_iter().filter(|(_, accuracy)| !(is_all && has_map && *accuracy <= LAST_DIGIT));
        let of_few = of_few.find(|&(most, _)| pairs <= most);
        let accuracy = of_few.map_or(transport.accuracy, |(_, accuracy)| accuracy);
        for here in transport.fronts(surface) {
            for there in self.faces.iter().map(|&index| &transport.faces[index]) {
                if watch.is_stopped() {
                    return None;
                }
                let (exchanged, of_rules) = exchanged((here, there), accuracy, transport, watch);
                let surface = &self.scene.surfaces[there.surface];
                let emitted = emitted(exchanged, surface).zip(&surface.radiance);
                flux.iter_mut().zip(emitted).for_each(|((flux, rules), (emitted, radiance))| {
                    *flux = *flux + emitted.times_pi();
                    *rules += PI * radiance * of_rules;
                });
            }
        }
        Some(flux)
    }

    /// Adds what comes from lights without extent.
    pub(super) fn add_lights(&self, point: Vector, measure: Measure, transport: &Transport, sum: &mut [f64]) {
        lights_at(self.scene, point, measure, transport, |arriving, factor, _| {
            sum.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += factor * arriving);
        });
    }
}

/// Calls `each` for the lights without extent that a point sees, with the intensity or irradiance in each band, what that is multiplied by, and
/// the distance, which may be without end.
pub(super) fn lights_at(
    scene: &Scene,
    point: Vector,
    measure: Measure,
    transport: &Transport,
    mut each: impl FnMut(&[f64], f64, f64),
) {
    for light in &scene.lights {
        let factor = reaching_factor(light, point, measure);
        if factor != 0.0 && !hides(light, point, transport) {
            let distance = match light.kind {
                LightKind::Point { position, .. } => (position - point).length(),
                LightKind::Distant { .. } => f64::INFINITY,
            };
            each(spectrum(light), factor, distance);
        }
    }
}

/// What is multiplied by the intensity, or the irradiance, of a light for what it makes at a point, were nothing in between.
pub(super) fn reaching_factor(light: &Light, point: Vector, measure: Measure) -> f64 {
    let (towards, squared) = match light.kind {
        LightKind::Point { position, .. } => {
            let way = position - point;
            (way, way.dot(way))
        }
        LightKind::Distant { direction, .. } => (-direction, 1.0),
    };
    towards.unit().map_or(0.0, |unit| measure.factor(unit) / squared)
}

/// Whether a point does not see a light without extent.
pub(super) fn hides(light: &Light, point: Vector, transport: &Transport) -> bool {
    transport.occlusion
        && match light.kind {
            LightKind::Point { position, .. } => transport.screens.hides(point, position),
            LightKind::Distant { direction, .. } => transport.screens.hides_direction(point, -direction),
        }
}

/// The kinds of light that come straight from the lights of a scene with these faces.
pub(super) fn kinds(scene: &Scene, faces: &[Face]) -> Effects {
    Effects {
        luminaires: faces.iter().any(|face| emits(scene, face)),
        surroundings: scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0),
        beams: !scene.lights.is_empty(),
        interreflection: false,
    }
}

/// The exchange area of two faces of a scene, and what rules of integration leave of it.
fn exchanged(
    (here, there): (&Face, &Face),
    accuracy: f64,
    transport: &Transport,
    watch: &dyn Watch,
) -> (Rounded, f64) {
    let screens = &transport.screens;
    let Exchange { area, error } = if transport.occlusion {
        let tolerances = [transport.accuracy, LEAST * here.area];
        exchange_with(here, there, screens, tolerances, || watch.is_stopped())
    } else if !screens.face_each_other(&here.vertices, Some(here.normal), &there.vertices, there.normal) {
        Exchange::default()
    } else if let Some(precise) = (accuracy <= LAST_DIGIT).then(|| exchange_precisely(here, there)).flatten()
    {
        return (precise, 0.0);
    } else {
        exchange_of(here, there, [accuracy, transport.accuracy])
    };
    (Rounded::exactly(area), error)
}
