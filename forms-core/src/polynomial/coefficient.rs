//! Coefficients on a ladder of number types: `i64` if all of them fit, else `i128`, else `BigInt`.
//!
//! The rung of a result is chosen from bounds before the result is computed, so that the loops on
//! the two lower rungs need no checks. Afterwards the result moves down to the lowest rung that
//! holds it, which makes the rung a function of the value.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{Signed, ToPrimitive, Zero};
use std::borrow::Cow;

/// The coefficients of a polynomial, none of them zero, on the lowest rung that holds them all.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) enum Coefficients {
    Small(Vec<i64>),
    Wide(Vec<i128>),
    Big(Vec<BigInt>),
}

/// A rung of the ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rung {
    Small,
    Wide,
    Big,
}

impl Rung {
    /// Returns the lowest rung whose numbers reach `bound` in absolute value; `None` stands for a
    /// bound beyond 128 bits.
    pub(super) fn for_bound(bound: Option<u128>) -> Rung {
        match bound {
            Some(bound) if bound <= i64::MAX as u128 => Rung::Small,
            Some(bound) if bound <= i128::MAX as u128 => Rung::Wide,
            _ => Rung::Big,
        }
    }
}

/// Runs an expression with `$C` standing for the number type of a rung.
macro_rules! on_rung {
    ($rung:expr, $C:ident => $body:expr) => {
        match $rung {
            $crate::polynomial::coefficient::Rung::Small => {
                type $C = i64;
                $body
            }
            $crate::polynomial::coefficient::Rung::Wide => {
                type $C = i128;
                $body
            }
            $crate::polynomial::coefficient::Rung::Big => {
                type $C = num_bigint::BigInt;
                $body
            }
        }
    };
}
pub(super) use on_rung;

/// The number type of a rung. Its operations are exact as long as the chosen bound holds.
pub(super) trait Coefficient: Clone + PartialEq + From<i64> + 'static {
    fn zero() -> Self;
    fn is_zero(&self) -> bool;
    fn negated(&self) -> Self;
    fn plus(&self, other: &Self) -> Self;
    fn minus(&self, other: &Self) -> Self;
    fn times(&self, other: &Self) -> Self;
    /// self += a·b
    fn add_product(&mut self, a: &Self, b: &Self);
    /// Returns the quotient if it is exact.
    fn divided_by(&self, divisor: &Self) -> Option<Self>;
    /// Returns the absolute value, on the machine rungs.
    fn size(&self) -> Option<u128>;
    /// Whether the type holds every number up to this bound.
    fn holds(bound: Option<u128>) -> bool;
    /// Returns the coefficients as numbers of this type; they must fit, which the bound of the
    /// result ensures.
    fn view(coefficients: &Coefficients) -> Cow<'_, [Self]>;
    /// Returns the numbers as machine words, on the lowest rung.
    fn words(_: &[Self]) -> Option<&[i64]> {
        None
    }
    /// Returns the numbers as mutable machine words, on the lowest rung.
    fn words_mut(_: &mut [Self]) -> Option<&mut [i64]> {
        None
    }
    /// Returns the coefficients on the lowest rung that holds them.
    fn settle(numbers: Vec<Self>) -> Coefficients;
}

macro_rules! machine_coefficient {
    ($number:ty) => {
        fn zero() -> Self {
            0
        }
        #[inline(always)]
        fn is_zero(&self) -> bool {
            *self == 0
        }
        #[inline(always)]
        fn negated(&self) -> Self {
            self.wrapping_neg()
        }
        #[inline(always)]
        fn plus(&self, other: &Self) -> Self {
            self.wrapping_add(*other)
        }
        #[inline(always)]
        fn minus(&self, other: &Self) -> Self {
            self.wrapping_sub(*other)
        }
        #[inline(always)]
        fn times(&self, other: &Self) -> Self {
            self.wrapping_mul(*other)
        }
        #[inline(always)]
        fn add_product(&mut self, a: &Self, b: &Self) {
            *self = self.wrapping_add(a.wrapping_mul(*b));
        }
        fn divided_by(&self, divisor: &Self) -> Option<Self> {
            let quotient = self.checked_div(*divisor)?;
            (quotient.wrapping_mul(*divisor) == *self).then_some(quotient)
        }
        fn size(&self) -> Option<u128> {
            Some(self.unsigned_abs().into())
        }
        fn holds(bound: Option<u128>) -> bool {
            bound.is_some_and(|bound| bound <= <$number>::MAX as u128)
        }
    };
}

