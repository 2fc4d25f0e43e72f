//! ln x, ln(1 + x), and ln x beyond the precision of the format: x = 2^k m with √½ ≤ m < √2, and
//! with f = m − 1 and s = f/(2 + f), ln m = 2 artanh s.

use super::pair::{Pair, fast_two_sum, pair, quotient, two_product, two_sum};
use super::word::Word;

/// Computes k ln 2 + ln(1 + f + rest) for a rest below a rounding error of f:
/// ln(1 + f) = f − (h − s (h + s² P(s²))) with h = f²/2, in which the rounded part is small
/// compared with f.
#[inline(always)]
fn combine<W: Word>(k: W, f: W, rest: W) -> W {
    let s = f / (W::literal(2.0) + f);
    let square = s * s;
    let h = W::literal(0.5) * f * f;
    let series = square * square.polynomial(W::TABLE.ln);
    let tail = k.fused(W::of(W::TABLE.ln_2[1]), rest);
    k * W::of(W::TABLE.ln_2[0]) - ((h - s.fused(h + series, tail)) - f)
}

/// Returns the value for a positive position, −∞ at the pole (position 0), and NaN below it; ∞ and
/// NaN pass through.
#[inline(always)]
fn on_domain<W: Word>(position: W, value: W) -> W {
    let zero = W::literal(0.0);
    let below = if position < zero { W::not_a_number() } else { -W::infinity() };
    let inside = if position < W::infinity() { value } else { position };
    let outside = if position <= zero { below } else { position };
    if position > zero { inside } else { outside }
}

/// ln x
#[inline(always)]
pub(super) fn ln<W: Word>(x: W) -> W {
    let subnormal = x < W::two_to(1 - W::LARGEST_EXPONENT);
    let scale = f64::from(W::PRECISION + 1);
    let normal = if subnormal { x * W::two_to(W::PRECISION + 1) } else { x };
    let (k, m) = normal.split();
    let k = if subnormal { k - W::literal(scale) } else { k };
    on_domain(x, combine(k, m - W::literal(1.0), W::literal(0.0)))
}

/// Computes ln(1 + x): the rounding error of 1 + x is added to f.
#[inline(always)]
pub(super) fn ln_1p<W: Word>(x: W) -> W {
    let one = W::literal(1.0);
    let sum = two_sum(one, x);
    let (k, m) = sum.head.split();
    let limit = W::literal(f64::from(2 * W::PRECISION));
    let rest = if k > limit {
        W::literal(0.0)
    } else {
        sum.tail * (-(if k > limit { limit } else { k })).power_of_two()
    };
    let f = fast_two_sum(m - one, rest);
    let value = on_domain(sum.head, combine(k, f.head, f.tail));
    if x.magnitude() < W::two_to(-W::PRECISION - 1) { x } else { value }
}

/// Computes ln x of a positive normal x with 10 bits more than the format; near 1 this accuracy is
/// absolute. The terms 2 s + (2/3) s³ are pairs, and the rest of the series is a single number.
#[inline(always)]
pub(super) fn ln_pair<W: Word>(x: W) -> Pair<W> {
    let (k, m) = x.split();
    let f = m - W::literal(1.0);
    let s = quotient(pair(f, W::literal(0.0)), fast_two_sum(W::literal(2.0), f)).normal();
    let square = s.times(s);
    let cubic = Pair::of(W::TABLE.two_thirds, 0).times(square).times(s);
    let rest = s.head * square.head * square.head * square.head.polynomial(W::TABLE.ln_tail);
    let linear = two_sum(k * W::of(W::TABLE.ln_2[0]), s.head + s.head);
    let sum = two_sum(linear.head, cubic.head);
    let of_exponent = two_product(k, W::of(W::TABLE.ln_2[1]));
    let tail = (s.tail + s.tail) + cubic.tail + rest + of_exponent.tail;
    let sum_of_small = two_sum(linear.tail + sum.tail, of_exponent.head);
    pair(sum.head, sum_of_small.head + (sum_of_small.tail + tail)).normal()
}
