//! Ranges of sums of inverse trigonometric functions: principal values, narrowed by the signs of
//! the arguments.

use super::facts::Facts;
use super::range::{End, Range};
use crate::expression::Operation;
use crate::normal::{Fraction, Obstacle, Sign, Tower};
use crate::polynomial::Polynomial;
use num_rational::BigRational;
use num_traits::One;

impl Facts {
    /// Returns the range of a rational combination of inverse functions, of quantities and of π.
    pub(crate) fn range(&self, tower: &mut Tower, angle: &Fraction) -> Result<Range, Obstacle> {
        let mut range = Range::of_pi((0, 1, false), (0, 1, false));
        let mut rest = Vec::new();
        for (quantity, coefficient) in tower.linear_parts(angle)? {
            match (tower.arc_of(&quantity), quantity.as_monomial()) {
                (Some((operation, arguments)), _) => {
                    let principal = self.principal_values(tower, operation, &arguments);
                    range = range.add(&principal.scaled(&coefficient));
                }
                (None, Some(monomial)) => rest.push((monomial.to_vec(), coefficient)),
                (None, None) => return Ok(Range::default()),
            }
        }
        Ok(range.add(&self.range_of_terms(tower.pi(), rest)))
    }

    /// Returns the range of Σ c m: from conditions, or else term by term from the bounds of single
    /// generators.
    fn range_of_terms(&self, pi: Option<u32>, terms: Vec<(Vec<(u32, u32)>, BigRational)>) -> Range {
        let known = self.ranges.of(pi, terms.clone());
        if known.lower.is_some() && known.upper.is_some() {
            return known;
        }
        let zero = Range::of_pi((0, 1, false), (0, 1, false));
        let apart = terms.into_iter().fold(zero, |sum, (monomial, coefficient)| {
            let one = self.ranges.of(pi, [(monomial.clone(), BigRational::one())]);
            let (lower, upper) = match monomial.as_slice() {
                [(variable, 1)] => self.bounds(*variable),
                _ => (None, None),
            };
            let end = |known: Option<End>, bound: Option<&BigRational>| known.or(bound.map(End::number));
            let term = Range { lower: end(one.lower, lower), upper: end(one.upper, upper) };
            sum.add(&term.scaled(&coefficient))
        });
        Range { lower: known.lower.or(apart.lower), upper: known.upper.or(apart.upper) }
    }

    /// Returns the principal range of an inverse function: atan q ∈ (−π/2, π/2), asin q ∈ [−π/2,
    /// π/2], acos q ∈ [0, π], atan2(y, x) ∈ (−π, π) off its branch cut, each restricted by the
    /// signs of its arguments.
    fn principal_values(&self, tower: &Tower, operation: Operation, arguments: &[Fraction]) -> Range {
        use Sign::{Negative, Positive};
        let signs: Vec<Option<Sign>> = arguments.iter().map(|q| self.sign_of_fraction(tower, q)).collect();
        let (down, zero, up) = ((-1, 2), (0, 1), (1, 2));
        let range = |(p, q): (i64, i64), open: bool, (r, s): (i64, i64), also: bool| {
            Range::of_pi((p, q, open), (r, s, also))
        };
        match (operation, signs.as_slice()) {
            (Operation::Atan, [Some(Positive)]) => range(zero, false, up, true),
            (Operation::Atan, [Some(Negative)]) => range(down, true, zero, false),
            (Operation::Atan, _) => range(down, true, up, true),
            (Operation::Asin, [Some(Positive)]) => range(zero, false, up, false),
            (Operation::Asin, [Some(Negative)]) => range(down, false, zero, false),
            (Operation::Asin, _) => range(down, false, up, false),
            (Operation::Acos, [Some(Positive)]) => range(zero, false, up, false),
            (Operation::Acos, [Some(Negative)]) => range(up, false, (1, 1), false),
            (Operation::Acos, _) => range(zero, false, (1, 1), false),
            (_, [Some(Positive), Some(Positive)]) => range(zero, false, up, false),
            (_, [Some(Negative), Some(Positive)]) => range(down, false, zero, false),
            (_, [_, Some(Positive)]) => range(down, false, up, false),
            (_, [Some(Positive), Some(Negative)]) => range(up, false, (1, 1), true),
            (_, [Some(Negative), Some(Negative)]) => range((-1, 1), true, down, false),
            (_, [Some(Positive), None]) => range(zero, false, (1, 1), true),
            (_, [Some(Negative), None]) => range((-1, 1), true, zero, false),
            _ => range((-1, 1), true, (1, 1), true),
        }
    }

