//! System of equations of a scene: elements give rows of weights and direct light at their nodes,
//! these give the irradiance of the nodes, and from it any receiver gathers its light.

use super::coarsest_elements::coarsest;
use super::convergence::Change;
use super::direct::{Integral, Lights};
use super::element::Element;
use super::gathered_light::Kinds;
use super::kept::Kept;
use super::measure::Measure;
use super::operator::{Operator, Row, largest};
use super::partial::OnElement;
use super::question::Question;
use super::received::{OfNodes, Received};
use super::reflectance::{is_reflecting, reflectance};
use super::residual::{Check, Residual};
use super::shadows::Shadows;
use super::solution::{RESIDUAL, Reflection};
use super::transport::{Group, Scratch, Transport};
use crate::faces::is_bright;
use crate::form_factor::double_double::{Rounded, area};
use crate::geometry::Vector;
use crate::parallelism::Parallelism;
use crate::scene::Scene;
use crate::visibility::{Face, ReceivingArea};
use crate::watch::Watch;
use forms::math::{DoubleDouble, Real};
use forms_kernels::gathered_light::Effects as LightKinds;
use rustc_hash::{FxHashMap, FxHashSet};
use std::f64::consts::PI;
use std::sync::atomic::{AtomicUsize, Ordering};

/// A solution on elements.
pub(crate) struct Radiosity<'t> {
    pub(super) scene: &'t Scene,
    pub(super) transport: &'t Transport,
    pub(super) lights: &'t Lights<'t>,
    pub(super) watch: &'t dyn Watch,
    /// The kinds of light that receivers gather.
    kinds: Kinds,
    pub(super) question: Question,
    pub(super) elements: Vec<Element>,
    pub(super) outlines: Vec<Vec<Vector>>,
    pub(super) changes: Vec<[Change; 2]>,
    /// `None` if reflections are not requested.
    pub(super) reflection: Option<Reflection>,
    /// The first node of each element, and at the end the number of all nodes.
    pub(super) first: Vec<usize>,
    /// For each band the irradiance of each node.
    pub(super) irradiance: Vec<Vec<f64>>,
    /// For each band the largest irradiance of a node.
    pub(super) brightest: Vec<f64>,
    /// For each band the direct irradiance of each node.
    pub(super) direct: Vec<Vec<f64>>,
    /// The same for point and distant lights alone.
    pub(super) beams: Vec<Vec<f64>>,
    /// The lit parts of faces under point and distant lights.
    shadows: Shadows,
    /// For each band the deviation of the irradiance of each element from that of its nodes where a
    /// shadow border lies on it; and the possible error of the irradiance of each node due to that,
    /// over all reflections. Empty without shadow borders.
    pub(super) jumps: Vec<Vec<f64>>,
    pub(super) doubts: Vec<Vec<f64>>,
    /// Direct light at random points; its excess over the interpolation from the nodes; and for
    /// each band the resulting difference between the mean irradiance of each element and the mean
    /// of its nodes.
    pub(super) checks: Vec<Check>,
    pub(super) residuals: Vec<Residual>,
    pub(super) missed: Vec<Vec<f64>>,
    /// The direct light onto each area over which a receiver integrates.
    pub(super) straight: FxHashMap<ReceivingArea, Integral>,
    /// For each band the part of the irradiance of each node that is reflected once more: all but
    /// its highest order.
    pub(super) reflected: Vec<Vec<f64>>,
    /// For each band the largest error that the solution of the equations leaves.
    pub(super) tail: Vec<f64>,
}

