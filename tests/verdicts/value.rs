//! Values with many digits, from a library that is independent of the engine's interval arithmetic.

use crate::statement::{Condition, Relation};
use crate::tree::Tree::{self, *};
use astro_float::{BigFloat, Consts, Radix, RoundingMode};

/// Rounding mode without correct rounding, which would not terminate at an exact value such as
/// 4^(1/2). Only the last few bits are wrong.
const ROUNDING: RoundingMode = RoundingMode::None;

/// Evaluator of trees at points.
pub(crate) struct Calculator {
    constants: Consts,
    /// Precision of every operation, in bits.
    bits: usize,
    /// Threshold below which a value counts as zero: the residue when values of moderate size
    /// cancel.
    nothing: BigFloat,
}

impl Calculator {
    /// Creates a calculator with this precision; three eighths of the bits can be lost.
    pub(crate) fn new(bits: usize) -> Self {
        let half = BigFloat::from_f64(0.5, bits);
        let nothing = half.powi(bits * 5 / 8, bits, ROUNDING);
        Calculator { constants: Consts::new().expect("constants fit in memory"), bits, nothing }
    }

    pub(crate) fn ratio(&self, p: i64, q: i64) -> BigFloat {
        self.integer(p).div(&self.integer(q), self.bits, ROUNDING)
    }

    /// Parses a coordinate of a witness: sums, products and quotients of π and of integers with any
    /// number of digits.
    pub(crate) fn coordinate(&mut self, text: &str) -> BigFloat {
        let mut rest = text;
        let value = self.sum(&mut rest);
        assert!(rest.is_empty(), "{text} is no number");
        value
    }

    fn sum(&mut self, rest: &mut &str) -> BigFloat {
        let mut sum = self.product(rest);
        loop {
            let (sign, after) = (rest.chars().next(), rest.get(1..).unwrap_or_default());
            match sign {
                Some(' ') => *rest = after,
                Some('+') => {
                    *rest = after;
                    sum = sum.add(&self.product(rest), self.bits, ROUNDING);
                }
                Some('-') => {
                    *rest = after;
                    sum = sum.sub(&self.product(rest), self.bits, ROUNDING);
                }
                _ => return sum,
            }
        }
    }

    fn product(&mut self, rest: &mut &str) -> BigFloat {
        let mut product = self.factor(rest);
        while let Some(sign @ ('*' | '/')) = rest.chars().next() {
            *rest = &rest[1..];
            let factor = self.factor(rest);
            product = match sign {
                '*' => product.mul(&factor, self.bits, ROUNDING),
                _ => product.div(&factor, self.bits, ROUNDING),
            };
        }
        product
    }

    fn factor(&mut self, rest: &mut &str) -> BigFloat {
        *rest = rest.trim_start();
        if let Some(after) = rest.strip_prefix('-') {
            *rest = after;
            return self.factor(rest).neg();
        }
        if let Some(after) = rest.strip_prefix("pi") {
            *rest = after;
            return self.constants.pi(self.bits, ROUNDING);
        }
        if let Some(after) = rest.strip_prefix('(') {
            *rest = after;
            let inner = self.sum(rest);
            *rest = rest.strip_prefix(')').expect("a bracket is closed");
            return inner;
        }
        let end = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        let (digits, after) = rest.split_at(end);
        *rest = after;
        BigFloat::parse(digits, Radix::Dec, self.bits, ROUNDING, &mut self.constants)
    }

    fn integer(&self, value: i64) -> BigFloat {
        BigFloat::from_i64(value, self.bits)
    }

    fn is_nothing(&self, value: &BigFloat) -> bool {
        value.abs().cmp(&self.nothing).is_none_or(|order| order < 0)
    }

    fn is_positive(&self, value: &BigFloat) -> bool {
        !value.is_negative() && !self.is_nothing(value)
    }

    /// Returns the value; `None` where the expression is undefined.
    pub(crate) fn value(&mut self, tree: &Tree, point: &[BigFloat]) -> Option<BigFloat> {
        let (p, rm) = (self.bits, ROUNDING);
        let value = match tree {
            Variable(place) => point[*place].clone(),
            Number(above, below) => self.ratio(*above, *below),
            Pi => self.constants.pi(p, rm),
            Sum(a, b) => self.value(a, point)?.add(&self.value(b, point)?, p, rm),
            Difference(a, b) => self.value(a, point)?.sub(&self.value(b, point)?, p, rm),
            Product(a, b) => self.value(a, point)?.mul(&self.value(b, point)?, p, rm),
            Quotient(a, b) => {
                let (above, below) = (self.value(a, point)?, self.value(b, point)?);
                if self.is_nothing(&below) {
                    return None;
                }
                above.div(&below, p, rm)
            }
            Negative(a) => self.value(a, point)?.neg(),
            Power(a, n, d) => {
                let base = self.value(a, point)?;
                self.power(&base, *n, *d)?
            }
            Raised(a, e) => {
                let (base, exponent) = (self.value(a, point)?, self.value(e, point)?);
                self.raised(&base, &exponent)?
            }
            Function(name, a) => {
                let argument = self.value(a, point)?;
                self.function(name, &argument)?
            }
            Atan2(y, x) => {
                let (y, x) = (self.value(y, point)?, self.value(x, point)?);
                self.atan2(&y, &x)?
            }
            Written(notation, parts) => self.value(&notation.meaning(parts), point)?,
        };
        (!value.is_nan() && !value.is_inf()).then_some(value)
    }

