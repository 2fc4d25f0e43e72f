//! Arithmetic modulo the Mersenne prime p = 2⁶¹ − 1; residues are `u64` below p.

use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// p = 2⁶¹ − 1.
pub const PRIME: u64 = (1 << 61) - 1;

/// Returns the residue of any word.
#[inline]
pub fn reduce(number: u64) -> u64 {
    let folded = (number & PRIME) + (number >> 61);
    if folded >= PRIME { folded - PRIME } else { folded }
}

/// a + b
#[inline]
pub fn add(a: u64, b: u64) -> u64 {
    let sum = a + b;
    if sum >= PRIME { sum - PRIME } else { sum }
}

/// a − b
#[inline]
pub fn sub(a: u64, b: u64) -> u64 {
    if a >= b { a - b } else { a + PRIME - b }
}

/// −a
#[inline]
pub fn neg(a: u64) -> u64 {
    if a == 0 { 0 } else { PRIME - a }
}

/// a·b, folded by 2⁶¹ ≡ 1.
#[inline]
pub fn mul(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    let folded = (product as u64 & PRIME) + (product >> 61) as u64;
    if folded >= PRIME { folded - PRIME } else { folded }
}

/// aⁿ, with a⁰ = 1.
pub fn pow(a: u64, n: u64) -> u64 {
    let mut result = 1;
    let mut square = a;
    let mut rest = n;
    while rest != 0 {
        if rest & 1 == 1 {
            result = mul(result, square);
        }
        square = mul(square, square);
        rest >>= 1;
    }
    result
}

/// 1/a = aᵖ⁻², where a ≠ 0.
pub fn inverse(a: u64) -> Option<u64> {
    (a != 0).then(|| pow(a, PRIME - 2))
}

/// Returns a square root if a is a quadratic residue: p ≡ 3 (mod 4), so it is a^((p+1)/4) =
/// a^(2⁵⁹).
pub fn sqrt(a: u64) -> Option<u64> {
    let mut root = a;
    for _ in 0..59 {
        root = mul(root, root);
    }
    (mul(root, root) == a).then_some(root)
}

/// Returns the residue of a signed word.
#[inline]
pub fn from_i64(number: i64) -> u64 {
    let size = reduce(number.unsigned_abs());
    if number < 0 { neg(size) } else { size }
}

/// Returns the residue of a signed double word.
pub fn from_i128(number: i128) -> u64 {
    let size = number.unsigned_abs();
    let low = reduce(size as u64 & PRIME);
    let middle = reduce((size >> 61) as u64 & PRIME);
    let high = reduce((size >> 122) as u64);
    let residue = add(add(low, middle), high);
    if number < 0 { neg(residue) } else { residue }
}

/// Returns the residue of an integer.
pub fn from_integer(number: &BigInt) -> u64 {
    if let Some(word) = number.to_i64() {
        return from_i64(word);
    }
    number.mod_floor(&BigInt::from(PRIME)).to_u64().expect("a residue is below p")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn by_wide_division(a: u64, b: u64) -> u64 {
        (u128::from(a) * u128::from(b) % u128::from(PRIME)) as u64
    }

    proptest! {
        #[test]
        fn product_is_the_remainder_of_the_wide_product(a in 0..PRIME, b in 0..PRIME) {
            prop_assert_eq!(mul(a, b), by_wide_division(a, b));
        }

        #[test]
        fn inverse_times_number_is_one(a in 1..PRIME) {
            prop_assert_eq!(inverse(a).map(|inverse| mul(a, inverse)), Some(1));
        }

        #[test]
        fn just_one_of_a_and_minus_a_is_a_square(a in 1..PRIME) {
            prop_assert!(sqrt(a).is_some() != sqrt(neg(a)).is_some());
            let square = mul(a, a);
            let root = sqrt(square).expect("a square has a root");
            prop_assert!(root == a || root == neg(a));
        }

        #[test]
        fn words_of_every_size_reduce_alike(number: i128, small: i64) {
            prop_assert_eq!(from_i128(number), from_integer(&BigInt::from(number)));
            prop_assert_eq!(from_i64(small), from_integer(&BigInt::from(small)));
        }
    }

    #[test]
    fn zero_has_no_inverse_and_is_its_own_root() {
        assert_eq!((inverse(0), sqrt(0)), (None, Some(0)));
        assert_eq!((reduce(PRIME), reduce(u64::MAX), add(PRIME - 1, 1)), (0, 7, 0));
    }
}
