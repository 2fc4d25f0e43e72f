//! Signs: polynomials that are visibly not negative, and cases of signs that leave no point out.

use crate::expression::Operation::{Add, Divide, Function, Multiply, Number, Pi, Power};
use crate::expression::{Expr, Pool, rational};
use crate::field::{Base, Field, Fraction, Kind};
use crate::polynomial::Polynomial;
use crate::theory::{Condition, Relation};
use crate::{Stop, rejected, uncovered};
use std::collections::HashMap;

/// More bases than this are not told apart at once.
const MOST_SPLIT: usize = 8;

/// What a condition says of bases: the sign of a product of odd powers, where none of `all` vanishes.
struct Constraint {
    relation: Relation,
    front: i64,
    odd: Vec<usize>,
    all: Vec<usize>,
}

impl Field {
    /// N ∏ F^odd, which has the sign of N / ∏ Fᵉ, up to a positive number.
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

    /// What is not negative: conditions, bounds of π, sines and cosines, bases with their signs.
    fn facts(&mut self, pool: &Pool, conditions: &[Condition]) -> Result<Vec<Polynomial>, Stop> {
        let mut facts: Vec<Fraction> = Vec::new();
        for (expr, _) in conditions.iter().filter(|condition| condition.1 != Relation::NotZero) {
            facts.extend(self.element(pool, *expr));
        }
        let signed = |base: &Base| Some(base.polynomial.clone().scale(&rational(base.sign?, 1)).into());
        facts.extend(self.bases.iter().filter_map(signed));
        let bounds = |generator: usize, low, high| {
            let itself = Polynomial::generator(generator, 1);
            let negated = itself.clone().scale(&rational(-1, 1));
            let (low, high) = (Polynomial::constant(low), Polynomial::constant(high));
            [itself.add(&low.scale(&rational(-1, 1))).into(), negated.add(&high).into()]
        };
        for unit in self.units.iter().filter(|unit| unit.kind == Kind::Circle) {
            for generator in [unit.generator, unit.generator + 1] {
                facts.extend::<[Fraction; 2]>(bounds(generator, rational(-1, 1), rational(1, 1)));
            }
        }
        if let Some(pi) = self.generators.iter().position(|generator| matches!(generator, Some((Pi, _)))) {
            facts.extend::<[Fraction; 2]>(bounds(pi, rational(333, 106), rational(22, 7)));
        }
        facts.iter().map(|fact| self.signed(fact)).collect()
    }

    /// Whether an expression is not negative, as it is written: sums, products and even powers of such, or facts.
    pub(crate) fn is_visibly_positive(
        &mut self,
        pool: &mut Pool,
        root: Expr,
        conditions: &[Condition],
    ) -> Result<bool, Stop> {
        let facts = self.facts(pool, conditions)?;
        let mut visible: HashMap<Expr, bool> = HashMap::new();
        for part in pool.parts(&[root]) {
            let (operation, operands) = (pool.node(part).0.clone(), pool.node(part).1.to_vec());
            let all = operands.iter().all(|operand| visible[operand]);
            let seen = match &operation {
                Number(value) => *value >= rational(0, 1),
                Pi | Function("exp" | "abs") => true,
                Multiply => all || operands[0] == operands[1],
                Add | Divide => all,
                Power(p, q) => all || p % 2 == 0 || *q > 1,
                Function("tan") => {
                    // 0 ≤ a ≤ π/2
                    let (half, pi) = (pool.number(rational(1, 2)), pool.make(Pi, vec![]));
                    let (quarter, negated) = (pool.make(Multiply, vec![half, pi]), pool.negate(operands[0]));
                    let rest = pool.make(Add, vec![quarter, negated]);
                    let rest = self.element(pool, rest)?;
                    all && facts.contains(&self.signed(&rest)?)
                }
                _ => false,
            };
            let seen = seen || {
                let element = self.element(pool, part)?;
                facts.contains(&self.signed(&element)?)
            };
            visible.insert(part, seen);
        }
        Ok(visible[&root])
    }

    fn constraints(&mut self, pool: &Pool, conditions: &[Condition]) -> Vec<Constraint> {
        let mut found = Vec::new();
        for (expr, relation) in conditions {
            // a condition that says nothing about bases leaves only more cases
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

    /// Every choice of signs −, 0, + for the split bases that the conditions allow has to lie in a case, on its
    /// border perhaps: the cases then cover every point.
    pub(crate) fn check_cover(
        &mut self,
        pool: &Pool,
        conditions: &[Condition],
        split: &[usize],
        cases: &[Vec<i64>],
    ) -> Result<(), Stop> {
        if split.len() > MOST_SPLIT {
            return uncovered("so many open signs");
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
            // a base that is not split may vanish, which only a strict relation excludes
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
