//! Convergence: predicts, from the difference between an element and the element that it was split
//! from, how much its own parts will differ from it in each coordinate.
//!
//! ```text
//! highest terms of the polynomials, h on a part of the size r and H on the whole:   h/H = r^q
//! smooth light:          q = n − 1 with n nodes along a side; the next change is r^n of the last
//!                        one, its mean r^2n
//! light like xᵝ, a jump: q = β, 0; the next change is r^q of the last one, and so is its mean
//! ```
//! The mean of a change is the difference in the light that an element sends out. With Gauss nodes
//! it converges twice as fast as the change itself, where light is smooth.

use super::element::Element;
use super::reference::Shape;

/// Smallest and largest expected ratio between the next change of an element and its last one, and
/// the ratio that is assumed where nothing is known.
const EXPECTED: [f64; 2] = [1.0 / 64.0, 1.0];
const UNKNOWN: f64 = 0.5;
/// Growth of the highest term of a polynomial that indicates light which had not reached the
/// element before.
const GROWN: f64 = 4.0;
/// Largest ratio of successive changes in the sum of all future changes: the area of the elements
/// that contain a jump halves with each split, and so does their effect.
const SLOWEST: f64 = 0.7;

/// Difference between an element and the element that it was split from, in one coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Change {
    /// Measured difference, relative to the largest irradiance.
    measured: f64,
    /// Expected difference between the element and its own parts.
    pub(crate) expected: f64,
    /// Highest term of the polynomial when the difference was measured, relative to the largest
    /// irradiance.
    term: f64,
}

impl Change {
    /// Returns the change of an element before it is split.
    pub(crate) fn unknown(expected: f64, term: f64) -> Self {
        Self { measured: f64::INFINITY, expected, term }
    }

    /// Whether light has reached the element since, so that the measured change is no longer valid;
    /// judged by its current polynomial.
    pub(crate) fn is_outgrown_by(self, now: Self) -> bool {
        now.term > GROWN * self.term
    }

    /// Returns the sum of all future changes, if each is the same fraction of the one before.
    pub(crate) fn remaining(self) -> f64 {
        let part = if self.measured.is_finite() { self.expected / self.measured } else { UNKNOWN };
        if self.expected > 0.0 { self.expected / (1.0 - part.min(SLOWEST)) } else { 0.0 }
    }

    /// Returns the change of a part of a split element. The expected next change is at least the
    /// one extrapolated from the last two.
    pub(crate) fn followed_by(self, measured: f64, expected: f64, term: f64) -> Self {
        let settled = measured / self.measured;
        let by_last = if settled.is_finite() { settled.min(EXPECTED[1]) * measured } else { 0.0 };
        Self { measured, expected: expected.max(by_last), term }
    }
}

/// Returns the factors by which the mean of a change, and its size, shrink from an element to a
/// part of it, in each coordinate, from the highest terms of their polynomials.
pub(crate) fn decay(whole: &Element, part: &Element, highest: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    let of = |coordinate: usize| {
        let size = match whole.shape {
            Shape::Triangle => 0.5,
            Shape::Square => part.extent()[coordinate] / whole.extent()[coordinate],
        };
        let ratio = highest[1][coordinate] / highest[0][coordinate];
        if !ratio.is_finite() {
            return [if highest[1][coordinate] == 0.0 { EXPECTED[0] } else { EXPECTED[1] }; 2];
        }
        let (power, degree) = (ratio.ln() / size.ln(), whole.order as f64 - 1.0);
        // 1 where light is smooth, 0 where it is a power too low for polynomials to gain from a
        // higher degree
        let smooth = (power - (degree - 1.0)).clamp(0.0, 1.0);
        let of_size = ratio * size.powf(smooth);
        [of_size.powf(1.0 + smooth), of_size].map(|part| part.clamp(EXPECTED[0], EXPECTED[1]))
    };
    [of(0), of(1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;
    use crate::radiosity::contact::ConvexPiece;
    use crate::visibility::Face;

    fn unit_square() -> Element {
        let corner = |x, y| Vector::new(x, y, 0.0);
        let vertices = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        let face = Face {
            surface: 0,
            part: 0,
            is_back: false,
            vertices: vertices.into(),
            normal: Vector::new(0.0, 0.0, 1.0),
            area: 1.0,
        };
        Element::of(0, &face, &ConvexPiece::whole(&face)).swap_remove(0)
    }

    #[test]
    fn smooth_light_settles_by_its_degree_and_a_power_by_itself() {
        let whole = unit_square();
        let part = whole.divided([true, true]).swap_remove(0);
        for (name, ratio, [of_flux, of_size]) in [
            ("a cubic", 0.25, [1.0 / 64.0, 0.125]),
            ("a root", 0.5_f64.sqrt(), [0.5_f64.sqrt(); 2]),
            ("a jump", 1.0, [1.0, 1.0]),
            ("what grows", 3.0, [1.0, 1.0]),
            ("what vanishes", 0.0, [1.0 / 64.0; 2]),
        ] {
            let [along, across] = decay(&whole, &part, [[1.0; 2], [ratio; 2]]);
            let off = (along[0] - of_flux).abs().max((along[1] - of_size).abs());
            assert!(off < 1e-12 && along == across, "{name}: {along:?}");
        }
    }
}
