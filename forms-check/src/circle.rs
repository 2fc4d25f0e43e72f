//! Sines, cosines and tangents of sums of multiples of units, of rational multiples of π, and of
//! inverse functions.

use crate::element::one;
use crate::expression::Operation::{Function, Pi};
use crate::expression::rational;
use crate::field::{Field, Fraction, Kind, Unit};
use crate::polynomial::Polynomial;
use crate::{Stop, rejected};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};

/// Cosine and sine of an angle.
type Point = (Fraction, Fraction);

/// Largest denominator q of an angle pπ/q.
const SMALLEST_PART: i64 = 960;

impl Field {
    pub(crate) fn circular(&mut self, angle: &Fraction) -> Result<Point, Stop> {
        let mut point = (one(), Fraction::default());
        for (quantity, c) in self.terms(angle)? {
            let (step, times) = self.step(&quantity, &c)?;
            point = self.turned_often(point, &step, times)?;
        }
        Ok(point)
    }

    fn turned_often(&mut self, mut point: Point, step: &Point, times: i64) -> Result<Point, Stop> {
        let sine = step.1.scale(&rational(times.signum(), 1));
        for _ in 0..times.abs() {
            point = self.turned(&point, &(step.0.clone(), sine.clone()))?;
        }
        Ok(point)
    }

    /// Returns the point of π/q for q = 2ᵏ, 3·2ᵏ, 5·2ᵏ and 15·2ᵏ. It uses that cos² and sin² of
    /// half an angle are (1 ± cos)/2, cos(π/5) = (1 + √5)/4, sin(π/5) = √(√5/(2(1 + √5))), and
    /// π/(mn) = uπ/n + vπ/m for um + vn = 1.
    fn part_of_half_turn(&mut self, q: i64) -> Result<Point, Stop> {
        let number = |p, q| Fraction::number(rational(p, q));
        match q {
            1 => return Ok((number(-1, 1), number(0, 1))),
            2 => return Ok((number(0, 1), one())),
            3 => return Ok((number(1, 2), self.root(&number(3, 1), 1, 2)?.scale(&rational(1, 2)))),
            5 => {
                let root = self.root(&number(5, 1), 1, 2)?;
                let sum = self.add(&one(), &root)?;
                let square = self.quotient(&root, &sum.scale(&rational(2, 1)))?;
                return Ok((sum.scale(&rational(1, 4)), self.root(&square, 1, 2)?));
            }
            _ => {}
        }
        if let Some(m) = [3, 5].into_iter().find(|m| q % m == 0) {
            let n = q / m;
            let Some(u) = (0..n).find(|u| (u * m) % n == 1) else {
                return rejected("there is no rule for the sine and cosine of this rational multiple of pi");
            };
            let (coarse, fine) = (self.part_of_half_turn(n)?, self.part_of_half_turn(m)?);
            let point = self.turned_often((one(), Fraction::default()), &coarse, u)?;
            return self.turned_often(point, &fine, (1 - u * m) / n);
        }
        if q % 2 != 0 || q > 64 {
            return rejected("there is no rule for the sine and cosine of this rational multiple of pi");
        }
        let cosine = self.part_of_half_turn(q / 2)?.0;
        let [up, down] = [1, -1].map(|sign| cosine.scale(&rational(sign, 2)));
        let (up, down) = (self.add(&number(1, 2), &up)?, self.add(&number(1, 2), &down)?);
        Ok((self.root(&up, 1, 2)?, self.root(&down, 1, 2)?))
    }

    /// Returns the point of a + b, where cos(a + b) = cos a cos b − sin a sin b and
    /// sin(a + b) = sin a cos b + cos a sin b.
    fn turned(&mut self, a: &Point, b: &Point) -> Result<Point, Stop> {
        let (cc, ss) = (self.multiply(&a.0, &b.0)?, self.multiply(&a.1, &b.1)?);
        let (sc, cs) = (self.multiply(&a.1, &b.0)?, self.multiply(&a.0, &b.1)?);
        Ok((self.subtract(&cc, &ss)?, self.add(&sc, &cs)?))
    }

