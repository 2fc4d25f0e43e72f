//! Direct light: computes the direct light of all kinds of light sources at a receiver, with
//! occlusion.
//!
//! ```text
//! a face of radiance L               F L, F = μ(visible part)
//! surroundings of radiance L         open, μ(all directions) − Σ μ(visible parts of all faces)
//! a point light of intensity I       I/r² where it is visible,   times cos θ for a plane
//! a distant light of irradiance E    E where nothing occludes it, times cos θ
//! ```
//! μ is the measure of the receiver over π. Everything is exact except for rounding.
//! [`arriving`](super::gathered_light) combines it into the gathered light of the receiver.

use super::emission::emitted;
use super::gathered_light::{Arriving, Kinds};
use super::measure::Measure;
use super::point_lights::{hides, reaching_factor, spectrum};
use super::shadows::Shadows;
use super::transport::{Group, Scratch, Transport};
use crate::faces::emits;
use crate::form_factor::double_double::Rounded;
use crate::form_factor::{Exchange, exchange_of, exchange_precisely, exchange_with};
use crate::geometry::Vector;
use crate::parallelism::Parallelism;
use crate::scene::{LightKind, Scene};
use crate::visibility::{Face, ReceivingArea};
use crate::watch::Watch;
use forms_kernels::gathered_light::Effects as LightKinds;
use rustc_hash::{FxHashMap, FxHashSet};
use std::f64::consts::PI;

/// Maximum numbers of edge pairs, each with the relative error to which unoccluded faces exchange
/// light. To the last digit, two quadrilaterals, with 16 pairs, take 1 to 20 ms; to the twelfth
/// digit, which `f64` reaches, some 5 µs, and hardly less to fewer. A map of direct light takes
/// less time than the last digit, which is then not worth its cost.
const OF_FEW: [(usize, f64); 2] = [(80, LAST_DIGIT), (1024, 1e-12)];
const LAST_DIGIT: f64 = 1e-15;
/// Exchange below this fraction of a surface is computed to the absolute error of this fraction.
const LEAST: f64 = 1e-3;

/// Light sources of a scene.
pub(crate) struct Lights<'s> {
    scene: &'s Scene,
    /// The faces that points have to see: those that emit, and all of them if there is light from
    /// the surroundings.
    faces: Vec<usize>,
    /// The disks and spheres whose pieces these faces are.
    round: Vec<usize>,
    kinds: Kinds,
}

/// Returns the faces that a point has to see for direct light: those that emit, and all of them if
/// there is light from the surroundings.
pub(super) fn sources(scene: &Scene, faces: &[Face], kinds: LightKinds) -> Vec<usize> {
    let counts = |&index: &usize| kinds.surroundings || emits(scene, &faces[index]);
    (0..faces.len()).filter(counts).collect()
}

/// Direct light onto a surface, by closed forms and by integrals over the surface.
#[derive(Clone, Debug)]
pub(super) struct Integral {
    /// For each band the flux, and its quadrature error, without rounding.
    pub(super) flux: Vec<Rounded>,
    pub(super) of_rules: Vec<f64>,
    /// The kinds of light that it includes; the other kinds are summed over nodes.
    pub(super) kinds: LightKinds,
}

impl Integral {
    fn of_nothing(bands: usize) -> Self {
        Self { flux: vec![Rounded::exactly(0.0); bands], of_rules: vec![0.0; bands], kinds: LightKinds::NONE }
    }

