//! Signs: expressions that are visibly positive or not negative, and cases of signs that cover
//! every point.

use crate::expression::Operation::{Add, Divide, Function, Multiply, Number, Pi, Power};
use crate::expression::{Expr, Pool, rational};
use crate::field::{Base, Field, Fraction, Kind};
use crate::polynomial::{MOST_GENERATORS, Polynomial};
use crate::theory::{Condition, Relation};
use crate::{Stop, rejected, uncovered};
use num_rational::BigRational;
use std::collections::HashMap;

/// Maximum number of bases that are split into cases at once.
const MOST_SPLIT: usize = 8;

/// Visible sign of an expression.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Seen {
    Nothing,
    NotNegative,
    Positive,
}

/// Returns the sign of a polynomial in which all terms are positive numbers times squares.
fn squares(polynomial: &Polynomial) -> Seen {
    let is_square = |(monomial, c): (&[u8; MOST_GENERATORS], &BigRational)| {
        *c > rational(0, 1) && monomial.iter().all(|exponent| exponent % 2 == 0)
    };
    match polynomial.0.first_key_value() {
        Some((least, _)) if polynomial.0.iter().all(is_square) => {
            if least.iter().all(|exponent| *exponent == 0) { Seen::Positive } else { Seen::NotNegative }
        }
        _ => Seen::Nothing,
    }
}

/// Returns the sign of a product of facts.
fn product_of(facts: &[(Polynomial, Seen)], mut rest: Polynomial) -> Seen {
    let mut least = Seen::Positive;
    for (fact, seen) in facts.iter().filter(|fact| fact.0.as_constant().is_none()) {
        while let Some(quotient) = rest.divide(fact).filter(|_| rest.as_constant().is_none()) {
            rest = quotient;
            least = least.min(*seen);
        }
    }
    least.min(squares(&rest))
}

/// Condition in terms of bases: the sign of a product of odd powers, where none of `all` vanishes.
struct Constraint {
    relation: Relation,
    front: i64,
    odd: Vec<usize>,
    all: Vec<usize>,
}

impl Field {
    /// Returns N ∏ F^odd, which has the sign of N / ∏ Fᵉ, up to a positive number.
    fn signed(&mut self, q: &Fraction) -> Result<Polynomial, Stop> {
        let mut product = q.numerator.clone();
        for (factor, exponent) in &q.factors {
            if exponent % 2 != 0 {
                product = self.product(&product, &self.factor(*factor).clone())?;
            }
        }
        let leading = product.leading();
        Ok(product.scale(&(rational(1, 1) / if leading < rational(0, 1) { -leading } else { leading })))
    }

    /// Returns expressions that are not negative: conditions, bounds of π, sines and cosines, bases
    /// with their signs.
    fn facts(&mut self, pool: &Pool, conditions: &[Condition]) -> Result<Vec<(Polynomial, Seen)>, Stop> {
        let mut facts: Vec<(Fraction, Seen)> = Vec::new();
        for (expr, relation) in conditions.iter().filter(|condition| condition.1 != Relation::NotZero) {
            let seen = if *relation == Relation::Positive { Seen::Positive } else { Seen::NotNegative };
            facts.extend(self.element(pool, *expr).map(|element| (element, seen)));
        }
        let signed = |base: &Base| {
            let polynomial = base.polynomial.clone().scale(&rational(base.sign?, 1));
            Some((polynomial.into(), Seen::NotNegative))
        };
        facts.extend(self.bases.iter().filter_map(signed));
        let bounds = |generator: usize, low, high, seen| {
            let itself = Polynomial::generator(generator, 1);
            let negated = itself.clone().scale(&rational(-1, 1));
            let (low, high) = (Polynomial::constant(low), Polynomial::constant(high));
            [(itself.add(&low.scale(&rational(-1, 1))).into(), seen), (negated.add(&high).into(), seen)]
        };
        for unit in self.units.iter().filter(|unit| unit.kind == Kind::Circle) {
            for generator in [unit.generator, unit.generator + 1] {
                facts.extend(bounds(generator, rational(-1, 1), rational(1, 1), Seen::NotNegative));
            }
        }
        if let Some(pi) = self.generators.iter().position(|generator| matches!(generator, Some((Pi, _)))) {
            facts.extend(bounds(pi, rational(333, 106), rational(22, 7), Seen::Positive));
        }
        facts.iter().map(|(fact, seen)| Ok((self.signed(fact)?, *seen))).collect()
    }

