//! Signs of polynomials, proved: by bounds of the generators, by terms that cannot be negative, by squares.
//!
//! Never sampled. An answer σ means σ·g ≥ 0 wherever the assumptions hold.

use super::range::Ranges;
use crate::normal::{Fraction, Generator, Sign, Tower};
use crate::polynomial::Polynomial;
use crate::syntax::ast::Relation;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use rustc_hash::FxHashMap;

/// A polynomial with more variables than this is not tried as a sum of squares.
const MOST_SQUARES: usize = 12;

/// Moving bounds to zero multiplies terms; beyond this degree it is not tried.
const HIGHEST_DEGREE: u32 = 12;

/// Bounds of generators by numbers.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facts {
    lower: FxHashMap<u32, BigRational>,
    upper: FxHashMap<u32, BigRational>,
    ranges: Ranges,
    /// Other polynomials whose signs are given.
    given: Vec<(Polynomial, Sign)>,
}

impl Facts {
    /// What holds of every generator by its nature: roots and exponentials are positive.
    pub(crate) fn of(tower: &Tower) -> Self {
        let mut facts = Facts::default();
        for variable in 0..tower.generator_count() {
            match tower.generator(variable) {
                Generator::Root { .. } | Generator::Exponential(_) => {
                    facts.at_least(variable, BigRational::zero());
                }
                Generator::Pi => {
                    facts.at_least(variable, BigRational::new(333.into(), 106.into()));
                    facts.at_most(variable, BigRational::new(22.into(), 7.into()));
                }
                Generator::Cosine(_) | Generator::Sine(_) => {
                    facts.at_least(variable, -BigRational::one());
                    facts.at_most(variable, BigRational::one());
                }
                _ => {}
            }
        }
        facts
    }

    /// Learns from `difference relation 0` if it bounds one generator by a number, or from above by π.
    pub(crate) fn learn(&mut self, tower: &Tower, difference: &Fraction, relation: Relation) {
        self.ranges.learn(tower.pi(), difference, relation);
        let Some(difference) = difference.as_polynomial() else { return };
        let up = matches!(relation, Relation::Greater | Relation::GreaterEqual);
        if relation == Relation::NotEqual {
            return;
        }
        let mut linear: Vec<(u32, BigInt)> = Vec::new();
        let mut constant = BigInt::zero();
        for (monomial, coefficient) in difference.terms() {
            match monomial.as_slice() {
                [] => constant = coefficient,
                [(variable, 1)] => linear.push((*variable, coefficient)),
                _ => return,
            }
        }
        // a v + c > 0
        if let [(variable, slope)] = linear.as_slice() {
            let bound = BigRational::new(-&constant, slope.clone());
            self.bound(*variable, up == slope.is_positive(), bound);
        }
    }

    /// Half-angle tangents keep between the tangents of the ends of their angles, as far as these stay between two
    /// poles; where the angle is nearer to a pole than to a zero, t² ≥ 1.
    pub(crate) fn learn_half_tangents(&mut self, tower: &Tower) {
        for variable in 0..tower.generator_count() {
            let Generator::HalfTangent(unit) = tower.generator(variable) else { continue };
            let Some(monomial) = unit.as_monomial() else { continue };
            let part = BigRational::new(1.into(), (2 * unit.divisor()).into());
            let range = self.ranges.of(tower.pi(), [(monomial.to_vec(), part)]);
            if range.modulo_pi((1, 2)).is_within(1, 4) {
                let square = Polynomial::variable(variable).square();
                self.give(square.sub(&Polynomial::one()), Sign::Positive);
            }
            let (lower, upper) = range.modulo_pi((0, 1)).tangents();
            lower.into_iter().for_each(|lower| self.at_least(variable, lower));
            upper.into_iter().for_each(|upper| self.at_most(variable, upper));
        }
    }

    /// What is known of combinations of quantities.
    pub(crate) fn ranges(&self) -> &Ranges {
        &self.ranges
    }

    /// Remembers the sign of a polynomial.
    pub(crate) fn give(&mut self, polynomial: Polynomial, sign: Sign) {
        self.given.push((polynomial, sign));
    }

    /// A generator whose bounds leave no value, if there is one.
    pub(crate) fn contradiction(&self) -> bool {
        self.lower.iter().any(|(variable, lower)| self.upper.get(variable).is_some_and(|upper| lower > upper))
    }

    fn bound(&mut self, variable: u32, from_below: bool, bound: BigRational) {
        if from_below {
            self.at_least(variable, bound);
        } else {
            self.at_most(variable, bound);
        }
    }

