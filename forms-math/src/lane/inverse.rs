//! Inverse trigonometric functions: the angles of a sine, a cosine, a tangent and a point.

use super::pair::{Pair, pair, two_product, two_sum};
use super::word::Word;

/// Computes arcsin t = t + t³ A(t²) for |t| ≤ 1/2; beyond, arcsin |x| = π/2 − 2 arcsin t with
/// t² = (1 − |x|)/2. Returns the pair t, t³ A(t²), and whether |x| > 1/2.
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

/// Returns the angle in [−π/2, π/2] with this sine.
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

/// Returns the angle in [0, π] with this cosine: π/2 − arcsin x, or 2 arcsin t, subtracted from π
/// if x is negative.
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

/// Returns the angle in (−π/2, π/2) with this tangent.
#[inline(always)]
pub(super) fn atan<W: Word>(x: W) -> W {
    atan2(x, W::literal(1.0))
}

/// Returns the angle in (−π, π] of the point (x, y): t + t³ A(t²). Here t is the ratio of the
/// smaller to the larger coordinate or, from half a radian on, the tangent of the angle from the
/// diagonal. The result is reflected into the octant of (|x|, |y|), and then of (x, y). Gives up at
/// the origin and where coordinates are near overflow.
#[inline(always)]
pub(super) fn atan2<W: Word>(y: W, x: W) -> W {
    let (height, width) = (y.magnitude(), x.magnitude());
    let zero = W::literal(0.0);
    let (swapped, backwards) = (width < height, x < zero);
    let larger = if swapped { height } else { width };
    let smaller = if swapped { width } else { height };
    let near_diagonal = larger * W::of(W::TABLE.atan_limit) <= smaller;
    // The difference of numbers within a factor of two is exact (Sterbenz).
    let numerator = if near_diagonal { smaller - larger } else { smaller };
    let t = numerator / if near_diagonal { smaller + larger } else { larger };
    let square = t * t;
    let angle = (t * square).fused(square.polynomial(W::TABLE.atan), t);
    // The rounding errors of these constants are below half a unit of the sum, which is at least
    // 1/2.
    let quarters = |count: usize| W::of(W::TABLE.quarters_pi[2 * (count - 1)]);
    let angle = angle + if near_diagonal { quarters(1) } else { zero };
    let angle = if swapped { quarters(2) - angle } else { angle };
    let angle = if backwards { quarters(4) - angle } else { angle };
    // Near overflow four times the larger coordinate is infinite, and 0·∞ is NaN.
    (larger * W::literal(4.0)).fused(zero, angle).with_sign(y)
}
