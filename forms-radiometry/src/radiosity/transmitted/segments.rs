//! Segments: the light of a point light that a segment of a ray scatters once to the start of the
//! ray. It becomes a sum over the points of a quadrature rule, with an error bound that is known
//! before any value is.
//!
//! ```text
//! ∫ σₛ p(cos θ) e^(−σ (t + r)) I/r² dt,  r² = h² + (t − s)²,  cos θ = (s − t)/r
//! ```
//! Where the ray is abreast of the light, h is their distance and s the distance along the ray.
//!
//! The bound is that of [`triangles`](super::triangles), for an ellipse about the segment: there
//! Re r² ≥ A, and the cosine differs from a real one by no more than the imaginary part of t times
//! h²/A^(3/2), so that 1 + g² − 2 g cos θ stays away from 0.
//!
//! Sources: S. Chandrasekhar, Radiative transfer (1950), chapter 1; for the bound, L. N. Trefethen
//! (2008), theorem 4.5.

use super::halving::{Part, Piece, halved};
use super::{OF_HEIGHT, Reached, gauss_error, rounding, transmittance};
use crate::form_factor::gauss;
use crate::geometry::Vector;
use crate::scene::Medium;
use forms_kernels::henyey_greenstein::unguarded as henyey_greenstein;
use forms_kernels::measure_area_to_solid_angle;
use std::f64::consts::PI;

/// Number of points of the rule.
const POINTS: usize = 16;
/// Sums of the half axes of the ellipses.
const ELLIPSES: [f64; 9] = [1.2, 1.5, 2.0, 3.0, 4.0, 6.0, 9.0, 14.0, 24.0];
/// Rounding of a cosine, where 1 + g² − 2 g cos θ can be as small as (1 − |g|)².
const OF_COSINE: f64 = 16.0;

/// The position at which a ray is abreast of a point light, and the distance of the light from it.
#[derive(Clone, Copy)]
pub(super) struct Lit<'l> {
    pub(super) abreast: f64,
    pub(super) height: f64,
    /// The distance of the light from the start of the ray.
    pub(super) reach: f64,
    pub(super) intensity: &'l [f64],
}

/// A segment of a ray, from one distance to another.
#[derive(Clone, Copy)]
pub(super) struct Segment<'l> {
    pub(super) lit: Lit<'l>,
    pub(super) ends: [f64; 2],
}

impl<'l> Lit<'l> {
    pub(super) fn of([origin, direction]: [Vector; 2], position: Vector, intensity: &'l [f64]) -> Self {
        let way = position - origin;
        let abreast = way.dot(direction);
        Self { abreast, height: (way - abreast * direction).length(), reach: way.length(), intensity }
    }

    /// Returns the distance of the light from a point of the ray.
    fn distance(&self, along: f64) -> f64 {
        self.height.hypot(along - self.abreast)
    }
}

impl Piece for Segment<'_> {
    fn halves(&self) -> [Self; 2] {
        let [from, to] = self.ends;
        let middle = 0.5 * (from + to);
        [[from, middle], [middle, to]].map(|ends| Self { ends, ..*self })
    }
}

/// Returns the light that all segments scatter to the start of the ray in each band.
pub(super) fn scattered(
    segments: Vec<Segment<'_>>,
    medium: &Medium,
    extinction: &[f64],
    goal: f64,
) -> Vec<Reached> {
    halved(segments, (1, extinction), goal, |segment| part(segment, medium, extinction))
}

fn part<'l>(segment: Segment<'l>, medium: &Medium, extinction: &[f64]) -> Part<Segment<'l>> {
    let mut part = Part { piece: segment, values: Vec::new(), errors: Vec::new(), rounding: Vec::new() };
    for (band, &extinction) in extinction.iter().enumerate() {
        let (scattering, asymmetry) = (medium.scattering[band], medium.asymmetry[band]);
        let factor = scattering * segment.lit.intensity[band];
        let (most, error) = if factor > 0.0 {
            (segment.most(extinction, asymmetry), segment.error(extinction, asymmetry))
        } else {
            (0.0, 0.0)
        };
        let is_found = error < most;
        part.values.push(if is_found { factor * segment.integral(extinction, asymmetry) } else { 0.0 });
        part.errors.push(if factor > 0.0 { factor * if is_found { error } else { most } } else { 0.0 });
        part.rounding.push(if factor > 0.0 {
            factor * most * segment.lost(extinction, asymmetry)
        } else {
            0.0
        });
    }
    part
}