    /// Returns the sign of a fraction from the signs of its factors, if they can be shown.
    pub(super) fn sign_of_fraction(&self, tower: &Tower, q: &Fraction) -> Option<Sign> {
        let mut negative = self.is_negative(q.numerator())?;
        for (polynomial, exponent) in tower.factors_of(q) {
            if exponent % 2 != 0 {
                negative ^= self.is_negative(polynomial)?;
            }
        }
        Some(if negative { Sign::Negative } else { Sign::Positive })
    }

    /// Whether a polynomial is ≤ 0 (true) or ≥ 0 (false), as a whole or as a product of variables
    /// and a remaining factor.
    fn is_negative(&self, polynomial: &Polynomial) -> Option<bool> {
        let of = |polynomial: &Polynomial| self.sign_of(polynomial).map(|sign| sign == Sign::Negative);
        if let Some(known) = of(polynomial) {
            return Some(known);
        }
        let monomial = polynomial.monomial_content();
        let rest = polynomial.divide_by_monomial(&monomial)?;
        let mut negative = of(&rest)?;
        for (variable, exponent) in monomial {
            if exponent % 2 != 0 {
                negative ^= of(&Polynomial::variable(variable))?;
            }
        }
        Some(negative)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::expression::Relation;
    use crate::expression::{Pool, SymbolKind};
    use crate::normal::{Trigonometry, normalise};
    use std::cmp::Ordering;

    /// Signs of the arguments of inverse functions, and their values as fractions of π.
    const VALUES: &[(Operation, &[i64], (i64, i64))] = &[
        (Operation::Atan, &[1], (1, 4)),
        (Operation::Atan, &[-1], (-1, 4)),
        (Operation::Asin, &[1], (1, 2)),
        (Operation::Asin, &[-1], (-1, 2)),
        (Operation::Acos, &[1], (0, 1)),
        (Operation::Acos, &[-1], (1, 1)),
        (Operation::Atan2, &[1, 1], (1, 4)),
        (Operation::Atan2, &[1, -1], (3, 4)),
        (Operation::Atan2, &[-1, 1], (-1, 4)),
        (Operation::Atan2, &[-1, -1], (-3, 4)),
        (Operation::Atan2, &[0, 1], (0, 1)),
        (Operation::Atan2, &[1, 0], (1, 2)),
        (Operation::Atan2, &[-1, 0], (-1, 2)),
    ];

    /// Returns the range of an inverse function of variables, some of which have known signs.
    fn range_of(operation: Operation, signs: &[Option<i64>]) -> Range {
        let mut pool = Pool::new();
        let arguments: Vec<_> = (0..signs.len())
            .map(|place| {
                let symbol = pool.declare_symbol(format!("x{place}"), SymbolKind::Coordinate);
                pool.symbol(symbol)
            })
            .collect();
        let arc = pool.apply(operation, &arguments);
        let all: Vec<_> = arguments.iter().copied().chain([arc]).collect();
        let mut tower = Tower::new(Trigonometry::Circle);
        let fractions = normalise(&mut tower, &pool, &all)
            .and_then(|prepared| prepared.exact(&mut tower, &pool))
            .expect("variables and one function");
        let mut facts = Facts::of(&tower);
        for (sign, fraction) in signs.iter().zip(&fractions) {
            match sign {
                Some(1) => facts.learn(&tower, fraction, Relation::GreaterEqual),
                Some(_) => facts.learn(&tower, fraction, Relation::LessEqual),
                None => {}
            }
        }
        facts.range(&mut tower, &fractions[signs.len()]).expect("a range")
    }

    #[test]
    fn the_range_of_an_inverse_function_holds_its_values_for_every_choice_of_known_signs() {
        for &(operation, point, (p, q)) in VALUES {
            for known in 0..1_usize << point.len() {
                let signs = point.iter().enumerate().map(|(place, &sign)| {
                    (known >> place & 1 == 1).then_some(if sign == 0 { 1 } else { sign })
                });
                let signs: Vec<Option<i64>> = signs.collect();
                let range = range_of(operation, &signs);
                let value = End::of_pi(p, q, false);
                let lower = range.lower.expect("a bound").compare(&value);
                let upper = range.upper.expect("a bound").compare(&value);
                assert!(
                    matches!(lower, Some(Ordering::Less | Ordering::Equal))
                        && matches!(upper, Some(Ordering::Greater | Ordering::Equal)),
                    "{operation:?} at {point:?} with {signs:?}"
                );
            }
        }
    }

    #[test]
    fn a_known_sign_halves_the_range() {
        assert!(range_of(Operation::Atan, &[Some(-1)]).is_within(1, 2));
        assert!(!range_of(Operation::Acos, &[Some(1)]).is_within(1, 2));
        assert!(range_of(Operation::Acos, &[Some(1)]).is_within(2, 3));
        assert!(range_of(Operation::Atan2, &[Some(-1), Some(1)]).is_within(2, 3));
        assert!(!range_of(Operation::Atan2, &[Some(-1), None]).is_within(2, 3));
    }
}
