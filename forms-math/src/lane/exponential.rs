//! eˣ, eˣ − 1 and the hyperbolic functions: x = k ln 2 + r, and a polynomial of r.

use super::pair::{Pair, fast_two_sum, pair, quotient, two_product, two_sum};
use super::word::Word;
use core::hint::select_unpredictable;

/// log₂ 3
const LOG2_3: f64 = 1.584_962_500_721_156_2;

/// Returns (k, r) with x = k ln 2 + r and |r| ≤ (ln 2)/2, with r as a pair.
#[inline(always)]
fn reduce<W: Word>(x: W) -> (W, Pair<W>) {
    let multiple = (x * W::of(W::TABLE.log2_e)).shifted().unshifted();
    let rest = multiple.fused(-W::of(W::TABLE.ln_2[0]), x);
    let tail = multiple * W::of(W::TABLE.ln_2[1]);
    let head = rest - tail;
    (multiple, pair(head, (rest - head) - tail))
}

/// Clamps x to the bounds, beyond which the function has its limit. Both selections are always
/// computed, each by one instruction; branches would be merged.
#[inline(always)]
fn clamped<W: Word>(x: W, low: f64, high: f64) -> W {
    let x = select_unpredictable(x < W::literal(low), W::literal(low), x);
    select_unpredictable(x > W::literal(high), W::literal(high), x)
}

/// Returns the arguments at which eˣ is certainly 0 and certainly ∞.
#[inline(always)]
fn limits<W: Word>() -> (f64, f64) {
    let largest = f64::from(W::LARGEST_EXPONENT + 1);
    (
        -(largest + f64::from(W::PRECISION) + 1.0) * core::f64::consts::LN_2,
        largest * core::f64::consts::LN_2 + 1.0,
    )
}

/// Returns the arguments at which the power in [`parts`] is 0, and ∞ with r < 0.
#[inline(always)]
fn ends<W: Word>() -> (f64, f64) {
    let (least, largest) = (W::LARGEST_EXPONENT + W::PRECISION, W::LARGEST_EXPONENT + 1 - W::PRECISION);
    (-f64::from(least) * core::f64::consts::LN_2, (f64::from(largest) - 0.25) * core::f64::consts::LN_2)
}

/// Computes y 2^k in two steps, so that k can be out of the range of exponents and only the last
/// step rounds.
#[inline(always)]
pub(super) fn scaled<W: Word>(y: W, k: W) -> W {
    let half = (k * W::literal(0.5)).shifted().unshifted();
    y * half.power_of_two() * (k - half).power_of_two()
}

/// Returns (2^k, 1 − eʳ) for x = k ln 2 + r with ¾ ≤ eʳ < 3/2: k = 0 wherever eˣ − 1 is small, so
/// that no difference is needed there. Far below the logarithm of the least number, 2^k is 0; near
/// overflow it is ∞ with r < 0, for which both functions are NaN.
#[inline(always)]
fn parts<W: Word>(x: W) -> (W, W) {
    let (low, high) = ends::<W>();
    let x = clamped(x, low, high);
    let centred = x.fused(W::of(W::TABLE.log2_e), W::literal(1.5 - LOG2_3));
    let (opposite, power) = centred.opposite_exponent_and_power();
    let opposite_r = opposite.fused(-W::of(W::TABLE.ln_2[0]), -x);
    let opposite_r = opposite.fused(-W::of(W::TABLE.ln_2[1]), opposite_r);
    let square = opposite_r * opposite_r;
    (power, (-square).fused((-opposite_r).polynomial(W::TABLE.exp), opposite_r))
}

/// Computes eˣ = 2^k − 2^k (1 − eʳ). Gives up near overflow.
#[inline(always)]
pub(super) fn exp<W: Word>(x: W) -> W {
    let (power, complement) = parts(x);
    (-power).fused(complement, power)
}

