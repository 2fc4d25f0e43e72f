//! Numbers of a kernel: exact until they are used, and then rounded to a floating-point number
//! once.

use crate::expression::Rational;
use forms_math::{Number, Real};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::fmt;

/// π to a hundred decimals, so that the words of q πᵏ are correct in double-double precision.
const PI_DIGITS: &str =
    "31415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679";

/// Length of the longest quotient that is written in full; a longer one is written by its power of
/// ten.
const LONGEST_TEXT: usize = 40;

/// Exact number q πᵏ with q rational.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Constant {
    /// q
    pub factor: Rational,
    /// k
    pub pi_exponent: i32,
}

impl Constant {
    /// Creates a rational number.
    pub fn rational(factor: Rational) -> Self {
        Constant { factor, pi_exponent: 0 }
    }

    /// Creates an integer.
    pub fn integer(value: i64) -> Self {
        Self::rational(Rational::from_integer(value.into()))
    }

    /// π
    pub fn pi() -> Self {
        Constant { factor: Rational::one(), pi_exponent: 1 }
    }

    /// Whether the number is 1.
    pub fn is_one(&self) -> bool {
        self.pi_exponent == 0 && self.factor.is_one()
    }

    /// Whether the number is 0.
    pub fn is_zero(&self) -> bool {
        self.factor.is_zero()
    }

    /// Whether the number is below 0.
    pub fn is_negative(&self) -> bool {
        self.factor.is_negative()
    }

    /// Whether the number, as an `f64`, is neither infinite nor rounded to zero.
    pub fn is_representable(&self) -> bool {
        let nearest = self.to_f64();
        nearest.is_finite() && (nearest != 0.0 || self.is_zero())
    }

    /// −c
    pub fn negated(&self) -> Self {
        Constant { factor: -&self.factor, pi_exponent: self.pi_exponent }
    }

    /// c₁ c₂
    pub fn times(&self, other: &Self) -> Self {
        Constant {
            factor: &self.factor * &other.factor,
            pi_exponent: if self.is_zero() || other.is_zero() {
                0
            } else {
                self.pi_exponent + other.pi_exponent
            },
        }
    }

    /// c₁ + c₂, if both have the same power of π.
    pub(crate) fn plus(&self, other: &Self) -> Option<Self> {
        (self.pi_exponent == other.pi_exponent)
            .then(|| Constant { factor: &self.factor + &other.factor, pi_exponent: self.pi_exponent })
    }

    /// 1/c for c ≠ 0.
    pub(crate) fn reciprocal(&self) -> Self {
        Constant { factor: self.factor.recip(), pi_exponent: -self.pi_exponent }
    }

    /// Returns the nearest `f64`, ties to even.
    pub fn to_f64(&self) -> f64 {
        nearest_f64(&self.value())
    }

    /// Returns the nearest `f32`, ties to even.
    pub fn to_f32(&self) -> f32 {
        let value = self.value();
        nearest(value.numer(), value.denom(), SINGLE) as f32
    }

    /// Splits the number into a sum of at most `most` `f64`s, each the nearest to the remainder
    /// after the previous ones. The sum is exact if it is shorter. A number beyond all `f64`s gives
    /// one infinity.
    pub fn words(&self, most: usize) -> Vec<f64> {
        let mut left = self.value();
        let mut words = Vec::new();
        while words.is_empty() || (words.len() < most && !left.is_zero()) {
            let word = nearest_f64(&left);
            words.push(word);
            // the remainder is below all `f64`s, or the number is infinite
            let Some(exact) = Rational::from_float(word).filter(|exact| !exact.is_zero()) else { break };
            left -= exact;
        }
        if words.len() > 1 && words.last() == Some(&0.0) {
            words.pop();
        }
        words
    }

    /// Converts the exact number to any precision.
    pub(crate) fn to_real<T: Real>(&self) -> T {
        let words = self.words(2);
        if self.is_double() {
            return T::from_f64(words[0]);
        }
        let [numerator, denominator] = self.natural_words();
        let words = [words[0], words.get(1).copied().unwrap_or(0.0)];
        T::number(Number::new(words, &numerator, &denominator, self.pi_exponent))
    }