    /// Returns the visible sign of an expression as written, from its sums, products and even
    /// powers, and from facts.
    pub(crate) fn seen(
        &mut self,
        pool: &mut Pool,
        root: Expr,
        conditions: &[Condition],
    ) -> Result<Seen, Stop> {
        let facts = self.facts(pool, conditions)?;
        let of_fact = |polynomial: Polynomial| product_of(&facts, polynomial);
        let mut visible: HashMap<Expr, Seen> = HashMap::new();
        for part in pool.parts(&[root]) {
            let (operation, operands) = (pool.node(part).0.clone(), pool.node(part).1.to_vec());
            let of = |place: usize| visible[&operands[place]];
            let least = || operands.iter().map(|operand| visible[operand]).min().unwrap_or(Seen::Nothing);
            let seen = match &operation {
                Number(value) if *value == rational(0, 1) => Seen::NotNegative,
                Number(value) if *value > rational(0, 1) => Seen::Positive,
                Pi | Function("exp") => Seen::Positive,
                Function("abs") => of(0).max(Seen::NotNegative),
                Multiply if operands[0] == operands[1] => of(0).max(Seen::NotNegative),
                Add if least() > Seen::Nothing => of(0).max(of(1)),
                Multiply | Divide => least(),
                Power(p, q) if p % 2 == 0 || *q > 1 => of(0).max(Seen::NotNegative),
                Power(..) => of(0),
                Function(name @ ("sin" | "cos" | "tan")) => {
                    // bounds of the angle a in quarter turns: 0 ≤ a ≤ π, −π/2 ≤ a ≤ π/2 and 0 ≤ a ≤
                    // π/2
                    let (from, to) = match *name {
                        "sin" => (0, 2),
                        "cos" => (-1, 1),
                        _ => (0, 1),
                    };
                    let (above, below) =
                        (self.beyond(pool, operands[0], 1, -from)?, self.beyond(pool, operands[0], -1, to)?);
                    let above = if from == 0 { of(0).max(of_fact(above)) } else { of_fact(above) };
                    above.min(of_fact(below))
                }
                _ => Seen::Nothing,
            };
            let seen = if seen == Seen::Positive {
                seen
            } else {
                let element = self.element(pool, part)?;
                seen.max(of_fact(self.signed(&element)?))
            };
            visible.insert(part, seen);
        }
        Ok(visible[&root])
    }

    /// Whether a relation is visible, from q as written or because q is a product of nonzero
    /// factors.
    pub(crate) fn shows(
        &mut self,
        pool: &mut Pool,
        (q, relation): Condition,
        known: &[Condition],
    ) -> Result<bool, Stop> {
        match relation {
            Relation::Positive => Ok(self.seen(pool, q, known)? == Seen::Positive),
            Relation::NotNegative => Ok(self.seen(pool, q, known)? >= Seen::NotNegative),
            Relation::NotZero => {
                let negated = pool.negate(q);
                Ok(self.seen(pool, q, known)? == Seen::Positive
                    || self.seen(pool, negated, known)? == Seen::Positive
                    || self.is_product_of_nonzero(pool, q, known)?)
            }
        }
    }

