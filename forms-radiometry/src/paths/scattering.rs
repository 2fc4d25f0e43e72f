//! Scattering along a ray: samples where light is scattered, and where singly scattered light from
//! light sources is evaluated.
//!
//! ```text
//! free flight     t with the density σ e^(−σ t); beyond the end of the segment light passes
//! within          a forced collision before that: t with the density σ e^(−σ t)/(1 − e^(−σ d))
//! lit point       t with half the density of free flight within the segment, and half the
//!                 equiangular density at a light source
//! ```
//! Bands have different extinctions: one of them, selected at random, gives the distance, and the
//! density is the mean over all bands.
//!
//! Source: C. Kulla, M. Fajardo, Importance sampling techniques for path tracing in participating
//! media (2012).

use super::optics::{MediumOptics, mean, scaled};
use super::vertex::one_of;
use super::warps::{equiangular_pdf, equiangular_sample, free_flight_pdf, free_flight_sample};
use crate::extinction::lost;
use crate::geometry::Vector;
use crate::sampling::Samples;

/// Optical thickness beyond which no light remains: e^−45 is 3e−20.
const OPAQUE: f64 = 45.0;
/// Minimum distance of a light source from a ray, relative to the length of the segment; below it
/// the equiangular density is not used.
const LEAST_HEIGHT: f64 = 1e-12;

/// Outcome of a flight through a medium.
pub(super) enum Flight<const N: usize> {
    /// Scattered at this distance, with this factor: scattering × transmittance / density.
    Scattered(f64, [f64; N]),
    /// Reached the end of the segment, with this factor.
    Passed([f64; N]),
    /// A forced collision that has probability zero.
    Nothing,
}

impl<const N: usize> MediumOptics<N> {
    /// Samples a free flight over a segment.
    pub(super) fn flight(&self, length: f64, count: usize, samples: &mut Samples) -> Flight<N> {
        let chosen = self.extinction[one_of(count, samples)];
        let number = samples.one();
        let distance = if chosen > 0.0 { free_flight_sample(chosen, number) } else { f64::INFINITY };
        if distance < length {
            return Flight::Scattered(distance, self.scattered(distance, count));
        }
        let left = self.transmittance(length);
        let chance = mean(&left, count);
        Flight::Passed(left.map(|left| left / chance))
    }

    /// Samples a forced collision within a segment. Its factor includes the fraction of all flights
    /// that are scattered there, 1 − e^(−σ d).
    pub(super) fn flight_within(&self, length: f64, count: usize, samples: &mut Samples) -> Flight<N> {
        let within = self.extinction.map(|extinction| lost(extinction, length));
        let part = mean(&within, count);
        if part == 0.0 {
            return Flight::Nothing;
        }
        let band = likely(&within[..count], samples);
        let distance = free_flight_sample(self.extinction[band], within[band] * samples.one()).min(length);
        Flight::Scattered(distance, scaled(part, &self.scattered(distance, count)))
    }

    /// Returns scattering times transmittance at a distance, over the density of free flight there.
    fn scattered(&self, distance: f64, count: usize) -> [f64; N] {
        let left = self.transmittance(distance);
        let densities: [f64; N] = std::array::from_fn(|band| self.extinction[band] * left[band]);
        let density = mean(&densities, count);
        std::array::from_fn(|band| self.scattering[band] * left[band] / density)
    }

    /// Samples a distance along a segment at which light from a point is evaluated. Returns with
    /// it, for each band, σₛ times the transmittance up to there, over the density. `pivot` is the
    /// assumed origin of the light, if it is not distant.
    pub(super) fn lit_point(
        &self,
        [origin, direction]: [Vector; 2],
        length: f64,
        pivot: Option<Vector>,
        count: usize,
        samples: &mut Samples,
    ) -> Option<(f64, [f64; N])> {
        let extinction = mean(&self.extinction, count);
        let thinnest = self.extinction[..count].iter().copied().fold(f64::INFINITY, f64::min);
        let length = length.min(OPAQUE / thinnest.max(f64::MIN_POSITIVE));
        if !length.is_finite() {
            return None;
        }
        let angle = pivot.and_then(|pivot| Angle::at(pivot, [origin, direction], length));
        // the number selects the distribution, and then a distance from it
        let number = samples.one();
        let within = lost(extinction, length);
        let flight = |number: f64| free_flight_sample(extinction, number * within);
        let distance = match &angle {
            None => flight(number),
            Some(angle) if number < 0.5 => angle.distance(2.0 * number),
            Some(_) => flight(2.0 * number - 1.0),
        };
        let distance = distance.clamp(0.0, length);
        let of_flight = free_flight_pdf(extinction, distance) / within;
        let density = angle.map_or(of_flight, |angle| 0.5 * (of_flight + angle.density(distance)));
        let left = self.transmittance(distance);
        let factor = std::array::from_fn(|band| self.scattering[band] * left[band] / density);
        (density > 0.0).then_some((distance, factor))
    }
}

/// Selects a band with a probability proportional to its part of the sum.
fn likely(parts: &[f64], samples: &mut Samples) -> usize {
    if parts.len() == 1 {
        return 0;
    }
    let mut along = samples.one() * parts.iter().sum::<f64>();
    let is_beyond = |part: &&f64| {
        along -= **part;
        along >= 0.0
    };
    let last = parts.iter().rposition(|&part| part > 0.0).unwrap_or(0);
    parts.iter().take_while(is_beyond).count().min(last)
}

/// Segment of a ray for equiangular sampling about a light source: distances are measured from the
/// foot of the perpendicular of length h from the light source to the ray.
struct Angle {
    height: f64,
    abreast: f64,
    length: f64,
}

impl Angle {
    fn at(pivot: Vector, [origin, direction]: [Vector; 2], length: f64) -> Option<Self> {
        let offset = pivot - origin;
        let abreast = offset.dot(direction);
        let height = (offset - abreast * direction).length();
        (height > LEAST_HEIGHT * length).then_some(Self { height, abreast, length })
    }

    fn ends(&self) -> [f64; 2] {
        [-self.abreast, self.length - self.abreast]
    }

    fn distance(&self, number: f64) -> f64 {
        let [from, to] = self.ends();
        self.abreast + equiangular_sample(self.height, from, to, number)
    }

    fn density(&self, distance: f64) -> f64 {
        let [from, to] = self.ends();
        equiangular_pdf(self.height, from, to, (distance - self.abreast).clamp(from, to))
    }
}
