//! Signs of polynomials, proved: by bounds of the generators, by terms that cannot be negative, by
//! squares, by combinations of known inequalities, by norms.
//!
//! Signs are never sampled. An answer σ means σ·g ≥ 0 wherever the assumptions hold. With a root ρ
//! of f, A + Bρ ≥ 0 follows from A, B ≥ 0, from A ≥ 0 and A² − B² f ≥ 0, and from B ≥ 0 and A² − B²
//! f ≤ 0.

use super::facts::Facts;
use super::linear::{Inequality, follows};
use crate::normal::Sign;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// Largest number of variables of a polynomial that is tried as a sum of squares.
const MOST_SQUARES: usize = 12;

/// Highest degree at which bounds are moved to zero, which multiplies the number of terms.
const HIGHEST_DEGREE: u32 = 12;

/// Polynomials with more terms are not written as combinations, decomposed by roots, or factored.
const MOST_TERMS: usize = 40;

/// Largest number of inequalities of which products are formed.
const MOST_MULTIPLIED: usize = 8;

/// Largest number of nested roots through which a sign is traced.
const MOST_ROOTS: u32 = 4;

impl Facts {
    /// Returns the sign of a polynomial, if it can be shown.
    pub(crate) fn sign_of(&self, polynomial: &Polynomial) -> Option<Sign> {
        if self.never_negative(polynomial) {
            return Some(Sign::Positive);
        }
        if self.never_negative(&polynomial.neg()) {
            return Some(Sign::Negative);
        }
        None
    }

    /// Whether a polynomial is bounded away from zero: g − c ≥ 0 or −g − c ≥ 0 for its constant
    /// term ±c, c > 0.
    pub(crate) fn never_zero(&self, polynomial: &Polynomial) -> bool {
        let constant = polynomial.terms().find(|(monomial, _)| monomial.is_empty()).map(|(_, c)| c);
        constant.is_some_and(|constant| {
            let rest = polynomial.sub(&Polynomial::constant(constant.clone()));
            let signed = if constant.is_negative() { rest.neg() } else { rest };
            self.never_negative(&signed)
        })
    }

    pub(super) fn never_negative(&self, polynomial: &Polynomial) -> bool {
        self.never_negative_through(polynomial, MOST_ROOTS)
    }

    fn never_negative_through(&self, polynomial: &Polynomial, roots: u32) -> bool {
        if self.terms_are_never_negative(polynomial)
            || is_positive_semidefinite(polynomial)
            || self.moved_to_zero(polynomial).is_some_and(|moved| self.bounded_terms_never_negative(&moved))
        {
            return true;
        }
        polynomial.term_count() <= MOST_TERMS
            && (self.exponents_show(polynomial, roots)
                || self.is_combination(polynomial)
                || self.is_square_beside_known(polynomial)
                || self.norm_shows(polynomial, roots)
                || self.factors_show(polynomial, roots))
    }

    /// Whether b exp u − c exp v ≥ 0 because b ≥ c > 0 and u ≥ v, with products of exponentials.
    fn exponents_show(&self, polynomial: &Polynomial, roots: u32) -> bool {
        let mut terms: Vec<(Vec<(u32, u32)>, BigInt)> = polynomial.terms().collect();
        terms.sort_by(|a, b| b.1.cmp(&a.1));
        let [(above, b), (below, c)] = terms.as_slice() else { return false };
        if roots == 0 || !c.is_negative() || *b < -c {
            return false;
        }
        let scale = self.exponents.values().fold(1, |scale, (_, divisor)| num_integer::lcm(scale, *divisor));
        let exponent = |monomial: &[(u32, u32)]| {
            monomial.iter().try_fold(Polynomial::zero(), |sum, (variable, times)| {
                let (exponent, divisor) = self.exponents.get(variable)?;
                let parts = BigInt::from(*times) * (scale / divisor);
                Some(sum.add(&exponent.scale(&parts)))
            })
        };
        let (Some(u), Some(v)) = (exponent(above), exponent(below)) else { return false };
        self.never_negative_through(&u.sub(&v), roots - 1)
    }

    /// Whether the polynomial is a combination of known inequalities or, for a polynomial of higher
    /// degree, also of products of two of them.
    fn is_combination(&self, polynomial: &Polynomial) -> bool {
        if self.inequalities.is_empty() {
            return false;
        }
        let mut known = self.known();
        let degree = polynomial.total_degree();
        let variables = polynomial.variables();
        let speaks_of_it = |inequality: &&Inequality| {
            inequality.polynomial.variables().iter().all(|variable| variables.contains(variable))
        };
        let mut single: Vec<Inequality> = Vec::new();
        for inequality in known.iter().filter(speaks_of_it) {
            if single.iter().all(|other| other.polynomial != inequality.polynomial) {
                single.push(inequality.clone());
            }
        }
        if degree > 1 && single.len() <= MOST_MULTIPLIED {
            for (place, a) in single.iter().enumerate() {
                for b in single[..=place].iter().filter(|b| b.degree() + a.degree() <= degree) {
                    known.push(Inequality { polynomial: a.polynomial.mul(&b.polynomial), strict: false });
                }
            }
        }
        follows(polynomial, &known, |monomial| self.sign_of_monomial(monomial))
    }