/// Computes eˣ of a pair.
#[inline(always)]
pub(super) fn exp_of_sum<W: Word>(x: Pair<W>) -> W {
    let (low, high) = limits::<W>();
    let (k, r) = reduce(clamped(x.head, low, high));
    from_rest(k, two_sum(r.head, r.tail + x.tail))
}

/// Computes 2^k eʳ.
#[inline(always)]
fn from_rest<W: Word>(k: W, r: Pair<W>) -> W {
    let square = r.head * r.head;
    let sum = r.head + square.fused(r.head.polynomial(W::TABLE.exp), r.tail);
    scaled(W::literal(1.0) + sum, k)
}

/// Computes eˣ − 1 = −2^k (1 − eʳ) − (1 − 2^k): the signs ensure that −0 gives −0. Gives up near
/// overflow. The steps before the sum equal those of [`exp`], so that they are shared if both
/// functions are needed.
#[inline(always)]
pub(super) fn exp_m1<W: Word>(x: W) -> W {
    let (power, complement) = parts(x);
    (-power).fused(complement, -(W::literal(1.0) - power))
}

/// Computes 2^−k, or its limit 0 if it is far below a rounding error of 1.
#[inline(always)]
fn inverse_power<W: Word>(k: W) -> W {
    let bound = W::literal(f64::from(2 * W::PRECISION + 10));
    let power = (-(if k > bound { bound } else { k })).power_of_two();
    if k > bound { W::literal(0.0) } else { power }
}

/// Computes 2^(1−k) (sinh |x|, cosh |x|), and k, from sinh r and cosh r: with C = 1 + 4^−k and
/// S = 1 − 4^−k, the values are S cosh r + C sinh r and C cosh r + S sinh r.
#[inline(always)]
fn sinh_cosh<W: Word>(x: W) -> (Pair<W>, Pair<W>, W) {
    let (k, r) = reduce(x.magnitude());
    let one = W::literal(1.0);
    let power = inverse_power(k + k);
    let (larger, smaller) = (fast_two_sum(one, power), fast_two_sum(one, -power));
    let square = r.head * r.head;
    let sinh = r.head.fused(square * square.polynomial(W::TABLE.sinh), r.tail);
    let cosh = square.fused(square.polynomial(W::TABLE.cosh), W::literal(0.5)) * square + r.head * r.tail;
    let combine = |of_cosh: Pair<W>, of_sinh: Pair<W>| {
        let product = two_product(of_sinh.head, r.head);
        let sum = two_sum(of_cosh.head, product.head);
        let rest = of_cosh.head.fused(cosh, of_sinh.head * sinh);
        let tails = of_sinh.tail.fused(r.head, of_cosh.tail);
        pair(sum.head, (sum.tail + product.tail + tails) + rest)
    };
    (combine(smaller, larger), combine(larger, smaller), k)
}

/// (eˣ − e^−x)/2
#[inline(always)]
pub(super) fn sinh<W: Word>(x: W) -> W {
    let (_, high) = limits::<W>();
    let (sinh, _, k) = sinh_cosh(clamped(x, -high, high));
    let value = scaled(sinh.rounded() * W::literal(0.5), k).with_sign(x);
    if x.magnitude() < W::two_to(-W::PRECISION / 2 - 1) { x } else { value }
}

/// (eˣ + e^−x)/2
#[inline(always)]
pub(super) fn cosh<W: Word>(x: W) -> W {
    let (_, high) = limits::<W>();
    let (_, cosh, k) = sinh_cosh(clamped(x, -high, high));
    scaled(cosh.rounded() * W::literal(0.5), k)
}

/// sinh x / cosh x
#[inline(always)]
pub(super) fn tanh<W: Word>(x: W) -> W {
    let high = f64::from(W::PRECISION) / 2.0;
    let (sinh, cosh, _) = sinh_cosh(clamped(x, -high, high));
    let ratio = quotient(sinh.normal(), cosh.normal()).rounded().with_sign(x);
    if x.magnitude() < W::two_to(-W::PRECISION / 2 - 1) { x } else { ratio }
}