impl<'t> Radiosity<'t> {
    /// Computes the solution on the coarsest elements; there is none yet if the work is stopped
    /// before.
    pub(crate) fn new(
        scene: &'t Scene,
        transport: &'t Transport,
        lights: &'t Lights<'t>,
        question: Question,
        watch: &'t dyn Watch,
    ) -> Self {
        let is_all = question.orders == Some(0);
        let shadows = Shadows::on(scene, transport, &question, watch);
        let straight = lights.fluxes((question.receives.all(), is_all), transport, &shadows, watch);
        let summed = straight.iter().filter(|(_, integral)| integral.kinds != lights.kinds());
        let summed: FxHashSet<[usize; 2]> =
            summed.map(|(area, _)| [area.surface, usize::from(area.is_back)]).collect();
        let is_summed = |face: &Face| summed.contains(&[face.surface, usize::from(face.is_back)]);
        let elements = coarsest(scene, transport, &question, &is_summed, &shadows);
        let mut radiosity = Self {
            scene,
            transport,
            lights,
            watch,
            kinds: Kinds::of(question.kinds(lights.kinds())),
            question,
            outlines: Vec::new(),
            changes: Vec::new(),
            reflection: None,
            first: Vec::new(),
            irradiance: Vec::new(),
            brightest: Vec::new(),
            direct: Vec::new(),
            beams: Vec::new(),
            shadows,
            jumps: Vec::new(),
            doubts: Vec::new(),
            checks: Vec::new(),
            residuals: Vec::new(),
            missed: Vec::new(),
            straight,
            reflected: Vec::new(),
            tail: Vec::new(),
            elements,
        };
        radiosity.check();
        radiosity.solve(&Kept::nothing(radiosity.elements.len()));
        radiosity.changes = radiosity.unknown_changes();
        radiosity
    }

    /// Computes the light at the nodes of the current elements, of which some are those of the
    /// current solution; returns whether this was done before the work was stopped.
    pub(super) fn solve(&mut self, kept: &Kept) -> bool {
        self.outlines = self.elements.iter().map(Element::outline).collect();
        self.first = vec![0];
        for element in &self.elements {
            self.first.push(self.first[self.first.len() - 1] + element.count());
        }
        let of_elements = self.all_rows(kept);
        if self.watch.is_stopped() {
            return false;
        }
        let OfNodes { rows, direct, beams, jumps } = OfNodes::of(of_elements, self.scene.band_count());
        (self.beams, self.jumps) = (beams, jumps);
        if self.question.orders == Some(0) {
            self.tail = vec![0.0; direct.len()];
            self.take(direct.clone());
            self.direct = direct;
            self.doubt_anew();
            return true;
        }
        let reflection = Reflection::new(Operator::new(rows, self.first.clone()), self.reflectances());
        let solved = reflection.solve(&direct, self.question.orders, RESIDUAL, self.watch);
        if self.watch.is_stopped() {
            return false;
        }
        (self.reflected, self.tail) = (solved.reflected, solved.tail);
        self.take(solved.irradiance);
        (self.direct, self.reflection) = (direct, Some(reflection));
        self.doubt_anew();
        true
    }

    /// Returns for each band the reflectance of each element.
    fn reflectances(&self) -> Vec<Vec<f64>> {
        let of_band = |band| self.elements.iter().map(|element| self.reflectance(element, band)).collect();
        (0..self.scene.band_count()).map(of_band).collect()
    }

    /// Returns the rows of the nodes of each element, and their direct light.
    fn all_rows(&self, kept: &Kept) -> Vec<Received> {
        let done = AtomicUsize::new(0);
        let of_element = |scratch: &mut Scratch, index| {
            let rows = self.rows(index, kept, scratch);
            let part = done.fetch_add(1, Ordering::Relaxed) as f64 / self.elements.len() as f64;
            if !self.watch.is_stopped() {
                self.watch.progress("interreflection", part);
            }
            rows
        };
        Parallelism::of(self.operations(self.size())).map(0..self.elements.len(), of_element)
    }

    /// Stores the irradiance of the nodes.
    fn take(&mut self, irradiance: Vec<Vec<f64>>) {
        self.brightest = irradiance.iter().map(|values| largest(values)).collect();
        self.irradiance = irradiance;
    }

    /// Returns the rows of the nodes of an element, and their direct light; only part of it if the
    /// work is stopped.
    fn rows(&self, index: usize, kept: &Kept, scratch: &mut Scratch) -> Received {
        let element = &self.elements[index];
        let points: Vec<Vector> = element.nodes().collect();
        let measure = Measure::Plane(element.normal);
        let group = Group { points: &points, outline: &self.outlines[index], measure };
        let reflects = self.question.orders != Some(0);
        let mut rows = if reflects { vec![Row::default(); points.len()] } else { Vec::new() };
        if reflects && self.receives_reflected(element) {
            let is_asked =
                |source: usize| self.elements[source].face != element.face && !kept.has(index, source);
            self.weigh_some(is_asked, group, scratch, |source, node, weights| {
                rows[node].push(source, weights);
            });
            if let Some(reflection) = &self.reflection {
                kept.add(index, &reflection.operator, &self.first, &mut rows);
            }
        }
        if self.watch.is_stopped() {
            return Received { rows, ..Received::default() };
        }
        if let Some(before) = kept.received(index, [&self.direct, &self.beams, &self.jumps]) {
            return Received { rows, ..before };
        }
        let mut direct = self.lights.reaching(group, self.transport, scratch);
        if !self.lights.kinds().beams {
            return Received { rows, direct, ..Received::default() };
        }
        let OnElement { nodes: beams, more, jump } =
            self.shadows.on_element((element, &self.outlines[index]), self.scene, self.transport);
        direct.iter_mut().zip(&more).for_each(|(sums, more)| {
            sums.iter_mut().zip(more).for_each(|(sum, more)| *sum += more);
        });
        Received { rows, direct, beams, jump }
    }

