//! Linear certificates: a polynomial as a combination of known inequalities with positive
//! coefficients.
//!
//! ```text
//! p = Σ λᵢ cᵢ + Σ μⱼ σⱼ mⱼ + λ₀,   λ, μ ≥ 0        shows p ≥ 0 wherever every cᵢ ≥ 0
//! 0 = Σ λᵢ cᵢ + Σ μⱼ σⱼ mⱼ + λ₀,   Σ λ > 0         over strict cᵢ > 0 and λ₀: no point meets them
//! ```
//! The mⱼ are monomials of a known sign σⱼ. Both are linear programs in λ and μ, with one equation
//! for each monomial, solved exactly (by Farkas' lemma the search is complete among combinations of
//! this kind).

use crate::normal::Sign;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use std::collections::BTreeMap;

/// Programs with more equations or unknowns are not tried.
const MOST_ROWS: usize = 48;
const MOST_COLUMNS: usize = 96;

/// Limit on the steps of the simplex method.
const MOST_PIVOTS: usize = 400;

/// An inequality c ≥ 0, or c > 0 if it is strict.
#[derive(Clone, Debug)]
pub(super) struct Inequality {
    pub(super) polynomial: Polynomial,
    pub(super) strict: bool,
}

impl Inequality {
    pub(super) fn degree(&self) -> u32 {
        self.polynomial.total_degree()
    }
}

type Monomial = Vec<(u32, u32)>;

/// Whether p ≥ 0 follows from the known inequalities.
pub(super) fn follows(
    target: &Polynomial,
    known: &[Inequality],
    sign_of: impl Fn(&Monomial) -> Option<Sign>,
) -> bool {
    let reachable = |(monomial, coefficient): (Monomial, BigInt)| {
        let positive = coefficient.is_positive();
        let by_itself = if monomial.is_empty() { Some(Sign::Positive) } else { sign_of(&monomial) };
        by_itself.is_some_and(|sign| (sign == Sign::Positive) == positive)
            || known.iter().any(|inequality| {
                inequality.polynomial.terms().any(|(m, c)| m == monomial && c.is_positive() == positive)
            })
    };
    target.terms().all(reachable) && Program::new(known, target, &sign_of).solvable(target, None)
}

/// Whether no point meets the inequalities.
pub(super) fn contradict(known: &[Inequality], sign_of: impl Fn(&Monomial) -> Option<Sign>) -> bool {
    let zero = Polynomial::zero();
    let program = Program::new(known, &zero, sign_of);
    let strict: Vec<bool> = known.iter().map(|inequality| inequality.strict).collect();
    program.solvable(&zero, Some(&strict))
}

/// A linear program. Its columns are the inequalities, then 1, then the monomials of a known sign.
struct Program {
    rows: Vec<Monomial>,
    columns: Vec<BTreeMap<usize, BigRational>>,
}

impl Program {
    fn new(known: &[Inequality], target: &Polynomial, sign_of: impl Fn(&Monomial) -> Option<Sign>) -> Self {
        let mut places: BTreeMap<Monomial, usize> = BTreeMap::new();
        let mut rows: Vec<Monomial> = Vec::new();
        let all = known.iter().map(|inequality| &inequality.polynomial).chain([target]);
        for monomial in all.flat_map(|p| p.terms().map(|(m, _)| m)).chain([Vec::new()]) {
            places.entry(monomial.clone()).or_insert_with(|| {
                rows.push(monomial);
                rows.len() - 1
            });
        }
        let column = |p: &Polynomial| -> BTreeMap<usize, BigRational> {
            p.terms().map(|(m, c)| (places[&m], BigRational::from_integer(c))).collect()
        };
        let mut columns: Vec<_> = known.iter().map(|inequality| column(&inequality.polynomial)).collect();
        let alone = |row: usize, value: BigRational| BTreeMap::from([(row, value)]);
        columns.push(alone(places[&Vec::new()], BigRational::one()));
        for (row, monomial) in rows.iter().enumerate().filter(|(_, monomial)| !monomial.is_empty()) {
            columns.extend(sign_of(monomial).map(|sign| match sign {
                Sign::Positive => alone(row, BigRational::one()),
                Sign::Negative => alone(row, -BigRational::one()),
            }));
        }
        Program { rows, columns }
    }

    /// Whether the target is such a combination; `strict` requires that the coefficients of the
    /// strict inequalities and of 1 add up to 1.
    fn solvable(&self, target: &Polynomial, strict: Option<&[bool]>) -> bool {
        if self.rows.len() > MOST_ROWS || self.columns.len() > MOST_COLUMNS {
            return false;
        }
        let (height, width) = (self.rows.len() + usize::from(strict.is_some()), self.columns.len());
        let mut table = vec![vec![BigRational::zero(); width + 1]; height];
        for (place, column) in self.columns.iter().enumerate() {
            for (&row, value) in column {
                table[row][place] = value.clone();
            }
        }
        for (monomial, coefficient) in target.terms() {
            let row = self.rows.iter().position(|other| *other == monomial);
            table[row.expect("the target's monomials are rows")][width] =
                BigRational::from_integer(coefficient);
        }
        if let Some(strict) = strict {
            let last = &mut table[height - 1];
            for (place, _) in strict.iter().enumerate().filter(|(_, is_strict)| **is_strict) {
                last[place] = BigRational::one();
            }
            last[strict.len()] = BigRational::one();
            last[width] = BigRational::one();
        }
        presolved(table).is_some_and(has_solution)
    }
}