impl Segment<'_> {
    /// Returns the integral by the rule, for a scattering coefficient and an intensity of 1.
    fn integral(&self, extinction: f64, asymmetry: f64) -> f64 {
        let [from, to] = self.ends;
        let value = |&[at, weight]: &[f64; 2]| {
            let along = from + at * (to - from);
            let distance = self.lit.distance(along);
            let phase =
                henyey_greenstein(asymmetry, ((self.lit.abreast - along) / distance).clamp(-1.0, 1.0));
            let arriving = measure_area_to_solid_angle(distance * distance, 1.0);
            weight * phase * arriving * transmittance(extinction, along + distance)
        };
        (to - from) * gauss(POINTS).iter().map(value).sum::<f64>()
    }

    /// Returns the least distance of the light.
    fn nearest(&self) -> f64 {
        let [from, to] = self.ends;
        self.lit.distance(self.lit.abreast.clamp(from, to))
    }

    /// Returns an upper bound on the integral, for a scattering coefficient and an intensity of 1:
    /// ∫ dt/r² is at most the length over r², and at most π/h.
    fn most(&self, extinction: f64, asymmetry: f64) -> f64 {
        let [from, to] = self.ends;
        let nearest = self.nearest();
        let seen = ((to - from) / nearest / nearest).min(PI / self.lit.height);
        phase(asymmetry, self.least_square(asymmetry, self.ends))
            * seen
            * transmittance(extinction, from + nearest)
    }

    /// Returns the least 1 + g² − 2 g cos θ between two distances along the ray: the cosine falls
    /// from one to the other.
    fn least_square(&self, asymmetry: f64, ends: [f64; 2]) -> f64 {
        let along = if asymmetry > 0.0 { ends[0] } else { ends[1] };
        let distance = self.lit.distance(along);
        let cosine = if distance > 0.0 { (self.lit.abreast - along) / distance } else { asymmetry.signum() };
        1.0 + asymmetry * (asymmetry - 2.0 * cosine.clamp(-1.0, 1.0))
    }

    /// Returns the least error bound of the rule, for a scattering coefficient and an intensity of
    /// 1.
    fn error(&self, extinction: f64, asymmetry: f64) -> f64 {
        ELLIPSES.iter().map(|&rho| self.error_in(rho, [extinction, asymmetry])).fold(f64::INFINITY, f64::min)
    }

    /// Returns the error bound of the rule from one ellipse. With its half axes α and β and the
    /// half length a: Re t ≥ from − a (α − 1), |Im t| ≤ a β, and Re √z ≥ √(Re z).
    fn error_in(&self, rho: f64, [extinction, asymmetry]: [f64; 2]) -> f64 {
        let [from, to] = self.ends;
        let [alpha, beta] = [0.5 * (rho + 1.0 / rho), 0.5 * (rho - 1.0 / rho)];
        let half = 0.5 * (to - from);
        let [beyond, across] = [half * (alpha - 1.0), half * beta];
        let ends = [from - beyond, to + beyond];
        let near = Self { ends, ..*self }.nearest();
        if near <= across {
            return f64::INFINITY;
        }
        let squared = (near - across) * (near + across);
        let distance = squared.sqrt();
        let turned = across * (self.lit.height / distance).powi(2) / distance;
        let square = self.least_square(asymmetry, ends) - 2.0 * asymmetry.abs() * turned;
        if square <= 0.0 {
            return f64::INFINITY;
        }
        // the start of the ray can lie within the ellipse, where the exponential is above 1
        let left = (-extinction * (ends[0] + distance)).exp();
        let of_rule = gauss_error(rho, POINTS);
        half * of_rule * phase(asymmetry, square) * left / squared
    }

    /// Returns the rounding error of the integral, relative to its upper bound.
    fn lost(&self, extinction: f64, asymmetry: f64) -> f64 {
        let [_, to] = self.ends;
        rounding(extinction, to + self.lit.distance(to).max(self.nearest()))
            + OF_HEIGHT * f64::EPSILON * (self.lit.reach / self.nearest()).max(1.0)
            + OF_COSINE * f64::EPSILON / (1.0 - asymmetry.abs()).powi(2)
    }
}

/// Returns the phase function at this value of 1 + g² − 2 g cos θ.
fn phase(asymmetry: f64, square: f64) -> f64 {
    (1.0 - asymmetry * asymmetry) / (4.0 * PI * square * square.sqrt())
}