    /// Adds the light onto another area, of the same kinds.
    fn take(&mut self, other: &Self) {
        self.add(&other.flux);
        self.of_rules.iter_mut().zip(&other.of_rules).for_each(|(sum, rules)| *sum += rules);
        if other.kinds != self.kinds {
            // the work was stopped between the two
            self.kinds = LightKinds::NONE;
        }
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

    /// Returns the kinds of direct light.
    pub(crate) fn kinds(&self) -> LightKinds {
        self.kinds.effects()
    }

    /// Returns the disks and spheres that a point has to see for direct light.
    pub(super) fn round(&self) -> &[usize] {
        &self.round
    }

    pub(super) fn scene(&self) -> &Scene {
        self.scene
    }

    /// Returns the faces that a point has to see for direct light.
    pub(super) fn faces(&self) -> &[usize] {
        &self.faces
    }

    /// Returns the maximum number of operations for the direct light at this number of points. A
    /// point or distant light counts as an edge.
    pub(crate) fn operations(&self, points: usize, transport: &Transport) -> f64 {
        let of_faces: usize = self.faces.iter().map(|&index| transport.faces[index].vertices.len()).sum();
        transport.operations(points, of_faces + self.scene.lights.len())
    }

    /// Returns the direct light at each point of a group, for each band.
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

    /// Gathers the direct light at the points of a group, point by point and band by band.
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

    /// Adds the direct light that arrives at the points of a group.
    pub(super) fn add_arriving(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
        arriving: &mut Arriving,
    ) {
        let bands = self.scene.band_count();
        let LightKinds { luminaires, surroundings, beams, .. } = self.kinds();
        if luminaires || surroundings {
            self.add_faces(group, transport, scratch, arriving);
        }
        if beams {
            for (sum, &point) in arriving.beams.chunks_exact_mut(bands).zip(group.points) {
                self.add_lights(point, group.measure, transport, sum);
            }
        }
    }

    /// Adds the light that faces emit, and the light of the surroundings between them.
    fn add_faces(&self, group: Group, transport: &Transport, scratch: &mut Scratch, arriving: &mut Arriving) {
        let bands = self.scene.band_count();
        // for each point, the form factor of the directions in which there is no face, repeated for
        // every band
        arriving.open.fill(group.measure.whole());
        for &index in &self.faces {
            let face = &transport.faces[index];
            let Some(measures) = transport.measured(group, (&face.vertices, face.normal), scratch) else {
                continue;
            };
            let hidden = if transport.hides_outside { measures } else { &[] };
            for (open, measure) in arriving.open.chunks_exact_mut(bands).zip(hidden) {
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

    /// Returns the direct flux onto each of these areas. The flux onto a side whose faces are areas,
    /// too, is the sum of theirs.
    pub(super) fn fluxes(
        &self,
        (areas, is_all): (&[ReceivingArea], bool),
        transport: &Transport,
        shadows: &Shadows,
        watch: &dyn Watch,
    ) -> FxHashMap<ReceivingArea, Integral> {
        let side = |area: &ReceivingArea| ReceivingArea { face: None, ..*area };
        let faces = || areas.iter().filter(|area| area.face.is_some());
        let divided: FxHashSet<ReceivingArea> = faces().map(side).collect();
        let computed: Vec<ReceivingArea> =
            areas.iter().filter(|area| !divided.contains(area)).copied().collect();
        let flux =
            |_: &mut (), &area: &ReceivingArea| (area, self.flux((area, is_all), transport, shadows, watch));
        let parallelism = if transport.occlusion { Parallelism::Shared } else { Parallelism::Alone };
        let mut fluxes: FxHashMap<_, _> = parallelism.map(&computed, flux).into_iter().collect();
        for face in faces() {
            let Some(own) = fluxes.get(face).cloned() else { continue };
            fluxes.entry(side(face)).and_modify(|sum| sum.take(&own)).or_insert(own);
        }
        fluxes
    }

    /// Returns the direct flux onto an area as integrals over it. A sum over points
    /// could miss light near an edge or in a shadow. `is_all` is set if nothing is reflected. No
    /// kind of light is included if the work is stopped.
    fn flux(
        &self,
        (area, is_all): (ReceivingArea, bool),
        transport: &Transport,
        shadows: &Shadows,
        watch: &dyn Watch,
    ) -> Integral {
        let mut integral = Integral::of_nothing(self.scene.band_count());
        if !self.kinds().surroundings
            && let Some(flux) = self.flux_of_faces((area, is_all), transport, watch)
        {
            let (flux, of_rules): (Vec<Rounded>, Vec<f64>) = flux.into_iter().unzip();
            integral.add(&flux);
            integral.of_rules = of_rules;
            integral.kinds.luminaires = self.kinds().luminaires;
        }
        let of_face = |index: usize| shadows.flux(index, self.scene, transport);
        if self.kinds().beams
            && let Some(of_faces) = transport.indices_in(area).map(of_face).collect::<Option<Vec<_>>>()
        {
            of_faces.iter().for_each(|flux| integral.add(flux));
            integral.kinds.beams = true;
        }
        integral
    }

    /// Returns for each band the flux of emitting faces, and its quadrature error; `None` if the
    /// work is stopped.
    fn flux_of_faces(
        &self,
        (area, is_all): (ReceivingArea, bool),
        transport: &Transport,
        watch: &dyn Watch,
    ) -> Option<Vec<(Rounded, f64)>> {
        let mut flux = vec![(Rounded::exactly(0.0), 0.0); self.scene.band_count()];
        let received: usize = transport.faces_in(area).map(|face| face.vertices.len()).sum();
        let pairs = received * self.edges(transport);
        let is_one_of_many = self.scene.receivers.iter().any(|receiver| {
            receiver.kind.has_cells() && receiver.kind.side().is_some_and(|side| side.surface == area.surface)
        });
        let mut of_few =
            OF_FEW.into_iter().filter(|(_, accuracy)| !(is_all && is_one_of_many && *accuracy <= LAST_DIGIT));
        let of_few = of_few.find(|&(most, _)| pairs <= most);
        let accuracy = of_few.map_or(transport.accuracy, |(_, accuracy)| accuracy);
        for here in transport.faces_in(area) {
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

    /// Adds the light of point and distant lights.
    pub(super) fn add_lights(&self, point: Vector, measure: Measure, transport: &Transport, sum: &mut [f64]) {
        lights_at(self.scene, point, measure, transport, |arriving, factor, _| {
            sum.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += factor * arriving);
        });
    }
}

/// Calls `each` for the point and distant lights that a point sees, with the intensity or
/// irradiance in each band, its factor, and the distance, which can be infinite.
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

/// Returns the kinds of direct light in a scene with these faces.
pub(super) fn kinds(scene: &Scene, faces: &[Face]) -> LightKinds {
    LightKinds {
        luminaires: faces.iter().any(|face| emits(scene, face)),
        surroundings: scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0),
        beams: !scene.lights.is_empty(),
        interreflection: false,
    }
}

/// Returns the exchange area of two faces of a scene, and its quadrature error.
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
