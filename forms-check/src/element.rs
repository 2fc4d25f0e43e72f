//! Expressions as fractions: roots in terms of bases, sines and exponentials in terms of units,
//! other functions as generators.

use crate::expression::Operation::{Add, Divide, Function, Jet, Multiply, Number, Pi, Power, Variable};
use crate::expression::{Expr, Operation, Pool, rational};
use crate::field::{Field, Fraction, Kind};
use crate::polynomial::{MOST_BITS, MOST_GENERATORS, Polynomial};
use crate::{Stop, rejected, uncovered};
use num_bigint::BigInt;
use num_rational::{BigRational, Ratio};
use std::collections::BTreeMap;

/// Largest numerator and denominator of an exponent.
const LARGEST_ROOT: i64 = 4096;

/// Product c ∏ gᵉ ∏ exp(u)ᵏ over the bases g and the units u of exponents. Each g is stored with
/// whether g itself, apart from its roots, occurs to an odd power.
pub(crate) struct Factored {
    pub(crate) constant: BigRational,
    pub(crate) powers: BTreeMap<usize, (Ratio<i64>, bool)>,
    exponentials: BTreeMap<usize, i64>,
}

pub(crate) fn one() -> Fraction {
    Fraction::number(rational(1, 1))
}

/// Returns cⁿ of a nonzero number, unless the result would be too long.
fn number_power(c: &BigRational, n: i64) -> Result<BigRational, Stop> {
    let bits = c.numer().bits().max(c.denom().bits()).saturating_mul(n.unsigned_abs());
    match i32::try_from(n).ok().filter(|_| bits <= MOST_BITS) {
        Some(n) => Ok(c.pow(n)),
        None => uncovered("numbers with too many digits"),
    }
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

impl Field {
    /// Returns the element that represents an expression.
    pub(crate) fn element(&mut self, pool: &Pool, expr: Expr) -> Result<Fraction, Stop> {
        for part in pool.parts(&[expr]) {
            if !self.elements.contains_key(&part) {
                let (operation, operands) = pool.node(part);
                let a: Vec<Fraction> =
                    operands.iter().map(|operand| self.elements[operand].clone()).collect();
                let element = match operation {
                    Number(value) => Fraction::number(value.clone()),
                    Pi | Variable(_) | Jet(..) => self.generator(operation, &a)?,
                    Add => self.add(&a[0], &a[1])?,
                    Multiply => self.multiply(&a[0], &a[1])?,
                    Divide => self.quotient(&a[0], &a[1])?,
                    Power(p, 1) => self.integer_power(&a[0], *p)?,
                    Power(p, q) => self.root(&a[0], *p, *q)?,
                    Function(name) => match self.function(name, &a) {
                        // only its arguments are known
                        Err(Stop::Rejected(_)) => self.generator(operation, &a)?,
                        known => known?,
                    },
                };
                self.elements.insert(part, element);
            }
        }
        Ok(self.elements[&expr].clone())
    }

    /// Returns the generator of an operation at arguments: the known generator for equal arguments,
    /// or a new one.
    fn generator(&mut self, operation: &Operation, a: &[Fraction]) -> Result<Fraction, Stop> {
        for number in 0..self.generators.len() {
            let known = self.generators[number].clone().filter(|known| known.0 == *operation);
            let Some((_, arguments)) = known else { continue };
            let mut same = true;
            for (x, y) in arguments.iter().zip(a) {
                same = same && self.equal(x, y)?;
            }
            if same {
                return Ok(Polynomial::generator(number, 1).into());
            }
        }
        Ok(Polynomial::generator(self.new_generator(Some((operation.clone(), a.to_vec())))?, 1).into())
    }

    /// Returns a^(p/q) in terms of the bases, or else in terms of a new root.
    pub(crate) fn root(&mut self, a: &Fraction, p: i64, q: i64) -> Result<Fraction, Stop> {
        match self.magnitude(a, Ratio::new(p, q)) {
            Err(Stop::Rejected(_)) => self.free_root(a, p, q),
            known => known,
        }
    }

    /// Returns a^(p/q) = ρᵖ with ρ^q = a.
    fn free_root(&mut self, a: &Fraction, p: i64, q: i64) -> Result<Fraction, Stop> {
        let count = self.generators.len();
        let root = self.generator(&Power(1, q), std::slice::from_ref(a))?;
        let order = u8::try_from(q).ok().filter(|_| self.generators.len() > count && a.factors.is_empty());
        if let Some(order) = order {
            self.bind(count, order, a.numerator.clone());
        }
        self.integer_power(&root, p)
    }

    fn function(&mut self, name: &str, a: &[Fraction]) -> Result<Fraction, Stop> {
        match name {
            "sin" => Ok(self.circular(&a[0])?.1),
            "cos" => Ok(self.circular(&a[0])?.0),
            "tan" => self.tangent(&a[0]),
            "exp" => self.exponential(&a[0]),
            "abs" => self.magnitude(&a[0], Ratio::from_integer(1)),
            "asin" | "atan" if a[0].numerator.is_zero() => Ok(Fraction::default()),
            "log" => {
                // log |q| does not depend on the sign of q
                let magnitude = self.generators.iter().enumerate().find_map(|(g, known)| match known {
                    Some((Function("abs"), q)) if a[0].is_generator(g) => Some(q[0].clone()),
                    _ => None,
                });
                self.logarithm(magnitude.as_ref().unwrap_or(&a[0]))
            }
            _ => rejected("there is no rule for this function"),
        }
    }

    /// Returns |q|^r = |c|^r ∏ |g|^(e r).
    pub(crate) fn magnitude(&mut self, q: &Fraction, r: Ratio<i64>) -> Result<Fraction, Stop> {
        if q.numerator.is_zero() {
            return if r > Ratio::from_integer(0) { Ok(Fraction::default()) } else { Err(Stop::Undefined) };
        }
        if *r.denom() > LARGEST_ROOT || r.numer().abs() > LARGEST_ROOT {
            return uncovered("exponents this large");
        }
        let Factored { constant, powers, exponentials } = self.factored(q)?;
        let numbers = if r.is_integer() { BTreeMap::new() } else { self.number_powers(&constant)? };
        let plain = if r.is_integer() { number_power(&constant, *r.numer())? } else { rational(1, 1) };
        let mut result = Fraction::number(if plain < rational(0, 1) { -plain } else { plain });
        let powers = powers.into_iter().map(|(base, (exponent, _))| (base, exponent));
        for (base, exponent) in powers.chain(numbers) {
            let power = self.base_power(base, exponent * r)?;
            result = self.multiply(&result, &power)?;
        }
        for (unit, exponent) in exponentials {
            let times = r * exponent;
            if !times.is_integer() {
                return rejected("a unit of exponents is too coarse");
            }
            let itself = Polynomial::generator(self.units[unit].generator, 1).into();
            let power = self.integer_power(&itself, times.to_integer())?;
            result = self.multiply(&result, &power)?;
        }
        Ok(result)
    }

    /// Returns log |q| = Σ e log |g| + Σ k u.
    fn logarithm(&mut self, q: &Fraction) -> Result<Fraction, Stop> {
        if q.numerator.is_zero() {
            return Err(Stop::Undefined);
        }
        let Factored { constant, powers, exponentials } = self.factored(q)?;
        let numbers = self.number_powers(&constant)?;
        let mut sum = Fraction::default();
        for (base, exponent) in powers.into_iter().map(|(base, (e, _))| (base, e)).chain(numbers) {
            let Some(logarithm) = self.bases[base].logarithm else {
                return rejected(format!("base {} lacks a logarithm", base + 1));
            };
            let term = Fraction::from(Polynomial::generator(logarithm, 1));
            sum = self.add(&sum, &term.scale(&rational(*exponent.numer(), *exponent.denom())))?;
        }
        for (unit, exponent) in exponentials {
            let term = self.units[unit].value.scale(&rational(exponent, 1));
            sum = self.add(&sum, &term)?;
        }
        Ok(sum)
    }

    /// Factors an element over the bases; the cofactor must be a number.
    pub(crate) fn factored(&mut self, q: &Fraction) -> Result<Factored, Stop> {
        if q.numerator.is_zero() {
            return rejected("zero has no factors");
        }
        let mut found =
            Factored { constant: rational(1, 1), powers: BTreeMap::new(), exponentials: BTreeMap::new() };
        let below = q.factors.iter().map(|(factor, n)| (self.factor(*factor).clone(), -*n));
        for (mut rest, times) in std::iter::once((q.numerator.clone(), 1)).chain(below.collect::<Vec<_>>()) {
            for (number, base) in self.bases.iter_mut().enumerate() {
                let mut raise = |by: Ratio<i64>, is_whole: bool| {
                    let entry = found.powers.entry(number).or_insert((Ratio::from_integer(0), false));
                    *entry = (entry.0 + by * times, entry.1 ^ (is_whole && times % 2 != 0));
                };
                let root = base.root.map(|root| (Polynomial::generator(root, 1), Ratio::new(1, base.order)));
                let itself = Some((base.polynomial.clone(), Ratio::from_integer(1)));
                for (divisor, exponent) in [root, itself].into_iter().flatten() {
                    while divisor.as_constant().is_none() && rest.as_constant().is_none() {
                        let Some(quotient) = rest.divide(&divisor) else { break };
                        rest = quotient;
                        base.used = base.used.max(1);
                        raise(exponent, exponent.is_integer());
                    }
                }
            }
            for (number, unit) in self.units.iter().enumerate().filter(|unit| unit.1.kind == Kind::Exponent) {
                while let Some(quotient) = rest.divide(&Polynomial::generator(unit.generator, 1)) {
                    rest = quotient;
                    *found.exponentials.entry(number).or_default() += times;
                }
            }
            let Some(constant) = rest.as_constant() else {
                return rejected("a radicand is not a product of the bases");
            };
            found.constant *= number_power(&constant, times)?;
        }
        Ok(found)
    }

    /// Factors |c| over the bases that are numbers.
    fn number_powers(&mut self, c: &BigRational) -> Result<BTreeMap<usize, Ratio<i64>>, Stop> {
        let mut parts = [BigInt::from(c.numer().magnitude().clone()), c.denom().clone()];
        let mut powers = BTreeMap::new();
        for (number, base) in self.bases.iter_mut().enumerate() {
            let Some(prime) = base.polynomial.as_constant().filter(|p| *p > rational(1, 1)) else { continue };
            for (part, step) in parts.iter_mut().zip([1, -1]) {
                while *part != BigInt::from(0) && &*part % prime.numer() == BigInt::from(0) {
                    *part /= prime.numer();
                    base.used = base.used.max(1);
                    *powers.entry(number).or_insert(Ratio::from_integer(0)) += step;
                }
            }
        }
        if parts == [BigInt::from(1), BigInt::from(1)] {
            return Ok(powers);
        }
        rejected("a number is not a product of the bases")
    }

    /// Returns |g|ᵉ: in terms of g itself for an integer e, of its root otherwise.
    fn base_power(&mut self, number: usize, exponent: Ratio<i64>) -> Result<Fraction, Stop> {
        let base = &mut self.bases[number];
        let itself: Fraction = base.polynomial.clone().into();
        if exponent.is_integer() && exponent.numer() % 2 == 0 {
            return self.integer_power(&itself, *exponent.numer());
        }
        let Some(sign) = base.sign else {
            return rejected(format!("the sign of base {} matters", number + 1));
        };
        let signed = itself.scale(&rational(sign, 1));
        if exponent.is_integer() {
            base.used = base.used.max(1);
            return self.integer_power(&signed, *exponent.numer());
        }
        let times = exponent * base.order;
        let Some(order) = u8::try_from(base.order).ok().filter(|_| times.is_integer()) else {
            return rejected(format!("base {} lacks a root", number + 1));
        };
        base.used = base.used.max(1) / gcd(base.used.max(1), *exponent.denom()) * exponent.denom();
        let root = match base.root {
            Some(root) => root,
            None => {
                let root = self.new_generator(None)?;
                self.bases[number].root = Some(root);
                self.bind(root, order, signed.numerator);
                root
            }
        };
        self.integer_power(&Polynomial::generator(root, 1).into(), times.to_integer())
    }

    /// Returns the terms of an angle or exponent, each as a quantity and a numeric coefficient.
    pub(crate) fn terms(&mut self, a: &Fraction) -> Result<Vec<(Fraction, BigRational)>, Stop> {
        let a = self.expanded(a)?;
        let term = |(monomial, c): (&[u8; MOST_GENERATORS], &BigRational)| {
            let numerator = Polynomial(BTreeMap::from([(*monomial, rational(1, 1))]));
            (Fraction { numerator, factors: a.factors.clone() }, c.clone())
        };
        Ok(a.numerator.0.iter().map(term).collect())
    }

    /// Returns the unit of which c·quantity is an integer multiple, and the multiple; `exponent`
    /// selects units of exponents instead of units of angles.
    pub(crate) fn multiple(
        &mut self,
        quantity: &Fraction,
        c: &BigRational,
        exponent: bool,
    ) -> Result<(usize, i64), Stop> {
        for number in 0..self.units.len() {
            let unit = self.units[number].value.clone();
            if (self.units[number].kind == Kind::Exponent) != exponent {
                continue;
            }
            let scale = rational(1, 1) / unit.numerator.leading();
            if self.equal(&unit.scale(&scale), quantity)? {
                let times = c * scale;
                let Some(n) =
                    i64::try_from(times.numer()).ok().filter(|n| times.is_integer() && n.abs() < 256)
                else {
                    return rejected("an angle or exponent is not an integer multiple of its unit");
                };
                self.units[number].used = gcd(self.units[number].used, n);
                return Ok((number, n));
            }
        }
        rejected("an angle or exponent has no unit")
    }

    /// Returns exp(Σ nₖ uₖ + Σ rₖ log qₖ) = ∏ exp(uₖ)^nₖ ∏ qₖ^rₖ.
    fn exponential(&mut self, exponent: &Fraction) -> Result<Fraction, Stop> {
        let mut product = one();
        for (quantity, c) in self.terms(exponent)? {
            let is_quantity = |g: usize| quantity.numerator == Polynomial::generator(g, 1);
            let of_base = self.bases.iter().find(|base| base.logarithm.is_some_and(is_quantity));
            let opaque = self.generators.iter().enumerate().find_map(|(g, generator)| match generator {
                Some((Function("log"), q)) if is_quantity(g) => Some(q[0].clone()),
                _ => None,
            });
            let logarithm = of_base.map(|base| base.polynomial.clone().into()).or(opaque);
            let rational_exponent = [c.numer(), c.denom()].map(|part| i64::try_from(part).ok());
            let power = match (self.multiple(&quantity, &c, true), logarithm, rational_exponent) {
                (Ok((number, n)), ..) => {
                    self.integer_power(&Polynomial::generator(self.units[number].generator, 1).into(), n)?
                }
                (Err(_), Some(q), [Some(n), Some(d)]) if quantity.factors.is_empty() => {
                    self.magnitude(&q, Ratio::new(n, d))?
                }
                (Err(stop), ..) => return Err(stop),
            };
            product = self.multiply(&product, &power)?;
        }
        Ok(product)
    }
}