    /// Whether an `f64` holds the number exactly.
    pub(crate) fn is_double(&self) -> bool {
        self.pi_exponent == 0
            && Rational::from_float(self.to_f64()).is_none_or(|nearest| nearest == self.factor)
    }

    /// Returns the magnitudes of the numerator and the denominator of q, each with the least
    /// significant word first.
    pub(crate) fn natural_words(&self) -> [Vec<u64>; 2] {
        [self.factor.numer(), self.factor.denom()].map(|part| part.magnitude().to_u64_digits())
    }

    /// q πᵏ, with π to a hundred decimals.
    fn value(&self) -> Rational {
        if self.pi_exponent == 0 {
            return self.factor.clone();
        }
        let digits: BigInt = PI_DIGITS.parse().expect("the digits of π are digits");
        let pi = Rational::new(digits, BigInt::from(10).pow(PI_DIGITS.len() as u32 - 1));
        let power = num_traits::pow(pi, self.pi_exponent.unsigned_abs() as usize);
        let power = if self.pi_exponent < 0 { power.recip() } else { power };
        &self.factor * power
    }
}

/// Writes q πᵏ with q as a quotient, or as a power of ten if the quotient is long.
impl fmt::Display for Constant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factor = self.factor.to_string();
        if factor.len() <= LONGEST_TEXT {
            f.write_str(&factor)?;
        } else {
            let digits = |part: &BigInt| part.magnitude().to_string().len() as i64;
            let sign = if self.is_negative() { "-" } else { "" };
            write!(f, "{sign}10^{}", digits(self.factor.numer()) - digits(self.factor.denom()))?;
        }
        match self.pi_exponent {
            0 => Ok(()),
            1 => f.write_str(" pi"),
            exponent => write!(f, " pi^{exponent}"),
        }
    }
}

/// Binary floating-point format: the number of bits of its mantissa, and its range of exponents.
#[derive(Clone, Copy)]
pub(crate) struct Binary {
    mantissa: i64,
    /// Exponent of the least positive number.
    least: i64,
    /// Largest exponent of a finite number.
    greatest: i64,
}

/// `f32`
pub(crate) const SINGLE: Binary = Binary { mantissa: 24, least: -149, greatest: 127 };
/// `f64`
pub(crate) const DOUBLE: Binary = Binary { mantissa: 53, least: -1074, greatest: 1023 };

/// Returns the nearest `f64` to a rational number, ties to even, including subnormal numbers and
/// overflow.
pub(crate) fn nearest_f64(value: &Rational) -> f64 {
    nearest(value.numer(), value.denom(), DOUBLE)
}

/// Returns the number of a binary format that is nearest to a quotient with a positive denominator,
/// ties to even, including subnormal numbers and overflow. The quotient need not be in lowest
/// terms.
pub(crate) fn nearest(numerator: &BigInt, denominator: &BigInt, format: Binary) -> f64 {
    if numerator.is_zero() {
        return 0.0;
    }
    let negative = numerator.is_negative();
    let numerator = numerator.abs();
    // 2^exponent <= |value| < 2^(exponent + 1)
    let mut exponent = numerator.bits() as i64 - denominator.bits() as i64;
    let below = if exponent >= 0 {
        numerator < denominator << exponent
    } else {
        &numerator << -exponent < *denominator
    };
    exponent -= i64::from(below);
    if exponent > format.greatest {
        return if negative { f64::NEG_INFINITY } else { f64::INFINITY };
    }
    let unit = (exponent - format.mantissa + 1).max(format.least);
    let (numerator, denominator) =
        if unit > 0 { (numerator, denominator << unit) } else { (numerator << -unit, denominator.clone()) };
    let (quotient, remainder) = numerator.div_rem(&denominator);
    let mut mantissa = quotient.to_u64().expect("a mantissa has at most 53 bits");
    let twice = remainder << 1;
    if twice > denominator || (twice == denominator && mantissa % 2 == 1) {
        mantissa += 1;
    }
    let magnitude = mantissa as f64 * power_of_two(unit);
    let overflows = magnitude > power_of_two(format.greatest) * (2.0 - power_of_two(1 - format.mantissa));
    match (overflows, negative) {
        (true, false) => f64::INFINITY,
        (true, true) => f64::NEG_INFINITY,
        (false, false) => magnitude,
        (false, true) => -magnitude,
    }
}

