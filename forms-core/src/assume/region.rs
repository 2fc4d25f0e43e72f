//! Cases of a proof: the signs of radicand factors that the assumptions leave open.
//!
//! A stratum gives every factor a sign −, 0 or +. The strata that meet all constraints cover every
//! point of the statement. A case (no sign 0) is needed if it meets the constraints itself, or if
//! some stratum on its boundary does and lies on the boundary of no other needed case.

use crate::normal::{Sign, SignConstraint};

/// Largest number of factors; more factors have too many strata.
pub(crate) const MOST_FACTORS: usize = 8;

/// A product of factors that is positive, or not negative.
#[derive(Clone, Debug)]
pub(crate) struct Constraint {
    pub(crate) product: SignConstraint,
    pub(crate) strict: bool,
}

/// The factors whose signs matter, with the known signs and constraints.
#[derive(Clone, Debug, Default)]
pub(crate) struct Region {
    pub(crate) factors: Vec<(usize, Option<Sign>)>,
    pub(crate) constraints: Vec<Constraint>,
}

/// A sign for every factor.
pub(crate) type Case = Vec<(usize, Sign)>;

/// Reason why there are no cases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum NoCases {
    /// No point meets the constraints.
    Empty,
    /// There would be too many cases.
    TooMany,
}

impl Constraint {
    /// The constraint that no point meets.
    pub(crate) fn impossible() -> Self {
        let product = SignConstraint { negative: true, odd: Vec::new(), other: Vec::new() };
        Constraint { product, strict: true }
    }

    /// The constraint g ≠ 0.
    pub(crate) fn not_zero(base: usize) -> Self {
        let product = SignConstraint { negative: false, odd: Vec::new(), other: vec![base] };
        Constraint { product, strict: true }
    }
}

impl Region {
    /// Returns the cases, each a sign for every factor. A stratum on a boundary without a case of
    /// its own counts only if it is possible; if `thorough`, the same holds for every case.
    pub(crate) fn cases(
        &self,
        is_possible: impl Fn(&[(usize, i8)]) -> bool,
        thorough: bool,
    ) -> Result<Vec<Case>, NoCases> {
        if self.factors.len() > MOST_FACTORS {
            return Err(NoCases::TooMany);
        }
        let strata: Vec<Vec<i8>> = self.strata().into_iter().filter(|signs| self.meets(signs)).collect();
        if strata.is_empty() {
            return Err(NoCases::Empty);
        }
        let (mut cases, borders): (Vec<_>, Vec<_>) =
            strata.into_iter().partition(|signs| !signs.contains(&0));
        let is_possible = |signs: &[i8]| {
            let signs: Vec<(usize, i8)> =
                self.factors.iter().zip(signs).map(|(factor, &sign)| (factor.0, sign)).collect();
            is_possible(&signs)
        };
        if thorough {
            cases.retain(|case| is_possible(case));
        }
        for border in borders {
            if !cases.iter().any(|case| touches(case, &border)) && is_possible(&border) {
                cases.push(self.beside(&border));
            }
        }
        if cases.is_empty() {
            return Err(NoCases::Empty);
        }
        Ok(cases.into_iter().map(|signs| self.named(&signs)).collect())
    }

    /// Returns every choice of signs that the known signs allow.
    fn strata(&self) -> Vec<Vec<i8>> {
        let mut strata: Vec<Vec<i8>> = vec![vec![]];
        for (_, known) in &self.factors {
            let choices: &[i8] = match known {
                None => &[1, -1, 0],
                Some(Sign::Positive) => &[1, 0],
                Some(Sign::Negative) => &[-1, 0],
            };
            strata = strata
                .iter()
                .flat_map(|signs| {
                    choices.iter().map(move |&sign| signs.iter().copied().chain([sign]).collect())
                })
                .collect();
        }
        strata
    }

