//! Arcs: inverse trigonometric functions as angles of points, so that their sines and cosines
//! are algebraic.
//!
//! ```text
//! atan q = ∠(1, q)   asin q = ∠(√(1 − q²), q)   acos q = ∠(q, √(1 − q²))   atan2(y, x) = ∠(x, y)
//! ```
//! with ∠(x, y) the angle of the point (x, y) in (−π, π], whose cosine and sine are x/r and y/r,
//! r = √(x² + y²). Half of such an angle lies in (−π/2, π/2], where the cosine is not negative:
//! cos(α/2) = √((1 + cos α)/2).

use super::angle::Point;
use super::fraction::Fraction;
use super::generator::{Generator, Quantity};
use super::obstacle::{Obstacle, OutsidePart};
use super::tower::Tower;
use crate::expression::{Expr, Node, Operation, Pool, Rational};
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::Ratio;
use num_traits::{Signed, ToPrimitive};

/// Largest multiple of an arc that is expanded.
const LARGEST_MULTIPLE: u32 = 16;

/// Largest number of times an arc is halved.
const MOST_HALVINGS: u32 = 4;

/// Whether a function of the operation table is an angle.
pub(crate) fn is_arc(operation: Operation) -> bool {
    matches!(operation, Operation::Asin | Operation::Acos | Operation::Atan | Operation::Atan2)
}

/// Whether inverse functions occur in expressions.
pub(crate) fn arcs_occur_in(pool: &Pool, expressions: &[Expr]) -> bool {
    let is_arc = |part: Expr| matches!(pool.node(part), Node::Apply(operation, _) if is_arc(*operation));
    pool.reachable(expressions).into_iter().any(is_arc)
}

impl Tower {
    /// Returns the inverse function that a quantity consists of, if it is a single one, with its
    /// arguments.
    pub(crate) fn arc_of(&self, quantity: &Quantity) -> Option<(Operation, Vec<Fraction>)> {
        match self.generator(quantity.as_variable()?) {
            Generator::Opaque { operation, arguments } if is_arc(*operation) => {
                Some((*operation, arguments.clone()))
            }
            _ => None,
        }
    }

    /// (cos qα, sin qα) for an arc α and a number q whose denominator is a power of two.
    pub(super) fn multiple_of_arc(
        &mut self,
        (operation, arguments): (Operation, Vec<Fraction>),
        coefficient: &Rational,
    ) -> Result<Point, Obstacle> {
        let outside = || {
            let (coefficient, function) = (coefficient.clone(), operation.row().name);
            Obstacle::Outside(OutsidePart::Multiple { coefficient, function })
        };
        let halvings = coefficient.denom().trailing_zeros().unwrap_or(0) as u32;
        let multiple = coefficient.numer().abs().to_u32().filter(|m| *m <= LARGEST_MULTIPLE);
        let multiple = multiple.ok_or_else(outside)?;
        if halvings > MOST_HALVINGS || *coefficient.denom() != (1u32 << halvings).into() {
            return Err(outside());
        }
        if multiple.is_even() && halvings == 0 {
            let double = self.point_of_twice_the_arc(operation, &arguments)?;
            let (cosine, sine) = self.repeated(&double, multiple / 2)?;
            let sine = if coefficient.is_negative() { self.negate(&sine) } else { sine };
            return Ok((cosine, sine));
        }
        let mut point = match (operation, halvings) {
            (Operation::Acos, 1..) => self.point_of_half_an_arc_cosine(&arguments[0])?,
            _ => self.point_of_arc(operation, &arguments)?,
        };
        let halved_already = u32::from(operation == Operation::Acos).min(halvings);
        for _ in halved_already..halvings {
            point = self.halved(&point)?;
        }
        let (cosine, sine) = self.repeated(&point, multiple)?;
        let sine = if coefficient.is_negative() { self.negate(&sine) } else { sine };
        Ok((cosine, sine))
    }

    /// Returns the point of the unit circle in the direction of an arc.
    fn point_of_arc(&mut self, operation: Operation, arguments: &[Fraction]) -> Result<Point, Obstacle> {
        let q = &arguments[0];
        match operation {
            Operation::Asin => Ok((self.complement(q)?, q.clone())),
            Operation::Acos => Ok((q.clone(), self.complement(q)?)),
            Operation::Atan => self.direction(&Fraction::one(), q),
            _ => self.direction(&arguments[1], q),
        }
    }

    /// Returns the point for twice the arc, without roots for an arc tangent: ((x² − y²)/r²,
    /// 2xy/r²).
    fn point_of_twice_the_arc(
        &mut self,
        operation: Operation,
        arguments: &[Fraction],
    ) -> Result<Point, Obstacle> {
        let (y, x) = match operation {
            Operation::Atan => (&arguments[0], Fraction::one()),
            Operation::Atan2 => (&arguments[0], arguments[1].clone()),
            _ => {
                let point = self.point_of_arc(operation, arguments)?;
                return self.angle_sum(&point, &point);
            }
        };
        let (x_squared, y_squared, area) =
            (self.multiply(&x, &x)?, self.multiply(y, y)?, self.multiply(&x, y)?);
        let square = self.add(&x_squared, &y_squared)?;
        let inverse = self.inverse(&square)?;
        let (across, along) = (self.subtract(&x_squared, &y_squared)?, self.add(&area, &area)?);
        Ok((self.multiply(&across, &inverse)?, self.multiply(&along, &inverse)?))
    }

    /// √(1 − q²)
    fn complement(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        let square = self.multiply(q, q)?;
        let rest = self.subtract(&Fraction::one(), &square)?;
        self.root_of(&rest)
    }

