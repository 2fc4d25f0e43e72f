//! The angles of a sine, a cosine, a tangent and a point.

use super::pair::{Pair, fast_two_sum, pair, quotient, two_product, two_sum};
use super::word::Word;

/// arcsin t = t + t³ A(t²) of |t| ≤ 1/2; beyond, arcsin |x| = π/2 − 2 arcsin t with t² = (1 − |x|)/2.
/// Gives the pair t, t³ A(t²), and whether |x| > 1/2.
#[inline(always)]
fn half_angle<W: Word>(x: W) -> (Pair<W>, bool) {
    let half = W::literal(0.5);
    let large = x.magnitude() > half;
    let complement = half * (W::literal(1.0) - x.magnitude());
    let square = if large { complement } else { x * x };
    let root = complement.root();
    let product = two_product(root, root);
    let rest = ((complement - product.head) - product.tail) * half / root;
    let rest = if complement > W::literal(0.0) { rest } else { complement };
    let t = if large { pair(root, rest) } else { pair(x.magnitude(), W::literal(0.0)) };
    (pair(t.head, (t.head * square).fused(square.polynomial(W::TABLE.asin), t.tail)), large)
}

/// The angle in [−π/2, π/2] of that sine.
#[inline(always)]
pub(super) fn asin<W: Word>(x: W) -> W {
    let (t, large) = half_angle(x);
    let right_angle = Pair::of(W::TABLE.quarters_pi, 1);
    let two = W::literal(2.0);
    let outer = two_sum(right_angle.head, -two * t.head);
    let outer = outer.head + ((outer.tail + right_angle.tail) - two * t.tail);
    let value = (if large { outer } else { t.rounded() }).with_sign(x);
    if x.magnitude() < W::two_to(-W::PRECISION / 2 - 1) { x } else { value }
}

/// The angle in [0, π] of that cosine: π/2 − arcsin x, or 2 arcsin t, from π where x is negative.
#[inline(always)]
pub(super) fn acos<W: Word>(x: W) -> W {
    let (t, large) = half_angle(x);
    let (zero, two) = (W::literal(0.0), W::literal(2.0));
    let negative = x < zero;
    let right_angle = Pair::of(W::TABLE.quarters_pi, 1);
    let straight_angle = Pair::of(W::TABLE.quarters_pi, 3);
    let base = if negative { straight_angle } else { pair(zero, zero) };
    let base = if large { base } else { right_angle };
    let factor = if large { two } else { -W::literal(1.0) };
    let factor = if negative { -factor } else { factor };
    let sum = two_sum(base.head, factor * t.head);
    sum.head + ((sum.tail + base.tail) + factor * t.tail)
}

/// The angle in (−π/2, π/2) of that tangent.
#[inline(always)]
pub(super) fn atan<W: Word>(x: W) -> W {
    atan2(x, W::literal(1.0))
}

/// The angle in (−π, π] of the point (x, y): of the nearest multiple of π/4 with |y|/|x| in the first octants,
/// and of t + t³ A(t²) with t the tangent of what is left, |t| ≤ tan(π/8).
#[inline(always)]
pub(super) fn atan2<W: Word>(y: W, x: W) -> W {
    let (height, width) = within_reach(y.magnitude(), x.magnitude());
    let zero = W::literal(0.0);
    let tangent = W::literal(std::f64::consts::SQRT_2 - 1.0);
    let (low, high) = (height < tangent * width, width < tangent * height);
    let (difference, sum) = (two_sum(height, -width), two_sum(height, width));
    let numerator = if low { pair(height, zero) } else { difference };
    let denominator = if low { pair(width, zero) } else { sum };
    let numerator = if high { pair(-width, zero) } else { numerator };
    let denominator = if high { pair(height, zero) } else { denominator };
    let t = tangent_of(numerator, denominator);
    let backwards = W::literal(1.0).with_sign(x) < zero;
    from_octant(t, low, high, backwards).with_sign(y)
}

/// n/d, to twice the precision unless it is so small that this has no use.
#[inline(always)]
fn tangent_of<W: Word>(numerator: Pair<W>, denominator: Pair<W>) -> Pair<W> {
    let t = quotient(numerator, denominator);
    let tail = if t.head.magnitude() < W::two_to(W::SMALL) { W::literal(0.0) } else { t.tail };
    pair(t.head, tail)
}

/// The multiple of π/4 plus arctan t, or the same from π backwards.
#[inline(always)]
fn from_octant<W: Word>(t: Pair<W>, low: bool, high: bool, backwards: bool) -> W {
    let quarter = |count: usize| Pair::<W>::of(W::TABLE.quarters_pi, count - 1);
    let none = pair(W::literal(0.0), W::literal(0.0));
    let beside = if backwards { quarter(4) } else { none };
    let diagonal = if backwards { quarter(3) } else { quarter(1) };
    let base = if low { beside } else { diagonal };
    let base = if high { quarter(2) } else { base };
    let one = W::literal(1.0);
    let direction = if backwards { -one } else { one };
    let square = t.head * t.head;
    let tail = t.tail - t.tail * square;
    let series = (t.head * square).fused(square.polynomial(W::TABLE.atan), tail);
    let sum = fast_two_sum(base.head, direction * t.head);
    sum.head + direction.fused(series, sum.tail + base.tail)
}

/// The point scaled by a power of two so that no sum or quotient of its coordinates overflows or loses bits that count;
/// infinite coordinates become 1 beside 0, and the origin (0, 1).
#[inline(always)]
fn within_reach<W: Word>(height: W, width: W) -> (W, W) {
    let larger = if height > width { height } else { width };
    let (one, large) = (W::literal(1.0), W::two_to(W::LARGE));
    let scale = if larger < one { W::two_to(W::LARGE / 2) } else { one };
    let scale = if larger > large { W::two_to(W::LARGE - W::LARGEST_EXPONENT - 1) } else { scale };
    let infinite = larger >= W::infinity();
    let of_infinite = |side: W| {
        let flattened = side * W::literal(0.0);
        if side >= W::infinity() { one } else { flattened }
    };
    let height_value = if infinite { of_infinite(height) } else { height * scale };
    let width_value = if infinite { of_infinite(width) } else { width * scale };
    let width_value = if larger <= W::literal(0.0) { one } else { width_value };
    (height_value, width_value)
}
