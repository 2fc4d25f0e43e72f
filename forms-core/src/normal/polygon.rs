//! Sines and cosines of rational multiples of π, as algebraic numbers.
//!
//! p/q is split into partial fractions over the prime powers in q, and e^{iπp/q} into a product of
//! powers of
//!
//! ```text
//! e^{iπ/2ᵃ}: halving from e^{iπ/2} = i      e^{iπ/3} = (1 + i√3)/2      e^{iπ/10} = (√(10 + 2√5) + i(√5 − 1))/4
//! ```
//! The corners of polygons that can be constructed by few square roots are therefore polynomials in
//! these, and all radicands are manifestly positive. For any other prime power q the chord
//! δ = 2 cos(2π/q) is a generator, bound by its minimal polynomial, and 2 sin(2π/q) is another (see
//! [`super::chord`]).

use super::angle::Point;
use super::fraction::Fraction;
use super::generator::{Generator, Quantity};
use super::obstacle::{Obstacle, OutsidePart};
use super::tower::Tower;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};

/// Largest number of times π is halved.
const MOST_HALVINGS: u32 = 6;

/// Largest odd prime power in a polygon's number of sides.
const LARGEST_ODD_PART: u32 = 31;

impl Tower {
    /// Whether a quantity is π.
    pub(super) fn is_pi(&self, quantity: &Quantity) -> bool {
        quantity.as_variable().is_some_and(|variable| *self.generator(variable) == Generator::Pi)
    }

    /// (cos πr, sin πr)
    pub(super) fn corner(&mut self, r: &Rational) -> Result<Point, Obstacle> {
        let outside = || Obstacle::Outside(OutsidePart::HalfTurns(r.clone()));
        let sides = r.denom().to_u32().ok_or_else(outside)?;
        let parts = prime_powers(sides).ok_or_else(outside)?;
        let mut rest = r.clone();
        let mut point = (Fraction::one(), Fraction::zero());
        for part in parts {
            let share = share_of(r, part);
            rest -= Rational::new(share.into(), part.into());
            let corner = self.corner_of_part(part, share)?;
            point = self.angle_sum(&point, &corner)?;
        }
        // the remainder is a whole number of half turns
        if rest.to_integer().is_odd() {
            point = (self.negate(&point.0), self.negate(&point.1));
        }
        Ok(point)
    }

    /// e^{iπ share/part} for a prime power.
    fn corner_of_part(&mut self, part: u32, share: u32) -> Result<Point, Obstacle> {
        let (first, times) = match part {
            3 => {
                let height = self.square_root_of(3)?;
                ((ratio(1, 2), self.multiply(&ratio(1, 2), &height)?), share)
            }
            5 => (self.tenth()?, 2 * share),
            _ if part.is_power_of_two() => (self.halved_turn(part.trailing_zeros())?, share),
            _ => return self.corner_by_chord(part, share),
        };
        self.repeated(&first, times)
    }

    /// e^{iπ/2ⁿ}, by halving π: cos(α/2) = √(2 + 2 cos α)/2, sin(α/2) = sin α/(2 cos(α/2)), where
    /// 2 cos α is a root of a sum of roots.
    fn halved_turn(&mut self, halvings: u32) -> Result<Point, Obstacle> {
        let (mut cosine, mut sine) = match halvings {
            0 => return Ok((ratio(-1, 1), Fraction::zero())),
            _ => (Fraction::zero(), Fraction::one()),
        };
        for _ in 1..halvings {
            let twice = self.add(&cosine, &cosine)?;
            let radicand = self.add(&ratio(2, 1), &twice)?;
            let chord = self.magnitude_power(&radicand, Ratio::new(1, 2))?.0;
            let inverse = self.inverse(&chord)?;
            sine = self.multiply(&sine, &inverse)?;
            cosine = self.multiply(&ratio(1, 2), &chord)?;
        }
        Ok((cosine, sine))
    }

    /// e^{iπ/10} = (√(10 + 2√5) + i(√5 − 1))/4
    fn tenth(&mut self) -> Result<Point, Obstacle> {
        let root = self.square_root_of(5)?;
        let twice = self.add(&root, &root)?;
        let radicand = self.add(&ratio(10, 1), &twice)?;
        let outer = self.magnitude_power(&radicand, Ratio::new(1, 2))?.0;
        let inner = self.subtract(&root, &Fraction::one())?;
        Ok((self.multiply(&ratio(1, 4), &outer)?, self.multiply(&ratio(1, 4), &inner)?))
    }

    fn square_root_of(&mut self, number: i64) -> Result<Fraction, Obstacle> {
        Ok(self.magnitude_power(&ratio(number, 1), Ratio::new(1, 2))?.0)
    }

    /// Whether a polynomial is a sum of positive terms in squares and in inherently positive
    /// generators, so that it is nowhere negative.
    pub(crate) fn is_manifestly_not_negative(&self, polynomial: &Polynomial) -> bool {
        let positive = |&(variable, exponent): &(u32, u32)| {
            exponent % 2 == 0
                || matches!(
                    self.generator(variable),
                    Generator::Pi
                        | Generator::Root { .. }
                        | Generator::Exponential(_)
                        | Generator::Chord { .. }
                )
        };
        polynomial.terms().all(|(monomial, c)| c.is_positive() && monomial.iter().all(positive))
    }
}

pub(super) fn ratio(p: i64, q: i64) -> Fraction {
    Fraction::number(&Rational::new(p.into(), q.into()))
}

/// Returns the numerator k of r's partial fraction k/part: r = k/part + a number whose denominator
/// is coprime to `part`.
fn share_of(r: &Rational, part: u32) -> u32 {
    let part = BigInt::from(part);
    let cofactor = r.denom() / &part;
    let inverse = cofactor.extended_gcd(&part).x;
    (r.numer() * inverse).mod_floor(&part).to_u32().unwrap_or(0)
}

/// Returns the prime powers whose product is the number, if each is small.
fn prime_powers(number: u32) -> Option<Vec<u32>> {
    let halvings = number.trailing_zeros();
    let mut rest = number >> halvings;
    let mut parts = if halvings > 0 { vec![1 << halvings] } else { vec![] };
    for prime in (3..=LARGEST_ODD_PART).step_by(2) {
        let mut part = 1;
        while rest.is_multiple_of(prime) {
            rest /= prime;
            part *= prime;
        }
        if part > LARGEST_ODD_PART {
            return None;
        }
        parts.extend((part > 1).then_some(part));
    }
    (rest == 1 && halvings <= MOST_HALVINGS).then_some(parts)
}
