//! Error-free sums and products, as a number and its rounding error.
//!
//! Dekker, A floating-point technique for extending the available precision, Numer. Math. 18
//! (1971).

use super::word::Word;

/// Sum head + tail; the tail is below the last bit of the head.
#[derive(Clone, Copy)]
pub(super) struct Pair<W> {
    pub(super) head: W,
    pub(super) tail: W,
}

/// Creates a pair without normalisation.
#[inline(always)]
pub(super) fn pair<W>(head: W, tail: W) -> Pair<W> {
    Pair { head, tail }
}

/// Computes a + b exactly.
#[inline(always)]
pub(super) fn two_sum<W: Word>(a: W, b: W) -> Pair<W> {
    let head = a + b;
    let shift = head - a;
    pair(head, (a - (head - shift)) + (b - shift))
}

/// Computes a + b exactly, if |a| ≥ |b| or a = 0.
#[inline(always)]
pub(super) fn fast_two_sum<W: Word>(a: W, b: W) -> Pair<W> {
    let head = a + b;
    pair(head, b - (head - a))
}

/// Computes a b exactly: by the fused operation, or from the four products of halves.
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
    /// Returns two entries of a table: a constant and its rounding error.
    #[inline(always)]
    pub(super) fn of(entries: &'static [W::Raw], position: usize) -> Self {
        pair(W::of(entries[2 * position]), W::of(entries[2 * position + 1]))
    }
    /// Returns the nearest number.
    #[inline(always)]
    pub(super) fn rounded(self) -> W {
        self.head + self.tail
    }
    /// Normalises the pair, so that head and tail do not overlap.
    #[inline(always)]
    pub(super) fn normal(self) -> Self {
        fast_two_sum(self.head, self.tail)
    }
    /// Computes the product, to about twice the precision.
    #[inline(always)]
    pub(super) fn times(self, other: Self) -> Self {
        let product = two_product(self.head, other.head);
        let cross = self.head.fused(other.tail, self.tail * other.head);
        pair(product.head, product.tail + cross).normal()
    }
    /// Computes 1/self, to about twice the precision.
    #[inline(always)]
    pub(super) fn reciprocal(self) -> Self {
        quotient(pair(W::literal(1.0), W::literal(0.0)), self)
    }
}

/// Computes n/d, to about twice the precision: the quotient of the heads, and the remainder divided
/// by the same head.
#[inline(always)]
pub(super) fn quotient<W: Word>(numerator: Pair<W>, denominator: Pair<W>) -> Pair<W> {
    let reciprocal = W::literal(1.0) / denominator.head;
    let head = numerator.head * reciprocal;
    let product = two_product(head, denominator.head);
    let rest = ((numerator.head - product.head) - product.tail) + (numerator.tail - head * denominator.tail);
    pair(head, rest * reciprocal)
}