    /// Whether p = λc + q with c known not to be negative, a number λ ≥ 0 and q a sum of squares,
    /// for the λ that the constant terms suggest: 1 − 2xy = (1 − x² − y²) + (x − y)².
    fn is_square_beside_known(&self, polynomial: &Polynomial) -> bool {
        let constant = |p: &Polynomial| p.terms().find(|(monomial, _)| monomial.is_empty()).map(|(_, c)| c);
        self.inequalities.iter().any(|Inequality { polynomial: known, .. }| {
            let (own, other) = match (constant(polynomial), constant(known)) {
                (Some(own), Some(other)) if own.sign() == other.sign() => (own.abs(), other.abs()),
                (None, None) => (1.into(), 1.into()),
                _ => return false,
            };
            is_positive_semidefinite(&polynomial.scale(&other).sub(&known.scale(&own)))
        })
    }

    /// Whether A + Bρᵏ ≥ 0 with ρ²ᵏ = f: both parts are ≥ 0, or the larger one is, as the norm
    /// shows.
    fn norm_shows(&self, polynomial: &Polynomial, roots: u32) -> bool {
        let last = polynomial.variables().into_iter().rev().find_map(|v| Some((v, self.roots.get(&v)?)));
        let Some((variable, root)) = last.filter(|_| roots > 0) else { return false };
        let (mut rational, mut slope) = (Polynomial::zero(), Polynomial::zero());
        for (exponent, coefficient) in polynomial.coefficients_in(variable) {
            match exponent {
                0 => rational = coefficient,
                _ if 2 * exponent == root.order => slope = coefficient,
                _ => return false,
            }
        }
        let shown = |p: &Polynomial| self.never_negative_through(p, roots - 1);
        let (above, rising) = (shown(&rational), shown(&slope));
        if above && rising {
            return true;
        }
        let norm = self.reduced(rational.square().sub(&slope.square().mul(&root.radicand)));
        norm.term_count() <= MOST_TERMS && (above && shown(&norm) || rising && shown(&norm.neg()))
    }

    /// Returns the polynomial with powers of roots replaced by their radicands.
    fn reduced(&self, polynomial: Polynomial) -> Polynomial {
        let mut reduced = polynomial;
        for variable in reduced.variables().into_iter().rev() {
            let Some(root) = self.roots.get(&variable) else { continue };
            reduced = reduced.coefficients_in(variable).into_iter().fold(
                Polynomial::zero(),
                |sum, (exponent, coefficient)| {
                    let rest = coefficient.multiply_by_monomial(&[(variable, exponent % root.order)]);
                    sum.add(&rest.mul(&root.radicand.pow(exponent / root.order)))
                },
            );
        }
        reduced
    }

    /// Whether the signs of the factors of odd multiplicity have a positive product; even powers do
    /// not matter.
    fn factors_show(&self, polynomial: &Polynomial, roots: u32) -> bool {
        if polynomial.total_degree() < 3 && polynomial.monomial_content().is_empty() {
            return false; // a square among these is semidefinite
        }
        let (content, factors) = polynomial.square_free();
        let odd: Vec<&Polynomial> =
            factors.iter().filter(|(_, n)| n % 2 == 1).map(|(part, _)| part).collect();
        let is_new = factors.len() > 1 || factors.iter().any(|(_, n)| *n > 1);
        if !is_new || roots == 0 {
            return false;
        }
        let mut negative = content.is_negative();
        for part in odd {
            if self.never_negative_through(&part.neg(), roots - 1) {
                negative = !negative;
            } else if !self.never_negative_through(part, roots - 1) {
                return false;
            }
        }
        !negative
    }

    fn terms_are_never_negative(&self, polynomial: &Polynomial) -> bool {
        terms_never_negative(polynomial, |variable| {
            self.lower.get(&variable).is_some_and(|lower| !lower.is_negative())
        })
    }

    fn bounded_terms_never_negative(&self, moved: &Polynomial) -> bool {
        terms_never_negative(moved, |v| self.lower.contains_key(&v) || self.upper.contains_key(&v))
    }

    /// Replaces bounded variables by variables that are only known to be positive: v = l + w, v = u
    /// − w, or v = (l + u w)/(1 + w), times (1 + w)^deg. Variables without bounds must occur in
    /// even powers.
    fn moved_to_zero(&self, polynomial: &Polynomial) -> Option<Polynomial> {
        if polynomial.total_degree() > HIGHEST_DEGREE {
            return None;
        }
        let mut moved = polynomial.clone();
        for variable in polynomial.variables() {
            moved = match (self.lower.get(&variable), self.upper.get(&variable)) {
                (None, None) => moved,
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

/// Substitutes v = from ± w, or v = (from + to·w)/(1 + w), and clears denominators by positive
/// factors.
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

/// Whether a polynomial of degree 2 is a sum of squares: its symmetric matrix has only non-negative
/// pivots.
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
    use num_traits::One;

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
