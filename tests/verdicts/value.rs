//! Values with some 90 digits, by a library that knows nothing of the engine's enclosures.

use crate::tree::Tree::{self, *};
use astro_float::{BigFloat, Consts, RoundingMode};

/// Bits of every operation.
const BITS: usize = 320;
/// To the last bit but few: correct rounding would never end at an exact value such as 4^(1/2).
const ROUNDING: RoundingMode = RoundingMode::None;

/// Below this a divisor counts as zero, and a difference of the sides (as a part of their size) as none: 10⁻⁶⁰.
const NOTHING: f64 = 1e-60;

/// Evaluates trees at points.
pub struct Calculator {
    constants: Consts,
}

impl Calculator {
    pub fn new() -> Self {
        Calculator { constants: Consts::new().expect("constants fit in memory") }
    }

    pub fn ratio(&self, p: i64, q: i64) -> BigFloat {
        BigFloat::from_i64(p, BITS).div(&BigFloat::from_i64(q, BITS), BITS, ROUNDING)
    }

    /// The value; nothing where the expression is not defined, or where that cannot be told for the digits.
    pub fn value(&mut self, tree: &Tree, point: &[BigFloat]) -> Option<BigFloat> {
        let (p, rm) = (BITS, ROUNDING);
        let value = match tree {
            Variable(place) => point[*place].clone(),
            Number(above, below) => self.ratio(*above, *below),
            Pi => self.constants.pi(p, rm),
            Sum(a, b) => self.value(a, point)?.add(&self.value(b, point)?, p, rm),
            Difference(a, b) => self.value(a, point)?.sub(&self.value(b, point)?, p, rm),
            Product(a, b) => self.value(a, point)?.mul(&self.value(b, point)?, p, rm),
            Quotient(a, b) => {
                let below = self.value(b, point)?;
                let above = self.value(a, point)?;
                if is_nothing(&below) {
                    return None;
                }
                above.div(&below, p, rm)
            }
            Negative(a) => self.value(a, point)?.neg(),
            Power(a, n, d) => self.power(a, (*n, *d), point)?,
            Function(name, a) => {
                let argument = self.value(a, point)?;
                self.function(name, &argument)?
            }
            Partial(a, by) => {
                self.value(a, point)?;
                self.value(&a.derivative(*by), point)?
            }
        };
        (!value.is_nan() && !value.is_inf()).then_some(value)
    }

    fn power(&mut self, base: &Tree, (n, d): (i64, i64), point: &[BigFloat]) -> Option<BigFloat> {
        let (p, rm) = (BITS, ROUNDING);
        let base = self.value(base, point)?;
        if d == 1 {
            if n < 0 && is_nothing(&base) {
                return None;
            }
            let raised = base.powi(n.unsigned_abs() as usize, p, rm);
            return Some(if n < 0 { BigFloat::from_i64(1, p).div(&raised, p, rm) } else { raised });
        }
        if is_nothing(&base) {
            return (n > 0).then(|| BigFloat::from_i64(0, p));
        }
        if base.is_negative() {
            return None;
        }
        let exponent = self.ratio(n, d).mul(&base.ln(p, rm, &mut self.constants), p, rm);
        Some(exponent.exp(p, rm, &mut self.constants))
    }

    fn function(&mut self, name: &str, x: &BigFloat) -> Option<BigFloat> {
        let (p, rm, cc) = (BITS, ROUNDING, &mut self.constants);
        let one = BigFloat::from_i64(1, p);
        let positive = !x.is_negative() && !is_nothing(x);
        Some(match name {
            "sin" => x.sin(p, rm, cc),
            "cos" => x.cos(p, rm, cc),
            "tan" => {
                if is_nothing(&x.cos(p, rm, cc)) {
                    return None;
                }
                x.tan(p, rm, cc)
            }
            "exp" => x.exp(p, rm, cc),
            "log" if positive => x.ln(p, rm, cc),
            "sqrt" if positive => x.sqrt(p, rm),
            "atan" => x.atan(p, rm, cc),
            "asin" | "acos" => {
                let rest = one.sub(&x.mul(x, p, rm), p, rm);
                if rest.is_negative() || is_nothing(&rest) {
                    return None;
                }
                if name == "asin" { x.asin(p, rm, cc) } else { x.acos(p, rm, cc) }
            }
            "sinh" => x.sinh(p, rm, cc),
            "cosh" => x.cosh(p, rm, cc),
            "tanh" => x.tanh(p, rm, cc),
            "abs" => x.abs(),
            _ => return None,
        })
    }

    /// Whether both sides are defined at a point and, if so, whether they differ in their first 60 digits.
    pub fn differ(&mut self, sides: [&Tree; 2], point: &[BigFloat]) -> Option<bool> {
        let (left, right) = (self.value(sides[0], point)?, self.value(sides[1], point)?);
        let size = left.abs().add(&right.abs(), BITS, ROUNDING);
        let bound = size.add(&BigFloat::from_i64(1, BITS), BITS, ROUNDING);
        let bound = bound.mul(&BigFloat::from_f64(NOTHING, BITS), BITS, ROUNDING);
        let difference = left.sub(&right, BITS, ROUNDING).abs();
        Some(difference.cmp(&bound).is_some_and(|order| order > 0))
    }
}

fn is_nothing(value: &BigFloat) -> bool {
    let bound = BigFloat::from_f64(NOTHING, BITS);
    value.abs().cmp(&bound).is_none_or(|order| order < 0)
}