    /// Whether reflected light is needed at an element. Light that is reflected once leaves from
    /// where direct light arrives: then only receivers and visible surfaces need reflected light.
    fn receives_reflected(&self, element: &Element) -> bool {
        let face = &self.transport.faces[element.face];
        self.question.orders != Some(1) || self.question.is_seen || self.question.receives.have(face)
    }

    /// Returns the elements that reflect, with their indices; none if reflections are not
    /// requested.
    pub(super) fn sources(&self) -> impl Iterator<Item = (usize, &Element)> {
        let is_on = self.question.orders != Some(0);
        let elements = self.elements.iter().enumerate();
        let face = |element: &Element| &self.transport.faces[element.face];
        elements.filter(move |(_, element)| is_on && is_reflecting(self.scene, face(element)))
    }

    /// Returns the reflectance of an element in a band; the back of a one-sided surface is black.
    pub(super) fn reflectance(&self, element: &Element, band: usize) -> f64 {
        let face = &self.transport.faces[element.face];
        if is_bright(self.scene, face) { reflectance(self.scene, face.surface)[band] } else { 0.0 }
    }

    /// Returns the maximum number of operations to gather light at this number of points.
    pub(crate) fn operations(&self, points: usize) -> f64 {
        let reflected: usize = self.sources().map(|(index, _)| self.outlines[index].len()).sum();
        self.lights.operations(points, self.transport) + self.transport.operations(points, reflected)
    }

    /// Returns the number of nodes.
    pub(crate) fn size(&self) -> usize {
        self.first.last().copied().unwrap_or(0)
    }

    /// Returns the light sources.
    pub(crate) fn lights(&self) -> &'t Lights<'t> {
        self.lights
    }

