//! Sums and products without rounding, as a number and what its rounding left.
//!
//! Dekker, A floating-point technique for extending the available precision, Numer. Math. 18 (1971).

use super::word::Word;

/// head + tail, the tail being below the last bit of the head.
#[derive(Clone, Copy)]
pub(super) struct Pair<W> {
    pub(super) head: W,
    pub(super) tail: W,
}

/// head + tail as they are.
#[inline(always)]
pub(super) fn pair<W>(head: W, tail: W) -> Pair<W> {
    Pair { head, tail }
}

/// a + b exactly.
#[inline(always)]
pub(super) fn two_sum<W: Word>(a: W, b: W) -> Pair<W> {
    let head = a + b;
    let shift = head - a;
    pair(head, (a - (head - shift)) + (b - shift))
}

/// a + b exactly, of |a| ≥ |b| or a = 0.
#[inline(always)]
pub(super) fn fast_two_sum<W: Word>(a: W, b: W) -> Pair<W> {
    let head = a + b;
    pair(head, b - (head - a))
}

/// a b exactly: by the fused operation, or from the four products of halves.
#[inline(always)]
pub(super) fn two_product<W: Word>(a: W, b: W) -> Pair<W> {
    let head = a * b;
    if W::FUSED {
        return pair(head, a.fused(b, -head));
    }
    let (a_high, b_high) = (a.leading_half(), b.leading_half());
    let (a_low, b_low) = (a - a_high, b - b_high);
    pair(head, ((a_high * b_high - head) + a_high * b_low + a_low * b_high) + a_low * b_low)
}

impl<W: Word> Pair<W> {
    /// Two entries of a table: a constant and what its rounding leaves.
    #[inline(always)]
    pub(super) fn of(entries: &'static [W::Raw], position: usize) -> Self {
        pair(W::of(entries[2 * position]), W::of(entries[2 * position + 1]))
    }
    /// The nearest number.
    #[inline(always)]
    pub(super) fn rounded(self) -> W {
        self.head + self.tail
    }
    /// Head and tail that do not overlap.
    #[inline(always)]
    pub(super) fn normal(self) -> Self {
        fast_two_sum(self.head, self.tail)
    }
    /// The product, to about twice the precision.
    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Self {
        let product = two_product(self.head, other.head);
        let cross = self.head.fused(other.tail, self.tail * other.head);
        pair(product.head, product.tail + cross).normal()
    }
    /// 1/self, to about twice the precision.
    #[inline(always)]
    pub(super) fn reciprocal(self) -> Self {
        quotient(pair(W::literal(1.0), W::literal(0.0)), self)
    }
}

/// n/d, to about twice the precision: the quotient of the heads, and what is left of n divided by the same.
#[inline(always)]
pub(super) fn quotient<W: Word>(numerator: Pair<W>, denominator: Pair<W>) -> Pair<W> {
    let reciprocal = W::literal(1.0) / denominator.head;
    let head = numerator.head * reciprocal;
    let product = two_product(head, denominator.head);
    let rest = ((numerator.head - product.head) - product.tail) + (numerator.tail - head * denominator.tail);
    pair(head, rest * reciprocal)
}
