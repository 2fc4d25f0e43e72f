//! Checks: what comes straight from faces and from outside to random points of elements, beside what their nodes make of it.
//!
//! ```text
//! the first elements ─▶ random points, more on larger ones ─▶ E of lights ─┐
//! nodes ─▶ polynomials of elements at these points ─▶ Eₙ ──────────────────┴─▶ r = E − Eₙ, anew for finer elements
//! what nodes miss of the flux of a surface   |Σ a r| + 2 √Σ (a r)²      a is the area that a point stands for
//! ```
//! Light that comes through a narrow opening falls between nodes that are far apart, and then these do not know of it. Points that are no nodes
//! find it if it covers so much of a surface as one of them stands for.

use super::element::Element;
use super::gather::{Group, Scratch};
use super::measure::Measure;
use super::system::Radiosity;
use crate::geometry::Vector;
use crate::kernels::gathered_light::Effects;
use crate::sampling::{Net, key};
use rayon::prelude::*;

/// Points on all elements together, where faces are few; and how many operations they may take where these are many.
const POINTS: f64 = 4096.0;
const OPERATIONS: f64 = 4e8;
/// Standard errors that a sum over points may be off by.
const SURE: f64 = 2.0;
/// The key of these points beside those of other numbers.
const KEY: u64 = 0x63_6865_636b;

/// What comes straight to a point.
pub(super) struct Check {
    face: usize,
    position: Vector,
    /// The area that it stands for.
    area: f64,
    /// In each band what comes from faces and from outside.
    straight: Vec<f64>,
}

/// By how much what comes straight to a point is more than nodes make of it.
#[derive(Clone, Debug)]
pub(super) struct Residual {
    element: usize,
    /// In each band, as a flux.
    flux: Vec<f64>,
}

impl Radiosity<'_> {
    /// Finds what comes straight to random points, where nodes are to tell of light that may be hidden from them.
    pub(super) fn check(&mut self) {
        let Effects { luminaires, surroundings, .. } = self.lights.kinds();
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

    /// What comes straight from faces and from outside to a place on a face, in each band.
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

    /// By how much that is more than nodes make of it, point by point.
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

    /// For each band by how much the mean irradiance of each element is more, or less, than that of its nodes.
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

    /// For each band what the nodes of a surface miss of the flux that comes straight to it.
    pub(super) fn missed_of(&self, surface: usize) -> Vec<f64> {
        let mut sums = vec![[0.0; 2]; self.scene.band_count()];
        let is_on = |residual: &&Residual| {
            self.transport.faces[self.elements[residual.element].face].is_front_of(surface)
        };
        for Residual { flux, .. } in self.residuals.iter().filter(is_on) {
            for ([sum, squares], flux) in sums.iter_mut().zip(flux) {
                *sum += flux;
                *squares += flux * flux;
            }
        }
        sums.into_iter().map(|[sum, squares]: [f64; 2]| sum.abs() + SURE * squares.sqrt()).collect()
    }
}
