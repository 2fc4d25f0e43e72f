//! Net flux: the irradiance of faces becomes the power that they absorb less the power that they emit.
//!
//! ```text
//! Φ = A ((1 − ρ) E − M)          ρ = M = 0 on the black back of a one-sided surface
//! ```
//! The flux A E of a surface is all power that arrives. Net flux has no error of its own besides
//! rounding: it is accurate where the irradiance is. Surfaces whose reflectance depends on the
//! direction of light, metals and boundaries of media, have none.

use super::cells::mean_of_cells;
use super::error_budget::ErrorParts;
use super::quantity::Quantity;
use super::results::{Answer, Map, Simulation};
use crate::scene::{ReceiverKind, Scene, Shape, SurfaceSide};
use std::collections::HashMap;

/// The faces of all receivers of faces that have a net flux.
#[derive(Clone, Debug, Default)]
pub(crate) struct NetFlux {
    of_receivers: HashMap<String, Faces>,
}

/// The faces of a receiver.
#[derive(Clone, Debug)]
struct Faces {
    /// Their areas, in m².
    areas: Vec<f64>,
    /// For each band, the absorbed fraction of light and the exitance.
    bands: Vec<[f64; 2]>,
}

impl NetFlux {
    /// Returns the faces of the receivers of a scene.
    pub(crate) fn of(scene: &Scene) -> Self {
        let of_receiver = |receiver: &crate::scene::Receiver| {
            let ReceiverKind::Faces { surface, side } = receiver.kind else { return None };
            Some((receiver.name.clone(), Faces::of(scene, surface, side)?))
        };
        Self { of_receivers: scene.receivers.iter().filter_map(of_receiver).collect() }
    }

    /// Adds the net flux of each face and of all faces of each receiver.
    pub(crate) fn add_to(&self, simulation: &mut Simulation) {
        if self.of_receivers.is_empty() {
            return;
        }
        let mut answers = Vec::with_capacity(simulation.answers.len());
        for own in simulation.answers.chunk_by(|a, b| a.receiver == b.receiver) {
            answers.extend_from_slice(own);
            let means = own.iter().filter(|answer| answer.quantity == Quantity::Irradiance);
            let faces = own.first().and_then(|answer| self.of_receivers.get(&answer.receiver));
            answers.extend(faces.into_iter().flat_map(|faces| means.clone().map(|mean| faces.total(mean))));
        }
        simulation.answers = answers;
        let mut maps = Vec::with_capacity(simulation.maps.len());
        for map in std::mem::take(&mut simulation.maps) {
            let faces = self.of_receivers.get(&map.receiver);
            let net = faces.filter(|_| map.quantity == Quantity::Irradiance).map(|faces| faces.map(&map));
            maps.push(map);
            maps.extend(net);
        }
        simulation.maps = maps;
    }
}

impl Faces {
    fn of(scene: &Scene, surface: usize, side: SurfaceSide) -> Option<Self> {
        let square_metres = scene.unit.metres() * scene.unit.metres();
        let surface = &scene.surfaces[surface];
        let areas: Vec<f64> = match &surface.shape {
            Shape::Polygon(polygon) => vec![square_metres * polygon.area()],
            Shape::Mesh(mesh) => mesh.polygons().map(|polygon| square_metres * polygon.area()).collect(),
            _ => return None,
        };
        let is_black = side == SurfaceSide::Back && !surface.two_sided;
        if surface.texture.is_some() {
            return None;
        }
        let of_band = |band: usize| {
            let reflectance = scene.materials[surface.material].kind.reflectance_in(band)?;
            let exitance = surface.exitance_in(band);
            Some(if is_black { [1.0, 0.0] } else { [1.0 - reflectance, exitance] })
        };
        let bands = (0..scene.band_count()).map(of_band).collect::<Option<_>>()?;
        Some(Self { areas, bands })
    }

    /// Returns the net flux of an area with this irradiance, and the rounding error of the
    /// difference.
    fn net(&self, area: f64, irradiance: f64, band: usize) -> [f64; 2] {
        let [absorbed, exitance] = self.bands[band];
        let rounding = 4.0 * f64::EPSILON * area * (absorbed * irradiance.abs() + exitance);
        [area * (absorbed * irradiance - exitance), rounding]
    }

    /// Returns the net flux of all faces, given their mean irradiance.
    fn total(&self, mean: &Answer) -> Answer {
        let (band, area) = (mean.band.unwrap_or(0), self.areas.iter().sum::<f64>());
        let [value, lost] = self.net(area, mean.value, band);
        let parts = mean.parts.scaled(area * self.bands[band][0]);
        let parts = parts + ErrorParts { rounding: lost, ..ErrorParts::default() };
        let place = (mean.receiver.as_str(), Quantity::NetFlux, mean.band);
        let answer = mean_of_cells(place, &[(value, parts)], mean.kind, 1.0);
        Answer { seconds: mean.seconds, ..answer }
    }

    /// Returns the net flux of each face, given its irradiance.
    fn map(&self, irradiance: &Map) -> Map {
        let mut net = Map { quantity: Quantity::NetFlux, ..irradiance.clone() };
        for (band, (values, errors)) in net.values.iter_mut().zip(&mut net.errors).enumerate() {
            for ((value, error), area) in values.iter_mut().zip(errors).zip(&self.areas) {
                let [flux, lost] = self.net(*area, *value, band);
                (*value, *error) = (flux, area * self.bands[band][0] * *error + lost);
            }
        }
        net
    }
}
