//! Natural numbers of any length, the least significant word first.

use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Ordering;

/// Returns the number of bits.
pub(super) fn bit_length(number: &[u64]) -> usize {
    number
        .iter()
        .rposition(|&word| word != 0)
        .map_or(0, |top| 64 * (top + 1) - number[top].leading_zeros() as usize)
}

/// Computes a + b·c + carry as (low, high) words.
#[inline(always)]
pub(super) fn multiply_add(a: u64, b: u64, c: u64, carry: u64) -> (u64, u64) {
    let sum = u128::from(a) + u128::from(b) * u128::from(c) + u128::from(carry);
    (sum as u64, (sum >> 64) as u64)
}

/// Divides by a word in place; returns the remainder.
pub(super) fn divide_by_word(number: &mut [u64], divisor: u64) -> u64 {
    let mut rest = 0_u64;
    if divisor >> 32 == 0 {
        // Half a word at a time: dividing one word is much faster than dividing two.
        for word in number.iter_mut().rev() {
            let high = (rest << 32) | (*word >> 32);
            let low = ((high % divisor) << 32) | (*word & 0xffff_ffff);
            *word = ((high / divisor) << 32) | (low / divisor);
            rest = low % divisor;
        }
        return rest;
    }
    for word in number.iter_mut().rev() {
        let part = (u128::from(rest) << 64) | u128::from(*word);
        *word = (part / u128::from(divisor)) as u64;
        rest = (part % u128::from(divisor)) as u64;
    }
    rest
}

/// Multiplies by a word in place; returns the carry.
pub(super) fn multiply_by_word(number: &mut [u64], factor: u64) -> u64 {
    let mut carry = 0;
    for word in number.iter_mut() {
        (*word, carry) = multiply_add(0, *word, factor, carry);
    }
    carry
}

/// Adds a number of the same length in place; the carry is dropped.
pub(super) fn add(number: &mut [u64], other: &[u64]) {
    let mut carry = false;
    for (word, &more) in number.iter_mut().zip(other) {
        (*word, carry) = add_with_carry(*word, more, carry);
    }
}

/// Subtracts a number of the same length that is not larger, in place.
pub(super) fn subtract(number: &mut [u64], other: &[u64]) {
    let mut borrow = false;
    for (word, &less) in number.iter_mut().zip(other) {
        (*word, borrow) = subtract_with_borrow(*word, less, borrow);
    }
}

#[inline(always)]
pub(super) fn add_with_carry(a: u64, b: u64, carry: bool) -> (u64, bool) {
    let (sum, first) = a.overflowing_add(b);
    let (sum, second) = sum.overflowing_add(u64::from(carry));
    (sum, first | second)
}

#[inline(always)]
pub(super) fn subtract_with_borrow(a: u64, b: u64, borrow: bool) -> (u64, bool) {
    let (difference, first) = a.overflowing_sub(b);
    let (difference, second) = difference.overflowing_sub(u64::from(borrow));
    (difference, first | second)
}

/// Returns number · 2^bits.
pub(super) fn shifted_left(number: &[u64], bits: usize) -> Vec<u64> {
    let (words, bits) = (bits / 64, bits % 64);
    let mut shifted = vec![0; words];
    let mut carry = 0;
    for &word in number {
        shifted.push((word << bits) | carry);
        carry = if bits == 0 { 0 } else { word >> (64 - bits) };
    }
    shifted.push(carry);
    shifted
}

/// Compares two numbers.
pub(super) fn compare(a: &[u64], b: &[u64]) -> Ordering {
    bit_length(a).cmp(&bit_length(b)).then_with(|| {
        // The bit lengths are equal, so the longer one has leading zero words.
        let words = a.len().min(b.len());
        a[..words].iter().rev().cmp(b[..words].iter().rev())
    })
}