    /// Returns the geometry that light passes through.
    pub(crate) fn transport(&self) -> &'t Transport {
        self.transport
    }

    /// Returns the error that the solution of the equations leaves, as radiance from all sides.
    pub(crate) fn floor(&self, band: usize) -> f64 {
        self.tail[band] / PI
    }

    /// Returns the quadrature error relative to an answer: none for light that is equal everywhere.
    pub(crate) fn rules(&self) -> f64 {
        let variation = |irradiance: &Vec<f64>| {
            let ends = irradiance.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
                (low.min(value), high.max(value))
            });
            if ends.1 > 0.0 { (ends.1 - ends.0) / ends.1 } else { 0.0 }
        };
        self.transport.accuracy * self.irradiance.iter().map(variation).fold(0.0, f64::max)
    }

    /// Returns the light of light sources and reflecting surfaces at each point of a group, for
    /// each band.
    pub(crate) fn reaching(&self, group: Group, scratch: &mut Scratch) -> Vec<Vec<f64>> {
        let bands = self.scene.band_count();
        let mut gathered = vec![0.0; bands * group.points.len()];
        self.gather(group, scratch, &mut gathered);
        gathered.chunks_exact(bands).map(<[f64]>::to_vec).collect()
    }

    /// Gathers the same light of all bands, point by point; only part of it if the work is stopped.
    fn gather(&self, group: Group, scratch: &mut Scratch, gathered: &mut [f64]) {
        self.gather_kinds(self.kinds, group, scratch, gathered);
    }

    /// Gathers the light that surfaces reflect, without direct light.
    pub(crate) fn gather_reflected(&self, group: Group, scratch: &mut Scratch, gathered: &mut [f64]) {
        let effects =
            LightKinds { interreflection: self.kinds.effects().interreflection, ..LightKinds::NONE };
        self.gather_kinds(Kinds::of(effects), group, scratch, gathered);
    }

    pub(super) fn gather_kinds(
        &self,
        kinds: Kinds,
        group: Group,
        scratch: &mut Scratch,
        gathered: &mut [f64],
    ) {
        let mut arriving = std::mem::take(&mut scratch.arriving);
        arriving.begin(kinds, gathered.len());
        let LightKinds { luminaires, surroundings, beams, interreflection } = kinds.effects();
        if luminaires || surroundings || beams {
            self.lights.add_arriving(group, self.transport, scratch, &mut arriving);
        }
        if interreflection {
            self.add_reflected(group, scratch, &mut arriving.reflected);
        }
        arriving.gather(kinds, gathered);
        scratch.arriving = arriving;
    }

    /// Whether surfaces reflect light to receivers.
    pub(crate) fn is_reflected(&self) -> bool {
        self.kinds.effects().interreflection
    }

    /// Adds the light that surfaces reflect: Σ ρ W E over their nodes.
    fn add_reflected(&self, group: Group, scratch: &mut Scratch, reflected: &mut [f64]) {
        let bands = self.scene.band_count();
        self.weigh(group, scratch, |source, point, weights| {
            let nodes = self.first[source]..self.first[source + 1];
            let element = &self.elements[source];
            for (band, sum) in reflected[point * bands..][..bands].iter_mut().enumerate() {
                let values = &self.reflected[band][nodes.clone()];
                let arriving: f64 = weights.iter().zip(values).map(|(w, e)| w * e).sum();
                *sum += self.reflectance(element, band) * arriving;
            }
        });
    }

    /// Returns the mean irradiance over an area, for each band, and the size of the area. Direct
    /// light that is known as an integral is taken from it; the remainder is summed over nodes.
    pub(crate) fn mean(&self, area: ReceivingArea) -> (Vec<f64>, f64) {
        let integral = self.straight.get(&area).filter(|_| self.question.direct);
        let left_out = match integral.map(|integral| integral.kinds) {
            // direct light is not requested
            None if !self.question.direct => Some(&self.direct),
            Some(kinds) if kinds == self.lights.kinds() => Some(&self.direct),
            Some(LightKinds { beams: true, .. }) => Some(&self.beams),
            _ => None,
        };
        let mut sums = vec![0.0; self.scene.band_count()];
        for (index, element) in self.elements.iter().enumerate() {
            if !area.contains(&self.transport.faces[element.face]) {
                continue;
            }
            for (area, node) in element.areas().zip(self.first[index]..) {
                for (band, sum) in sums.iter_mut().enumerate() {
                    let left_out = left_out.map_or(0.0, |left_out| left_out[band][node]);
                    *sum += area * (self.irradiance[band][node] - left_out);
                }
            }
        }
        if let Some(Integral { flux, .. }) = integral.filter(|_| left_out.is_some()) {
            sums.iter_mut().zip(flux).for_each(|(sum, flux)| *sum += flux.value.to_f64());
        }
        let whole = self.transport.size_of(area);
        (sums.into_iter().map(|sum| sum / whole).collect(), whole)
    }

    /// Returns the direct light onto an area, if all of it is an integral.
    fn integral(&self, area: ReceivingArea) -> Option<&Integral> {
        self.straight.get(&area).filter(|integral| integral.kinds == self.lights.kinds())
    }

    /// Returns the errors of the direct light onto an area in a band, as a flux, by quadrature
    /// and by rounding; `None` where it is summed over nodes.
    pub(crate) fn straight_error(&self, area: ReceivingArea, band: usize) -> Option<[f64; 2]> {
        let Integral { flux, of_rules, .. } = self.integral(area)?;
        Some([of_rules[band], flux[band].error])
    }

    /// Returns for each band the mean direct irradiance over an area as the nearest
    /// `f64`, and its rounding error; both as a flux with `is_flux`. `None` where it is summed over
    /// nodes.
    pub(crate) fn precise_mean(&self, over: ReceivingArea, is_flux: bool) -> Option<Vec<[f64; 2]>> {
        let flux = &self.integral(over)?.flux;
        let areas = self.transport.faces_in(over).map(|face| area(&face.vertices));
        let area = areas.fold(DoubleDouble::from_f64(0.0), |sum, area| sum + area);
        let nearest = |flux: &Rounded| {
            let value = if is_flux { flux.value } else { flux.value / area };
            Rounded { value, error: 0.0 }.nearest()
        };
        Some(flux.iter().map(nearest).collect())
    }
}
