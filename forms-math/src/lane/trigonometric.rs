//! sin, cos and tan: x = k π/2 + r with |r| ≤ π/4, polynomials of r, and the quadrant k mod 4.
//!
//! π/2 is subtracted in parts whose products with k are exact (Cody and Waite). This holds for k
//! below 2^20, 2^12 in `f32`. Beyond that the value is NaN.

use super::pair::{Pair, fast_two_sum, pair, quotient, two_sum};
use super::word::Word;

/// Returns k with its integer in the low bits, and r as a pair; r is NaN if x is out of range.
#[inline(always)]
fn reduce<W: Word>(x: W) -> (W, Pair<W>) {
    let shifted = (x * W::of(W::TABLE.two_over_pi)).shifted();
    let k = shifted.unshifted();
    let parts = W::TABLE.half_pi;
    let reach = W::two_to(W::MULTIPLE_BITS);
    let x = if k.magnitude() < reach { x } else { W::not_a_number() };
    let mut rest = pair(x - k * W::of(parts[0]), W::literal(0.0));
    for &part in &parts[1..parts.len() - 1] {
        let difference = two_sum(rest.head, -(k * W::of(part)));
        rest = pair(difference.head, rest.tail + difference.tail);
    }
    let last = k * W::of(parts[parts.len() - 1]);
    (shifted, fast_two_sum(rest.head, rest.tail - last))
}

/// Computes sin r = r + r³ S(r²) as a pair.
#[inline(always)]
fn sine<W: Word>(r: Pair<W>) -> Pair<W> {
    let square = r.head * r.head;
    let series = r.head * square * square.polynomial(W::TABLE.sin);
    let tail = (-W::literal(0.5) * square).fused(r.tail, r.tail);
    fast_two_sum(r.head, series + tail)
}

/// Computes cos r = 1 − r²/2 + r⁴ C(r²) as a pair.
#[inline(always)]
fn cosine<W: Word>(r: Pair<W>) -> Pair<W> {
    let one = W::literal(1.0);
    let square = r.head * r.head;
    let half = W::literal(0.5) * square;
    let head = one - half;
    let series = (square * square).fused(square.polynomial(W::TABLE.cos), -(r.head * r.tail));
    fast_two_sum(head, ((one - head) - half) + series)
}

/// sin x
#[inline(always)]
pub(super) fn sin<W: Word>(x: W) -> W {
    let (k, r) = reduce(x);
    let value = W::if_odd(k, cosine(r).head, sine(r).head).negated_by_second_bit(k);
    if x.magnitude() < W::two_to(-W::PRECISION / 2 - 1) { x } else { value }
}

/// cos x = sin(x + π/2)
#[inline(always)]
pub(super) fn cos<W: Word>(x: W) -> W {
    let (k, r) = reduce(x);
    let next = k + W::literal(1.0);
    W::if_odd(k, sine(r).head, cosine(r).head).negated_by_second_bit(next)
}

/// Computes sin x / cos x as a quotient of pairs; in odd quadrants −cos r / sin r.
#[inline(always)]
pub(super) fn tan<W: Word>(x: W) -> W {
    let (k, r) = reduce(x);
    let (sine, cosine) = (sine(r), cosine(r));
    let choose = |odd: Pair<W>, even: Pair<W>| {
        pair(W::if_odd(k, odd.head, even.head), W::if_odd(k, odd.tail, even.tail))
    };
    let numerator = choose(pair(-cosine.head, -cosine.tail), sine);
    let value = quotient(numerator, choose(sine, cosine)).rounded();
    if x.magnitude() < W::two_to(-W::PRECISION / 2 - 1) { x } else { value }
}