    /// Computes an integer power of any base, or a fractional power of a non-negative base.
    fn power(&mut self, base: &BigFloat, n: i64, d: i64) -> Option<BigFloat> {
        let (p, rm) = (self.bits, ROUNDING);
        if self.is_nothing(base) && (n < 0 || n % d != 0) {
            return (n > 0).then(|| self.integer(0));
        }
        if n % d != 0 {
            let exponent = self.ratio(n, d);
            return self.raised(base, &exponent);
        }
        let raised = base.powi((n / d).unsigned_abs() as usize, p, rm);
        Some(if n < 0 { self.integer(1).div(&raised, p, rm) } else { raised })
    }

    /// Computes qᵉ = exp(e log q).
    fn raised(&mut self, base: &BigFloat, exponent: &BigFloat) -> Option<BigFloat> {
        let (p, rm) = (self.bits, ROUNDING);
        let logarithm = self.function("log", base)?;
        Some(exponent.mul(&logarithm, p, rm).exp(p, rm, &mut self.constants))
    }

    fn function(&mut self, name: &str, x: &BigFloat) -> Option<BigFloat> {
        let (p, rm) = (self.bits, ROUNDING);
        let (nothing, positive) = (self.is_nothing(x), self.is_positive(x));
        let cc = &mut self.constants;
        Some(match name {
            "sin" => x.sin(p, rm, cc),
            "cos" => x.cos(p, rm, cc),
            "tan" => {
                let (sine, cosine) = (x.sin(p, rm, cc), x.cos(p, rm, cc));
                if self.is_nothing(&cosine) {
                    return None;
                }
                sine.div(&cosine, p, rm)
            }
            "exp" => x.exp(p, rm, cc),
            "log" if positive => x.ln(p, rm, cc),
            "sqrt" if nothing => self.integer(0),
            "sqrt" if positive => x.sqrt(p, rm),
            "atan" => x.atan(p, rm, cc),
            "asin" | "acos" => {
                let rest = self.integer(1).sub(&x.mul(x, p, rm), p, rm);
                let cosine = self.function("sqrt", &rest)?;
                // asin x is the angle of the point (√(1 − x²), x), and acos x is the angle of (x,
                // √(1 − x²)).
                return if name == "asin" { self.angle(x, &cosine) } else { self.angle(&cosine, x) };
            }
            "sinh" => x.sinh(p, rm, cc),
            "cosh" => x.cosh(p, rm, cc),
            "tanh" => x.tanh(p, rm, cc),
            "abs" => x.abs(),
            _ => return None,
        })
    }

    /// Returns the angle of a point; `None` on the branch cut.
    fn atan2(&mut self, y: &BigFloat, x: &BigFloat) -> Option<BigFloat> {
        if self.is_nothing(y) && !self.is_positive(x) {
            return None;
        }
        self.angle(y, x)
    }

    /// Returns the angle of a point in (−π, π]: atan(y/x) where x > 0, ±π/2 − atan(x/y) or π
    /// elsewhere.
    fn angle(&mut self, y: &BigFloat, x: &BigFloat) -> Option<BigFloat> {
        let (p, rm) = (self.bits, ROUNDING);
        if self.is_positive(x) {
            return Some(y.div(x, p, rm).atan(p, rm, &mut self.constants));
        }
        let pi = self.constants.pi(p, rm);
        if self.is_nothing(y) {
            return (!self.is_nothing(x)).then_some(pi);
        }
        let quarter = pi.div(&self.integer(2), p, rm);
        let quarter = if y.is_negative() { quarter.neg() } else { quarter };
        Some(quarter.sub(&x.div(y, p, rm).atan(p, rm, &mut self.constants), p, rm))
    }

    /// Whether a condition holds; `None` where one of its sides is undefined.
    pub(crate) fn meets(&mut self, condition: &Condition, point: &[BigFloat]) -> Option<bool> {
        let (left, right) = (self.value(&condition.left, point)?, self.value(&condition.right, point)?);
        let difference = right.sub(&left, self.bits, ROUNDING);
        Some(match condition.relation {
            Relation::Less => self.is_positive(&difference),
            Relation::LessEqual => self.is_nothing(&difference) || self.is_positive(&difference),
            Relation::NotEqual => !self.is_nothing(&difference),
        })
    }

    /// Whether the sides differ at a point, relative to their size, by more than the threshold;
    /// `None` where a side is undefined.
    pub(crate) fn differ(&mut self, sides: [&Tree; 2], point: &[BigFloat]) -> Option<bool> {
        let (p, rm) = (self.bits, ROUNDING);
        let (left, right) = (self.value(sides[0], point)?, self.value(sides[1], point)?);
        let size = left.abs().add(&right.abs(), p, rm).add(&self.integer(1), p, rm);
        let difference = left.sub(&right, p, rm);
        Some(!self.is_nothing(&difference.div(&size, p, rm)))
    }
}
