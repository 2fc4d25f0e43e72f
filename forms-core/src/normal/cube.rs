//! Cubes among numbers A + Bρ with ρ² = r: (2 + √5) = ((1 + √5)/2)³.
//!
//! With h³ = A + Bρ, N = h h̄ and t = h + h̄: N³ = A² − B² r, t³ − 3 N t = 2A and
//! h = (A + Bρ + t N)/(t² − N). Both N and t are integers, as h is an algebraic integer.

use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive, Zero};

/// Largest magnitude of the small candidates that are tried.
const MOST_TRIED: i64 = 1 << 12;

/// Returns t N and t² − N for a number A + Bρ of norm n that is a cube:
/// h = (A + Bρ + t N)/(t² − N).
pub(super) fn cube_root(a: &BigInt, norm: &BigInt) -> Option<(BigInt, BigInt)> {
    let root = norm.cbrt();
    if &root * &root * &root != *norm {
        return None;
    }
    let twice: BigInt = a * 2;
    let t = integer_root(&root, &twice)?;
    let below = &t * &t - &root;
    (!below.is_zero()).then(|| (t * root, below))
}

/// Returns the largest integer t with t³ − 3 N t = c, if there is one. Beyond 2√|N| in magnitude
/// the cubic increases, and bisection finds a root there; nearer to zero the few integers are tried
/// one by one.
fn integer_root(n: &BigInt, c: &BigInt) -> Option<BigInt> {
    let value = |t: &BigInt| -> BigInt { t * t * t - n * t * 3 - c };
    let turn: BigInt = n.abs().sqrt() * 2 + 2;
    for sign in [BigInt::one(), -BigInt::one()] {
        let (mut near, mut far) = (turn.clone(), turn.clone() + c.abs().cbrt() * 2 + 2);
        while near < far {
            let middle: BigInt = (&near + &far) / 2;
            if (value(&(&middle * &sign)) * &sign).is_negative() {
                near = middle + 1;
            } else {
                far = middle;
            }
        }
        let found = &near * &sign;
        if value(&found).is_zero() {
            return Some(found);
        }
    }
    let limit = turn.to_i64().filter(|limit| *limit <= MOST_TRIED)?;
    (-limit..=limit).rev().map(BigInt::from).find(|t| value(t).is_zero())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the two parts of the numerator of h and its denominator, from the parts of
    /// f = A + Bρ.
    fn root_of(a: i64, b: i64, r: i64) -> Option<(i64, i64, i64)> {
        let norm = BigInt::from(a * a - b * b * r);
        let (shift, below) = cube_root(&a.into(), &norm)?;
        Some((a + shift.to_i64()?, b, below.to_i64()?))
    }

    #[test]
    fn the_cube_of_what_is_found_is_the_number() {
        // ((p + q√r)/d)³ = (p³ + 3 p q² r + (3 p² q + q³ r)√r)/d³
        let numbers = [(2, 1, 5), (7, 5, 2), (26, 15, 3), (-2, 1, 5), (9, 4, 5), (99, 70, 2)];
        for (a, b, r) in numbers {
            let (p, q, d) = root_of(a, b, r).unwrap();
            let cube = (p * p * p + 3 * p * q * q * r, 3 * p * p * q + q * q * q * r);
            assert_eq!(cube, (a * d * d * d, b * d * d * d), "{a} + {b}√{r}");
        }
    }

    #[test]
    fn what_is_no_cube_has_no_root() {
        assert!(
            [(3, 2, 2), (1, 1, 2), (2, 1, 3), (5, 2, 6), (8, 3, 7)]
                .iter()
                .all(|&(a, b, r)| root_of(a, b, r).is_none())
        );
    }
}
