//! Changes: how an element differs from the one that it was a part of becomes how much its own parts will differ from it, in each
//! coordinate.
//!
//! ```text
//! highest terms of the polynomials, h of a part of the size r and H of the whole:   h/H = r^q
//! light that is smooth:  q = n − 1 with n nodes along a side; the next change is r^n of the one before, its mean r^2n
//! light like xᵝ, a jump: q = β, 0;                            the next change is r^q of it, and so is its mean
//! ```
//! The mean of a change is what an element sends out differently. With Gauss nodes it settles twice as fast as the change itself, where
//! light is smooth.

use super::element::Element;
use super::reference::Shape;

/// The least and the largest part that is expected of an element's change when it is split once more, and the part that is
/// expected where nothing is known.
const EXPECTED: [f64; 2] = [1.0 / 64.0, 1.0];
const UNKNOWN: f64 = 0.5;
/// By how much the highest term of a polynomial grows where light has come to an element that was not there before.
const GROWN: f64 = 4.0;
/// The largest part that all changes to come are expected to leave: areas with a jump inside halve, and so does what they matter.
const SLOWEST: f64 = 0.7;

/// How an element differs from the one that it was a part of, in one coordinate.
#[derive(Clone, Copy, Debug)]
pub(super) struct Change {
    /// By how much, relative to the largest irradiance.
    measured: f64,
    /// By how much its own parts are expected to differ from it.
    pub(super) expected: f64,
    /// The highest term of its polynomial then, relative to the largest irradiance.
    term: f64,
}

impl Change {
    /// Before an element is split.
    pub(super) fn unknown(expected: f64, term: f64) -> Self {
        Self { measured: f64::INFINITY, expected, term }
    }

    /// Whether light has come to the element since, of which what was measured does not tell: as far as its polynomial now shows.
    pub(super) fn is_outgrown_by(self, now: Self) -> bool {
        now.term > GROWN * self.term
    }

    /// The sum of the changes that are to come, if each leaves the same part.
    pub(super) fn remaining(self) -> f64 {
        let part = if self.measured.is_finite() { self.expected / self.measured } else { UNKNOWN };
        if self.expected > 0.0 { self.expected / (1.0 - part.min(SLOWEST)) } else { 0.0 }
    }

    /// The change of a part of an element that was split, and what is expected next, but no less than the last two let expect.
    pub(super) fn followed_by(self, measured: f64, expected: f64, term: f64) -> Self {
        let settled = measured / self.measured;
        let by_last = if settled.is_finite() { settled.min(EXPECTED[1]) * measured } else { 0.0 };
        Self { measured, expected: expected.max(by_last), term }
    }
}

/// What the mean of a change, and its size, are multiplied by from an element to a part of it, in each coordinate, by the highest terms
/// of their polynomials.
pub(super) fn decay(whole: &Element, part: &Element, highest: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
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
        // 1 where light is smooth, 0 where it is a power too low for the polynomials to gain by their degree
        let smooth = (power - (degree - 1.0)).clamp(0.0, 1.0);
        let of_size = ratio * size.powf(smooth);
        [of_size.powf(1.0 + smooth), of_size].map(|part| part.clamp(EXPECTED[0], EXPECTED[1]))
    };
    [of(0), of(1)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Face, Vector};
    use crate::radiosity::contact::ConvexPiece;

    fn unit_square() -> Element {
        let corner = |x, y| Vector::new(x, y, 0.0);
        let vertices = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)];
        let face =
            Face { surface: 0, is_back: false, vertices, normal: Vector::new(0.0, 0.0, 1.0), area: 1.0 };
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