    /// Whether q reduces to a nonzero number when it is divided by the factors of expressions that
    /// conditions state to be nonzero.
    fn is_product_of_nonzero(&mut self, pool: &Pool, q: Expr, known: &[Condition]) -> Result<bool, Stop> {
        let mut rest = self.element(pool, q)?.numerator;
        for (expr, _) in known.iter().filter(|condition| condition.1 != Relation::NotNegative) {
            let Ok(element) = self.element(pool, *expr) else { continue };
            let factors = element.factors.keys().map(|factor| self.factor(*factor).clone());
            for divisor in std::iter::once(element.numerator.clone()).chain(factors.collect::<Vec<_>>()) {
                while divisor.as_constant().is_none() && rest.as_constant().is_none() {
                    let Some(quotient) = rest.divide(&divisor) else { break };
                    rest = quotient;
                }
            }
        }
        Ok(rest.as_constant().is_some_and(|c| c != rational(0, 1)))
    }

    /// Returns ±a plus `quarters` quarter turns.
    fn beyond(&mut self, pool: &mut Pool, a: Expr, sign: i64, quarters: i64) -> Result<Polynomial, Stop> {
        let (share, pi) = (pool.number(rational(quarters, 2)), pool.make(Pi, vec![]));
        let turn = pool.make(Multiply, vec![share, pi]);
        let signed = if sign < 0 { pool.negate(a) } else { a };
        let sum = pool.make(Add, vec![signed, turn]);
        let sum = self.element(pool, sum)?;
        self.signed(&sum)
    }

    fn constraints(&mut self, pool: &Pool, conditions: &[Condition]) -> Vec<Constraint> {
        let mut found = Vec::new();
        for (expr, relation) in conditions {
            // a condition without information about bases only leaves more cases
            let Ok(element) = self.element(pool, *expr) else { continue };
            let Ok(mut factored) = self.factored(&element) else { continue };
            let front = if factored.constant < rational(0, 1) { -1 } else { 1 };
            factored.powers.retain(|_, (exponent, odd)| *odd || *exponent.numer() != 0);
            let odd = factored.powers.iter().filter(|power| power.1.1).map(|power| *power.0).collect();
            found.push(Constraint {
                relation: *relation,
                front,
                odd,
                all: factored.powers.into_keys().collect(),
            });
        }
        found
    }

    /// Checks that the cases cover every point: every combination of signs −, 0, + of the split
    /// bases that the conditions allow must lie in a case or on its boundary.
    pub(crate) fn check_cover(
        &mut self,
        pool: &Pool,
        conditions: &[Condition],
        split: &[usize],
        cases: &[Vec<i64>],
    ) -> Result<(), Stop> {
        if split.len() > MOST_SPLIT {
            return uncovered("this many undetermined signs");
        }
        let constraints = self.constraints(pool, conditions);
        for number in 0..3_usize.pow(split.len() as u32) {
            let digit = |place: usize| (number / 3_usize.pow(place as u32) % 3) as i64 - 1;
            let stratum: Vec<i64> = (0..split.len()).map(digit).collect();
            let known =
                |place: usize| self.bases[split[place]].sign.unwrap_or(stratum[place]) * stratum[place] >= 0;
            let is_possible = (0..split.len()).all(known)
                && constraints.iter().all(|constraint| self.allows(constraint, split, &stratum));
            let touches =
                |case: &Vec<i64>| case.iter().zip(&stratum).all(|(sign, at)| *at == 0 || at == sign);
            if is_possible && !cases.iter().any(touches) {
                return rejected(format!("no case for the signs {stratum:?}"));
            }
        }
        Ok(())
    }

    fn allows(&self, constraint: &Constraint, split: &[usize], stratum: &[i64]) -> bool {
        let at = |base: &usize| split.iter().position(|b| b == base).map(|place| stratum[place]);
        let strict = constraint.relation != Relation::NotNegative;
        if constraint.all.iter().any(|base| at(base) == Some(0)) {
            return !strict;
        }
        let mut product = constraint.front;
        for base in &constraint.odd {
            // a base that is not split can vanish, which only a strict relation excludes
            match at(base).or(self.bases[*base].sign.filter(|_| strict)) {
                Some(sign) => product *= sign,
                None => return true,
            }
        }
        let others = |base: &usize| at(base).is_none();
        product > 0
            || constraint.relation == Relation::NotZero
            || (!strict && constraint.all.iter().any(others))
    }
}