    /// Returns the point of an angle of which c·quantity is an integer multiple, and the multiple:
    /// the angle is π/q, an inverse function or a unit.
    fn step(&mut self, quantity: &Fraction, c: &BigRational) -> Result<(Point, i64), Stop> {
        let generator = (0..self.generators.len()).find(|g| quantity.is_generator(*g));
        match generator.and_then(|g| self.generators[g].clone()) {
            Some((Pi, _)) => {
                let times = i64::try_from(c.numer() % (c.denom() * BigInt::from(2))).ok();
                let q = i64::try_from(c.denom()).ok().filter(|q| *q <= SMALLEST_PART);
                let (Some(times), Some(q)) = (times, q) else {
                    return rejected("the denominator of the multiple of pi is too large");
                };
                return Ok((self.part_of_half_turn(q)?, times));
            }
            Some((Function(name @ ("asin" | "atan")), a)) if c.is_integer() => {
                let times = i64::try_from(c.numer()).ok().filter(|n| n.abs() < 256);
                let Some(times) = times else { return rejected("the multiple of the angle is too large") };
                return Ok((self.inverse_point(name, &a[0])?, times));
            }
            _ => {}
        }
        let (number, times) = self.multiple(quantity, c, false)?;
        let unit = self.units[number].clone();
        let first = Polynomial::generator(unit.generator, 1).into();
        if unit.kind == Kind::Circle {
            return Ok(((first, Polynomial::generator(unit.generator + 1, 1).into()), times));
        }
        // ((1 − t²)/(1 + t²), 2t/(1 + t²))
        let square = self.multiply(&first, &first)?;
        let (below, above) = (self.add(&one(), &square)?, self.subtract(&one(), &square)?);
        let cosine = self.quotient(&above, &below)?;
        let sine = self.quotient(&first.scale(&rational(2, 1)), &below)?;
        Ok(((cosine, sine), times))
    }

    /// Returns the cosine and the sine of asin q or atan q.
    fn inverse_point(&mut self, name: &str, q: &Fraction) -> Result<Point, Stop> {
        let sign = rational(if name == "asin" { -1 } else { 1 }, 1);
        let square = self.multiply(q, q)?.scale(&sign);
        let sum = self.add(&one(), &square)?;
        let root = self.magnitude(&sum, Ratio::new(1, 2))?;
        if name == "asin" {
            return Ok((root, q.clone()));
        }
        Ok((self.inverse(&root)?, self.quotient(q, &root)?))
    }

    /// Declares a unit of angles or exponents, which must be one term; returns its value.
    pub(crate) fn declare(&mut self, kind: Kind, value: &Fraction) -> Result<Fraction, Stop> {
        let value = self.expanded(value)?;
        if value.numerator.0.len() != 1 {
            return rejected("a unit must be a single term");
        }
        let generator = self.new_generator(None)?;
        if kind == Kind::Circle {
            let sine = self.new_generator(None)?;
            let square = Polynomial::generator(generator, 2).scale(&rational(-1, 1));
            self.bind(sine, 2, square.add(&Polynomial::constant(rational(1, 1))));
        }
        self.units.push(Unit { kind, value: value.clone(), generator, used: 0 });
        Ok(value)
    }

    /// Whether an angle is a declared unit.
    pub(crate) fn has_unit(&mut self, angle: &Fraction) -> Result<bool, Stop> {
        for number in 0..self.units.len() {
            let value = self.units[number].value.clone();
            if self.equal(angle, &value)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Returns the tangent of an angle that is half of a unit represented by tan(u/2).
    pub(crate) fn half_unit(&mut self, angle: &Fraction) -> Result<Option<Fraction>, Stop> {
        for number in 0..self.units.len() {
            let unit = self.units[number].clone();
            if unit.kind == Kind::Tangent && self.equal(&angle.scale(&rational(2, 1)), &unit.value)? {
                return Ok(Some(Polynomial::generator(unit.generator, 1).into()));
            }
        }
        Ok(None)
    }

    /// Returns the tangent of an angle: the generator if it is tan(u/2) of a unit, otherwise sine
    /// over cosine.
    pub(crate) fn tangent(&mut self, angle: &Fraction) -> Result<Fraction, Stop> {
        if let Some(known) = self.half_unit(angle)? {
            return Ok(known);
        }
        let (cosine, sine) = self.circular(angle)?;
        self.quotient(&sine, &cosine)
    }
}
