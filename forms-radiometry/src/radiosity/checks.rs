//! Checks: compares the direct light of faces and surroundings at random points of elements with
//! its interpolation from the nodes.
//!
//! ```text
//! the first elements ─▶ random points, more on larger ones ─▶ E of lights ─┐
//! nodes ─▶ polynomials of elements at these points ─▶ Eₙ ──────────────────┴─▶ r = E − Eₙ
//! error of the flux of a surface by its nodes:  |Σ a r| + 2 √Σ (a r)²
//! ```
//! r is computed again for finer elements; a is the area that a point represents.
//!
//! Light through a narrow opening falls between nodes that are far apart, so that the nodes miss
//! it. Additional random points find this light if it covers at least the area that one of them
//! represents.

use super::element::Element;
use super::measure::Measure;
use super::residual::{Check, Residual};
use super::system::Radiosity;
use super::transport::{Group, Scratch};
use crate::geometry::Vector;
use crate::sampling::{Net, key};
use crate::visibility::ReceivingArea;
use forms_kernels::gathered_light::Effects as LightKinds;
use rayon::prelude::*;

/// Number of points on all elements together if faces are few, and maximum number of operations for
/// them if faces are many.
const POINTS: f64 = 4096.0;
const OPERATIONS: f64 = 4e8;
/// Number of standard errors in the error of a sum over points.
const SURE: f64 = 2.0;
/// Key that distinguishes the random numbers of these points from others.
const KEY: u64 = 0x63_6865_636b;

impl Radiosity<'_> {
    /// Computes the direct light at random points, if nodes represent light that can be occluded at
    /// them.
    pub(super) fn check(&mut self) {
        let LightKinds { luminaires, surroundings, .. } = self.lights.kinds();
        let is_told = surroundings || luminaires && self.question.orders != Some(0);
        if !self.transport.occlusion || !is_told {
            return;
        }
        let whole: f64 = self.elements.iter().map(|element| element.area).sum();
        let count = POINTS.min(OPERATIONS / self.lights.operations(1, self.transport));
        let on_element = |(index, element): (usize, &Element)| {
            let points = (count * element.area / whole).ceil();
            let net = Net::new(key(key(self.scene.solve.seed, KEY), index as u64));
            let mut scratch = Scratch::default();
            let mut checks = Vec::new();
            for point in 0..points as u32 {
                if self.watch.is_stopped() {
                    break;
                }
                let position = element.image(net.point(point));
                let straight = self.straight_to(position, element.normal, &mut scratch);
                checks.push(Check { face: element.face, position, area: element.area / points, straight });
            }
            checks
        };
        self.checks = self.elements.par_iter().enumerate().flat_map_iter(on_element).collect();
    }

    /// Returns the direct light of faces and surroundings at a point of a face, in each band.
    fn straight_to(&self, position: Vector, normal: Vector, scratch: &mut Scratch) -> Vec<f64> {
        let points = [position];
        let measure = Measure::Plane(normal);
        let group = Group { points: &points, outline: &points, measure };
        let mut straight = self.lights.reaching(group, self.transport, scratch).swap_remove(0);
        if self.lights.kinds().beams {
            let mut beams = vec![0.0; straight.len()];
            self.lights.add_lights(position, measure, self.transport, &mut beams);
            straight.iter_mut().zip(beams).for_each(|(all, beams)| *all -= beams);
        }
        straight
    }

    /// Returns the excess of the direct light over its interpolation from the nodes, point by
    /// point.
    pub(super) fn residuals(&self) -> Vec<Residual> {
        let mut on_face = vec![Vec::new(); self.transport.faces.len()];
        for (index, element) in self.elements.iter().enumerate() {
            on_face[element.face].push(index);
        }
        let of_point = |check: &Check| {
            let mut elements = on_face[check.face].iter().copied();
            let element = elements.find(|&element| self.elements[element].contains(check.position))?;
            let basis = self.elements[element].basis(check.position);
            let nodes = self.first[element]..self.first[element + 1];
            let of_band = |(band, straight): (usize, &f64)| {
                let beams = self.beams[band].get(nodes.clone()).unwrap_or(&[]);
                let sum = |values: &[f64]| basis.iter().zip(values).map(|(b, e)| b * e).sum::<f64>();
                check.area * (straight - (sum(&self.direct[band][nodes.clone()]) - sum(beams)))
            };
            Some(Residual { element, flux: check.straight.iter().enumerate().map(of_band).collect() })
        };
        self.checks.par_iter().filter_map(of_point).collect()
    }

    /// Returns for each band the absolute difference between the mean irradiance of each element
    /// and the mean of its nodes.
    pub(super) fn missed(&self) -> Vec<Vec<f64>> {
        let mut missed = vec![vec![0.0_f64; self.elements.len()]; self.scene.band_count()];
        for Residual { element, flux } in &self.residuals {
            missed.iter_mut().zip(flux).for_each(|(missed, flux)| missed[*element] += flux);
        }
        for of_band in &mut missed {
            let of_elements = of_band.iter_mut().zip(&self.elements);
            of_elements.for_each(|(missed, element)| *missed = missed.abs() / element.area);
        }
        missed
    }

    /// Returns for each band the error of the direct flux onto an area that its nodes cause.
    pub(super) fn missed_of(&self, area: ReceivingArea) -> Vec<f64> {
        let mut sums = vec![[0.0; 2]; self.scene.band_count()];
        let is_on =
            |residual: &&Residual| area.contains(&self.transport.faces[self.elements[residual.element].face]);
        for Residual { flux, .. } in self.residuals.iter().filter(is_on) {
            for ([sum, squares], flux) in sums.iter_mut().zip(flux) {
                *sum += flux;
                *squares += flux * flux;
            }
        }
        sums.into_iter().map(|[sum, squares]: [f64; 2]| sum.abs() + SURE * squares.sqrt()).collect()
    }
}
