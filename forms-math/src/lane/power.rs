//! x^(n/d): products and roots where the exponent is an integer, a half or a third, else
//! e^(n/d · ln x).
//!
//! The exponent is the same in all lanes, so that branches on it are possible. Products of up to
//! three factors are computed directly; for more factors, or for roots, each intermediate value is
//! a pair. If such a value leaves the range in which pairs are valid, the power is NaN.

use super::exponential::exp_of_sum;
use super::logarithm::ln_pair;
use super::pair::{Pair, fast_two_sum, pair, quotient, two_product};
use super::word::Word;

/// Computes x^(numerator/denominator) for x > 0, for x = 0 if the exponent is positive, and for
/// x < 0 if it is an integer.
#[inline(always)]
pub(super) fn power<W: Word>(x: W, numerator: i64, denominator: i64) -> W {
    match (numerator, denominator) {
        (_, 0) => W::not_a_number(),
        (0, _) => W::literal(1.0),
        (n, d) if d < 0 => power_of(x, n.wrapping_neg(), d.wrapping_neg()),
        (n, d) => power_of(x, n, d),
    }
}

/// Computes the power for a positive denominator.
#[inline(always)]
fn power_of<W: Word>(x: W, numerator: i64, denominator: i64) -> W {
    match (numerator, denominator) {
        (1, 1) => x,
        (2, 1) => x * x,
        (3, 1) => x * x * x,
        (-1, 1) => W::literal(1.0) / x,
        (-2, 1) => W::literal(1.0) / in_reach(x * x, x * x),
        (1, 2) => x.root(),
        (-1, 2) => W::literal(1.0) / x.root(),
        (3, 2) => x * x.root(),
        (n, 1) => of_pair(x, pair(x, W::literal(0.0)), n),
        (n, 2) => of_pair(x, square_root(x), n),
        (n, 3) => of_pair(x, cube_root(x), n),
        (n, d) => by_logarithm(x, n, d),
    }
}

/// Returns `value` if `magnitude` is in the range in which pairs are valid, else NaN.
#[inline(always)]
fn in_reach<W: Word>(magnitude: W, value: W) -> W {
    let above = if magnitude > W::two_to(W::SMALL) { value } else { W::not_a_number() };
    if magnitude < W::two_to(W::LARGE) { above } else { W::not_a_number() }
}

/// Computes an integer power of the base, which is a root of x; zero to a positive power is zero.
#[inline(always)]
fn of_pair<W: Word>(x: W, base: Pair<W>, exponent: i64) -> W {
    let mut count = exponent.unsigned_abs();
    let mut square = base;
    let mut product = pair(W::literal(1.0), W::literal(0.0));
    while count > 0 {
        if count & 1 == 1 {
            product = product.times(square);
        }
        square = square.times(square);
        count >>= 1;
    }
    let value = if exponent < 0 { product.reciprocal() } else { product };
    let value = in_reach(product.head.magnitude(), value.rounded());
    let value = in_reach(x.magnitude(), value);
    if exponent > 0 && x.magnitude() <= W::literal(0.0) { W::literal(0.0) } else { value }
}

/// Computes √x as a pair: s, and (x − s²)/(2s).
#[inline(always)]
fn square_root<W: Word>(x: W) -> Pair<W> {
    let root = x.root();
    let square = two_product(root, root);
    pair(root, ((x - square.head) - square.tail) * W::literal(0.5) / root)
}

/// Computes √(x² + y²). Gives up where a square can leave the range.
#[inline(always)]
pub(super) fn hypotenuse<W: Word>(x: W, y: W) -> W {
    let (width, height) = (x.magnitude(), y.magnitude());
    let larger = if width < height { height } else { width };
    let (square, other) = (two_product(x, x), two_product(y, y));
    let value = ((square.head + other.head) + (square.tail + other.tail)).root();
    let above = if larger > W::two_to(W::SMALL / 2) { value } else { W::not_a_number() };
    let inside = if larger < W::two_to(W::LARGE / 2) { above } else { W::not_a_number() };
    if larger <= W::literal(0.0) { width + height } else { inside }
}

/// Computes ∛x as a pair: y = e^(ln x / 3), and (x − y³)/(3 y²).
#[inline(always)]
fn cube_root<W: Word>(x: W) -> Pair<W> {
    let root = by_logarithm(x, 1, 3);
    let cube = two_product(root, root).times(pair(root, W::literal(0.0)));
    pair(root, ((x - cube.head) - cube.tail) / (W::literal(3.0) * root * root))
}

/// Computes e^(n/d · ln x).
#[inline(always)]
fn by_logarithm<W: Word>(x: W, numerator: i64, denominator: i64) -> W {
    let exponent = fraction(numerator, denominator);
    let value = in_reach(x, exp_of_sum(exponent.times(ln_pair(x))));
    if numerator > 0 && x.magnitude() <= W::literal(0.0) { W::literal(0.0) } else { value }
}

/// Returns n/d as a pair; NaN if n or d is not exact.
#[inline(always)]
fn fraction<W: Word>(numerator: i64, denominator: i64) -> Pair<W> {
    let exact = |integer: i64| {
        let (head, bound) = (W::literal(integer as f64), 1_u64 << W::PRECISION);
        if integer.unsigned_abs() <= bound { head } else { W::not_a_number() }
    };
    let zero = W::literal(0.0);
    let value = quotient(pair(exact(numerator), zero), pair(exact(denominator), zero));
    fast_two_sum(value.head, value.tail)
}
