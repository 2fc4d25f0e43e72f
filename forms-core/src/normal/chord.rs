//! Chords: 2 cos(2π/q) and 2 sin(2π/q) of a regular polygon with q = pᵏ sides, p odd.
//!
//! With Cₙ(2 cos α) = 2 cos nα, C₀ = 2, C₁ = x, Cₙ₊₁ = x Cₙ − Cₙ₋₁, the chord δ = 2 cos(2π/q) is a
//! root of
//!
//! ```text
//! Ψ_p = 1 + C₁ + C₂ + … + C_{(p−1)/2},      Ψ_q = Ψ_p(C_{q/p}),
//! ```
//! which is irreducible over ℚ and has the leading coefficient 1. The sine comes from σ² = 4 − δ²
//! for a prime p, and from sin α = sin pα/(1 + C₂ + C₄ + … + C_{p−1}) for a higher power. (Watkins
//! and Zeitlin, The minimal polynomial of cos(2π/n), American Mathematical Monthly 100, 1993.)

use super::angle::Point;
use super::fraction::Fraction;
use super::generator::Generator;
use super::obstacle::Obstacle;
use super::polygon::ratio;
use super::tower::Tower;
use crate::enclosure::{Enclosure, Precision};
use crate::expression::Rational;
use crate::polynomial::Polynomial;

/// Precision, in bits, of the enclosure of a chord.
const PRECISION: Precision = Precision(48);

/// Returns a lower and an upper bound of a chord.
pub(crate) fn chord_bounds(sides: u32, sine: bool) -> (Rational, Rational) {
    let turn = Enclosure::exact(&Rational::new(2.into(), sides.into()), PRECISION);
    let angle = turn.mul(&Enclosure::pi(PRECISION));
    let half = if sine { angle.sin() } else { angle.cos() };
    let chord = half.mul(&Enclosure::integer(2, PRECISION));
    (chord.lower(), chord.upper())
}

impl Tower {
    /// e^{iπ share/q}: a power of e^{2πi/q}, since e^{iπ} = −1 makes the share even.
    pub(super) fn corner_by_chord(&mut self, q: u32, share: u32) -> Result<Point, Obstacle> {
        let first = self.first_corner(q)?;
        let is_even = share.is_multiple_of(2);
        let turns = if is_even { share } else { share + q } / 2;
        let point = self.repeated(&first, turns)?;
        Ok(if is_even { point } else { (self.negate(&point.0), self.negate(&point.1)) })
    }

    /// e^{2πi/q}
    fn first_corner(&mut self, q: u32) -> Result<Point, Obstacle> {
        let prime = least_prime_factor(q);
        let chord = self.variable_of(Generator::Chord { sides: q, sine: false });
        let delta = Polynomial::variable(chord);
        let minimal = dirichlet_sum(prime, 1, &multiple(&delta, q / prime));
        let order = minimal.degree(chord);
        let leading = delta.pow(order);
        self.bind(chord, order, leading.sub(&minimal));
        let cosine = self.multiply(&ratio(1, 2), &delta.clone().into())?;
        if q == prime {
            let height = self.variable_of(Generator::Chord { sides: q, sine: true });
            self.bind(height, 2, Polynomial::integer(4).sub(&delta.square()));
            let sine = self.multiply(&ratio(1, 2), &Polynomial::variable(height).into())?;
            return Ok((cosine, sine));
        }
        let coarser = self.corner(&Rational::new(2.into(), (q / prime).into()))?.1;
        let slope = self.reduce(dirichlet_sum(prime, 2, &delta))?;
        let inverse = self.inverse(&Fraction::from(slope))?;
        Ok((cosine, self.multiply(&coarser, &inverse)?))
    }
}

/// 1 + C_s + C_2s + … with (p − 1)/2 terms after the first, at x.
fn dirichlet_sum(prime: u32, step: u32, x: &Polynomial) -> Polynomial {
    let terms = 1..=(prime - 1) / 2;
    terms.fold(Polynomial::one(), |sum, term| sum.add(&multiple(x, step * term)))
}

/// Cₙ(x)
fn multiple(x: &Polynomial, n: u32) -> Polynomial {
    let (mut before, mut last) = (Polynomial::integer(2), x.clone());
    if n == 0 {
        return before;
    }
    for _ in 1..n {
        (before, last) = (last.clone(), x.mul(&last).sub(&before));
    }
    last
}

fn least_prime_factor(number: u32) -> u32 {
    (2..=number).find(|factor| number.is_multiple_of(*factor)).unwrap_or(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_minimal_polynomials_are_the_known_ones() {
        let x = Polynomial::variable(0);
        let of = |coefficients: &[i64]| {
            coefficients
                .iter()
                .rev()
                .fold(Polynomial::zero(), |sum, &c| sum.mul(&x).add(&Polynomial::integer(c)))
        };
        // x³ + x² − 2x − 1 and x³ − 3x + 1
        assert_eq!(dirichlet_sum(7, 1, &x), of(&[-1, -2, 1, 1]));
        assert_eq!(dirichlet_sum(3, 1, &multiple(&x, 3)), of(&[1, -3, 0, 1]));
        assert_eq!(dirichlet_sum(11, 1, &x), of(&[1, 3, -3, -4, 1, 1]));
    }

    #[test]
    fn a_chord_is_a_root_of_its_minimal_polynomial() {
        let x = Polynomial::variable(0);
        for q in [7, 9, 11, 13, 25, 27, 29, 31] {
            let prime = least_prime_factor(q);
            let minimal = dirichlet_sum(prime, 1, &multiple(&x, q / prime));
            let (lower, upper) = chord_bounds(q, false);
            let at = |value: &Rational| {
                let one = |c: &num_bigint::BigInt| Rational::from_integer(c.clone());
                minimal.evaluate_with(one, |_| value.clone())
            };
            let zero = Rational::from_integer(0.into());
            assert!((at(&lower) <= zero) != (at(&upper) <= zero), "{q}");
        }
    }
}
