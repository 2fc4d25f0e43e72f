//! Taylor coefficients of expressions over an interval, used to enclose integrals.
//!
//! ```text
//! x = x₀ + x₁ε + …  ─ operands before results ─▶ f(x) = f₀ + f₁ε + … + fₙεⁿ, each fₖ an enclosure
//! ```
//! If x₀ is an interval, fₖ contains the k-th Taylor coefficient at each of its points. A function
//! with derivative g has k fₖ = Σ j xⱼ gₖ₋ⱼ; for eˣ, sin x and powers that is a recurrence, for the
//! others g is computed first.

use super::bounds::{Enclosure, Precision, Undecided};
use crate::expression::{Expr, Node, Operation, Pool, Rational, Symbol};
use crate::steps;
use num_rational::Ratio;
use num_traits::Signed;
use rustc_hash::FxHashMap;

/// Coefficients of 1, ε, …, εⁿ.
pub(super) type Series = Vec<Enclosure>;

type Expanded = Result<Series, Undecided>;

/// Returns the series x₀ + x₁ε up to an order.
pub(super) fn linear(first: Enclosure, slope: &Enclosure, order: usize, precision: Precision) -> Series {
    let mut series = vec![Enclosure::integer(0, precision); order + 1];
    series[0] = first;
    if let Some(second) = series.get_mut(1) {
        *second = slope.clone();
    }
    series
}

/// Context of an expansion: n + 1 coefficients for each variable.
pub(super) struct Taylor<'a> {
    pub(super) pool: &'a Pool,
    pub(super) values: &'a FxHashMap<Symbol, Series>,
    pub(super) order: usize,
    pub(super) precision: Precision,
}

