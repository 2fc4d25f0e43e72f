//! Sines and cosines of rational combinations of quantities.
//!
//! An argument Σ qₖ mₖ with rational qₖ is written in units uₖ = mₖ/dₖ, so that every sine and
//! cosine in one comparison is a polynomial in the functions of integer multiples of the same
//! units.

use super::fraction::Fraction;
use super::generator::{Generator, Quantity, Trigonometry, Unit};
use super::obstacle::{Obstacle, OutsidePart};
use super::power::FactorPower;
use super::tower::Tower;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// Largest multiple of one unit, and largest divisor of a unit, that are expanded.
const LARGEST_MULTIPLE: u32 = 48;

/// Largest number of parts of an angle that is expanded: each part doubles the number of terms of
/// its sine.
const MOST_PARTS: usize = 10;

/// cos and sin of one angle.
pub(super) type Point = (Fraction, Fraction);

impl Tower {
    /// Returns the quantities that an element is a rational combination of, with their
    /// coefficients.
    pub(crate) fn linear_parts(
        &mut self,
        argument: &Fraction,
    ) -> Result<Vec<(Quantity, Rational)>, Obstacle> {
        let argument = self.expanded(argument)?;
        Ok(argument
            .numerator
            .terms()
            .map(|(monomial, coefficient)| {
                let quantity = Quantity { monomial, factors: argument.factors.clone() };
                (quantity, Rational::new(coefficient, argument.divisor.clone()))
            })
            .collect())
    }

    /// Expresses q · quantity as a multiple of a unit. A finer unit restarts the normalisation.
    fn multiple(&mut self, quantity: &Quantity, coefficient: &Rational) -> Result<(Unit, i64), Obstacle> {
        let outside = || Obstacle::Outside(OutsidePart::AngleOrExponent(coefficient.clone()));
        let needed = coefficient.denom().to_u32().filter(|d| *d <= LARGEST_MULTIPLE).ok_or_else(outside)?;
        let divisor = *self.denominators.of_angles.entry(quantity.clone()).or_insert(needed);
        if !divisor.is_multiple_of(needed) {
            let finer = divisor.lcm(&needed);
            if finer > LARGEST_MULTIPLE {
                return Err(outside());
            }
            self.denominators.of_angles.insert(quantity.clone(), finer);
            return Err(Obstacle::Refine);
        }
        let multiple = coefficient * Rational::from_integer(divisor.into());
        let multiple = multiple.to_integer().to_i64().ok_or_else(outside)?;
        if multiple.unsigned_abs() > u64::from(LARGEST_MULTIPLE) {
            return Err(outside());
        }
        Ok((Unit { quantity: quantity.clone(), divisor }, multiple))
    }

    /// (cos q, sin q)
    pub(super) fn circular(&mut self, argument: &Fraction) -> Result<Point, Obstacle> {
        if argument.numerator.term_count() > MOST_PARTS {
            return Err(Obstacle::Outside(OutsidePart::AngleParts(MOST_PARTS)));
        }
        let mut point = (Fraction::one(), Fraction::zero());
        for (quantity, coefficient) in self.linear_parts(argument)? {
            let next = if self.is_pi(&quantity) {
                self.corner(&coefficient)?
            } else if let Some(arc) = self.arc_of(&quantity) {
                self.multiple_of_arc(arc, &coefficient)?
            } else {
                let (unit, multiple) = self.multiple(&quantity, &coefficient)?;
                self.multiple_angle(unit, multiple)?
            };
            point = self.angle_sum(&point, &next)?;
        }
        Ok(point)
    }

    /// cos(a + b) = cos a cos b − sin a sin b, sin(a + b) = sin a cos b + cos a sin b
    pub(super) fn angle_sum(&mut self, a: &Point, b: &Point) -> Result<Point, Obstacle> {
        let (cc, ss) = (self.multiply(&a.0, &b.0)?, self.multiply(&a.1, &b.1)?);
        let (sc, cs) = (self.multiply(&a.1, &b.0)?, self.multiply(&a.0, &b.1)?);
        Ok((self.subtract(&cc, &ss)?, self.add(&sc, &cs)?))
    }

    /// e^(imu) as a polynomial in c, s or as (1 + it)²ᵐ/(1 + t²)ᵐ.
    fn multiple_angle(&mut self, unit: Unit, multiple: i64) -> Result<Point, Obstacle> {
        let times = multiple.unsigned_abs() as u32;
        let (cosine, sine) = match self.trigonometry {
            Trigonometry::Circle => self.circle_multiple(unit, times)?,
            Trigonometry::HalfAngle => self.half_angle_multiple(unit, times)?,
        };
        let sine = if multiple < 0 { self.negate(&sine) } else { sine };
        Ok((cosine, sine))
    }

    fn circle_multiple(&mut self, unit: Unit, times: u32) -> Result<Point, Obstacle> {
        let c = self.variable_of(Generator::Cosine(unit.clone()));
        let s = self.variable_of(Generator::Sine(unit));
        let c_squared = Polynomial::variable(c).square();
        self.bind(s, 2, Polynomial::one().sub(&c_squared));
        let (re, im) = complex_power(&Polynomial::variable(c), &Polynomial::variable(s), times);
        Ok((self.reduce(re)?.into(), self.reduce(im)?.into()))
    }

    fn half_angle_multiple(&mut self, unit: Unit, times: u32) -> Result<Point, Obstacle> {
        if self.is_at_half_turn(&unit)? {
            let cosine = Polynomial::integer(if times.is_even() { 1 } else { -1 });
            return Ok((cosine.into(), Fraction::zero()));
        }
        let t = Polynomial::variable(self.variable_of(Generator::HalfTangent(unit)));
        let (re, im) = complex_power(&Polynomial::one(), &t, 2 * times);
        let norm = self.factor(Polynomial::one().add(&t.square()));
        let over = |numerator: Polynomial| {
            self.cancel(numerator, 1.into(), vec![FactorPower { factor: norm, exponent: times as i32 }])
        };
        Ok((over(re), over(im)))
    }
}

/// Returns the real and imaginary part of (x + iy)ⁿ.
fn complex_power(x: &Polynomial, y: &Polynomial, n: u32) -> (Polynomial, Polynomial) {
    let (mut re, mut im) = (Polynomial::one(), Polynomial::zero());
    for _ in 0..n {
        (re, im) = (re.mul(x).sub(&im.mul(y)), re.mul(y).add(&im.mul(x)));
    }
    (re, im)
}