impl Coefficient for i64 {
    machine_coefficient!(i64);

    fn view(coefficients: &Coefficients) -> Cow<'_, [i64]> {
        match coefficients {
            Coefficients::Small(numbers) => Cow::Borrowed(numbers),
            Coefficients::Wide(numbers) => numbers.iter().map(|&number| number as i64).collect(),
            Coefficients::Big(numbers) => {
                numbers.iter().map(|number| number.to_i64().expect("the bound fits 64 bits")).collect()
            }
        }
    }

    fn words(numbers: &[i64]) -> Option<&[i64]> {
        Some(numbers)
    }

    fn words_mut(numbers: &mut [i64]) -> Option<&mut [i64]> {
        Some(numbers)
    }

    fn settle(numbers: Vec<i64>) -> Coefficients {
        Coefficients::Small(numbers)
    }
}

impl Coefficient for i128 {
    machine_coefficient!(i128);

    fn view(coefficients: &Coefficients) -> Cow<'_, [i128]> {
        match coefficients {
            Coefficients::Small(numbers) => numbers.iter().map(|&number| i128::from(number)).collect(),
            Coefficients::Wide(numbers) => Cow::Borrowed(numbers),
            Coefficients::Big(numbers) => {
                numbers.iter().map(|number| number.to_i128().expect("the bound fits 128 bits")).collect()
            }
        }
    }

    fn settle(numbers: Vec<i128>) -> Coefficients {
        if numbers.iter().all(|&number| i64::try_from(number).is_ok()) {
            return Coefficients::Small(numbers.iter().map(|&number| number as i64).collect());
        }
        Coefficients::Wide(numbers)
    }
}

impl Coefficient for BigInt {
    fn zero() -> Self {
        Zero::zero()
    }
    fn is_zero(&self) -> bool {
        Zero::is_zero(self)
    }
    fn negated(&self) -> Self {
        -self
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn add_product(&mut self, a: &Self, b: &Self) {
        *self += a * b;
    }
    fn divided_by(&self, divisor: &Self) -> Option<Self> {
        let (quotient, remainder) = self.div_rem(divisor);
        Zero::is_zero(&remainder).then_some(quotient)
    }
    fn size(&self) -> Option<u128> {
        None
    }
    fn holds(_: Option<u128>) -> bool {
        true
    }

    fn view(coefficients: &Coefficients) -> Cow<'_, [BigInt]> {
        match coefficients {
            Coefficients::Small(numbers) => numbers.iter().map(|&number| BigInt::from(number)).collect(),
            Coefficients::Wide(numbers) => numbers.iter().map(|&number| BigInt::from(number)).collect(),
            Coefficients::Big(numbers) => Cow::Borrowed(numbers),
        }
    }

    fn settle(numbers: Vec<BigInt>) -> Coefficients {
        match numbers.iter().map(BigInt::to_i128).collect::<Option<Vec<i128>>>() {
            Some(numbers) => i128::settle(numbers),
            None => Coefficients::Big(numbers),
        }
    }
}

/// The largest absolute value of a polynomial's coefficients, and the sum of the absolute values;
/// `None` is beyond 128 bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct Norms {
    pub(super) largest: Option<u128>,
    pub(super) sum: Option<u128>,
}