    fn at_least(&mut self, variable: u32, bound: BigRational) {
        let entry = self.lower.entry(variable).or_insert_with(|| bound.clone());
        if bound > *entry {
            *entry = bound;
        }
    }

    fn at_most(&mut self, variable: u32, bound: BigRational) {
        let entry = self.upper.entry(variable).or_insert_with(|| bound.clone());
        if bound < *entry {
            *entry = bound;
        }
    }

    /// The sign of a polynomial, if it can be shown.
    pub(crate) fn sign_of(&self, polynomial: &Polynomial) -> Option<Sign> {
        if let Some((_, sign)) = self.given.iter().find(|entry| entry.0 == *polynomial) {
            return Some(*sign);
        }
        if self.never_negative(polynomial) {
            return Some(Sign::Positive);
        }
        if self.never_negative(&polynomial.neg()) {
            return Some(Sign::Negative);
        }
        None
    }

    /// Whether a polynomial keeps away from zero: g − c ≥ 0 or −g − c ≥ 0 for its constant term ±c, c > 0.
    pub(crate) fn never_zero(&self, polynomial: &Polynomial) -> bool {
        let constant = polynomial.terms().find(|(monomial, _)| monomial.is_empty()).map(|(_, c)| c);
        constant.is_some_and(|constant| {
            let rest = polynomial.sub(&Polynomial::constant(constant.clone()));
            let signed = if constant.is_negative() { rest.neg() } else { rest };
            self.never_negative(&signed)
        })
    }

    fn never_negative(&self, polynomial: &Polynomial) -> bool {
        self.terms_are_never_negative(polynomial)
            || is_positive_semidefinite(polynomial)
            || self.moved_to_zero(polynomial).is_some_and(|moved| terms_never_negative(&moved, |_| true))
    }

    fn terms_are_never_negative(&self, polynomial: &Polynomial) -> bool {
        terms_never_negative(polynomial, |variable| {
            self.lower.get(&variable).is_some_and(|lower| !lower.is_negative())
        })
    }

    /// Bounded variables replaced by ones that are only known to be positive:
    /// v = l + w, v = u − w, or v = (l + u w)/(1 + w), times (1 + w)^deg. Free ones must occur evenly.
    fn moved_to_zero(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        if polynomial.total_degree() > HIGHEST_DEGREE {
            return None;
        }
        let mut moved = polynomial.clone();
        for variable in polynomial.variables() {
            moved = match (self.lower.get(&variable), self.upper.get(&variable)) {
                (None, None) => return None,
                (Some(lower), None) => moebius(&moved, variable, lower, None, 1),
                (None, Some(upper)) => moebius(&moved, variable, upper, None, -1),
                (Some(lower), Some(upper)) => moebius(&moved, variable, lower, Some(upper), 1),
            };
        }
        Some(moved)
    }
}

/// Whether every term is a non-negative number times squares and variables that are not negative.
fn terms_never_negative(polynomial: &Polynomial, positive: impl Fn(u32) -> bool) -> bool {
    polynomial.terms().all(|(monomial, coefficient)| {
        coefficient.is_positive()
            && monomial.iter().all(|&(variable, exponent)| exponent % 2 == 0 || positive(variable))
    })
}

/// Substitutes v = from ± w, or v = (from + to·w)/(1 + w), and clears denominators by positive factors.
fn moebius(
    polynomial: &Polynomial,
    variable: u32,
    from: &BigRational,
    to: Option<&BigRational>,
    direction: i64,
) -> Polynomial {
    let w = Polynomial::variable(variable);
    let scale = match to {
        Some(to) => from.denom() * to.denom(),
        None => from.denom().clone(),
    };
    let scaled = |value: &BigRational| {
        Polynomial::constant((value * BigRational::from_integer(scale.clone())).to_integer())
    };
    let (above, below) = match to {
        Some(to) => (scaled(from).add(&scaled(to).mul(&w)), Polynomial::one().add(&w).scale(&scale)),
        None => {
            let step = w.scale(&(&scale * BigInt::from(direction)));
            (scaled(from).add(&step), Polynomial::constant(scale.clone()))
        }
    };
    let degree = polynomial.degree(variable);
    polynomial.coefficients_in(variable).into_iter().fold(
        Polynomial::zero(),
        |sum, (exponent, coefficient)| {
            let powers = above.pow(exponent).mul(&below.pow(degree - exponent));
            sum.add(&coefficient.mul(&powers))
        },
    )
}

