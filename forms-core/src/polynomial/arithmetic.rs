//! Sums, differences and integer multiples, by merging sorted terms.

use super::Polynomial;
use super::coefficient::{Coefficient, Coefficients, Rung, on_rung};
use super::monomial::{Layout, compare};
use crate::steps;
use num_bigint::BigInt;
use num_traits::{One, ToPrimitive, Zero};
use std::cmp::Ordering;

/// Steps for one term of a sum, including its memory.
const STEPS_OF_TERM: u64 = 4;

impl Polynomial {
    /// f + g
    pub fn add(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.clone();
        }
        self.combine(other, false)
    }

    /// f − g
    pub fn sub(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.neg();
        }
        self.combine(other, true)
    }

    /// −f
    pub fn neg(&self) -> Self {
        // −(−2⁶³) does not fit its rung, and the negation of 2⁶³ fits a lower one: scaling handles
        // both.
        self.scale_small(-1)
    }

    /// c·f
    pub fn scale(&self, factor: &BigInt) -> Self {
        match factor.to_i64() {
            Some(factor) => self.scale_small(factor),
            None => self.scale_on_rung::<BigInt>(factor),
        }
    }

    pub(super) fn scale_small(&self, factor: i64) -> Self {
        if factor == 0 {
            return Self::zero();
        }
        if factor == 1 {
            return self.clone();
        }
        let largest = self.coefficients.norms().largest;
        let bound = largest.and_then(|largest| largest.checked_mul(u128::from(factor.unsigned_abs())));
        on_rung!(Rung::for_bound(bound), C => self.scale_on_rung::<C>(&C::from(factor)))
    }

    fn scale_on_rung<C: Coefficient>(&self, factor: &C) -> Self {
        let numbers = C::view(&self.coefficients);
        let mut scaled = Vec::with_capacity(numbers.len());
        for number in numbers.iter() {
            scaled.push(number.times(factor));
        }
        Polynomial { layout: self.layout, monomials: self.monomials.clone(), coefficients: C::settle(scaled) }
    }

    fn combine(&self, other: &Self, subtract: bool) -> Self {
        if other.is_zero() {
            return self.clone();
        }
        let layout = self.layout.join(other.layout);
        let left = self.coefficients.norms().largest;
        let right = other.coefficients.norms().largest;
        let bound = left.zip(right).and_then(|(left, right)| left.checked_add(right));
        let monomials = (self.monomials_on(layout), other.monomials_on(layout));
        on_rung!(Rung::for_bound(bound), C => {
            let left = (&*monomials.0, &*C::view(&self.coefficients));
            let right = (&*monomials.1, &*C::view(&other.coefficients));
            merge(layout, left, right, subtract)
        })
    }
}

/// Packed terms in decreasing order.
type Terms<'a, C> = (&'a [u64], &'a [C]);

/// Returns the sum or difference of packed terms.
fn merge<C: Coefficient>(
    layout: Layout,
    left: Terms<'_, C>,
    right: Terms<'_, C>,
    subtract: bool,
) -> Polynomial {
    let words = layout.words;
    let ((f, a), (g, b)) = (left, right);
    steps::spend(STEPS_OF_TERM * (a.len() + b.len()) as u64);
    let mut monomials = Vec::with_capacity(f.len() + g.len());
    let mut coefficients: Vec<C> = Vec::with_capacity(a.len() + b.len());
    let signed = |number: &C| if subtract { number.negated() } else { number.clone() };
    let (mut i, mut j) = (0, 0);
    while i < a.len() && j < b.len() {
        let (m, n) = (&f[i * words..(i + 1) * words], &g[j * words..(j + 1) * words]);
        let order = compare(m, n);
        let number = match order {
            Ordering::Greater => a[i].clone(),
            Ordering::Less => signed(&b[j]),
            Ordering::Equal if subtract => a[i].minus(&b[j]),
            Ordering::Equal => a[i].plus(&b[j]),
        };
        if !number.is_zero() {
            monomials.extend_from_slice(if order.is_ge() { m } else { n });
            coefficients.push(number);
        }
        i += usize::from(order.is_ge());
        j += usize::from(order.is_le());
    }
    monomials.extend_from_slice(&f[i * words..]);
    coefficients.extend_from_slice(&a[i..]);
    monomials.extend_from_slice(&g[j * words..]);
    while j < b.len() {
        coefficients.push(signed(&b[j]));
        j += 1;
    }
    Polynomial::settle(layout, monomials, coefficients)
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl std::ops::$trait<&Polynomial> for &Polynomial {
            type Output = Polynomial;
            fn $method(self, other: &Polynomial) -> Polynomial {
                Polynomial::$method(self, other)
            }
        }
        impl std::ops::$trait for Polynomial {
            type Output = Polynomial;
            fn $method(self, other: Polynomial) -> Polynomial {
                Polynomial::$method(&self, &other)
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);

impl std::ops::Neg for &Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial::neg(self)
    }
}

impl std::ops::Neg for Polynomial {
    type Output = Polynomial;
    fn neg(self) -> Polynomial {
        Polynomial::neg(&self)
    }
}

impl Zero for Polynomial {
    fn zero() -> Self {
        Polynomial::zero()
    }
    fn is_zero(&self) -> bool {
        Polynomial::is_zero(self)
    }
}

impl One for Polynomial {
    fn one() -> Self {
        Polynomial::one()
    }
}

impl From<i64> for Polynomial {
    fn from(number: i64) -> Self {
        Polynomial::integer(number)
    }
}

impl Coefficients {
    /// Divides every coefficient by a common divisor.
    pub(super) fn divided_by(&self, divisor: &BigInt) -> Coefficients {
        match (self, divisor.to_i64()) {
            (_, Some(1)) => self.clone(),
            (Coefficients::Small(numbers), Some(divisor)) => {
                // −2⁶³/(−1) does not occur: contents are positive.
                Coefficients::Small(numbers.iter().map(|number| number / divisor).collect())
            }
            _ => BigInt::settle(BigInt::view(self).iter().map(|number| number / divisor).collect()),
        }
    }
}