impl Norms {
    /// Returns a bound on the coefficients of f·g: the lesser of max|f|·‖g‖₁ and max|g|·‖f‖₁.
    pub(super) fn of_product(f: Norms, g: Norms) -> Option<u128> {
        let narrow =
            |norms: Norms| Some((u64::try_from(norms.largest?).ok()?, u64::try_from(norms.sum?).ok()?));
        if let (Some((f_largest, f_sum)), Some((g_largest, g_sum))) = (narrow(f), narrow(g)) {
            let left = u128::from(f_largest) * u128::from(g_sum);
            return Some(left.min(u128::from(g_largest) * u128::from(f_sum)));
        }
        let left = f.largest.zip(g.sum).and_then(|(largest, sum)| largest.checked_mul(sum));
        let right = g.largest.zip(f.sum).and_then(|(largest, sum)| largest.checked_mul(sum));
        match (left, right) {
            (Some(left), Some(right)) => Some(left.min(right)),
            (one, other) => one.or(other),
        }
    }
}

impl Coefficients {
    pub(super) fn len(&self) -> usize {
        match self {
            Coefficients::Small(numbers) => numbers.len(),
            Coefficients::Wide(numbers) => numbers.len(),
            Coefficients::Big(numbers) => numbers.len(),
        }
    }

    /// Returns the number of 64-bit words, at least one for each coefficient.
    pub(super) fn word_count(&self) -> u64 {
        match self {
            Coefficients::Big(numbers) => numbers.iter().map(|number| number.bits() / 64 + 1).sum(),
            _ => self.len() as u64,
        }
    }

    pub(super) fn rung(&self) -> Rung {
        match self {
            Coefficients::Small(_) => Rung::Small,
            Coefficients::Wide(_) => Rung::Wide,
            Coefficients::Big(_) => Rung::Big,
        }
    }

    /// Returns the coefficient at a position.
    pub(super) fn get(&self, index: usize) -> BigInt {
        match self {
            Coefficients::Small(numbers) => BigInt::from(numbers[index]),
            Coefficients::Wide(numbers) => BigInt::from(numbers[index]),
            Coefficients::Big(numbers) => numbers[index].clone(),
        }
    }

    /// Whether the coefficient at a position is a multiple of another one.
    pub(super) fn is_multiple(&self, index: usize, divisors: &Coefficients, divisor: usize) -> bool {
        match (self, divisors) {
            // −2⁶³ is a multiple of −1 and wraps to remainder 0.
            (Coefficients::Small(a), Coefficients::Small(b)) => a[index].wrapping_rem(b[divisor]) == 0,
            _ => self.get(index).is_multiple_of(&divisors.get(divisor)),
        }
    }

    pub(super) fn is_negative(&self, index: usize) -> bool {
        match self {
            Coefficients::Small(numbers) => numbers[index] < 0,
            Coefficients::Wide(numbers) => numbers[index] < 0,
            Coefficients::Big(numbers) => numbers[index].is_negative(),
        }
    }

    /// Returns the number of 64-bit words of the longest coefficient, at least 1.
    pub(super) fn words(&self) -> u64 {
        match self {
            Coefficients::Small(_) => 1,
            Coefficients::Wide(_) => 2,
            Coefficients::Big(numbers) => numbers.iter().map(BigInt::bits).max().unwrap_or(0).div_ceil(64),
        }
    }

    pub(super) fn norms(&self) -> Norms {
        let mut largest = 0u128;
        let mut sum = 0u128;
        match self {
            Coefficients::Small(numbers) => {
                for number in numbers {
                    let size = u128::from(number.unsigned_abs());
                    largest = largest.max(size);
                    sum += size;
                }
            }
            Coefficients::Wide(numbers) => {
                let mut beyond = false;
                for number in numbers {
                    let size = number.unsigned_abs();
                    largest = largest.max(size);
                    let (total, overflow) = sum.overflowing_add(size);
                    sum = total;
                    beyond |= overflow;
                }
                if beyond {
                    return Norms { largest: Some(largest), sum: None };
                }
            }
            Coefficients::Big(_) => return Norms { largest: None, sum: None },
        }
        Norms { largest: Some(largest), sum: Some(sum) }
    }
}