/// Whether a polynomial of degree 2 is a sum of squares: its symmetric matrix has only non-negative pivots.
fn is_positive_semidefinite(polynomial: &Polynomial) -> bool {
    let variables = polynomial.variables();
    if polynomial.total_degree() > 2 || variables.len() > MOST_SQUARES {
        return false;
    }
    let size = variables.len() + 1;
    let place = |variable: u32| variables.iter().position(|&v| v == variable).unwrap_or(size - 1);
    let mut matrix = vec![vec![BigRational::zero(); size]; size];
    for (monomial, coefficient) in polynomial.terms() {
        let (i, j) = match monomial.as_slice() {
            [] => (size - 1, size - 1),
            [(v, 1)] => (place(*v), size - 1),
            [(v, _)] => (place(*v), place(*v)),
            [(v, _), (w, _), ..] => (place(*v), place(*w)),
        };
        let half = BigRational::new(coefficient, 2.into());
        matrix[i][j] += &half;
        matrix[j][i] += half;
    }
    pivots_are_not_negative(matrix)
}

/// Symmetric elimination; a zero pivot needs a zero row.
fn pivots_are_not_negative(mut matrix: Vec<Vec<BigRational>>) -> bool {
    let size = matrix.len();
    for k in 0..size {
        let pivot = matrix[k][k].clone();
        if pivot.is_negative() {
            return false;
        }
        if pivot.is_zero() {
            if matrix[k][k..].iter().any(|entry| !entry.is_zero()) {
                return false;
            }
            continue;
        }
        for i in k + 1..size {
            let factor = &matrix[i][k] / &pivot;
            let pivot_row = matrix[k].clone();
            for (entry, above) in matrix[i].iter_mut().zip(&pivot_row).skip(k + 1) {
                *entry -= &factor * above;
            }
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polynomial(terms: &[(&[(u32, u32)], i64)]) -> Polynomial {
        Polynomial::from_terms(terms.iter().map(|(m, c)| (m.to_vec(), BigInt::from(*c))))
    }

    #[test]
    fn a_quadratic_is_a_sum_of_squares_exactly_if_it_is_never_negative() {
        let (xx, xy, yy, x, one): (&[_], &[_], &[_], &[_], &[_]) =
            (&[(0, 2)], &[(0, 1), (1, 1)], &[(1, 2)], &[(0, 1)], &[]);
        let never_negative = [
            polynomial(&[(xx, 1), (xy, -1), (yy, 1)]),
            polynomial(&[(xx, 1), (xy, -2), (yy, 1)]),
            polynomial(&[(xx, 1), (x, 2), (one, 1)]),
        ];
        let sometimes = [
            polynomial(&[(xx, 1), (xy, -3), (yy, 1)]),
            polynomial(&[(xx, 1), (x, 3), (one, 1)]),
            polynomial(&[(xx, 1), (yy, -1)]),
            polynomial(&[(x, 1)]),
            polynomial(&[(xy, 1)]),
        ];
        let facts = Facts::default();
        assert!(never_negative.iter().all(|p| facts.sign_of(p) == Some(Sign::Positive)));
        assert!(sometimes.iter().all(|p| facts.sign_of(p).is_none()));
    }

    #[test]
    fn bounds_decide_signs_inside_them_and_not_outside() {
        let x_minus_one = polynomial(&[(&[(0, 1)], 1), (&[], -1)]);
        let x_plus_one = polynomial(&[(&[(0, 1)], 1), (&[], 1)]);
        let mut facts = Facts::default();
        facts.at_least(0, BigRational::from_integer(1.into()));
        assert_eq!(facts.sign_of(&x_minus_one), Some(Sign::Positive));
        assert_eq!(facts.sign_of(&x_plus_one), Some(Sign::Positive));
        let mut facts = Facts::default();
        facts.at_most(0, BigRational::from_integer(1.into()));
        assert_eq!(facts.sign_of(&x_minus_one), Some(Sign::Negative));
        assert_eq!(facts.sign_of(&x_plus_one), None);
    }

    #[test]
    fn a_product_of_distances_from_both_ends_is_positive_between_them() {
        // x (1 − x) for 0 ≤ x ≤ 1
        let product = polynomial(&[(&[(0, 1)], 1), (&[(0, 2)], -1)]);
        let mut facts = Facts::default();
        facts.at_least(0, BigRational::zero());
        facts.at_most(0, BigRational::one());
        assert_eq!(facts.sign_of(&product), Some(Sign::Positive));
    }
}