/// Returns the quotient and the remainder, for a non-zero divisor.
///
/// Source: D. E. Knuth, The Art of Computer Programming 2, §4.3.1, algorithm D.
pub(super) fn quotient_and_remainder(number: &[u64], divisor: &[u64]) -> (Vec<u64>, Vec<u64>) {
    let length = bit_length(divisor).div_ceil(64);
    let shift = (64 * length - bit_length(divisor)) % 64;
    let mut divisor = shifted_left(&divisor[..length], shift);
    divisor.truncate(length);
    let mut left = shifted_left(number, shift);
    left.resize(left.len().max(length + 1), 0);
    let mut quotient = vec![0; left.len() - length];
    for place in (0..quotient.len()).rev() {
        quotient[place] = quotient_word(&mut left[place..=place + length], &divisor);
    }
    left.truncate(length);
    (quotient, shifted_right(&left, shift))
}

/// Computes one word of the quotient of a number with one word more than the divisor, whose first
/// bit is set; `left` becomes the remainder.
pub(super) fn quotient_word(left: &mut [u64], divisor: &[u64]) -> u64 {
    let length = divisor.len();
    let (top, first) = (left[length], divisor[length - 1]);
    let mut word = if top >= first {
        u64::MAX
    } else {
        (((u128::from(top) << 64) | u128::from(left[length - 1])) / u128::from(first)) as u64
    };
    let (mut carry, mut borrow) = (0, false);
    for (place, &part) in divisor.iter().enumerate() {
        let product;
        (product, carry) = multiply_add(0, part, word, carry);
        (left[place], borrow) = subtract_with_borrow(left[place], product, borrow);
    }
    (left[length], borrow) = subtract_with_borrow(left[length], carry, borrow);
    // The estimate is at most two too large.
    while borrow {
        word -= 1;
        let mut carry = false;
        for (place, &part) in divisor.iter().enumerate() {
            (left[place], carry) = add_with_carry(left[place], part, carry);
        }
        let over;
        (left[length], over) = add_with_carry(left[length], 0, carry);
        borrow = !over;
    }
    word
}

/// Returns number / 2^bits, for bits < 64.
fn shifted_right(number: &[u64], bits: usize) -> Vec<u64> {
    let word = |place: usize| number.get(place).copied().unwrap_or(0);
    (0..number.len())
        .map(
            |place| {
                if bits == 0 { word(place) } else { (word(place) >> bits) | (word(place + 1) << (64 - bits)) }
            },
        )
        .collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Generates words that make carries and wrong estimates likely.
    fn number(words: core::ops::Range<usize>) -> impl Strategy<Value = Vec<u64>> {
        let word =
            prop_oneof![any::<u64>(), Just(0), Just(1), Just(u64::MAX), Just(1 << 63), Just(u64::MAX - 1)];
        prop::collection::vec(word, words)
    }

    fn product(a: &[u64], b: &[u64]) -> Vec<u64> {
        let mut sum = vec![0; a.len() + b.len()];
        for (row, &factor) in a.iter().enumerate() {
            let mut carry = 0;
            for (column, &word) in b.iter().enumerate() {
                (sum[row + column], carry) = multiply_add(sum[row + column], word, factor, carry);
            }
            sum[row + b.len()] = carry;
        }
        sum
    }

    proptest! {
        #[test]
        fn quotient_times_divisor_and_remainder(mut a in number(1..9), b in number(1..5)) {
            prop_assume!(bit_length(&b) > 0);
            let (quotient, mut rest) = quotient_and_remainder(&a, &b);
            prop_assert!(compare(&rest, &b).is_lt());
            let mut sum = product(&quotient, &b);
            let length = sum.len().max(a.len()).max(rest.len());
            sum.resize(length, 0);
            rest.resize(length, 0);
            a.resize(length, 0);
            add(&mut sum, &rest);
            prop_assert_eq!(&sum, &a);
        }

        #[test]
        fn division_by_a_word_is_that_by_a_number(
            a in number(1..6),
            wide in 1..u64::MAX,
            narrow in 1..u64::from(u32::MAX),
        ) {
            for divisor in [wide, narrow] {
                let (quotient, rest) = quotient_and_remainder(&a, &[divisor]);
                let mut by_word = a.clone();
                let rest_by_word = divide_by_word(&mut by_word, divisor);
                prop_assert_eq!(rest.first(), Some(&rest_by_word));
                prop_assert!(compare(&quotient, &by_word).is_eq());
            }
        }
    }
}