/// Returns 2^exponent for −1074 ≤ exponent ≤ 1023.
fn power_of_two(exponent: i64) -> f64 {
    let bits = if exponent >= -1022 { ((exponent + 1023) as u64) << 52 } else { 1u64 << (exponent + 1074) };
    f64::from_bits(bits)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rational(text: &str) -> Rational {
        text.parse().expect("a fraction")
    }

    #[test]
    fn a_number_is_rounded_once_to_the_nearest() {
        let tiny = Rational::new(1.into(), BigInt::from(2).pow(1074));
        let cases = [
            (rational("1/3"), 1.0 / 3.0),
            (rational("-1/10"), -0.1),
            (rational("9007199254740993"), 9007199254740992.0),
            (rational("9007199254740995"), 9007199254740996.0),
            (tiny.clone(), f64::from_bits(1)),
            (&tiny / rational("2"), 0.0),
            (&tiny * rational("3/2"), f64::from_bits(2)),
            (Rational::from_integer(BigInt::from(2).pow(1024)), f64::INFINITY),
            (Rational::from_integer(BigInt::from(2).pow(1024) - 1), f64::INFINITY),
            (rational("0"), 0.0),
        ];
        for (value, expected) in cases {
            assert_eq!(nearest_f64(&value), expected, "{value}");
        }
    }

    #[test]
    fn a_quotient_is_rounded_once_to_single_precision() {
        let f32_of = |value: f64| {
            let exact = Rational::from_float(value).expect("finite");
            nearest(exact.numer(), exact.denom(), SINGLE)
        };
        let cases =
            [0.1, -1.0 / 3.0, 1e-40, 7e-46, 1.4e-45, 3.4028235e38, 3.402823669e38, 1e39, -1e300, 16777217.0];
        for value in cases {
            assert_eq!(f32_of(value), f64::from(value as f32), "{value}");
        }
    }

    #[test]
    fn every_double_is_its_own_nearest() {
        for value in [1.0, 0.1, 1e300, 1e-300, 5e-324, f64::MAX, f64::MIN_POSITIVE, -123.456] {
            assert_eq!(nearest_f64(&Rational::from_float(value).expect("finite")), value);
        }
    }

    #[test]
    fn the_words_of_a_number_sum_to_it() {
        let sum = |words: &[f64]| -> Rational {
            words.iter().map(|&word| Rational::from_float(word).expect("finite")).sum()
        };
        for text in ["1/3", "-1/10", "9007199254740993", "1/7000000000000000000000000000000", "3", "0"] {
            let constant = Constant::rational(rational(text));
            let words = constant.words(5);
            let error = (sum(&words) - &constant.factor).abs();
            let bound = constant.factor.abs() / Rational::from_integer(BigInt::from(2).pow(5 * 53));
            assert!(error <= bound, "{text}: {words:?}");
        }
        assert_eq!(Constant::integer(3).words(5), [3.0]);
        assert_eq!(Constant::rational(rational("9007199254740993")).words(5), [9007199254740992.0, 1.0]);
        assert_eq!(Constant::pi().words(2), [std::f64::consts::PI, 1.2246467991473532e-16]);
        let huge = Constant::rational(Rational::from_integer(BigInt::from(2).pow(1024)));
        assert_eq!(huge.words(5), [f64::INFINITY]);
    }

    #[test]
    fn multiples_of_powers_of_pi_are_rounded_once() {
        use std::f64::consts;
        let scaled = |factor: &str, pi_exponent| Constant { factor: rational(factor), pi_exponent }.to_f64();
        assert_eq!(scaled("1", 1), consts::PI);
        assert_eq!(scaled("1/3", 1), consts::FRAC_PI_3);
        assert_eq!(scaled("2", -1), consts::FRAC_2_PI);
        assert_eq!(scaled("1", 2), 9.869604401089358);
    }
}
