//! Sines and cosines of rational multiples of π, by square roots where regular polygons are constructible.
//!
//! p/q with q = 2ᵃ 3ᵇ 5ᶜ, b, c ≤ 1, is split into partial fractions, and e^{iπp/q} into the product of powers of
//!
//! ```text
//! e^{iπ/2ᵃ}: halving from e^{iπ/2} = i      e^{iπ/3} = (1 + i√3)/2      e^{iπ/10} = (√(10 + 2√5) + i(√5 − 1))/4
//! ```
//! so that every such number is a polynomial in few roots, all of manifestly positive radicands. A polygon whose
//! number of sides has another odd factor (7, 9, 11, …) is outside.

use super::angle::Point;
use super::fraction::Fraction;
use super::generator::{Generator, Quantity};
use super::tower::{Obstacle, Tower};
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};

/// π is halved at most this often.
const MOST_HALVINGS: u32 = 6;

impl Tower {
    /// Whether a quantity is π.
    pub(super) fn is_pi(&self, quantity: &Quantity) -> bool {
        quantity.as_variable().is_some_and(|variable| *self.generator(variable) == Generator::Pi)
    }

    /// (cos πr, sin πr)
    pub(super) fn corner(&mut self, r: &Rational) -> Result<Point, Obstacle> {
        let outside = || Obstacle::Outside(format!("an angle of {r} times pi"));
        let sides = r.denom().to_u32().ok_or_else(outside)?;
        let halvings = sides.trailing_zeros();
        let odd = sides >> halvings;
        if halvings > MOST_HALVINGS || !matches!(odd, 1 | 3 | 5 | 15) {
            return Err(outside());
        }
        let mut rest = r.clone();
        let mut point = (Fraction::one(), Fraction::zero());
        for part in [1 << halvings, 3, 5].into_iter().filter(|part| sides.is_multiple_of(*part)) {
            let share = share_of(r, part);
            rest -= Rational::new(share.into(), part.into());
            let corner = self.corner_of_part(part, share)?;
            point = self.angle_sum(&point, &corner)?;
        }
        // what is left is a whole number of half turns
        if rest.to_integer().is_odd() {
            point = (self.negate(&point.0), self.negate(&point.1));
        }
        Ok(point)
    }

    /// e^{iπ share/part} for a part that is 3, 5 or a power of two.
    fn corner_of_part(&mut self, part: u32, share: u32) -> Result<Point, Obstacle> {
        let (first, times) = match part {
            3 => {
                let height = self.square_root_of(3)?;
                ((ratio(1, 2), self.multiply(&ratio(1, 2), &height)?), share)
            }
            5 => (self.tenth()?, 2 * share),
            _ => (self.halved_turn(part.trailing_zeros())?, share),
        };
        self.repeated(&first, times)
    }

    /// e^{iπ/2ⁿ}, halving π: cos(α/2) = √(2 + 2 cos α)/2, sin(α/2) = sin α/(2 cos(α/2)), where 2 cos α is a root of
    /// a sum of roots.
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

    /// Whether a polynomial is a sum of positive terms in generators that are positive by their nature.
    pub(super) fn is_manifestly_positive(&self, polynomial: &Polynomial) -> bool {
        let positive = |&(variable, _): &(u32, u32)| {
            matches!(
                self.generator(variable),
                Generator::Pi | Generator::Root { .. } | Generator::Exponential(_)
            )
        };
        polynomial.terms().all(|(monomial, c)| c.is_positive() && monomial.iter().all(positive))
    }
}

fn ratio(p: i64, q: i64) -> Fraction {
    Fraction::number(&Rational::new(p.into(), q.into()))
}

/// The numerator k of r's partial fraction k/part: r = k/part + a number whose denominator is prime to it.
fn share_of(r: &Rational, part: u32) -> u32 {
    let part = BigInt::from(part);
    let cofactor = r.denom() / &part;
    let inverse = cofactor.extended_gcd(&part).x;
    (r.numer() * inverse).mod_floor(&part).to_u32().unwrap_or(0)
}
