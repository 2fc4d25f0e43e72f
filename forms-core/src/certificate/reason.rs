//! Reasons for signs: a polynomial written in a form that shows that it is not negative.
//!
//! A sum of positive terms is its own reason. A quadratic form is written as a sum of squares, by
//! completing the squares one after the other. Between bounds l ≤ v ≤ u a polynomial Σ cₖ wᵏ/(1 +
//! w)ⁿ in w = (v − l)/(u − v) is Σ cₖ (v − l)ᵏ (u − v)ⁿ⁻ᵏ/(u − l)ⁿ, which shows its sign if no cₖ
//! is negative.

use crate::assume::Facts;
use crate::expression::Rational;
use crate::polynomial::Polynomial;
use num_bigint::BigInt;
use num_traits::{One, Signed, Zero};

/// Highest degree of a polynomial that is written in distances from bounds.
const HIGHEST_DEGREE: u32 = 12;

/// Writes a polynomial as a reason that it is not negative; `name` writes a generator.
pub(super) fn reason(polynomial: &Polynomial, facts: &Facts, name: &dyn Fn(u32) -> String) -> Option<String> {
    if let Some(value) = polynomial.as_constant() {
        return (!value.is_negative()).then(|| value.to_string());
    }
    let terms: Vec<Term> =
        polynomial.terms().map(|(m, c)| Term { c: c.into(), parts: powers(&m, facts, name) }).collect();
    if terms.iter().all(|term| term.is_positive()) {
        return Some(sum(&terms));
    }
    squares(polynomial, name).or_else(|| distances(polynomial, facts, name))
}

/// c ∏ partᵏ, with a flag for each part that is known not to be negative.
struct Term {
    c: Rational,
    parts: Vec<(String, u32, bool)>,
}

impl Term {
    fn is_positive(&self) -> bool {
        !self.c.is_negative() && self.parts.iter().all(|(_, power, positive)| *positive || power % 2 == 0)
    }
}

fn powers(monomial: &[(u32, u32)], facts: &Facts, name: &dyn Fn(u32) -> String) -> Vec<(String, u32, bool)> {
    let is_positive = |v: u32| facts.bounds(v).0.is_some_and(|lower| !lower.is_negative());
    monomial.iter().map(|&(v, n)| (name(v), n, is_positive(v))).collect()
}

fn sum(terms: &[Term]) -> String {
    let product = |term: &Term| {
        let powers = term.parts.iter().filter(|part| part.1 > 0);
        let powers =
            powers.map(|(part, n, _)| if *n == 1 { format!("({part})") } else { format!("({part})**{n}") });
        std::iter::once(format!("({})", term.c)).chain(powers).collect::<Vec<_>>().join("*")
    };
    terms.iter().map(product).collect::<Vec<_>>().join(" + ")
}

/// Writes a polynomial of degree 2 as Σ dₖ (yₖ + Σ lⱼ yⱼ)², where the last y is 1.
fn squares(polynomial: &Polynomial, name: &dyn Fn(u32) -> String) -> Option<String> {
    if polynomial.total_degree() > 2 {
        return None;
    }
    let variables = polynomial.variables();
    let size = variables.len();
    let place = |v: u32| variables.iter().position(|&w| w == v).unwrap_or(size);
    let mut matrix = vec![vec![Rational::zero(); size + 1]; size + 1];
    for (monomial, c) in polynomial.terms() {
        let (i, j) = match monomial.as_slice() {
            [] => (size, size),
            [(v, 1)] => (place(*v), size),
            [(v, _)] => (place(*v), place(*v)),
            [(v, _), (w, _), ..] => (place(*v), place(*w)),
        };
        let half = Rational::new(c, 2.into());
        matrix[i][j] += &half;
        matrix[j][i] += half;
    }
    let mut terms = Vec::new();
    for k in 0..=size {
        let row = matrix[k].clone();
        if row[k].is_negative() || (row[k].is_zero() && row[k..].iter().any(|entry| !entry.is_zero())) {
            return None;
        }
        if row[k].is_zero() {
            continue;
        }
        let linear = (k..=size).filter(|&j| !row[j].is_zero()).map(|j| {
            let y = variables.get(j).map_or("1".to_string(), |&v| name(v));
            format!("({})*({y})", &row[j] / &row[k])
        });
        terms.push(Term {
            c: row[k].clone(),
            parts: vec![(linear.collect::<Vec<_>>().join(" + "), 2, false)],
        });
        for below in &mut matrix[k + 1..] {
            let factor = &below[k] / &row[k];
            below.iter_mut().zip(&row).skip(k).for_each(|(entry, above)| *entry -= &factor * above);
        }
    }
    Some(sum(&terms))
}