impl Taylor<'_> {
    /// Returns the coefficients of an expression; unknown if a choice is not certain or the
    /// expression contains an integral or an unknown function.
    pub(super) fn of(&self, expression: Expr) -> Expanded {
        let mut known: FxHashMap<Expr, Series> = FxHashMap::default();
        for part in self.pool.reachable(&[expression]) {
            if !steps::spend(self.cost(self.pool.node(part))) {
                return Err(Undecided::TooLarge);
            }
            let series = self.of_node(self.pool.node(part), &known)?;
            known.insert(part, series);
        }
        known.remove(&expression).ok_or(Undecided::Unknown)
    }

    /// Returns the steps of a node: products of series are sums of products of numbers.
    fn cost(&self, node: &Node) -> u64 {
        let terms = self.order as u64 + 1;
        let one = steps::of_arithmetic(self.precision.0);
        match node {
            Node::Number(_) | Node::Pi | Node::Symbol(_) | Node::Add(..) | Node::Negate(_) => terms * one,
            _ => terms * terms * one,
        }
    }

    fn of_node(&self, node: &Node, known: &FxHashMap<Expr, Series>) -> Expanded {
        let of = |operand: &Expr| &known[operand];
        match node {
            Node::Number(value) => Ok(self.constant(Enclosure::exact(value, self.precision))),
            Node::Pi => Ok(self.constant(Enclosure::pi(self.precision))),
            Node::Symbol(symbol) => self.values.get(symbol).cloned().ok_or(Undecided::Unknown),
            Node::Add(a, b) => Ok(sum(of(a), of(b))),
            Node::Negate(a) => Ok(of(a).iter().map(Enclosure::neg).collect()),
            Node::Multiply(a, b) => Ok(self.product(of(a), of(b))),
            Node::Divide(a, b) => Ok(self.product(of(a), &self.power(of(b), Ratio::from_integer(-1))?)),
            Node::Power(a, exponent) => self.power(of(a), *exponent),
            Node::Apply(Operation::Atan2, arguments) => self.angle(of(&arguments[0]), of(&arguments[1])),
            Node::Apply(Operation::Hypot, arguments) => {
                let squares = [0, 1].map(|side| self.product(of(&arguments[side]), of(&arguments[side])));
                self.power(&sum(&squares[0], &squares[1]), Ratio::new(1, 2))
            }
            Node::Apply(operation, arguments) => self.function(*operation, of(&arguments[0])),
            Node::Select { left, relation, right, then, otherwise, .. } => {
                match of(left)[0].decide(*relation, &of(right)[0]) {
                    Some(true) => Ok(of(then).clone()),
                    Some(false) => Ok(of(otherwise).clone()),
                    None => Err(Undecided::Unknown),
                }
            }
            Node::Jet { .. } => Err(Undecided::Unknown),
        }
    }

    fn integer(&self, value: i64) -> Enclosure {
        Enclosure::integer(value, self.precision)
    }

    fn ratio(&self, p: i64, q: i64) -> Enclosure {
        Enclosure::exact(&Rational::new(p.into(), q.into()), self.precision)
    }

    pub(super) fn constant(&self, value: Enclosure) -> Series {
        let mut series = vec![self.integer(0); self.order + 1];
        series[0] = value;
        series
    }

    /// Σ aⱼ bₖ₋ⱼ
    fn product(&self, a: &Series, b: &Series) -> Series {
        let coefficient = |k: usize| {
            (0..=k).fold(self.integer(0), |sum, j| {
                if a[j].is_zero() || b[k - j].is_zero() { sum } else { sum.add(&a[j].mul(&b[k - j])) }
            })
        };
        (0..=self.order).map(coefficient).collect()
    }

    fn scaled(&self, a: &Series, p: i64, q: i64) -> Series {
        let factor = self.ratio(p, q);
        a.iter().map(|coefficient| coefficient.mul(&factor)).collect()
    }

    /// p₀ = x₀ʳ, k x₀ pₖ = Σ (r j − (k − j)) xⱼ pₖ₋ⱼ for j ≥ 1; a positive integer power by
    /// products, since x₀ may be 0.
    fn power(&self, x: &Series, exponent: Ratio<i64>) -> Expanded {
        if exponent.is_integer() && exponent.is_positive() {
            let times = u32::try_from(*exponent.numer()).map_err(|_| Undecided::Unknown)?;
            return Ok(self.repeated(x, times));
        }
        let mut power = vec![x[0].power(exponent)?];
        for k in 1..=self.order {
            let mut sum = self.integer(0);
            for j in (1..=k).filter(|&j| !x[j].is_zero()) {
                let factor = exponent * Ratio::from_integer(j as i64) - Ratio::from_integer((k - j) as i64);
                let factor = self.ratio(*factor.numer(), *factor.denom());
                sum = sum.add(&x[j].mul(&power[k - j]).mul(&factor));
            }
            power.push(sum.div(&x[0].mul(&self.integer(k as i64)))?);
        }
        Ok(power)
    }

    fn repeated(&self, x: &Series, times: u32) -> Series {
        let mut power = self.constant(self.integer(1));
        for bit in (0..32 - times.leading_zeros()).rev() {
            power = self.product(&power, &power);
            if times >> bit & 1 == 1 {
                power = self.product(&power, x);
            }
        }
        power
    }

    /// Returns the series with f₀ and k fₖ = Σ j xⱼ gₖ₋ⱼ.
    fn integrated(&self, first: Enclosure, x: &Series, slope: &Series) -> Expanded {
        let mut series = vec![first];
        for k in 1..=self.order {
            let mut sum = self.integer(0);
            for j in (1..=k).filter(|&j| !x[j].is_zero()) {
                sum = sum.add(&x[j].mul(&slope[k - j]).mul(&self.integer(j as i64)));
            }
            series.push(sum.div(&self.integer(k as i64))?);
        }
        Ok(series)
    }

    fn exponential(&self, x: &Series) -> Expanded {
        let mut series = vec![x[0].exp()?];
        for k in 1..=self.order {
            let mut sum = self.integer(0);
            for j in (1..=k).filter(|&j| !x[j].is_zero()) {
                sum = sum.add(&x[j].mul(&series[k - j]).mul(&self.integer(j as i64)));
            }
            series.push(sum.div(&self.integer(k as i64))?);
        }
        Ok(series)
    }

    /// (cos x, sin x)
    fn circular(&self, x: &Series) -> Result<(Series, Series), Undecided> {
        let (mut cosine, mut sine) = (vec![x[0].cos()], vec![x[0].sin()]);
        for k in 1..=self.order {
            let (mut of_cosine, mut of_sine) = (self.integer(0), self.integer(0));
            for j in (1..=k).filter(|&j| !x[j].is_zero()) {
                let speed = x[j].mul(&self.integer(j as i64));
                of_sine = of_sine.add(&speed.mul(&cosine[k - j]));
                of_cosine = of_cosine.sub(&speed.mul(&sine[k - j]));
            }
            sine.push(of_sine.div(&self.integer(k as i64))?);
            cosine.push(of_cosine.div(&self.integer(k as i64))?);
        }
        Ok((cosine, sine))
    }

    /// (cosh x, sinh x)
    fn hyperbolic(&self, x: &Series) -> Result<(Series, Series), Undecided> {
        let up = self.exponential(x)?;
        let down = self.exponential(&self.scaled(x, -1, 1))?;
        Ok((self.scaled(&sum(&up, &down), 1, 2), self.scaled(&difference(&up, &down), 1, 2)))
    }

    fn quotient(&self, a: &Series, b: &Series) -> Expanded {
        Ok(self.product(a, &self.power(b, Ratio::from_integer(-1))?))
    }

    fn function(&self, operation: Operation, x: &Series) -> Expanded {
        match operation {
            Operation::Exp => self.exponential(x),
            Operation::Expm1 => {
                let mut series = self.exponential(x)?;
                series[0] = x[0].expm1()?;
                Ok(series)
            }
            Operation::Sin => Ok(self.circular(x)?.1),
            Operation::Cos => Ok(self.circular(x)?.0),
            Operation::Tan => {
                let (cosine, sine) = self.circular(x)?;
                self.quotient(&sine, &cosine)
            }
            Operation::Sinh => Ok(self.hyperbolic(x)?.1),
            Operation::Cosh => Ok(self.hyperbolic(x)?.0),
            Operation::Tanh => {
                let (cosh, sinh) = self.hyperbolic(x)?;
                self.quotient(&sinh, &cosh)
            }
            Operation::Abs if x[0].is_positive() => Ok(x.clone()),
            Operation::Abs if x[0].is_negative() => Ok(self.scaled(x, -1, 1)),
            Operation::Abs | Operation::Atan2 | Operation::Hypot => Err(Undecided::Unknown),
            Operation::Cbrt if x[0].is_positive() => self.power(x, Ratio::new(1, 3)),
            Operation::Cbrt if x[0].is_negative() => {
                let root = self.power(&self.scaled(x, -1, 1), Ratio::new(1, 3))?;
                Ok(self.scaled(&root, -1, 1))
            }
            Operation::Cbrt => Err(Undecided::Unknown),
            _ => {
                let first = Enclosure::apply(operation, std::slice::from_ref(&x[0]))?;
                self.integrated(first, x, &self.slope(operation, x)?)
            }
        }
    }

    /// Returns the derivative of a function according to the table of operations.
    fn slope(&self, operation: Operation, x: &Series) -> Expanded {
        let one = self.constant(self.integer(1));
        let half = Ratio::new(-1, 2);
        match operation {
            Operation::Log => self.power(x, Ratio::from_integer(-1)),
            Operation::Log1p => self.power(&sum(&one, x), Ratio::from_integer(-1)),
            Operation::Atan => self.power(&sum(&one, &self.product(x, x)), Ratio::from_integer(-1)),
            Operation::Asin => self.power(&difference(&one, &self.product(x, x)), half),
            Operation::Acos => Ok(self.scaled(&self.slope(Operation::Asin, x)?, -1, 1)),
            Operation::Erf => {
                let bell = self.exponential(&self.scaled(&self.product(x, x), -1, 1))?;
                let factor = self.constant(Enclosure::pi(self.precision).power(half)?);
                Ok(self.scaled(&self.product(&bell, &factor), 2, 1))
            }
            Operation::Erfc => Ok(self.scaled(&self.slope(Operation::Erf, x)?, -1, 1)),
            Operation::Expint1 => {
                let decay = self.exponential(&self.scaled(x, -1, 1))?;
                Ok(self.scaled(&self.quotient(&decay, x)?, -1, 1))
            }
            Operation::Expint2 => Ok(self.scaled(&self.function(Operation::Expint1, x)?, -1, 1)),
            Operation::Expint3 => Ok(self.scaled(&self.function(Operation::Expint2, x)?, -1, 1)),
            Operation::Dilog => {
                let logarithm = self.function(Operation::Log, &difference(&one, x))?;
                Ok(self.scaled(&self.quotient(&logarithm, x)?, -1, 1))
            }
            Operation::Clausen => {
                let sine = self.circular(&self.scaled(x, 1, 2))?.1;
                let chord = self.function(Operation::Abs, &self.scaled(&sine, 2, 1))?;
                Ok(self.scaled(&self.function(Operation::Log, &chord)?, -1, 1))
            }
            _ => Err(Undecided::Unknown),
        }
    }

    /// Returns the angle of (x, y), whose derivative is (x y′ − y x′)/(x² + y²).
    fn angle(&self, y: &Series, x: &Series) -> Expanded {
        let norm = sum(&self.product(x, x), &self.product(y, y));
        let inverse = self.power(&norm, Ratio::from_integer(-1))?;
        let (by_y, by_x) = (self.product(x, &inverse), self.product(y, &inverse));
        let first = Enclosure::atan2(&y[0], &x[0])?;
        let along = self.integrated(first, y, &by_y)?;
        let across = self.integrated(self.integer(0), x, &by_x)?;
        Ok(difference(&along, &across))
    }
}

fn sum(a: &Series, b: &Series) -> Series {
    a.iter().zip(b).map(|(a, b)| a.add(b)).collect()
}

fn difference(a: &Series, b: &Series) -> Series {
    a.iter().zip(b).map(|(a, b)| a.sub(b)).collect()
}