    /// (x/r, y/r)
    fn direction(&mut self, x: &Fraction, y: &Fraction) -> Result<Point, Obstacle> {
        let (x_squared, y_squared) = (self.multiply(x, x)?, self.multiply(y, y)?);
        let square = self.add(&x_squared, &y_squared)?;
        let distance = self.root_of(&square)?;
        let inverse = self.inverse(&distance)?;
        Ok((self.multiply(x, &inverse)?, self.multiply(y, &inverse)?))
    }

    fn root_of(&mut self, q: &Fraction) -> Result<Fraction, Obstacle> {
        if q.is_zero() {
            return Ok(Fraction::zero());
        }
        Ok(self.magnitude_power(q, Ratio::new(1, 2))?.0)
    }

    /// cos(α/2) = √((1 + q)/2), sin(α/2) = √((1 − q)/2) for α = acos q in [0, π], including π.
    fn point_of_half_an_arc_cosine(&mut self, q: &Fraction) -> Result<Point, Obstacle> {
        let half = Fraction::number(&Rational::new(1.into(), 2.into()));
        let (above, below) = (self.add(&Fraction::one(), q)?, self.subtract(&Fraction::one(), q)?);
        let (above, below) = (self.multiply(&above, &half)?, self.multiply(&below, &half)?);
        Ok((self.root_of(&above)?, self.root_of(&below)?))
    }

    /// Returns the point at half the angle, for an angle in (−π, π): cos(α/2) = √((1 + cos α)/2),
    /// sin(α/2) = sin α/(2 cos(α/2)). All arcs except `acos`, and all parts of arcs, lie there: the
    /// branch cut of `atan2` is excluded.
    pub(super) fn halved(&mut self, (cosine, sine): &Point) -> Result<Point, Obstacle> {
        let above = self.add(&Fraction::one(), cosine)?;
        if above.is_zero() {
            return Ok((Fraction::zero(), Fraction::one()));
        }
        let half = Fraction::number(&Rational::new(1.into(), 2.into()));
        let square = self.multiply(&above, &half)?;
        let outer = self.root_of(&square)?;
        let inverse = self.inverse(&outer)?;
        let slope = self.multiply(sine, &half)?;
        Ok((outer, self.multiply(&slope, &inverse)?))
    }

    /// (cos α + i sin α)ⁿ by repeated squaring.
    pub(super) fn repeated(&mut self, point: &Point, times: u32) -> Result<Point, Obstacle> {
        let mut result = (Fraction::one(), Fraction::zero());
        let mut square = point.clone();
        let mut rest = times;
        while rest > 0 {
            if rest.is_odd() {
                result = self.angle_sum(&result, &square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = self.angle_sum(&square, &square.clone())?;
            }
        }
        Ok(result)
    }

    /// Returns tan q. If q contains half an arc, this is sin 2q/(1 + cos 2q), which needs no root
    /// of a root.
    pub(super) fn tangent(&mut self, argument: &Fraction) -> Result<Fraction, Obstacle> {
        let parts = self.linear_parts(argument)?;
        let is_half = |(quantity, coefficient): &(Quantity, Rational)| {
            self.arc_of(quantity).is_some() && coefficient.denom().is_even()
        };
        let (above, below) = if parts.iter().any(is_half) {
            let twice = self.add(argument, argument)?;
            let (cosine, sine) = self.circular(&twice)?;
            (sine, self.add(&Fraction::one(), &cosine)?)
        } else {
            let (cosine, sine) = self.circular(argument)?;
            (sine, cosine)
        };
        let inverse = self.inverse(&below)?;
        self.multiply(&above, &inverse)
    }

    /// Returns rational combinations of arcs and other terms whose vanishing makes an element
    /// vanish: the element itself if the coefficients of its arcs are integers, the element divided
    /// by a common factor of these coefficients, or its parts by monomials. `None` if the element
    /// has no arc or is not linear in its arcs.
    pub(crate) fn combinations_of_arcs(&mut self, a: &Fraction) -> Result<Option<Vec<Fraction>>, Obstacle> {
        let (arcs, others): (Vec<u32>, Vec<u32>) =
            a.numerator.variables().into_iter().partition(|&variable| self.is_arc_generator(variable));
        let parts = a.numerator.split_by(&arcs);
        let is_linear = |exponents: &[u32]| exponents.iter().sum::<u32>() <= 1;
        if arcs.is_empty() || !parts.iter().all(|(exponents, _)| is_linear(exponents)) {
            return Ok(None);
        }
        let has_arc = |exponents: &Vec<u32>| exponents.iter().any(|&exponent| exponent > 0);
        let coefficients: Vec<&Polynomial> =
            parts.iter().filter(|(exponents, _)| has_arc(exponents)).map(|(_, c)| c).collect();
        let shared = coefficients[0].primitive_part();
        let numbers: Option<Vec<BigInt>> = coefficients
            .iter()
            .map(|c| c.divide_exact(&shared).and_then(|quotient| quotient.as_constant()))
            .collect();
        if let Some(numbers) = numbers {
            let common = numbers.iter().fold(BigInt::from(0), |all, number| all.gcd(number));
            let divisor = self.inverse(&Polynomial::constant(common).mul(&shared).into())?;
            return Ok(Some(vec![self.multiply(&a.numerator.clone().into(), &divisor)?]));
        }
        let others: Vec<u32> =
            others.into_iter().filter(|&variable| *self.generator(variable) != Generator::Pi).collect();
        Ok(Some(a.numerator.split_by(&others).into_iter().map(|(_, part)| part.into()).collect()))
    }

    fn is_arc_generator(&self, variable: u32) -> bool {
        matches!(self.generator(variable), Generator::Opaque { operation, .. } if is_arc(*operation))
    }
}
