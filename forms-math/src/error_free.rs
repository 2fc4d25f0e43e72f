//! Error-free transformations: sums and products of two numbers as a rounded result and its exact
//! rounding error.
//!
//! Source: T. J. Dekker, A floating-point technique for extending the available precision, Numer.
//! Math. 18 (1971); D. E. Knuth, The Art of Computer Programming 2, §4.2.2.

/// Returns (sum, rest) with a + b = sum + rest exactly, if nothing overflows.
#[inline(always)]
pub(crate) const fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    let of_b = sum - a;
    (sum, (a - (sum - of_b)) + (b - of_b))
}

/// Returns (sum, rest) with a + b = sum + rest exactly, if |a| ≥ |b| or a = 0.
#[inline(always)]
pub(crate) const fn fast_two_sum(a: f64, b: f64) -> (f64, f64) {
    let sum = a + b;
    (sum, b - (sum - a))
}

/// Limit beyond which the split would overflow: 2⁹⁹⁵.
const SPLIT_LIMIT: f64 = f64::from_bits((995 + 1023) << 52);
/// Scale for numbers beyond the limit, 2⁻²⁸; the scaling and its inverse are exact.
const SPLIT_SCALE: f64 = 1.0 / (1_u64 << 28) as f64;

/// Splits a = high + low into parts with 26 bits each.
#[inline(always)]
const fn split(a: f64) -> (f64, f64) {
    const SPLITTER: f64 = ((1_u64 << 27) + 1) as f64;
    if a.abs() > SPLIT_LIMIT {
        let (high, low) = split_within(a * SPLIT_SCALE, SPLITTER);
        return (high / SPLIT_SCALE, low / SPLIT_SCALE);
    }
    split_within(a, SPLITTER)
}

#[inline(always)]
const fn split_within(a: f64, splitter: f64) -> (f64, f64) {
    let carried = splitter * a;
    let high = carried - (carried - a);
    (high, a - high)
}

/// Returns (product, rest) with a b = product + rest exactly, if the product is finite and above
/// [`EXACT_PRODUCT`] or zero.
#[inline(always)]
pub(crate) const fn two_product(a: f64, b: f64) -> (f64, f64) {
    let product = a * b;
    let (a_high, a_low) = split(a);
    let (b_high, b_low) = split(b);
    (product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

/// 2⁻⁹⁶⁹: the rounding error of a product at least this large is a normal number or zero.
pub(crate) const EXACT_PRODUCT: f64 = f64::from_bits((1023 - 969) << 52);

/// Returns `value` · 2^`exponent`, rounded once unless the result is subnormal.
#[inline]
pub(crate) fn scaled(value: f64, exponent: i64) -> f64 {
    if (-1022..=1023).contains(&exponent) {
        return value * f64::from_bits(((1023 + exponent) as u64) << 52);
    }
    scaled_in_steps(value, exponent)
}

#[cold]
fn scaled_in_steps(value: f64, exponent: i64) -> f64 {
    let mut value = value;
    let mut left = exponent.clamp(-2300, 2300);
    while left != 0 {
        let step = left.clamp(-1022, 1023);
        value *= f64::from_bits(((1023 + step) as u64) << 52);
        left -= step;
    }
    value
}

/// Splits a finite non-zero number into m 2ᵉ with ½ ≤ |m| < 1.
pub(crate) fn mantissa_and_exponent(value: f64) -> (f64, i64) {
    let bits = value.to_bits();
    let biased = (bits >> 52) & 0x7ff;
    if biased == 0 {
        let (mantissa, exponent) = mantissa_and_exponent(value * (1_u64 << 54) as f64);
        return (mantissa, exponent - 54);
    }
    (f64::from_bits((bits & !(0x7ff << 52)) | (1022 << 52)), biased as i64 - 1022)
}

/// Whether [`two_product`] returns the exact rounding error of a · b.
#[inline(always)]
pub(crate) fn has_exact_rest(product: f64, a: f64, b: f64) -> bool {
    (product.abs() >= EXACT_PRODUCT && product.abs() <= SPLIT_LIMIT)
        || (product == 0.0 && (a == 0.0 || b == 0.0))
}

/// Computes a b − c d within an ulp, for products of any size, if the result is in range.
#[inline(always)]
pub(crate) fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let (first, second) = (a * b, c * d);
    if has_exact_rest(first, a, b) && has_exact_rest(second, c, d) {
        let [value, rest, least] = difference_in_words(a, b, c, d);
        return value + (rest + least);
    }
    difference_of_scaled_products(a, b, c, d)
}

/// Returns a b − c d as a sum of three words, exact up to two more roundings of the last word, if
/// the rests of both products are exact. The second word is at most half an ulp of the first, and
/// the last is small compared with the larger of the second and the first.
#[inline(always)]
pub(crate) fn difference_in_words(a: f64, b: f64, c: f64, d: f64) -> [f64; 3] {
    let (high_first, low_first) = two_product(a, b);
    let (high_second, low_second) = two_product(c, d);
    let (high, low) = two_sum(high_first, -high_second);
    let (rest, least) = two_sum(low_first, -low_second);
    let (middle, small) = two_sum(low, rest);
    let (value, left) = two_sum(high, middle);
    [value, left, small + least]
}

/// Computes a b − c d where a product is near an end of the range: every factor is scaled to about
/// one, and the result is scaled back.
#[cold]
fn difference_of_scaled_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    if !(a.is_finite() && b.is_finite() && c.is_finite() && d.is_finite()) {
        return a * b - c * d;
    }
    let parts = |left: f64, right: f64| {
        if left == 0.0 || right == 0.0 {
            return (0.0, 0.0, i64::MIN / 2);
        }
        let ((left, left_exponent), (right, right_exponent)) =
            (mantissa_and_exponent(left), mantissa_and_exponent(right));
        (left, right, left_exponent + right_exponent)
    };
    let (a, b, first_exponent) = parts(a, b);
    let (c, d, second_exponent) = parts(c, d);
    let common = first_exponent.max(second_exponent);
    if common < -4000 {
        return 0.0;
    }
    // A product 2³⁰⁰ times smaller than the other changes it by less than half an ulp.
    let below = |exponent: i64| (exponent - common).max(-300);
    let difference =
        difference_of_products(scaled(a, below(first_exponent)), b, scaled(c, below(second_exponent)), d);
    scaled(difference, common)
}