/// Writes a polynomial in the distances of its generators from their bounds.
fn distances(polynomial: &Polynomial, facts: &Facts, name: &dyn Fn(u32) -> String) -> Option<String> {
    if polynomial.total_degree() > HIGHEST_DEGREE {
        return None;
    }
    let mut terms: Vec<(Polynomial, Term)> =
        vec![(polynomial.clone(), Term { c: Rational::one(), parts: vec![] })];
    for v in polynomial.variables() {
        let (lower, upper) = facts.bounds(v);
        let degree = polynomial.degree(v);
        let below = |bound: &Rational| format!("{} - ({bound})", name(v));
        let above = |bound: &Rational| format!("({bound}) - ({})", name(v));
        // v = (from + to w)/(1 + w), or v = from ± w
        let (from, to, direction, parts) = match (lower, upper) {
            (Some(l), None) => (l, None, 1, [Some(below(l)), None]),
            (None, Some(u)) => (u, None, -1, [Some(above(u)), None]),
            (Some(l), Some(u)) => (l, Some(u), 1, [Some(below(l)), Some(above(u))]),
            (None, None) => return None,
        };
        let width = to.map_or(Rational::one(), |to| to - from);
        if width.is_zero() {
            return None;
        }
        let mut finer = Vec::new();
        for (coefficients, term) in terms {
            for (k, (c, part)) in moved(&coefficients, v, degree, from, to, direction).into_iter().enumerate()
            {
                let mut parts_of = term.parts.iter().map(|p| (p.0.clone(), p.1, true)).collect::<Vec<_>>();
                parts_of.extend(parts[0].clone().map(|p| (p, k as u32, true)));
                parts_of.extend(parts[1].clone().map(|p| (p, degree - k as u32, true)));
                let power = if to.is_some() { degree as i32 } else { 0 };
                finer.push((c, Term { c: &term.c * part / width.pow(power), parts: parts_of }));
            }
        }
        terms = finer;
    }
    let mut all = Vec::new();
    for (c, mut term) in terms {
        term.c *= Rational::from_integer(c.as_constant()?);
        if term.c.is_negative() {
            return None;
        }
        if !term.c.is_zero() {
            all.push(term);
        }
    }
    Some(sum(&all))
}

/// Returns the coefficients of p(from ± w), or of (1 + w)ⁿ p((from + to w)/(1 + w)), by powers of
/// w; each is a polynomial in the other generators times a number.
fn moved(
    polynomial: &Polynomial,
    v: u32,
    degree: u32,
    from: &Rational,
    to: Option<&Rational>,
    direction: i64,
) -> Vec<(Polynomial, Rational)> {
    let scale = to.map_or(from.denom().clone(), |to| from.denom() * to.denom());
    let whole = |value: &Rational| (value * Rational::from_integer(scale.clone())).to_integer();
    let w = Polynomial::variable(v);
    let start = Polynomial::constant(whole(from));
    let (above, below) = match to {
        Some(to) => (start.add(&w.scale(&whole(to))), Polynomial::one().add(&w).scale(&scale)),
        None => {
            (start.add(&w.scale(&(&scale * BigInt::from(direction)))), Polynomial::constant(scale.clone()))
        }
    };
    let mut sum = Polynomial::zero();
    for (exponent, coefficient) in polynomial.coefficients_in(v) {
        let powers = above.pow(exponent).mul(&below.pow(degree - exponent));
        sum = sum.add(&coefficient.mul(&powers));
    }
    let scale = Rational::from_integer(num_traits::pow(scale, degree as usize)).recip();
    let mut parts = vec![(Polynomial::zero(), scale); degree as usize + 1];
    for (exponent, coefficient) in sum.coefficients_in(v) {
        parts[exponent as usize].0 = coefficient;
    }
    parts
}