/// Returns the program without the unknowns that have to be zero because they occur with one sign
/// in an equation whose right side is zero; `None` if a right side cannot be reached.
fn presolved(mut table: Vec<Vec<BigRational>>) -> Option<Vec<Vec<BigRational>>> {
    let width = table.first().map_or(0, |row| row.len() - 1);
    let mut kept = vec![true; width];
    loop {
        let mut dropped = false;
        for row in &table {
            let entries = |positive: bool| {
                let alike =
                    move |place: &usize| row[*place].is_positive() == positive && !row[*place].is_zero();
                (0..width).filter(alike)
            };
            let occurs = |positive: bool| entries(positive).any(|place| kept[place]);
            let (up, down) = (occurs(true), occurs(false));
            let needed = &row[width];
            if needed.is_positive() && !up || needed.is_negative() && !down {
                return None;
            }
            if needed.is_zero() && up != down {
                let places: Vec<usize> = entries(up).filter(|&place| kept[place]).collect();
                places.into_iter().for_each(|place| kept[place] = false);
                dropped = true;
            }
        }
        if !dropped {
            break;
        }
    }
    for row in &mut table {
        let mut place = 0;
        row.retain(|_| {
            place += 1;
            place > width || kept[place - 1]
        });
    }
    table.retain(|row| row.iter().any(|entry| !entry.is_zero()));
    Some(table)
}

/// Whether A x = b has a solution with x ≥ 0; the last column is b. The simplex method minimises
/// the sum of the residuals of the equations, with Bland's rule.
fn has_solution(mut table: Vec<Vec<BigRational>>) -> bool {
    let Some(width) = table.first().map(|row| row.len() - 1) else { return true };
    for row in &mut table {
        if row[width].is_negative() {
            row.iter_mut().for_each(|entry| *entry = -&*entry);
        }
    }
    let mut basis: Vec<Option<usize>> = vec![None; table.len()];
    for _ in 0..MOST_PIVOTS {
        let open: Vec<usize> = (0..table.len()).filter(|&row| basis[row].is_none()).collect();
        if open.iter().all(|&row| table[row][width].is_zero()) {
            return true;
        }
        let gain = |place: usize| open.iter().map(|&row| &table[row][place]).sum::<BigRational>();
        let Some(entering) =
            (0..width).find(|&place| !basis.contains(&Some(place)) && gain(place).is_positive())
        else {
            return false;
        };
        let ratios = (0..table.len()).filter(|&row| table[row][entering].is_positive());
        let leaving = ratios.min_by(|&a, &b| {
            let ratio = |row: usize| &table[row][width] / &table[row][entering];
            let number = |row: usize| basis[row].unwrap_or(width + row);
            ratio(a).cmp(&ratio(b)).then(number(a).cmp(&number(b)))
        });
        let Some(leaving) = leaving else { return false };
        pivot(&mut table, leaving, entering);
        basis[leaving] = Some(entering);
    }
    false
}

fn pivot(table: &mut [Vec<BigRational>], row: usize, column: usize) {
    let scale = table[row][column].clone();
    table[row].iter_mut().for_each(|entry| *entry /= &scale);
    let pivot_row = table[row].clone();
    for (number, other) in table.iter_mut().enumerate() {
        let factor = other[column].clone();
        if number != row && !factor.is_zero() {
            for (entry, above) in other.iter_mut().zip(&pivot_row) {
                *entry -= &factor * above;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difference(larger: u32, smaller: u32) -> Polynomial {
        Polynomial::variable(larger).sub(&Polynomial::variable(smaller))
    }

    fn chain(pairs: &[(u32, u32)], strict: bool) -> Vec<Inequality> {
        let inequality =
            |&(larger, smaller): &(u32, u32)| Inequality { polynomial: difference(larger, smaller), strict };
        pairs.iter().map(inequality).collect()
    }

    #[test]
    fn a_chain_orders_its_ends_and_nothing_else() {
        let known = chain(&[(0, 1), (1, 2)], false);
        assert!(follows(&difference(0, 2), &known, |_| None));
        assert!(!follows(&difference(2, 0), &known, |_| None));
        assert!(!follows(&difference(0, 3), &known, |_| None));
    }

    #[test]
    fn a_closed_chain_contradicts_itself_exactly_if_it_is_strict() {
        let pairs = [(0, 1), (1, 2), (2, 0)];
        assert!(contradict(&chain(&pairs, true), |_| None));
        assert!(!contradict(&chain(&pairs, false), |_| None));
        assert!(!contradict(&chain(&pairs[..2], true), |_| None));
    }

    #[test]
    fn monomials_of_known_sign_may_be_added() {
        // 1 − x² − y² ≥ 0 shows 1 − x² ≥ 0, but not 1 − 2x² ≥ 0
        let square = |v: u32| Polynomial::variable(v).square();
        let disk = Polynomial::one().sub(&square(0)).sub(&square(1));
        let known = [Inequality { polynomial: disk, strict: false }];
        let even = |m: &Monomial| m.iter().all(|&(_, n)| n % 2 == 0).then_some(Sign::Positive);
        assert!(follows(&Polynomial::one().sub(&square(0)), &known, even));
        assert!(!follows(&Polynomial::one().sub(&square(0).scale(&2.into())), &known, even));
    }
}