    fn meets(&self, signs: &[i8]) -> bool {
        let sign_of = |base: &usize| {
            let place = self.factors.iter().position(|factor| factor.0 == *base);
            place.map_or(1, |place| signs[place])
        };
        self.constraints.iter().all(|Constraint { product, strict }| {
            let vanishes = product.odd.iter().chain(&product.other).any(|base| sign_of(base) == 0);
            if vanishes {
                return !strict;
            }
            let front = if product.negative { -1 } else { 1 };
            product.odd.iter().fold(front, |sign, base| sign * sign_of(base)) > 0
        })
    }

    /// Returns a case on whose boundary the stratum lies.
    fn beside(&self, border: &[i8]) -> Vec<i8> {
        self.factors
            .iter()
            .zip(border)
            .map(|((_, known), &sign)| match (sign, known) {
                (0, Some(Sign::Negative)) => -1,
                (0, _) => 1,
                (sign, _) => sign,
            })
            .collect()
    }

    fn named(&self, signs: &[i8]) -> Vec<(usize, Sign)> {
        self.factors
            .iter()
            .zip(signs)
            .map(|((base, _), &sign)| (*base, if sign < 0 { Sign::Negative } else { Sign::Positive }))
            .collect()
    }
}

/// Whether the stratum lies on the boundary of the case.
fn touches(case: &[i8], border: &[i8]) -> bool {
    case.iter().zip(border).all(|(&sign, &at_border)| at_border == 0 || at_border == sign)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn product(odd: &[usize], strict: bool) -> Constraint {
        let product = SignConstraint { negative: false, odd: odd.to_vec(), other: vec![] };
        Constraint { product, strict }
    }

    fn signs(region: &Region) -> Vec<Vec<i8>> {
        let number = |sign: Sign| if sign == Sign::Positive { 1 } else { -1 };
        let mut all: Vec<Vec<i8>> = region
            .cases(|_| true, false)
            .unwrap()
            .into_iter()
            .map(|case| case.into_iter().map(|(_, sign)| number(sign)).collect())
            .collect();
        all.sort();
        all
    }

    #[test]
    fn a_product_of_two_is_not_negative_in_two_of_four_cases() {
        let region =
            Region { factors: vec![(0, None), (1, None)], constraints: vec![product(&[0, 1], false)] };
        assert_eq!(signs(&region), [[-1, -1], [1, 1]]);
    }

    #[test]
    fn a_border_that_belongs_to_no_case_brings_its_own() {
        // x ≥ 0 and x y ≥ 0 hold at x = 0, y < 0, which is on the boundary of no case with x, y > 0
        let constraints = vec![product(&[0], false), product(&[0, 1], false)];
        let region = Region { factors: vec![(0, None), (1, None)], constraints };
        assert_eq!(signs(&region), [[1, -1], [1, 1]]);
    }

    #[test]
    fn a_border_that_no_point_lies_on_brings_none() {
        let constraints = vec![product(&[0], false), product(&[0, 1], false)];
        let region = Region { factors: vec![(0, None), (1, None)], constraints };
        let cases = region.cases(|signs| signs[0].1 != 0 || signs[1].1 != -1, false);
        assert_eq!(cases, Ok(vec![vec![(0, Sign::Positive), (1, Sign::Positive)]]));
    }

    #[test]
    fn a_strict_constraint_has_no_such_border() {
        let constraints = vec![product(&[0], true), product(&[0, 1], false)];
        let region = Region { factors: vec![(0, None), (1, None)], constraints };
        assert_eq!(signs(&region), [[1, 1]]);
    }

    #[test]
    fn contradictory_constraints_leave_no_point() {
        let negative = SignConstraint { negative: true, odd: vec![0], other: vec![] };
        let constraints = vec![product(&[0], true), Constraint { product: negative, strict: true }];
        let region = Region { factors: vec![(0, None)], constraints };
        assert_eq!(region.cases(|_| true, false), Err(NoCases::Empty));
    }
}
