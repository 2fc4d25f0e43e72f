//! Direct light: lights of all kinds and what stands before them become what a receiver gets straight from them.
//!
//! ```text
//! a face of radiance L       π L μ(visible part)
//! from outside, radiance L   π L (μ(all directions) − Σ μ(visible parts of all faces))
//! a point of intensity I     I/r² where it is seen,   times cos θ for a plane
//! from far away              E where nothing hides it, times cos θ
//! ```
//! μ is the measure of the receiver over π. All of it is exact but for rounding.

use super::gather::{Group, Scratch, Seen, Transport};
use super::measure::Measure;
use crate::faces::emits;
use crate::geometry::{Exchange, Screens, Vector, exchange_with};
use crate::kernels::irradiance;
use crate::scene::{LightKind, Scene};

/// Exchange below this part of a surface is computed to the absolute error of this part.
const LEAST: f64 = 1e-3;

/// What shines in a scene.
pub(crate) struct Lights<'s> {
    scene: &'s Scene,
    /// The faces that have to be seen: those that emit, and all of them where light comes from outside.
    faces: Vec<usize>,
    from_outside: bool,
}

impl<'s> Lights<'s> {
    pub(crate) fn of(scene: &'s Scene, transport: &Transport) -> Self {
        let from_outside = scene.ambient.radiance.iter().any(|&radiance| radiance > 0.0);
        let counts = |&index: &usize| from_outside || emits(scene, &transport.faces[index]);
        let faces = (0..transport.faces.len()).filter(counts).collect();
        Self { scene, faces, from_outside }
    }

    /// Whether light comes from outside.
    pub(crate) fn come_from_outside(&self) -> bool {
        self.from_outside
    }

    /// The faces that have to be seen for what comes straight to a point.
    pub(super) fn faces(&self) -> &[usize] {
        &self.faces
    }

    /// What each point of a group gets, for each band.
    pub(crate) fn reaching(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
    ) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let mut sums = vec![0.0; bands * group.points.len()];
        self.add_reaching(group, transport, scratch, &mut sums);
        sums.chunks_exact(bands).map(<[f64]>::to_vec).collect()
    }

    /// Adds what each point of a group gets to its sums, which are those of all bands, point by point.
    pub(crate) fn add_reaching(
        &self,
        group: Group,
        transport: &Transport,
        scratch: &mut Scratch,
        sums: &mut [f64],
    ) {
        let bands = self.scene.band_count();
        let mut outlines = std::mem::take(&mut scratch.outlines);
        let mut factors = vec![0.0; group.points.len()];
        let mut hidden = vec![0.0; if self.from_outside { group.points.len() } else { 0 }];
        for &index in &self.faces {
            let face = &transport.faces[index];
            let luminaire = (face.vertices.as_slice(), face.normal);
            factors.fill(0.0);
            match transport.seen(group, luminaire, scratch) {
                Seen::Nothing => continue,
                Seen::Whole => outlines.add_whole(group.points, luminaire.0, group.measure, &mut factors),
                Seen::Parts => {
                    outlines.clear();
                    transport.take_outlines(group, luminaire, scratch, &mut outlines);
                    outlines.add_pieces(group.measure, &mut factors);
                }
            }
            hidden.iter_mut().zip(&factors).for_each(|(hidden, factor)| *hidden += factor);
            if emits(self.scene, face) {
                let radiance = &self.scene.surfaces[face.surface].radiance;
                let of_points = sums.chunks_exact_mut(bands).zip(&factors);
                of_points.for_each(|(sum, &factor)| add(sum, factor, radiance));
            }
        }
        scratch.outlines = outlines;
        for (sum, hidden) in sums.chunks_exact_mut(bands).zip(hidden) {
            add(sum, group.measure.whole() - hidden, &self.scene.ambient.radiance);
        }
        if !self.scene.lights.is_empty() {
            for (sum, &point) in sums.chunks_exact_mut(bands).zip(group.points) {
                self.add_lights(point, group.measure, transport, sum);
            }
        }
    }

    /// For each band, the flux that comes straight to the fronts of a surface, and its error; nothing where light is not that of
    /// faces alone. It is an integral over both, and not a sum over points that may miss what is near an edge.
    pub(crate) fn flux(&self, surface: usize, transport: &Transport) -> Option<Vec<[f64; 2]>> {
        if self.from_outside || !self.scene.lights.is_empty() {
            return None;
        }
        let nothing = Screens::of(&[]);
        let screens = if transport.occlusion { &transport.screens } else { &nothing };
        let mut flux = vec![[0.0; 2]; self.scene.band_count()];
        for here in transport.fronts(surface) {
            for there in self.faces.iter().map(|&index| &transport.faces[index]) {
                let tolerances = [transport.accuracy, LEAST * here.area];
                let Exchange { area, error } = exchange_with(here, there, screens, tolerances);
                let radiances = &self.scene.surfaces[there.surface].radiance;
                for ([value, of_value], &radiance) in flux.iter_mut().zip(radiances) {
                    *value += irradiance(area, radiance);
                    *of_value += irradiance(error, radiance);
                }
            }
        }
        Some(flux)
    }

    /// Adds what comes from lights without extent.
    pub(super) fn add_lights(&self, point: Vector, measure: Measure, transport: &Transport, sum: &mut [f64]) {
        for light in &self.scene.lights {
            let (towards, arriving, squared) = match &light.kind {
                LightKind::Point { position, intensity } => {
                    let way = *position - point;
                    (way, intensity, way.dot(way))
                }
                LightKind::Distant { direction, irradiance } => (-*direction, irradiance, 1.0),
            };
            let Some(unit) = towards.unit() else { continue };
            let factor = measure.factor(unit) / squared;
            let hidden = || match light.kind {
                LightKind::Point { position, .. } => transport.screens.hides(point, position),
                LightKind::Distant { .. } => transport.screens.hides_direction(point, unit),
            };
            if factor != 0.0 && !(transport.occlusion && hidden()) {
                sum.iter_mut().zip(arriving).for_each(|(sum, arriving)| *sum += factor * arriving);
            }
        }
    }
}

fn add(sum: &mut [f64], factor: f64, radiance: &[f64]) {
    sum.iter_mut().zip(radiance).for_each(|(sum, &radiance)| *sum += irradiance(factor, radiance));
}
